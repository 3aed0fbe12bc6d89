"""A period cut into panels at the breaks of a function, and exact calculus on it: what is smooth within each panel is
there the polynomial through its Gauss–Legendre points.

    |  · ·  ·  · · | · ·  ·  · · |· ·  ·  · ·|        edges | and points ·: no point lies on an edge, so a jump there
    0            break           …         period     needs no word on which of its two values holds

Forces of a cycle have kinks and jumps (an indicator diagram, a stroke that ends); with these as edges the integrals,
extremes and values between the points are found to the rounding of a double where the function is smooth between them.
(Davis, Rabinowitz, Methods of numerical integration, ch. 2; barycentric form: Berrut, Trefethen, SIAM Review 46)
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.zeros import grid, zeros
from tmm_report.records import dataclass

Array = Any
ORDER = 12  # points in a panel
WIDEST = np.pi / 12  # rad: of a panel of the driver's angle
NARROWEST = 1e-9  # of the period: breaks nearer than this are one


@cache
def _rule(order: int) -> tuple[Array, Array, Array, Array, Array, Array]:
    """On [-1, 1]: points, weights, barycentric weights; matrices: integral from -1 to each point, derivative at each
    point; values at both ends."""
    points, weights = np.polynomial.legendre.leggauss(order)
    apart = points[:, None] - points
    np.fill_diagonal(apart, 1.0)
    barycentric = 1.0 / np.prod(apart, axis=1)
    barycentric /= np.abs(barycentric).max()
    # through Legendre coefficients: exact for polynomials of degree order - 1
    to_coefficients = np.linalg.inv(np.polynomial.legendre.legvander(points, order - 1))
    unit = np.eye(order)
    integrals = np.array([np.polynomial.legendre.legint(row, lbnd=-1) for row in unit])
    slopes = np.array([np.pad(np.polynomial.legendre.legder(row), (0, 1)) for row in unit])[:, :order]
    running = np.polynomial.legendre.legval(points, integrals.T).T @ to_coefficients
    derivative = np.polynomial.legendre.legval(points, slopes.T).T @ to_coefficients
    ends = np.polynomial.legendre.legvander(np.array([-1.0, 1.0]), order - 1) @ to_coefficients
    return points, weights, barycentric, running, derivative, ends


@dataclass(frozen=True, eq=False)
class Panels:
    """`edges` (K+1,), ascending from 0 to the period; a function is its values (..., K, n) at `x`."""

    edges: Array
    order: int = ORDER

    @property
    def period(self) -> float:
        return float(self.edges[-1])

    @cached_property
    def half(self) -> Array:
        """Half widths of the panels, (K, 1)."""
        return np.diff(self.edges)[:, None] / 2

    @cached_property
    def x(self) -> Array:
        """The points, (K, n), ascending."""
        return self.edges[:-1, None] + self.half * (1 + _rule(self.order)[0])

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.edges) - 1, self.order

    def total(self, values: Array) -> Array:
        """Integral over the period, (...)."""
        return np.sum(values * (self.half * _rule(self.order)[1]), axis=(-2, -1))

    def mean(self, values: Array) -> Array:
        return self.total(values) / self.period

    def running(self, values: Array) -> Array:
        """Integral from 0 to each point, (..., K, n)."""
        inside = values @ _rule(self.order)[3].T * self.half
        return inside + self._before(values)[..., None]

    def running_edges(self, values: Array) -> Array:
        """Integral from 0 to each edge, (..., K+1)."""
        before, last = self._before(values), self.total(values)
        return np.concatenate([before, np.asarray(last)[..., None]], axis=-1)

    def _before(self, values: Array) -> Array:
        each = np.sum(values * (self.half * _rule(self.order)[1]), axis=-1)
        return np.cumsum(each, axis=-1) - each

    def slope(self, values: Array) -> Array:
        """Derivative at each point, (..., K, n)."""
        return values @ _rule(self.order)[4].T / self.half

    def ends(self, values: Array) -> Array:
        """Values at the left and at the right end of each panel, (..., K, 2): a jump tells neighbours apart."""
        return values @ _rule(self.order)[5].T

    def at(self, values: Array, x: Array) -> Array:
        """Values (..., K, n) at any places x (P,), periodic; at an edge, of the panel that begins there."""
        x = np.asarray(x, dtype=float)
        flat = np.mod(x, self.period).ravel()
        k = np.clip(np.searchsorted(self.edges, flat, side="right") - 1, 0, self.shape[0] - 1)
        away = flat[:, None] - self.x[k]
        hit = away == 0
        with np.errstate(divide="ignore", invalid="ignore"):
            share = _rule(self.order)[2] / away
            found = np.sum(share * values[..., k, :], axis=-1) / np.sum(share, axis=-1)
        if hit.any():
            known = np.sum(np.where(hit, values[..., k, :], 0.0), axis=-1)
            found = np.where(hit.any(axis=-1), known, found)
        return found.reshape(*np.shape(values)[:-2], *x.shape)

    def extremes(self, values: Array) -> tuple[tuple[float, float], tuple[float, float]]:
        """Least and greatest of a function (K, n), each as (value, place): at the ends of the panels, both sides of a
        jump among them, and where the panel's polynomial stands still; of equal ones the first."""
        places, heights = self._candidates(values)
        low, high = heights.min(), heights.max()
        near = 1e-13 * max(abs(low), abs(high))
        first = [np.flatnonzero(heights <= low + near)[0], np.flatnonzero(heights >= high - near)[0]]
        least, greatest = ((float(heights[i]), float(places[i])) for i in first)
        return least, greatest

    def _candidates(self, values: Array) -> tuple[Array, Array]:
        """Places in ascending order and the function there."""
        ends = self.ends(values)
        places = [np.repeat(self.edges, 2)[1:-1], self.x.ravel()]
        heights = [ends.ravel(), np.asarray(values).ravel()]
        still = self.roots(self.slope(values), within=True)
        if still.size:
            places.append(still)
            heights.append(self.at(values, still))
        x, y = np.concatenate(places), np.concatenate(heights)
        order = np.argsort(x, kind="stable")
        return x[order], y[order]

    def roots(self, values: Array, within: bool = False) -> Array:
        """Places where a function (K, n) passes through zero, ascending; jumps across zero too unless `within`."""
        return self.roots_of(np.asarray(values)[None], within)[0]

    def roots_of(self, values: Array, within: bool = False) -> list[Array]:
        """The same of functions (F, K, n), each its own."""
        ends = self.ends(values)
        rows = np.concatenate([ends[..., :1], values, ends[..., 1:]], axis=-1)
        signs = np.where(rows == 0, 1.0, np.sign(rows))
        # next to nothing at an end: what passes through zero there does so on the edge
        nothing = np.abs(ends) <= 1e-13 * np.abs(rows).max(axis=(-2, -1), keepdims=True)
        signs[..., 0] = np.where(nothing[..., 0], signs[..., 1], signs[..., 0])
        signs[..., -1] = np.where(nothing[..., 1], signs[..., -2], signs[..., -1])
        f, k, i = np.nonzero(signs[..., :-1] * signs[..., 1:] < 0)
        on = grid(self.order)
        t = zeros(values[f, k], on[i], on[i + 1], signs[f, k, i])
        found = self.edges[k] + self.half[k, 0] * (1 + t)
        each = [found[f == one] for one in range(len(values))]
        if within:
            return [np.sort(places) for places in each]
        before, after = signs[..., -1], np.roll(signs[..., 0], -1, axis=-1)
        jumps = [self.edges[1:][across] for across in before * after < 0]
        return [self._once(np.concatenate(both)) for both in zip(each, jumps, strict=True)]

    def _once(self, places: Array) -> Array:
        """Ascending, within the period; what is found from both sides of an edge is one."""
        near = NARROWEST * self.period
        inside = np.sort(np.where(places > self.period - near, 0.0, places))
        return inside[np.diff(inside, prepend=-1.0) > near]


def panels(
    period: float, breaks: Array | Sequence[float] = (), widest: float = WIDEST, order: int = ORDER
) -> Panels:
    """Panels over a period, none wider than `widest`, with edges at all the breaks within it."""
    inside = np.mod(np.asarray(breaks, dtype=float), period)
    marks = distinct(np.concatenate([[0.0], inside, [period]]))
    keep = np.concatenate([[True], np.diff(marks) > NARROWEST * period])
    marks = marks[keep]
    marks[-1] = period  # a break next to the end is the end
    counts = np.maximum(1, np.ceil(np.diff(marks) / widest - 1e-9).astype(int))
    return Panels(cut(marks, counts), order)


def cut(edges: Array, counts: Array) -> Array:
    """Edges (K+1,) with each of the panels cut into so many (K,) equal ones."""
    first = np.cumsum(counts) - counts
    part = np.arange(counts.sum()) - np.repeat(first, counts)
    starts, steps = (np.repeat(x, counts) for x in (edges[:-1], np.diff(edges) / counts))
    return np.append(part * steps + starts, edges[-1])
