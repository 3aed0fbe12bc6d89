"""One cycle of the driving link: numbering of positions, extreme positions and extremes by root finding."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from tmm_report.mechanics.mechanism import ZeroAngle
from tmm_report.mechanics.motion import Linkage, Motion, solve
from tmm_report.mechanics.planar import dot
from tmm_report.problems import Message, N_, ProblemError, mistake

Array = Any
Rate = Callable[[Motion], Array]

SEARCH = 720  # brackets of the root search over a turn; two extremes nearer than half a degree count as none
FULL_TURN = 2 * np.pi


@dataclass(frozen=True, eq=False)
class Cycle:
    """Position 0 and the sweep of the driving link: positions are numbered in the sense of rotation."""

    linkage: Linkage
    zero: float  # angle of the driving link in position 0, rad

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
        """Motion at angles turned from position 0, rad."""
        return solve(self.linkage, self.phi(np.asarray(turned, dtype=float)))

    def roots(self, rate: Rate) -> Array:
        """Angles turned, sorted, at which `rate` of the motion changes sign continuously, rad, to full precision."""
        grid = np.linspace(0.0, self.sweep, SEARCH + 1)
        # half a step aside, so that a root at position 0 falls inside a bracket and not on its edge
        grid = grid - (grid[1] / 2 if self.closed else 0.0)
        values = np.real(rate(self.motion(grid)))
        turns = np.flatnonzero(np.sign(values[:-1]) * np.sign(values[1:]) < 0)
        found = _bisect(lambda x: np.real(rate(self.motion(x))), grid[turns], grid[turns + 1], values[turns])
        tolerance = 1e-6 * np.nanmax(np.abs(values), initial=0.0)
        crossing = np.abs(np.real(rate(self.motion(found)))) <= tolerance  # a pole changes sign too
        found = found[crossing] if found.size else found
        return np.sort(np.mod(found + 1e-9, self.sweep) - 1e-9 if self.closed else found)

    def extremes(self, value: Rate, rate: Rate) -> tuple[tuple[float, float], tuple[float, float]]:
        """(value, angle turned) of the least and the greatest `value` over the cycle; `rate` is its derivative."""
        ends = np.array([0.0] if self.closed else [0.0, self.sweep])
        where = np.concatenate([self.roots(rate), ends])
        values = np.real(value(self.motion(where)))
        low, high = np.nanargmin(values), np.nanargmax(values)
        return (float(values[low]), float(where[low])), (float(values[high]), float(where[high]))


def _bisect(f: Callable[[Array], Array], low: Array, high: Array, f_low: Array) -> Array:
    """Roots in many brackets at once: Illinois steps, a halving where they stall, to the last bits."""
    if not low.size:
        return low
    f_high = f(high)
    for step in range(60):
        with np.errstate(invalid="ignore", divide="ignore"):
            x = (low * f_high - high * f_low) / (f_high - f_low)
        bad = ~((x > np.minimum(low, high)) & (x < np.maximum(low, high)))
        x = np.where(bad | (step % 4 == 3), (low + high) / 2, x)
        fx = f(x)
        left = np.sign(fx) == np.sign(f_low)
        low, f_low = np.where(left, x, low), np.where(left, fx, f_low / 2)
        high, f_high = np.where(left, high, x), np.where(left, f_high / 2, fx)
        if np.all((np.abs(high - low) < 4e-15) | (fx == 0)):
            break
    return np.where(fx == 0, x, np.where(np.abs(f_low) < np.abs(f_high), low, high))


def cycle_of(linkage: Linkage) -> Cycle:
    """The cycle with position 0 as the variant states it. Raises ProblemError if that position does not exist."""
    zero = linkage.mechanism.driver.zero
    if isinstance(zero, ZeroAngle):
        return Cycle(linkage, zero.angle)
    start = Cycle(linkage, 0.0)
    if zero.point is not None:
        point, direction = zero.point, zero.direction
        roots = start.roots(lambda motion: dot(motion.velocity(point), direction))
        reached = dot(start.motion(roots).place(point), direction) if roots.size else np.array([])
    else:
        link = str(zero.link)
        roots = start.roots(lambda motion: motion.angular_velocity(link))
        reached = _rocker_angle(start, link, roots) * np.real(zero.direction) if roots.size else np.array([])
    if not roots.size:
        name = zero.point or zero.link
        text = N_("%(name)s has no extreme position: it never stops within the cycle")
        right = Message(N_("state position 0 by an angle, or by another point"))
        raise ProblemError([mistake(text, ("mechanism", "driver", "zero"), right, name=name)])
    return Cycle(linkage, float(start.phi(roots[np.argmax(reached)])))


def _rocker_angle(cycle: Cycle, link: str, turned: Array) -> Array:
    """Angle of a rocker about its middle over the cycle, so that the cut of atan2 is out of its way, rad."""
    u = cycle.motion(np.linspace(0, cycle.sweep, 37)[:-1]).turn(link)
    middle = np.nanmean(u)
    return np.angle(cycle.motion(turned).turn(link) / middle)
