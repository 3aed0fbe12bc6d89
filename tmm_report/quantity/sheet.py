"""The single numbers of a chapter: each declared once, and computed by assigning the expression that is printed.

    class Values(Sheet, prefix="vibration"):
        inertia = Q("m", "kg", N_("mass of the machine"))
        natural = Q("omega_0", "rad/s", N_("natural frequency without damping"))

    s = Values()
    s.inertia = 1200.0                            # a number that is given or found elsewhere
    s.natural = sqrt(s.stiffness / s.inertia)     # its value, its formula, its row of a where-list
    s["natural"].value, s.formula("natural"), Values.natural.column(numbers)

results.json, CSV, formulas, where-lists, axes, explanations and marks take letter, unit and meaning from the
declaration. A `Row` is a sheet whose numbers stand in a row of a table: those of one wheel of several.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, ClassVar, Self, overload

from tmm_report.problems import Message
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book, Column, InRow, Quantity, Value
from tmm_report.quantity.symbols import Symbol, math_symbol
from tmm_report.quantity.units import factor
from tmm_report.records import dataclass


@dataclass(frozen=True, eq=False)
class Computed:
    """A number with the expression that a student would write for it. `number`: where that form loses digits, or the
    number is found by a search; `scale`: of what it is nought beside, where it may be."""

    expression: Expr
    number: float | None = None
    scale: float | None = None


@dataclass(frozen=True, eq=False)
class Reached:
    """A number with the angle turned from position 0 at which it is reached, rad."""

    number: float
    at: float


Assigned = Expr | Computed | Reached | float | None


class Q:
    """A declared number. `symbol`: as keys are written, "omega_d", or None of what is never written as one; `unit`: of
    the results; `meaning`: a literal for translation; `shown`: unit of print, where it is another; `formed`: unit in
    formulas, where it is another: angles that are printed in degrees are so in formulas, too; `key`: where it can be no
    attribute's name, "lambda"; `digits`: significant ones in formulas, where they are not as many as of others: whole
    numbers have them all."""

    def __init__(
        self,
        symbol: str | Symbol | None,
        unit: str,
        meaning: str | Message,
        shown: str = "",
        formed: str | None = None,
        key: str = "",
        digits: int | None = None,
    ):
        self.key, self.digits = key, digits
        self.symbol = math_symbol(symbol) if isinstance(symbol, str) else symbol
        self.unit, self.shown = unit, shown
        self.formed = ("deg" if shown == "deg" else "") if formed is None else formed
        self.meaning = Message(meaning) if isinstance(meaning, str) else meaning

    def __set_name__(self, owner: type, name: str) -> None:
        self.key = self.key or name.removesuffix("_")  # of a name that Python keeps: lambda_

    @overload
    def __get__(self, sheet: None, owner: type) -> Self: ...
    @overload
    def __get__(self, sheet: Sheet, owner: type) -> Var: ...
    def __get__(self, sheet: Sheet | None, owner: type) -> Self | Var:
        return self if sheet is None else sheet.var(self.key)

    def __set__(self, sheet: Sheet, value: Assigned) -> None:
        sheet.put(self.key, value)

    @cached_property
    def quantity(self) -> Quantity:
        """As a column of a table, whose name stands before it."""
        return self.named("")

    def named(self, prefix: str) -> Quantity:
        return Quantity(f"{prefix}{self.key}", self.symbol, self.unit, self.meaning, self.shown)

    def column(self, values: Any) -> Column:
        """Its numbers (P,) at the rows of a table."""
        return self.quantity.column(values)

    def called(self, symbol: Symbol | None, key: str = "", **values: object) -> Q:
        """As one variant calls it; `values`: of the meaning's %(name)s."""
        meaning = Message(self.meaning.text, values) if values else self.meaning
        return Q(symbol, self.unit, meaning, self.shown, self.formed, key or self.key, self.digits)

    def of(self, name: str, /, **values: object) -> Q:
        """That of one of several things: rho_4, by the same name in the key and in the index of the letter."""
        return self.called(_indexed(self.symbol, name), f"{self.key}_{name}", **values)


def _indexed(symbol: Symbol | None, index: str) -> Symbol | None:
    return replace(symbol, sub=symbol.sub + index) if symbol else None


@dataclass(frozen=True, eq=False)
class _Kept:
    value: Value
    expression: Expr | None
    scale: float | None


class Sheet:
    """The numbers of one variant. A number that is None is not there; assigning one twice is an error of the program.

    `other`: declarations that this variant calls otherwise, by their keys: J and kg·m² of what turns for m and kg; or
    that it alone has: of each of its resistances, whatever their number.
    `prefix`: of this sheet's own names, where several of one kind are solved: the stages of a drive.
    """

    PREFIX: ClassVar[str] = ""
    DECLARED: ClassVar[Mapping[str, Q]] = {}

    def __init_subclass__(cls, prefix: str | None = None) -> None:
        if prefix is not None:
            cls.PREFIX = f"{prefix}_"
        cls.DECLARED = {**cls.DECLARED, **{one.key: one for one in vars(cls).values() if isinstance(one, Q)}}

    def __init__(self, other: Mapping[str, Q] | None = None, prefix: str | None = None, **others: Q):
        if prefix is not None:
            self.PREFIX = f"{prefix}_"  # type: ignore[misc]
        self._others = {**(other or {}), **others}
        for key, one in self._others.items():
            one.key = one.key or key
        self._kept: dict[str, _Kept] = {}

    def declared(self, key: str) -> Q:
        """Raises KeyError for what the chapter has not."""
        return self._others.get(key) or self.DECLARED[key]

    def named(self, key: str) -> Quantity:
        """What a number is in the results."""
        return self.declared(key).named(self.PREFIX)

    def put(self, key: str, value: Assigned) -> None:
        """What `sheet.key = value` does."""
        if value is None:
            return
        if key in self._kept:
            raise ValueError(f"{self.PREFIX}{key} is found twice")
        made = value if isinstance(value, Computed) else None
        expression = made.expression if made else value if isinstance(value, Expr) else None
        at = value.at if isinstance(value, Reached) else None
        number: Any = value.number if isinstance(value, Computed | Reached) else None
        number = value if number is None and expression is None else number
        declared = self.declared(key)
        if number is None:
            assert expression is not None
            number = expression.evaluate()
            if declared.unit == "deg":  # a formula is evaluated in radians
                number = math.degrees(number)
            elif declared.formed not in ("", "deg", declared.unit):
                number /= factor(declared.unit, declared.formed)
        scale = made.scale if made else None
        self._kept[key] = _Kept(self._value(key, number, at), expression, scale)

    def _value(self, key: str, number: float, at: float | None) -> Value:
        return self.named(key).value(float(number), at)

    def take(self, record: object, *keys: str) -> None:
        """Fields of a record by their names, of those that are declared; `keys`: these alone."""
        for key in keys or [key for key in self.DECLARED if hasattr(record, key)]:
            self.put(key, getattr(record, key))

    # --- what is there

    def __contains__(self, key: str) -> bool:
        return key in self._kept

    def __getitem__(self, key: str) -> Value:
        """Raises KeyError for what this variant has not."""
        return self._kept[key].value

    def get(self, key: str) -> float | None:
        """The number in the unit of the results; None where this variant has it not."""
        return self._kept[key].value.value if key in self._kept else None

    def number(self, key: str) -> float:
        """The number in the unit of the results."""
        return self._kept[key].value.value

    def var(self, key: str) -> Var:
        """The number for an expression."""
        declared = self.declared(key)
        return self[key].var(declared.formed, digits=declared.digits)

    def has_formula(self, key: str) -> bool:
        return key in self._kept and self._kept[key].expression is not None

    def computed(self) -> list[str]:
        """Keys of what is computed by a formula, in the order of the steps."""
        return [key for key, kept in self._kept.items() if kept.expression is not None]

    def formula(self, key: str, **form: Any) -> Formula:
        """symbol = expression = numbers = value. Raises KeyError for a number that was not computed by one."""
        kept = self._kept[key]
        if kept.expression is None:
            raise KeyError(f"{self.PREFIX}{key} has no formula")
        declared = self.declared(key)
        form = form if kept.scale is None else {"scale": kept.scale, **form}
        form = form if declared.digits is None else {"digits": declared.digits, **form}
        return kept.value.formula(kept.expression, declared.formed, **form)

    def values(self) -> Iterator[Value]:
        """All numbers, in the order of their declarations; behind them those that this variant alone declares."""
        for key in {**self.DECLARED, **self._others}:
            if key in self._kept:
                yield self._kept[key].value

    def quantity(self, key: str) -> Quantity:
        """As a column of a table: letter, unit and meaning as this variant has them."""
        return self.declared(key).quantity

    def column(self, key: str, values: Any) -> Column:
        """Numbers (P,) at the rows of a table; what is not finite is a dash there."""
        return self.quantity(key).column([x if math.isfinite(x) else math.nan for x in values])

    def book(self) -> Book:
        return Book.of((), self.values())


class Row(Sheet):
    """The numbers of a row of a table; `index`: what the index of their letters has besides, of all, or by key."""

    def __init__(
        self, table: str, row: int, index: str | Mapping[str, str] = "", other: Mapping[str, Q] | None = None
    ):
        super().__init__(other)
        self.table, self.row, self.index = table, row, index

    def letter(self, key: str) -> Symbol | None:
        """As it is written in this row."""
        index = self.index if isinstance(self.index, str) else self.index.get(key, "")
        return _indexed(self.declared(key).symbol, index)

    def _value(self, key: str, number: float, at: float | None) -> Value:
        quantity, letter = self.declared(key).quantity, self.letter(key)
        if letter != quantity.symbol:
            quantity = replace(quantity, symbol=letter)
        number = number if isinstance(number, int) else float(number)
        return InRow(quantity, number, table=self.table, row=self.row)


def columns(rows: Sequence[Row]) -> Iterator[Column]:
    """The columns of the rows of a table, in the order of their declarations; of what a row has not, nan."""
    for key in rows[0].DECLARED:
        if any(key in row for row in rows):
            of = rows[0].declared(key).quantity
            numbers = [math.nan if (number := row.get(key)) is None else number for row in rows]
            letters = [letter for row in rows if (letter := row.letter(key))]
            yield Column(of, numbers, letters if set(letters) - {of.symbol} else ())
