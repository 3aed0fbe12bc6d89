"""Every formula of the flywheel against mechanics/machine/flywheel, which finds the same in other ways."""

import math

import numpy as np
import pytest
from conftest import solved
from scipy.optimize import brentq
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.machine.flywheel import reduced
from tmm_report.chapters.machine.flywheel.equations import energies, pole, sample, unevenness
from tmm_report.chapters.machine.flywheel.given import Disc, Gyration
from tmm_report.chapters.machine.flywheel.methods import Written
from tmm_report.chapters.machine.flywheel.quantities import book
from tmm_report.mechanics.machine.flywheel import inertia as mechanics
from tmm_report.quantity.formula import Var

LOAD = "resisting: {table: [[0, 0], [90 deg, 800], [180 deg, 0], [360 deg, 0]]}"
ALONE = f"{LOAD}, speed: 12, delta: 1/25"
VARIES = "inertia: {mean: 3, harmonics: [{order: 2, cos: 1}]}"
MOTOR = "motor: {power: 8 kW, speed: 960 rpm, inertia: 0.03, efficiency: 0.9}"
TEXTS = {
    "disc": f"{ALONE}, disc: {{width: 0.15}}",
    "disc of a diameter": f"{ALONE}, disc: {{diameter: 1.1 m}}, ratio: 2, own: 2",
    "rim": f"{ALONE}, rim: {{}}, inertia: {{constant: 2}}, {MOTOR}",
    "rim of a diameter": f"{ALONE}, rim: {{diameter: 1.3 m, width: 2}}, {VARIES}, {MOTOR}, shaft: motor",
    "rim of a stress": f"{ALONE}, rim: {{}}, material: {{density: 7200 kg/m^3, stress: 6 MPa}}",
    "gyration": f"{ALONE}, radius_of_gyration: 0.6, {VARIES}, own: 1",
    "speeds": f"{LOAD}, speeds: [11, 13]",
    "driven": "driving: {mean: 100, harmonics: [{order: 1, sin: 40}]}, speed: 10, delta: 0.1",
    "both": f"{LOAD}, driving: {{constant: 200}}, speed: 12, delta: 1/25, {VARIES}",
    "areas": "areas: {values: [400, -320, 380, -410, 300, -350]}, speed: 25, delta: 0.02",
    "punch": f"punch: {{work: 2 kJ, period: 2 s, time: 0.4 s}}, delta: 0.1, {MOTOR}, ratio: 3",
    "needless": f"{ALONE.replace('12', '90')}, own: 40",
    "wheel": f"wheel: {{inertia: 60}}, speed: 12, {LOAD}, {VARIES}",
    "wheel on a fast shaft": f"wheel: {{mass: 90, radius_of_gyration: 0.4}}, ratio: 3, speed: 12, {LOAD}",
}


def found_of(name):
    return course.solve(loading.loads(f"flywheel: {{{TEXTS[name]}}}")).flywheel


EVERY = [
    *(pytest.param(lambda name=name: found_of(name), id=name) for name in TEXTS),
    *(
        pytest.param(lambda name=name: solved(name).flywheel, id=name)
        for name in ("compressor", "engine_four_stroke", "punch_press")
    ),
]


@pytest.mark.parametrize("made", EVERY)
def test_every_formula_agrees_with_the_second_way(made):
    found = made()
    assert disagreements(found.s, {**_task(found), **_diagram(found), **_sizes(found)}) == []


@pytest.mark.parametrize("made", EVERY)
def test_the_definition_of_the_unevenness_gives_what_the_motion_has(made):
    found = made()
    greatest, least = float(found.after.omega.max()), float(found.after.omega.min())
    defined = unevenness(found.s).expression.value
    assert defined == pytest.approx(found.s.number("delta"), rel=1e-12)
    if not found.needless:
        assert defined == pytest.approx((greatest - least) / found.omega, rel=0.02)  # between the points


@pytest.mark.parametrize("made", EVERY)
def test_formulas_of_rows_give_the_numbers_of_their_rows(made):
    found = made()
    table = book(found).tables["flywheel_table"]
    formulas = [
        (table, k, one) for k in range(len(table)) for of in (sample, energies) for one in of(found, table, k)
    ]
    for method in found.methods if found.diagram else ("exact",) if found.methods else ():
        if method != "constant":
            written = Written(found, method)
            cuts = map(written.cut, "12") if method != "rerikh" and found.diagram else ()
            rows = [*cuts, written.needed(), written.wheel()]
            formulas += [(found.compared, written.row, one) for one in rows]
    for of, row, formula in formulas:
        size = np.nanmax(np.abs(of[formula.ref.key].numbers()))
        assert float(formula.value) == pytest.approx(of[formula.ref.key].number(row), abs=1e-9 * size)


@pytest.mark.parametrize("name", ["compressor", "engine_four_stroke", "shaper_project"])
def test_masses_and_loads_reduced_at_every_position_are_those_over_the_cycle(name):
    found = solved(name).flywheel
    table = book(found).tables["flywheel_table"]
    keys = {"J_II", "M_dr" if found.sides.balancing == "resisting" else "M_res"}
    for k in range(len(table)):
        formulas = {one.ref.key: one for one in reduced.formulas(found, table, k)}
        assert set(formulas) == keys
        for key, one in formulas.items():
            size = np.max(np.abs(table[key].numbers()))
            assert float(one.value) == pytest.approx(table[key].number(k), abs=1e-9 * size)


def test_the_pole_distance_lays_the_diagram_of_moments_off_as_that_of_works():
    """A moment of one millimetre over one degree of the axis, through the pole, is its work at the scale of works."""
    scales = [Var("mu_A", 5.0, "J/mm"), Var("mu_M", 20.0, "N·m/mm"), Var("mu_phi", 2.5, "°/mm")]
    distance = float(pole(scales).value)
    rise = (
        1.0 / distance
    )  # mm of the diagram of works for 1 mm along the axis, by a chord parallel to the ray
    assert rise * 5.0 == pytest.approx(20.0 * np.radians(2.5))


def _task(found):
    cycle, sides, s = found.cycle, found.sides, found.s
    over = cycle.panels
    low, high = (value for value, _ in cycle.swing)
    ways = {
        "J_own": cycle.own, "omega_max": found.after.greatest, "omega_min": found.after.least, "A_ex": high - low,
        "delta_est": (high - low) / (found.omega**2 * (found.after.fixed + float(over.mean(cycle.varying)))),
    }  # fmt: skip
    if found.needless:  # of the motion without a flywheel the unevenness is less than the wanted one
        ways |= {"omega_max": found.omega * (1 + found.given.delta / 2)}
        ways |= {"omega_min": found.omega * (1 - found.given.delta / 2)}
    if sides.driving is not None:
        mean = float(over.mean(sides.driving))
        power = mean * found.omega
        lost = 1.0 if found.given.motor is None else found.given.motor.efficiency
        ways |= {"M_m": mean, "P_m": power, "P_need": power / lost}
        ways |= {"C_E": 100 * (high - low) / abs(s.number("W"))}
    return ways


def _diagram(found):
    if not found.diagram:
        return {}
    method, s = found.methods["wittenbauer"], found.s
    scale = s.number("mu_J") / s.number("mu_T")
    return {
        "psi_1": np.arctan(method.upper.slope * scale), "psi_2": np.arctan(method.lower.slope * scale),
        "ab": (method.upper.cut - method.lower.cut) / s.number("mu_T"),
    }  # fmt: skip


def _sizes(found):
    """The dimensions by mechanics, the masses by the volume of the body."""
    s, given, shape = found.s, found.given, found.given.shape
    if given.wheel is not None and given.wheel.mass is not None:
        own = given.wheel.mass * given.wheel.radius_of_gyration**2
        return {"J_shaft": own, "J_fl": own * (given.ratio or 1) ** 2}
    if given.wheel is not None or found.needless:
        return {}
    turns = given.motor.speed / found.omega if given.shaft == "motor" else given.ratio or 1
    inertia = s.number("J_fl") / turns**2
    if isinstance(shape, Gyration):
        return {"J_shaft": inertia, "m": inertia / shape.radius**2}
    rho = given.metal.density
    if isinstance(shape, Disc):
        D = shape.diameter or mechanics.disc(inertia, shape.width, rho)
        h, b = 0.0, mechanics.disc_width(inertia, D, rho)
        volume = math.pi * D**2 / 4 * b
    else:
        own = inertia * (1 - shape.spokes)
        D = shape.diameter or mechanics.rim(own, shape.height, shape.width, rho)
        h = mechanics.rim_height(own, D, shape.width, rho)
        b = shape.width * h
        volume = math.pi * ((D + h) ** 2 - (D - h) ** 2) / 4 * b
    fastest = found.after.greatest * turns
    metal = given.metal
    most = metal.speed or brentq(lambda v: mechanics.hoop_stress(rho, v) - metal.stress, 0, 1e3)
    v = fastest * (D + h) / 2
    return {
        "J_shaft": inertia, "D": D, "h": h, "b": b, "m": rho * volume, "D_out": D + h, "k_b": b / D, "k_h": h / D,
        "omega_s": fastest, "v": v, "sigma": mechanics.hoop_stress(rho, v),
        "D_lim": (D + h) * most / v, "v_lim": most,
    }  # fmt: skip
