"""What a number of the results is: a quantity with its key, symbol, unit and meaning; columns, tables, single values.

A quantity is defined once, in the `quantities.py` of its chapter. results.json, CSV, the note and its formulas take
symbol, unit and meaning from there; a printed number keeps a `Ref`, by which it is found in results.json again.

    speed = Quantity("v_B", Symbol("v", "B"), "m/s", Message(N_("velocity of point %(name)s"), {"name": "B"}))
    rates = Table("rates_table", RATES, (position, speed.column(values)))
    rates.var("v_B", 7)          # in a formula: v_B, its number at position 7, and where that number stands
"""

from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from dataclasses import field, replace
from functools import cached_property, lru_cache
from typing import Any, ParamSpec, TypeVar, cast

import numpy as np

from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.units import factor
from tmm_report.records import dataclass

Array = Any
Texts = Sequence[str]
Names = ParamSpec("Names")
Made = TypeVar("Made")


def kept(make: Callable[Names, Made]) -> Callable[Names, Made]:
    """What makes quantities of names, so that it makes each once: what is found out about a quantity stays with it."""
    return cast(Callable[Names, Made], lru_cache(maxsize=1024)(make))


@dataclass(frozen=True)
class Quantity:
    """`key`: its name in the results; `symbol`: how it is written, None of names and other texts; `unit`: of its
    numbers in the results, "" of pure numbers and texts; `shown`: unit in which the note prints it, where that is
    another one."""

    key: str
    symbol: Symbol | None
    unit: str
    meaning: Message
    shown: str = ""

    @property
    def sign(self) -> Symbol:
        """The symbol. Raises ValueError for what is never written as one."""
        if self.symbol is None:
            raise ValueError(f"{self.key} has no symbol")
        return self.symbol

    @property
    def printed(self) -> str:
        """The unit in which the note prints it."""
        return self.shown or self.unit

    def column(self, values: Array | Texts) -> Column:
        """Its numbers (P,), or a list of texts, one for each row of a table."""
        return Column(self, values)

    def value(self, number: float, at: float | None = None, side: int = 0) -> Value:
        """One number; `at`: the angle turned from position 0 at which it holds, rad, `side`: see `Value`."""
        return Value(self, number, at, side)

    def vector(self, values: Array) -> Iterator[Column]:
        """Size and both components of complex values (P,); of what does not exist neither."""
        values = np.where(np.isfinite(values), values, complex(np.nan, np.nan))
        yield self.column(np.abs(values))
        for component, (_, _, part) in zip(self.components, AXES, strict=True):
            yield component.column(part(values))

    @cached_property
    def components(self) -> tuple[Quantity, Quantity]:
        """Its projections on x and y, as quantities."""
        x, y = (self._component(axis, text) for axis, text, _ in AXES)
        return x, y

    def _component(self, axis: str, text: str) -> Quantity:
        symbol = self.symbol and replace(self.symbol, sup=",".join(filter(None, (self.symbol.sup, axis))))
        meaning = Message(text, {"of": self.meaning})
        return Quantity(f"{self.key}_{axis}", symbol, self.unit, meaning, self.shown)

    @cached_property
    def said(self) -> dict[Hashable, dict[str, str]]:
        """What results.json says of it, by the language and the own words: kept by who writes."""
        return {}


X_PART, Y_PART = N_("%(of)s, x component"), N_("%(of)s, y component")
AXES = (("x", X_PART, np.real), ("y", Y_PART, np.imag))


class OfQuantity:
    """What has a quantity: its key, unit and meaning."""

    quantity: Quantity

    @property
    def key(self) -> str:
        return self.quantity.key

    @property
    def unit(self) -> str:
        return self.quantity.unit

    @property
    def meaning(self) -> Message:
        return self.quantity.meaning


@dataclass(frozen=True, eq=False)
class Column(OfQuantity):
    """A quantity at the rows of a table: (P,) numbers in its unit, or a list of texts.

    `symbols`: of each row, where the rows are wheels or other things that name the symbol; `meanings`: of each, where
    they name that, too. `units`: of each row, where the rows measure different things; they stand in the results in the
    column "unit" of the table. `asked`: whether a person may be asked for it; not where it is given, or stands in
    another table by another name."""

    quantity: Quantity
    values: Any
    symbols: Sequence[Symbol] = ()
    units: Sequence[str] = ()
    asked: bool = True
    meanings: Sequence[Message] = ()

    @classmethod
    def of_each(cls, quantity: Quantity, values: Any, own: Sequence[Quantity]) -> Column:
        """A column of which each row is a quantity of its own: of a link, of a point."""
        return cls(quantity, values, [one.sign for one in own], meanings=[one.meaning for one in own])

    def symbol(self, row: int | None = None) -> Symbol:
        """Raises ValueError for a column of texts."""
        return self.symbols[row] if self.symbols and row is not None else self.quantity.sign

    def meaning_of(self, row: int) -> Message:
        return self.meanings[row] if self.meanings else self.meaning

    def numbers(self, unit: str = "") -> Array:
        """Its numbers (P,), in another unit if one is named."""
        numbers = np.asarray(self.values, dtype=float)
        return numbers * factor(self.unit, unit) if unit and unit != self.unit else numbers

    def unit_of(self, row: int) -> str:
        return self.units[row] if self.units else self.unit

    def number(self, row: int, unit: str = "") -> float:
        """The number of a row, in another unit if one is named."""
        own = self.unit_of(row)
        number = float(self.values[row])
        return number * factor(own, unit) if unit and unit != own else number


@dataclass(frozen=True, eq=False)
class Table:
    """Named columns of equal length. Key by key: `table["v_B"]`; raises KeyError for a column that it has not."""

    name: str
    meaning: Message
    columns: tuple[Column, ...]

    @cached_property
    def _by_key(self) -> dict[str, Column]:
        return {column.key: column for column in self.columns}

    def __getitem__(self, key: str) -> Column:
        return self._by_key[key]

    def __contains__(self, key: str) -> bool:
        return key in self._by_key

    def __len__(self) -> int:
        """Number of rows."""
        return len(self.columns[0].values) if self.columns else 0

    def ref(self, key: str, row: int, unit: str = "", size: bool = False) -> Ref:
        """Where the number of a row stands; a position goes by its own number."""
        own = self[key].unit_of(row)
        at = int(self["position"].values[row]) if "position" in self else row
        return Ref(key, at, self.name, unit="" if unit == own else unit, size=size)

    def refs(self, key: str, unit: str = "", size: bool = False) -> list[Ref]:
        """`ref` of every row of a column."""
        column = self[key]
        places = self["position"].values if "position" in self else range(len(self))
        units = column.units or [column.unit] * len(self)
        return [
            Ref(key, int(at), self.name, unit="" if unit == own else unit, size=size)
            for at, own in zip(places, units, strict=True)
        ]

    def by_key(self, key: str, column: str, position: int | None = None) -> Ref:
        """Where a number stands in a table of which each row is a quantity with its key."""
        return Ref(key, position, self.name, by=column)

    def var(self, key: str, row: int, unit: str = "", size: bool = False, digits: int | None = None) -> Var:
        """The number of a row, for a formula."""
        column, ref = self[key], self.ref(key, row, unit, size)
        own = unit or column.unit_of(row)
        return variable(
            column.quantity,
            column.number(row, unit),
            own,
            digits,
            ref,
            column.symbol(row),
            column.meaning_of(row),
        )

    def formula(
        self, key: str, row: int, expression: Expr, unit: str = "", size: bool = False, **form: Any
    ) -> Formula:
        """`symbol of the key` = expression, whose value, or `size`, stands in the row."""
        column, ref = self[key], self.ref(key, row, unit, size)
        own = unit or column.unit_of(row)
        return Formula(column.symbol(row), expression, own, ref=ref, meaning=column.meaning_of(row), **form)


@dataclass(frozen=True)
class Value(OfQuantity):
    """A single number in its quantity's unit; `at`: the angle turned from position 0 at which it holds, rad; where it
    jumps there, on which `side`: -1 before, +1 after."""

    quantity: Quantity
    value: float
    at: float | None = None
    side: int = 0

    @property
    def symbol(self) -> Symbol:
        """Raises ValueError for a quantity that is never written as a symbol."""
        return self.quantity.sign

    def number(self, unit: str = "") -> float:
        """The number, in another unit if one is named."""
        return self.value * factor(self.unit, unit) if unit and unit != self.unit else self.value

    def ref(self, unit: str = "", size: bool = False) -> Ref:
        return Ref(self.key, unit="" if unit == self.unit else unit, size=size)

    def var(self, unit: str = "", size: bool = False, digits: int | None = None) -> Var:
        """The number, for a formula."""
        return variable(self.quantity, self.number(unit), unit, digits, self.ref(unit, size))

    def formula(self, expression: Expr, unit: str = "", size: bool = False, **form: Any) -> Formula:
        """`symbol` = expression, whose value this is, or its `size`."""
        ref = self.ref(unit, size)
        return Formula(self.symbol, expression, unit or self.unit, ref=ref, meaning=self.meaning, **form)


@dataclass(frozen=True)
class InRow(Value):
    """A number of a row of a table, of a wheel's among those of all wheels."""

    table: str = ""
    row: int = 0

    def ref(self, unit: str = "", size: bool = False) -> Ref:
        return Ref(self.key, self.row, self.table, unit="" if unit == self.unit else unit, size=size)


def variable(
    quantity: Quantity,
    number: float,
    unit: str = "",
    digits: int | None = None,
    ref: Ref | None = None,
    symbol: Symbol | None = None,
    meaning: Message | None = None,
) -> Var:
    """A quantity's number, in `unit` where it is not its own, as a variable of a formula."""
    unit = unit or quantity.unit
    number = abs(number) if ref is not None and ref.size else number
    # a formula is evaluated in radians and printed in degrees
    number = math.radians(number) if unit == "deg" else number
    return Var(symbol or quantity.sign, number, unit, digits, ref, meaning or quantity.meaning)


@dataclass(frozen=True, eq=False)
class Book:
    """All tables and single values of the results, or of one chapter, by their names."""

    tables: dict[str, Table] = field(default_factory=dict)
    values: dict[str, Value] = field(default_factory=dict)

    @classmethod
    def of(cls, tables: Iterable[Table] = (), values: Iterable[Value] = ()) -> Book:
        return cls({table.name: table for table in tables}, {value.key: value for value in values})

    def __getitem__(self, key: str) -> Value:
        return self.values[key]


def text_column(key: str, meaning: Message, texts: Texts) -> Column:
    """A column of names or other texts."""
    return plain(key, "", meaning, texts)


def plain(key: str, unit: str, meaning: Message, values: Any) -> Column:
    """A column that is never written as a symbol."""
    quantity = Quantity(key, None, unit, meaning) if meaning.values else _of_text(key, unit, meaning.text)
    return Column(quantity, values)


@kept
def _of_text(key: str, unit: str, text: str) -> Quantity:
    return Quantity(key, None, unit, Message(text))
