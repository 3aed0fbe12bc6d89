"""Steps in time: closed answers, the order, ends, and the two ways of stepping against each other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tmm_report.mechanics.machine.governor import equilibrium as g
from tmm_report.mechanics.machine.governor import response as large
from tmm_report.mechanics.machine.governor.stability import Servo
from tmm_report.mechanics.machine.governor.steps import follow, follow_stiff


def swing(t: float, y: list[float]) -> list[float]:
    """A pendulum of 3 rad/s for small swings, with a driven neighbour."""
    return [y[1], -9 * y[0], np.cos(2 * t)]


START, NEVER = [0.2, 0.3, 0.0], {"never": 1.0}


def exact(t):
    return np.array(
        [
            0.2 * np.cos(3 * t) + 0.1 * np.sin(3 * t),
            0.3 * np.cos(3 * t) - 0.6 * np.sin(3 * t),
            np.sin(2 * t) / 2,
        ]
    )


@pytest.mark.parametrize("way", [follow, follow_stiff])
def test_a_swing_is_followed_at_any_moment(way):
    found = way(swing, START, (0.0, 5.0), lambda y: NEVER, 1e-9, [1e-11] * 3)
    t = np.linspace(0, 5, 173)
    assert found.ended is None and found.x[-1] == 5.0
    assert found.at(t) == pytest.approx(exact(t), abs=2e-7)
    assert found.y[:, -1] == pytest.approx(exact(5.0), abs=1e-7)


def test_the_error_follows_the_tolerance():
    """Bounded in length, so that it is the tolerance that chooses the steps."""

    def error(relative):
        found = follow(
            lambda t, y: [y[1], -1e4 * y[0]],
            [1.0, 0.0],
            (0.0, 1.0),
            lambda y: NEVER,
            relative,
            [relative] * 2,
        )
        return abs(found.y[0, -1] - np.cos(100.0)), found.steps

    (coarse, few), (fine, many) = error(1e-4), error(1e-9)
    assert fine < 1e-3 * coarse and 5 < many / few < 15  # (1e5)^(1/5) = 10


@pytest.mark.parametrize("way", [follow, follow_stiff])
def test_what_is_used_up_ends_it(way):
    """The pendulum passes zero for the first time where tan 3t = −2."""
    found = way(swing, START, (0.0, 5.0), lambda y: {"far": 9.0, "zero": y[0]}, 1e-9, [1e-11] * 3)
    passed = (np.pi - np.arctan(2)) / 3
    assert found.ended == 0 and found.x[-1] == pytest.approx(passed, abs=1e-7)
    assert found.y[:, -1] == pytest.approx(exact(passed), abs=1e-6)


def test_what_grows_beyond_bounds_is_given_up():
    with pytest.raises(ArithmeticError):
        follow(lambda t, y: [y[0] ** 2], [1.0], (0.0, 2.0), lambda y: NEVER, 1e-6, [1e-8])


# --- the machine with its governor

ARMS, LOWEST = g.Arms(0.3, 0.3, 0.0, 0.04), 0.15
H = float(ARMS.height(0.15) - ARMS.height(0.2))


def at(z):
    return g.equilibrium(ARMS.moves(z, LOWEST), g.Weights(6.0, 40.0, 2000.0))


MACHINE = large.Machine(60.0, 400.0, 280.0, float(at(np.array([H / 2])).omega[0]), 4.0, least=0.1)
DIRECT = np.array([MACHINE.omega, 0.5 * H, 0.0]), None
SERVO = np.array([MACHINE.omega, 0.5 * H, 0.0, 0.5, 0.0]), Servo(0.05, 0.0005, 1.5, 1.0)


@pytest.mark.parametrize("start, servo", [DIRECT, SERVO], ids=["direct", "servo"])
@pytest.mark.parametrize("friction", [0.0, 6.0])
def test_both_ways_of_stepping_give_one_response(start, servo, friction, monkeypatch):
    sleeve = large.sleeve(at, H, friction, 900.0, H / 2)
    t = np.linspace(0, 8.0, 81)
    mine = large.respond(MACHINE, sleeve, start, t, servo)
    monkeypatch.setattr(large, "STIFF", 0.0)
    monkeypatch.setattr(large, "RELATIVE", 1e-9)
    monkeypatch.setattr(large, "ABSOLUTE", 1e-12)
    other = large.respond(MACHINE, sleeve, start, t, servo)
    assert np.abs(mine.omega - other.omega).max() < 2e-5 * np.ptp(other.omega) and np.ptp(other.omega) > 0.1
    assert np.abs(mine.z - other.z).max() < 2e-5 * H and np.abs(mine.s - other.s).max() < 2e-5


def test_a_dashpot_that_makes_it_stiff_lets_the_sleeve_creep():
    """With k beyond measure k z' = A ω² − E: the sleeve goes without inertia."""
    k = 4e6
    sleeve = large.sleeve(at, H, 0.0, k)
    machine = replace(MACHINE, inertia=1e15)
    found = large.respond(machine, sleeve, np.array([MACHINE.omega, 0.2 * H, 0.0]), np.linspace(0, 60.0, 601))
    z = found.z
    force = at(z).A * MACHINE.omega**2 - at(z).E
    assert np.gradient(z, found.t)[5:-5] == pytest.approx(force[5:-5] / k, rel=1e-3)


@pytest.mark.parametrize("lowest, offset, miss", [(0.1, 0.03, 1e-6), (0.08, 0.03, 1e-6), (0.002, 0.0, 0.1)])
def test_the_polynomials_are_told_how_far_they_miss(lowest, offset, miss):
    """Where the arms begin near their straight line no polynomial follows them."""
    arms = g.Arms(0.3, 0.3, offset, offset)
    h = float(arms.height(lowest) - arms.height(0.22))

    def places(z):
        return g.equilibrium(arms.moves(z, lowest), g.Weights(4.0, 30.0))

    missed = large.missed(large.sleeve(places, h, 0.0, 0.0), places)
    assert missed > 0.1 if miss == 0.1 else missed < miss
