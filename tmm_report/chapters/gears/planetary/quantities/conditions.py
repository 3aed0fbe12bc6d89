"""Quantities of the conditions of a planetary stage: a row each, in its own unit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from tmm_report.chapters.gears.planetary.solve.conditions import Condition
from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, text_column
from tmm_report.quantity.symbols import Symbol, math_symbol


def condition_columns(found: Found) -> Iterator[Column]:
    """One condition in each row, numbers in the row's own unit."""
    of, names = found.conditions, found.given.wheels
    yield text_column("condition", Message(N_("name of the condition")), [c.key for c in of])
    wheels = ["-".join(names[wheel] for wheel in c.wheels) for c in of]
    yield text_column("wheel", Message(N_("number of the wheel")), wheels)
    yield text_column("unit", Message(N_("unit of the numbers in the row")), [c.unit for c in of])
    symbols = [_symbol(c, names) for c in of]
    for key, text, numbers in (
        ("value", N_("value"), [c.value for c in of]),
        ("limit", N_("limit"), [c.limit for c in of]),
        ("margin", N_("margin"), [c.margin for c in of]),
    ):
        quantity = Quantity(key, None, "", Message(text))
        yield Column(quantity, numbers, symbols, [c.unit for c in of])


def _symbol(of: Condition, names: Sequence[str]) -> Symbol:
    match of.key:
        case "ratio":
            return Symbol("Delta", "u")
        case "undercut":
            return Symbol("z", names[of.wheels[0]])
        case "tips":
            return Symbol("Delta", "φ")
        case "radial":
            return Symbol("Delta", "r")
        case "contact":
            return math_symbol("epsilon_alpha")
        case "gap":
            return Symbol("Delta")
        case _:
            assert_never(of.key)
