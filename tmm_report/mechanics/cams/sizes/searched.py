"""Where over a law something is greatest: what a cam's size is asked by."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.cams.follower_laws import EDGE, FULL_TURN, Law

Array = Any
# points of a piece of the law, of each of its refinements, how many: a round costs by its calls, hardly by its points
GRID, FINER, ROUNDS = 400, 160, 5
PEAKS = 4  # of a piece that are looked at more closely
TOGETHER = 64  # pieces: a table of many lifts has as many, and its points take room


class Demand(NamedTuple):
    """What one way of the follower asks: b, m, reached at the angle `theta` of the law, rad, with S, m, and S', m."""

    b: float
    theta: float
    S: float
    slope: float


def greatest(law: Law, of: Callable[[Array, Array, Array], Array]) -> Demand:
    """Of a function of S, S' and S'' over the turn."""
    return greatest_at(law, lambda theta: of(*law.of(theta)))


def greatest_at(law: Law, of: Callable[[Array], Array]) -> Demand:
    """Of a function of the law's angle over the turn, in all pieces of the law, about the highest peaks of each: peaks
    of nearly one height are where a size is held in two places. `of`: (K, N) → (K, N), a row a piece or a peak."""
    edges = np.array(sorted({0.0, *law.breaks, FULL_TURN}))
    best, at = -inf, 0.0
    for k in range(0, len(edges) - 1, TOGETHER):
        low, high = edges[:-1][k : k + TOGETHER], edges[1:][k : k + TOGETHER]
        last = high - 2 * EDGE  # nearer to a break the law is already that of what follows
        x = np.column_stack([np.linspace(low, last, GRID + 1, axis=-1), high])
        for turn in range(ROUNDS):
            y = np.where((x <= last[:, None]) | (x == high[:, None]), of(x), -inf)
            row, peak = _peaks(y) if turn == 0 else (np.arange(len(y)), np.argmax(y, axis=1))
            which = int(np.argmax(y[row, peak]))
            if y[row, peak][which] > best:
                best, at = float(y[row, peak][which]), float(x[row, peak][which])
            if turn == 0:
                last, high = last[row], high[row]
            ends = x[row, np.maximum(peak - 1, 0)], x[row, np.minimum(peak + 1, x.shape[1] - 1)]
            x = np.linspace(*ends, FINER + 1, axis=-1)
    if best == -inf:
        return Demand(best, at, 0.0, 0.0)
    S, slope, _ = law.of(np.array(at))
    return Demand(best, at, float(S), float(slope))


def _peaks(y: Array) -> tuple[Array, Array]:
    """Row and column of the highest local maxima of each row; of a row of nothing its first."""
    values = np.pad(y, ((0, 0), (1, 1)), constant_values=-inf)
    peak = (y >= values[:, :-2]) & (y >= values[:, 2:]) & np.isfinite(y)
    peak[:, 0] |= ~peak.any(axis=1)
    least = np.finfo(float).min  # the first of a row of nothing stays before what is no peak
    score = np.where(peak, np.where(np.isfinite(y), y, least), -inf)
    highest = np.argsort(score, axis=1, kind="stable")[:, -PEAKS:]
    row, column = np.nonzero(np.take_along_axis(peak, highest, axis=1))
    return row, highest[row, column]
