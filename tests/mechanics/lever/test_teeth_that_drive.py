"""The force of a gear that turns the driving link: against powers and the equilibrium of the crank."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.forces.force_on_crank_gear import GearDrive

ANGLES = st.floats(-np.pi, np.pi)
MOMENTS = st.floats(-1e4, 1e4).filter(lambda moment: abs(moment) > 1e-3)
GEARS = st.builds(GearDrive, st.floats(0.01, 1.0), st.floats(0.0, np.radians(40)), ANGLES, st.booleans())


@given(GEARS, MOMENTS, st.sampled_from((-7.0, 7.0)))
def test_its_moment_about_the_pivot_is_the_balancing_moment(gear, moment, omega):
    assert cross(gear.pitch_point, gear.force(moment, omega)) == pytest.approx(moment, rel=1e-9)


@given(GEARS, MOMENTS, st.sampled_from((-7.0, 7.0)))
def test_its_power_is_that_of_the_moment(gear, moment, omega):
    """F·v along the line of action, v of the pitch point on the gear, is M·ω."""
    velocity = 1j * omega * gear.pitch_point
    assert dot(gear.force(moment, omega), velocity) == pytest.approx(moment * omega, rel=1e-9)


@given(GEARS, MOMENTS, st.sampled_from((-7.0, 7.0)))
def test_teeth_push_the_wheels_apart(gear, moment, omega):
    """Towards the pivot, unless a wheel that keeps to one flank would have to pull."""
    along = dot(gear.force(moment, omega), gear.pitch_point)
    pulls = gear.one_flank and moment * omega < 0
    slack = 1e-9 * abs(moment)
    assert along >= -slack if pulls else along <= slack


@given(GEARS, MOMENTS)
def test_the_line_of_action_touches_the_base_circle(gear, moment):
    line = gear.line(moment, 1.0)
    assert abs(line) == pytest.approx(1.0)
    assert abs(cross(gear.pitch_point, line)) == pytest.approx(gear.radius * np.cos(gear.pressure))


def test_either_flank_changes_its_line_with_the_sense_of_the_moment():
    gear = GearDrive(0.1, np.radians(20), np.radians(-90))
    force = gear.force(np.array([94.0, -94.0]), 1.0)
    size = 94.0 / (0.1 * np.cos(np.radians(20)))
    assert np.degrees(np.angle(force)) == pytest.approx([20.0, 160.0])
    assert np.abs(force) == pytest.approx([size, size])


def test_straight_teeth_without_an_angle_push_along_the_tangent():
    gear = GearDrive(0.2, 0.0, 0.0)
    assert gear.force(10.0, 1.0) == pytest.approx(50j)
