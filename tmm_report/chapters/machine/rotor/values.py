"""The single numbers of masses on a turning shaft balanced."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.rotor.solve import Found
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

PER = NP_("index", "lim")  # permissible
SUM = "Sigma"

# key, symbol, unit, meaning, number
Row = tuple[str, Symbol | None, str, str, float]


@tabulated
def values(found: Found) -> Iterator[Value]:
    """All of them; every key begins with "rotor_"."""
    for rows in (_unbalance, _polygons, _left, _limits):
        for key, symbol, unit, meaning, number in rows(found):
            yield Quantity(f"rotor_{key}", symbol, unit, Message(meaning)).value(number)


def _unbalance(found: Found) -> Iterator[Row]:
    force, couple, given = found.resultant, found.moment, found.given
    yield "D_x", Symbol("D", SUM, "x"), "kg·m", N_("sum of the unbalances, component along x"), force.real
    yield "D_y", Symbol("D", SUM, "y"), "kg·m", N_("sum of the unbalances, component along y"), force.imag
    yield "D", Symbol("D", SUM), "kg·m", N_("sum of the unbalances"), abs(force)
    angle = float(np.degrees(np.angle(force))) % 360.0 if abs(force) > 1e-9 * found.size else 0.0
    yield "alpha", Symbol("alpha", SUM), "deg", N_("angle of the sum of the unbalances from x"), angle
    x, y = (
        N_("sum of the moments about plane I, component along x"),
        N_("sum of the moments about plane I, component along y"),
    )
    yield "M_x", Symbol("M", SUM, "x"), "kg·m²", x, couple.real
    yield "M_y", Symbol("M", SUM, "y"), "kg·m²", y, couple.imag
    yield "M", Symbol("M", SUM), "kg·m²", N_("sum of the moments about plane I"), abs(couple)
    if found.two:
        between = N_(
            "distance between the planes of correction, negative where plane II stands before plane I"
        )
        yield "L", Symbol("L"), "m", between, found.corrections[1].at - found.corrections[0].at
    if given.bearings:
        yield (
            "L_AB",
            Symbol("L", "AB"),
            "m",
            N_("distance between the bearings"),
            given.bearings[1] - given.bearings[0],
        )
    if given.speed:
        yield "omega", Symbol("omega"), "rad/s", N_("angular velocity of the rotor"), given.speed
    if found.mass is not None:
        yield "mass", Symbol("m", "0"), "kg", N_("mass of the rotor"), found.mass
        yield (
            "e",
            Symbol("e"),
            "m",
            N_("distance of the mass centre of the rotor from its axis"),
            abs(force) / found.mass,
        )


def _polygons(found: Found) -> Iterator[Row]:
    yield (
        "mu_D",
        Symbol("mu", "D"),
        "kg·m/mm",
        N_("scale of the polygon of the unbalances"),
        found.force.scale,
    )
    closing = N_("length of the vector that closes the polygon of the unbalances")
    yield "closing_D", Symbol("d", "I"), "mm", closing, abs(found.force.closing)
    read = N_("its angle read off the polygon of the unbalances")
    yield (
        "read_D",
        Symbol("alpha", "I"),
        "deg",
        read,
        float(np.degrees(np.angle(found.force.closing))) % 360.0,
    )
    if found.couple is None:
        return
    yield "mu_M", Symbol("mu", "M"), "kg·m²/mm", N_("scale of the polygon of the moments"), found.couple.scale
    closing = N_("length of the vector that closes the polygon of the moments")
    yield "closing_M", Symbol("d", "M,II"), "mm", closing, abs(found.couple.closing)
    read = N_("its angle read off the polygon of the moments")
    yield (
        "read_M",
        Symbol("alpha", "II"),
        "deg",
        read,
        float(np.degrees(np.angle(found.couple.closing))) % 360.0,
    )
    laid = N_("length of the product of plane II in the polygon of the unbalances")
    yield "laid_II", Symbol("d", "II"), "mm", laid, float(found.force.lengths[-1])


def _left(found: Found) -> Iterator[Row]:
    force, couple = found.left
    yield (
        "left_D",
        Symbol("D'", SUM),
        "kg·m",
        N_("sum of the unbalances with the weights as they are made"),
        abs(force),
    )
    about = N_("sum of the moments about plane I with the weights as they are made")
    yield "left_M", Symbol("M'", SUM), "kg·m²", about, abs(couple)
    yield "uneven", None, "", N_("what exact weights leave of the unbalance, relative"), found.uneven
    if found.given.bearings:
        text = N_("relative disagreement of the forces of both bearings with the sum of the unbalances")
        yield "disagreement", None, "", text, found.disagreement


def _limits(found: Found) -> Iterator[Row]:
    given = found.given
    if found.permissible is not None and given.grade:
        grade = N_("balance quality grade, product of permissible eccentricity and angular velocity")
        yield "G", Symbol("G"), "mm/s", grade, 1e3 * given.grade
        yield "D_per", Symbol("D", PER), "kg·m", N_("permissible unbalance of the rotor"), found.permissible
    if found.centre is not None:
        yield "centre", Symbol("z", "S"), "m", N_("place of the mass centre along the shaft"), found.centre
    if found.ratio is not None and found.one_plane is not None:
        yield "ratio", Symbol("lambda"), "", N_("width of the rotor by its diameter"), found.ratio
        one = N_("angular velocity up to which balance in one plane suffices")
        yield "one_plane", Symbol("omega", "1"), "rad/s", one, found.one_plane
