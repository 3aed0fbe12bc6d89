"""Laws of motion by the time: their rates are derivatives, and every time at which they come to an angle is found."""

import numpy as np
import pytest

from tmm_report.mechanics.calculus.motion_laws import (
    Harmonic,
    Phased,
    Pieces,
    Polynomial,
    RunUp,
    Tabulated,
    accelerated,
    time_of,
)
from tmm_report.mechanics.calculus.roots import slope
from tmm_report.mechanics.cams.follower_laws import Phase, Phases
from tmm_report.mechanics.cams.shapes import named

FULL_TURN = 2 * np.pi
PHASES = Phases(
    (
        Phase("rise", 2.5, named("sine")),
        Phase("dwell", 0.7),
        Phase("return", FULL_TURN - 3.2, named("polynomial")),
    ),
    1.1,
)
LAWS = {
    "rocker": Harmonic(1.5, 0.0, 0.6, 8.0, 0.3),
    "uneven crank": Harmonic(0.2, 12.0, 0.15, 12.0),
    "clockwise": Harmonic(0.2, -12.0, 0.3, 24.0, 0.0, 2),
    "accelerated": accelerated(0.4, 5.0, 4.0, 0.8),
    "turning back": Polynomial((0.35, 0.0, 6.0, -2.0), 2.5),
    "table": Tabulated((0.0, 0.2, 0.4, 0.7, 1.0), (0.1, 1.3, 2.2, 3.6, 0.1 + FULL_TURN)),
    "open table": Tabulated((0.0, 0.2, 0.4, 0.7, 1.0), (0.1, 0.4, 1.2, 1.0, 0.3)),
    "phases": Phased(PHASES, 0.3, 2.0),
    "lifted": Phased(
        Phases((Phase("dwell", 1.0), Phase("rise", FULL_TURN - 1.0, named("polynomial"))), 1.4), 0.3, 2.0
    ),
    "lowered": Phased(Phases((Phase("rise", FULL_TURN, named("sine")),), -1.4), 0.3, 2.0),
    "run up": RunUp(1.1, 0.0, (0.4, 2.0, 0.6), (0.375, 0.0, -0.25), 0.15, 0.4, 0.6),
    "pieces": Pieces(1.1, 0.0, (0.4, 2.0, 0.6), (0.375, 0.0, -0.2)),
}
every = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)


@every
def test_rates_are_derivatives(law):
    t = np.linspace(0.0, law.period, 29)[1:-1] + 1e-4
    _, v, a = law.at(t)
    step = 1e-4 * law.period
    assert slope(lambda x: law.at(x)[0], t, step) == pytest.approx(v, rel=1e-7, abs=1e-7 * law.fastest)
    away = np.min(np.abs(t[:, None] - np.array([*law.breaks, -1.0])), axis=1) > 8 * step
    differences = slope(lambda x: law.at(x)[1], t, step)
    assert differences[away] == pytest.approx(a[away], rel=1e-6, abs=1e-6 * law.fastest / law.period)


@every
def test_a_law_that_repeats_goes_on_where_it_ended(law):
    theta = np.linspace(0.0, FULL_TURN, 7)[:-1] + 0.1
    before, after = law.of_phase(theta), law.of_phase(theta + FULL_TURN)
    assert after[0] - before[0] == pytest.approx(np.full(6, law.advance), abs=1e-9) or not law.returns
    if law.returns:
        assert after[1] == pytest.approx(before[1], abs=1e-9 * law.fastest)
        assert law.advance / FULL_TURN == pytest.approx(round(law.advance / FULL_TURN), abs=1e-9)


def test_which_laws_repeat():
    assert [name for name, law in LAWS.items() if not law.returns] == [
        "accelerated",
        "turning back",
        "open table",
        "lifted",
        "lowered",
        "run up",
        "pieces",
    ]


@every
@pytest.mark.parametrize("angle", [0.5, 1.0, 1.9, 2.6, 4.0, -3.0])
def test_every_time_at_which_it_comes_to_an_angle_is_found(law, angle):
    t = np.linspace(0.0, law.period, 200_001)
    turns = np.floor((law.at(t)[0] - angle) / FULL_TURN)
    crossed = (t[:-1] + t[1:])[turns[:-1] != turns[1:]] / 2 * FULL_TURN / law.period
    found = law.when([angle])
    assert found == pytest.approx(crossed, abs=1e-4)
    here = law.at(found * law.period / FULL_TURN)[0]
    assert np.angle(np.exp(1j * (here - angle))) == pytest.approx(np.zeros(found.size), abs=1e-11)


@every
def test_reach_is_that_of_many_times(law):
    q = law.at(np.linspace(0.0, law.period, 200_001))[0]
    assert law.reach == pytest.approx((q.min(), q.max()), abs=1e-8)


@pytest.mark.parametrize("speed, acceleration", [(5.0, 4.0), (5.0, -1.9), (5.0, 1e-12), (0.0, 3.0)])
def test_the_time_of_a_turn_with_constant_acceleration(speed, acceleration):
    t = time_of(FULL_TURN, speed, acceleration)
    assert speed * t + acceleration * t**2 / 2 == pytest.approx(FULL_TURN, rel=1e-12)


def test_it_stops_before_a_turn():
    assert np.isnan(time_of(FULL_TURN, 5.0, -2.1))
