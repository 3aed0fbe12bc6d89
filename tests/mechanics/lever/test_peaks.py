"""Extremes and integrals of functions of a cycle against closed answers: smooth, with kinks, with jumps."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.lever.extremes import inside, integral, peaks, refined, signed, size_peaks

TURN = 2 * np.pi


@given(st.floats(0.1, 3.0), st.floats(-3.0, 3.0), st.integers(1, 3))
def test_a_harmonic_has_its_amplitude_at_its_phase(size, phase, order):
    over = panels(TURN)
    (low, high), *_ = peaks(over, size * np.cos(order * over.x - phase)[None])
    # of values nearer than 1e-10 the first counts: that of an end beside the extreme
    assert (low.value, high.value) == pytest.approx((-size, size), abs=1e-9 * size)
    assert np.cos(order * high.turned - phase) == pytest.approx(1, abs=1e-9)
    assert high.turned < TURN / order + 1e-6  # of equal ones the first
    assert low.side == high.side == 0


@given(st.floats(0.3, 6.0), st.floats(0.5, 4.0))
def test_at_a_jump_both_sides_count_and_are_told(at, size):
    """A ramp that falls back: its greatest value is just before the jump, its least just after it."""
    over = panels(TURN, [at])
    ramp = size * np.mod(over.x - at, TURN)
    ((low, high),) = peaks(over, ramp[None])
    assert (high.value, high.turned, high.side) == (pytest.approx(size * TURN), pytest.approx(at), -1)
    assert (low.value, low.turned, low.side) == (pytest.approx(0, abs=1e-10), pytest.approx(at), 1)


def test_a_jump_at_the_end_of_the_cycle_is_none_of_a_cycle_that_does_not_close():
    over = panels(1.0)
    for closed, side in ((True, -1), (False, 0)):
        ((_, high),) = peaks(over, over.x[None], closed)
        assert (high.value, high.turned, high.side) == (pytest.approx(1), 1.0, side)


def test_a_kink_is_an_extreme_and_no_jump():
    over = panels(TURN, [2.0])
    ((low, high),) = peaks(over, -np.abs(over.x - 2.0)[None])
    assert (high.value, high.turned, high.side) == (pytest.approx(0, abs=1e-12), pytest.approx(2.0), 0)
    assert low.turned == pytest.approx(TURN)


def test_a_constant_is_extreme_at_position_0():
    over = panels(TURN)
    assert [(one.value, one.turned, one.side) for one in peaks(over, np.full((1, *over.shape), 3.0))[0]] == [
        (pytest.approx(3.0), 0.0, 0)
    ] * 2


@pytest.mark.exhaustive
def test_the_size_of_a_vector_is_exact_where_it_vanishes():
    """An ellipse through the origin: between 0 and its long axis, both within it where no point of the grid lies."""
    over = panels(TURN)
    vector = 2 * (1 - np.cos(over.x - 1)) + 1j * np.sin(over.x - 1)
    ((low, high),) = size_peaks(over, vector[None])
    assert (low.value, low.turned) == (pytest.approx(0, abs=1e-9), pytest.approx(1, abs=1e-6))
    grid = np.linspace(0, TURN, 2_000_001)
    assert high.value == pytest.approx(np.abs(2 * (1 - np.cos(grid)) + 1j * np.sin(grid)).max(), rel=1e-11)


def test_many_functions_at_once_are_as_each_alone():
    over = panels(TURN, [0.7, 4.4])
    values = np.array([np.sin(k * over.x) / k + (over.x > 4.4) * k for k in range(1, 8)])
    together = peaks(over, values)
    assert together == [peaks(over, one[None])[0] for one in values]


@given(st.floats(0.05, TURN - 0.05), st.floats(0.05, TURN - 0.05))
def test_integrals_between_any_places(a, b):
    over = panels(TURN, [1.0, 2.5])
    found = np.diff(integral(over, np.cos(over.x), [a, b]))[0]
    assert found == pytest.approx(np.sin(b) - np.sin(a), abs=1e-12)


def test_what_is_above_zero_and_what_is_below():
    over = panels(TURN)
    assert signed(over, 3 * np.cos(over.x - 0.4)) == (pytest.approx(6), pytest.approx(-6))
    assert signed(over, np.ones(over.shape)) == (pytest.approx(TURN), 0.0)


def test_panels_are_cut_where_a_function_is_sharp():
    """A narrow hump of 1/(a² + x²) is resolved to 1e-9 of its height once its panels are cut, and not before."""

    def hump(over):
        return (1 / (0.03**2 + (over.x - 3.0) ** 2))[None]

    coarse = panels(TURN)
    ((_, rough),) = peaks(coarse, hump(coarse))
    fine = coarse
    for _ in range(3):
        fine = refined(fine, hump(fine), [1 / 0.03**2])
    ((_, high),) = peaks(fine, hump(fine))
    assert abs(rough.value * 0.03**2 - 1) > 1e-3
    assert high.value * 0.03**2 == pytest.approx(1, abs=1e-9) and high.turned == pytest.approx(3, abs=1e-8)
    assert fine.shape[0] < 80
    assert refined(fine, hump(fine) * 0 + 1, [1.0]) is fine


def test_inside_is_the_polynomial_of_the_panel_asked_for():
    """At an edge each of both panels gives its own value."""
    over = panels(TURN, [2.0])
    values = np.where(over.x < 2.0, 1.0, 5.0)[None]
    edge = int(np.flatnonzero(over.edges == 2.0)[0])
    k = np.array([edge - 1, edge])
    assert inside(over, values, 0 * k, k, np.array([2.0, 2.0])) == pytest.approx([1.0, 5.0])
