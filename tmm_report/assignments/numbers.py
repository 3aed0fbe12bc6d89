"""Numbers as a person writes them: exact decimals with a unit, `85 mm`, never 0.08500000000000001."""

from __future__ import annotations

import re
from decimal import Decimal
from typing import NamedTuple

from tmm_report.assignments.emit import scalar
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity.text import for_example
from tmm_report.quantity.units import DIMENSIONS, WrongValue, parse

Cell = Decimal | str
"""A parameter's value in a row of the table: a number in the parameter's unit, or a word."""

_WRITTEN = re.compile(r"([-+]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][-+]?[0-9]{1,2})?)\s*(.*)")
_SPACES = str.maketrans("−\N{NO-BREAK SPACE}\N{NARROW NO-BREAK SPACE}", "-  ")


class Written(NamedTuple):
    """A number and its unit, as they are written; "" for no unit."""

    number: Decimal
    unit: str


def written(value: object, dimension: str | None = None) -> Written:
    """What a number with a unit says, exactly. Raises WrongValue for what is none, or has another dimension."""
    text = str(value) if isinstance(value, int | float | Decimal) and not isinstance(value, bool) else value
    text = text.strip().translate(_SPACES) if isinstance(text, str) and len(text) <= 60 else ""
    match = _WRITTEN.fullmatch(text)
    if match is None:
        seen = shown(value) if isinstance(value, str | int | float) else "[…]"
        right = for_example("85 mm")
        raise WrongValue(Message(N_("%(value)s is not a number with a unit"), {"value": seen}), right)
    unit = match[2].strip()
    if unit and (dimension or not dimension_of(unit)):
        parse(text, dimension or "number")  # its words for an unknown unit, or for another dimension
    return Written(Decimal(match[1].replace(",", ".")), unit)


def dimension_of(unit: str) -> str | None:
    """The dimension that a unit measures, by its name in DIMENSIONS; None of an unknown or an empty one."""
    for name in DIMENSIONS if unit else ():
        try:
            parse(f"1 {unit}", name)
        except WrongValue:
            continue
        return name
    return None


def si(number: Decimal, unit: str) -> float:
    """The number in SI; one without a unit is in SI already, or pure."""
    name = dimension_of(unit)
    return float(number) * (parse(f"1 {unit}", name) if name else 1.0)


def text_of(number: Decimal) -> str:
    """As short as it can be written without an exponent: 85, 72.5, 0.0135."""
    short = number.normalize()
    return format(short, "f") if short else "0"


def scaled(value: object, by: Decimal) -> str:
    """A number of a template multiplied, in its own unit, as text of a variant. Raises WrongValue for what is none."""
    number, unit = written(value)
    return scalar(f"{text_of(number * by)} {unit}") if unit else text_of(number * by)
