"""Flywheel: closed answers, every method against the exact one, the motion by independent ways, energies."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from conftest import examples, read, solved
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tmm_report import course, loading
from tmm_report.chapters.lever.moving import Moving
from tmm_report.chapters.machine.flywheel.loads import sides
from tmm_report.mechanics.calculus import ode
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.machine.flywheel import inertia as fly
from tmm_report.mechanics.machine.flywheel.motion import integrated, turning

TURN = 2 * math.pi


def machine(moment, inertia, own: float = 0.0, turns: int = 1) -> fly.Cycle:
    """A cycle by functions of the angle; the moment loses its mean."""
    over = panels(TURN * turns)
    values = moment(over.x)
    return fly.Cycle(over, values - over.mean(values), inertia(over.x) + 0 * over.x, own)


def alone(**keys: object):
    text = "flywheel:\n" + "".join(f"  {key}: {value}\n" for key, value in keys.items())
    return course.solve(loading.loads(text)).flywheel


# --- closed answers


@pytest.mark.parametrize("method", fly.METHODS)
def test_constant_inertia_under_a_sine_is_known_in_closed_form(method):
    """M = m sin 2φ gives and takes m in a quarter of a turn."""
    found = method(machine(lambda x: 30 * np.sin(2 * x), lambda x: 0 * x), 0.05, 20.0)
    assert found.inertia == pytest.approx(30 / (0.05 * 400), rel=1e-13)


def test_links_alone_exchange_energy_in_closed_form():
    """Without moments (J_I + J_II) ω² does not change: J_II = 2 + cos 2φ between 1 and 3."""
    cycle = machine(lambda x: 0 * x, lambda x: 2 + np.cos(2 * x))
    found = turning(cycle, 10.0, 7.0)
    ratio = math.sqrt(13 / 11)
    assert found is not None
    assert found.delta == pytest.approx(2 * (ratio - 1) / (ratio + 1), rel=1e-13)
    assert fly.exact(cycle, found.delta, 7.0).inertia == pytest.approx(10.0, rel=1e-12)


def test_a_machine_without_anything_to_even_out_turns_evenly():
    found = turning(machine(lambda x: 0 * x, lambda x: 0 * x + 2.0), 1.0, 5.0)
    assert found is not None and found.delta == 0 and np.ptp(found.omega) == 0


# --- every method and the exact one


waves = st.lists(st.tuples(st.integers(1, 4), st.floats(-50, 50), st.floats(-50, 50)), min_size=1, max_size=3)


def drawn(moments: list, ripples: list, own: float) -> fly.Cycle:
    def of(rows, x):
        return sum(a * np.cos(n * x) + b * np.sin(n * x) for n, a, b in rows)

    size = sum(abs(a) + abs(b) for _, a, b in ripples) or 1.0
    return machine(lambda x: of(moments, x), lambda x: 0.6 + 0.5 * of(ripples, x) / size, own)


@given(waves, waves, st.floats(0.0, 2.0), st.floats(1e-3, 0.3), st.floats(2.0, 40.0))
@settings(max_examples=examples(40), deadline=None)
def test_the_exact_flywheel_leaves_the_wanted_unevenness(moments, ripples, own, delta, mean):
    cycle = drawn(moments, ripples, own)
    needed = fly.exact(cycle, delta, mean).inertia
    left = needed + cycle.varying.min()
    assume(abs(left) > 1e-3)  # else nothing swings
    found = turning(cycle, needed, mean)
    if left <= 0:
        assert found is None
        return
    assert found is not None
    assert found.delta == pytest.approx(delta, rel=1e-9)
    assert (found.greatest + found.least) / 2 == pytest.approx(mean)
    assert found.least * (1 - 1e-9) <= found.omega.min() and found.omega.max() <= found.greatest * (1 + 1e-9)


@given(waves, waves, st.floats(1e-3, 0.2), st.floats(2.0, 40.0))
@settings(max_examples=examples(40), deadline=None)
def test_a_method_differs_from_the_exact_one_by_what_it_leaves_out_and_no_more(moments, ripples, delta, mean):
    cycle = drawn(moments, ripples, 0.0)
    by = {found.key: found.inertia for found in (method(cycle, delta, mean) for method in fly.METHODS)}
    (low, _), (high, _) = cycle.panels.extremes(cycle.varying)
    rounding = 1e-9 * (1 + abs(by["exact"]))
    # T_II at the mean speed: the change of the energy of the second group is left out
    assert low - rounding <= by["mertsalov"] - by["exact"] <= high + rounding
    # δ²/4 of both slopes
    assert abs(by["wittenbauer"] - by["exact"]) <= delta / 8 * (high - low) + rounding
    # two positions that are not quite those of the tangents
    assert by["rerikh"] <= by["wittenbauer"] + rounding
    # all of the varying energy
    assert abs(by["constant"] - by["exact"]) <= (high - low) * (1 / (2 * delta) + 1) + rounding


def test_no_point_of_the_energy_mass_curve_is_beyond_its_tangents():
    cycle = solved("compressor").flywheel.cycle
    for method in (fly.exact, fly.wittenbauer, fly.mertsalov):
        found = method(cycle, 0.0125, 125.66)
        above = cycle.work - found.upper.slope * cycle.varying - found.upper.cut
        below = cycle.work - found.lower.slope * cycle.varying - found.lower.cut
        assert above.max() <= 1e-10 and below.min() >= -1e-10
        assert above.max() > -0.2 and below.min() < 0.2  # they touch


# --- the motion


@pytest.mark.parametrize("name", ["compressor", "punch_press"])
def test_the_integrated_motion_has_the_wanted_unevenness_and_closes(name):
    found = solved(name).flywheel
    assert found.proof.delta == pytest.approx(found.given.delta, rel=1e-6)
    assert found.proof.closure < 1e-9


def test_halved_steps_leave_a_sixteenth_of_the_error():
    found = solved("compressor").flywheel
    start = found.proof.omega[0]
    once, twice = (integrated(found.cycle, found.cycle.own, start, steps).closure for steps in (1, 2))
    assert 10 < once / twice < 24


def test_an_integrator_that_chooses_its_steps_finds_the_same_motion():
    found = solved("compressor").flywheel
    cycle, over = found.cycle, found.cycle.panels

    def rate(x, y):
        at = np.array([x])
        moment, slope, varying = (over.at(of, at)[0] for of in (cycle.moment, cycle.slope, cycle.varying))
        return [(moment - y[0] ** 2 * slope / 2) / (y[0] * (found.after.fixed + varying))]

    run = ode.integrate(rate, [found.proof.omega[0]], (0.0, TURN), longest=TURN / 24)
    omega = run.at(np.linspace(0, TURN, 20001))[0]
    delta = 2 * (omega.max() - omega.min()) / (omega.max() + omega.min())
    assert delta == pytest.approx(found.given.delta, rel=1e-6)
    assert omega[-1] == pytest.approx(omega[0], rel=1e-8)


def test_energy_is_what_it_was_and_the_work_done_since():
    for name in ("compressor", "punch_press"):
        found = solved(name).flywheel
        energy = found.after.inertia * found.after.omega**2 / 2 - found.cycle.work
        assert np.ptp(energy) <= 1e-12 * energy.max()


def test_angular_acceleration_is_the_change_of_the_angular_velocity():
    after = solved("compressor").flywheel.after
    slope = after.cycle.panels.slope(after.omega)
    np.testing.assert_allclose(after.omega * slope, after.epsilon, atol=1e-6 * np.abs(after.epsilon).max())


FINE = 2880  # positions of an independent grid


def by_simpson(name: str) -> tuple[np.ndarray, np.ndarray]:
    """A and J_II at every other of equal steps, from the reduction chapter's own numbers, by Simpson's rule."""
    variant = read(name)
    positions = dataclasses.replace(variant.lever.positions, diagram=FINE)
    lever = dataclasses.replace(variant.lever, reduction=True, positions=positions, readings={})
    found = course.solve(course.Variant(lever=lever)).lever
    reduced, sense = found.reduction.diagram, np.sign(found.kinematics.omega)
    rubbing = found.friction.diagram.reduced[:FINE]
    moment, weights = sense * reduced.whole_moment[:FINE] - rubbing, np.array([1, 4, 1]) / 3 * TURN / FINE
    rows = np.stack([moment[0::2], moment[1::2], np.roll(moment, -2)[0::2]], axis=-1)
    pieces = rows @ weights
    work = np.concatenate([[0.0], np.cumsum(pieces - pieces.mean())[:-1]])
    return work, reduced.whole_inertia[0:FINE:2]


def peak(values: np.ndarray) -> float:
    """The greatest value of a closed curve, by the parabola through the greatest three."""
    k = int(values.argmax())
    a, b, c = (values[(k + step) % len(values)] for step in (-1, 0, 1))
    return float(b - (c - a) ** 2 / (8 * (a - 2 * b + c)))


def test_the_compressor_on_an_independent_fine_grid_has_the_wanted_unevenness():
    """Work and inertia of another chapter, by another rule; the energy is found by halving for the mean speed."""
    work, varying = by_simpson("compressor")
    found = solved("compressor").flywheel
    inertia = varying + found.cycle.own + found.s.number("J_fl")

    def ends(start: float) -> tuple[float, float]:
        omega = np.sqrt(2 * (start + work) / inertia)
        return -peak(-omega), peak(omega)

    low, high = 0.5 * found.after.start, 2 * found.after.start
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if sum(ends(middle)) < 2 * found.omega else (low, middle)
    least, greatest = ends(low)
    assert 2 * (greatest - least) / (greatest + least) == pytest.approx(found.given.delta, rel=1e-6)


# --- the sides


def test_a_compressor_is_driven_and_an_engine_drives():
    compressor = solved("compressor").flywheel
    assert compressor.sides.balancing == "driving" and np.ptp(compressor.sides.driving) == 0
    lever = solved("v_engine").lever
    engine = sides(compressor.given, Moving(lever.kinematics, lever.kinetostatics), 100.0)
    assert engine.balancing == "resisting" and engine.resisting.max() < 0
    assert engine.cycle.panels.total(engine.cycle.moment) == pytest.approx(0.0, abs=1e-9 * 8300)


def test_without_a_flywheel_a_press_does_not_pass_its_stroke_and_a_compressor_does():
    assert solved("punch_press").flywheel.before is None
    before = solved("compressor").flywheel.before
    assert before is not None and 0.0125 < before.delta < 2


def test_a_punch_is_a_rectangle_of_resistance():
    stated = {"speed": "3 rad/s", "delta": 0.1}
    punch = alone(punch="{work: 600, period: 4.1887902047863905, time: 1.0471975511965976}", **stated)
    table = alone(resisting="{table: [[0, 190.9859317102744], [180 deg, 190.9859317102744], [180 deg, 0], "
                  "[720 deg, 0]]}", turns=2, **stated)  # fmt: skip
    assert punch.s.number("J_fl") == pytest.approx(table.s.number("J_fl"), rel=1e-12)
    assert punch.s.number("A_ex") == pytest.approx(600 * 0.75) and punch.s.number("P_m") == pytest.approx(
        600 / 4.18879020
    )


def test_a_table_is_linear_between_its_points_and_jumps_where_two_stand_together():
    """And from the last point to the first of the next turn, which are no farther apart than others are."""
    found = alone(
        resisting="{table: [[45 deg, 10], [180 deg, 40], [180 deg, 0], [270 deg, 0]]}", speed=10, delta=0.1
    )
    law = found.given.resisting.law
    at = law.repeating(TURN).value(np.radians([63, 112.5, 179.99, 180.01, 225, 303.75, 0]))
    np.testing.assert_allclose(at, [14, 25, 40, 0, 0, 2.5, 20 / 3], atol=0.01)


def test_inertia_stated_of_a_turn_is_that_of_every_turn():
    table = "[0, 1], [120 deg, 3], [200 deg, 2], [360 deg, 1]"
    again = ", ".join(f"[{x} deg, {y}]" for x, y in ((480, 3), (560, 2), (720, 1)))
    stated = {
        "driving": "{mean: 90, harmonics: [{order: 0.5, sin: 300}]}",
        "turns": 2,
        "speed": 20,
        "delta": 0.05,
    }
    one = alone(inertia=f"{{table: [{table}]}}", **stated)
    both = alone(inertia=f"{{table: [{table}, {again}]}}", **stated)
    assert one.s.number("J_fl") == pytest.approx(both.s.number("J_fl"), rel=1e-12)


# --- what is asked for


def test_the_flywheel_found_for_an_unevenness_leaves_it_when_it_is_stated():
    load = {"resisting": "{table: [[0, 0], [90 deg, 800], [180 deg, 0], [360 deg, 0]]}", "speed": 12}
    load["inertia"] = "{mean: 2, harmonics: [{order: 2, cos: -0.8}]}"
    wanted = alone(delta="1/25", **load)
    stated = alone(wheel=f"{{inertia: {wanted.s.number('J_fl')!r}}}", **load)
    assert stated.s.number("delta") == pytest.approx(1 / 25, rel=1e-12)
    assert not stated.methods


def test_what_turns_with_the_machine_already_is_taken_from_the_flywheel():
    load = {
        "resisting": "{table: [[0, 0], [90 deg, 800], [180 deg, 0], [360 deg, 0]]}",
        "speed": 12,
        "delta": 0.05,
    }
    bare = alone(**load)
    own = alone(own=5, motor="{power: 9 kW, speed: 36, inertia: 0.5}", **load)
    assert bare.s.number("J_fl") - own.s.number("J_fl") == pytest.approx(5 + 0.5 * 9)
    assert own.methods["exact"].inertia == pytest.approx(bare.methods["exact"].inertia)


def test_a_machine_heavy_enough_needs_no_flywheel_and_is_told_so():
    found = alone(
        resisting="{table: [[0, 0], [90 deg, 8], [180 deg, 0], [360 deg, 0]]}", speed=12, delta=0.05, own=50
    )
    assert found.needless and "J_shaft" not in found.s and found.s.number("J_fl") == 0
    assert found.after.delta < 0.05


def test_rotor_and_wheel_on_the_motor_shaft_have_the_energy_that_they_would_have_on_the_main_one():
    load = {
        "resisting": "{table: [[0, 0], [90 deg, 800], [180 deg, 0], [360 deg, 0]]}",
        "speed": 12,
        "delta": 0.05,
    }
    main = alone(**load)
    fast = alone(motor="{power: 9 kW, speed: 60}", shaft="motor", **load)
    assert fast.s.number("i") == pytest.approx(5)
    assert fast.s.number("J_shaft") * 60**2 == pytest.approx(main.s.number("J_shaft") * 12**2)
