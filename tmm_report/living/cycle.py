"""The positions of the note as the script has them: those of the tables and of the diagrams in one row, and the columns
of all tables over these."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping
from functools import cached_property
from itertools import groupby
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.quantities.positions import reaction
from tmm_report.course import Results
from tmm_report.i18n import Translator
from tmm_report.quantity.model import Column, Table
from tmm_report.quantity.text import unit_text
from tmm_report.records import dataclass
from tmm_report.report.plain import Plain
from tmm_report.results import tables

Array = Any
DIGITS = 6  # of the largest number of a column: one more than is printed
SIGHT = 5  # of what is only drawn
SAME = 1e-9  # rad: nearer angles are one position
ASIDE = ("position", "phi", "t")


@dataclass(frozen=True, eq=False)
class Positions:
    """Positions `turned` (Q,), rad, ascending. `chosen`: their places among those of the table, then of the diagram;
    `numbered`: the place in `turned` of each table position; `pairs`: tables over both, by their common name;
    `closed`: whether behind the last comes the first."""

    turned: Array
    chosen: Array
    numbered: Array
    pairs: Mapping[str, tuple[Table, Table]]
    closed: bool

    def merged(self, of_table: Array, of_diagram: Array) -> Array:
        """Values of the table and of the diagram positions, (..., Q)."""
        return np.concatenate([of_table, of_diagram], axis=-1)[..., self.chosen]

    @cached_property
    def vectors(self) -> dict[str, Array]:
        return vectors_of(self)

    def said(
        self,
        tr: Translator,
        shown: Container[str],
        vectors: Mapping[str, Array],
        turning: Mapping[str, Array],
    ) -> dict[str, Any]:
        """For the script: columns whose keys are `shown` on the page, the `vectors` that are drawn, and the couples,
        `turning`, of which only the sense is drawn."""
        return {
            "at": numbers(np.degrees(self.turned)),
            "numbered": self.numbered.tolist(),
            "closed": self.closed,
            "columns": {
                name: [self._column(one, other, tr) for _, one, other in group]
                for name, group in groupby(self.told(shown), lambda row: row[0])
            },
            "vectors": {
                key: [numbers(one.real, SIGHT), numbers(one.imag, SIGHT)]
                for key, one in vectors.items()
            },
            "turning": {key: numbers(one, SIGHT) for key, one in turning.items()},
        }  # fmt: skip

    def told(self, shown: Container[str]) -> Iterator[tuple[str, Column, Column]]:
        """Name of the tables, column of the table and of the diagram positions: of those `shown` that are no axes, no
        texts and no projections of vectors."""
        for name, (one, other) in self.pairs.items():
            for column in one.columns:
                key = column.key
                projected = key[-2:] in ("_x", "_y") and key[:-2] in self.vectors
                if key in shown and key not in ASIDE and key in other and not (projected or _is_text(column)):
                    yield name, column, other[key]

    def values(self, one: Column, other: Column) -> Array:
        """In the unit of print, (Q,)."""
        unit = one.quantity.printed
        return self.merged(one.numbers(unit), other.numbers(unit))

    def _column(self, one: Column, other: Column, tr: Translator) -> dict[str, Any]:
        unit = one.quantity.printed
        sign = Plain(tr).symbol(one.quantity.symbol) if one.quantity.symbol is not None else one.key
        values = numbers(self.values(one, other))
        return {"key": one.key, "sign": sign, "unit": unit_text(unit, tr.language), "values": values}


def vectors_of(positions: Positions) -> dict[str, Array]:
    """Key -> complex (Q,), SI, of all vectors in the results."""
    found: dict[str, Array] = {}
    for one, other in positions.pairs.values():
        for key in (column.key for column in one.columns):
            if key in one and f"{key}_x" in one and f"{key}_y" in one and f"{key}_x" in other:
                x, y = (
                    positions.merged(one[k].numbers(), other[k].numbers()) for k in (f"{key}_x", f"{key}_y")
                )
                found[key] = x + 1j * y
    return found


@dataclass(frozen=True, eq=False)
class Cycle(Positions):
    """Those of a lever mechanism."""

    kinematics: Kinematics

    def both(self, of: Callable[..., Array], *named: Any) -> Array:
        """What the motion has of what is named, at the positions, (Q,)."""
        k = self.kinematics
        return self.merged(*(np.broadcast_to(of(m, *named), m.shape) for m in (k.table, k.diagram)))

    @cached_property
    def vectors(self) -> dict[str, Array]:
        """Reactions turned round are among them."""
        found = vectors_of(self)
        links = list(self.kinematics.linkage.mechanism.links)
        for by in links:
            for on in links:
                if (turned := reaction(on, by).key) in found:
                    found.setdefault(reaction(by, on).key, -found[turned])
        return found


def _is_text(column: Column) -> bool:
    return len(column.values) > 0 and isinstance(column.values[0], str)


def numbers(values: Array, digits: int = DIGITS) -> list[float | None]:
    """To so many digits of the largest of them; what is not there is null."""
    values = np.asarray(values, dtype=float)
    there = np.isfinite(values)
    largest = float(np.max(np.abs(values), initial=0.0, where=there))
    places = digits - 1 - int(np.floor(np.log10(largest))) if largest > 0 else 0
    rounded = np.round(np.where(there, values, 0.0), min(max(places, 0), 15)) + 0.0
    whole = (int(x) if x == int(x) else x for x in rounded.tolist())
    return [x if ok else None for x, ok in zip(whole, there.tolist(), strict=True)]


def places(values: Array, digits: int) -> list[float | None]:
    """Rounded to so many decimals."""
    values = np.asarray(values, dtype=float)
    there = np.isfinite(values)
    rounded = (np.round(np.where(there, values, 0.0), digits) + 0.0).tolist()
    return [x if ok else None for x, ok in zip(rounded, there.tolist(), strict=True)]


def cycle_of(results: Results) -> Cycle | None:
    """None of a variant without a lever mechanism."""
    if results.lever is None:
        return None
    found = results.lever.kinematics
    every = np.concatenate([found.turned, found.diagram_turned])
    order = np.argsort(every, kind="stable")
    apart = np.diff(every[order], prepend=-1.0) > SAME
    chosen = order[apart]
    turned = every[chosen]
    numbered = np.searchsorted(turned, found.turned - SAME)
    closed = bool(found.cycle.closed)
    sizes = len(found.turned), len(found.diagram_turned)
    by_name = {table.name: table for table in tables(results)}
    pairs = {
        name.removesuffix("_table"): (table, other)
        for name, table in by_name.items()
        if name.endswith("_table") and (other := by_name.get(name.removesuffix("_table") + "_diagram")) is not None
        and (len(table), len(other)) == sizes
    }  # fmt: skip
    return Cycle(turned, chosen, numbered, pairs, closed, found)


EVEN = 12  # positions of what turns evenly


def positions_of(results: Results) -> Positions:
    """Of a variant without a lever mechanism: those of its first tables over the angle, else of one turn."""
    by_name = {table.name: table for table in tables(results)}
    pairs = {
        name.removesuffix("_table"): (table, other)
        for name, table in by_name.items()
        if name.endswith("_table") and (other := by_name.get(name.removesuffix("_table") + "_diagram")) is not None
        and "phi" in table and "phi" in other
    }  # fmt: skip
    if not pairs:
        turned = np.linspace(0, 2 * np.pi, EVEN + 1)
        return Positions(turned, np.arange(EVEN + 1), np.arange(EVEN + 1), {}, True)
    first = next(iter(pairs.values()))
    one, other = (np.radians(table["phi"].numbers("deg")) for table in first)
    sizes = len(one), len(other)
    every = np.concatenate([one, other])
    order = np.argsort(every, kind="stable")
    chosen = order[np.diff(every[order], prepend=-1.0) > SAME]
    turned = every[chosen]
    turns = (turned[-1] - turned[0]) / (2 * np.pi)
    same = {name: pair for name, pair in pairs.items() if tuple(map(len, pair)) == sizes}
    closed = bool(turns > 0.5 and abs(turns - round(turns)) < SAME)
    return Positions(turned, chosen, np.searchsorted(turned, one - SAME), same, closed)
