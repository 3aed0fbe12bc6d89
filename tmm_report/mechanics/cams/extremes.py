"""Extremes of functions of the angle turned: among angles near one another, then by golden sections between them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any
GOLD = (np.sqrt(5.0) - 1) / 2
NARROWED = 40  # golden sections: a bracket of half a degree shrinks to rounding


@dataclass(frozen=True)
class Extreme:
    """An extreme value and the angle turned from position 0, rad, at which it is reached; in a corner on which `side`
    of it, -1 before and +1 after, elsewhere 0."""

    value: float
    turned: float
    side: int = 0


def greatest(of: Callable[[Array], Array], fine: Array) -> list[Extreme]:
    """The greatest of each of several functions, `of`: (P,) -> (Q, P): the best of the angles `fine`, then golden
    sections between its neighbours, all functions at once."""
    values = of(fine)
    each, k = np.arange(len(values)), np.argmax(values, axis=1)
    low, high = fine[np.maximum(k - 1, 0)], fine[np.minimum(k + 1, len(fine) - 1)]
    best, at = values[each, k], fine[k]
    for _ in range(NARROWED):
        inner = np.stack([high - GOLD * (high - low), low + GOLD * (high - low)])
        found = of(inner.ravel()).reshape(len(each), 2, len(each))[each, :, each].T
        left = found[0] >= found[1]
        high, low = np.where(left, inner[1], high), np.where(left, low, inner[0])
        value, x = np.where(left, found[0], found[1]), np.where(left, inner[0], inner[1])
        best, at = np.where(value > best, value, best), np.where(value > best, x, at)
    return [Extreme(float(value), float(x)) for value, x in zip(best, at, strict=True)]
