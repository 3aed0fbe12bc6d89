"""Zeros of polynomials, many at once, against the roots that they are made of."""

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.panels import ORDER, panels
from tmm_report.mechanics.calculus.zeros import evaluated, grid, zeros

POINTS = grid(ORDER)[1:-1]


def bracketed(values):
    """Of functions (S, n) of one zero each: the bracket between neighbours of the grid, and the sign at its low end."""
    rows = np.sign(values)
    k = np.array([np.flatnonzero(row[:-1] * row[1:] < 0)[0] for row in rows])
    return POINTS[k], POINTS[k + 1], rows[np.arange(len(rows)), k]


@settings(max_examples=examples(100))
@given(st.lists(st.floats(-0.97, 0.97), min_size=1, max_size=6), st.sampled_from([1.0, -1e-6, 1e6]))
def test_a_zero_is_found_wherever_it_lies(places, size):
    places = np.array([x for x in places if not np.any(x == POINTS)] or [0.0])
    values = size * np.array([np.sinh(POINTS - x) for x in places])
    assert zeros(values, *bracketed(values)) == pytest.approx(places, abs=1e-11)  # of sinh by twelve points


def test_the_end_of_a_bracket_may_be_the_zero_itself():
    values = np.array([POINTS - 1.0, POINTS - POINTS[4]])
    found = zeros(values, np.array([POINTS[-1], POINTS[3]]), np.array([1.0, POINTS[5]]), -np.ones(2))
    assert found == pytest.approx([1.0, POINTS[4]], abs=1e-14)


def test_nothing_is_found_of_nothing():
    assert zeros(np.zeros((0, ORDER)), *np.zeros((3, 0))).size == 0


def test_values_between_the_points():
    t = np.linspace(-1, 1, 9)
    values = np.tile(POINTS**7 - 0.3 * POINTS, (9, 1))
    assert evaluated(values, t) == pytest.approx(t**7 - 0.3 * t, abs=1e-14)


def test_roots_of_many_functions_are_those_of_each():
    over = panels(2 * np.pi, (1.0, 2.5))
    each = np.stack(
        [np.cos(over.x), np.sin(3 * over.x) + 0.2, np.ones(over.shape), np.where(over.x < 1, -1.0, 1)]
    )
    together = over.roots_of(each)
    counts = [len(places) for places in together]
    assert counts == [2, 6, 0, 2]  # the last jumps at its edge and at the end of the period
    for values, places in zip(each, together, strict=True):
        assert np.array_equal(over.roots(values), places)
    assert together[0] == pytest.approx([np.pi / 2, 3 * np.pi / 2], abs=1e-13)


def test_values_of_many_functions_at_any_places():
    over = panels(2 * np.pi, (1.0,))
    both, x = np.stack([np.cos(over.x), np.sin(over.x)]), np.array([[0.0, 1.0], [over.x[2, 3], 7.0]])
    assert over.at(both, x) == pytest.approx(np.stack([np.cos(x), np.sin(x)]), abs=1e-12)
