"""How a number is found that no formula of the note defines: from which other numbers, by which formula or method.

A chapter's room `ways` lists them for its own numbers, in `WAYS`; the first that fits, and whose numbers the variant
has, is taken:

    Way("flywheel_C_E", by=lambda q: q("flywheel_dE") / q("flywheel_W"))
    Way("strokes.ends", N_("Where the stroke that is stated ends: ..."), of="begins phi_cycle")
    Way("engine_r engine_l", STATED)

Names are those of results.json: `key` of a single value, `table.key` of a column. A star stands for any text, and `{0}`
in what a way is made of for what the first star stands for. A table of the diagram positions goes by its table.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Any, NamedTuple, Protocol, TypeVar

import numpy as np

from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Var, sqrt
from tmm_report.quantity.model import Book, Column, Quantity, Table, variable
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation
from tmm_report.records import dataclass

STATED = N_("Given: the variant states it, or leaves the usual value.")
NAME = N_("A name: it says of what the row is.")
COUNTED = N_("A number that counts the rows.")
AXIS = N_(
    "The places at which the table is worked out: from the first to the last in steps chosen beforehand."
)
GIVEN = (STATED, NAME, COUNTED, AXIS)  # what needs no inputs


class Input(NamedTuple):
    """A number with which a way starts: its quantity, and the number or text. `row`: None of a single one."""

    quantity: Quantity
    number: float | str
    unit: str
    symbol: Symbol | None


Line = Message | Formula | Equation | Input


class Says(Protocol):
    @property
    def says(self) -> bool:
        """Whether it says more than that there is a method."""


T = TypeVar("T", bound=Says)


@dataclass(frozen=True, eq=False)
class Way:
    """How the numbers named by `keys` are found.

    `text`: the method in a sentence; `of`: names of the numbers that it starts with; those that a variant has not are
    passed over. `by`: the formula. `worked`: what is written out with numbers, from what the chapter found. `beside`:
    it is told beside the formulas of the note, too, as these only approach the number. `enough`: the sentence says all,
    for what is counted or looked up.
    """

    keys: str
    text: str = ""
    of: str = ""
    by: Callable[[Known], Expr] | None = None
    worked: Callable[[Any, Known], Iterable[Line]] | None = None
    beside: bool = False
    enough: bool = False

    @property
    def ends(self) -> bool:
        """Whether it needs no inputs."""
        return self.enough or self.text in GIVEN


def fits(pattern: str, name: str) -> tuple[str, ...] | None:
    """What the stars of a pattern stand for in a name, each for as much as it can but for no dot; None where it is not
    meant. Without `re`: each way would be compiled for the few names that it is asked for."""
    start, *rest = pattern.split("*")
    if not rest:
        return () if name == start else None
    return _stars(rest, name[len(start) :]) if name.startswith(start) else None


def _stars(parts: list[str], name: str) -> tuple[str, ...] | None:
    """What stands before each of the parts."""
    part, *others = parts
    at = len(name) - len(part) if not others else name.rfind(part)
    while at >= 0:
        before, behind = name[:at], name[at + len(part) :]
        if "." not in before and name.startswith(part, at):
            found = _stars(others, behind) if others else ()
            if found is not None:
                return (before, *found)
        at = name.rfind(part, 0, at + len(part) - 1) if others and at + len(part) > 0 else -1
    return None


def summed(prefix: str, but: str = "") -> Callable[[Known], Expr]:
    """The sum of what stands beside a number in its table, by the beginning of the keys; `but`: a key that is no
    part of it."""

    def total(q: Known) -> Expr:
        assert q.table is not None
        keys = [one.key for one in q.table.columns if one.key.startswith(prefix) and one.key != but]
        if not keys:
            raise KeyError(prefix)
        first, *others = [q(key) for key in keys]
        return sum(others, first)

    return total


class OwnWays:
    """The ways of a chapter by the names of its numbers: hundreds of them are asked for one after another."""

    def __init__(self, ways: Iterable[Way]):
        self.whole: dict[str, list[_Named]] = {}
        self.starred: dict[
            str, list[_Named]
        ] = {}  # by the table and the first letter of the key, before any star
        for number, way in enumerate(ways):
            for k, key in enumerate(way.keys.split()):
                start, *rest = key.split("*")
                table, dot, begun = start.partition(".")
                place = f"{table}.{begun[:1]}" if dot else table[:1] if "." not in key else ""
                home, place = (self.starred, place) if rest else (self.whole, key)
                home.setdefault(place, []).append(
                    _Named((number, k), key, start, rest[-1] if rest else "", way)
                )

    def of(self, name: str) -> Iterator[tuple[Way, tuple[str, ...]]]:
        """The ways that fit a number, in their order, and what their stars stand for."""
        table, _, key = name.rpartition(".")
        names = (
            [name, f"{table.removesuffix('_diagram')}_table.{key}"] if table.endswith("_diagram") else [name]
        )
        found: dict[int, tuple[Way, tuple[str, ...]]] = {}
        for one in names:
            for near in self._near(one):
                number, _ = near.order
                if number not in found and (parts := fits(near.pattern, one)) is not None:
                    found[number] = near.way, parts
        return (found[number] for number in sorted(found))

    def begins(self, way: Way, known: Known) -> Iterator[str]:
        """Names of what a way starts with: what it finds itself, all together, it does not start with."""
        for name in known.named(way.of):
            own = known.table is not None and name in known.table
            whole = f"{known.table.name}.{name}" if own and known.table is not None else name
            if next((one for one, _ in self.of(whole)), None) is not way:
                yield name

    def _near(self, name: str) -> list[_Named]:
        """Names that may fit."""
        table, _, key = name.partition(".")
        places = dict.fromkeys((f"{table}.{key[:1]}", f"{table}.", table[:1] if not key else "", ""))
        every = [*self.whole.get(name, ()), *(one for place in places for one in self.starred.get(place, ()))]
        near = (one for one in every if name.startswith(one.start) and name.endswith(one.end))
        return sorted(near, key=lambda one: one.order)


class _Named(NamedTuple):
    """A way by one of its names; with what this begins and ends."""

    order: tuple[int, int]
    pattern: str
    start: str
    end: str
    way: Way


def telling(every: Iterable[T]) -> T | None:
    """Of what is told of a number by its ways the first that says with which numbers, else the first."""
    first = None
    for one in every:
        if one.says:
            return one
        first = first or one
    return first


def formula(way: Way, known: Known, symbol: Symbol, unit: str) -> Iterator[Formula]:
    """The formula of a way, where the variant has what it is made of, and the number is there."""
    if way.by is None:
        return
    with suppress(KeyError), np.errstate(invalid="ignore", divide="ignore"):
        made = Formula(symbol, way.by(known), unit, scale=0.0)
        if np.isfinite(made.value):
            yield made


@dataclass(frozen=True, eq=False)
class Known:
    """The numbers of the results by their names, as those of a row of a table have them: of it first, then of all.

    `parts`: what the stars of the way stand for. Raises KeyError for a number that is not there.
    """

    book: Book
    table: Table | None = None
    row: int | None = None
    parts: tuple[str, ...] = ()
    own: str = ""
    found: Any = None

    def __call__(self, name: str, mark: str = "") -> Var:
        """The number as a variable of a formula; `mark` goes to its index."""
        found = self._input(name.format(*self.parts))
        if isinstance(found.number, str):
            raise KeyError(f"{name} is a text")
        symbol = found.symbol or Symbol(found.quantity.key)
        if mark:
            symbol = replace(symbol, sub=",".join(filter(None, (symbol.sub, mark))))
        return variable(found.quantity, found.number, found.unit, symbol=symbol)

    def own_text(self, name: str) -> str:
        """A text."""
        return str(self._input(name.format(*self.parts)).number)

    def at(self, name: str, mark: str) -> Var:
        """The angle turned at which a single value is reached."""
        value = self.book.values[name.format(*self.parts)]
        if value.at is None:
            raise KeyError(f"{name} has no angle")
        return Var(Symbol("phi", mark), value.at, "deg", meaning=value.meaning)

    def there(self, name: str, key: str, position: int) -> Var:
        """A number of a table at a position."""
        table = self.book.tables[name]
        if key not in table:
            raise KeyError(key)
        at = [int(k) for k in table["position"].values].index(position)
        return table.var(key, at)

    def shown(self, name: str, key: str, position: int) -> Iterator[Input]:
        """The same to be shown, where it is there."""
        table = self.book.tables.get(name)
        if table is not None and key in table:
            yield _cell(table, key, [int(k) for k in table["position"].values].index(position))

    @property
    def fine(self) -> bool:
        """Whether it is a table of the diagram positions."""
        return self.table is not None and self.table.name.endswith("_diagram")

    @property
    def position(self) -> int:
        """Of its row. Raises KeyError for what has none."""
        if self.table is None or self.row is None:
            raise KeyError("position")
        return int(self.table["position"].values[self.row])

    def has(self, name: str) -> bool:
        """Whether there is such a number."""
        try:
            number = self._input(name.format(*self.parts)).number
        except KeyError:
            return False
        return isinstance(number, str) or number == number

    def _input(self, name: str) -> Input:
        """Raises KeyError."""
        table, _, key = name.rpartition(".")
        if not table and self.table is not None and key in self.table and self.row is not None:
            return _cell(self.table, key, self.row)
        if not table:
            value = self.book.values[key]
            return Input(value.quantity, value.value, value.unit, value.quantity.symbol)
        return self._elsewhere(table, key)

    def _elsewhere(self, name: str, key: str) -> Input:
        name, _, row = name.partition(":")
        if self.table is not None and self.table.name.endswith("_diagram") and name.endswith("_table"):
            fine = f"{name.removesuffix('_table')}_diagram"
            name = fine if fine in self.book.tables else name
        table = self.book.tables[name]
        if row or len(table) == 1:
            return _cell(table, key, _row_of(table, row) if row else 0)
        if self.table is None or self.row is None or "position" not in self.table or "position" not in table:
            raise KeyError(f"{name}.{key}")
        at = [int(k) for k in table["position"].values]
        position = int(self.table["position"].values[self.row])
        if position not in at:
            raise KeyError(f"{name}.{key} {position}")
        return _cell(table, key, at.index(position))

    def named(self, names: str) -> list[str]:
        """The names of what a way is made of, those of every row alike; a star in a name stands for any text."""
        return [one for name in names.split() for one in self._named(name.format(*self.parts))]

    def inputs(self, names: Iterable[str]) -> Iterator[Input]:
        """Those of the names that are there."""
        for name in names:
            try:
                yield self._input(name)
            except KeyError:
                continue

    def _named(self, name: str) -> list[str]:
        if "*" not in name:
            return [name]
        table, _, key = name.rpartition(".")
        if table and table.partition(":")[0] in self.book.tables:
            known: Iterable[str] = (
                f"{table}.{c.key}" for c in self.book.tables[table.partition(":")[0]].columns
            )
        elif (
            not table
            and self.table is not None
            and any(fits(key, c.key) is not None for c in self.table.columns)
        ):
            known = (c.key for c in self.table.columns)
        else:
            known = self.book.values
        begin = name.partition("*")[0]
        return [
            one for one in known if one.startswith(begin) and fits(name, one) is not None and one != self.own
        ]


def _cell(table: Table, key: str, row: int) -> Input:
    column = table[key]
    number = column.values[row]
    symbol = column.symbol(row) if column.quantity.symbol is not None else None
    return Input(
        column.quantity, number if isinstance(number, str) else float(number), column.unit_of(row), symbol
    )


def _row_of(table: Table, name: str) -> int:
    """The row that a name in the first column of texts means."""
    labels = next(c for c in table.columns if len(c.values) and isinstance(c.values[0], str))
    if name not in list(labels.values):
        raise KeyError(f"{table.name}:{name}")
    return list(labels.values).index(name)


# ---------------------------------------------------------------- by the kind of a number

OWN = "*.*"
SIZE = N_("The size of the vector by its projections.")
PROJECTED = N_("The projection of the vector on the axis: its size is that of both projections together.")
STEP = N_("Equal steps of the cycle: the number of the position by the step.")


def by_kind(table: Table | None, column: Column, key: str) -> Way | None:
    """The way that follows from what a number is, whatever chapter it is of."""
    if table is None:
        return None
    if len(column.values) and isinstance(column.values[0], str):
        return Way(OWN, NAME)
    if key == "position":
        return Way(OWN, COUNTED)
    if key == "phi" and "position" in table and len(table) > 1:
        return Way(OWN, STEP, by=lambda q: q("position") * _step(table))
    if f"{key}_x" in table and f"{key}_y" in table:
        return Way(OWN, SIZE, by=lambda q: _size(q(f"{key}_x"), q(f"{key}_y")))
    vector = key[:-2]
    if key.endswith(("_x", "_y")) and vector in table:
        return Way(OWN, PROJECTED, of=f"{vector} {vector}_{'y' if key.endswith('x') else 'x'}")
    return None


def _step(table: Table) -> Var:
    phi = table["phi"]
    step = float(phi.values[-1]) / float(table["position"].values[-1])
    return Var(Symbol("phi", "1"), np.radians(step) if phi.unit == "deg" else step, phi.unit)


def _size(x: Var, y: Var) -> Expr:
    return sqrt(x**2 + y**2)
