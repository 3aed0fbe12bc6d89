"""Large motions of the machine with its governor against closed answers and energy; the brake."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tmm_report.mechanics.machine.governor import equilibrium as g
from tmm_report.mechanics.machine.governor import response as large
from tmm_report.mechanics.machine.governor import stability as small
from tmm_report.mechanics.machine.governor.brake import Brake

ARMS = g.Arms(0.3, 0.3, 0.0, 0.04)
LOWEST = 0.15
H = float(ARMS.height(0.15) - ARMS.height(0.2))


def at(z):
    return g.equilibrium(ARMS.moves(z, LOWEST), g.Weights(6.0, 40.0, 2000.0))


def plant(load: float, **changes: float) -> large.Machine:
    omega = float(at(np.array([H / 2])).omega[0])
    return replace(large.Machine(60.0, 400.0, load, omega), **changes)


def test_the_polynomials_of_the_sleeve_are_those_of_its_mechanism():
    sleeve = large.sleeve(at, H, 0.0, 0.0)
    z = np.linspace(0, H, 33)
    found = at(z)
    x = 2 * z / H - 1
    for mine, exact in ((sleeve.E, found.E), (sleeve.A, found.A), (sleeve.m, found.mass)):
        assert [large.horner(mine, one) for one in x] == pytest.approx(exact, rel=1e-9)
    e = 1e-5
    slope = (at(z[1:-1] + e).mass - at(z[1:-1] - e).mass) / (2 * e)
    assert [large.horner(sleeve.dm, one) for one in x[1:-1]] == pytest.approx(slope, rel=1e-5)


def test_energy_of_the_sleeve_at_a_held_speed_is_conserved():
    """With a flywheel beyond measure the speed stays: m v²/2 + ∫(E − A ω²) dz is constant without dashpot and
    friction."""
    machine = plant(200.0, inertia=1e15)
    sleeve = large.sleeve(at, H, 0.0, 0.0)
    t = np.linspace(0, 2.0, 201)
    found = large.respond(machine, sleeve, np.array([machine.omega, 0.35 * H, 0.0]), t)
    z = found.z
    v = np.gradient(z, t, edge_order=2)
    fine = np.linspace(z.min(), z.max(), 2001)
    force = at(fine).E - at(fine).A * machine.omega**2
    work = np.concatenate([[0], np.cumsum((force[1:] + force[:-1]) / 2 * np.diff(fine))])
    energy = at(z).mass * v**2 / 2 + np.interp(z, fine, work)
    assert np.ptp(energy[2:-2]) < 5e-3 * np.ptp(work) and np.ptp(z) > 0.2 * H


def test_a_small_step_moves_as_the_small_motions_do():
    sleeve = large.sleeve(at, H, 0.0, 900.0)
    z0, t = 0.5 * H, np.linspace(0, 6.0, 301)
    state = at(np.array([z0]))
    omega = float(state.omega[0])
    load = 400.0 * (1 - z0 / H)
    found = large.respond(plant(load), sleeve, np.array([omega * 1.00001, z0, 0.0]), t)
    loop = small.Loop(
        60.0, 0.0, 400.0, 1.0, state.mass[0], 900.0, state.S[0], 2 * state.A[0] * omega, omega, H
    )
    exact = small.linear(small.matrix(loop), np.array([1e-5, 0, 0]), 6.0, 301)
    assert (found.omega / omega - 1) == pytest.approx(exact[0], abs=2e-9)
    assert (found.z - z0) / H == pytest.approx(exact[1], abs=2e-8)


def test_a_resting_sleeve_leaves_the_machine_alone():
    """Friction beyond every force: J ω' = M s − M_c at a constant supply."""
    sleeve = large.sleeve(at, H, 1e6, 0.0)
    machine, t = plant(100.0), np.linspace(0, 2.0, 21)
    found = large.respond(machine, sleeve, np.array([15.0, 0.5 * H, 0.0]), t)
    assert found.omega == pytest.approx(15.0 + (200.0 - 100.0) / 60.0 * t, rel=1e-9)
    assert found.z == pytest.approx(0.5 * H, rel=1e-12)


def test_the_sleeve_never_passes_its_stops():
    sleeve = large.sleeve(at, H, 0.0, 5.0)
    found = large.respond(plant(390.0), sleeve, np.array([10.0, 0.9 * H, 0.0]), np.linspace(0, 5, 501))
    assert found.z.min() > -1e-6 * H and found.z.max() < (1 + 1e-6) * H
    assert found.z.min() < 1e-6 * H  # it does come to one


def test_with_friction_it_comes_to_rest_within_the_band():
    friction = 10.0
    sleeve = large.sleeve(at, H, friction, 2500.0)
    found = large.respond(plant(280.0), sleeve, np.array([18.0, 0.5 * H, 0.0]), np.linspace(0, 30, 301))
    end = at(found.z[-1:])
    down, up = end.band(friction)
    assert np.ptp(found.z[-10:]) < 1e-4 * H and down[0] - 1e-3 <= found.omega[-1] <= up[0] + 1e-3


def test_the_isodrome_brings_the_speed_back():
    servo = small.Servo(0.1, 0.0, 1.5, 1.0)
    sleeve = large.sleeve(at, H, 0.0, 900.0, H / 2)
    machine = plant(300.0)
    start = np.array([machine.omega, H / 2, 0.0, 0.5, 0.0])
    found = large.respond(machine, sleeve, start, np.linspace(0, 40, 201), servo)
    assert found.omega[-1] == pytest.approx(machine.omega, rel=1e-6)
    assert found.s[-1] == pytest.approx(0.75, rel=1e-6) and found.x[-1] == pytest.approx(0, abs=1e-7)


def test_a_dead_zone_leaves_an_error_no_larger_than_it():
    zone = 0.001
    sleeve = large.sleeve(at, H, 0.0, 900.0, H / 2)
    servo, machine = small.Servo(0.1, zone, 1.5, 1.0), plant(300.0)
    start = np.array([machine.omega, H / 2, 0.0, 0.5, 0.0])
    found = large.respond(machine, sleeve, start, np.linspace(0, 40, 201), servo)
    assert abs(found.z[-1] - H / 2) < 3 * zone and abs(found.z[-1] - H / 2) > 1e-7


# --- the brake

BRAKE = Brake(1.5, 0.09, 0.003, 0.13, 0.35, 60e3, 900.0, 3)


def test_the_brake_balances_what_drives_it():
    assert BRAKE.moment(BRAKE.held(60.0)) == pytest.approx(60.0)
    assert (
        BRAKE.moment(BRAKE.contact) == pytest.approx(0.0, abs=1e-9) and BRAKE.moment(0.5 * BRAKE.contact) == 0
    )
    force = BRAKE.mass * BRAKE.at_contact * BRAKE.contact**2
    assert force == pytest.approx(900 + 60e3 * 0.003)


def test_the_start_with_the_brake_obeys_its_equation():
    """J ω' = M − M_b(ω), by differences."""
    t, e = np.linspace(0.2, 8.0, 40), 1e-5
    ahead, behind = (BRAKE.start(60.0, 2.5, t + step) for step in (e, -e))
    rate = (ahead - behind) / (2 * e)
    assert 2.5 * rate == pytest.approx(60.0 - BRAKE.moment(BRAKE.start(60.0, 2.5, t)), abs=1e-5)
    at_time = BRAKE.time_to(0.99, 60.0, 2.5)
    assert BRAKE.start(60.0, 2.5, at_time) == pytest.approx(0.99 * BRAKE.held(60.0))


def test_a_stiffer_friction_holds_a_lower_speed():
    assert (
        replace(BRAKE, friction=0.5).held(60.0) < BRAKE.held(60.0) < replace(BRAKE, preload=1000.0).held(60.0)
    )


def test_the_piston_rests_at_the_ends_of_its_stroke_while_it_is_pressed_to_them():
    """A fast servomotor after a large step: the supply is full for a time, constant to the last digit, then leaves."""
    servo, machine = small.Servo(0.02), plant(395.0, slope=30.0, least=0.2)
    sleeve = large.sleeve(at, H, 0.0, 900.0, H / 2)
    start = np.array(
        [
            machine.omega * 0.97,
            H / 2,
            0.0,
            0.3,
        ]
    )
    found = large.respond(machine, sleeve, start, np.linspace(0, 6, 601), servo)
    full = found.s >= 1
    assert 10 < full.sum() < 590 and found.s.max() <= 1 + 1e-6 and found.s.min() >= 0.2 - 1e-6
    # while it rests there the machine follows J ω' = M_d(ω) − M_c
    first, last = np.flatnonzero(full)[[0, -1]]
    alone = np.flatnonzero(~full[first : last + 1])
    end = first + alone[0] if len(alone) else last
    t, omega = found.t[first : end - 1] - found.t[first], found.omega[first : end - 1]
    limit = machine.omega + (400.0 - 395.0) / 30.0
    assert omega == pytest.approx(limit + (omega[0] - limit) * np.exp(-30.0 * t / 60.0), rel=1e-6)


def test_a_machine_that_stops_is_said_to():
    sleeve = large.sleeve(at, H, 0.0, 900.0)
    with pytest.raises(large.Stalled):
        large.respond(plant(399.0, inertia=0.01), sleeve, np.array([5.0, H, 0.0]), np.linspace(0, 5, 51))
