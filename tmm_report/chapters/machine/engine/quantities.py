"""The numbers of the balance of an engine of several cylinders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.machine.engine.drawn import LETTERS, UNITS, Star, stars
from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.chapters.machine.engine.values import values
from tmm_report.mechanics.masses.engine_cylinders import Turning, cranks
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, plain, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.tabulated import tabulated

__all__ = ["tables", "values"]

Array = Any

NAME = Message(N_("number of the cylinder"))
OF = {"force": N_("inertia force"), "couple": N_("moment of the inertia forces")}


@tabulated
def tables(found: Found) -> Iterator[Table]:
    yield Table("engine_cylinders", Message(N_("cylinders of the engine")), tuple(_cylinders(found)))
    yield Table("engine_orders", Message(N_("inertia forces and moments by orders")), tuple(_orders(found)))
    meaning = Message(N_("force and moment of order 1 with the masses that turn"))
    yield Table("engine_primary", meaning, tuple(_primary(found)))
    if rows := list(stars(found)):
        meaning = Message(N_("inertia forces and moments by the polygons of cranks"))
        yield Table("engine_polygons", meaning, tuple(_polygons(rows)))
    meaning = Message(N_("inertia force and moment over a turn of the crankshaft"))
    yield Table("engine_diagram", meaning, tuple(_diagram(found)))
    meaning = Message(N_("greatest inertia force and moment over a turn"))
    yield Table("engine_greatest", meaning, tuple(_greatest(found)))
    meaning = Message(N_("weights on shafts that balance what is left"))
    yield Table("engine_remedies", meaning, tuple(_remedies(found)))
    if found.firing:
        yield Table("engine_firing", Message(N_("order of firing")), tuple(_firing(found)))


# --- the cylinders


def _cylinders(found: Found) -> Iterator[Column]:
    names = [one.name for one in found.given.cylinders]
    yield text_column("cylinder", NAME, names)
    for key, base, unit, text, numbers in (
        (
            "beta",
            "beta",
            "deg",
            N_("angle of the cylinder's axis from the upward vertical"),
            np.degrees(found.banks),
        ),
        ("psi", "psi", "deg", N_("angle of the crank from that of angle 0"), np.degrees(found.angles) % 360),
        ("z", "z", "m", N_("place of the cylinder from the plane of the moments"), found.places),
    ):
        yield Quantity(key, Symbol(base), unit, Message(text)).column(numbers)
    for k in (1, 2):
        for sense, text, turned in zip(
            ("direct", "reverse"),
            (N_("angle of the direct crank of order %(k)s"), N_("angle of the reverse crank of order %(k)s")),
            cranks(k, found.banks, found.angles),
            strict=True,
        ):
            sign = Symbol("gamma", str(k), "" if sense == "direct" else "'")
            of = Quantity(f"{sense}_{k}", sign, "deg", Message(text, {"k": k}))
            yield of.column(np.round(np.degrees(turned) % 360, 9) % 360)


# --- by orders


def _orders(found: Found) -> Iterator[Column]:
    rows = found.orders
    names = [str(one.order) for one in rows]
    order = Quantity("order", Symbol("k"), "", Message(N_("order, turns for one of the crankshaft")))
    yield order.column([one.order for one in rows])
    series = Message(N_("coefficient of the series in λ"))
    yield _of_rows("c", Symbol("c"), "", series, [one.textbook for one in rows], names)
    exact = Message(N_("coefficient of the exact motion"))
    yield _of_rows("c_exact", Symbol("c'"), "", exact, [one.exact for one in rows], names)
    yield from _turning([one.force for one in rows], "force", names)
    yield from _turning([one.couple for one in rows], "couple", names)


def _of_rows(
    key: str, sign: Symbol, unit: str, meaning: Message, values: Any, names: Sequence[str]
) -> Column:
    symbols = [Symbol(sign.base, f"{name},{sign.sub}" if sign.sub else name, sign.sup) for name in names]
    return Column(Quantity(key, sign, unit, meaning), values, symbols)


PARTS = {
    "forward": N_("%(of)s, part that turns with the crankshaft"),
    "backward": N_("%(of)s, part that turns against the crankshaft"),
    "max": N_("%(of)s, greatest"),
    "min": N_("%(of)s, least"),
    "direction": N_("%(of)s, direction of the greatest from the axis x"),
}


def _turning(rows: Sequence[Turning], of: str, names: Sequence[str]) -> Iterator[Column]:
    letter, unit = LETTERS[of], UNITS[of]
    sizes = {
        "forward": (Symbol(letter, "", "+"), [abs(one.forward) for one in rows]),
        "backward": (Symbol(letter, "", "-"), [abs(one.backward) for one in rows]),
        "max": (Symbol(letter, "max"), [one.greatest for one in rows]),
        "min": (Symbol(letter, "min"), [one.least for one in rows]),
    }
    for key, (sign, numbers) in sizes.items():
        meaning = Message(PARTS[key], {"of": Message(OF[of])})
        yield _of_rows(f"{letter}_{key}", sign, unit, meaning, [float(x) for x in numbers], names)
    meaning = Message(PARTS["direction"], {"of": Message(OF[of])})
    turned = [float(np.degrees(one.direction)) for one in rows]
    yield _of_rows(f"{letter}_direction", Symbol("alpha", letter), "deg", meaning, turned, names)


def _primary(found: Found) -> Iterator[Column]:
    names = [name for name, *_ in found.stages]
    yield text_column("stage", Message(N_("masses taken together")), names)
    yield from _turning([force for _, force, _ in found.stages], "force", ["1"] * len(names))
    yield from _turning([couple for *_, couple in found.stages], "couple", ["1"] * len(names))


# --- polygons


def graph(star: Star) -> Quantity:
    """The greatest force or moment of an order, by the polygons."""
    text = (
        N_("greatest inertia force of order %(k)s")
        if star.of == "force"
        else N_("greatest moment of order %(k)s")
    )
    sign = Symbol(LETTERS[star.of], f"{star.order},max")
    return Quantity(
        f"{LETTERS[star.of]}_{star.order}_max", sign, UNITS[star.of], Message(text, {"k": star.order})
    )


def _polygons(rows: Sequence[Star]) -> Iterator[Column]:
    found = [graph(star) for star in rows]
    yield text_column("key", Message(N_("quantity")), [one.key for one in found])
    yield text_column("unit", Message(N_("its unit")), [one.unit for one in found])
    for key, text, lengths in (
        ("d_direct", N_("length of the sum of the direct cranks"), [star.direct_length for star in rows]),
        ("d_reverse", N_("length of the sum of the reverse cranks"), [star.reverse_length for star in rows]),
    ):
        sign = Symbol("d") if key == "d_direct" else Symbol("d'")
        own = [Symbol(sign.base, f"{LETTERS[star.of]}{star.order}") for star in rows]
        yield Column(Quantity(key, sign, "mm", Message(text)), lengths, own)
    graphs, exact = (np.array(numbers) for numbers in ([s.graph for s in rows], [s.analytic for s in rows]))
    with np.errstate(all="ignore"):
        delta = np.where(exact > 0, 200 * (graphs - exact) / (graphs + exact), np.nan)
    yield plain("graph", "", Message(N_("by the polygon")), graphs)
    yield plain("analytic", "", Message(N_("by calculation")), exact)
    yield plain("delta", "%", Message(N_("difference in per cent of the mean")), delta)


# --- over a turn

STAGES = {
    "before": N_("without counterweights"),
    "after": N_("with all masses"),
    "orders": N_("by orders 1 and 2"),
}


def _diagram(found: Found) -> Iterator[Column]:
    turn = Quantity("phi", Symbol("phi"), "deg", Message(N_("angle of the crankshaft")))
    yield turn.column(np.degrees(found.diagram["after"].phi))
    for name, course in found.diagram.items():
        for of, vectors in (("force", course.force), ("couple", course.couple)):
            meaning = Message(N_("%(of)s: %(when)s"), {"of": Message(OF[of]), "when": Message(STAGES[name])})
            letter = LETTERS[of]
            size = Quantity(f"{letter}_{name}", Symbol(letter), UNITS[of], meaning)
            yield from size.vector(vectors)


def _greatest(found: Found) -> Iterator[Column]:
    """A row each for the force and the moment."""
    names = ("force", "couple")
    yield text_column("of", Message(N_("quantity")), list(names))
    yield text_column("unit", Message(N_("its unit")), [UNITS[of] for of in names])
    for key, text in (*STAGES.items(), ("left", N_("what orders 1 and 2 leave of the exact motion"))):
        numbers = [found.greatest(key, of) for of in names]
        column = plain(key, "", Message(text), numbers)
        yield Column(column.quantity, numbers, units=[UNITS[of] for of in names])


# --- what balances the rest


def _remedies(found: Found) -> Iterator[Column]:
    rows = found.remedies
    yield text_column("of", Message(N_("quantity")), [one.of for one in rows])
    order = Quantity("order", Symbol("k"), "", Message(N_("order, turns for one of the crankshaft")))
    yield order.column([one.order for one in rows])
    yield text_column("kind", Message(N_("how it turns")), [one.kind for one in rows])
    units = ["kg·m" if one.of == "force" else "kg·m²" for one in rows]
    yield text_column("unit", Message(N_("its unit")), units)
    for key, sup, text, vectors in (
        (
            "forward",
            "+",
            N_("product of the weight that turns with the crankshaft"),
            [r.forward for r in rows],
        ),
        (
            "backward",
            "-",
            N_("product of the weight that turns against the crankshaft"),
            [r.backward for r in rows],
        ),
    ):
        signs = [Symbol("D", f"{LETTERS[one.of]}{one.order}", sup) for one in rows]
        of = Quantity(key, Symbol("D", "", sup), "", Message(text))
        yield Column(of, [abs(vector) for vector in vectors], signs, units)
        angle = Quantity(
            f"{key}_angle", Symbol("alpha", "", sup), "deg", Message(N_("its angle from x at angle 0"))
        )
        turned = [float(np.degrees(np.angle(v))) % 360 if v else np.nan for v in vectors]
        yield Column(angle, turned, units=["deg"] * len(rows))


def _firing(found: Found) -> Iterator[Column]:
    rows = found.firing
    yield text_column("cylinder", NAME, [one.name for one in rows])
    angle = Message(N_("angle of the crankshaft at which the cylinder fires, from the first"))
    yield Quantity("angle", Symbol("phi"), "deg", angle).column(np.degrees([one.angle for one in rows]))
    to_next = Message(N_("angle of the crankshaft to the next firing"))
    yield Quantity("interval", Symbol("Deltaphi"), "deg", to_next).column(
        np.degrees([one.interval for one in rows])
    )
