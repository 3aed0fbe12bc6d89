"""Integration of equations of motion: known solutions, and an event that ends it."""

from __future__ import annotations

import numpy as np
import pytest

from tmm_report.mechanics.calculus.ode import integrate


@pytest.mark.parametrize("method", ["LSODA", "DOP853", "Radau"])
def test_an_oscillator_swings_as_a_sine(method):
    found = integrate(
        lambda t, y: np.array([y[1], -y[0]]), np.array([0.0, 1.0]), (0.0, 20.0), method=method, relative=1e-9
    )
    times = np.linspace(0, 20, 50)
    assert found.at(times)[0] == pytest.approx(np.sin(times), abs=2e-6)
    assert found.ended is None and found.x[-1] == 20


def test_the_first_event_ends_it():
    """A stone thrown up is at its highest before it is back."""
    found = integrate(
        lambda t, y: np.array([y[1], -9.81]),
        np.array([0.0, 10.0]),
        (0.0, 100.0),
        events=[lambda t, y: y[0] + 5.0, lambda t, y: y[1]],
    )
    assert found.ended == 1 and found.x[-1] == pytest.approx(10 / 9.81)


def test_what_grows_beyond_every_bound_is_said():
    with pytest.raises(ArithmeticError):
        integrate(lambda t, y: y * y, np.array([1.0]), (0.0, 2.0), method="DOP853")
