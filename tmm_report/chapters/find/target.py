"""Which number of the results a demand names: a single one, or an extreme or a row of a column of a table."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.find.given import Demand
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.units import WrongValue, between
from tmm_report.records import dataclass

Chapter = tuple[str, Iterable[Table], Iterable[Value]]
"""Name of a chapter, its tables and single numbers."""

EXTREMES: Mapping[str, Any] = {"max": np.nanmax, "min": np.nanmin}
SOME = 6  # candidates that are named
NEAR = 0.5  # likeness of a name


@dataclass(frozen=True)
class Target:
    """`key`: of the single number, or `table.column`; `pick`: of a column "max", "min" or the number of a row;
    `table`: what its table shows."""

    chapter: str
    key: str
    quantity: Quantity
    pick: str = ""
    table: Message | None = None

    def number(self, chapters: Iterable[Chapter]) -> float:
        """The number in the results of a variant; nan where they have none."""
        for name, tables, values in chapters:
            if name == self.chapter:
                found = self._of(tables) if self.pick else self._single(values)
                return found if math.isfinite(found) else math.nan
        return math.nan

    def _single(self, values: Iterable[Value]) -> float:
        return next((float(value.value) for value in values if value.key == self.key), math.nan)

    def _of(self, tables: Iterable[Table]) -> float:
        name, _, key = self.key.partition(".")
        table = next((one for one in tables if one.name == name and key in one), None)
        return math.nan if table is None else _picked(table[key], self.pick)


def _picked(column: Column, pick: str) -> float:
    numbers = column.numbers()
    if pick in EXTREMES:
        return float(EXTREMES[pick](numbers)) if np.isfinite(numbers).any() else math.nan
    return float(numbers[int(pick)]) if int(pick) < numbers.size else math.nan


def target(demand: Demand, chapters: Sequence[Chapter]) -> Target:
    """Raises ProblemError: unknown, not unique, no number."""
    table, _, rest = demand.name.partition(".")
    if rest:
        return _in_table(demand, table, rest, chapters)
    own = {value.key: (name, value) for name, _, values in chapters for value in values}
    found = [demand.name] if demand.name in own else [key for key in own if key.endswith(f"_{demand.name}")]
    if len(found) == 1:
        chapter, value = own[found[0]]
        if isinstance(value.value, str):
            raise _wrong(N_("%(name)s is no number"), demand, Message(N_("name a number of the results")))
        return Target(chapter, found[0], value.quantity)
    if found:
        right = Message(N_("name one of %(words)s"), {"words": ", ".join(found[:SOME])})
        raise _wrong(N_("%(name)s may be several numbers of the results"), demand, right)
    raise _wrong(N_("the results have no number %(name)s"), demand, _nearest(demand.name, own))


def _in_table(demand: Demand, name: str, rest: str, chapters: Sequence[Chapter]) -> Target:
    own = {table.name: (chapter, table) for chapter, tables, _ in chapters for table in tables}
    if name not in own:
        raise _wrong(N_("the results have no table of %(name)s"), demand, _nearest(name, own))
    chapter, table = own[name]
    key, _, pick = rest.partition(".")
    columns = [column.key for column in table.columns]
    if key not in columns:
        wrong, right = N_("the table of %(name)s has no such column"), _nearest(key, columns, len(columns))
        raise _wrong(wrong, demand, right)
    pick = "0" if not pick and len(table) == 1 else pick
    if pick not in EXTREMES and not (pick.isdecimal() and int(pick) < len(table)):
        right = Message(N_("add .max, .min or the number of a row, 0 … %(last)s"), {"last": len(table) - 1})
        raise _wrong(N_("%(name)s is a column and not one number"), demand, right)
    column, quantity = table[key], table[key].quantity
    if any(isinstance(one, str) for one in column.values):
        raise _wrong(N_("%(name)s is no number"), demand, Message(N_("name a number of the results")))
    if column.units:
        if pick in EXTREMES:
            right = Message(N_("add the number of a row, 0 … %(last)s"), {"last": len(table) - 1})
            raise _wrong(N_("the rows of %(name)s measure different things"), demand, right)
        quantity = replace(quantity, unit=column.unit_of(int(pick)))
    return Target(chapter, f"{name}.{key}", quantity, pick, table.meaning)


def level(demand: Demand, of: Target) -> float:
    """The wanted number in the unit of the results. Raises ProblemError for one of another kind."""
    if not demand.unit:
        return demand.level
    try:
        return demand.level * between(demand.unit, of.quantity.unit)
    except WrongValue as error:
        example = Message(
            N_("write for example %(text)s"), {"text": f"{demand.level:g} {of.quantity.unit}".strip()}
        )
        raise ProblemError([Problem(error.wrong, error.right or example, demand.path)]) from None


def _wrong(text: str, demand: Demand, right: Message | None) -> ProblemError:
    return ProblemError([mistake(text, demand.path, right, name=shown(demand.name, 80))])


def _nearest(name: str, known: Iterable[str], most: int = SOME) -> Message:
    """The known names that are like one, by what they have in common or by their endings; else the first of them."""
    known = list(known)
    alike = list(dict.fromkeys([*_having(name, known), *difflib.get_close_matches(name, known, SOME, NEAR)]))
    words = shown(", ".join(alike[:SOME] or known[:most]), 200)
    if alike:
        return Message(N_("near it are %(words)s; all stand in results.json"), {"words": words})
    return Message(N_("all stand in results.json, for example %(words)s"), {"words": words})


def _having(name: str, known: Iterable[str]) -> Iterator[str]:
    parts = {part for part in name.casefold().split("_") if len(part) > 2}
    yield from (one for one in known if parts & set(one.casefold().split("_")))
