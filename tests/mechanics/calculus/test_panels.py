"""Panels over a period: exact where the function is smooth between the breaks, whatever it does at them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.panels import panels

TURN = 2 * math.pi


def kinked(x):
    """A cosine, then a hump three higher, then the cosine again."""
    return np.where((x >= 1.0) & (x < 2.5), 3 + np.sin(5 * x), np.cos(x))


WORK = math.sin(1) + 4.5 + (math.cos(5) - math.cos(12.5)) / 5 - math.sin(2.5)


def test_the_integral_steps_over_jumps_without_a_loss():
    over = panels(TURN, [1.0, 2.5])
    assert over.total(kinked(over.x)) == pytest.approx(WORK, abs=1e-14)


def test_without_its_breaks_the_same_integral_is_wrong():
    over = panels(TURN)
    assert abs(over.total(kinked(over.x)) - WORK) > 1e-4


@given(st.lists(st.floats(0.01, TURN - 0.01), max_size=6))
def test_breaks_where_nothing_breaks_change_nothing(breaks):
    over = panels(TURN, breaks)
    assert over.total(np.sin(over.x) ** 2) == pytest.approx(math.pi, rel=1e-13)
    assert over.edges[0] == 0 and over.edges[-1] == TURN and np.all(np.diff(over.edges) > 0)


def test_the_running_integral_and_the_slope_are_those_of_the_sine():
    over = panels(TURN, [0.3])
    assert over.running(np.sin(over.x)) == pytest.approx(1 - np.cos(over.x), abs=1e-14)
    assert over.running_edges(np.sin(over.x)) == pytest.approx(1 - np.cos(over.edges), abs=1e-14)
    assert over.slope(np.sin(over.x)) == pytest.approx(np.cos(over.x), abs=1e-11)


@given(st.floats(-20, 20))
def test_between_its_points_a_function_is_known_and_periodic(x):
    over = panels(TURN, [1.0, 2.5])
    found = over.at(kinked(over.x), np.array([x, over.x[3, 4]]))
    near = min(abs(x % TURN - b) for b in (0, 1, 2.5, TURN))
    assert near < 1e-6 or found[0] == pytest.approx(float(kinked(x % TURN)), abs=1e-12)
    assert found[1] == float(kinked(over.x[3, 4]))


def test_both_sides_of_a_jump_count_as_extremes():
    over = panels(3.0, [1.0, 2.0])
    saw = over.x % 1.0
    (low, at_low), (high, at_high) = over.extremes(saw)
    assert (low, at_low) == (pytest.approx(0.0, abs=1e-14), 0.0)
    assert (high, at_high) == (pytest.approx(1.0, abs=1e-14), 1.0)


def test_extremes_between_the_points_are_found():
    over = panels(TURN)
    (low, at_low), (high, at_high) = over.extremes(np.cos(over.x - 1.234))
    assert high == pytest.approx(1, abs=1e-15) and at_high == pytest.approx(1.234, abs=1e-7)
    assert low == pytest.approx(-1, abs=1e-15) and at_low == pytest.approx(1.234 + math.pi, abs=1e-7)


def test_roots_are_passages_through_zero_jumps_among_them():
    over = panels(TURN, [1.0, 2.5])
    assert over.roots(np.sin(over.x)) == pytest.approx([0, math.pi], abs=1e-13)
    assert over.roots(kinked(over.x)) == pytest.approx([2.5, 1.5 * math.pi], abs=1e-13)
    assert over.roots(kinked(over.x), within=True) == pytest.approx([1.5 * math.pi], abs=1e-13)


def test_many_functions_are_integrated_at_once():
    over = panels(TURN)
    both = np.stack([np.sin(over.x) ** 2, np.cos(3 * over.x) ** 2])
    assert over.total(both) == pytest.approx([math.pi, math.pi])
    assert over.running(both).shape == both.shape
