"""Gaps of a dyad behind a group: where its two rods do not reach from the group's point to the fixed one."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.random_groups.curve import at_angle
from benchmarks.random_groups.draw import Batch
from benchmarks.random_groups.equations import Equations, solved

Array = Any
Interval = tuple[float, float]
FINE = 40  # parts of a step in which a margin near zero is looked through
SURE = 0.003
DOUBTFUL = 1e-6  # of a rod's square: a margin that comes as near to zero and turns


def gaps_behind(batch: Batch, lane: int, path: Array, limits: Array) -> tuple[Interval, ...] | None:
    """Angles turned, rad, between which the dyad does not close, along the path (COUNT + 1, n) of a lane, whose group
    has its limits at x = `limits` (2, n), the forward one first; None where that cannot be told."""
    one = batch.of(np.array([lane]))
    eq, step = one.equations, 2 * np.pi / (len(path) - 1)
    found: list[Interval] = []
    for part in _stretches(path):
        inside = _inside(one, eq, path, part, step)
        if inside is None or not _ends_alike(one, path, part, limits):
            return None
        found += inside
    return tuple(found)


def _stretches(path: Array) -> list[Array]:
    """Numbers of neighbouring positions that exist."""
    there = np.flatnonzero(np.isfinite(path[:, 0]))
    return [part for part in np.split(there, np.flatnonzero(np.diff(there) > 1) + 1) if part.size]


def _ends_alike(one: Batch, path: Array, part: Array, limits: Array) -> bool:
    """Whether the margin surely keeps its sign between the group's limits and the positions beside them."""
    pairs = []
    if part[-1] < len(path) - 1:
        pairs.append((path[part[-1]], limits[0]))
    if part[0] > 0:
        pairs.append((path[part[0]], limits[1]))
    margins = [_margin(one, np.array(pair)) for pair in pairs]
    return all(m[0] * m[1] > 0 and np.abs(m).min() > SURE for m in margins)


def _inside(one: Batch, eq: Equations, path: Array, part: Array, step: float) -> list[Interval] | None:
    turned = part * step
    values = _margin(one, path[part])
    near = np.flatnonzero(
        (values[1:-1] < values[:-2]) & (values[1:-1] < values[2:]) & (np.abs(values[1:-1]) < 0.05)
    )
    extra = [turned[k + 1] + step * np.linspace(-1, 1, 2 * FINE + 1)[1:-1] for k in near]
    turned = np.unique(np.concatenate([turned, *extra]))
    values = _margin(one, _at(one, eq, path, turned, step))
    if not np.isfinite(values).all() or _touches(values):
        return None
    cuts = np.flatnonzero(np.sign(values[:-1]) * np.sign(values[1:]) < 0)
    ends = [_root(one, eq, path, turned[k], turned[k + 1], step) for k in cuts]
    if not np.isfinite(ends).all():
        return None
    if values[0] < 0:
        ends.insert(0, float(turned[0]) - step)  # into the group's own gap
    if values[-1] < 0:
        ends.append(min(float(turned[-1]) + step, 2 * np.pi))
    return list(zip(ends[::2], ends[1::2], strict=True))


def _touches(values: Array) -> bool:
    low = (np.abs(values[1:-1]) < np.abs(values[:-2])) & (np.abs(values[1:-1]) < np.abs(values[2:]))
    return bool((low & (np.abs(values[1:-1]) < DOUBTFUL) & (values[:-2] * values[2:] > 0)).any())


def _margin(one: Batch, x: Array) -> Array:
    """(r² − (a − b)²)((a + b)² − r²) over the squares of the rods, negative where they do not meet."""
    v = {k: value[0] for k, value in one.numbers.items()}
    p = (x[:, -2] + 1j * x[:, -1]) * one.size[0]
    r = np.abs(p + v["T"] * np.exp(1j * x[:, -3]) - v["K"])
    a, b = v["TR"], v["KR"]
    return (r * r - (a - b) ** 2) * ((a + b) ** 2 - r * r) / (a + b) ** 4


def _at(one: Batch, eq: Equations, path: Array, turned: Array, step: float) -> Array:
    """x at angles turned between positions of the path, by their slopes and Newton's method."""
    k = np.clip(np.round(turned / step).astype(int), 0, len(path) - 1)
    k = np.where(np.isfinite(path[k, 0]), k, k - 1)
    many = eq.of(np.zeros(len(k), dtype=int))
    J = many.rates(path[k])
    slope = -solved(J[:, :, 1:], J[:, :, 0])
    phi = path[k, 0] + one.sense[0] * (turned - k * step)
    guess = path[k].copy()
    guess[:, 1:] += slope * (phi - path[k, 0])[:, None]
    return at_angle(many, guess, phi, 8, 0.02)


def _root(one: Batch, eq: Equations, path: Array, low: float, high: float, step: float) -> float:
    def of(turned: float) -> float:
        return float(_margin(one, _at(one, eq, path, np.array([turned]), step))[0])

    first = of(low)
    for _ in range(48):
        middle = (low + high) / 2
        if not np.isfinite(value := of(middle)):  # beside the group's own limit
            return np.nan
        low, high = (middle, high) if value * first > 0 else (low, middle)
    return (low + high) / 2
