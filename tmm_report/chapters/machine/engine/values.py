"""Every number of the balance of an engine: single values, and columns of its tables."""

from __future__ import annotations

from typing import NamedTuple

from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import X_PART, Y_PART, Quantity, kept
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.quantity.symbols import Symbol

WORDS = (NP_("index", "rod"), NP_("index", "cw"))  # counterweight


class Values(Sheet, prefix="engine"):
    count = Q("n", "", N_("number of cylinders"))
    m_piston = Q("m_P", "kg", N_("mass of the piston with its pin and rings"))
    m = Q("m", "kg", N_("reciprocating mass of a cylinder"))
    m_crank = Q("m_K", "kg", N_("mass of the crank brought to its pin"))
    m_rot = Q("m_R", "kg", N_("rotating mass of a cylinder at the crankpin"))
    m_rod = Q("m_rod", "kg", N_("mass of the connecting rod"))
    a = Q("a", "m", N_("distance of the rod's mass centre from the crankpin"))
    r = Q("r", "m", N_("radius of the crank"))
    l = Q("l", "m", N_("length of the connecting rod"))
    lam = Q("lambda", "", N_("ratio of the crank radius to the length of the rod"), key="lambda")
    omega = Q("omega", "rad/s", N_("angular velocity of the crankshaft"))
    unit = Q("F_0", "N", N_("greatest inertia force of order 1 of a cylinder"))
    share = Q("c_cw", "", N_("part of the reciprocating mass that is balanced"))
    m_cw = Q("m_cw", "kg", N_("mass of a counterweight"))
    r_cw = Q("r_cw", "m", N_("distance of the counterweight's mass centre from the axis of the crankshaft"))
    hammer = Q(
        "N_cw",
        "N",
        N_(
            "hammer blow of a counterweight: force across the cylinders of what balances the reciprocating mass"
        ),
    )
    F_along = Q(Symbol("F", "1,∥"), "N", N_("force of order 1 along the axes of the cylinders"))
    F_across = Q(Symbol("F", "1,⟂"), "N", N_("force of order 1 across the axes of the cylinders"))
    M_along = Q(Symbol("M", "1,∥"), "N·m", N_("moment of order 1 in the plane of the cylinders"))
    M_across = Q(Symbol("M", "1,⟂"), "N·m", N_("moment of order 1 across the plane of the cylinders"))
    mu_F = Q("mu_F", "kg·m/mm", N_("scale of the polygons of the forces"))
    mu_M = Q("mu_M", "kg·m²/mm", N_("scale of the polygons of the moments"))


def _crank(letter: str, meaning: str, k: int) -> Q:
    return Q(letter, "deg", Message(meaning, {"k": k}))


DIRECT = N_("angle of the direct crank of order %(k)s")
REVERSE = N_("angle of the reverse crank of order %(k)s")


class Cylinders(Sheet):
    beta = Q("beta", "deg", N_("angle of the cylinder's axis from the upward vertical"))
    psi = Q("psi", "deg", N_("angle of the crank from that of angle 0"))
    z = Q("z", "m", N_("place of the cylinder from the plane of the moments"))
    direct_1, reverse_1 = _crank("gamma_1", DIRECT, 1), _crank("gamma_1^'", REVERSE, 1)
    direct_2, reverse_2 = _crank("gamma_2", DIRECT, 2), _crank("gamma_2^'", REVERSE, 2)
    theta = Q("theta_i", "deg", N_("angle of the crank from the axis of its cylinder"))


class Orders(Sheet):
    order = Q("k", "", N_("order, turns for one of the crankshaft"))
    c = Q("c", "", N_("coefficient of the series in λ"))
    c_exact = Q("c'", "", N_("coefficient of the exact motion"))


class Polygons(Sheet):
    d_direct = Q("d", "mm", N_("length of the sum of the direct cranks"))
    d_reverse = Q("d'", "mm", N_("length of the sum of the reverse cranks"))


class Turn(Sheet):
    phi = Q("phi", "deg", N_("angle of the crankshaft"))


class Weights(Sheet):
    """Products: of forces in kg·m, of moments in kg·m²."""

    forward = Q("D^+", "", N_("product of the weight that turns with the crankshaft"))
    forward_angle = Q("alpha^+", "deg", N_("angle of the vector of that order from x at angle 0"))
    backward = Q("D^-", "", N_("product of the weight that turns against the crankshaft"))
    backward_angle = Q("alpha^-", "deg", N_("angle of the vector of that order from x at angle 0"))


FIRES = NP_("index", "ign")


class Firing(Sheet):
    angle = Q(
        Symbol("phi", FIRES), "deg", N_("angle of the crankshaft at which the cylinder fires, from the first")
    )
    interval = Q("Deltaphi", "deg", N_("angle of the crankshaft to the next firing"))


# --- inertia forces and their moments


class Kind(NamedTuple):
    """`product`: unit of the weights that balance it; `graph`: the greatest of an order."""

    letter: str
    unit: str
    product: str
    meaning: str
    graph: str


KINDS = {
    "force": Kind("F", "N", "kg·m", N_("inertia force"), N_("greatest inertia force of order %(k)s")),
    "couple": Kind(
        "M", "N·m", "kg·m²", N_("moment of the inertia forces"), N_("greatest moment of order %(k)s")
    ),
}
PARTS = {
    "forward": (("", "+"), N_("%(of)s, part that turns with the crankshaft")),
    "backward": (("", "-"), N_("%(of)s, part that turns against the crankshaft")),
    "max": (("max", ""), N_("%(of)s, greatest")),
    "min": (("min", ""), N_("%(of)s, least")),
    "direction": (("", ""), N_("%(of)s, direction of the greatest from the axis x")),
}
STAGES = {
    "before": N_("without counterweights"),
    "after": N_("with all masses"),
    "orders": N_("by orders 1 and 2"),
}


@kept
def turning(of: str, part: str) -> Quantity:
    """A part of a force or moment of an order."""
    kind, (index, text) = KINDS[of], PARTS[part]
    meaning = Message(text, {"of": Message(kind.meaning)})
    if part == "direction":
        return Quantity(f"{kind.letter}_direction", Symbol("alpha", kind.letter), "deg", meaning)
    return Quantity(f"{kind.letter}_{part}", Symbol(kind.letter, *index), kind.unit, meaning)


@kept
def graph(of: str, order: int) -> Quantity:
    """The greatest force or moment of an order, by the polygons."""
    kind = KINDS[of]
    meaning = Message(kind.graph, {"k": order})
    return Quantity(f"{kind.letter}_{order}_max", Symbol(kind.letter, f"{order},max"), kind.unit, meaning)


@kept
def over_turn(of: str, stage: str) -> Quantity:
    kind = KINDS[of]
    meaning = Message(N_("%(of)s: %(when)s"), {"of": Message(kind.meaning), "when": Message(STAGES[stage])})
    return Quantity(f"{kind.letter}_{stage}", Symbol(kind.letter), kind.unit, meaning)


@kept
def component(of: str, axis: str) -> Quantity:
    """Of any stage: what an axis of a diagram shows."""
    kind = KINDS[of]
    meaning = Message({"x": X_PART, "y": Y_PART}[axis], {"of": Message(kind.meaning)})
    return Quantity(f"{kind.letter}_{axis}", Symbol(kind.letter, axis), kind.unit, meaning)
