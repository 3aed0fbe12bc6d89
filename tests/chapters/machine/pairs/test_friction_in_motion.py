"""Friction of the pairs in the machine in motion: works and powers by two ways, what it changes, who leaves it out."""

import math
import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from conftest import solved
from notes import VARIANTS, render

from tmm_report import course, loading
from tmm_report.chapters.lever.friction import solve as friction
from tmm_report.chapters.lever.kinetostatics.solve.positions import at, stated
from tmm_report.chapters.machine.dynamics import quantities as motion_quantities
from tmm_report.chapters.machine.flywheel import quantities as wheel_quantities
from tmm_report.problems import ProblemError

CASE = Path(__file__).parents[3] / "cases/machine/friction_left_out_of_power.yaml"
FRICTION = "friction: {pivots: {coefficient: 0.1, diameter: 60 mm}, guides: {coefficient: 0.15}}"
PUMP = (VARIANTS / "piston_pump.yaml").read_text("utf-8")
ENGINE = (VARIANTS / "engine_four_stroke.yaml").read_text("utf-8")


@cache
def press(power: str = "500 W", friction: str = FRICTION, more: str = "", rest: str = ""):
    text = CASE.read_text("utf-8").replace("400 W", power).replace(FRICTION, friction)
    return course.solve(
        loading.loads(text.replace("delta: 1/30,", f"delta: 1/30, {more}{', ' * bool(more)}") + rest)
    )


def mean_lost(results, count=100_000) -> float:
    """Friction power at equal steps, by no panels, W."""
    lever = results.lever
    turned = (np.arange(count) + 0.5) * (lever.kinematics.cycle.period / count)
    moved = lever.kinematics.cycle.motion(turned)
    given = lever.kinetostatics.given
    found = at(given, moved, turned, stated(given, lever.kinematics, moved, turned))
    return float(friction._losses(lever.given.friction, moved, found.statics).total.mean())


def told(results) -> str:
    text = render(results, "html")["note.html"].decode()
    return re.sub(r"\s+", " ", re.sub(r"<[^>]*>", "", text))


# ---------------------------------------------------------------- the flywheel and its motor


@pytest.mark.exhaustive
def test_the_work_of_friction_is_that_of_its_power_over_the_cycle():
    found = press()
    wheel, lost = found.flywheel, mean_lost(found)
    time = wheel.cycle.panels.period / wheel.omega
    assert wheel.cycle.panels.total(wheel.sides.rubbing) == pytest.approx(-lost * time, rel=1e-6)
    table = wheel_quantities.book(wheel).tables["flywheel_table"]
    np.testing.assert_allclose(table["M_fr"].numbers(), found.lever.friction.table.reduced, rtol=1e-6)


@pytest.mark.exhaustive
def test_the_power_balance_closes_with_friction_in_it():
    """What the motor gives is what the loads take and what the pairs lose; without friction it is 375 W."""
    without, found = press(more="friction: false").flywheel, press()
    assert without.s.number("P_m") == pytest.approx(375, rel=1e-9)
    assert found.flywheel.s.number("P_m") == pytest.approx(375 + mean_lost(found), rel=1e-6)
    eta = found.lever.friction.mean_efficiency
    assert found.flywheel.s.number("P_m") == pytest.approx(
        375 / eta, rel=0.01
    )  # which counts what the cycle gives back, too
    assert found.flywheel.s.number("J_fl") > 1.1 * without.s.number("J_fl")


def test_a_motor_is_judged_with_the_friction():
    assert press("439 W").flywheel.s.number("P_need") == pytest.approx(438.5, abs=0.1)
    with pytest.raises(ProblemError, match=r"0\.4385 kW on average, 0\.06349 kW of it for the friction"):
        press("400 W")
    assert press("400 W", more="friction: false").flywheel.s.number("P_need") == pytest.approx(375)


def test_a_mechanism_that_drives_gives_less_to_the_machine():
    """An engine: the friction is a part of what resists, and the constant moment is the less for it."""
    of = {}
    for kept in (True, False):
        text = ENGINE if kept else ENGINE.replace("  delta: 1/80", "  friction: false\n  delta: 1/80")
        of[kept] = course.solve(loading.loads(text))
    (rubbed, free) = (of[key].flywheel for key in (True, False))
    assert rubbed.sides.balancing == free.sides.balancing == "resisting"
    assert rubbed.s.number("P_m") == pytest.approx(free.s.number("P_m"))  # of the gases
    constant = rubbed.sides.resisting - rubbed.sides.rubbing
    assert np.ptp(constant) < 1e-9 * np.abs(constant).max()
    lost = of[True].lever.friction.mean_power
    assert -constant.mean() * rubbed.omega == pytest.approx(free.s.number("P_m") - lost, rel=1e-6)
    assert rubbed.sides.machine.friction_share == pytest.approx(100 * lost / free.s.number("P_m"))


def test_friction_alone_is_a_load():
    """With weights alone nothing takes work but the pairs."""
    text = CASE.read_text("utf-8").split("loads:")[0]
    text += f"loads: {{}}\n{FRICTION}\nflywheel: {{delta: 1/30}}\n"
    found = course.solve(loading.loads(text))
    assert found.flywheel.s.number("P_m") == pytest.approx(found.lever.friction.mean_power)
    assert found.flywheel.sides.machine.friction_share == pytest.approx(100)


@pytest.mark.exhaustive
def test_corrected_reactions_give_the_friction_of_the_motion():
    corrected = FRICTION[:-1] + ", corrected: true}"
    found = press(friction=corrected)
    lever = found.lever.friction
    lost = found.flywheel.s.number("P_m") - 375
    assert lost == pytest.approx(lever.corrected.mean_power)
    assert lost != pytest.approx(lever.mean_power, rel=1e-3)
    assert "by the reactions corrected for friction" in told(found)


# ---------------------------------------------------------------- start-up, steady motion, run-down


def pump(more: str = "", text: str = PUMP):
    return course.solve(loading.loads(text.replace("dynamics:", f"dynamics:{more}", 1)))


def test_friction_slows_the_machine_and_stops_it_sooner():
    rubbed, free = solved("piston_pump").dynamics, pump("\n  friction: false").dynamics
    assert rubbed.start.t[-1] > 1.05 * free.start.t[-1]
    assert rubbed.coast.t[-1] < 0.95 * free.coast.t[-1]
    assert rubbed.steady.mean < free.steady.mean
    assert "pairs" not in free.steady.works and rubbed.steady.works["pairs"] < 0
    for run in (rubbed.start, rubbed.coast):
        assert sum(run.works.values()) == pytest.approx(run.gained, abs=1e-5) and run.error < 1e-6


@pytest.mark.exhaustive
def test_work_of_friction_in_steady_motion_is_by_its_power_at_the_stated_speed():
    results = solved("piston_pump")
    work, omega = results.dynamics.steady.works["pairs"], abs(results.lever.kinematics.omega)
    assert work == pytest.approx(-mean_lost(results) * 2 * math.pi / omega, rel=1e-6)
    values = {of.quantity.key: of.value for of in motion_quantities.values(results.dynamics)}
    assert values["dynamics_P_fr"] == pytest.approx(results.lever.friction.mean_power)


@pytest.mark.exhaustive
def test_friction_alone_stops_a_machine():
    """No resistance, no load: the kinetic energy goes through the pairs, J ω²/2 = ∫ M dφ, by small steps."""
    text = """
dynamics:
  parts: [{name: flywheel, inertia: 14 kg*m^2}]
  steady: false
  coast: {begin: 90 rpm, load: false}
"""
    results = course.solve(loading.loads(PUMP.split("\ndynamics:")[0] + text))
    found, reduced = results.dynamics, results.lever.friction.unloaded
    assert found.coast.works.keys() >= {"pairs"} and found.coast.works["pairs"] < 0
    assert not {key for key in found.coast.works if key.startswith("P_")}
    assert reduced.panels.mean(reduced.moment) < results.lever.friction.reduced.moment.mean() / 2
    plant, step = found.coast.plant, 1e-3
    x = np.arange(0, found.coast.phi[-1], step) + step / 2
    energy = found.whole.panels.at(plant.inertia, np.zeros(1))[0] * (3 * math.pi) ** 2 / 2
    weights = [one for one in plant.acting if one.key.startswith("G_")]
    done = -reduced.panels.at(reduced.moment, x).sum() * step
    done += sum(found.whole.panels.at(one.values, x).sum() for one in weights) * step
    assert done == pytest.approx(-energy, rel=1e-4)


def test_a_machine_that_starts_from_a_place_with_little_load_comes_to_its_steady_motion():
    """On the mean the motor at rest is too weak by some newton metres, but not where the crank stands."""
    found = pump(text=PUMP.replace("friction: 6 N*m", "friction: 25 N*m")).dynamics
    assert found.supplied.net(0.0) < 0 < found.start.t[-1] < 1
    assert found.start.omega[-1] == pytest.approx(
        0.98 * float(found.omega(np.mod(found.start.phi[-1:], 2 * math.pi))[0]), rel=1e-6
    )


# ---------------------------------------------------------------- who leaves it out


@pytest.mark.exhaustive
@pytest.mark.parametrize("block", ["flywheel", "dynamics"])
def test_what_is_left_out_is_told(block):
    rest = "\ndynamics: {parts: [{name: wheel, inertia: 2}]%s}\n"
    if block == "flywheel":
        found = press(more="friction: false"), press()
    else:
        found = tuple(press(rest=rest % of) for of in (", friction: false", ""))
    left, kept = (re.findall(r"The friction of the kinematic pairs is [^;]*", told(one))[0] for one in found)
    assert "left out of the resistances, as the variant states" in left
    assert "among the resistances" in kept and "as at the stated speed" in kept
    share = 100 * 63.4876 / 438.4876
    for one in found:
        at = getattr(one, block)
        book = (wheel_quantities if block == "flywheel" else motion_quantities).book(at)
        assert book[f"{block}_P_fr"].value == pytest.approx(63.4876, rel=1e-6)
        assert book[f"{block}_P_fr_share"].value == pytest.approx(share, rel=1e-6)


@pytest.mark.exhaustive
def test_reactions_without_bound_leave_friction_out_and_are_told():
    """A parallelogram stretches out twice a turn, where its links hold any load across them."""
    text = """
language: en
mechanism:
  frame: {O: [0, 0], C: [300 mm, 0]}
  links:
    1: {points: {O: 0, A: 80 mm}, mass: 1 kg, mass_centre: A}
    2: {points: {A: 0, B: 300 mm}, mass: 2 kg, mass_centre: B}
    3: {points: {C: 0, B: 80 mm}}
  driver: {link: 1, speed: 60 rpm}
  sketch: {A: [0, 80 mm], B: [300 mm, 80 mm]}
loads: {moments: [{on: 3, direction: against motion, constant: 20 N*m}]}
friction: {pivots: {coefficient: 0.1, diameter: 30 mm}}
flywheel: {delta: 1/30}
"""
    found = course.solve(loading.loads(text))
    assert found.lever.friction.reduced is None
    assert "left out: beside some position of the cycle the reactions grow without bound" in told(found)
    (doubt,) = [one for one in course.doubts(found) if "left out" in str(one)]
    assert "flywheel" in str(doubt)
    assert "flywheel_P_fr" not in wheel_quantities.book(found.flywheel).values
    free = course.solve(loading.loads(text.replace("1/30}", "1/30, friction: false}")))
    assert not [one for one in course.doubts(free) if "left out" in str(one)]
    assert free.flywheel.s.number("J_fl") == pytest.approx(found.flywheel.s.number("J_fl"))


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        (
            "flywheel: {speed: 9, delta: 1/30, resisting: {table: [[0, 1], [1, 2]]}, friction: true}",
            "this variant has none",
        ),
        (
            "dynamics: {parts: [{name: a, inertia: 1}], motor: {constant: 1}, friction: false}",
            "this variant has none",
        ),
    ],
)
def test_a_machine_alone_has_no_pairs(text, wrong):
    with pytest.raises(ProblemError, match=wrong):
        loading.loads(text)


@pytest.mark.exhaustive
def test_friction_that_is_not_stated_cannot_be_asked_for():
    with pytest.raises(ProblemError, match="no friction of the pairs is stated"):
        press(friction="", more="friction: true")
    assert press(friction="").flywheel.s.number("P_m") == pytest.approx(375)
    assert "friction of the kinematic pairs" not in told(press(friction=""))
