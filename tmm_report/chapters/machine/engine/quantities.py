"""The tables of the balance of an engine of several cylinders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.chapters.machine.engine.values import (
    KINDS,
    PARTS,
    STAGES,
    Cylinders,
    Firing,
    Orders,
    Polygons,
    Turn,
    Weights,
    graph,
    over_turn,
    turning,
)
from tmm_report.mechanics.masses.engine_cylinders import Turning, cranks
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value, plain, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

Array = Any
NAME = Message(N_("number of the cylinder"))
QUANTITY, UNIT = Message(N_("quantity")), Message(N_("its unit"))


@tabulated
def values(found: Found) -> Iterator[Value]:
    yield from found.s.values()


def headline(found: Found) -> Iterator[Value]:
    """What is looked for first: what shakes the engine, and the counterweight."""
    names = {"force": N_("greatest inertia force"), "couple": N_("greatest moment of the inertia forces")}
    for of, text in names.items():
        symbol = Symbol(KINDS[of].letter, "max")
        yield Quantity(f"engine_{of}_most", symbol, KINDS[of].unit, Message(text)).value(
            found.greatest("after", of)
        )
    if "m_cw" in found.s:
        yield found.s["m_cw"]


@tabulated
def tables(found: Found) -> Iterator[Table]:
    yield _table("cylinders", N_("cylinders of the engine"), _cylinders(found))
    yield _table("orders", N_("inertia forces and moments by orders"), _orders(found))
    yield _table("primary", N_("force and moment of order 1 with the masses that turn"), _primary(found))
    if found.stars:
        yield _table("polygons", N_("inertia forces and moments by the polygons of cranks"), _polygons(found))
    yield _table("diagram", N_("inertia force and moment over a turn of the crankshaft"), _diagram(found))
    yield _table("greatest", N_("greatest inertia force and moment over a turn"), _greatest(found))
    yield _table("remedies", N_("weights on shafts that balance what is left"), _remedies(found))
    if found.firing:
        yield _table("firing", N_("order of firing"), _firing(found))


def _table(name: str, meaning: str, columns: Iterator[Column]) -> Table:
    return Table(f"engine_{name}", Message(meaning), tuple(columns))


# --- the cylinders


def _cylinders(found: Found) -> Iterator[Column]:
    yield text_column("cylinder", NAME, [one.name for one in found.given.laid])
    yield Cylinders.beta.column(np.degrees(found.banks))
    yield Cylinders.psi.column(np.degrees(found.angles) % 360)
    yield Cylinders.z.column(found.places)
    of = ((Cylinders.direct_1, Cylinders.reverse_1), (Cylinders.direct_2, Cylinders.reverse_2))
    for k, both in enumerate(of, 1):
        for one, turned in zip(both, cranks(k, found.banks, found.angles), strict=True):
            yield one.column(np.round(np.degrees(turned) % 360, 9) % 360)


# --- by orders


def _orders(found: Found) -> Iterator[Column]:
    rows = found.orders
    names = [str(one.order) for one in rows]
    yield Orders.order.column([one.order for one in rows])
    yield _of_rows(Orders.c.quantity, [one.textbook for one in rows], names)
    yield _of_rows(Orders.c_exact.quantity, [one.exact for one in rows], names)
    yield from _turning([one.force for one in rows], "force", names)
    yield from _turning([one.couple for one in rows], "couple", names)


def _of_rows(of: Quantity, values: Any, names: Sequence[str]) -> Column:
    """Each row with its order at the letter."""
    sign = of.sign
    return Column(
        of, values, [Symbol(sign.base, ",".join(filter(None, (name, sign.sub))), sign.sup) for name in names]
    )


def _turning(rows: Sequence[Turning], of: str, names: Sequence[str]) -> Iterator[Column]:
    for part in PARTS:
        yield _of_rows(turning(of, part), [_part(one, part) for one in rows], names)


def _part(of: Turning, part: str) -> float:
    """Its size, or the direction in degrees."""
    if part == "direction":
        return float(np.degrees(of.direction))
    return float(np.abs(getattr(of, {"max": "greatest", "min": "least"}.get(part, part))))


def _primary(found: Found) -> Iterator[Column]:
    stages, forces, couples = zip(*found.stages, strict=True)
    yield text_column("stage", Message(N_("masses taken together")), stages)
    yield from _turning(forces, "force", ["1"] * len(stages))
    yield from _turning(couples, "couple", ["1"] * len(stages))


# --- polygons


def _polygons(found: Found) -> Iterator[Column]:
    rows = found.stars
    of = [graph(star.of, star.order) for star in rows]
    yield text_column("key", QUANTITY, [one.key for one in of])
    yield text_column("unit", UNIT, [one.unit for one in of])
    own = [f"{KINDS[star.of].letter}{star.order}" for star in rows]
    for one, lengths in (
        (Polygons.d_direct.quantity, [star.direct_length for star in rows]),
        (Polygons.d_reverse.quantity, [star.reverse_length for star in rows]),
    ):
        yield Column(one, lengths, [Symbol(one.sign.base, sub) for sub in own])
    graphs, exact = (np.array(numbers) for numbers in ([s.graph for s in rows], [s.analytic for s in rows]))
    with np.errstate(all="ignore"):
        delta = np.where(exact > 0, 200 * (graphs - exact) / (graphs + exact), np.nan)
    yield plain("graph", "", Message(N_("by the polygon")), graphs)
    yield plain("analytic", "", Message(N_("by calculation")), exact)
    yield plain("delta", "%", Message(N_("difference in per cent of the mean")), delta)


# --- over a turn


def _diagram(found: Found) -> Iterator[Column]:
    yield Turn.phi.column(np.degrees(found.diagram["after"].phi))
    for stage, course in found.diagram.items():
        for of in KINDS:
            yield from over_turn(of, stage).vector(getattr(course, of))


def _greatest(found: Found) -> Iterator[Column]:
    """A row each for the force and the moment."""
    names = ("force", "couple")
    units = [KINDS[of].unit for of in names]
    yield text_column("of", QUANTITY, list(names))
    yield text_column("unit", UNIT, units)
    for key, text in (*STAGES.items(), ("left", N_("what orders 1 and 2 leave of the exact motion"))):
        numbers = [found.greatest(key, of) for of in names]
        yield Column(plain(key, "", Message(text), numbers).quantity, numbers, units=units)


# --- what balances the rest


def _remedies(found: Found) -> Iterator[Column]:
    rows = found.remedies
    yield text_column("of", QUANTITY, [one.of for one in rows])
    yield Orders.order.column([one.order for one in rows])
    yield text_column("kind", Message(N_("how it turns")), [one.kind for one in rows])
    units = [KINDS[one.of].product for one in rows]
    yield text_column("unit", UNIT, units)
    for size, angle, vectors in (
        (Weights.forward.quantity, Weights.forward_angle.quantity, [one.forward for one in rows]),
        (Weights.backward.quantity, Weights.backward_angle.quantity, [one.backward for one in rows]),
    ):
        sign = size.sign
        signs = [Symbol(sign.base, f"{KINDS[one.of].letter}{one.order}", sign.sup) for one in rows]
        yield Column(size, [abs(vector) for vector in vectors], signs, units)
        turned = [float(np.degrees(np.angle(v))) % 360 if v else np.nan for v in vectors]
        yield Column(angle, turned, units=["deg"] * len(rows))


def _firing(found: Found) -> Iterator[Column]:
    rows = found.firing
    yield text_column("cylinder", NAME, [one.name for one in rows])
    yield Firing.angle.column(np.degrees([one.angle for one in rows]))
    yield Firing.interval.column(np.degrees([one.interval for one in rows]))
