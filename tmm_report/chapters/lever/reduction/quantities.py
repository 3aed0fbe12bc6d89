"""The numbers of the reduction: parts of the links in the moment of inertia, of the loads in the moment of forces."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.kinematics.quantities import POSITION, where
from tmm_report.chapters.lever.reduction.solve import Reduced, Reduction
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

INERTIAS = Message(N_("reduced moment of inertia and the parts of the links in it"))
BY_PLANS = Message(
    N_("ratios of velocities read off the polygons, and the reduced moment of inertia by them")
)
MOMENTS = Message(N_("reduced moment of the forces and the parts of the loads in it"))

RED = NP_("index", "red")
I_RED, M_RED = Symbol("I", RED), Symbol("M", RED)
INERTIA = Quantity("I_red", I_RED, "kg·m²", Message(N_("reduced moment of inertia")))
SLOPE = Quantity(
    "I_red_slope",
    Symbol("I'", RED),
    "kg·m²/rad",
    Message(N_("derivative of the reduced moment of inertia with respect to the angle of the driving link")),
)
MOMENT = Quantity("M_red", M_RED, "N·m", Message(N_("reduced moment of the forces")))
GRAPH = Quantity(
    "I_red_graph",
    Symbol("I", RED, NP_("index", "gr")),
    INERTIA.unit,
    Message(N_("reduced moment of inertia by the ratios read off the polygon")),
)
DELTA = Quantity("delta_I", Symbol("delta", "I"), "%", Message(N_("its difference from the analytical one")))
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


def centre_ratio(point: str) -> Quantity:
    """Of a mass centre, read off a velocity plan."""
    meaning = Message(
        N_(
            "ratio of the velocity of point %(name)s to the angular velocity of the driving link, by the polygon"
        ),
        {"name": point},
    )
    return Quantity(f"vq_{point}", Symbol("v", f"{point},q"), "m", meaning)


def link_ratio(link: str, driver: str) -> Quantity:
    meaning = Message(
        N_("ratio of the angular velocity of link %(name)s to that of the driving link, by the polygon"),
        {"name": link},
    )
    return Quantity(f"u_{link}_{driver}", Symbol("u", f"{link},{driver}"), "", meaning)


@tabulated
def tables(found: Reduction) -> Iterator[Table]:
    if found.plans:
        yield Table("reduction_plans", BY_PLANS, tuple(_by_plans(found)))
    for name, reduced in (("table", found.table), ("diagram", found.diagram)):
        at = where(reduced.turned, found.kinematics.by_law)
        yield Table(f"reduced_inertia_{name}", INERTIAS, (*at, *_inertias(reduced)))
        if reduced.moments:
            yield Table(f"reduced_moment_{name}", MOMENTS, (*at, *_moments(reduced)))


def _by_plans(found: Reduction) -> Iterator[Column]:
    driver = found.kinematics.linkage.mechanism.driver.link
    yield POSITION.column([one.position for one in found.plans])
    for point in found.plans[0].centres:
        yield centre_ratio(point).column([one.centres[point] for one in found.plans])
    for link in found.plans[0].links:
        if link != driver:
            yield link_ratio(link, driver).column([one.links[link] for one in found.plans])
    yield GRAPH.column([one.graph for one in found.plans])
    yield INERTIA.column([one.exact for one in found.plans])
    yield DELTA.column([one.delta for one in found.plans])


def _inertias(reduced: Reduced) -> Iterator[Column]:
    for link, values in reduced.inertia.items():
        yield part(link).column(values)
    yield INERTIA.column(reduced.whole_inertia)
    yield SLOPE.column(reduced.slope)


def _moments(reduced: Reduced) -> Iterator[Column]:
    for load, values in reduced.moments:
        yield share(load).column(values)
    yield MOMENT.column(reduced.whole_moment)


@tabulated
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
