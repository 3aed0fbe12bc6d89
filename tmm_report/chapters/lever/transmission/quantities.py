"""The numbers of the transmission angles, by the joint of the two links."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tmm_report.chapters.lever.initial_data.quantities import length
from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.transmission.solve import Coupler, Found
from tmm_report.i18n import NP_
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

ANGLES = Message(N_("transmission angles"))
PERMITTED = Message(N_("permitted transmission angle"))
LIMIT = Quantity("transmission", Symbol("mu", NP_("index", "lim")), "rad", PERMITTED, "deg")


def angle(of: Coupler) -> Quantity:
    joint = of.dyad.inner.name
    text = Message(N_("transmission angle at joint %(name)s"), {"name": joint})
    return Quantity(f"mu_{joint}", Symbol("mu", joint), "rad", text, "deg")


def span(of: Coupler) -> Quantity:
    text = N_("distance of the outer joints of the links that meet in %(name)s")
    if of.dyad.kind == 2:
        text = N_("distance of the other joint of the link from the guide through %(name)s")
    joint = of.dyad.inner.name
    return Quantity(f"d_{joint}", Symbol("d", joint), "m", Message(text, {"name": joint}))


def arms(of: Coupler) -> Iterator[Value]:
    """Lengths of the links between their joints, but of one that slides on a guide."""
    pairs = ((of.dyad.outer_a, of.dyad.arm_a), (of.dyad.outer_b, of.dyad.arm_b))
    for outer, arm in pairs[: 1 if of.dyad.kind == 2 else 2]:
        own = length(outer.name + of.dyad.inner.name)
        yield replace(own, key=f"transmission_{own.key}").value(float(abs(arm)))


@tabulated
def tables(found: Found) -> Iterator[Table]:
    for of in found.couplers[:1]:
        for name, at in (("table", of.kinematics.table), ("diagram", of.kinematics.diagram)):
            turned = of.kinematics.turned if name == "table" else of.kinematics.diagram_turned
            rows = [angle(one).column(one.angle(at)) for one in found.couplers]
            rows += [span(one).column(one.span(at)) for one in found.couplers if name == "table"]
            yield Table(f"transmission_{name}", ANGLES, (*where(turned), *rows))


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield LIMIT.value(found.permitted)
    for one in found.couplers:
        own, least = angle(one), one.least()
        text = Message(N_("least transmission angle at joint %(name)s over the cycle"), own.meaning.values)
        yield from arms(one)
        yield replace(own, key=f"{own.key}_min", meaning=text).value(least.value, least.turned)
