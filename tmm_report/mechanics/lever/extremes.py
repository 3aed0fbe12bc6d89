"""Least and greatest values of many functions of a cycle at once, exact between their kinks and jumps.

On panels with edges at every kink and jump (see `panels`) a function is the polynomial through its Gauss–Legendre
points. It is extreme where the slope of that polynomial passes through zero, or at an end of a panel: at a jump the
values of both its sides count, and which of them holds is told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.panels import ORDER, Panels, cut
from tmm_report.mechanics.calculus.zeros import grid, zeros
from tmm_report.mechanics.lever.cycle import Extreme
from tmm_report.records import dataclass

Array = Any
ALIKE = 1e-10  # values nearer than this part of the largest are one, and the first of them counts
JUMP = 1e-8  # of the largest value: what differs by less on both sides of an edge does not jump
RESOLVED = 1e-11  # of the size of a function, of the last coefficients of a panel's polynomial
MOST = 240  # panels: what they do not resolve is not smooth


@dataclass(frozen=True)
class Peak(Extreme):
    """An extreme value; `side`: -1 just before a jump at its angle, +1 just after it, 0 where nothing jumps."""

    side: int = 0


Peaks = tuple[Peak, Peak]


def peaks(over: Panels, values: Array, closed: bool = True) -> list[Peaks]:
    """Least and greatest of real functions (F, K, n)."""
    return _peaks(over, np.asarray(values, float), over.slope(values), np.real, closed)


def size_peaks(over: Panels, vectors: Array, closed: bool = True) -> list[Peaks]:
    """Least and greatest magnitude of complex functions (F, K, n)."""
    vectors = np.asarray(vectors, complex)
    slope = np.real(np.conj(vectors) * over.slope(vectors))  # half of that of the square: smooth through zero
    return _peaks(over, vectors, slope, np.abs, closed)


def _peaks(
    over: Panels, values: Array, slope: Array, shown: Callable[[Array], Array], closed: bool
) -> list[Peaks]:
    f, k, x = still(over, slope)
    inner = shown(inside(over, values, f, k, x))
    ends = shown(over.ends(values))
    sides = _sides(ends, closed)
    places = np.stack([over.edges[:-1], over.edges[1:]], axis=-1)
    return [
        _one(np.append(places, x[f == i]), np.append(ends[i], inner[f == i]), sides[i])
        for i in range(len(values))
    ]


def _one(x: Array, y: Array, sides: Array) -> Peaks:
    """Of the values (N,) at places (N,) the least and the greatest, the first of equal ones; `sides`: of the ends of
    the panels, which stand first."""
    alike = ALIKE * float(np.abs(y).max())
    picks = (_first(x, y <= y.min() + alike), _first(x, y >= y.max() - alike))
    flat = sides.ravel()
    low, high = (Peak(float(y[i]), float(x[i]), int(flat[i]) if i < len(flat) else 0) for i in picks)
    return low, high


def _first(x: Array, among: Array) -> int:
    at = np.flatnonzero(among)
    return int(at[np.argmin(x[at])])


def _sides(ends: Array, closed: bool) -> Array:
    """Which side of a jump each end (F, K, 2) of a panel is."""
    after, before = ends[..., 0], np.roll(ends[..., 1], 1, axis=-1)
    jumps = np.abs(after - before) > JUMP * np.abs(ends).max(axis=(-2, -1))[:, None]
    if not closed:
        jumps[:, 0] = False
    return np.stack([np.where(jumps, 1, 0), np.where(np.roll(jumps, -1, axis=-1), -1, 0)], axis=-1)


def still(over: Panels, slope: Array) -> tuple[Array, Array, Array]:
    """Where functions (F, K, n) pass through zero within their panels: numbers of function and panel, places; (S,)."""
    ends = over.ends(slope)
    rows = np.concatenate([ends[..., :1], slope, ends[..., 1:]], axis=-1)
    rows = np.where(np.abs(rows) <= 1e-13 * np.abs(rows).max(axis=(-2, -1), keepdims=True), 0.0, rows)
    f, k, i = np.nonzero(rows[..., :-1] * rows[..., 1:] < 0)
    on = np.nonzero((rows[..., 1:-1] == 0) & (rows[..., :-2] * rows[..., 2:] < 0))
    at = grid(over.order)
    t = zeros(slope[f, k], at[i], at[i + 1], np.sign(rows[f, k, i]))
    found = over.edges[k] + over.half[k, 0] * (1 + t)
    exact = over.x[on[1], on[2]]
    return np.append(f, on[0]), np.append(k, on[1]), np.append(found, exact)


def inside(over: Panels, values: Array, f: Array, k: Array, x: Array) -> Array:
    """Function f in panel k at place x, (S,)."""
    points, barycentric = _points(over.order)
    unit = (x - over.edges[k]) / over.half[k, 0] - 1
    away = unit[:, None] - points
    hit = away == 0
    share = barycentric / np.where(hit, 1.0, away)
    share = np.where(hit.any(axis=-1, keepdims=True), hit, share)
    return np.sum(share * values[f, k], axis=-1) / np.sum(share, axis=-1)


@cache
def _gauss(order: int) -> tuple[Array, Array]:
    """Gauss–Legendre points on [-1, 1] and their weights."""
    points, weights = np.polynomial.legendre.leggauss(order)
    return points, weights


@cache
def _points(order: int) -> tuple[Array, Array]:
    """Gauss–Legendre points on [-1, 1] and their barycentric weights."""
    points, _ = _gauss(order)
    apart = points[:, None] - points
    np.fill_diagonal(apart, 1.0)
    barycentric = 1.0 / np.prod(apart, axis=1)
    return points, barycentric / np.abs(barycentric).max()


# ---------------------------------------------------------------- panels fine enough


def refined(over: Panels, values: Array, sizes: Array) -> Panels:
    """Panels on which functions (F, K, n) are resolved: where the last coefficients of a polynomial are not yet next
    to nothing beside the function's size (F,) its panel is cut, by what a halving gains. The same panels where all are
    or where too many would be needed."""
    tails = np.abs(values @ _last(over.order).T).max(axis=-1)  # (F, K)
    allowed = np.maximum(RESOLVED * np.asarray(sizes), 1e-300)
    excess = (tails / allowed[:, None]).max(axis=0, initial=0.0)
    cuts = np.ceil(np.log2(np.maximum(excess, 1.0)) / (over.order - 2)).astype(int)
    parts = 2 ** np.minimum(cuts, 4)
    if not cuts.any() or parts.sum() > MOST:
        return over
    return replace(over, edges=cut(over.edges, parts))


@cache
def _last(order: int = ORDER) -> Array:
    """The last two Legendre coefficients of the polynomial through the points, (2, n)."""
    points, _ = _points(order)
    return np.linalg.inv(np.polynomial.legendre.legvander(points, order - 1))[-2:]


# ---------------------------------------------------------------- integrals between any places


def integral(over: Panels, values: Array, x: Array) -> Array:
    """Of a function (K, n) from 0 to places x (S,) within the period."""
    x = np.asarray(x, float)
    k = np.clip(np.searchsorted(over.edges, x, side="left") - 1, 0, over.shape[0] - 1)
    points, weights = _gauss(over.order)
    half = (x - over.edges[k]) / 2
    inner = over.edges[k, None] + half[:, None] * (1 + points)
    panel = np.repeat(k, over.order)
    found = inside(over, values[None], 0 * panel, panel, inner.ravel()).reshape(inner.shape)
    return over.running_edges(values)[k] + half * (found @ weights)


def signed(over: Panels, values: Array) -> tuple[float, float]:
    """Integrals of a function (K, n) over the period where it is above zero, and where it is below."""
    marks = distinct(np.concatenate([over.edges, still(over, values[None])[2]]))
    parts = np.diff(integral(over, values, marks))
    return float(parts[parts > 0].sum()), float(parts[parts < 0].sum())
