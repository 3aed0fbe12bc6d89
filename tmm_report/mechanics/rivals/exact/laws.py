"""Laws in 40 digits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.rivals.exact.numbers import Number, context, exact

Array = Any


class Digits:
    """The arithmetic of one place (`laws.Arithmetic`). `near`: the same place in doubles, which tells the piece of the
    law that holds there; its value is exact."""

    def __init__(self, near: float):
        self.near = near

    @staticmethod
    def full(amount: float, at: Number) -> Number:
        return exact(amount)

    @staticmethod
    def cos(x: Number) -> Number:
        return context().cos(x)

    @staticmethod
    def sin(x: Number) -> Number:
        return context().sin(x)

    @staticmethod
    def exp(x: Number) -> Number:
        return context().exp(x)

    def lines(self, at: Number, x: Array, y: Array, period: float | None) -> Number:
        places, values, near = [exact(a) for a in x], [exact(v) for v in y], self.near
        if period is not None:
            turns, rest = divmod(near - x[0], period)
            at, near = at - int(turns) * exact(period), x[0] + rest
            places, values = [*places, places[0] + exact(period)], [*values, values[0]]
            x = np.append(x, x[0] + period)
        k = int(np.searchsorted(x, near, side="right")) - 1
        if k < 0 or k >= len(places) - 1:
            return values[0] if k < 0 else values[-1]
        return values[k] + (values[k + 1] - values[k]) * (at - places[k]) / (places[k + 1] - places[k])

    @staticmethod
    def one_of(values: Sequence[Number], which: int) -> Number:
        return values[which]
