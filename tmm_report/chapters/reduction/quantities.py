"""The numbers of the reduction: parts of the links in the moment of inertia, of the loads in the moment of forces."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.kinematics.quantities import where
from tmm_report.chapters.reduction.solve import Reduced, Reduction
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol

INERTIAS = Message(N_("reduced moment of inertia and the parts of the links in it"))
MOMENTS = Message(N_("reduced moment of the forces and the parts of the loads in it"))

RED = NP_("index", "red")
I_RED, M_RED = Symbol("I", RED), Symbol("M", RED)
INERTIA = Quantity("I_red", I_RED, "kg·m²", Message(N_("reduced moment of inertia")))
SLOPE = Quantity(
    "I_red_slope",
    Symbol("I'", RED),
    "kg·m²/rad",
    Message(N_("derivative of the reduced moment of inertia by the angle of the driving link")),
)
MOMENT = Quantity("M_red", M_RED, "N·m", Message(N_("reduced moment of the forces")))
MISS = Quantity(
    "reduction_disagreement",
    None,
    "",
    Message(N_("worst relative disagreement of the balancing moment with the reduced moments")),
)


def part(link: str) -> Quantity:
    """Of a link in the reduced moment of inertia."""
    meaning = Message(N_("part of link %(of)s in the reduced moment of inertia"), {"of": link})
    return Quantity(f"I_{link}", Symbol("I", link), "kg·m²", meaning)


def share(load: Quantity) -> Quantity:
    """Of a load in the reduced moment of the forces."""
    meaning = Message(N_("part in the reduced moment of the forces: %(load)s"), {"load": load.meaning})
    symbol = Symbol("M", f"{RED},{load.sign.base}{load.sign.sub}")
    return Quantity(f"M_red_{load.key}", symbol, "N·m", meaning)


def tables(found: Reduction) -> Iterator[Table]:
    for name, reduced in (("table", found.table), ("diagram", found.diagram)):
        at = where(reduced.turned)
        yield Table(f"reduced_inertia_{name}", INERTIAS, (*at, *_inertias(reduced)))
        if reduced.moments:
            yield Table(f"reduced_moment_{name}", MOMENTS, (*at, *_moments(reduced)))


def _inertias(reduced: Reduced) -> Iterator[Column]:
    for link, values in reduced.inertia.items():
        yield part(link).column(values)
    yield INERTIA.column(reduced.whole_inertia)
    yield SLOPE.column(reduced.slope)


def _moments(reduced: Reduced) -> Iterator[Column]:
    for load, values in reduced.moments:
        yield share(load).column(values)
    yield MOMENT.column(reduced.whole_moment)


def values(found: Reduction) -> Iterator[Value]:
    low, high = found.extremes
    least, greatest = (
        Message(N_("least reduced moment of inertia")),
        Message(N_("greatest reduced moment of inertia")),
    )
    yield Quantity("I_red_min", I_RED, INERTIA.unit, least).value(low.value, low.turned)
    yield Quantity("I_red_max", I_RED, INERTIA.unit, greatest).value(high.value, high.turned)
    if found.disagreement is not None:
        yield MISS.value(found.disagreement)
