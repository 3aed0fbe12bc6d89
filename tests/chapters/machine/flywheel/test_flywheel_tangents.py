"""Tangents to the energy–mass curve: the highest place of a function over panels, looked for where it may be."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import solved
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.machine.flywheel.inertia import Cycle, highest, tangents

OVER = panels(4 * np.pi, (1.0, 2.5, 7.0))


@given(
    waves=st.lists(st.tuples(st.integers(1, 8), st.floats(-1, 1), st.floats(0, 6)), min_size=1, max_size=5)
)
def test_the_highest_place_is_that_of_all_the_panels(waves):
    values = sum(size * np.cos(order * OVER.x / 2 - phase) for order, size, phase in waves)
    (_, _), (greatest, _) = OVER.extremes(values)
    found = highest(OVER, values[None])[0]
    assert sum(size * np.cos(order * found / 2 - phase) for order, size, phase in waves) == pytest.approx(
        greatest, abs=1e-11
    )


@pytest.mark.parametrize(
    ("values", "place"),
    [
        (np.cos(OVER.x), 0.0),  # twice as high in two turns: the first
        (np.cos(OVER.x - 1.3), 1.3),
        (-np.abs(OVER.x - 2.5), 2.5),  # a kink on an edge
        (OVER.x, 4 * np.pi),
        (np.where(OVER.x < 1.0, 2.0, np.sin(OVER.x)), 0.0),  # before a jump, level
        (np.zeros(OVER.shape), 0.0),
    ],
)
def test_the_highest_place_of_curves_with_kinks_and_equal_summits(values, place):
    assert highest(OVER, values[None])[0] == pytest.approx(place, abs=1e-7)


@pytest.mark.parametrize("part", np.linspace(0.0, 1.0, 7))
def test_a_summit_between_two_points_of_a_panel_is_found_wherever_it_lies(part):
    left, right = OVER.edges[3:5]
    place = left + part * (right - left)
    assert highest(OVER, np.exp(-4 * (OVER.x - place) ** 2)[None])[0] == pytest.approx(place, abs=1e-7)


@pytest.mark.parametrize("name", ["compressor", "punch_press"])
def test_no_point_of_a_fine_grid_is_beyond_a_tangent(name):
    found = solved(name).flywheel
    of: Cycle = found.cycle
    x = np.linspace(0, of.panels.period, 20001)
    for share in (0.1, 1.0, 1.9):
        slope = share * found.omega**2 / 2
        heights = of.panels.at(of.work, x) - slope * of.panels.at(of.varying, x)
        size = np.ptp(heights)
        upper, lower = tangents(of, slope, slope)
        assert upper.cut == pytest.approx(heights.max(), abs=1e-6 * size)
        assert lower.cut == pytest.approx(heights.min(), abs=1e-6 * size)
        assert upper.cut >= heights.max() - 1e-12 * size
