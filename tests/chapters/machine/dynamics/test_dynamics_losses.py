"""Losses in the gears by the acceleration: the flow of power decides on which side η stands, part by part."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from test_dynamics_chapter import alone, book, refused

from tmm_report.mechanics.machine.passing import Passing
from tmm_report.mechanics.machine.run.steady import closing

TRAIN = """
  parts:
    - {name: rotor, inertia: 0.08 kg*m^2}
    - {name: pulley, ratio: 0.4, inertia: 2.5 kg*m^2, moment: 20 N*m, efficiency: 0.95}
    - {name: drum, ratio: 0.05, inertia: 30 kg*m^2, efficiency: 0.9}
    - {name: load, ratio: 0.05, radius: 200 mm, mass: 400 kg, moves: up, efficiency: 0.85}
  losses_of_acceleration: true
  motor:
    by_speed: [[0, 120 N*m], [80, 150 N*m], [120, 180 N*m], [150, 60 N*m], [157, 0]]
  resistance:
    - {name: dry, friction: 6 N*m}
    - {name: fan, fan: {moment: 12 N*m, speed: 1500 rpm}}
"""
# J, M on the main shaft without losses, η: by hand from the rows above
BRANCHES = [(0.08, 0.0, 1.0), (0.4, 8.0, 0.95), (0.075, 0.0, 0.9), (0.04, 400 * 9.81 * 0.01, 0.85)]


def motor(omega):
    return float(np.interp(omega, [0, 80, 120, 150, 157], [120, 150, 180, 60, 0]))


def fan(omega):
    return 12 * (omega / (50 * math.pi)) ** 2


def took(epsilon, branches):
    """What the main shaft gives to all branches, by the definition of an efficiency: out/in of each gear."""
    whole = 0.0
    for J, M, eta in branches:
        goes = M + J * epsilon
        whole += goes / eta if goes > 0 else goes * eta
    return whole


def rate(left, branches, added=0.0):
    """ε at which all that is left is taken; `added`: inertia on the main shaft itself."""
    return brentq(lambda x: took(x, branches) + added * x - left, -1e6, 1e6, xtol=1e-13, rtol=1e-14)


def until(speed, begin, epsilon, horizon=20.0):
    """Time and angle at which a speed is met, by Runge and Kutta."""

    def there(t, y):
        return y[1] - speed

    there.terminal = True
    found = solve_ivp(lambda t, y: [y[1], epsilon(y[1])], (0, horizon), [0.0, begin], events=there,
                      rtol=1e-9, atol=1e-9, max_step=0.02)  # fmt: skip
    return found.t[-1], found.y[0, -1]


def test_in_a_run_down_what_drives_stands_on_the_other_side_of_its_gear():
    found = alone(TRAIN + "  start: {within: 1 %}\n  coast: {brake: 30 N*m}\n")
    begin = found.coast.omega[0]
    t, phi = until(0.0, begin, lambda w: rate(-36 - fan(w), BRANCHES))
    assert (found.coast.t[-1], found.coast.phi[-1]) == pytest.approx((t, phi), rel=1e-7)
    assert t == pytest.approx(0.9078, abs=1e-4)
    t, phi = until(0.99 * begin, 0.0, lambda w: rate(motor(w) - 6 - fan(w), BRANCHES))
    assert (found.start.t[-1], found.start.phi[-1]) == pytest.approx((t, phi), rel=1e-6)


@pytest.mark.parametrize(
    ("coast", "begin", "braked", "branches"),
    [
        ("{begin: 90}", 90.0, lambda w: -6 - fan(w), BRANCHES),
        ("{begin: 120, brake: 200 N*m, speed: 10}", 120.0, lambda w: -206 - fan(w), BRANCHES),
        ("{begin: 140, motor: reversed}", 140.0, lambda w: -126 - fan(w), BRANCHES),
        ("{begin: 90, load: false}", 90.0, lambda w: -6 - fan(w),
         [(J, M if k == 3 else 0.0, eta) for k, (J, M, eta) in enumerate(BRANCHES)]),
    ],
)  # fmt: skip
def test_run_downs_of_every_kind_against_an_integration_of_their_own(coast, begin, braked, branches):
    found = alone(f"{TRAIN}  steady: false\n  start: {{speed: 10}}\n  coast: {coast}\n").coast
    t, phi = until(float(found.omega[-1]), begin, lambda w: rate(braked(w), branches))
    assert (found.t[-1], found.phi[-1]) == pytest.approx((t, phi), rel=1e-6)


@pytest.mark.parametrize("part", ["moment: 30 N*m, moves: down", "moves: down", "force: 500 N, moves: down"])
def test_a_load_that_drives_is_braked_by_its_own_acceleration_and_by_what_resists_beside_it(part):
    """A weight that is lowered with its drum: one branch, one flow of power."""
    found = alone(f"""
  parts:
    - {{name: rotor, inertia: 0.5}}
    - {{name: drum, ratio: 0.1, inertia: 90, radius: 0.3, mass: 120, efficiency: 0.8, {part}}}
  losses_of_acceleration: true
  resistance: [{{fan: {{moment: 20, speed: 40}}}}]
  motor: {{shunt: {{moment: 40, speed: 90, no_load: 100}}}}
  start: {{within: 3 %}}
""")
    M = 30 * 0.1 * ("moment" in part) + (500 * ("force" in part) - 120 * 9.81) * 0.03
    branches = [(0.9 + 120 * 0.03**2, M, 0.8)]

    def epsilon(w):
        return rate(400 * (1 - w / 100) - 20 * (w / 40) ** 2, branches, 0.5)

    assert rate(400 * (1 - found.steady.mean / 100) - 20 * (found.steady.mean / 40) ** 2, branches, 0.5) == \
        pytest.approx(0, abs=1e-9)  # fmt: skip
    t, phi = until(float(found.start.omega[-1]), 0.0, epsilon)
    assert (found.start.t[-1], found.start.phi[-1]) == pytest.approx((t, phi), rel=1e-5)


SWINGING = """
  parts:
    - {name: shaft, inertia: 1.5}
    - {name: wheel, ratio: 3, inertia: 0.6, efficiency: 0.8}
    - {name: roll, ratio: 0.5, inertia: 4, moment: 30, efficiency: 0.9}
  losses_of_acceleration: true
  resistance: [{by_angle: [[0, 0], [90 deg, 300], [180 deg, 0], [360 deg, 0]]}]
"""


def swinging(phi):
    return float(np.interp(phi % (2 * math.pi), [0, math.pi / 2, math.pi, 2 * math.pi], [0, 300, 0, 0]))


def test_in_steady_motion_a_part_drives_and_is_driven_by_turns():
    found = alone(SWINGING + "  motor: {shunt: {moment: 150, speed: 27, no_load: 30}}\n  steady: true\n")
    branches = [(5.4, 0.0, 0.8), (1.0, 15.0, 0.9)]

    def rates(t, y):
        return [y[1], rate(1500 * (1 - y[1] / 30) - swinging(y[0]), branches, 1.5)]

    first = float(found.steady.plant.panels.at(found.steady.omega, np.zeros(1))[0])
    cycle = solve_ivp(rates, (0, found.steady.cycle), [0.0, first], rtol=1e-9, atol=1e-9, max_step=2e-3)
    assert cycle.y[:, -1] == pytest.approx([2 * math.pi, first], rel=1e-7)
    of = found.steady
    assert abs(sum(of.works.values())) < 1e-9 * of.works["motor"] and of.works["gears"] < 0
    assert len(of.bends) >= 2 and of.residual < 1e-6


@pytest.mark.exhaustive
def test_a_motor_without_a_speed_gives_what_the_gears_lose_too():
    """Moments of the angle alone: the constant moment by which the cycle closes, by a shooting of its own."""
    text = SWINGING + "  motor: {constant: %r}\n  speed: 25\n  steady: %s\n"
    assert "lacks" in refused(text % (300 / 4 + 15 / 0.9, "true"))[0]
    branches = [(5.4, 0.0, 0.8), (1.0, 15.0, 0.9)]

    def turned(moment, first):
        def rates(t, y):
            return [y[1], rate(moment - swinging(y[0]), branches, 1.5)]

        return solve_ivp(rates, (0, 1.0), [0.0, first], rtol=1e-9, atol=1e-9, max_step=2e-3, events=_turned)

    plant = alone(text % (0.0, "false") + "  start: {begin: 25, speed: 20}\n").start.plant
    found = closing(plant, 25.0)
    first = 25.0
    for _ in range(4):  # the mean of the extremes is to be the stated speed
        whole = turned(found, first)
        first += 25.0 - (whole.y[1].max() + whole.y[1].min()) / 2
    assert whole.y_events[0][0][1] == pytest.approx(first, rel=1e-6)
    assert found > 75 + 15 / 0.9 + 0.5


def _turned(t, y):
    return y[0] - 2 * math.pi


_turned.terminal = True


def test_a_gear_of_the_motor_loses_on_the_other_side_when_it_brakes():
    text = """
  parts: [{name: drum, inertia: 40}]
  motor: {shunt: {moment: 100, speed: 90, no_load: 100}, ratio: 5, efficiency: 0.8}
  coast: {begin: 19, motor: MOTOR, speed: 10}
"""
    found = alone(text.replace("MOTOR", "reversed")).coast
    t, _ = until(10.0, 19.0, lambda w: -5 * 1000 * (1 + 5 * w / 100) / 0.8 / 40)
    assert found.t[-1] == pytest.approx(t, rel=1e-7)
    braked = alone("""
  parts: [{name: cage, mass: 500, radius: 0.2, moves: down}]
  motor: {shunt: {moment: 100, speed: 90, no_load: 100}, ratio: 5, efficiency: 0.8}
  start: {begin: 20.5, within: 1 %}
""")
    assert 5 * 1000 * (1 - 5 * braked.steady.mean / 100) / 0.8 == pytest.approx(-500 * 9.81 * 0.2)


def test_the_bends_of_the_broken_line_are_those_of_its_definition():
    numbers = np.random.default_rng(5)
    for _ in range(40):
        n = int(numbers.integers(1, 6))
        J, eta = numbers.uniform(0.1, 5, n), numbers.uniform(0.3, 0.99, n)
        M = numbers.normal(0, 50, n) * numbers.integers(0, 2, n)
        passing, own = Passing(J, M, eta), float(numbers.uniform(0, 3))
        still = took(0.0, zip(J, M, eta, strict=True))
        for left in numbers.normal(0, 400, 6):
            wanted = rate(left + still, list(zip(J, M, eta, strict=True)), own)
            assert passing.acceleration(left, own + J.sum()) == pytest.approx(wanted, rel=1e-9, abs=1e-9)
            lost = took(wanted, zip(J, M, eta, strict=True)) - still - J.sum() * wanted
            assert passing.lost(np.array(wanted)) == pytest.approx(lost, rel=1e-9, abs=1e-9)


def test_the_printed_losses_and_the_balance_of_works_are_those_of_the_motion():
    found = alone(TRAIN + "  start: {within: 1 %}\n  coast: {brake: 30 N*m}\n")
    values = book(found)
    for name, run in found.runs:
        table = {one.key: np.array(one.values) for one in values.tables[f"dynamics_{name}"].columns}
        balance = table["M_dr"] - table["M_res"] - 0.595 * table["epsilon"]
        assert balance == pytest.approx(0, abs=1e-9)
        more = [took(x, BRANCHES) - took(0.0, BRANCHES) - 0.595 * x for x in table["epsilon"]]
        assert table["M_lost"] == pytest.approx(more, abs=1e-9)
        assert sum(run.works.values()) == pytest.approx(run.gained, rel=1e-7)
        assert run.gained == pytest.approx(0.595 * (run.omega[-1] ** 2 - run.omega[0] ** 2) / 2)
