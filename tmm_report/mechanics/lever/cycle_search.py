"""Roots over one sweep of the driving link: their brackets, finer beside singular positions, and the search in them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.brackets import LOW, certain, dips, finer, lowest, opened, signed_brackets
from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.roots import Finder, bracketed, interpolated
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.mechanism import Scalar
from tmm_report.mechanics.lever.meeting import AT, BESIDE, meets, settle
from tmm_report.mechanics.lever.motion import Linkage, Motion, solve, solve_by_law
from tmm_report.mechanics.lever.singular import Critical
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.calculus.motion_laws import MotionLaw

Array = Any
Quantity = Callable[[Motion], Array]

SEARCH = 720  # brackets of the root search over a turn
NOISE = 1e-13  # rounding error of a solved rate, relative to its largest value, to which a root is found
INTERPOLATED = 100.0  # times that error: what is interpolated over a change point has
STEP = 1e-4  # rad, of the difference that stands for a derivative that is not solved for
STEP_NOISE = 1e-9  # rounding error of such a difference
FULL_TURN = 2 * np.pi


@dataclass(frozen=True, eq=False)
class Slope:
    """Derivative of a quantity by the angle turned, by central difference: good for finding extremes of the highest
    derivative, whose own derivative is not solved for."""

    of: Quantity


Rate = Quantity | Slope


@dataclass(frozen=True, eq=False)
class Search:
    """A linkage over a sweep of its driving link, from position 0 in the sense of rotation."""

    linkage: Linkage
    zero: Scalar  # angle of the driving link in position 0, rad
    critical: tuple[Critical, ...] = ()  # singular positions of the groups, by the driver's angle

    @property
    def sense(self) -> int:
        return 1 if np.ravel(self.linkage.mechanism.driver.omega)[0] > 0 else -1

    @property
    def sweep(self) -> float:
        return self.linkage.mechanism.driver.sweep

    @property
    def closed(self) -> bool:
        """Whether the driving link makes full turns, or its law repeats."""
        return self.sweep >= FULL_TURN - 1e-12 if self.law is None else self.law.returns

    @property
    def law(self) -> MotionLaw | None:
        """By which the driving link moves, where it does not turn uniformly: angles turned are then phases."""
        return self.linkage.mechanism.driver.law

    def phi(self, turned: Array) -> Array:
        return self.zero + self.sense * turned if self.law is None else self.law.of_phase(turned)[0]

    def turned_at(self, angles: Sequence[float] | Array) -> Array:
        """Angles turned, within a full turn, at which the driving link makes some angles, rad."""
        if self.law is not None:
            return self.law.when(angles)
        return np.mod(self.sense * (np.array(angles) - self.zero), FULL_TURN)

    def _solved(self, turned: Array) -> Motion:
        return (
            solve(self.linkage, self.phi(turned)) if self.law is None else solve_by_law(self.linkage, turned)
        )

    @cached_property
    def returns(self) -> bool:
        """Whether the motion goes on as it began, once the driving link has turned all round."""
        return self.closed and all(c.run is None or c.run.returns for c in self.critical)

    def motion(self, turned: Array) -> Motion:
        """Motion at angles turned from position 0, rad; in change points its limit, in corners the places before them,
        but in position 0 those after it."""
        turned = np.asarray(turned, dtype=float)
        motion = self._solved(turned)
        if self.meets:
            settle(motion, side_of(turned))
        return motion

    def beside(self, turned: Array, side: int) -> Motion:
        """Motion at angles turned, of which those of corners are its limits before (-1) or after them (+1)."""
        motion = self._solved(turned)
        settle(motion, side, alone=True)
        return motion

    @cached_property
    def _even(self) -> tuple[Array, Motion]:
        """Angles turned in equal steps over a turn, rad, and the motion there."""
        grid = np.linspace(0.0, self.sweep, SEARCH + 1)
        # half a step aside, so that a root at position 0 falls inside a bracket and not on its edge
        grid = grid - (grid[1] / 2 if self.returns else 0.0)
        return grid, self.motion(grid)

    @cached_property
    def search(self) -> tuple[Array, Motion]:
        """Angles turned that bracket the roots, and the motion there: ever finer beside singular positions."""
        grid, motion = self._even
        marks = self._marks
        if not marks.size:
            return grid, motion
        beside = finer(marks)
        if self.returns:
            beside = grid[0] + np.mod(beside - grid[0], self.sweep)
        beside = beside[(beside > grid[0]) & (beside < grid[-1])]
        grid = distinct(np.concatenate([grid, beside]))
        return grid, self.motion(grid)

    @property
    def meets(self) -> bool:
        """Whether two assemblies of a group meet within a turn."""
        return meets(self.linkage.groups)

    @cached_property
    def _marks(self) -> Array:
        """Angles turned at which a group is singular, or nearest to it and near, rad."""
        exact = [x for c in self.critical for x in (*c.limits, *c.changes)]
        near = [] if self.linkage.axes else [self._lowest(label) for label in self._even[1].sines]
        return np.concatenate([self.turned_at(exact), *near])

    def _lowest(self, label: str) -> Array:
        """Angles turned at which the closeness of a group is least and below `LOW`, rad."""
        grid, motion = self._even
        square = motion.sines[label] ** 2
        around = square if not self.returns else np.append(square, square[1])
        middle = np.flatnonzero((around[1:-1] <= around[:-2]) & (around[1:-1] < around[2:])) + 1
        middle = middle[around[middle] < LOW**2]
        if not middle.size:
            return np.array([])
        step = grid[1] - grid[0]
        three = grid[middle] + np.array([[-step], [0.0], [step]])
        values = np.stack([around[middle - 1], around[middle], around[middle + 1]])
        return lowest(lambda x: self.motion(x).sines[label] ** 2, three, values)[0]

    @cached_property
    def _closeness(self) -> Array:
        """How near the nearest of the groups is to a singular position, at the angles of the search, (P,)."""
        motion = self.search[1]
        sines = [
            # what is taken from neighbours is as sure as where that begins
            np.maximum(sine, BESIDE) if group.meetings else sine
            for group, sine in ((g, motion.sines[g.group.label]) for g in self.linkage.groups)
        ]
        return np.fmin.reduce([np.ones(motion.shape), *sines])

    @cached_property
    def _search_beside(self) -> Motion:
        """The motion a step ahead of the angles of the search, then a step behind."""
        grid = self.search[0]
        return self.motion(np.concatenate([grid + STEP, grid - STEP]))

    def roots(self, rate: Rate) -> Array:
        """Angles turned, sorted, at which `rate` of the motion passes through zero, rad."""
        return self.roots_of([rate])[0]

    def roots_of(self, rates: Sequence[Rate], finder: Finder = interpolated) -> list[Array]:
        """Roots of several rates, all found together: a motion of many angles costs hardly more than of one."""
        if not rates:
            return []
        rows = [self.searched(rate) for rate in rates]
        sizes = [self._size(row) for row in rows]
        over = [self._brackets(row, size) for row, size in zip(rows, sizes, strict=True)]
        pairs = self._pairs(rates, rows, sizes)
        low, high, starts = (
            [np.concatenate([b[k], p[k]]) for b, p in zip(over, pairs, strict=True)] for k in range(3)
        )
        counts = [len(x) for x in low]
        parts = np.cumsum(counts)[:-1]

        def sampled(x: Array) -> Array:
            return np.concatenate(self.sampled(rates, np.split(x, parts)))

        found = left = np.concatenate(low)
        if found.size:
            floor = INTERPOLATED if self.meets else 1.0
            noise = np.repeat(
                [floor * noise_of(rate) * size for rate, size in zip(rates, sizes, strict=True)], counts
            )
            found, left = finder(sampled, found, np.concatenate(high), np.concatenate(starts), noise)
        # a pole changes sign too; beside a singular position rounding errors leave more of a rate than elsewhere
        least = np.maximum(1e-6 * np.repeat(sizes, counts), 1e-2 * np.abs(np.concatenate(starts)))
        real = np.abs(left) <= least
        each = zip(np.split(found, parts), np.split(real, parts), over, strict=True)
        return [self.within(np.concatenate([roots[good], jumps])) for roots, good, (*_, jumps) in each]

    def _size(self, row: Array) -> float:
        """Greatest magnitude of a rate at the equal steps: near a limit it may grow without bound."""
        grid, even = self.search[0], self._even[0]
        if grid.size > even.size:
            row = row[np.searchsorted(grid, even)]
        return float(np.nanmax(np.abs(row), initial=0.0))

    def _brackets(self, row: Array, size: float) -> tuple[Array, Array, Array, Array]:
        """Both ends of the brackets of a rate's roots, its values at the low ends, and the corners at which it jumps
        from one sign to the other."""
        grid, motion = self.search
        low, high = signed_brackets(row, certain(row, self._closeness, size), motion.closes)
        over = (grid[low, None] < self.corners) & (self.corners < grid[high, None])
        smooth, jumps = ~over.any(axis=-1), self.corners[over.any(axis=0)]
        return grid[low[smooth]], grid[high[smooth]], row[low[smooth]], jumps

    def _pairs(
        self, rates: Sequence[Rate], rows: Sequence[Array], sizes: Sequence[float]
    ) -> list[tuple[Array, Array, Array]]:
        """Brackets of roots that lie by twos within a step of the search: no sign changes on it, but the rate comes to
        zero between."""
        grid = self.search[0]
        if self.returns:
            grid = np.append(grid, grid[1] + self.sweep)
            rows = [np.append(row, row[1]) for row in rows]
        middles = [
            np.flatnonzero(dips(row, 1e3 * noise_of(rate) * size))
            for rate, row, size in zip(rates, rows, sizes, strict=True)
        ]
        parts = np.cumsum([at.size for at in middles])[:-1]
        at = np.concatenate(middles)
        if not at.size:
            return [(np.array([]),) * 3] * len(rates)
        values = [np.stack([row[at + k] for k in (-1, 0, 1)]) for row, at in zip(rows, middles, strict=True)]
        *ends, good = opened(
            lambda x: np.concatenate(self.sampled(rates, np.split(x, parts))),
            grid, np.concatenate(values, axis=-1), at, np.ones(at.shape, dtype=bool),
        )  # fmt: skip
        each = zip(*(np.split(part, parts, axis=-1) for part in (*ends, good)), strict=True)
        return [(low[:, k].ravel(), high[:, k].ravel(), start[:, k].ravel()) for low, high, start, k in each]

    @cached_property
    def corners(self) -> Array:
        """Angles turned at which a group is in a change point that is not passed smoothly, rad."""
        found = [
            c.group.corner for c in self.critical if isinstance(c.group, Dyad) and c.group.corner is not None
        ]
        turned = self.turned_at(found)
        return np.where(np.minimum(turned, FULL_TURN - turned) < AT, 0.0, turned)

    def searched(self, rate: Rate) -> Array:
        """A rate at the angles of the search."""
        if not isinstance(rate, Slope):
            return np.broadcast_to(np.real(rate(self.search[1])), self.search[1].shape)
        return _difference(np.real(rate.of(self._search_beside)))

    def sampled(self, rates: Sequence[Rate], turned: Sequence[Array]) -> list[Array]:
        """Each rate at its own angles turned, all from one motion."""
        points = [
            np.concatenate([x + STEP, x - STEP], axis=-1) if isinstance(rate, Slope) else x
            for rate, x in zip(rates, turned, strict=True)
        ]
        motion = self.motion(np.concatenate(points, axis=-1))
        found, start = [], 0
        for rate, x in zip(rates, points, strict=True):
            end = start + x.shape[-1]
            values = np.real((rate.of if isinstance(rate, Slope) else rate)(motion))[..., start:end]
            found.append(_difference(values) if isinstance(rate, Slope) else values)
            start = end
        return found

    def within(self, turned: Array) -> Array:
        """Angles turned, ascending, within one turn."""
        if self.returns:
            turned = np.mod(turned, self.sweep)
            turned = np.where(
                np.minimum(turned, self.sweep - turned) < 1e-9, 0.0, turned
            )  # a turn is no turn
        return np.sort(turned)

    def moves(self, rate: Quantity, size: Quantity) -> bool:
        """Whether a rate is more than rounding beside `size` anywhere."""
        motion = self.search[1]
        largest = [np.nanmax(np.abs(of(motion)), initial=0.0) for of in (rate, size)]
        return bool(largest[0] > 1e-9 * largest[1])

    def swings(self, rate: Quantity, size: Quantity) -> Array:
        """Roots of a rate that is more than rounding beside `size`; none of one that is zero all round.

        By regula falsi, as ever: position 0 is made of them, and all tables keep their last digits with it.
        """
        return self.roots_of([rate], bracketed)[0] if self.moves(rate, size) else np.array([])


def side_of(turned: Array) -> Array:
    """The side of a corner whose places are taken at angles turned: at position 0 the motion begins after it."""
    return np.where(np.abs(turned) < AT, 1, -1)


def noise_of(rate: Rate) -> float:
    """Rounding error of a rate, relative to its largest value."""
    return STEP_NOISE if isinstance(rate, Slope) else NOISE


def _difference(values: Array) -> Array:
    """Slope of values of which the first half stands a step ahead and the second a step behind."""
    ahead, behind = np.split(values, 2, axis=-1)
    return (ahead - behind) / (2 * STEP)
