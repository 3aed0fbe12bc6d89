"""Start-ups by every method: a motor with a closed solution, a machine driven by angle, orders of fixed steps."""

import numpy as np
import pytest
from conftest import solved

from tmm_report.mechanics.calculus.laws import ByTime
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.machine.characteristics import Linear
from tmm_report.mechanics.machine.reduced import Acting, Plant
from tmm_report.mechanics.rivals.run_up import (
    RUN_UPS,
    StartUp,
    adams,
    errors,
    reference,
    runge_kutta,
    scene_of,
)

KEYS = {one.key: one for one in RUN_UPS}
TURN = 2 * np.pi


def plant(inertia, moment=None, *laws):
    """`inertia`, `moment`: of the angle turned."""
    over = panels(TURN)
    J = inertia(over.x) + 0 * over.x
    acting = [Acting("motor", law=law) for law in laws]
    if moment is not None:
        acting.append(Acting("load", values=moment(over.x) + 0 * over.x))
    return Plant(over, J, over.slope(J), tuple(acting))


SHUNT = StartUp(plant(lambda x: 0.05, None, Linear(30.0, 150.0)), 0.0, 0.6)
SWINGING = StartUp(plant(lambda x: 0.4 + 0.1 * np.cos(2 * x), lambda x: 5 + 2 * np.sin(x)), 3.0, 0.8)
STIFF = StartUp(plant(lambda x: 0.001, None, Linear(300.0, 150.0)), 0.0, 0.5)


def worst(scene, key, exact, count=400):
    return max(errors(exact, KEYS[key].run(scene, count)).values())


def accepted(scene):
    return [one.key for one in RUN_UPS if one.refuses(scene) is None]


def test_a_shunt_motor_comes_to_its_speed_exponentially():
    """J dω/dt = M₀(1 − ω/ω₀): ω = ω₀(1 − e^{−t/T}), T = Jω₀/M₀, φ = ω₀(t − T(1 − e^{−t/T}))."""
    T, t = 0.05 * 150 / 30, SHUNT.time
    rest = np.exp(-t / T)
    speed, angle = 150 * (1 - rest), 150 * (t - T * (1 - rest))
    for key in accepted(SHUNT):
        found = KEYS[key].run(SHUNT, 400)
        assert (found.omega, found.phi) == pytest.approx((speed, angle), rel=2e-5), key
    best = reference(SHUNT)
    assert (best.omega, best.phi) == pytest.approx((speed, angle), rel=1e-12)
    assert "energy" not in accepted(SHUNT)
    assert "angle" in str(KEYS["energy"].refuses(SHUNT))


@pytest.mark.exhaustive
def test_what_is_driven_by_angle_keeps_its_balance_of_energy():
    for key in accepted(SWINGING):
        found = KEYS[key].run(SWINGING, 400)
        J = 0.4 + 0.1 * np.cos(2 * found.phi)
        work = 5 * found.phi + 2 * (1 - np.cos(found.phi))
        assert J * found.omega**2 / 2 == pytest.approx(0.5 * 3.0**2 / 2 + work, rel=3e-4), key
    exact = reference(SWINGING)
    assert worst(SWINGING, "energy", exact) < 1e-11
    assert worst(SWINGING, "program", exact) < 1e-11


@pytest.mark.parametrize("way", [runge_kutta, adams])
def test_fixed_steps_are_of_the_fourth_order(way):
    exact = reference(SWINGING)
    found = np.array([max(errors(exact, way(SWINGING, count)).values()) for count in (160, 320, 640)])
    assert np.log2(found[:-1] / found[1:]) == pytest.approx([4, 4], abs=0.4)


@pytest.mark.parametrize("key", ["lsoda", "dop853", "radau"])
def test_a_finer_tolerance_is_nearer(key):
    exact = reference(SHUNT)
    rough, fine = (worst(SHUNT, f"{key}_{tolerance}", exact) for tolerance in ("1e-5", "1e-9"))
    assert fine < 1e-7
    assert fine < rough / 10


def test_explicit_fixed_steps_that_are_too_long_for_a_stiff_machine_run_away():
    """A time constant of 0.5 ms: beyond 2.8 of them a step of Runge and Kutta's grows every error."""
    exact = reference(STIFF)
    assert exact.omega == pytest.approx(150, rel=1e-12)
    for key in ("runge_kutta", "adams"):
        try:
            assert worst(STIFF, key, exact, 100) > 1e3
        except ArithmeticError as error:
            assert "too long" in str(error)
        assert worst(STIFF, key, exact, 3000) < 1e-5
    for key in ("program", "lsoda_1e-7", "radau_1e-7", "dop853_1e-7"):
        assert worst(STIFF, key, exact) < 1e-6


def test_the_reference_steps_from_kink_to_kink_of_a_load_by_time():
    """A load of 1 ms in a second of coasting: J Δω = −∫M dt, whatever steps would leap over it."""
    pulse = ByTime((0.0, 0.5, 0.5005, 0.501, 1.0), (0.0, 0.0, 200.0, 0.0, 0.0))
    over = panels(TURN)
    machine = Plant(
        over, np.full(over.shape, 0.5), np.zeros(over.shape), (Acting("load", law=pulse, sign=-1.0),)
    )
    scene = StartUp(machine, 10.0, 1.0)
    assert reference(scene).omega == pytest.approx(10 - 0.1 / 0.5, rel=1e-10)


def test_a_motion_found_by_the_program_is_a_task_for_its_rivals():
    found = solved("hoist_start").dynamics.start
    scene = scene_of(found)
    exact = reference(scene)
    assert exact.omega == pytest.approx(found.omega[-1], rel=1e-7)
    assert exact.phi == pytest.approx(found.phi[-1], rel=1e-7)
    for key in accepted(scene):
        assert worst(scene, key, exact) < 1e-3, key


def test_a_machine_that_stops_on_the_way_is_told_so():
    """J ω²/2 = 0.45 J is gone after 0.09 rad at 5 N m: no later time is reached by an integral."""
    scene = StartUp(plant(lambda x: 0.1, lambda x: -5.0), 3.0, 2.0)
    for key in ("program", "energy"):
        with pytest.raises(ArithmeticError, match="stops"):
            KEYS[key].run(scene, 100)
