"""The single numbers of the flywheel with their symbols, units and meanings."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.lever.moving import friction_rows
from tmm_report.chapters.machine.flywheel.given import Disc, Rim
from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.i18n import NP_
from tmm_report.mechanics.calculus.laws import Constant
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

# key, symbol (None of what is never written as one), unit, meaning, number, angle at which it is, rad
Row = tuple[str, Symbol | None, str, str, float] | tuple[str, Symbol | None, str, str, float, float]

MEAN, FL, OWN, NOM = NP_("index", "mean"), NP_("index", "fl"), NP_("index", "own"), NP_("index", "nom")
EX = NP_("index", "exc")


@tabulated
def values(found: Found) -> Iterator[Value]:
    """All of them; every key begins with "flywheel_"."""
    for rows in (_given, _loads, _wittenbauer, _motion, _sizes):
        for key, symbol, unit, meaning, number, *at in rows(found):
            quantity = Quantity(f"flywheel_{key}", symbol, unit, Message(meaning))
            yield quantity.value(number, at[0] if at else None)


def _given(found: Found) -> Iterator[Row]:
    given = found.given
    yield "delta", Symbol("delta"), "", N_("coefficient of non-uniformity"), found.delta
    if found.usual:
        fine, coarse = found.usual
        yield "delta_fine", None, "", N_("the least coefficient usual for machines of the kind"), fine
        yield "delta_coarse", None, "", N_("the greatest coefficient usual for machines of the kind"), coarse
    mean = N_("mean angular velocity of the main link")
    yield "omega_m", Symbol("omega", MEAN), "rad/s", mean, found.omega
    most, least = (found.omega * (1 + sign * found.delta / 2) for sign in (1, -1))
    yield "omega_max", Symbol("omega", "max"), "rad/s", N_("greatest angular velocity"), most
    yield "omega_min", Symbol("omega", "min"), "rad/s", N_("least angular velocity"), least
    yield from _own(found)
    own = N_("constant part of the machine's reduced moment of inertia, without the flywheel")
    yield "J_own", Symbol("J", OWN), "kg·m²", own, found.cycle.own
    period = N_("angle of the cycle")
    yield "Phi", Symbol("Phi"), "rad", period, found.cycle.panels.period
    if given.motor:
        yield "P_nom", Symbol("P", NOM), "W", N_("nominal power of the motor"), given.motor.power
        yield "omega_nom", Symbol("omega", NOM), "rad/s", N_("nominal speed of the motor"), given.motor.speed
        yield "eta", Symbol("eta"), "", N_("efficiency of the transmission"), given.motor.efficiency


def _own(found: Found) -> Iterator[Row]:
    """What the machine's own constant part is made of."""
    given = found.given
    fixed = given.inertia.amount if isinstance(given.inertia, Constant) else 0.0
    stated = N_("constant moment of inertia that is stated, of what turns with the main link")
    yield "J_0", Symbol("J", "0"), "kg·m²", stated, given.own + fixed
    links = N_("constant parts of the reduced moments of inertia of the links")
    yield "J_c", Symbol("J", "c"), "kg·m²", links, found.sides.links
    if given.motor:
        rotor = N_("moment of inertia of the motor's rotor on its own shaft")
        yield "J_r", Symbol("J", "r"), "kg·m²", rotor, given.motor.inertia


def _loads(found: Found) -> Iterator[Row]:
    if found.work is not None and found.moment is not None and found.power is not None:
        side = found.sides.balancing
        closing = N_("constant driving moment that closes the cycle")
        closing = N_("constant resisting moment that closes the cycle") if side == "resisting" else closing
        closing = closing if side else N_("mean driving moment")
        yield "W", Symbol("W"), "J", N_("work of the driving moment over the cycle"), found.work
        yield "M_m", Symbol("M", MEAN), "N·m", closing, found.moment
        yield "P_m", Symbol("P", MEAN), "W", N_("mean power of the cycle"), found.power
        yield (
            "C_E",
            Symbol("k", "E"),
            "%",
            N_("fluctuation of energy to the work of the cycle"),
            _share(found),
        )
        left = N_("part of the work of the cycle by which both sides do not close")
        yield "left", None, "%", left, 100 * abs(found.sides.spread / found.moment)
    yield from friction_rows(found.sides.machine)
    if found.needed is not None:
        yield "P_need", Symbol("P"), "W", N_("power that the motor must give on the average"), found.needed
    (low, at_low), (high, at_high) = found.cycle.swing
    yield "A_max", Symbol("A", "max"), "J", N_("greatest work of the excess moment"), high, at_high
    yield "A_min", Symbol("A", "min"), "J", N_("least work of the excess moment"), low, at_low
    yield "A_ex", Symbol("A", EX), "J", N_("greatest excess work: fluctuation of energy"), found.excess
    mean = N_("mean of the varying part of the moment of inertia")
    yield "J_mean", Symbol("J", "II," + MEAN), "kg·m²", mean, found.cycle.mean_inertia


def _share(found: Found) -> float:
    assert found.work is not None
    return 100 * found.excess / abs(found.work)


def _wittenbauer(found: Found) -> Iterator[Row]:
    """The energy–mass diagram at its scales: 1 mm of paper."""
    if not found.diagram:
        return
    method, (inertia, energy) = found.methods["wittenbauer"], found.scales
    yield "mu_J", Symbol("mu", "J"), "kg·m²/mm", N_("scale of the moments of inertia"), inertia
    yield "mu_T", Symbol("mu", "T"), "J/mm", N_("scale of the energies"), energy
    for end, touch in (("1", method.upper), ("2", method.lower)):
        psi = math.degrees(math.atan(touch.slope * inertia / energy))
        meaning = N_("angle of the tangent at the greatest speed with the axis of moments of inertia")
        if end == "2":
            meaning = N_("angle of the tangent at the least speed with the axis of moments of inertia")
        yield f"psi_{end}", Symbol("psi", end), "deg", meaning, psi
    segment = N_("segment between the tangents on the axis of energies")
    yield "ab", Symbol("ab", kind="segment"), "mm", segment, (method.upper.cut - method.lower.cut) / energy


def _motion(found: Found) -> Iterator[Row]:
    estimate = N_("coefficient of non-uniformity by the estimate with a constant moment of inertia")
    yield (
        "J_fl",
        Symbol("J", FL),
        "kg·m²",
        N_("moment of inertia of the flywheel, reduced to the main link"),
        found.fly,
    )
    yield "delta_est", Symbol("delta", NP_("index", "est")), "", estimate, found.estimate
    if found.before is not None:
        before = N_("coefficient of non-uniformity without a flywheel")
        yield "delta_0", Symbol("delta", "0"), "", before, found.before.delta
    yield (
        "delta_run",
        None,
        "",
        N_("coefficient of non-uniformity measured in the motion integrated"),
        found.proof.delta,
    )
    yield (
        "closure",
        None,
        "",
        N_("relative difference of the speeds at both ends of the cycle"),
        found.proof.closure,
    )
    (low, at_low), (high, at_high) = found.cycle.panels.extremes(found.after.epsilon)
    yield "eps_max", Symbol("epsilon", "max"), "rad/s²", N_("greatest angular acceleration"), high, at_high
    yield "eps_min", Symbol("epsilon", "min"), "rad/s²", N_("least angular acceleration"), low, at_low


def _sizes(found: Found) -> Iterator[Row]:
    if (sizes := found.sizes) is None:
        return
    given = found.given
    yield "i", Symbol("i"), "", N_("speed of the flywheel's shaft to that of the main link"), sizes.ratio
    yield "J_shaft", Symbol("J"), "kg·m²", N_("moment of inertia of the flywheel on its shaft"), sizes.inertia
    mass = N_("mass of the flywheel")
    if isinstance(given.shape, Rim) and not given.wheel:
        mass = N_("mass of the flywheel without spokes and hub")
    yield "m", Symbol("m"), "kg", mass, sizes.mass
    if found.gyration is not None:
        yield "k", Symbol("k"), "m", N_("radius of gyration of the flywheel"), found.gyration
    if sizes.diameter is None or sizes.width is None:
        return
    yield "D", Symbol("D"), "m", N_("diameter of the flywheel, of a rim the mean one"), sizes.diameter
    yield "b", Symbol("b"), "m", N_("width of the flywheel"), sizes.width
    if isinstance(given.shape, Disc):
        yield (
            "k_b",
            Symbol("k", "b"),
            "",
            N_("width of the disc to its diameter"),
            sizes.width / sizes.diameter,
        )
    if isinstance(given.shape, Rim) and sizes.height is not None:
        yield "h", Symbol("h"), "m", N_("height of the rim's section"), sizes.height
        yield (
            "k_h",
            Symbol("k", "h"),
            "",
            N_("height of the rim's section to its diameter"),
            sizes.height / sizes.diameter,
        )
        yield "k_b", Symbol("k", "b"), "", N_("width of the rim's section to its height"), given.shape.width
        yield (
            "k_s",
            Symbol("k", "s"),
            "",
            N_("part of the moment of inertia in spokes and hub"),
            given.shape.spokes,
        )
    yield from _strength(found)


def _strength(found: Found) -> Iterator[Row]:
    sizes, material = found.sizes, found.given.material
    assert sizes and sizes.outer and sizes.speed and sizes.stress and sizes.limit
    yield "D_out", Symbol("D", NP_("index", "outer")), "m", N_("outer diameter of the flywheel"), sizes.outer
    yield "rho", Symbol("rho"), "kg/m³", N_("density of the material"), material.density
    yield (
        "omega_s",
        Symbol("omega", "s"),
        "rad/s",
        N_("greatest angular velocity of the flywheel's shaft"),
        sizes.fastest,
    )
    yield "v", Symbol("v"), "m/s", N_("greatest speed of the rim"), sizes.speed
    yield (
        "v_lim",
        Symbol("v", NP_("index", "allow")),
        "m/s",
        N_("speed of the rim that is commonly allowed"),
        material.limit,
    )
    yield "sigma", Symbol("sigma"), "Pa", N_("stress in a thin rim at that speed"), sizes.stress
    limit = N_("largest outer diameter that the rim's speed allows")
    yield "D_lim", Symbol("D", NP_("index", "allow")), "m", limit, sizes.limit
