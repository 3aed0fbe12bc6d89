"""The numbers of the reduction to a link that slides: its stroke, parts of the links and loads, the force needed."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.translation.solve import Found, Reduced
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Book, Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

MASSES = Message(N_("reduced mass and the parts of the links in it"))
FORCES = Message(N_("reduced force and the parts of the loads in it"))

RED, DR = NP_("index", "red"), NP_("index", "dr")
M_RED, F_RED = Symbol("m", RED), Symbol("F", RED)
MASS = Quantity("m_red", M_RED, "kg", Message(N_("reduced mass")))
SLOPE = Quantity(
    "m_red_slope",
    Symbol("m'", RED),
    "kg/m",
    Message(N_("derivative of the reduced mass with respect to the stroke")),
)
FORCE = Quantity("F_red", F_RED, "N", Message(N_("reduced force")))
NEEDED = Quantity(
    "F_dr",
    Symbol("F", DR),
    "N",
    Message(N_("driving force along the stroke, under which the motion is as stated")),
)
MISS = Quantity(
    "translation_disagreement",
    None,
    "",
    Message(N_("worst relative disagreement of the balancing moment with the reduced mass and force")),
)


def place(found: Found) -> Quantity:
    """Of the link along its guide; of a driving cylinder its length."""
    if not found.link:
        meaning = Message(N_("stroke: length of the driving cylinder between its points"))
        return Quantity("s", Symbol("s"), "m", meaning)
    return Quantity("s", Symbol("s", found.link), "m", _of(found, N_("place of link %(of)s along its guide")))


def speed(found: Found) -> Quantity:
    if not found.link:
        return Quantity("v", Symbol("v", "s"), "m/s", Message(N_("speed of the stroke")))
    return Quantity(
        "v", Symbol("v", found.link), "m/s", _of(found, N_("speed of link %(of)s along its guide"))
    )


def acceleration(found: Found) -> Quantity:
    if not found.link:
        return Quantity("a", Symbol("a", "s"), "m/s²", Message(N_("acceleration of the stroke")))
    text = N_("acceleration of link %(of)s along its guide")
    return Quantity("a", Symbol("a", found.link), "m/s²", _of(found, text))


def _of(found: Found, text: str) -> Message:
    return Message(text, {"of": found.link})


def part(link: str) -> Quantity:
    """Of a link in the reduced mass."""
    meaning = Message(N_("part of link %(of)s in the reduced mass"), {"of": link})
    return Quantity(f"m_red_{link}", Symbol("m", f"{RED},{link}"), "kg", meaning)


def share(load: Quantity) -> Quantity:
    """Of a load in the reduced force."""
    meaning = Message(N_("part in the reduced force: %(load)s"), {"load": load.meaning})
    symbol = Symbol("F", f"{RED},{load.sign.base}{load.sign.sub}")
    return Quantity(f"F_red_{load.key}", symbol, "N", meaning)


def book(found: Found) -> Book:
    return Book.of(tables(found), values(found))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for name, reduced in (("table", found.table), ("diagram", found.diagram)):
        at = where(reduced.turned, found.kinematics.by_law)
        yield Table(f"reduced_mass_{name}", MASSES, (*at, *_masses(found, reduced)))
        yield Table(f"reduced_force_{name}", FORCES, (*at, *_forces(reduced)))


def _masses(found: Found, reduced: Reduced) -> Iterator[Column]:
    yield place(found).column(reduced.s)
    yield speed(found).column(reduced.v)
    yield acceleration(found).column(reduced.a)
    for link, values in reduced.mass.items():
        yield part(link).column(values)
    yield MASS.column(reduced.whole_mass)
    yield SLOPE.column(reduced.slope)


def _forces(reduced: Reduced) -> Iterator[Column]:
    """Without loads the force needed alone."""
    for load, values in reduced.forces:
        yield share(load).column(values)
    if reduced.forces:
        yield FORCE.column(reduced.whole_force)
    yield NEEDED.column(reduced.needed)


@tabulated
def values(found: Found) -> Iterator[Value]:
    low, high = found.extremes
    yield Quantity("m_red_min", M_RED, MASS.unit, Message(N_("least reduced mass"))).value(
        low.value, low.turned
    )
    if found.guide is None:
        text = Message(N_("greatest reduced mass"))
        yield Quantity("m_red_max", M_RED, MASS.unit, text).value(high.value, high.turned)
    if found.disagreement is not None:
        yield MISS.value(found.disagreement)
