"""The least cam under flat faces, its diagram, a roller and a shaft by the rules, the jerk."""

import math

import numpy as np
import pytest
from notes import render

from tmm_report import course, loading
from tmm_report.chapters.cams.cam.draw import face
from tmm_report.figures.drawing import THICK
from tmm_report.figures.primitives import Path as Stroke
from tmm_report.problems import ProblemError

PHASES = "phases: [{rise: 100 deg, law: sine}, {dwell: 40 deg}, {return: 80 deg, law: cosine}, {dwell: rest}]"
SLIDES = f"follower: flat, base: smallest, least_curvature: 8 mm, lift: 20 mm, {PHASES}"
SWINGS = (
    "follower: flat, base: smallest, least_curvature: 8 mm, swing: %s, centre_distance: 120 mm, face_offset: %s, "
    f"side: %s, rotation: %s, {PHASES}"
)
ROLLS = f"roller: %s, base: smallest, lift: 20 mm, %s{PHASES}"


def solved(cam):
    return course.solve(loading.loads(f"cam: {{{cam}}}")).cam.cams[0]


@pytest.mark.parametrize("turn", ["clockwise", "counter-clockwise"])
@pytest.mark.parametrize("side", ["against", "with"])
@pytest.mark.parametrize("away", ["5 mm", "0 mm", "-8 mm"])
def test_under_a_swinging_face_the_curvature_is_reached_and_no_less(away, side, turn):
    found = solved(SWINGS % ("14 deg", away, side, turn))
    assert found.least.value == pytest.approx(8e-3, rel=1e-7)
    lowest = found.cam.sized.lowest
    assert found.cam.base == pytest.approx(found.cam.sized.away + 0.12 * math.sin(lowest))
    assert found.cam.sized.away == pytest.approx(-float(away.split()[0]) / 1e3)


@pytest.mark.parametrize(
    ("cam", "key", "words"),
    [
        (SWINGS % ("110 deg", "0 mm", "with", "clockwise"), "cam.base", "keeps the curvature"),
        (SWINGS.replace("least_curvature: 8 mm, ", "") % ("14 deg", "0 mm", "with", "clockwise"),
         "cam.base", "least radius of curvature"),
        (SWINGS.replace("120 mm", "free") % ("14 deg", "5 mm", "with", "clockwise"), "cam.centre_distance",
         "room for both pivots"),
        (f"roller: chosen, base: 40 mm, lift: 20 mm, {PHASES}", "cam.roller", "by the pitch curve"),
        ("roller: chosen, base: smallest, profile: {circle: {radius: 40 mm, at: [9 mm, 0]}}", "cam.roller", "stated"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_told(cam, key, words):
    with pytest.raises(ProblemError) as raised:
        loading.loads(f"cam: {{{cam}}}")
    told = [(".".join(map(str, p.path)), p.wrong.text) for p in raised.value.problems]
    assert any(where == key and words in text for where, text in told), told


def test_the_tangent_at_45_degrees_bounds_the_curve_and_stands_above_the_axis():
    found = solved(SLIDES)
    under, mu = found.cam.sized, face.scale(found, found.cam.sized)
    strokes = [item for item in face.drawing(found, under, mu).items if isinstance(item, Stroke)]
    (start, end), curve = (
        next(one.strokes[0] for one in strokes if one.pen == pen) for pen in (face.TANGENT, THICK)
    )
    assert (end - start).real == pytest.approx(-(end - start).imag)
    beyond = np.array([z.real + z.imag for z in curve]) - (start.real + start.imag)
    assert beyond.min() == pytest.approx(0, abs=1e-6)
    assert (start.real + start.imag) * mu == pytest.approx(-(found.cam.base - 8e-3))


def test_a_chosen_roller_keeps_the_rules_and_one_millimetre_more_does_not():
    found = solved(ROLLS % ("chosen", ""))
    limits = found.roller_limits
    assert found.cam.roller <= limits.most < found.cam.roller + 1e-3
    assert limits.by_radius == pytest.approx(0.4 * found.pitch_base)
    assert found.cam.roller * 1e3 == pytest.approx(round(found.cam.roller * 1e3))


GROOVED = (
    "closure: groove, lift: 30 mm, phases: [{rise: 40 deg, law: sine}, {dwell: 40 deg}, "
    "{return: 40 deg, law: parabolic}, {dwell: rest}]"
)


@pytest.mark.parametrize("shaft", ["", "shaft: 90 mm, ", "shaft: 140 mm, round: 1 mm, "])
def test_a_roller_chosen_on_a_curve_about_a_shaft_leaves_none_that_is_larger(shaft):
    found = solved(ROLLS % ("chosen", shaft))
    assert found.cam.roller <= found.roller_limits.most < found.cam.roller + 1e-3


def test_in_a_groove_the_hollows_of_the_pitch_curve_bound_the_roller():
    found = solved(f"roller: 9 mm, pitch_base: 45 mm, {GROOVED}")
    phi = np.linspace(0, 2 * math.pi, 200_001)
    radius = found.cam.contact(phi).radius
    assert found.hollow.value == pytest.approx(-radius[radius < 0].max(), rel=1e-6)
    limits = found.roller_limits
    assert limits.by_hollow == pytest.approx(0.8 * found.hollow.value)
    assert limits.most == limits.by_hollow < min(limits.by_radius, limits.by_curvature)
    free = solved(f"roller: 9 mm, pitch_base: 45 mm, {GROOVED.replace('groove', 'force')}")
    assert free.hollow is None and free.roller_limits.by_hollow == math.inf
    chosen = solved(f"roller: chosen, pitch_base: 45 mm, {GROOVED}")
    assert chosen.cam.roller <= chosen.roller_limits.most < chosen.cam.roller + 1e-3


def test_a_groove_without_hollows_has_no_such_bound():
    found = solved(f"closure: groove, {ROLLS % ('5 mm', '')}".replace("base: smallest", "pitch_base: 150 mm"))
    assert found.hollow is None and found.roller_limits.by_hollow == math.inf


def test_what_bounds_a_roller_in_its_groove_is_printed():
    text = f"language: en\ncam: {{roller: 9 mm, pitch_base: 45 mm, {GROOVED}}}"
    note = render(course.solve(loading.loads(text)), "html")["note.html"].decode()
    assert all(f'data-q="{key}"' in note for key in ("cam_rho_hollow", "cam_roller_by_hollow"))
    assert "larger than the rules allow" in note


def test_a_thick_shaft_asks_for_a_larger_cam():
    thin, thick = (solved(ROLLS % ("5 mm", f"shaft: {d} mm, ")) for d in (10, 90))
    assert thin.pitch_base == pytest.approx(solved(ROLLS % ("5 mm", "")).pitch_base)
    assert thick.pitch_base == pytest.approx(0.8 * 0.090 + 0.005)
    for cam in (SLIDES, SWINGS % ("14 deg", "5 mm", "with", "clockwise")):
        assert solved(f"shaft: 100 mm, {cam}").cam.base == pytest.approx(0.8 * 0.100)


@pytest.mark.parametrize(
    ("cam", "asks", "rounds"),
    [
        (ROLLS % ("5 mm", "shaft: 90 mm, "), True, False),
        (ROLLS % ("5 mm", "shaft: 90 mm, round: 5 mm, "), True, False),
        (ROLLS % ("5 mm", "shaft: 10 mm, round: 5 mm, "), False, True),
        (f"shaft: 100 mm, {SLIDES}", True, False),
        (SLIDES, False, False),
    ],
)
def test_it_is_said_whether_the_shaft_or_rounding_makes_the_cam_larger(cam, asks, rounds):
    note = render(course.solve(loading.loads(f"language: en\ncam: {{{cam}}}")), "html")["note.html"].decode()
    assert ("The shaft requires more" in note) == asks and ("is rounded up to" in note) == rounds


def test_jerk_is_the_greatest_third_derivative():
    found = solved(ROLLS % ("5 mm", ""))
    rise, back = math.radians(100), math.radians(80)
    sine, cosine = 4 * math.pi**2 * 0.02 / rise**3, math.pi**3 / 2 * 0.02 / back**3
    assert found.jerk.value == pytest.approx(max(sine, cosine))
