"""The single numbers of the eccentric epicyclic mechanism with their symbols, units and meanings."""

from __future__ import annotations

import math
from collections.abc import Iterator

from tmm_report.chapters.gears.eccentric.quantities.further import further_values
from tmm_report.chapters.gears.eccentric.solve.mechanism import CARRIER, RING, SUN, Found
from tmm_report.mechanics.gears.pair_sizes import ring_rule
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.terms.gear_terms import HA, C

# key, symbol (None of what is never written as one), unit, meaning, number
Row = tuple[str, Symbol | None, str, str | Message, float]

GAP = "Delta"
AXES_STOPPED = Symbol("u", SUN + RING, CARRIER)


@tabulated
def values(found: Found, prefix: str = "eccentric") -> Iterator[Value]:
    """All of them; every key begins with `prefix`."""
    for rows in (_given, _equation, _chosen, _lengths, _proof, _motion, _drawings, further_values):
        for key, symbol, unit, meaning, number in rows(found):
            said = meaning if isinstance(meaning, Message) else Message(meaning)
            yield Quantity(f"{prefix}_{key}", symbol, unit, said).value(number)


def _given(found: Found) -> Iterator[Row]:
    given, rack = found.given, found.given.rack
    ratio = float(found.ratio_of_teeth)
    yield "u_teeth", Symbol("u"), "", N_("ratio of the teeth of ring and sun"), ratio
    yield "e", Symbol("e"), "m", N_("eccentricity"), found.e
    yield "m", Symbol("m"), "m", N_("module"), given.module
    yield "alpha", Symbol("alpha"), "deg", N_("profile angle of the basic rack"), math.degrees(rack.alpha)
    yield "ha", HA, "", N_("coefficient of the height of the head"), rack.ha
    yield "c", C, "", N_("coefficient of the radial clearance"), rack.c
    delta = N_("least distance between the tips of neighbouring satellites")
    yield "delta", Symbol("delta"), "m", delta, given.clearance
    yield "j_n", math_symbol("j_n"), "m", N_("normal backlash of the meshes"), given.backlash
    if given.speed:
        yield "omega", Symbol("omega"), "rad/s", N_("angular velocity of the driving wheel"), given.speed


def _equation(found: Found) -> Iterator[Row]:
    """The Diophantine equation a z1 + b z2 + c = 0 and its solution."""
    eq, solution = found.equation, found.solution
    yield "E", Symbol("E"), "", N_("eccentricity in halves of a module"), found.E
    factor = N_("factor that makes the coefficients of the equation whole")
    yield "equation_k", Symbol("k"), "", factor, eq.k
    for name, number in (("a", eq.a), ("b", eq.b), ("c", eq.c)):
        meaning = Message(N_("coefficient %(name)s of the equation of the teeth"), {"name": name})
        yield f"equation_{name}", Symbol(name), "", meaning, number
    divisor = N_("greatest common divisor of the coefficients a and b")
    yield "divisor", Symbol("d"), "", divisor, solution.divisor
    for name, number in (("x", solution.x), ("y", solution.y)):
        meaning = Message(N_("coefficient %(name)s of the extended algorithm of Euclid"), {"name": name})
        yield f"euclid_{name}", Symbol(name), "", meaning, number
    particular = () if found.halved else (("1", solution.first), ("2", solution.second))
    for name, number in particular:
        meaning = Message(N_("teeth of wheel %(wheel)s in the particular solution"), {"wheel": name})
        yield f"z{name}_0", Symbol("z", name, "0"), "", meaning, number
    for name, number in (("a", solution.a1), ("b", solution.b1)):
        meaning = Message(N_("coefficient %(name)s divided by the greatest common divisor"), {"name": name})
        yield f"{name}_1", Symbol(name, "1"), "", meaning, number


def _chosen(found: Found) -> Iterator[Row]:
    yield "t", Symbol("t"), "", N_("number of the set"), found.t
    for wheel, z in ((SUN, found.sun), (RING, found.ring)):
        meaning = Message(N_("number of teeth of wheel %(wheel)s"), {"wheel": wheel})
        yield f"z{wheel}", Symbol("z", wheel), "", meaning, z
    yield "satellites", None, "", N_("number of satellites"), len(found.satellites)
    one, other = found.remainder
    yield "remainder_teeth", None, "", N_("remainder of z1 + z3 divided by 4"), one
    yield "remainder_E", None, "", N_("remainder of 2e/m divided by 4"), other
    least = N_("least number of teeth that the rack does not undercut")
    yield "least_teeth", math_symbol("z_min"), "", least, found.least_teeth
    rounded = N_("least number of teeth as the course rounds it")
    yield "least_teeth_rounded", None, "", rounded, found.rounded_least
    if (rule := ring_rule(found.given.rack)) is not None:
        yield "ring_rule", None, "", N_("least teeth of a ring without shift by the rule of the course"), rule


def _lengths(found: Found) -> Iterator[Row]:
    half, clearance = found.given.module / 2, found.given.clearance
    yield "r_1", math_symbol("r_1"), "m", N_("radius of the pitch circle of the sun"), half * found.sun
    yield "r_3", math_symbol("r_3"), "m", N_("radius of the pitch circle of the ring"), half * found.ring
    gap = Message(N_("free distance between the tip circles of satellites %(pair)s"), {"pair": "2–4"})
    yield "gap_2_4", Symbol(GAP, "2,4"), "m", gap, found.middle_gap
    rest = N_("what the free distance of satellites 2 and 4 has in hand; negative: what it lacks")
    yield "in_hand_2_4", None, "m", rest, found.middle_gap - clearance
    tips = N_("distance between the tips of sun and ring where they are nearest")
    yield "gap_1_3", Symbol(GAP, "1,3"), "m", tips, found.tips_apart
    angle = N_("profile angle at the tips of the ring of full height")
    yield "alpha_a3", Symbol("alpha", "a3"), "deg", angle, math.degrees(found.tip_angle)
    yield "cut", None, "m", N_("by how much the tips of the ring are cut down"), found.cut


def _proof(found: Found) -> Iterator[Row]:
    positions = N_("number of positions at which the teeth were checked")
    yield "checked", None, "", positions, len(found.proof.turn)
    yield "overlap", None, "m²", N_("largest overlap of the teeth over a pitch"), found.overlap
    yield "clearance", None, "m", N_("least clearance of the teeth over a pitch"), found.clearance


def _motion(found: Found) -> Iterator[Row]:
    u = found.ratio
    yield "u", AXES_STOPPED, "", N_("ratio of sun and ring with the axes stopped"), u
    ring = N_("ratio of the sun and the body of the axes with the ring stopped")
    yield "u_1H", Symbol("u", SUN + CARRIER, RING), "", ring, 1 - u
    sun = N_("ratio of the ring and the body of the axes with the sun stopped")
    yield "u_3H", Symbol("u", RING + CARRIER, SUN), "", sun, 1 - 1 / u


def _drawings(found: Found) -> Iterator[Row]:
    """A scale is written 1:2 or 4:1: the number that is not 1."""
    for name, scale in (("drawing", found.scale), ("close", found.close_scale)):
        if scale >= 1:
            larger = N_("how many times the drawing is larger than the mechanism")
            yield f"{name}_enlargement", None, "", larger, scale
        else:
            smaller = N_("how many times the drawing is smaller than the mechanism")
            yield f"{name}_reduction", None, "", smaller, 1 / scale
