"""Blocking contour: the region of shifts (x1, x2) in which a pair of wheels can work, and the lines that bound it.

A point of the plane is the complex number x1 + i x2. Every point is a pair without backlash at its own centre distance
(`spur.meshed`); where the shifts leave no such distance the margins are nan and the point is not feasible.
Source: Bolotovsky, Involute gears: a reference book, part 1 (contours for pairs cut by a rack).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import field
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.isolines import isolines
from tmm_report.mechanics.calculus.roots import bracketed
from tmm_report.mechanics.gears import meshing
from tmm_report.mechanics.gears.limits.pair import Limit, limits_of, unknown
from tmm_report.mechanics.gears.meshing import Cutter, Pair, Rack
from tmm_report.records import dataclass

__all__ = ["Blocking", "Lack", "Limit", "Line", "Window"]

Array = Any
Window = tuple[complex, complex]  # lower left and upper right corner

SMALLEST, LARGEST = 2.0, 64.0  # half the side of the square in which the region is sought
COARSE, FINE = 81, 101  # points along the sides of the grids
AROUND = 0.3  # free room left round the region
DIFFERENCE_STEP = 1e-4  # of shifts: error about its fourth power
ROUNDING = 1e-9  # what a margin may lack by rounding
DRAWN = ("space", "tips")  # of the limits beyond which there are no wheels, those that have lines


class Line(NamedTuple):
    """A line of the plane on which a quality equals `level`, in `pieces` of x1 + i x2, each (N,)."""

    kind: str  # of a Limit that a pair can be beyond, or sliding, distance
    wheel: int
    level: float
    pieces: tuple[Array, ...]


class Lack(NamedTuple):
    """A limit that a point breaks: the value there and how much it lacks."""

    limit: Limit
    value: float
    lack: float


@dataclass(frozen=True)
class Blocking:
    """Two wheels whose shifts are free. `least_thickness` of the tips, modules; `least_ratio` of contact."""

    z1: int
    z2: int
    m: float
    rack: Rack
    beta: float = 0.0
    internal: bool = False
    least_thickness: float = 0.3
    least_ratio: float = 1.05
    sliding: float | None = field(default=None, kw_only=True)
    shortened: bool = field(default=True, kw_only=True)
    trimmed: bool = field(default=False, kw_only=True)
    cutter: Cutter | None = field(default=None, kw_only=True)
    tips: tuple[float, ...] = field(default=(0.0, 0.25, 0.3), kw_only=True)
    ratios: tuple[float, ...] = field(default=(1.0, 1.2), kw_only=True)

    def pair(self, x: Array) -> Pair:
        wheels = self.z1, self.z2, self.m, self.rack, self.beta, np.real(x), np.imag(x), self.internal
        return meshing.meshed(*wheels, self.shortened, self.trimmed, self.cutter)

    @cached_property
    def limits(self) -> tuple[Limit, ...]:
        """By all of which the region is bounded."""
        return limits_of(self.pair(0j), self.least_thickness, self.least_ratio, self.sliding)

    # ------------------------------------------------------------ a point

    def margin(self, x: Array) -> Array:
        """The least of the margins of all limits at x1 + i x2; −1 where there is no such pair."""
        least = np.min(self._margins(x), axis=0)
        return np.where(np.isfinite(least), least, -1.0)

    def feasible(self, x: Array) -> Array:
        """Whether the points (...) break no limit."""
        # most of a plane is undercut, behind straight lines: no pair need be made there to see it
        low = self._lowest
        good = (x.real >= low.real) & (x.imag >= low.imag)
        good[good] = self.margin(x[good]) >= 0
        return good

    def _margins(self, x: Array) -> Array:
        """(limits, ...)."""
        pair = self.pair(x)
        with unknown():
            return np.array([limit.margin(pair) + 0 * np.real(x) for limit in self.limits])

    def lacks(self, x: complex) -> tuple[Lack, ...]:
        """The limits that a point breaks; where there is no such pair, that and what its shifts alone break."""
        pair = self.pair(x)
        with unknown():
            found = [
                Lack(limit, float(limit.value(pair)), -float(limit.margin(pair))) for limit in self.limits
            ]
        if not np.isfinite(pair.a_w):
            x1, x2 = float(np.real(x)), float(np.imag(x))
            shifts = [Lack(one, (x1, x2)[one.wheel - 1], one.bound - (x1, x2)[one.wheel - 1])
                      for one in self.limits if one.kind == "undercut"]  # fmt: skip
            found = [*shifts, *(lack for lack in found if lack.limit.kind == "mesh")]
        return tuple(lack for lack in found if not lack.lack <= ROUNDING)

    def nearest(self, x: complex) -> complex | None:
        """The feasible point nearest to x, to 1e-9; None where no point is feasible."""
        # the limits of undercut are straight lines: no feasible point is nearer than the one clear of them
        for point in (x, self._uncut(x)):
            if self.margin(point) >= -ROUNDING:
                return point
        found = [point for piece in self.region(self.window(x)) for point in self._nearest_on(piece, x)]
        return min(found, key=lambda point: abs(point - x), default=None)

    def _uncut(self, x: complex) -> complex:
        """The point nearest to x without undercut, whatever the other limits."""
        low = self._lowest
        return complex(max(x.real, low.real), max(x.imag, low.imag))

    @cached_property
    def _lowest(self) -> complex:
        """The least shifts without undercut; −∞ of a ring."""
        least = {limit.wheel: limit.bound for limit in self.limits if limit.kind == "undercut"}
        return complex(least.get(1, -np.inf), least.get(2, -np.inf))

    def _nearest_on(self, piece: Array, x: complex) -> Iterator[complex]:
        """The nearest vertex of a closed piece of the boundary, and what is nearer on the two sides that meet there."""
        ring = piece[:-1]
        real = np.abs(self.margin(ring)) < ROUNDING  # not a side of the window
        if not real.any():
            return
        k = int(np.argmin(np.where(real, np.abs(ring - x), np.inf)))
        yield complex(ring[k])
        for other in (k - 1, (k + 1) % len(ring)):
            foot = self._foot(x, complex(ring[k]), complex(ring[other])) if real[other] else None
            if foot is not None:
                yield foot

    def _foot(self, x: complex, a: complex, b: complex) -> complex | None:
        """Where a perpendicular from x meets the boundary between its neighbouring points a and b."""
        limit = int(np.nanargmin(np.abs(self._margins(np.array([a, b]))).sum(axis=1)))

        def slope(part: Array) -> Array:  # of the distance along the boundary
            points = self._projected(a + part * (b - a), limit)
            along = 1j * self._gradients(points)[limit]
            with unknown():
                return ((points - x) * along.conj()).real / np.abs(along)

        ends = np.array([0.0]), np.array([1.0])
        starts = slope(ends[0])
        if not starts[0] * slope(ends[1])[0] <= 0:
            return None
        part, _ = bracketed(slope, *ends, starts, 1e-13)
        foot = complex(self._projected(a + part * (b - a), limit)[0])
        return foot if self.margin(foot) >= -ROUNDING else None

    def _projected(self, points: Array, limit: int) -> Array:
        """Points moved onto the line of a limit along its gradient, by Newton's method."""
        for _ in range(5):
            slope = self._gradients(points)[limit]
            with unknown():
                points = points - self._margins(points)[limit] * slope / np.abs(slope) ** 2
        return points

    def _gradients(self, points: Array) -> Array:
        """Gradients of all margins at points (N,), complex, (limits, N), by central differences of fourth order."""
        steps = DIFFERENCE_STEP * np.array([2, 1, -1, -2])
        weights = np.array([-1, 8, -8, 1]) / (12 * DIFFERENCE_STEP)
        around = self._margins(points[:, None] + np.concatenate([steps, 1j * steps]))
        with unknown():
            return around[..., :4] @ weights + 1j * (around[..., 4:] @ weights)

    def nearest_at_distance(self, x: complex) -> complex | None:
        """The feasible point nearest to x among those of the same centre distance; None where there is none."""
        if self.margin(x) >= 0:
            return x
        along = (1 + 1j if self.internal else 1 - 1j) / np.sqrt(2)
        centre, reach = x, 2 * float(np.abs(self._coarse[0]).max())
        found: complex | None = None
        while reach > 1e-10:
            net = centre + along * reach * np.linspace(-1, 1, 1025)
            if found is not None:  # what lies beyond it need not be asked about
                net = net[np.abs(net - x) <= abs(found - x)]
            good = net[self.feasible(net)]
            good = good if found is None else np.append(good, found)
            if not good.size:
                return None
            found = _closest(good, x)
            centre, reach = found, reach / 256
        return found

    # ------------------------------------------------------------ the plane

    @cached_property
    def _coarse(self) -> tuple[Array, Array]:
        """A grid that holds the whole region, and which of its points are feasible; (COARSE, COARSE)."""
        half = SMALLEST
        while True:
            grid = _grid((-half * (1 + 1j), half * (1 + 1j)), COARSE)
            good = self.feasible(grid)
            edges = good[0].any() or good[-1].any() or good[:, 0].any() or good[:, -1].any()
            if half >= LARGEST or (good.any() and not edges):
                return grid, good
            half *= 2

    def window(self, x: complex) -> Window:
        """The box of `x` and of the part of the region nearest to it, with some room round them."""
        grid, good = self._coarse
        points = np.array([x])
        if good.any():
            start = np.argmin(np.where(good, np.abs(grid - x), np.inf))
            points = np.append(grid[_connected(good, int(start))], x)
        room = (AROUND + float(abs(grid[0, 1] - grid[0, 0]))) * (1 + 1j)
        return _corner(points, np.min) - room, _corner(points, np.max) + room

    def region(self, window: Window) -> tuple[Array, ...]:
        """Boundary of the feasible region in closed pieces of x1 + i x2, its corners among them, exact to 1e-9.

        What of the region lies outside the window is cut off along its sides.
        """
        step = abs(window[1] - window[0]) / FINE * (1 + 1j)
        grid = _grid((window[0] - step, window[1] + step), FINE)
        return tuple(
            self._with_corners(piece) for piece in isolines(partial(self._margin_within, window), grid)
        )

    def _margin_within(self, window: Window, x: Array) -> Array:
        """The margin, or the distance from the nearest side of the window where that is less."""
        low, high = window[0] - x, x - window[1]
        return np.minimum(self.margin(x), -np.max([low.real, low.imag, high.real, high.imag], axis=0))

    def _with_corners(self, chain: Array) -> Array:
        """The chain with the points put in where one limit takes over from another."""
        active = np.argmin(self._margins(chain), axis=0)
        out = [chain[:1]]
        for k in range(len(chain) - 1):
            if active[k] != active[k + 1]:
                corner = self._corner(chain[k], chain[k + 1], [int(active[k]), int(active[k + 1])])
                out += [] if corner is None else [np.array([corner])]
            out.append(chain[k + 1 : k + 2])
        return np.concatenate(out)

    def _corner(self, a: complex, b: complex, which: list[int]) -> complex | None:
        """Where the margins of two limits are both 0, by Newton's method; None where that is not between a and b."""
        x = np.array([(a + b) / 2])
        for _ in range(8):
            g = self._margins(x)[which, 0]
            one, other = self._gradients(x)[which, 0]
            turn = (one.conjugate() * other).imag
            if not np.isfinite(g).all() or not abs(turn) > 1e-9:
                return None
            step = 1j * (g[1] * one - g[0] * other) / turn
            x = x - step
            if abs(step) < 1e-12:
                break
        off = np.abs(self._margins(x)[which, 0]).max()
        return complex(x[0]) if off < ROUNDING and abs(x[0] - (a + b) / 2) < 2 * abs(b - a) else None

    def lines(self, window: Window, x: complex) -> tuple[Line, ...]:
        """All lines of the contour; that of constant centre distance goes through `x`."""
        grid = _grid(window, FINE)
        pair, drawn = self.pair(grid), []
        for quality, levels in self._qualities(x):
            with unknown():
                values = quality.value(pair)
            for c in levels:
                pieces = isolines(partial(self._above, quality.value, c), grid, values - c)
                drawn.append(Line(quality.kind, quality.wheel, c, pieces))
        return tuple(line for line in drawn if line.pieces)

    def _above(self, value: Callable[[Pair], Array], level: float, x: Array) -> Array:
        with unknown():
            return value(self.pair(x)) - level

    def _qualities(self, x: complex) -> list[tuple[Limit, list[float]]]:
        """Every quality with the levels at which its lines are drawn."""
        more = {"pointing": self.tips, "contact": self.ratios}
        drawn = [limit for limit in self.limits if not limit.hard or limit.kind in DRAWN]
        rows = [(limit, sorted({*more.get(limit.kind, ()), limit.bound})) for limit in drawn]
        x_sum = x.imag - x.real if self.internal else x.real + x.imag
        rows.append((Limit("sliding", 0, 0.0, _sliding), [0.0]))
        return [*rows, (Limit("distance", 0, x_sum, lambda pair: pair.x_sum), [x_sum])]


def _sliding(pair: Pair) -> Array:
    """0 where the roots of both wheels slide equally; nan where a profile is not reached."""
    reached = (pair.rho_p[0] > 0) & (pair.rho_p[1] > 0) & (pair.active > 0)
    return np.where(reached, pair.sliding_difference / pair.m**2 / (pair.z1 * pair.z2), np.nan)


def _grid(window: Window, count: int) -> Array:
    low, high = window
    x1, x2 = np.linspace(low.real, high.real, count), np.linspace(low.imag, high.imag, count)
    return x1 + 1j * x2[:, None]


def _connected(good: Array, start: int) -> Array:
    """The true cells of `good` that hang together with the flat index `start`."""
    part = np.zeros_like(good)
    part.ravel()[start] = True
    while True:
        grown = part.copy()
        grown[1:] |= part[:-1]
        grown[:-1] |= part[1:]
        grown[:, 1:] |= part[:, :-1]
        grown[:, :-1] |= part[:, 1:]
        grown &= good
        if (grown == part).all():
            return part
        part = grown


def _corner(points: Array, pick: Callable[[Array], float]) -> complex:
    return complex(pick(points.real), pick(points.imag))


def _closest(points: Array, x: complex) -> complex:
    return complex(points[np.argmin(np.abs(points - x))])
