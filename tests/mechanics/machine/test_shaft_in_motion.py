"""The motion of one shaft against closed answers, one way against another, energy kept; the periodic solution."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import examples
from hypothesis import given, settings
from hypothesis import strategies as st

from tmm_report.mechanics.calculus import laws
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.machine import characteristics as ch
from tmm_report.mechanics.machine.reduced import Acting, Plant, between, level, pointwise
from tmm_report.mechanics.machine.run.by_time import by_time
from tmm_report.mechanics.machine.run.law import run
from tmm_report.mechanics.machine.run.motion_law import Goal, NeverReached
from tmm_report.mechanics.machine.run.steady import NotSteady, at_mean_speed, periodic

TURN = panels(2 * np.pi)


def plant(*acting, J=None, slope=None, over=TURN):
    inertia = np.full(over.shape, 2.0) if J is None else J(over.x)
    return Plant(over, inertia, np.zeros(over.shape) if slope is None else slope(over.x), acting)


def moment(of, key="load"):
    return Acting(key, values=np.broadcast_to(of(TURN.x) if callable(of) else of, TURN.shape).astype(float))


MOTOR = Acting("motor", law=ch.Linear(100.0, 150.0))
UNEVEN = {"J": lambda x: 2 + 0.5 * np.cos(2 * x), "slope": lambda x: -np.sin(2 * x)}
WAVY = moment(lambda x: -40 - 30 * np.cos(x))


# --- closed answers


@pytest.mark.parametrize("goal", [Goal(speed=30.0), Goal(time=20.0), Goal(angle=300.0)])
def test_a_constant_moment_accelerates_evenly(goal):
    found = run(plant(moment(7.0, "motor"), moment(-4.0)), 0.0, goal)
    assert (found.t[-1], found.phi[-1], found.omega[-1]) == pytest.approx((20.0, 300.0, 30.0), rel=1e-9)
    assert found.omega == pytest.approx(1.5 * found.t, abs=1e-6)
    assert found.works == pytest.approx({"motor": 2100.0, "load": -1200.0}) and found.error < 1e-9


def test_a_linear_motor_approaches_its_speed_exponentially():
    found = run(plant(MOTOR, moment(-20.0)), 0.0, Goal(speed=0.98 * 120))
    time_constant = 2.0 * 150 / 100
    assert found.way == "speed" and found.error < 1e-12
    assert found.t[-1] == pytest.approx(time_constant * np.log(50), rel=1e-12)
    assert found.omega == pytest.approx(120 * (1 - np.exp(-found.t / time_constant)), rel=1e-11, abs=1e-9)


def test_an_unloaded_induction_motor_starts_in_the_closed_time():
    law = ch.Kloss(104.72, 21441.0, 0.12)
    found = run(plant(Acting("motor", law=law), J=lambda x: 100 + 0 * x), 0.0, Goal(speed=0.95 * 104.72))
    assert found.t[-1] == pytest.approx(ch.kloss_time(100.0, law, 1.0, 0.05), rel=1e-12)


def test_a_viscous_and_a_dry_resistance_run_the_machine_down_in_the_closed_time():
    rubbing = Acting("viscous", law=ch.Power(0.15, 1.0), sign=-1.0)
    found = run(plant(rubbing, moment(-15.0)), 157.0, Goal(speed=0.0))
    assert found.t[-1] == pytest.approx(2.0 / 0.15 * np.log((157 + 100) / 100), rel=1e-12)


def agm(a, b):
    while abs(a - b) > 1e-15:
        a, b = (a + b) / 2, np.sqrt(a * b)
    return a


@pytest.mark.parametrize("swing", [0.2, 1.5, 2.9])
def test_a_pendulum_swings_in_the_time_by_the_arithmetic_geometric_mean(swing):
    hanging = plant(moment(lambda x: -9.0 * np.sin(x)), J=lambda x: 1 + 0 * x)
    quarter = np.pi / 2 / 3 / agm(1.0, np.cos(swing / 2))
    down = run(hanging, 0.0, Goal(angle=swing), -swing)
    assert down.t[-1] == pytest.approx(quarter, rel=1e-11)
    assert down.omega[-1] == pytest.approx(np.sqrt(18 * (1 - np.cos(swing))), rel=1e-12)
    up = run(hanging, float(down.omega[-1]), Goal(speed=0.0))
    assert (up.t[-1], up.phi[-1]) == pytest.approx((quarter, swing), rel=1e-9)


def test_a_constant_couple_on_a_shaft_of_varying_inertia_obeys_the_energy_integral():
    found = run(plant(moment(5.0), **UNEVEN), 1.0, Goal(angle=20.0))
    energy = (2.5 * 1.0) / 2 + 5.0 * found.phi
    assert (2 + 0.5 * np.cos(2 * found.phi)) * found.omega**2 / 2 == pytest.approx(energy, rel=1e-12)


def test_a_speed_that_is_met_just_at_the_end_of_a_turn_is_met():
    turns = np.arange(1, 41)
    for n in turns:
        found = run(plant(moment(1.0)), 0.0, Goal(speed=float(np.sqrt(2 * np.pi * n))))
        assert found.phi[-1] == pytest.approx(2 * np.pi * n, rel=1e-11)


def test_a_run_down_of_many_turns_takes_the_time_of_small_steps():
    """Whole cycles by the points of the panels, the first and the last one by finer pieces."""
    machine = plant(moment(lambda x: -0.4 - np.cos(x)), **UNEVEN)
    found, other = run(machine, 12.0, Goal(speed=0.0)), by_time(machine, 12.0, Goal(speed=0.0))
    assert found.way == "angle" and found.phi[-1] > 40 * 2 * np.pi
    assert (found.t[-1], found.phi[-1]) == pytest.approx((other.t[-1], other.phi[-1]), rel=1e-6)
    assert np.interp(found.phi, other.phi, other.t)[1:-1] == pytest.approx(found.t[1:-1], rel=2e-3)


# --- one way against another


@settings(max_examples=examples(8), deadline=None)
@given(st.floats(-35, 35), st.floats(40, 200), st.floats(0.5, 0.97))
def test_by_speed_and_by_time_are_one_motion(load, stall, share):
    machine = plant(Acting("motor", law=ch.Linear(stall, 150.0)), moment(load))
    goal = Goal(speed=share * 150 * (1 + load / stall))
    one, other = run(machine, 0.0, goal), by_time(machine, 0.0, goal)
    assert (one.way, other.way) == ("speed", "time")
    assert (one.t[-1], one.phi[-1]) == pytest.approx((other.t[-1], other.phi[-1]), rel=1e-6)
    assert one.works == pytest.approx(other.works, rel=1e-6, abs=1e-6) and other.error < 1e-7


def test_by_angle_and_by_time_are_one_motion():
    machine = plant(moment(12.0, "motor"), moment(lambda x: -4 * np.sin(x)), **UNEVEN)
    one, other = run(machine, 2.0, Goal(speed=20.0)), by_time(machine, 2.0, Goal(speed=20.0))
    assert one.way == "angle" and (one.t[-1], one.phi[-1]) == pytest.approx(
        (other.t[-1], other.phi[-1]), rel=1e-7
    )


@pytest.mark.exhaustive
def test_whole_cycles_by_collocation_are_those_by_small_steps():
    """A start-up of some turns; the same with a load stated by time, which is stepped through from end to end."""
    machine = plant(MOTOR, WAVY, **UNEVEN)
    goal = Goal(angle=9 * 2 * np.pi + 1.0)
    one = by_time(machine, 20.0, goal)
    never = Acting("never", law=laws.ByTime((0.0, 1.0), (0.0, 0.0)))
    other = by_time(plant(MOTOR, WAVY, never, **UNEVEN), 20.0, goal)
    assert one.steps < other.steps / 3
    assert (one.t[-1], one.omega[-1]) == pytest.approx((other.t[-1], other.omega[-1]), rel=1e-7)
    assert np.interp(one.t, other.t, other.phi) == pytest.approx(one.phi, abs=2e-3)
    assert one.error < 1e-8 and one.residual < 1e-6


@pytest.mark.exhaustive
def test_a_start_from_rest_keeps_its_energy_and_meets_the_equation():
    machine = plant(MOTOR, WAVY, **UNEVEN)
    steady = periodic(machine, level(machine.net, 0.0))
    found = by_time(machine, 0.0, Goal(near=0.98 * steady.omega))
    assert found.error < 1e-7 and found.residual < 1e-5
    at_end = TURN.at(steady.omega, found.phi[-1:])[0]
    assert found.omega[-1] == pytest.approx(0.98 * at_end, rel=1e-8)
    assert (found.omega[:-1] < 0.98 * TURN.at(steady.omega, found.phi[:-1])).all()


@pytest.mark.exhaustive
def test_no_step_leaps_over_a_load():
    """Neither one that acts over a part of the turn nor one that acts for a short time."""
    bump = moment(lambda x: np.where(x < 4, -12.0, 0.0))
    short = Acting("short", law=laws.ByTime((9.0, 9.01, 9.02, 9.03), (0.0, 400.0, 400.0, 0.0)), sign=-1.0)
    found = by_time(plant(moment(12.5, "motor"), bump, short), 1.0, Goal(time=12.0))
    assert found.error < 1e-5 and found.works["short"] < -50


# --- the periodic solution


def test_the_steady_motion_returns_to_itself_and_its_work_is_nil():
    machine = plant(MOTOR, WAVY, **UNEVEN)
    steady = periodic(machine, level(machine.net, 0.0))
    begin = float(TURN.at(steady.omega, np.zeros(1))[0])
    turn = by_time(machine, begin, Goal(angle=2 * np.pi))
    assert turn.omega[-1] == pytest.approx(begin, rel=1e-8) and turn.t[-1] == pytest.approx(
        steady.cycle, rel=1e-8
    )
    assert abs(sum(steady.works.values())) < 1e-10 * abs(steady.works["motor"])
    assert steady.residual < 1e-10


def test_a_disturbance_is_multiplied_as_the_multiplier_says():
    machine = plant(MOTOR, WAVY, **UNEVEN)
    steady = periodic(machine, level(machine.net, 0.0))
    begin = float(TURN.at(steady.omega, np.zeros(1))[0])
    ends = [by_time(machine, begin * k, Goal(angle=2 * np.pi)).omega[-1] for k in (1 - 1e-3, 1 + 1e-3)]
    assert (ends[1] ** 2 - ends[0] ** 2) / (4e-3 * begin**2) == pytest.approx(steady.multiplier, rel=1e-5)


def test_a_speed_that_does_not_vary_is_that_of_the_balance():
    machine = plant(MOTOR, moment(-20.0))
    steady = periodic(machine, 110.0)
    assert steady.mean == pytest.approx(120.0, rel=1e-12) and steady.delta < 1e-12


@settings(max_examples=examples(10), deadline=None)
@given(st.floats(5.0, 60.0), st.floats(0.0, 25.0))
def test_without_a_dependence_on_speed_the_mean_speed_is_the_stated_one(mean, wave):
    machine = plant(moment(30.0, "motor"), moment(lambda x: -30 - wave * np.cos(x)), **UNEVEN)
    try:
        steady = at_mean_speed(machine, mean)
    except NotSteady:
        assert 2 * wave > 0.2 * mean**2
        return
    assert steady.mean == pytest.approx(mean, rel=1e-9)
    energy = steady.plant.inertia * steady.omega**2 / 2
    assert energy + wave * np.sin(TURN.x) == pytest.approx(
        energy.flat[0] + wave * np.sin(TURN.x.flat[0]), rel=1e-9
    )


def test_a_load_that_stops_the_machine_has_no_steady_motion():
    weak = Acting("motor", law=ch.Linear(50.0, 3.0))
    machine = plant(
        weak, moment(lambda x: -20 - 900 * np.maximum(0, np.cos(x)) ** 8), J=lambda x: 0.2 + 0 * x
    )
    with pytest.raises(NotSteady):
        periodic(machine, 1.0)


# --- what is never reached


def test_a_speed_beyond_the_balance_is_never_reached():
    with pytest.raises(NeverReached) as never:
        run(plant(MOTOR, moment(-20.0)), 0.0, Goal(speed=140.0))
    assert never.value.why == "level" and never.value.omega == pytest.approx(120.0, abs=1.5)


def test_a_machine_that_stops_on_the_way_says_where():
    hanging = plant(moment(lambda x: -9.0 * np.sin(x)), J=lambda x: 1 + 0 * x)
    speed = np.sqrt(18 * (1 - np.cos(1.0)))
    for way in (run, by_time):
        with pytest.raises(NeverReached) as never:
            way(hanging, speed, Goal(angle=3.0))
        assert never.value.why == "stall" and never.value.phi == pytest.approx(1.0, rel=1e-6)


def test_a_viscous_resistance_alone_never_stops_a_machine():
    with pytest.raises(NeverReached) as never:
        run(plant(Acting("viscous", law=ch.Power(0.15, 1.0), sign=-1.0)), 10.0, Goal(speed=0.0))
    assert never.value.why == "level" and never.value.omega == 0.0


# --- tools


@settings(max_examples=examples(30), deadline=None)
@given(st.floats(-9.0, 9.0), st.floats(0.0, 20.0))
def test_work_between_any_two_angles(start, long):
    wave = 3 + 2 * np.cos(TURN.x) + np.sin(3 * TURN.x)
    end = start + long
    exact = 3 * long + 2 * (np.sin(end) - np.sin(start)) - (np.cos(3 * end) - np.cos(3 * start)) / 3
    assert between(TURN, wave, start, end) == pytest.approx(exact, abs=1e-10)


def test_plain_numbers_at_one_angle_are_those_of_the_panels():
    kinked = panels(4.0, [1.0, 2.5])
    values = np.where(kinked.x < 1, kinked.x**2, np.where(kinked.x < 2.5, np.sin(kinked.x), -kinked.x))
    at = pointwise(kinked, (values, np.ones(kinked.shape)))
    for x in (0.3, 0.999, 1.001, 2.4, 3.9, 4.3, -0.1):
        assert at(x) == pytest.approx((float(kinked.at(values, np.array([x]))[0]), 1.0), abs=1e-11)


def test_the_first_speed_of_balance_is_found_however_far():
    assert level(lambda w: 5000.0 - w, 0.0) == pytest.approx(5000.0)
    assert level(lambda w: -1.0 - w, 3.0) == 3.0 and level(lambda w: 1.0 + 0 * w, 0.0) is None
