"""Every formula of the balance of an engine in another way: moments of mass, the exact motion, the solved sums."""

import numpy as np
import pytest
from conftest import solved
from twice import disagreements

from tmm_report import course, loading
from tmm_report.chapters.machine.engine import equations
from tmm_report.chapters.machine.engine.quantities import tables
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.masses import engine_cylinders

SIZES = "speed: 955 rpm, crank_radius: 50 mm, rod_length: 200 mm, reciprocating: 2 kg, accuracy: 0.001 mm"
FOUR = "inline: {cranks: [0, 180 deg, 180 deg, 0], spacing: 0.1}"
ROD = ", rod: {mass: 1 kg, centre: 60 mm}"
TEXTS = {
    "single": "inline: {cranks: [0]}",
    "four": FOUR + ", rotating: 0.7 kg, counterweights: {share: 0.4, radius: 60 mm}",
    "rod": FOUR + ROD + ", counterweights: {mass: 1 kg, radius: 60 mm}",
    "rod and crank": FOUR + ROD + ", rotating: 0.2 kg, counterweights: {mass: 1 kg, share: 0.3}",
    "bare": "vee: {angle: 60 deg, cranks: [0]}, counterweights: {share: 0.4, mass: 2 kg}",
    "found share": "radial: {cylinders: 5}, counterweights: {radius: 60 mm, mass: 1 kg}",
    "uneven": "cylinders: [{bank: 10 deg}, {bank: -35 deg, crank: 70 deg, at: 0.1}]",
    "vee": "vee: {angle: 80 deg, cranks: [0, 90 deg, 270 deg, 180 deg], spacing: 0.1}, about: 0.3",
}


@pytest.fixture(params=[*TEXTS, "engine_balance"])
def found(request):
    """Every way to state a rod and a counterweight; with sums of order 1 and 2 of every kind."""
    if request.param in TEXTS:
        return course.solve(loading.loads(f"engine: {{{SIZES}, {TEXTS[request.param]}}}")).engine
    return solved(request.param).engine


def table(found, name):
    return next(one for one in tables(found) if one.name == f"engine_{name}")


def test_every_formula_agrees_with_the_second_way(found):
    assert disagreements(found.s, _ways(found)) == []


def _ways(found):
    """The rod by its moments about both pins; the counterweight by the moment of the masses about the shaft."""
    given, s = found.given, found.s
    rod, r = given.rod, given.crank_radius
    piston, turning = given.reciprocating, given.rotating
    if rod is not None:  # its weight is borne by two pins
        shares = np.linalg.solve([[1.0, 1.0], [given.rod_length, 0.0]], [rod.mass, rod.mass * rod.centre])
        piston, turning = piston + shares[0], turning + shares[1]
    sizes = {"m": piston, "m_rot": turning, "lambda": r / given.rod_length}
    push = engine_cylinders.exact(np.zeros(1), 1e-9, np.zeros(1), np.zeros(1), np.ones(1))
    sizes["unit"] = (
        piston * r * given.speed**2 * abs(complex(push[0]))
    )  # of an endless rod, at the dead point
    if given.counterweights is not None:
        share, weight, at = (s.number(key) for key in ("share", "m_cw", "r_cw"))
        whole = engine_cylinders.counterweight(piston, turning, share, r, at)
        sizes |= {
            "m_cw": whole,
            "r_cw": at * whole / weight,
            "share": share + (weight - whole) * at / (r * piston),
            "hammer": (weight * at - turning * r) * given.speed**2,
        }
    return sizes


def test_the_defined_force_has_the_coefficients_of_the_table(found):
    """Of each cylinder the cosines of its own angle; its sum over the cylinders is the force by the orders."""
    force = equations.of_one(found).expression.value  # (P, N), the first angle again at the end
    theta = equations.turned(found).expression.value
    unit, orders = found.s.number("unit"), table(found, "orders")
    for k, c in zip(orders["order"].values, orders["c"].values, strict=True):
        if k <= 4:  # the series is written so far
            by_cosine = 2 * np.mean((force * np.cos(k * theta))[:-1], axis=0) / unit
            assert by_cosine == pytest.approx(c, abs=1e-12)
    exact = unit * engine_cylinders.acceleration(theta, found.s.number("lambda"))
    assert np.abs(force - exact).max() < 0.5 * found.s.number("lambda") ** 3 * unit
    series = fourier.turning((force @ (1j * np.exp(1j * found.banks)))[:-1], 2)
    size = 1e-9 * unit * len(found.banks)
    for row, (k, one) in enumerate(((1, found.first), (2, found.second))):
        ahead, back = series[2 + k], series[2 - k]
        assert np.allclose([ahead, back], one.force, rtol=0, atol=size)
        assert abs(ahead) + abs(back) == pytest.approx(orders["F_max"].values[row], abs=size)


def test_forces_by_the_polygons_are_those_calculated(found):
    """To what can be read off the polygons at 0.1 mm or finer."""
    of = table(found, "polygons")
    size = max(of["analytic"].values)
    for row, star in enumerate(found.stars):
        formula = equations.by_polygon(found, of, row, star)
        assert formula.value == pytest.approx(of["graph"].values[row], rel=1e-12, abs=1e-12 * size)
        assert formula.value == pytest.approx(of["analytic"].values[row], abs=5e-3 * size)


def test_weights_by_the_formulas_balance_the_orders(found):
    """k² ω² times the products is what is left of the order, by the sum over the cylinders."""
    of, speed = table(found, "remedies"), found.given.speed
    for row, one in enumerate(found.remedies):
        source = table(found, "primary" if one.order == 1 else "orders")
        formulas = list(equations.remedy(found, of, source, row))
        most = found.primary if one.order == 1 else (found.second.force, found.second.couple)
        turning = most[one.of == "couple"]
        parts = [abs(turning.forward), abs(turning.backward)]
        wanted = {"none": [], "pair": parts[:1], "forward": parts[:1], "backward": parts[1:]}
        told = [formula.value * (one.order * speed) ** 2 for formula in formulas]
        assert told == pytest.approx(wanted.get(one.kind, parts))
