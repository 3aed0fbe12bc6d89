"""Conditions between parameters, `AB > 2*OA`: two products compared, and nothing else is read."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal

from tmm_report.assignments.model import Condition, Parameter
from tmm_report.assignments.numbers import Cell, si, written
from tmm_report.assignments.options import NAME
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.errors import near

_PRODUCT = re.compile(rf"(?:([0-9]{{1,12}}(?:\.[0-9]{{1,12}})?)\s*\*\s*)?({NAME})")
_COMPARED = re.compile(r"([^<>=]{1,80})(<=|>=|<|>)([^<>=]{1,80})")

Side = tuple[Decimal, str]


def condition(text: object, parameters: Mapping[str, Parameter]) -> Condition:
    """What a condition says. Raises WrongValue."""
    match = _COMPARED.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        right = Message(N_("for example, %(example)s"), {"example": "AB > 2*OA"})
        raise WrongValue(
            Message(N_("%(value)s does not compare two products"), {"value": shown(text)}), right
        )
    left, right_ = _side(match[1].strip(), parameters), _side(match[3].strip(), parameters)
    greater, equal = match[2].startswith(">"), match[2].endswith("=")
    return Condition(
        " ".join(match[0].split()), right_ if greater else left, left if greater else right_, equal
    )


def mentions(text: object, names: set[str]) -> bool:
    """Whether one of the names stands in a condition."""
    return not names.isdisjoint(re.findall(NAME, text)) if isinstance(text, str) else False


def _side(text: str, parameters: Mapping[str, Parameter]) -> Side:
    """A number times a parameter, or a number alone, in SI."""
    if product := _PRODUCT.fullmatch(text):
        if product[2] not in parameters:
            right = near(product[2], list(parameters))
            raise WrongValue(Message(N_("no parameter %(name)s"), {"name": shown(product[2])}), right)
        if not parameters[product[2]].numeric:
            raise WrongValue(
                Message(N_("parameter %(name)s has no numbers to compare"), {"name": product[2]})
            )
        return Decimal(product[1] or 1), product[2]
    number, unit = written(text)
    return Decimal(repr(si(number, unit))), ""


def holds(one: Condition, cells: Mapping[str, Cell], parameters: Mapping[str, Parameter]) -> bool:
    """Whether the values meet the condition; a word in the place of a number never does."""
    left, right = (_value(side, cells, parameters) for side in (one.left, one.right))
    rounding = 1e-12 * max(abs(left), abs(right))
    return left <= right + rounding if one.equal else left < right - rounding


def _value(side: Side, cells: Mapping[str, Cell], parameters: Mapping[str, Parameter]) -> float:
    times, name = side
    if not name:
        return float(times)
    cell = cells[name]
    return float(times) * si(cell, parameters[name].unit) if isinstance(cell, Decimal) else float("nan")
