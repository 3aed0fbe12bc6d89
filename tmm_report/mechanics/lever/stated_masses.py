"""Masses and moments of inertia as an assignment states them: of a metre of length, of another link's mass, m·l²/12.

A statement is a tree of numbers and letters, read from `q·l`, `0.3·m2`, `m·l_AB²/12`; it is worked out over whatever
stands for its letters: numbers for the solution, variables of a formula for the note.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, Union

from tmm_report.records import dataclass


@dataclass(frozen=True)
class Number:
    """A number; `measures`: exponents of kilogram and metre of one that is written with its unit, SI."""

    value: float
    measures: tuple[int, int] = (0, 0)


@dataclass(frozen=True)
class PerLength:
    """Mass of a metre of length, kg/m."""

    value: float


@dataclass(frozen=True)
class MassOf:
    """The mass of a link by its name, of the link itself by none."""

    link: str = ""


@dataclass(frozen=True)
class LengthOf:
    """The length between two points by their names (`AB`), of a link by its name, of the link itself by none."""

    name: str = ""


@dataclass(frozen=True)
class Synthesised:
    """A length that the synthesis found, by its key; `number`: as the mechanism takes it, m; `row`: of the table of
    rounded lengths, where they are rounded."""

    key: str
    number: float = math.nan
    row: int | None = None


@dataclass(frozen=True)
class Segment:
    """The length between two points of a link: what a `LengthOf` turns out to be."""

    link: str
    first: str
    second: str


@dataclass(frozen=True)
class Combined:
    sign: str  # one of + - * /
    left: Statement
    right: Statement


@dataclass(frozen=True)
class Power:
    base: Statement
    exponent: int


@dataclass(frozen=True)
class Negative:
    of: Statement


Letter = Union[PerLength, MassOf, LengthOf, Segment, Synthesised]  # noqa: UP007
Statement = Union[Number, Letter, Combined, Power, Negative]  # noqa: UP007

_SIGNS: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
}


def worked(statement: Statement, of: Callable[[Letter], Any]) -> Any:
    """The statement over what `of` gives for its letters. Raises ZeroDivisionError, OverflowError as numbers do."""
    match statement:
        case Number(value):
            return value
        case Combined(sign, left, right):
            return _SIGNS[sign](worked(left, of), worked(right, of))
        case Power(base, exponent):
            return worked(base, of) ** exponent
        case Negative(inner):
            return -worked(inner, of)
        case _:
            return of(statement)


def lettered(statement: Statement, of: Callable[[Letter], Letter]) -> Statement:
    """The same statement with other letters."""
    match statement:
        case Number():
            return statement
        case Combined(sign, left, right):
            return Combined(sign, lettered(left, of), lettered(right, of))
        case Power(base, exponent):
            return Power(lettered(base, of), exponent)
        case Negative(inner):
            return Negative(lettered(inner, of))
        case _:
            return of(statement)


def letters(statement: Statement) -> Iterator[Letter]:
    """Its letters, from left to right."""
    match statement:
        case Number():
            return
        case Combined(_, left, right):
            yield from letters(left)
            yield from letters(right)
        case Power(base, _) | Negative(base):
            yield from letters(base)
        case _:
            yield statement


def dimension(statement: Statement) -> tuple[int, int] | None:
    """Exponents of kilogram and metre; None of a sum of what measures different things."""
    match statement:
        case Number():
            return statement.measures
        case PerLength():
            return 1, -1
        case MassOf():
            return 1, 0
        case LengthOf() | Segment() | Synthesised():
            return 0, 1
        case Negative(inner):
            return dimension(inner)
        case Power(base, exponent):
            found = dimension(base)
            return None if found is None else (found[0] * exponent, found[1] * exponent)
        case Combined(sign, left, right):
            first, second = dimension(left), dimension(right)
            if first is None or second is None:
                return None
            if sign in "+-":
                return first if first == second else None
            turn = 1 if sign == "*" else -1
            return first[0] + turn * second[0], first[1] + turn * second[1]
    raise TypeError(statement)
