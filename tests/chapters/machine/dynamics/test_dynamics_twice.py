"""Every formula of the machine in motion against its own arrays over the cycle and over time, and the equations of
motion, printed in symbols, at the motion that is found."""

import math

import numpy as np
import pytest
from conftest import solved
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.machine.dynamics.equations import Written
from tmm_report.chapters.machine.dynamics.quantities import book

PARTS = "parts: [{name: flywheel, inertia: 3}, {name: table, inertia: 8, moment: 30, ratio: 0.5, efficiency: 0.9}]"
HOIST = "parts: [{name: drum, inertia: 2, efficiency: 0.9}, {name: cage, mass: 60, radius: 0.2, moves: up}]"
SHUNT = "motor: {shunt: {moment: 60, speed: 95, no_load: 100}}"
KLOSS = "induction: {moment: 40, speed: 290, synchronous: 310, overload: 2.5}"
FAN = "resistance: [{fan: {moment: 30, speed: 60}}, {viscous: 0.1}, {friction: 4}]"
RUNS = "start: {}, coast: {}"
TEXTS = {
    "shunt": f"{SHUNT}, {PARTS}, {FAN}, {RUNS}",
    "series": "motor: {series: {moment: 400, speed: 60, stall: 1600}, ratio: 3, efficiency: 0.95}, "
    f"{PARTS}, {FAN}, "
    "start: {}, coast: {brake: 20}",
    "induction": f"motor: {{{KLOSS}, ratio: 4, efficiency: 0.95}}, {PARTS}, {RUNS}",
    "stator": f"motor: {{{KLOSS[:-1]}, stator: 0.5}}}}, {PARTS}, {RUNS}",
    "losses": f"{SHUNT}, {PARTS}, losses_of_acceleration: true, {RUNS}",
    "hoist": f"{SHUNT}, {HOIST}, losses_of_acceleration: true, {RUNS}",
    "varying": f"{SHUNT}, varying_inertia: [[0, 2], [180 deg, 3], [360 deg, 2]], {FAN}, {RUNS}",
    "uniform": f"motor: {{constant: 20, ratio: 3, efficiency: 0.9}}, {PARTS}",
    "without a gear": f"motor: {{constant: 50}}, {PARTS}, resistance: [{{friction: 10}}]",
    "weights": "parts: [{name: cage, inertia: 1, mass: 20, radius: 0.1, moves: down}]",
    "nothing": "parts: [{name: flywheel, inertia: 3}], motor: {by_time: [[0, 5], [1, 9]]}",
}
READY = ("hoist_start", "piston_pump", "tram_start")


def found_of(name):
    if name in READY:
        return solved(name).dynamics
    return course.solve(loading.loads(f"dynamics: {{{TEXTS[name]}}}")).dynamics


EVERY = pytest.mark.parametrize("name", [*TEXTS, *READY])


@EVERY
def test_every_formula_agrees_with_the_second_way(name):
    found = found_of(name)
    assert disagreements(found.s, _ways(found)) == []


def _ways(found):
    whole, steady, plant = found.whole, found.steady, found.supplied
    ways = {"J_parts": whole.added, "M_parts": sum(one.moment for one in whole.parts)}
    for key, run in found.runs:
        ways[f"turns_{key}"] = float(run.phi[-1] - run.phi[0]) / (2 * math.pi)
    if steady is not None:
        ways |= {"omega_m": steady.mean, "delta": steady.delta}
        ways |= {"T_steady": float(plant.inertia.flat[0]) * steady.mean**2 / 2}
    if found.uniformly:
        motor = [one for one in plant.acting if one.key == "motor"]
        ways |= {
            "M_dr": sum(float(one.values.flat[0]) for one in motor),
            "epsilon": plant.mean_moment / float(plant.inertia.flat[0]),
        }
    return ways


@EVERY
def test_formulas_of_rows_give_the_numbers_of_their_rows(name):
    found = found_of(name)
    tables = book(found).tables
    formulas = []
    if found.steady is not None and not found.even:
        for position in range(len(tables["dynamics_cycle_table"])):
            written = Written(found, position)
            formulas += written.sample()
            formulas += [written.by_potential()] if found.has_potential else []
    written = Written(found, 0)
    if found.start is not None:
        formulas += [*written.lost("start"), *([written.accelerated()] if found.even else [])]
    formulas += written.lost("coast") if found.coast is not None else []
    formulas += written.motor() if found.by_speed and found.given.motor else []
    for formula in formulas:
        table, key, row = tables[formula.ref.table], formula.ref.key, formula.ref.row
        size = np.nanmax(np.abs(table[key].numbers()))
        assert float(formula.value) == pytest.approx(table[key].number(row), abs=1e-8 * size), key


@EVERY
def test_the_equations_in_symbols_hold_all_over_the_motion(name):
    found = found_of(name)
    if not found.moves:
        return
    written = Written(found, 0)
    moment = np.abs(written.over("M_dr").number).max() + np.abs(written.over("M_res").number).max()
    left = [written.differential().expression.value]
    if found.has_potential and not found.even and found.steady is not None:
        left.append(written.lagrange().expression.value)
        energy = written.over("J").number * written.over("omega").number ** 2 / 2
        assert np.allclose(written.energy().expression.value, energy, rtol=1e-8, atol=0)
    for one in left:
        if not any(run.plant.passing for _, run in found.runs):
            assert np.isfinite(one).all() and np.abs(one).max() <= 1e-8 * moment


@EVERY
def test_the_separated_equation_gives_times_and_angles_of_the_start_up(name):
    found = found_of(name)
    if found.start is None or found.start.way != "speed":
        return
    time, turned = (one.expression.value for one in Written(found, 0).separated())
    run = found.start
    assert np.median(time / np.diff(run.t)) == pytest.approx(1, abs=1e-3)
    assert np.median(turned / np.diff(run.phi)) == pytest.approx(1, abs=1e-3)


@pytest.mark.parametrize("name", ["piston_pump"])
def test_the_energy_in_symbols_is_that_of_the_motion(name):
    """T = T₀ + A: with the other sign it would be of no motion."""
    found = found_of(name)
    written = Written(found, 0)
    energy = written.over("J").number * written.over("omega").number ** 2 / 2
    assert np.allclose(written.energy().expression.value, energy, rtol=1e-9, atol=0)
