"""One cycle of the driving link: numbering of positions, extreme positions and extremes by root finding."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, assert_never

import numpy as np

from tmm_report.mechanics.mechanism import ZeroAngle, ZeroExtreme
from tmm_report.mechanics.motion import Linkage, Motion, solve
from tmm_report.mechanics.planar import dot
from tmm_report.mechanics.roots import bracketed
from tmm_report.mechanics.singular import Critical, criticals, settle
from tmm_report.problems import N_, Message, ProblemError, mistake

Array = Any
Rate = Callable[[Motion], Array]

SEARCH = 720  # brackets of the root search over a turn; two extremes nearer than half a degree count as none
FULL_TURN = 2 * np.pi


@dataclass(frozen=True)
class Extreme:
    """An extreme value and the angle turned from position 0, rad, at which it is reached."""

    value: float
    turned: float


def least_and_greatest(values: Array, turned: Array) -> tuple[Extreme, Extreme]:
    """Extremes among values (P,) at angles `turned`, rad; nan is passed over; of nothing but nan, nan."""
    if not np.isfinite(values).any():
        return Extreme(np.nan, np.nan), Extreme(np.nan, np.nan)
    low, high = np.nanargmin(values), np.nanargmax(values)
    return Extreme(float(values[low]), float(turned[low])), Extreme(float(values[high]), float(turned[high]))


@dataclass(frozen=True, eq=False)
class Cycle:
    """Position 0 and the sweep of the driving link: positions are numbered in the sense of rotation."""

    linkage: Linkage
    zero: float  # angle of the driving link in position 0, rad
    critical: tuple[Critical, ...] = ()  # singular positions of the groups, by the driver's angle

    @property
    def sense(self) -> int:
        return 1 if np.ravel(self.linkage.mechanism.driver.omega)[0] > 0 else -1

    @property
    def sweep(self) -> float:
        return self.linkage.mechanism.driver.sweep

    @property
    def closed(self) -> bool:
        """Whether the driving link makes full turns."""
        return self.sweep >= FULL_TURN - 1e-12

    def turned(self, count: int) -> Array:
        """Angle turned from position 0 at `count` equal steps, rad, (P,): 0..count-1, or to count if not closed."""
        return np.arange(count if self.closed else count + 1) * (self.sweep / count)

    def phi(self, turned: Array) -> Array:
        return self.zero + self.sense * turned

    def motion(self, turned: Array) -> Motion:
        """Motion at angles turned from position 0, rad; in change points its limit."""
        motion = solve(self.linkage, self.phi(np.asarray(turned, dtype=float)))
        if any(group.changes for group in self.linkage.groups):
            settle(motion)
        return motion

    @cached_property
    def _search(self) -> tuple[Array, Motion]:
        """Angles turned that bracket the roots, and the motion there."""
        grid = np.linspace(0.0, self.sweep, SEARCH + 1)
        # half a step aside, so that a root at position 0 falls inside a bracket and not on its edge
        grid = grid - (grid[1] / 2 if self.closed else 0.0)
        return grid, self.motion(grid)

    def roots(self, rate: Rate, noise: float = 1e-13) -> Array:
        """Angles turned, sorted, at which `rate` of the motion passes through zero, rad.

        `noise`: rounding error of the rate, relative to its largest value, to which a root is found.
        """
        grid, motion = self._search
        values = np.real(rate(motion))
        signs = np.where(values == 0, 1.0, np.sign(values))  # a root on the grid itself ends its bracket
        turns = np.flatnonzero(signs[:-1] * signs[1:] < 0)
        if turns.size:
            size = np.nanmax(np.abs(values), initial=0.0)
            brackets = grid[turns], grid[turns + 1], values[turns]
            found, left = bracketed(lambda x: np.real(rate(self.motion(x))), *brackets, noise=noise * size)
            found = found[np.abs(left) <= 1e-6 * size]  # a pole changes sign too
        else:
            found = np.array([])
        if self.closed:
            found = np.mod(found, self.sweep)
            found = np.where(np.minimum(found, self.sweep - found) < 1e-9, 0.0, found)  # a turn is no turn
        return np.sort(found)

    def swings(self, rate: Rate, size: Rate) -> Array:
        """Roots of a rate that is more than rounding beside `size`; none of one that is zero all round."""
        motion = self._search[1]
        moves = np.nanmax(np.abs(rate(motion)), initial=0.0) > 1e-9 * np.nanmax(
            np.abs(size(motion)), initial=0.0
        )
        return self.roots(rate) if moves else np.array([])

    def extremes(self, value: Rate, rate: Rate, noise: float = 1e-13) -> tuple[Extreme, Extreme]:
        """The least and the greatest `value` over the cycle; `rate` is its derivative by time or angle."""
        ends = [0.0] if self.closed else [0.0, self.sweep]
        where = np.concatenate([self.roots(rate, noise), ends, self._limits])
        values = np.real(value(self.motion(where)))
        return least_and_greatest(values, where)

    @cached_property
    def _limits(self) -> Array:
        """Angles turned just within the limits of assembly, rad: something may be extreme there and not stand still."""
        limits = np.array([x for critical in self.critical for x in critical.limits])
        turned = self.sense * (limits[:, None] - self.zero) + np.array([-1e-9, 1e-9])
        turned = np.mod(turned.ravel(), FULL_TURN)
        return turned[turned <= self.sweep]

    def slope(self, value: Rate, step: float = 1e-4) -> Rate:
        """Derivative of a quantity by the angle turned, by central difference: good for finding extremes of the
        highest derivative, whose own derivative is not solved for."""

        def rate(motion: Motion) -> Array:
            turned = (motion.phi - self.zero) * self.sense
            ahead, behind = self.motion(turned + step), self.motion(turned - step)
            return (np.real(value(ahead)) - np.real(value(behind))) / (2 * step)

        return rate


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
            angle = _extreme_angle(smooth, zero)
            if any(c.changes for c in critical):  # stated assemblies hold at position 0
                smooth, critical = criticals(linkage, angle)
        case _:
            assert_never(zero)
    return Cycle(smooth, angle, critical)


def _extreme_angle(linkage: Linkage, zero: ZeroExtreme) -> float:
    """Driver angle of the extreme position that is to be position 0, rad."""
    start = Cycle(linkage, 0.0)
    if not start._search[1].closes.any():
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
