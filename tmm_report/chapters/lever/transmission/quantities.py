"""The numbers of the transmission angles, by the joint of the two links."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tmm_report.chapters.lever.initial_data.quantities import length
from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.transmission import solve
from tmm_report.i18n import NP_
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

ANGLES = Message(N_("transmission angles"))
PERMITTED = Message(N_("permitted transmission angle"))
LIMIT = Quantity("transmission", Symbol("mu", NP_("index", "lim")), "rad", PERMITTED, "deg")


def angle(of: Dyad, text: str = N_("transmission angle at joint %(name)s"), end: str = "") -> Quantity:
    joint = of.inner.name
    return Quantity(f"mu_{joint}{end}", Symbol("mu", joint), "rad", Message(text, {"name": joint}), "deg")


def span(of: Dyad) -> Quantity:
    joint, text = of.inner.name, N_("distance of the outer joints of the links that meet in %(name)s")
    if of.kind == 2:
        text = N_("distance of the other joint of the link from the guide through %(name)s")
    return Quantity(f"d_{joint}", Symbol("d", joint), "m", Message(text, {"name": joint}))


def arms(of: Dyad) -> Iterator[Value]:
    """Lengths of the links between their joints, but of one that slides on a guide."""
    for outer, arm in ((of.outer_a, of.arm_a), (of.outer_b, of.arm_b))[: 1 if of.kind == 2 else 2]:
        own = length(outer.name + of.inner.name)
        yield replace(own, key=f"transmission_{own.key}").value(float(abs(arm)))


@tabulated
def tables(found: solve.Found) -> Iterator[Table]:
    of = found.kinematics
    sets = (("table", of.turned, of.table), ("diagram", of.diagram_turned, of.diagram))
    for name, turned, at in sets if found.couplers else ():
        rows = [angle(one).column(solve.angle(one, at)) for one in found.couplers]
        rows += [span(one).column(solve.span(one, at)) for one in found.couplers if name == "table"]
        yield Table(f"transmission_{name}", ANGLES, (*where(turned, of.by_law), *rows))


@tabulated
def values(found: solve.Found) -> Iterator[Value]:
    yield LIMIT.value(found.permitted)
    for one in found.couplers:
        least = solve.least(one, found.kinematics)
        yield from arms(one)
        own = angle(one, N_("least transmission angle at joint %(name)s over the cycle"), "_min")
        yield own.value(least.value, least.turned)
