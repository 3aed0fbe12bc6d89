"""The single numbers of the balance of an engine."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.engine.drawn import scales
from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

ROD = NP_("index", "rod")
COUNTER = NP_("index", "cw")  # counterweight

# key, symbol, unit, meaning, number
Row = tuple[str, Symbol | None, str, str, float]


@tabulated
def values(found: Found) -> Iterator[Value]:
    """All of them; every key begins with "engine_"."""
    for rows in (_masses, _sizes, _counterweight, _left, _drawn):
        for key, symbol, unit, meaning, number in rows(found):
            yield Quantity(f"engine_{key}", symbol, unit, Message(meaning)).value(number)


def _masses(found: Found) -> Iterator[Row]:
    given = found.given
    yield "count", Symbol("n"), "", N_("number of cylinders"), len(found.banks)
    yield "m_piston", Symbol("m", "P"), "kg", N_("mass of the piston with its pin and rings"), given.piston
    yield "m", Symbol("m"), "kg", N_("reciprocating mass of a cylinder"), found.reciprocating
    if given.rotating:
        yield "m_crank", Symbol("m", "K"), "kg", N_("mass of the crank brought to its pin"), given.rotating
    if found.rotating:
        yield (
            "m_rot",
            Symbol("m", "R"),
            "kg",
            N_("rotating mass of a cylinder at the crankpin"),
            found.rotating,
        )
    if rod := given.rod:
        yield "m_rod", Symbol("m", ROD), "kg", N_("mass of the connecting rod"), rod.mass
        yield "a", Symbol("a"), "m", N_("distance of the rod's mass centre from the crankpin"), rod.centre


def _sizes(found: Found) -> Iterator[Row]:
    given = found.given
    yield "r", Symbol("r"), "m", N_("radius of the crank"), given.radius
    yield "l", Symbol("l"), "m", N_("length of the connecting rod"), given.length
    yield "lambda", Symbol("lambda"), "", N_("ratio of the crank radius to the length of the rod"), found.lam
    yield "omega", Symbol("omega"), "rad/s", N_("angular velocity of the crankshaft"), given.speed
    yield "unit", Symbol("F", "0"), "N", N_("greatest inertia force of order 1 of a cylinder"), found.unit


def _counterweight(found: Found) -> Iterator[Row]:
    if found.weight_mass is None or found.weight_radius is None or found.share is None:
        return
    yield (
        "share",
        Symbol("c", COUNTER),
        "",
        N_("part of the reciprocating mass that is balanced"),
        found.share,
    )
    yield "m_cw", Symbol("m", COUNTER), "kg", N_("mass of a counterweight"), found.weight_mass
    radius = N_("distance of the counterweight's mass centre from the axis of the crankshaft")
    yield "r_cw", Symbol("r", COUNTER), "m", radius, found.weight_radius


def _left(found: Found) -> Iterator[Row]:
    """Of order 1 with all that turns, where all cylinders have one direction: along it and across it."""
    if not found.in_line:
        return
    axis = 1j * np.exp(1j * found.banks[0])
    force, couple = found.primary
    along, across = (
        N_("force of order 1 along the axes of the cylinders"),
        N_("force of order 1 across the axes of the cylinders"),
    )
    yield "F_along", Symbol("F", "1,∥"), "N", along, float(force.along(axis))
    yield "F_across", Symbol("F", "1,⟂"), "N", across, float(force.along(1j * axis))
    along, across = (
        N_("moment of order 1 in the plane of the cylinders"),
        N_("moment of order 1 across the plane of the cylinders"),
    )
    yield "M_along", Symbol("M", "1,∥"), "N·m", along, float(couple.along(axis))
    yield "M_across", Symbol("M", "1,⟂"), "N·m", across, float(couple.along(1j * axis))


def _drawn(found: Found) -> Iterator[Row]:
    of = scales(found)
    if "force" in of:
        yield "mu_F", Symbol("mu", "F"), "kg·m/mm", N_("scale of the polygons of the forces"), of["force"]
    if "couple" in of:
        yield "mu_M", Symbol("mu", "M"), "kg·m²/mm", N_("scale of the polygons of the moments"), of["couple"]
