"""Where over a law something is greatest: what a cam's size is asked by."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import inf
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.cams.follower_laws import EDGE, FULL_TURN, Law

Array = Any
GRID, FINER, ROUNDS = 400, 40, 7  # points of a piece of the law, of each of its refinements, how many
PEAKS = 4  # of a piece that are looked at more closely


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
    """Of a function of the law's angle over the turn, piece by piece of the law, about the highest peaks of each: peaks
    of nearly one height are where a size is held in two places."""
    edges = sorted({0.0, *law.breaks, FULL_TURN})
    best = Demand(-inf, 0.0, 0.0, 0.0)
    for low, high in pairwise(edges):
        last = high - 2 * EDGE  # nearer to a break the law is already that of what follows
        x = np.append(np.linspace(low, last, GRID + 1), high)[None]
        for _ in range(ROUNDS):
            y = np.where((x <= last) | (x == high), of(x), -inf)
            k = np.unravel_index(int(np.argmax(y)), y.shape)
            if y[k] > best.b:
                S, slope, _ = law.of(x[k])
                best = Demand(float(y[k]), float(x[k]), float(S), float(slope))
            row, peak = _peaks(y) if len(y) == 1 else (np.arange(len(y)), np.argmax(y, axis=1))
            ends = x[row, np.maximum(peak - 1, 0)], x[row, np.minimum(peak + 1, x.shape[1] - 1)]
            x = np.linspace(*ends, FINER + 1, axis=-1)
    return best


def _peaks(y: Array) -> tuple[Array, Array]:
    """Row and column of the highest local maxima of one row."""
    values = np.concatenate([[-inf], y[0], [-inf]])
    found = np.flatnonzero((y[0] >= values[:-2]) & (y[0] >= values[2:]) & np.isfinite(y[0]))
    if not len(found):
        found = np.array([0])
    found = found[np.argsort(y[0][found])[-PEAKS:]]
    return np.zeros(len(found), int), found
