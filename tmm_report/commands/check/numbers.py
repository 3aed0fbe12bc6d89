"""The numbers of a sample: what is stored of them, and how they are compared.

Stored are the single values and every column of every table. Of a table with many rows (the diagrams, which show the
functions of the tables by positions at more angles, and the lists of a search) a summary stands for each column: how
many numbers are missing, the least, the greatest, the mean; so a stored file stays small and all is still watched.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.course import INITIAL_DATA, Results, chapters, room
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity.model import Column, Table
from tmm_report.records import dataclass

Cell = float | str | None
Array = Any

DIGITS = 13  # stored; the rest is rounding errors, which differ from machine to machine
MOST_ROWS = 40  # a table with more is summed up
SUMMARY = ("missing", "least", "greatest", "mean")
VALUES = "values"  # in the place of a table's name: the single values
FLOOR = 1e-6  # of the largest number of a table with the same unit: what is smaller is compared as if it were so large


@dataclass(frozen=True, eq=False)
class Sheet:
    """A table of the results, or the single values of a chapter, as stored. `labels`: of its rows; `units`: of each
    column, one for each row."""

    chapter: str
    name: str
    labels: tuple[str, ...]
    columns: Mapping[str, Sequence[Cell]]
    units: Mapping[str, Sequence[str]]


@dataclass(frozen=True)
class Tolerance:
    """How far a number may be off: a part of the largest of its column, or so much."""

    relative: float = 1e-9
    absolute: float = 1e-12


@dataclass(frozen=True)
class Tolerances:
    """`places`: of a table, "tables.rates_table", or of a column, "tables.rates_table.v_B", "values.H_B"."""

    common: Tolerance = Tolerance()
    places: Mapping[str, Tolerance] = field(default_factory=dict)

    def of(self, sheet: str, column: str) -> Tolerance:
        table = sheet if sheet == VALUES else f"tables.{sheet}"
        return self.places.get(f"{table}.{column}") or self.places.get(table) or self.common


@dataclass(frozen=True)
class Difference:
    """One thing that is not as it was. `size`: by how much, of `largest`; None where that says nothing."""

    chapter: str
    sheet: str
    column: str
    row: str
    old: str
    new: str
    size: float | None = None
    largest: float = 0.0

    @property
    def message(self) -> Message:
        values = {name: shown(value) for name, value in vars(self).items() if isinstance(value, str)}
        if self.size is None:
            return Message(N_("%(place)s: was %(old)s, is %(new)s"), {**values, "place": self._place(values)})
        part = self.size / self.largest if self.largest else math.inf
        values |= {"size": f"{self.size:.2g}", "part": f"{part:.1e}"}
        text = N_("%(place)s: was %(old)s, is %(new)s, difference %(size)s (%(part)s of the largest)")
        return Message(text, {**values, "place": self._place(values)})

    def _place(self, values: Mapping[str, str]) -> Message:
        if self.sheet == VALUES:
            return Message(N_("chapter %(chapter)s, value %(column)s"), values)
        if not self.row:
            return Message(N_("chapter %(chapter)s, table %(sheet)s, column %(column)s"), values)
        return Message(N_("chapter %(chapter)s, table %(sheet)s, row %(row)s, column %(column)s"), values)


# ---------------------------------------------------------------- what is stored


def sheets(results: Results) -> list[Sheet]:
    """All numbers and texts of the results, by chapters."""
    found = [(INITIAL_DATA, results.lever)] if results.lever is not None else []
    return [sheet for name, one in [*found, *chapters(results)] for sheet in _of_chapter(name, one)]


def _of_chapter(name: str, found: Any) -> Iterator[Sheet]:
    quantities = room(name, "quantities")
    values = list(quantities.values(found))
    if values:
        numbers = {value.key: [_cell(value.value)] for value in values}
        yield Sheet(name, VALUES, ("",), numbers, {value.key: [value.unit] for value in values})
    for table in quantities.tables(found):
        yield _summary(name, table) if len(table) > MOST_ROWS or _is_diagram(table) else _whole(name, table)


def _is_diagram(table: Table) -> bool:
    return table.name.endswith("_diagram")


def _whole(chapter: str, table: Table) -> Sheet:
    columns = {column.key: [_cell(x) for x in column.values] for column in table.columns}
    units = {column.key: _units(table, column) for column in table.columns}
    return Sheet(chapter, table.name, tuple(_labels(table)), columns, units)


def _units(table: Table, column: Column) -> list[str]:
    """The unit of each row: in a table whose rows are quantities it stands in a column of its own."""
    if "unit" in table and not column.unit and not column.units:
        return [str(unit) for unit in table["unit"].values]
    return [column.unit_of(row) for row in range(len(table))]


def _labels(table: Table) -> Iterable[str]:
    """What the rows are called: the number of the position, the first text; else they are counted from 1."""
    if "position" in table:
        return (str(k) for k in table["position"].values)
    texts = (column for column in table.columns if len(column.values) and isinstance(column.values[0], str))
    first = next(texts, None)
    return (str(k + 1) for k in range(len(table))) if first is None else (str(x) for x in first.values)


def _summary(chapter: str, table: Table) -> Sheet:
    numeric = [c for c in table.columns if c.key != "position" and not isinstance(c.values[0], str)]
    columns: dict[str, list[Cell]] = {"rows": [len(table), None, None, None]}
    columns |= {column.key: _summed(np.asarray(column.values, dtype=float)) for column in numeric}
    units = {column.key: [column.unit] * len(SUMMARY) for column in numeric}
    return Sheet(chapter, table.name, SUMMARY, columns, {"rows": [""] * len(SUMMARY), **units})


def _summed(x: Array) -> list[Cell]:
    known = x[np.isfinite(x)]
    if not known.size:
        return [len(x), None, None, None]
    return [len(x) - known.size, *(_kept(float(of)) for of in (known.min(), known.max(), known.mean()))]


def _cell(x: Any) -> Cell:
    if isinstance(x, str | bool):
        return x
    return int(x) if isinstance(x, int | np.integer) else _kept(float(x))


def _kept(x: float) -> float | None:
    """A number as it is stored: rounded, None for nan and infinity."""
    return float(f"{x:.{DIGITS - 1}e}") + 0.0 if math.isfinite(x) else None


# ---------------------------------------------------------------- comparing

Stored = Mapping[str, Mapping[str, Sequence[Cell]]]
"""Name of a table, or VALUES -> column -> cells."""


def differences(old: Stored, new: Sequence[Sheet], tolerances: Tolerances) -> list[Difference]:
    """Everything that is not as it was, in the order of the note; what is gone comes last."""
    found = [one for sheet in new for one in _of_sheet(old.get(sheet.name, {}), sheet, tolerances)]
    return [*found, *_gone(old, new)]


def _gone(old: Stored, new: Sequence[Sheet]) -> Iterator[Difference]:
    chapters_of = {sheet.name: sheet.chapter for sheet in new if sheet.name != VALUES}
    known = {(sheet.name, column) for sheet in new for column in sheet.columns}
    for name, columns in old.items():
        for column in columns:
            if (name, column) not in known:
                yield Difference(
                    chapters_of.get(name, NOTHING), name, column, "", _text(columns[column]), NOTHING
                )


NOTHING = "—"


def _of_sheet(
    old: Mapping[str, Sequence[Cell]], sheet: Sheet, tolerances: Tolerances
) -> Iterator[Difference]:
    for column, cells in sheet.columns.items():
        was = old.get(column)
        if was is None or len(was) != len(cells):
            before = NOTHING if was is None else _text(was)
            yield Difference(sheet.chapter, sheet.name, column, "", before, _text(cells))
            continue
        for row, (a, b) in enumerate(zip(was, cells, strict=True)):
            if a != b:
                yield from _of_cell(a, b, (old, sheet, column, row), tolerances)


def _of_cell(
    old: Cell, new: Cell, at: tuple[Mapping[str, Sequence[Cell]], Sheet, str, int], tolerances: Tolerances
) -> Iterator[Difference]:
    before, sheet, column, row = at
    place = (
        sheet.chapter,
        sheet.name,
        column,
        sheet.labels[row] if row < len(sheet.labels) else str(row + 1),
    )
    if not _is_number(old) or not _is_number(new):
        yield Difference(*place, _text(old), _text(new))
        return
    assert isinstance(old, int | float) and isinstance(new, int | float)
    size, largest = abs(new - old), _largest(before, sheet, column, row)
    allowed = tolerances.of(sheet.name, column)
    if not size <= max(allowed.relative * largest, allowed.absolute):
        yield Difference(*place, _text(old), _text(new), size, largest)


def _is_number(cell: Cell) -> bool:
    return isinstance(cell, int | float) and not isinstance(cell, bool)


def _largest(old: Mapping[str, Sequence[Cell]], sheet: Sheet, column: str, row: int) -> float:
    """The size against which a cell is compared: the largest of its column with its unit, then and now; of a component
    that of its vector; and never less than a small part of what the table has in that unit."""
    vector = column[:-2] if column.endswith(("_x", "_y")) and column[:-2] in sheet.columns else column
    unit = sheet.units[column][row]
    own = max(_sizes(sheet, old, key, unit) for key in (column, vector))
    return max(own, FLOOR * max(_sizes(sheet, old, key, unit) for key in sheet.columns)) if unit else own


def _sizes(sheet: Sheet, old: Mapping[str, Sequence[Cell]], column: str, unit: str) -> float:
    units = sheet.units[column]
    pairs = zip(units, sheet.columns[column], old.get(column, [None] * len(units)), strict=False)
    numbers = (x for of, *cells in pairs if of == unit for x in cells if _is_number(x))
    return max((abs(x) for x in numbers if isinstance(x, int | float)), default=0.0)


def _text(cell: Cell | Sequence[Cell]) -> str:
    """A cell in a message; of a column how many rows it has."""
    match cell:
        case None:
            return "null"
        case str() | bool():
            return str(cell)
        case int() | float():
            return f"{cell:.{DIGITS}g}"
        case [one]:
            return _text(one)
        case _:
            return f"[{len(cell)}]"
