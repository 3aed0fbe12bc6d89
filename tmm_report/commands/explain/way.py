"""How a number is found that the formulas of the note do not define, or only approach: by its chapter's `ways`."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from typing import Any

import numpy as np

from tmm_report.commands.explain.target import Target
from tmm_report.course import Results, room, with_data
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Book
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.ways import Input, Known, Line, OwnWays, Way, by_kind, formula, telling
from tmm_report.records import dataclass
from tmm_report.results import tables, values


@dataclass(frozen=True, eq=False)
class Told:
    """A way as it is told: what it starts with, what is worked out with numbers, and its formulas, row by row of those
    asked for."""

    way: Way
    inputs: list[list[Input]]
    worked: list[Line]
    formulas: list[Formula]

    @property
    def says(self) -> bool:
        """Whether it says more than that there is a method."""
        return bool(self.worked or self.formulas) or any(self.inputs) or self.way.ends


@dataclass(frozen=True, eq=False)
class Ways:
    """The ways to all the numbers of the results."""

    results: Results
    book: Book

    @classmethod
    def of(cls, results: Results) -> Ways:
        return cls(results, Book.of(tables(results), values(results)))

    def told(self, target: Target) -> Told | None:
        """The way to a number: the first that says with which numbers; None where its chapter has none."""
        chapter, found = self._chapter(target)
        own, name = OwnWays(room(chapter, "ways").WAYS), target.name.partition(".")[2]
        kind = by_kind(target.table, target.column, target.quantity.key)
        of_kind = [(kind, ())] if kind is not None else []
        return telling(
            self._one(target, found, own, way, parts) for way, parts in chain(own.of(name), of_kind)
        )

    def _one(self, target: Target, found: Any, own: OwnWays, way: Way, parts: tuple[str, ...]) -> Told:
        rows: list[int | None] = [*target.rows] if target.table is not None else [None]
        known = [Known(self.book, target.table, row, parts, target.quantity.key, found) for row in rows]
        names = list(own.begins(way, known[0])) if known else []
        inputs = [list(one.inputs(names)) for one in known]
        worked = [line for one in known for line in way.worked(found, one)] if way.worked is not None else []
        formulas = list(chain.from_iterable(_formula(way, target, one) for one in known))
        return Told(way, inputs, worked, formulas)

    def _chapter(self, target: Target) -> tuple[str, Any]:
        """The name and the Found of the chapter that a number is of."""
        return self._of[target.table.name if target.table is not None else f"values.{target.quantity.key}"]

    @cached_property
    def _of(self) -> dict[str, tuple[str, Any]]:
        """Of every table and every single value the chapter that it is of."""
        found: dict[str, tuple[str, Any]] = {}
        for name, own in with_data(self.results):
            quantities = room(name, "quantities")
            found |= dict.fromkeys((table.name for table in quantities.tables(own)), (name, own))
            found |= dict.fromkeys((f"values.{value.key}" for value in quantities.values(own)), (name, own))
        return found


def _formula(way: Way, target: Target, known: Known) -> Iterator[Formula]:
    """Of a number that is there: names have no formula."""
    row = known.row or 0
    if way.by is not None and np.isfinite(float(target.column.values[row])):
        named = target.quantity.symbol is not None
        symbol = target.column.symbol(known.row) if named else Symbol(target.quantity.key)
        yield from formula(way, known, symbol, target.column.unit_of(row))
