"""Every formula of the balancing in another way: the solved motion and its force, and mechanics' own sums."""

from types import SimpleNamespace

import numpy as np
import pytest
from conftest import solved
from twice import disagreements

from tmm_report.chapters.lever.moving import Moving
from tmm_report.chapters.machine.balancing.given import METHODS, Antiphase, Counterweight, Given
from tmm_report.chapters.machine.balancing.quantities import tables, values
from tmm_report.chapters.machine.balancing.solve.whole import solve
from tmm_report.chapters.machine.balancing.view.slider_crank import SliderView
from tmm_report.chapters.machine.balancing.view.whole import BalancingView
from tmm_report.mechanics.calculus import harmonics as fourier

PAGE = SimpleNamespace(t=str, once=lambda make, *of: make(*of))  # formulas are asked for, nothing is printed
NAMES = ("compressor", "crank_rocker", "slider_crank_offset")
COUPLES = {"1": Antiphase(0.05, 0.3), "3": Antiphase(0.04, 0.2)}
WEIGHTS = (Counterweight(distance=0.05), Counterweight(mass=1.5))


CASES = [(name, weight, part) for name in NAMES for weight, part in zip(WEIGHTS, (0.4, 0.0), strict=True)]


@pytest.fixture(params=CASES, ids=str)
def found(request):
    """Balanced by all methods, counterweights by distance with a part of what reciprocates, or by mass without."""
    name, weight, part = request.param
    kinematics = solved(name).lever.kinematics
    weights = dict.fromkeys(kinematics.linkage.mechanism.moving, weight)
    given = Given(
        list(METHODS), weights, part=part, rotors={"first": 0.06, "second": 0.04, "3": 0.03}, couples=COUPLES
    )
    return solve(given, Moving(kinematics, None))


# --- slider-cranks


def test_every_formula_of_a_slider_crank_agrees_with_the_second_way(found):
    for crank, remains, s in zip(found.cranks, found.cycle_remains, found.sliders, strict=True):
        assert disagreements(s, _ways(found, crank, remains)) == []


def _ways(found, crank, remains):
    """λ is how far the rod turns aside: the first harmonic of its sine; a pair of rotors, of which each takes half,
    takes a harmonic of the force that the solved motion has."""
    motion = found.kinematics.cycle.motion(found.turned)
    rod = (motion.place(crank.joint) - motion.place(crank.pin)) / crank.along
    lam = float(fourier.series((rod / np.abs(rod)).imag, 1).amplitude[1])
    ways = {"lambda": lam, "lambda_L": 1 / lam}
    sizes = fourier.series(remains.exact, 2).amplitude
    for order, roman in ((1, "I"), (2, "II")):
        product = float(sizes[order]) / (2 * (order * found.kinematics.omega) ** 2)
        ways |= {f"U_{roman}": product, f"m_{roman}": product / found.given.radii[order]}
    return ways


def test_amplitudes_of_the_sliders_force_are_those_of_the_motion(found):
    for number, (crank, remains) in enumerate(zip(found.cranks, found.cycle_remains, strict=True)):
        if crank.central and crank.mass:
            view = SliderView(found, number, PAGE)
            sizes = fourier.series(remains.exact, 2).amplitude[1:]
            assert [formula.value for formula in view.forces()] == pytest.approx(sizes, rel=1e-9)


# --- rows of the tables


def test_every_formula_of_a_row_gives_its_number(found):
    """The expression is of the numbers as the note has them; the row is found by mechanics, by vectors."""
    view = BalancingView(found, PAGE)
    formulas = view.shaking_formulas()
    for row in range(len(found.substituted.splits)):
        formulas += [*view.split_formulas(row), *view.three_masses(row)]
    for case in found.cases:
        formulas += [one for own in view.counterweight_formulas(case) for one in own]
    formulas += [*view.rotor_formulas(), *view.couple_formulas()]
    if view.takes:
        formulas.append(view.wheel_formula(view.geared))
    told = [text for formula in formulas if (text := _contradicted(found, formula))]
    assert formulas and told == []


def _contradicted(found, formula):
    ref = formula.ref
    table = next(one for one in tables(found) if one.name == ref.table)
    row = list(table["position"].values).index(ref.row) if "position" in table else ref.row
    number, size = table[ref.key].number(row), np.nanmax(np.abs(table[ref.key].numbers()))
    if ref.table == "shaking_table":  # a sum of terms that nearly cancel, by the force at an arm
        size = max(size, found.original.force_max.value, found.original.moment_max.value)
    right = np.isclose(float(formula.value), number, rtol=1e-9, atol=1e-9 * size)
    return "" if right else f"{ref}: {float(formula.value)}, by mechanics {number}"


def test_masses_put_into_joints_have_the_mass_the_centre_and_the_inertia_of_the_link(found):
    """By linear equations: Σ m = m, Σ m s = 0, of three masses Σ m s² = J."""
    view = BalancingView(found, PAGE)
    for row, one in enumerate(found.substituted.splits):
        at_p, at_q, *rest = (float(formula.value) for formula in view.split_formulas(row))
        a, b = one.arms
        assert [at_p, at_q] == pytest.approx(np.linalg.solve([[1, 1], [-a, b]], [one.mass, 0.0]))
        reach = a**2 + one.off**2, b**2 + one.off**2
        if rest:
            assert rest[0] == pytest.approx(one.inertia - at_p * reach[0] - at_q * reach[1])
        three = [float(formula.value) for formula in view.three_masses(row)]
        if three:
            known = np.linalg.solve([[1, 1, 1], [-a, b, 0], [a**2, b**2, 0]], [one.mass, 0.0, one.inertia])
            assert three == pytest.approx(known)


def test_the_seen_force_is_that_of_the_driving_link(found):
    """A counterweight by the printed mean takes the mean away; no point of the curve lies outside the circle."""
    told = {value.key: value.value for value in values(found)}
    mean, centre = (complex(told[f"{key}_x"], told[f"{key}_y"]) for key in ("seen_mean", "seen"))
    size = np.abs(found.seen).max()
    assert abs((found.seen - mean).mean()) < 1e-9 * size
    assert np.abs(fourier.fine(found.seen) - centre).max() < told["seen_radius"] + 1e-9 * size
