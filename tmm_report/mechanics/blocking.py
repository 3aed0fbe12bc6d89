"""Blocking contour: the region of shifts (x1, x2) in which a pair of wheels can work, and the lines that bound it.

A point of the plane is the complex number x1 + i x2. Every point is a pair without backlash at its own centre distance
(`spur.meshed`); where the shifts leave no such distance the margins are nan and the point is not feasible.
Source: Bolotovsky, Involute gears: a reference book, part 1 (contours for pairs cut by a rack).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics import spur
from tmm_report.mechanics.isolines import isolines
from tmm_report.mechanics.spur import Pair, Rack

Array = Any
Window = tuple[complex, complex]  # lower left and upper right corner

SMALLEST, LARGEST = 2.0, 64.0  # half the side of the square in which the region is sought
COARSE, FINE = 81, 101  # points along the sides of the grids
AROUND = 0.3  # free room left round the region
ROUNDING = 1e-9  # what a margin may lack by rounding


class Limit(NamedTuple):
    """`value` of a pair must be at least `bound`. `wheel`: 1 or 2; 0 for both."""

    kind: str  # undercut, pointing, ratio, interference, fouling
    wheel: int
    bound: float
    value: Callable[[Pair], Array]

    def margin(self, pair: Pair) -> Array:
        return self.value(pair) - self.bound


class Line(NamedTuple):
    """A line of the plane on which a quality equals `level`, in `pieces` of x1 + i x2, each (N,)."""

    kind: str  # of a Limit, or sliding, distance
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
    tips: tuple[float, ...] = field(default=(0.0, 0.25, 0.3), kw_only=True)
    ratios: tuple[float, ...] = field(default=(1.0, 1.2), kw_only=True)

    def pair(self, x: Array) -> Pair:
        return spur.meshed(
            self.z1, self.z2, self.m, self.rack, self.beta, np.real(x), np.imag(x), self.internal
        )

    @cached_property
    def limits(self) -> tuple[Limit, ...]:
        limits = [Limit("undercut", i + 1, self._least_shift(i), _shift(i)) for i in self._cut_by_rack]
        limits += [Limit("pointing", i + 1, self.least_thickness, _tip(i)) for i in (0, 1)]
        limits += [Limit("ratio", 0, self.least_ratio, lambda pair: pair.eps)]
        limits += [Limit("interference", i + 1, 0.0, _interference(i)) for i in (0, 1)]
        return (
            (*limits, Limit("fouling", 0, 0.0, lambda pair: pair.fouling)) if self.internal else tuple(limits)
        )

    @property
    def _cut_by_rack(self) -> tuple[int, ...]:
        """Wheels that are not rings."""
        if not self.internal:
            return 0, 1
        return (0,) if self.z1 < self.z2 else (1,)

    def _least_shift(self, i: int) -> float:
        return float(spur.least_shift((self.z1, self.z2)[i], self.rack, self.beta))

    # ------------------------------------------------------------ a point

    def margin(self, x: Array) -> Array:
        """The least of the margins of all limits at x1 + i x2; −1 where there is no such pair."""
        least = np.min(self._margins(x), axis=0)
        return np.where(np.isfinite(least), least, -1.0)

    def _margins(self, x: Array) -> Array:
        """(limits, ...)."""
        pair = self.pair(x)
        return np.array([limit.margin(pair) + 0 * np.real(x) for limit in self.limits])

    def lacks(self, x: complex) -> tuple[Lack, ...]:
        """The limits that a point breaks."""
        pair = self.pair(x)
        found = [Lack(limit, float(limit.value(pair)), -float(limit.margin(pair))) for limit in self.limits]
        return tuple(lack for lack in found if not lack.lack <= ROUNDING)

    def nearest(self, x: complex) -> complex | None:
        """The feasible point nearest to x, to 1e-9; None where no point is feasible. Every round halves the net."""
        grid, good = self._coarse
        if self.margin(x) >= -ROUNDING:
            return x
        if not good.any():
            return None
        centre = _closest(grid[good], x)
        reach = 2 * float(abs(grid[0, 1] - grid[0, 0]))
        while reach > 1e-10:
            net = centre + _grid((-reach * (1 + 1j), reach * (1 + 1j)), 17)
            centre = _closest(np.append(net[self.margin(net) >= 0], centre), x)
            reach /= 2
        return centre

    def nearest_at_distance(self, x: complex) -> complex | None:
        """The feasible point nearest to x among those of the same centre distance; None where there is none."""
        along = (1 + 1j if self.internal else 1 - 1j) / np.sqrt(2)
        centre, reach = x, 2 * float(np.abs(self._coarse[0]).max())
        found: complex | None = None
        while reach > 1e-10:
            net = centre + along * reach * np.linspace(-1, 1, 1025)
            good = net[self.margin(net) >= 0]
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
            good = self.margin(grid) >= 0
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
        low, high = window
        within = (x.real >= low.real) & (x.real <= high.real) & (x.imag >= low.imag) & (x.imag <= high.imag)
        return np.where(within, self.margin(x), -1.0)

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
        x, step = (a + b) / 2, 1e-6
        for _ in range(12):
            at = x + step * np.array([0, 1, -1, 1j, -1j])
            g = self._margins(at)[which]
            slopes = np.stack([g[:, 1] - g[:, 2], g[:, 3] - g[:, 4]], axis=1) / (2 * step)
            if not np.isfinite(g).all() or abs(np.linalg.det(slopes)) < 1e-12:
                return None
            move = np.linalg.solve(slopes, g[:, 0])
            x -= complex(*move)
            if abs(complex(*move)) < 1e-12:
                break
        return x if abs(x - (a + b) / 2) < 2 * abs(b - a) else None

    def lines(self, window: Window, x: complex) -> tuple[Line, ...]:
        """All lines of the contour; that of constant centre distance goes through `x`."""
        grid = _grid(window, FINE)
        pair, drawn = self.pair(grid), []
        for quality, levels in self._qualities(x):
            values = quality.value(pair)
            for c in levels:
                pieces = isolines(partial(self._above, quality.value, c), grid, values - c)
                drawn.append(Line(quality.kind, quality.wheel, c, pieces))
        return tuple(line for line in drawn if line.pieces)

    def _above(self, value: Callable[[Pair], Array], level: float, x: Array) -> Array:
        return value(self.pair(x)) - level

    def _qualities(self, x: complex) -> list[tuple[Limit, list[float]]]:
        """Every quality with the levels at which its lines are drawn."""
        more = {"pointing": self.tips, "ratio": self.ratios}
        rows = [(limit, sorted({*more.get(limit.kind, ()), limit.bound})) for limit in self.limits]
        x_sum = x.imag - x.real if self.internal else x.real + x.imag
        rows.append((Limit("sliding", 0, 0.0, _sliding), [0.0]))
        return [*rows, (Limit("distance", 0, x_sum, lambda pair: pair.x_sum), [x_sum])]


def _shift(i: int) -> Callable[[Pair], Array]:
    return lambda pair: (pair.x1, pair.x2)[i] + 0 * pair.a_w


def _tip(i: int) -> Callable[[Pair], Array]:
    return lambda pair: pair.s_na[i] / pair.m


def _interference(i: int) -> Callable[[Pair], Array]:
    return lambda pair: pair.interference[i] / pair.m


def _sliding(pair: Pair) -> Array:
    """0 where the roots of both wheels slide equally; nan where a profile is not reached."""
    reached = (pair.rho_p[0] > 0) & (pair.rho_p[1] > 0)
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
