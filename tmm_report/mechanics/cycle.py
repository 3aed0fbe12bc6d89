"""One cycle of the driving link: numbering of positions, extreme positions and extremes by root finding."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, assert_never

import numpy as np

from tmm_report.mechanics.cam_breaks import breaks
from tmm_report.mechanics.cam_laws import EDGE
from tmm_report.mechanics.mechanism import Scalar, ZeroAngle, ZeroExtreme
from tmm_report.mechanics.motion import Linkage, Motion, solve
from tmm_report.mechanics.planar import dot
from tmm_report.mechanics.roots import Finder, bracketed, interpolated
from tmm_report.mechanics.singular import Critical, criticals, settle
from tmm_report.problems import N_, Message, ProblemError, mistake

Array = Any
Quantity = Callable[[Motion], Array]

SEARCH = 720  # brackets of the root search over a turn; two extremes nearer than half a degree count as none
NOISE = 1e-13  # rounding error of a solved rate, relative to its largest value, to which a root is found
EQUAL = 1e-12  # values nearer than this part of the largest are one
STEP = 1e-4  # rad, of the difference that stands for a derivative that is not solved for
STEP_NOISE = 1e-9  # rounding error of such a difference
FULL_TURN = 2 * np.pi


@dataclass(frozen=True)
class Extreme:
    """An extreme value and the angle turned from position 0, rad, at which it is reached."""

    value: float
    turned: float


@dataclass(frozen=True, eq=False)
class Slope:
    """Derivative of a quantity by the angle turned, by central difference: good for finding extremes of the highest
    derivative, whose own derivative is not solved for."""

    of: Quantity


Rate = Quantity | Slope


def least_and_greatest(values: Array, turned: Array) -> tuple[Extreme, Extreme]:
    """Extremes among values (P,) at angles `turned`, rad; nan is passed over; of nothing but nan, nan."""
    low, high = np.fmin.reduce(values), np.fmax.reduce(values)
    if np.isnan(low):
        return Extreme(np.nan, np.nan), Extreme(np.nan, np.nan)
    alike = EQUAL * max(abs(low), abs(high))
    return _first(values <= low + alike, values, turned), _first(values >= high - alike, values, turned)


def larger(extremes: tuple[Extreme, Extreme]) -> Extreme:
    """Of the least and the greatest value the one with the larger magnitude; of equal ones the first."""
    first, second = sorted(extremes, key=lambda extreme: extreme.turned)
    return second if abs(second.value) > abs(first.value) * (1 + EQUAL) else first


def _first(alike: Array, values: Array, turned: Array) -> Extreme:
    """Of values that rounding alone tells apart the first from position 0."""
    at = np.flatnonzero(alike)
    first = at[np.argmin(turned[at])]
    return Extreme(float(values[first]), float(turned[first]))


@dataclass(frozen=True, eq=False)
class Cycle:
    """Position 0 and the sweep of the driving link: positions are numbered in the sense of rotation.

    The motion repeats with each `sweep`, and is searched over one of them; loads repeat with the `period`, which may
    take several turns.
    """

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
    def turns(self) -> int:
        """How many turns the cycle takes."""
        return self.linkage.mechanism.driver.turns

    @property
    def period(self) -> float:
        """The whole cycle, rad."""
        return self.sweep * self.turns

    @property
    def closed(self) -> bool:
        """Whether the driving link makes full turns."""
        return self.sweep >= FULL_TURN - 1e-12

    def turned(self, count: int) -> Array:
        """Angle turned from position 0 at `count` equal steps of the cycle, rad, (P,): 0..count-1, or to count if not
        closed."""
        return np.arange(count if self.closed else count + 1) * (self.period / count)

    def once(self, count: int) -> Array:
        """The same angles with the last, each within its own turn, rad, (count + 1,): where the motion repeats, the
        angle does to the last bit. Position N of a full turn is position 0."""
        k = np.arange(count + 1)
        return (k * self.turns % count if self.closed else k) * (self.sweep / count)

    def repeated(self, turned: Array) -> Array:
        """Angles turned (P,) within one turn, and the same of every other turn of the cycle, rad."""
        return np.concatenate([turned + k * self.sweep for k in range(self.turns)])

    def phi(self, turned: Array) -> Array:
        return self.zero + self.sense * turned

    def motion(self, turned: Array) -> Motion:
        """Motion at angles turned from position 0, rad; in change points its limit."""
        motion = solve(self.linkage, self.phi(np.asarray(turned, dtype=float)))
        if any(group.changes for group in self.linkage.groups):
            settle(motion)
        return motion

    @cached_property
    def search(self) -> tuple[Array, Motion]:
        """Angles turned that bracket the roots, and the motion there."""
        grid = np.linspace(0.0, self.sweep, SEARCH + 1)
        # half a step aside, so that a root at position 0 falls inside a bracket and not on its edge
        grid = grid - (grid[1] / 2 if self.closed else 0.0)
        return grid, self.motion(grid)

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
        values = [self.searched(rate) for rate in rates]
        turns = [changes_of_sign(row) for row in values]
        sizes = [float(np.nanmax(np.abs(row), initial=0.0)) for row in values]
        counts = [len(at) for at in turns]
        parts = np.cumsum(counts)[:-1]

        def sampled(x: Array) -> Array:
            return np.concatenate(self.sampled(rates, np.split(x, parts)))

        grid, at = self.search[0], np.concatenate(turns) if turns else np.array([], dtype=int)
        if not at.size:
            return [np.array([])] * len(rates)
        noise = [
            (STEP_NOISE if isinstance(rate, Slope) else NOISE) * size
            for rate, size in zip(rates, sizes, strict=True)
        ]
        starts = np.concatenate([row[k] for row, k in zip(values, turns, strict=True)])
        found, left = finder(sampled, grid[at], grid[at + 1], starts, np.repeat(noise, counts))
        real = np.abs(left) <= 1e-6 * np.repeat(sizes, counts)  # a pole changes sign too
        each = zip(np.split(found, parts), np.split(real, parts), strict=True)
        return [self.within(roots[good]) for roots, good in each]

    def searched(self, rate: Rate) -> Array:
        """A rate at the angles of the search."""
        if not isinstance(rate, Slope):
            return np.real(rate(self.search[1]))
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
        if self.closed:
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

    def extremes(self, value: Quantity, rate: Rate) -> tuple[Extreme, Extreme]:
        """The least and the greatest `value` of the motion; `rate` is its derivative by time or angle."""
        return self.extremes_of([value], [self.roots(rate)])[0]

    def extremes_of(
        self, values: Sequence[Quantity], still: Sequence[Array]
    ) -> list[tuple[Extreme, Extreme]]:
        """The least and the greatest of several values, which stand still at the angles turned `still`."""
        ends = [0.0] if self.closed else [0.0, self.sweep]
        where = [np.concatenate([roots, ends, self._limits]) for roots in still]
        found = self.sampled(values, where)
        return [least_and_greatest(row, x) for row, x in zip(found, where, strict=True)]

    @cached_property
    def limits(self) -> Array:
        """Angles turned from position 0 at which a group comes to the limit of its assembly, rad, of a turn."""
        limits = np.array([x for critical in self.critical for x in critical.limits])
        return np.mod(self.sense * (limits - self.zero), FULL_TURN)

    @cached_property
    def _limits(self) -> Array:
        """Angles turned just within the limits of assembly, rad: something may be extreme there and not stand still."""
        turned = np.mod((self.limits[:, None] + np.array([-1e-9, 1e-9])).ravel(), FULL_TURN)
        turned = np.concatenate([turned, self._jumps])
        return turned[turned <= self.sweep]

    @property
    def _jumps(self) -> Array:
        """Angles turned at which the accelerations of a cam may jump, and just before them, rad."""
        found = np.mod(self.sense * (breaks(self.linkage.mechanism) - self.zero), FULL_TURN)
        return np.mod((found[:, None] + np.array([-3 * EDGE, 0.0])).ravel(), FULL_TURN)


def changes_of_sign(values: Array) -> Array:
    """Where the next value has another sign, (N,) of int; a zero on the grid itself ends its bracket."""
    signs = np.where(values == 0, 1.0, np.sign(values))
    return np.flatnonzero(signs[:-1] * signs[1:] < 0)


def _difference(values: Array) -> Array:
    """Slope of values of which the first half stands a step ahead and the second a step behind."""
    ahead, behind = np.split(values, 2, axis=-1)
    return (ahead - behind) / (2 * STEP)


def cycle_of(linkage: Linkage) -> Cycle:
    """The cycle with position 0 as the variant states it, its linkage going smoothly through change points.

    Raises ProblemError if position 0 does not exist.
    """
    zero = linkage.mechanism.driver.zero
    match zero:
        case ZeroAngle(angle):
            smooth, critical = criticals(linkage, angle)
        case ZeroExtreme():
            smooth, critical = criticals(linkage, 0.0)
            angle = extreme_angle(smooth, zero)
            if any(c.changes for c in critical):  # stated assemblies hold at position 0
                smooth, critical = criticals(linkage, angle)
        case _:
            assert_never(zero)
    return Cycle(smooth, angle, critical)


def extreme_angle(linkage: Linkage, zero: ZeroExtreme) -> float:
    """Driver angle of the extreme position that is to be position 0, rad."""
    start = Cycle(linkage, 0.0)
    if not start.search[1].closes.any():
        return 0.0  # that no position exists is said later, with the reason
    if zero.point is not None:
        point, direction = zero.point, zero.direction
        roots = start.swings(lambda m: dot(m.velocity(point), direction), lambda m: np.abs(m.velocity(point)))
        reached = dot(start.motion(roots).place(point), direction) if roots.size else np.array([])
    else:
        link = str(zero.link)
        roots = start.swings(lambda m: m.angular_velocity(link), lambda m: m.omega)
        reached = _rocker_angle(start, link, roots) * np.real(zero.direction) if roots.size else np.array([])
    if not roots.size:
        name = zero.point or zero.link
        text = N_("%(name)s has no extreme position: it never stops within the cycle")
        right = Message(N_("state position 0 by an angle, or by another point"))
        raise ProblemError([mistake(text, ("mechanism", "driver", "zero"), right, name=name)])
    return float(start.phi(roots[np.argmax(reached)]))


def _rocker_angle(cycle: Cycle, link: str, turned: Array) -> Array:
    """Angle of a rocker about its middle over the cycle, so that the cut of atan2 is out of its way, rad."""
    u = cycle.motion(np.linspace(0, cycle.sweep, 37)[:-1]).turn(link)
    middle = np.nanmean(u)
    return np.angle(cycle.motion(turned).turn(link) / middle)
