"""The chapter of the machine in motion: of the solved mechanism, of shafts alone, and what it refuses and why."""

from __future__ import annotations

import math

import numpy as np
import pytest
from conftest import solved

from tmm_report import course, loading
from tmm_report.chapters.lever.moving import Moving, machine
from tmm_report.chapters.machine.dynamics import quantities
from tmm_report.mechanics.machine.run.by_time import by_time
from tmm_report.mechanics.machine.run.motion_law import Goal
from tmm_report.problems import ProblemError
from tmm_report.quantity.model import Book

PUMP = "piston_pump"


@pytest.fixture(scope="module")
def pump():
    return solved(PUMP)


def alone(text):
    return course.solve(loading.loads("dynamics:\n" + text)).dynamics


def refused(text):
    with pytest.raises(ProblemError) as error:
        alone(text)
    return [problem.text() for problem in error.value.problems]


def book(found):
    return Book.of(quantities.tables(found), quantities.values(found))


# --- of the mechanism


def test_the_moment_of_inertia_is_that_of_the_mechanism_with_the_parts(pump):
    found, table = pump.dynamics, book(pump.dynamics).tables["dynamics_cycle_table"]
    rotor = 0.015 * 16**2 + 14
    assert table["J"].numbers() == pytest.approx(pump.lever.reduction.table.whole_inertia + rotor, rel=1e-9)
    assert table["J_slope"].numbers() == pytest.approx(pump.lever.reduction.table.slope, abs=1e-8)
    assert table["M_red"].numbers() == pytest.approx(pump.lever.reduction.table.whole_moment, abs=1e-6 * 700)
    assert (
        found.conservative < 1e-8
    )  # a derivative, on panels as narrow as 0.01° between kinks of the friction


def test_the_steady_motion_keeps_its_energy_from_position_to_position(pump):
    values = book(pump.dynamics)
    table = values.tables["dynamics_cycle_diagram"]
    energy = table["J"].numbers() * table["omega"].numbers() ** 2 / 2
    assert energy == pytest.approx(values["dynamics_T_0"].value + table["A"].numbers(), rel=1e-9)
    assert energy[0] == pytest.approx(energy[-1], rel=1e-11)
    slope = np.gradient(table["omega"].numbers(), table["t"].numbers(), edge_order=2)
    assert np.corrcoef(slope, table["epsilon"].numbers())[0, 1] > 0.97


def test_lagrange_s_force_is_what_has_no_potential(pump):
    table = book(pump.dynamics).tables["dynamics_cycle_table"]
    total = table["Q"].numbers() - table["V_slope"].numbers()
    assert total == pytest.approx(table["M"].numbers(), abs=1e-9)
    height = book(pump.dynamics).tables["dynamics_cycle_diagram"]
    rise = np.gradient(height["V"].numbers(), np.radians(height["phi"].numbers()))
    assert rise[1:-1] == pytest.approx(height["V_slope"].numbers()[1:-1], abs=0.05)


def test_the_steady_motion_by_waiting_is_that_which_was_found(pump):
    found = pump.dynamics
    waited = by_time(found.supplied, 0.0, Goal(angle=3 * 2 * math.pi + 0.7))
    assert waited.omega[-1] == pytest.approx(float(found.omega(np.array([0.7]))[0]), rel=1e-6)


def test_works_of_each_regime_are_the_change_of_the_energy(pump):
    table = book(pump.dynamics).tables["dynamics_works"]
    for key in ("A_start", "A_steady", "A_coast"):
        numbers = table[key].numbers()
        assert np.nansum(numbers[:-2]) == pytest.approx(numbers[-2], abs=1e-9)
        assert numbers[-2] == pytest.approx(numbers[-1], abs=1e-5)
    loads = machine(Moving(pump.lever.kinematics, pump.lever.kinetostatics))
    done = sum(float(loads.panels.total(values)) for _, values in loads.moments)
    steady = dict(zip(table["acting"].values, table["A_steady"].numbers(), strict=True))
    rubbed = -pump.lever.friction.mean_power * 2 * math.pi / abs(pump.lever.kinematics.omega)
    assert steady["pairs"] == pytest.approx(rubbed)
    assert steady["motor"] + steady["res1"] + rubbed == pytest.approx(-done)


def test_without_a_motor_a_constant_moment_closes_the_cycle_at_the_speed_of_the_mechanism(pump):
    text = (
        (course_text(PUMP).split("\ndynamics:")[0]) + "\ndynamics: {parts: [{name: flywheel, inertia: 20}]}\n"
    )
    found = course.solve(loading.loads(text)).dynamics
    assert found.steady.mean == pytest.approx(90 * math.pi / 30, rel=1e-9)
    closing = book(found)["dynamics_M_closing"].value
    table = pump.lever.reduction.diagram
    rubbed = pump.lever.friction.mean_power / found.steady.mean
    assert closing == pytest.approx(rubbed - np.mean(table.whole_moment[:-1]), rel=0.02)
    assert abs(sum(found.steady.works.values())) < 1e-9 * found.steady.works["motor"]


def course_text(name):
    from notes import VARIANTS

    return (VARIANTS / f"{name}.yaml").read_text("utf-8")


def test_a_spring_at_a_point_gives_back_what_it_took(pump):
    text = course_text(PUMP).replace(
        "  start: {within: 2 %}",
        "  springs: [{at: D, to: [600 mm, -190 mm], stiffness: 3 kN/m, length: 100 mm}]\n  start: {within: 2 %}",
    )
    found = course.solve(loading.loads(text)).dynamics
    assert abs(found.steady.works["spring1"]) < 1e-9 * found.steady.works["motor"]
    assert found.conservative < 1e-8
    place = solved(PUMP).lever.kinematics.table.place("D")
    stretch = np.abs(place - complex(0.6, -0.19)) - 0.1
    ours = book(found).tables["dynamics_cycle_table"]["V"].numbers()
    theirs = book(pump.dynamics).tables["dynamics_cycle_table"]["V"].numbers()
    assert ours - theirs == pytest.approx(1500 * stretch**2, rel=1e-9)


# --- shafts alone


def test_a_pendulum_on_a_shaft_swings_by_its_energy():
    found = alone("""
  parts: [{name: bob, mass: 2, offset: 0.5, angle: -90 deg}]
  coast: {begin: 3, motor: off}
""")
    highest = 1 - 3**2 * 0.5 / (2 * 9.81)
    assert found.coast.phi[-1] == pytest.approx(math.acos(highest), rel=1e-9) and found.coast.error < 1e-9
    assert found.conservative < 1e-9


def test_a_spring_and_a_pin_on_the_shaft_have_a_potential():
    found = alone("""
  parts: [{name: disc, inertia: 0.2}]
  springs: [{radius: 0.1, apart: 0.4, stiffness: 400, length: 0.25}]
  start: {begin: 20, angle: 360 deg}
""")
    assert found.start.omega[-1] == pytest.approx(20.0, rel=1e-11) and np.ptp(found.start.omega) > 0.2
    assert found.conservative < 1e-8


def test_inertia_stated_by_angle_keeps_the_energy():
    found = alone("""
  varying_inertia: [[0, 2], [90 deg, 3], [180 deg, 2], [270 deg, 3]]
  parts: [{name: rotor, inertia: 1}]
  motor: {constant: 10}
  resistance: [{by_angle: [[0, 0], [180 deg, 20], [360 deg, 0]]}]
  speed: 30
  steady: true
""")
    steady = found.steady
    assert steady.mean == pytest.approx(30.0) and steady.residual < 1e-9
    assert np.ptp(steady.plant.inertia) == pytest.approx(1.0, abs=0.02)


def test_a_load_stated_by_time_is_run_through_by_steps():
    found = alone("""
  parts: [{name: rotor, inertia: 2}]
  motor: {shunt: {moment: 60, speed: 145, no_load: 150}}
  resistance: [{by_time: [[0, 0], [1, 50], [2, 0]]}]
  start: {begin: 150, time: 3}
""")
    assert found.start.way == "time" and found.steady is None and found.start.omega.min() < 147
    # J dω/dt = k (150 − ω) − M(t) by the integral of its solution
    k, t = 60 / 5, np.linspace(0, 3, 300001)
    load = np.interp(t, [0, 1, 2], [0, 50, 0])
    lost = np.sum((load * np.exp(-k / 2 * (3 - t)))[:-1] + (load * np.exp(-k / 2 * (3 - t)))[1:]) * 0.5e-5 / 2
    assert 150 - found.start.omega[-1] == pytest.approx(lost, abs=1e-7)


def test_a_reversed_motor_stops_the_machine_sooner_than_a_motor_that_is_off():
    text = """
  parts: [{{name: rotor, inertia: 2, moment: 20}}]
  motor: {{induction: {{synchronous: 100, max_moment: 100, critical_slip: 0.2}}}}
  coast: {{motor: {supply}}}
"""
    times = {supply: alone(text.format(supply=supply)).coast.t[-1] for supply in ("off", "reversed")}
    begin = alone(text.format(supply="off")).steady.mean
    assert times["off"] == pytest.approx(2 * begin / 20) and times["reversed"] < 0.7 * times["off"]


def test_without_the_load_the_run_down_is_that_of_friction_alone():
    text = """
  parts: [{name: rotor, inertia: 2, moment: 20}]
  motor: {shunt: {moment: 60, speed: 95, no_load: 100}}
  resistance: [{friction: 5}]
  coast: {load: false, brake: 3}
"""
    found = alone(text)
    assert found.coast.t[-1] == pytest.approx(2 * found.steady.mean / 8)


def test_a_series_motor_settles_where_its_curve_meets_the_fan():
    found = alone("""
  parts: [{name: rotor, inertia: 5}]
  motor: {series: {moment: 400, speed: 60, stall: 1600}, ratio: 3, efficiency: 0.95}
  resistance: [{fan: {moment: 300, speed: 20}}]
  start: {}
""")
    omega = found.steady.mean
    a, b = 1600 * 60**2, 60.0
    assert 3 * 0.95 * a / (3 * omega + b) ** 2 == pytest.approx(300 * (omega / 20) ** 2)
    assert found.start.omega[-1] == pytest.approx(0.98 * omega)


@pytest.mark.parametrize(
    "motor", ["constant: 10", "by_angle: [[0, 10], [3, 10]]", "by_time: [[0, 10], [9, 10]]"]
)
def test_the_gear_of_a_motor_of_any_kind_is_reckoned_with(motor):
    found = alone(f"""
  parts: [{{name: rotor, inertia: 2}}]
  motor: {{{motor}, ratio: 3, efficiency: 0.8}}
  resistance: [{{friction: 4}}]
  start: {{time: 5}}
""")
    assert found.start.omega[-1] == pytest.approx((10 * 3 * 0.8 - 4) / 2 * 5, rel=1e-8)


# --- what is refused, and why


def test_a_motor_too_weak_to_start_is_told_with_both_moments():
    (said,) = refused("""
  parts: [{name: load, inertia: 2, moment: 70}]
  motor: {induction: {synchronous: 100, max_moment: 100, critical_slip: 0.2}}
  start: {}
""")
    weak = 2 * 100 / (0.2 + 1 / 0.2)
    assert f"{weak:.2f}" in said and "70" in said and "does not start" in said


CLOSED = """
  parts: [{name: flywheel, inertia: 2}]
  motor: {constant: MOMENT}
  resistance: [{by_angle: [[0, 0], [180 deg, 20], [360 deg, 0]]}]
  speed: 30
  steady: true
"""


def test_a_cycle_whose_work_does_not_close_is_told_with_what_is_left():
    (said,) = refused(CLOSED.replace("MOMENT", "12"))
    assert "grows from cycle to cycle" in said and f"{2 * 2 * math.pi:.2f}" in said
    (said,) = refused(CLOSED.replace("MOMENT", "9"))
    assert "falls from cycle to cycle" in said and f"{2 * math.pi:.3f}" in said
    assert alone(CLOSED.replace("MOMENT", "10")).steady.delta > 0


def test_a_stall_on_the_way_is_told_with_the_angle():
    (said,) = refused("""
  parts: [{name: bob, mass: 2, offset: 0.5, angle: -90 deg}]
  motor: {constant: 4}
  start: {angle: 300 deg}
""")
    assert "stops on the way" in said


def test_a_speed_beyond_the_balance_is_told():
    (said,) = refused("""
  parts: [{name: rotor, inertia: 2, moment: 20}]
  motor: {shunt: {moment: 60, speed: 95, no_load: 100}}
  start: {speed: 99}
""")
    assert "never reached" in said and "98.3" in said


ROTOR = "  parts: [{name: a, inertia: 1}]\n  "


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (ROTOR + "motor: {constant: 5}\n  start: {}", "where the start-up ends"),
        (ROTOR + "motor: {constant: 5}\n  coast: {}", "runs down is not known"),
        (ROTOR + "resistance: [{viscous: 1}]\n  coast: {begin: 9}\n  steady: false", "never reached"),
        (ROTOR + "motor: {by_speed: [[0, 5], [9, 5]]}", "grows without end"),
        ("  parts: [{name: a, inertia: 1, moment: 9}]\n  motor: {by_speed: [[0, 5], [9, 5]]}", "at every speed"),
    ],
)  # fmt: skip
def test_motions_that_do_not_exist_are_explained(text, words):
    assert words in refused(text)[0]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("  motor: {constant: 5}", "moment of inertia or a mass"),
        ("  varying_inertia: [[0, 2], [90 deg, 3]]", "nothing acts"),
        ("  parts: [{name: a, mass: 5}]\n  motor: {constant: 5}", "how the mass moves"),
        ("  parts: [{name: a, mass: 5, velocity: 1}]\n  motor: {constant: 5}", "unknown speed"),
        ("  parts: [{name: a, mass: 5, offset: 1, ratio: 2}]\n  motor: {constant: 5}", "offset mass"),
        ("  parts: [{name: a, inertia: 5, ratio: 0}]\n  motor: {constant: 5}", "stands still"),
        (ROTOR + "motor: {constant: 5, by_speed: [[0, 1], [2, 3]]}", "one characteristic"),
        (ROTOR + "motor: {shunt: {moment: 5, speed: 9}}", "do not state"),
        (ROTOR + "motor: {shunt: {moment: 5, speed: 9, no_load: 8}}", "nominal speed"),
        (ROTOR + "motor: {series: {moment: 5, speed: 9, stall: 4}}", "at rest"),
        (ROTOR + "motor: {induction: {moment: 5, speed: 9, synchronous: 10, overload: 1}}", "greatest"),
        (ROTOR + "motor: {by_speed: [[5, 1], [2, 3]]}", "ascend"),
        (ROTOR + "resistance: [{friction: 1, viscous: 2}]", "one law"),
        (ROTOR + "motor: {constant: 5}\n  start: {speed: 5, time: 3}", "stated twice"),
        (ROTOR + "motor: {constant: 5}\n  coast: {begin: 5, speed: 6}", "not lower"),
        ("  parts: [{name: a, inertia: 1, moment: 4}]\n  coast: {begin: 5, motor: reversed}", "no motor to reverse"),
        (ROTOR + "springs: [{stiffness: 5, length: 1, at: A, to: [0, 0]}]", "spring is fixed"),
        ("  parts: [{name: a, inertia: -1}]\n  motor: {constant: 5}", "negative"),
    ],
)  # fmt: skip
def test_what_is_stated_wrong_is_told_with_what_would_be_right(text, words):
    said = refused(text)
    assert any(words in one for one in said), said


def test_a_rounding_of_the_kinetic_energy_is_no_lack_where_nothing_works():
    found = alone("  start: {begin: 4.7 rad/s, time: 1.5 s}\n  parts: [{name: wheel, inertia: 3}]\n")
    assert found.s.number("omega_start") == pytest.approx(4.7, rel=1e-14)
    assert found.s.number("balance_error") < 1e-8
