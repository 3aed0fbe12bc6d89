"""The numbers of the plans: scales, segments, values read off, what was worked by hand, comparison of the methods."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Protocol

import numpy as np

from tmm_report.chapters.lever.initial_data.quantities import length
from tmm_report.chapters.lever.kinematics.quantities import POSITION
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, plain, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated
from tmm_report.quantity.written import segment_of, worked_table

if TYPE_CHECKING:  # drafting takes the names of its quantities from here
    from tmm_report.chapters.lever.plans.drafting import Plan, Projections
    from tmm_report.chapters.lever.plans.scales import Choice
    from tmm_report.chapters.lever.plans.solve import Drawn, Plans

MU_V = Quantity("mu_v", Symbol("mu", "v"), "(m/s)/mm", Message(N_("scale of the velocity polygon")))
MU_A = Quantity("mu_a", Symbol("mu", "a"), "(m/s²)/mm", Message(N_("scale of the acceleration polygon")))
ACCURACY = Quantity("accuracy", None, "mm", Message(N_("accuracy to which lengths are read off drawings")))
WORST = Quantity(
    "delta_max", None, "%", Message(N_("largest difference of the polygons from the analytical method"))
)

COMPARISON = Message(N_("graphical method against the analytical one"))
SEGMENTS = Message(N_("segments measured in the polygons"))
LARGEST = N_("%(of)s, the largest at the positions of the polygons")
VALUES = Message(N_("values read off the polygons"))
EQUATIONS = Message(N_("equations of the loops of a group in projections on the axes, and their solution"))
DELTA = Quantity(
    "delta", Symbol("delta"), "%", Message(N_("difference; empty where both are zero within the reading"))
)


SENSES = Message(N_("senses of angular velocities or accelerations found from the polygon"))


@tabulated
def values(found: Plans) -> Iterator[Value]:
    yield MU_V.value(found.velocity_scale)
    yield MU_A.value(found.acceleration_scale)
    yield ACCURACY.value(found.accuracy)
    yield WORST.value(found.worst)
    for choice in found.choices:
        yield from chosen(choice, found.named)


def chosen(choice: Choice, named: Mapping[str, Quantity]) -> tuple[Value, Value]:
    """A value and the segment at which it is to be drawn, mm, from which its scale follows."""
    segment, name = choice.segment, choice.segment.name
    if segment.kind == "length":
        of = length(name)
    else:
        of = named[choice.key]
        of = replace(of, meaning=Message(LARGEST, {"of": of.meaning}))
    drawn = replace(segment_of(name), key=f"chosen_{name}")
    return replace(of, key=f"largest_{of.key}").value(choice.value), drawn.value(segment.mm)


@tabulated
def tables(found: Plans) -> Iterator[Table]:
    """Of every plan what was worked by hand; of all the segments and values; the comparison of every position."""
    named = found.named
    for drawn in found.drawn:
        for plan in (drawn.velocity, drawn.acceleration):
            yield worked_table(plan.worked)
            if plan.senses:
                yield senses(plan)
            yield from _projections(plan, named)
    for kind in ("v", "a") if found.drawn else ():
        plans = plans_of(found.drawn, kind)
        yield Table(f"segments_{kind}", SEGMENTS, (_positions(plans), *_segments(plans)))
        yield Table(f"plan_values_{kind}", VALUES, (_positions(plans), *_read(plans, named)))
    for drawn in found.drawn:
        unit = {key: quantity.unit for key, quantity in named.items()}.__getitem__
        yield comparison(f"comparison_{drawn.position}", COMPARISON, drawn.comparison, unit)


def senses(plan: Plan) -> Table:
    """A row a link that turns: the vector that shows its sense and the point to which it is moved, or the link as which
    it turns; 1 counter-clockwise, -1 clockwise, 0 not at all."""
    rows = plan.senses
    columns = (
        text_column("link", Message(N_("the link")), [one.link for one in rows]),
        text_column("vector", Message(N_("vector of the polygon by its ends")), [one.ends for one in rows]),
        text_column("to", Message(N_("point of the link to which it is moved")), [one.to for one in rows]),
        text_column("like", Message(N_("link that turns alike")), [one.like for one in rows]),
        plain("sense", "", Message(N_("1: counter-clockwise, -1: clockwise")), [one.sense for one in rows]),
    )
    return Table(senses_name(plan), SENSES, columns)


def senses_name(plan: Plan) -> str:
    return f"senses_{plan.kind}_{plan.position}"


def plans_of(drawn: Sequence[Drawn], kind: str) -> list[Plan]:
    """All plans of velocities, "v", or of accelerations, "a"."""
    return [one.velocity if kind == "v" else one.acceleration for one in drawn]


def _positions(plans: Sequence[Plan]) -> Column:
    return POSITION.column([plan.position for plan in plans])


def _segments(plans: Sequence[Plan]) -> Iterator[Column]:
    for ends in _all(plan.segments for plan in plans):
        yield segment_of(ends).column([plan.segments.get(ends, math.nan) for plan in plans])


def _read(plans: Sequence[Plan], named: Mapping[str, Quantity]) -> Iterator[Column]:
    """Values that were read: not the driving link's own rate, which is given."""
    for key in _all([k for k in plan.values if plan.per_mm[k]] for plan in plans):
        yield named[key].column([plan.signed.get(key, math.nan) for plan in plans])


def _all(names: Iterable[Iterable[str]]) -> list[str]:
    return list(dict.fromkeys(name for some in names for name in some))


class Compared(Protocol):
    """One value by two methods; `delta`: %, None where there is none."""

    @property
    def key(self) -> str: ...
    @property
    def graph(self) -> float: ...
    @property
    def analytic(self) -> float: ...
    @property
    def delta(self) -> float | None: ...


def comparison(name: str, meaning: Message, rows: Sequence[Compared], unit: Callable[[str], str]) -> Table:
    """One row a quantity: its key finds it."""
    deltas = [math.nan if row.delta is None else row.delta for row in rows]
    columns = (
        text_column("key", Message(N_("the value compared")), [row.key for row in rows]),
        text_column("unit", Message(N_("its unit")), [unit(row.key) for row in rows]),
        plain("graph", "", Message(N_("read off the polygon")), [row.graph for row in rows]),
        plain("analytic", "", Message(N_("analytical")), [row.analytic for row in rows]),
        DELTA.column(deltas),
    )
    return Table(name, meaning, columns)


def _projections(plan: Plan, named: Mapping[str, Quantity]) -> Iterator[Table]:
    for number, step in enumerate(plan.steps, 1):
        if step.projections is not None:
            name = equations_name(plan, number)
            yield Table(name, EQUATIONS, tuple(_equations(step.projections, named)))


def equations_name(plan: Plan, number: int) -> str:
    """Name of the table of a group's equations, groups counted from 1."""
    return f"equations_{plan.kind}_{plan.position}_{number}"


def _equations(found: Projections, named: Mapping[str, Quantity]) -> Iterator[Column]:
    """A row a projection: the coefficients of the unknowns and the right side; the solution in the last row."""
    contours = [f"{point}, {axis}" for point, axis, _, _ in found.rows]
    yield text_column("contour", Message(N_("point at which the loop closes, axis")), [*contours, ""])
    coefficients = np.array([row for _, _, row, _ in found.rows])
    for i, key in enumerate(found.unknown):
        quantity, numbers = named[key], [*coefficients[:, i], found.solution[i]]
        meaning = Message(N_("coefficient of %(of)s; in the last row its value"), {"of": quantity.meaning})
        yield Quantity(key, quantity.symbol, quantity.unit, meaning).column(numbers)
    right = [right for _, _, _, right in found.rows]
    yield plain("right", "", Message(N_("right side")), [*right, math.nan])
