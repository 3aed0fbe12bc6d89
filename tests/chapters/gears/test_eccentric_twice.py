"""Every formula of the eccentric mechanism against mechanics/gears, coordinates and the speeds of its train."""

import cmath
import math

import numpy as np
import pytest
from notes import VARIANTS
from test_eccentric_loads import by_displacements, lines
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.gears.eccentric import equations
from tmm_report.chapters.gears.eccentric.quantities import tables
from tmm_report.chapters.gears.eccentric.steps import WRITTEN, steps
from tmm_report.mechanics.gears.eccentric import mechanism as ecc

DISCS = "width: 20 mm, density: 7800 kg/m^3"
CASES = {
    "four satellites": f"ratio: 4, eccentricity: 18 mm, t: 10, clearance: 1 mm, speed: 100 rpm, {DISCS}, "
    "load: {moment: -30 N*m, on: ring, meshes: 4e8 N/m, axes: 1e8 N/m}",
    "crowded": "ratio: 4, eccentricity: 18 mm, t: 16, satellites: [largest, middle]",
    "one alone": "ratio: 4, eccentricity: 18 mm, satellites: [largest]",
    "no middle satellite, paths": "ratio: 4, eccentricity: 17 mm, tolerance: 3 %, rack: {ha*: 0.8, c*: 0.3}, "
    + DISCS
    + ", points: {A: {radius: 100 mm, angle: -30 deg}, B: {wheel: sun, radius: 6 mm, angle: 40 deg}}",
    "undercut": "teeth: [14, 40, 76]",
    "other satellites by the backlash": "ratio: 4, eccentricity: 18 mm, t: 13, backlash: 0.4 mm, load: {moment: 5 N*m}",
    "a fraction, another rack": "ratio: 17/3, eccentricity: 12 mm, rack: {alpha: 25 deg, ha*: 0.9}",
    "a coefficient of one": "ratio: 1.5, eccentricity: 10 mm",
    "near the stated ratio": "ratio: 4, teeth: [27, 49, 107], eccentricity: 18 mm, tolerance: 1 %",
    "middle satellites alone": "teeth: [54, 106], eccentricity: 6 mm, satellites: [middle]",
    "halves of teeth": f"ratio: 53/27, eccentricity: 3 mm, satellites: [middle], {DISCS}",
}


def solved(name):
    if name in CASES:
        return course.solve(loading.loads(f"eccentric: {{module: 2 mm, {CASES[name]}}}")).eccentric
    return course.solve(loading.load(VARIANTS / f"{name}.yaml")).eccentric


@pytest.fixture(scope="module", params=[*CASES, "eccentric"])
def found(request):
    return solved(request.param)


@pytest.mark.exhaustive
def test_every_formula_agrees_with_the_second_way(found):
    made, family = steps(found), found.judged.family
    wrong = disagreements(made.s, _ways(found), formed=True)
    largest, middle, smallest, _ = family.satellites[found.row]
    teeth = {
        "z1": family.sun[found.row],
        "z2": largest,
        "z3": family.ring[found.row],
        "z4": middle,
        "z5": smallest,
    }
    wrong += disagreements(made.set, teeth)
    for of, row in zip(found.satellites, made.satellites, strict=True):
        wrong += disagreements(row, _of_satellite(found, of), formed=True)
    for pair, row in zip(found.near, made.pairs, strict=True):
        apart = 1e3 * abs(_centre(found, pair.one) - _centre(found, pair.other))
        gap = apart - 1e3 * found.given.module * (
            (pair.one.teeth + pair.other.teeth) / 2 + 2 * found.given.rack.ha
        )
        wrong += disagreements(row, {"l": apart, "gap": gap}, formed=True)
    if made.masses is not None:
        each = dict(zip(("m2", "m4", "m5"), found.masses.each[found.row], strict=False))
        wrong += disagreements(made.masses, each | {"saving": found.masses.saving[found.row]})
    for of, row in zip(found.satellites, made.loads, strict=bool(made.loads)):
        wrong += disagreements(row, _loaded(found, of), formed=True)
    for path in made.paths:
        place = 1e3 * path.traced.places[WRITTEN]
        wrong += disagreements(path.s, {"rate": path.traced.rate})
        wrong += disagreements(path.place, {"x": place.real, "y": place.imag}, formed=True)
    assert wrong == []


def _ways(found):
    """In the units of the formulas: whole numbers as they were found, ratios by the speeds of the train."""
    eq, solution, given = found.equation, found.solution, found.given
    axes, ring, sun = (of.speed for of in found.motions)  # what stands still
    pair = ecc.internal_pair(found.ring, np.array([20, 40]), given.module, given.rack)
    start = pair.rho_l[0]  # where the involute begins: nought at the least number of teeth
    ways = {
        "E": found.E, "equation_a": eq.a, "equation_b": eq.b, "equation_c": eq.c, "divisor": math.gcd(eq.a, eq.b),
        "z1_0": solution.first, "z2_0": solution.second, "a_1": solution.a1, "b_1": solution.b1,
        "gap_2_4": 1e3 * found.judged.gap[found.row, 0, 1],
        "gap_1_3": 1e3 * ecc.tips_apart(found.sun, found.ring, found.e, given.module, given.rack.ha),
        "least_teeth": 20 - 20 * start[0] / (start[1] - start[0]),
        "alpha_a3": math.acos(np.max(pair.d_b[1]) / np.max(pair.d_a[1])),
        "u": axes["1"] / axes["3"], "u_1H": ring["1"] / ring["H"], "u_3H": sun["3"] / sun["H"],
    }  # fmt: skip
    if found.masses is not None:
        ways["saved_share"] = 100 * found.masses.saving[found.row] / found.masses.each[found.row, 0]
    if (load := found.given.load) is not None:
        ways |= _moments(found, load)
    return ways


def _moments(found, load):
    """By the powers: of the members with the axes stopped, then of all with the ring stopped; w by the forces."""
    axes, ring, _ = (of.speed for of in found.motions)
    on_sun = load.moment if load.on == "sun" else -load.moment * axes["3"] / axes["1"]
    ways = {"M_1": on_sun, "M_3": -on_sun * axes["1"] / axes["3"], "M_H": -on_sun * ring["1"] / ring["H"]}
    ways["F_sum"] = abs(on_sun) / (found.given.module * found.sun / 2)
    if load.yielding is not None:
        forces = [by_displacements(found)[of.wheel] for of in found.satellites]
        ways["share_sum"] = sum(forces) / forces[0] * _weight(found, found.satellites[0])
    return ways


def _weight(found, of):
    """By the squares of the forces on axis and meshes, for a normal force of 1 in both."""
    one, other = lines(found, of)
    return 1 / (1 + found.given.load.yielding * abs(one + other) ** 2 / 2)


def _loaded(found, of):
    force, alpha = by_displacements(found)[of.wheel], found.given.rack.alpha
    centre = _centre(found, of)
    one, other = lines(found, of)
    ways = {"gamma": cmath.phase((centre - found.e) / centre), "F_t": force, "F_n": force / math.cos(alpha)}
    if found.given.load.yielding is not None:
        ways["w"] = _weight(found, of)
    return {**ways, "Q": abs(one + other) * ways["F_n"]}


def _centre(found, of):
    """Where two circles about the axes of sun and ring cross, m."""
    half, e = found.given.module / 2, found.e
    near, far = half * (found.sun + of.teeth), half * (found.ring - of.teeth)
    x = (near**2 - far**2 + e**2) / (2 * e)
    square = near**2 - x**2
    y = math.sqrt(square) if square > 1e-12 * near**2 else 0.0  # on the line of the axes
    return complex(x, -y if of.below else y)


def _of_satellite(found, of):
    centre, given = _centre(found, of), found.given
    first = -found.ring if found.by_middle else found.judged.family.satellites[found.row, 0]
    belt = ecc.belt(found.sun, found.ring, first, of.teeth, of.phi1, of.phi3)
    return {
        "phi1": cmath.phase(centre),
        "phi3": cmath.phase(centre - found.e),
        "L": round(float(belt), 12),
        "l": 1e3 * abs(centre),
        "rho": 1e3 * ecc.root_in_hand(found.ring, np.array(of.teeth), given.module, given.rack),
        "z3_least": _least_ring(found, of),
    }


def _least_ring(found, of):
    """The ring whose tip lies in the limit point of the line of action: the squares of the tip's curvature and of the
    distance between the limit points differ by what goes straight with the teeth of the ring."""
    rings = np.array([1000, 2000])
    pair = ecc.internal_pair(rings, np.array(of.teeth), found.given.module, found.given.rack)
    one, other = (pair.d_a[1] ** 2 - pair.d_b[1] ** 2) / 4 - pair.line**2
    return 1000 - 1000 * one / (other - one)


def test_equations_hold_for_the_chosen_set(found):
    made = steps(found)
    assert equations.general(made).expression.value == pytest.approx(0, abs=1e-9)
    assert equations.with_numbers(made).expression.value == pytest.approx(0, abs=1e-9)


def test_definitions_give_the_teeth_of_the_set(found):
    made = steps(found)
    largest, middle, smallest, _ = found.judged.family.satellites[found.row]
    second = middle if found.halved else largest
    assert [of.expression.value for of in equations.solutions(made)] == [found.sun, second]
    assert equations.ring_teeth(made).expression.value == pytest.approx(found.ring)
    assert equations.middle_teeth(made).expression.value == middle
    assert equations.smallest_teeth(made).expression.value == smallest


def test_definitions_of_sets_near_the_ratio(found):
    if found.nearby is None:
        return
    off, largest = (of.expression.value for of in equations.near(steps(found)))
    wanted = found.given.ratio or found.ratio_of_teeth
    assert off == pytest.approx(float((found.ratio_of_teeth - wanted) / wanted))
    assert largest == pytest.approx(found.judged.family.satellites[found.row, 0])


@pytest.mark.exhaustive
def test_columns_have_their_letters():
    rows = {table.name: table for table in tables(solved("four satellites"))}
    satellites = rows["eccentric_satellites"]
    assert str(satellites["phi1"].symbol(1)) == "phi_1,4" and satellites["x"].symbols == ()
    assert str(rows["eccentric_wheels"]["d_a"].symbol(0)) == "d_a1"
