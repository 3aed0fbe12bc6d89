"""The motion as drawn by hand: points on the paper's grid, errors of the size of a reading, the same at every time."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import solved

from tmm_report.mechanics.rivals.motion.drawing import LARGEST, drawing, on_a_sheet, scale
from tmm_report.mechanics.rivals.motion.turning import turning
from tmm_report.mechanics.rivals.paper import round_scale

NAMES = ("compressor", "shaper", "press", "scotch_yoke", "quick_return")


def cycle(name: str):
    return solved(name).lever.kinematics.cycle


@pytest.mark.parametrize("accuracy", [0.01, 0.1, 0.5])
@pytest.mark.parametrize("name", NAMES)
def test_places_are_read_in_whole_steps_of_the_accuracy(name, accuracy):
    of = cycle(name)
    found, exact = drawing(of, 12, accuracy), of.motion(of.once(12)).places
    metres = scale(max(np.ptp(exact.real), np.ptp(exact.imag)), 200.0)
    steps = found.places / metres / accuracy
    off = np.abs(steps - np.round(steps.real) - 1j * np.round(steps.imag))
    assert off.max() < 1e-6


@pytest.mark.parametrize("name", [name for name in NAMES if name != "scotch_yoke"])
def test_joints_are_drawn_one_from_another_so_that_they_err_by_more_than_a_reading(name):
    of = cycle(name)
    found, exact = drawing(of, 36, 0.5).places, of.motion(of.once(36)).places
    metres = scale(max(np.ptp(exact.real), np.ptp(exact.imag)), 200.0)
    assert 0.5 / np.sqrt(2) * 1.2 < np.abs(found - exact).max() / metres < 5


@pytest.mark.parametrize("name", NAMES)
def test_a_finer_pencil_draws_better(name):
    of = cycle(name)
    exact = of.motion(of.once(36))
    for quantity in ("places", "velocities", "accelerations"):
        value = getattr(exact, quantity)
        off = [np.abs(getattr(drawing(of, 36, mm), quantity) - value).max() for mm in (0.01, 0.1, 0.5)]
        assert off == sorted(off) and off[2] > 10 * off[0] > 0


def test_an_endlessly_fine_pencil_draws_the_exact_motion():
    """With every step of the drawing its own vector equation, Coriolis parts included: nothing but rounding is lost."""
    for name in NAMES:
        of = cycle(name)
        found, exact = drawing(of, 24, 1e-9), of.motion(of.once(24))
        for quantity in ("places", "velocities", "accelerations"):
            one, other = getattr(found, quantity), getattr(exact, quantity)
            assert np.abs(one - other).max() < 1e-9 * np.abs(other).max()
        for link in of.linkage.mechanism.moving:
            exactly = exact.angular_acceleration(link)
            assert found.angular_acceleration(link) == pytest.approx(
                exactly, rel=1e-7, abs=1e-7 * (1 + np.abs(exactly).max())
            )


def test_a_drawing_is_the_same_at_every_time():
    of = cycle("shaper")
    assert drawing(of, 12, 0.1).accelerations.tobytes() == drawing(of, 12, 0.1).accelerations.tobytes()


def test_lines_that_cross_on_no_sheet_give_nothing():
    rates = np.array([[1.0, 0.0, 2.0], [LARGEST, LARGEST, 2.0]])
    found = on_a_sheet(rates, 1.0)
    assert (found[0] == rates[0]).all() and np.isnan(found[1]).all()


def test_a_scale_is_a_round_number_that_fills_the_sheet():
    assert [scale(x, 200.0) for x in (0.4, 0.41, 0.5)] == pytest.approx([0.002, 0.0025, 0.0025])
    assert float(round_scale(np.array([0.0]), 200.0)[0]) > 0


def test_links_on_a_guide_turn_alike_and_are_read_off_between_their_outer_joints():
    """Shaper: slider 2 in the slot of rocker 3 turns with it; their turning is that of the line A–C."""
    linkage = cycle("shaper").linkage
    found = [one for group in linkage.structure.groups for one in turning(linkage, group)]
    several = [one for one in found if len(one.links) == 2]
    assert len(several) == 1 and {end for end, _ in several[0].ends} == set(several[0].links)
    sliders = [one for one in found if one.ends is None]
    assert [one.links for one in sliders]  # the ram keeps the frame's direction
