"""A pair in motion: the velocity of sliding by three ways, and how much the pitch-line velocity allows."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report import loading
from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.chapters.gears.spur.solve.motion import sliding_limit
from tmm_report.problems import ProblemError

GIVEN = {
    "reference": spur.Given(-2, 0.006, 0.130, wheels=("4", "5")),
    "multiplier": spur.Given(-0.5, 0.006, None, (28, 14)),
    "ring": spur.Given(3, 0.004, None, (20, 60), shift=(0.4, 1.0)),
    "ring drives": spur.Given(1 / 3, 0.004, None, (60, 20), shift=(1.0, 0.4)),
    "helical": spur.Given(-2, 0.004, None, (17, 34), helix=0.35),
}
FAST = spur.Given(-2, 0.0025, None, (42, 84), shift=(0.2, 0.0))


@pytest.fixture(scope="module", params=GIVEN)
def found(request):
    return spur.moving(spur.solve(GIVEN[request.param]), -80.0)


def velocities(found):
    """Of both teeth at the points of the line of action, m/s, as those of bodies that turn about their centres."""
    mesh = found.mesh
    speed = 80.0 * mesh.sense * (1 if mesh.small == 0 or found.given.internal else -1)
    omega = speed, speed / float(found.pair.ratio)
    at = np.array([mesh.points[name] for name in found.path.points]) / mesh.mm
    return [1j * w * (at - mesh.centre(i) / mesh.mm) for i, w in enumerate(omega)]


def test_both_teeth_have_one_velocity_along_the_line_of_action(found):
    one, other = velocities(found)
    along = found.mesh.along.conjugate()
    assert (one * along).real == pytest.approx((other * along).real, abs=1e-9)
    assert np.abs((one * along).real) == pytest.approx(np.full(5, found.motion.along), rel=1e-9)


def test_the_velocity_of_sliding_is_the_difference_of_the_velocities_of_the_points(found):
    one, other = velocities(found)
    assert np.abs(one) == pytest.approx(found.motion.whole[0]) and np.abs(other) == pytest.approx(
        found.motion.whole[1]
    )
    assert np.abs(one - other) == pytest.approx(np.abs(found.motion.sliding), abs=1e-9)


def test_the_velocity_of_sliding_grows_with_the_distance_from_the_pitch_point(found):
    one, other = found.motion.omega
    rate = abs(one - other) if found.given.internal else one + other
    way = found.path.at.rho - found.path.points["P"]
    assert np.abs(found.motion.sliding) == pytest.approx(rate * np.abs(way), abs=1e-9)
    assert found.motion.fastest in (0, 4) and found.motion.sliding[2] == 0


def test_specific_sliding_is_the_velocity_of_sliding_to_that_of_the_tooth(found):
    slip, (one, other) = found.motion.sliding, found.motion.across
    assert slip / one == pytest.approx(found.path.at.first, abs=1e-9)
    assert -slip / other == pytest.approx(found.path.at.second, abs=1e-9)


def test_the_limit_is_6_up_to_15_metres_a_second_and_3_from_20_on():
    assert [sliding_limit(v) for v in (0, 15, 16, 17.5, 20, 40)] == pytest.approx([6, 6, 5.4, 4.5, 3, 3])


@settings(max_examples=25, deadline=None)
@given(st.floats(0, 60), st.floats(0, 60))
def test_a_faster_pair_is_never_allowed_more(one, other):
    assert sliding_limit(max(one, other)) <= sliding_limit(min(one, other))


def test_the_pitch_line_velocity_is_that_of_both_working_circles():
    found = spur.moving(spur.solve(FAST), 300.0)
    assert found.motion.pitch == pytest.approx(300 * float(found.pair.d_w[0]) / 2)
    assert found.motion.pitch == pytest.approx(found.motion.omega[1] * float(found.pair.d_w[1]) / 2)


def limits(found):
    return sorted({c.limit for c in found.conditions if c.key == "sliding"})


def test_the_drive_sets_the_limit_of_each_pair_by_its_own_speed():
    """The first pair runs at 16.9 m/s, the second one, behind it, at half the speed."""
    second = replace(FAST, wheels=("3", "4"))
    found = drive.solve(drive.Given(3000 * math.pi / 30, (FAST, second)))
    first, slower = found.stages
    assert first.motion.pitch == pytest.approx(2 * slower.motion.pitch) and 15 < first.motion.pitch < 20
    assert limits(first) == pytest.approx([6 - 0.6 * (first.motion.pitch - 15)]) and limits(slower) == [6.0]


def test_a_stated_limit_is_taken_whatever_the_speed():
    found = spur.moving(spur.solve(replace(FAST, sliding_limit=0.5)), 10.0)
    assert limits(found) == [0.5] and {c.key for c in found.failed} == {"sliding"}


def test_a_pair_behind_an_output_that_stands_still_has_no_velocity():
    found = spur.moving(spur.solve(FAST), 0.0)
    assert found.motion.pitch == 0 and not found.motion.sliding.any() and limits(found) == [6.0]


def test_an_impossible_limit_is_refused():
    text = "drive: {speed: 100 rpm, stages: [{kind: spur, ratio: -2, module: 2 mm, teeth: [20, 40], sliding_limit: 0}]}"
    with pytest.raises(ProblemError) as error:
        loading.loads(text)
    assert error.value.problems[0].path[-1] == "sliding_limit"
