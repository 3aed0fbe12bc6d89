"""The formula of a law at one place, written out: of every law, as its own `value` is what is written out."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.laws import Law
from tmm_report.quantity import formula, functions
from tmm_report.quantity.formula import Expr, Number, Var


def written(law: Law, at: Var, which: int = 0) -> Expr:
    """The value of a law at a place of its axis, of the curve that holds there: of straight lines the one on which the
    place lies."""
    found: Expr = law.value(at, which, Written(float(at.value)))
    return found


class Written:
    """The arithmetic of formulas (`laws.Arithmetic`). `near`: the number of the place, which tells the piece."""

    def __init__(self, near: float):
        self.near = near

    @staticmethod
    def full(amount: float, at: Expr) -> Expr:
        return Number(amount)

    @staticmethod
    def cos(x: Expr) -> Expr:
        return formula.cos(x)

    @staticmethod
    def sin(x: Expr) -> Expr:
        return formula.sin(x)

    @staticmethod
    def exp(x: Expr) -> Expr:
        return functions.exp(x)

    def lines(self, at: Expr, x: Any, y: Any, period: float | None) -> Expr:
        places, values, near = x.tolist(), y.tolist(), self.near
        if period is not None:
            turns, rest = divmod(near - places[0], period)
            at, near = (at - Number(turns * period) if turns else at), places[0] + rest
            places, values = [*places, places[0] + period], [*values, values[0]]
        k = int(np.searchsorted(places, near, side="right")) - 1
        if k < 0 or k >= len(places) - 1 or values[k] == values[k + 1]:
            return Number(values[min(max(k, 0), len(places) - 1)])
        begin = at - Number(places[k]) if places[k] else at
        rise = Number(values[k + 1] - values[k]) * begin / Number(places[k + 1] - places[k])
        return Number(values[k]) + rise if values[k] else rise

    @staticmethod
    def one_of(values: Sequence[Expr], which: int) -> Expr:
        return values[which]
