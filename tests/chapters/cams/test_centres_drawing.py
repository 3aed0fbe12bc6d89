"""The zone of the axis under a swinging follower as it is drawn, and the cam that takes its place in it."""

import math

import numpy as np
import pytest

from tmm_report import course, loading
from tmm_report.chapters.cams.cam.draw import centres
from tmm_report.figures.drawing import THICK
from tmm_report.figures.primitives import Path as Stroke
from tmm_report.problems import ProblemError

CAM = (
    "roller: 12 mm, base: smallest, swing: 24 deg, arm: 120 mm, centre_distance: {apart}, side: {side}, "
    "rotation: {turn}, pressure_angle_limit: 40 deg, {back}phases: [{{rise: 110 deg, law: sine}}, {{dwell: 20 deg}}, "
    "{{return: 100 deg, law: cosine}}, {{dwell: rest}}], positions: 24"
)


def solved(apart="free", side="against", turn="counter-clockwise", back="return_angle_limit: 50 deg, "):
    text = CAM.format(apart=apart, side=side, turn=turn, back=back)
    return course.solve(loading.loads(f"cam: {{{text}}}")).cam.cams[0]


@pytest.fixture(
    scope="module",
    params=[(s, t) for s in ("against", "with") for t in ("clockwise", "counter-clockwise")],
    ids=str,
)
def drawn(request):
    found = solved("free", *request.param)
    mu = centres.scale(found, found.cam.sized)
    return found, found.cam.sized, mu, centres.drawing(found, found.cam.sized, mu)


def test_arms_what_is_laid_off_and_rays(drawn):
    """By the follower itself: its arm at every position, its end moved by l·β′ along it."""
    found, _, mu, drawing = drawn
    strokes = [item for item in drawing.items if isinstance(item, Stroke)]
    count = found.turn.distinct
    q, _ = found.cam.moved(found.phi(found.table.turned[:count]))
    ends = 0.12 * np.exp(1j * q.z) / mu
    arms = np.array([one.strokes[0][1] for one in strokes if one.pen == centres.ARM])
    assert max(np.abs(arms - z).min() for z in ends) < 1e-9
    curve = next(np.array(one.strokes[0]) for one in strokes if one.pen == THICK)
    sense = 1 if found.alike else -1
    laid = ends * (1 - sense * found.table.first[:count])
    assert max(np.abs(curve - z).min() for z in laid) < 0.5
    rays = [one.strokes[0] for one in strokes if one.pen == centres.RAY]
    assert len(rays) > 20
    for start, end in rays:
        across = abs(((end - start) * np.conj(start)).imag) / abs(end - start) / abs(start)
        assert math.degrees(math.acos(min(across, 1.0))) == pytest.approx(40) or math.degrees(
            math.acos(min(across, 1.0))
        ) == pytest.approx(50)
    # every ray begins where one position has its end
    assert max(np.abs(laid - start).min() for start, _ in rays) < 1e-6


def test_the_axis_stands_at_the_nearest_corner_of_the_zone(drawn):
    found, lever, _, _ = drawn
    corners = centres.permitted(found, lever)
    away = np.abs(corners - lever.arm)
    best = lever.centres.best
    assert away.min() == pytest.approx(abs(best.p - lever.arm), rel=1e-4)
    assert abs(found.pivot) == pytest.approx(abs(best.p))
    assert math.degrees(found.rise.value) == pytest.approx(40, abs=1e-5)
    assert math.degrees(found.back.value) == pytest.approx(50, abs=1e-5)


def test_pivots_too_near_are_told_with_the_least_distance_and_the_phase():
    free = solved(back="")
    least = abs(free.cam.sized.centres.closest.p)
    with pytest.raises(ProblemError) as raised:
        solved(f"{1e3 * least - 2:.4f} mm", back="")
    (problem,) = raised.value.problems
    told = problem.right.values
    assert float(told["least"]) == pytest.approx(least, abs=1e-4) and float(told["least"]) >= least
    assert told["phases"] == "rise"
    assert solved(f"{1e3 * least + 0.2:.4f} mm", back="").cam.sized.lowest is not None
