"""Which number of the results a person asks about: v_B at position 7, the stroke, the diameters of a stage's wheels."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

from tmm_report.course import Results
from tmm_report.grading.expected import reversed_reactions
from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.quantity.model import Column, Quantity, Table
from tmm_report.quantity.naming import one, resolve
from tmm_report.records import dataclass
from tmm_report.results import tables, values


@dataclass(frozen=True, eq=False)
class Target:
    """What is asked: a column at a position, a single value, or a column of a table of things at all its rows."""

    quantity: Quantity
    table: Table | None = None
    position: int | None = None
    value: float = math.nan  # of a single one

    @property
    def by_position(self) -> bool:
        return self.table is not None and "position" in self.table

    @property
    def worked(self) -> bool:
        """Whether these are numbers worked by hand, of which each is a row."""
        return self.table is not None and "key" in self.table and self.quantity.key == "value"

    @property
    def column(self) -> Column:
        """All its numbers."""
        return self.table[self.quantity.key] if self.table is not None else self.quantity.column([self.value])

    @property
    def rows(self) -> list[int]:
        """Of the table, those asked for: none where it has not the position."""
        if self.position is None:
            return list(range(len(self.column.values)))
        assert self.table is not None
        return [k for k, at in enumerate(self.table["position"].values) if int(at) == self.position]

    @property
    def numbers(self) -> list[float]:
        """Those asked for: one, or of a table of things all; none of texts."""
        if is_text(self.column):
            return []
        return [float(self.column.values[row]) for row in self.rows] or [math.nan]

    @property
    def texts(self) -> list[str]:
        return [str(self.column.values[row]) for row in self.rows] if is_text(self.column) else []

    @property
    def name(self) -> str:
        """Where it stands in results.json."""
        return (
            f"tables.{self.table.name}.{self.quantity.key}" if self.table else f"values.{self.quantity.key}"
        )


def find(results: Results, text: str, position: int | None) -> Target:
    """The number that a name, alone or behind the name of its table, means.

    Raises ProblemError for what is unknown, and for a position that is missing, needless or not there.
    """
    table, _, key = text.rpartition(".")
    every = list(_all(results, table))
    if table and not every:
        raise ProblemError([_no_table(table, results)])
    by_position = [target for target in every if target.by_position]
    if position is None or not resolve(key, [target.quantity for target in by_position]):
        by_position = [*(target for target in every if not target.by_position), *by_position]
    known = [target.quantity for target in by_position]
    quantity = one(key if resolve(key, known) else _turned(results, key), known, ("quantity",))
    return _placed(next(target for target in by_position if target.quantity is quantity), position)


def _turned(results: Results, key: str) -> str:
    """Of the reaction of link b on link a that of a on b, which the results have; any other name as it is."""
    both = reversed_reactions(results)
    meant = resolve(key, [quantity for quantity, _ in both])
    return next((name[1] for quantity, name in both if [quantity] == meant), key)


def _all(results: Results, table: str) -> Iterator[Target]:
    """Every number and column that may be asked for; with the name of a table all of its own, without one those that
    are told by their names alone."""
    for value in values(results) if not table else ():
        yield Target(value.quantity, value=float(value.value))
    for t in tables(results):
        if table == t.name:
            yield from (Target(column.quantity, t) for column in t.columns)
        elif not table and "key" not in t and not t.name.endswith("_diagram"):
            asked = (c for c in t.columns if c.key not in ("position", "phi") and not is_text(c))
            yield from (Target(column.quantity, t) for column in asked)


def is_text(column: Column) -> bool:
    return len(column.values) > 0 and isinstance(column.values[0], str)


def _placed(target: Target, position: int | None) -> Target:
    """The target at a position. Raises ProblemError where that is missing, needless or not in the table."""
    key = {"key": target.quantity.key}
    if not target.by_position or target.table is None:
        if position is None:
            return target
        text = N_("%(key)s is one number for all positions")
        raise _wrong(Message(text, key), Message(N_("leave the position out")))
    last = max(int(k) for k in target.table["position"].values)
    if position is None:
        text = N_("%(key)s is found at positions: state which one")
        raise _wrong(Message(text, key), Message(N_("from 0 to %(last)s"), {"last": last}))
    if not 0 <= position <= last and not target.table.name.startswith(OF_PLANS):
        text = N_("there is no position %(position)s: the table has positions 0 to %(last)s")
        raise _wrong(Message(text, {"position": position, "last": last}))
    return replace(target, position=position)


OF_PLANS = ("segments_", "plan_values_")  # tables that have the positions of the plans alone


def _wrong(wrong: Message, right: Message | None = None) -> ProblemError:
    return ProblemError([Problem(wrong, right, ("position",))])


def _no_table(name: str, results: Results) -> Problem:
    wrong = Message(N_("the results have no table %(name)s"), {"name": shown(name)})
    words = ", ".join(table.name for table in tables(results))
    return Problem(wrong, Message(N_("known: %(words)s"), {"words": words}), ("quantity",))
