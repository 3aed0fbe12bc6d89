"""Where accelerations jump: at the breaks of the law of the driving link or of a cam; in corners velocities do, too.

A diagram has both sides of a jump, each so little beside it that it stands upright on paper.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.cams.follower_laws import BEFORE
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any
Of = Callable[[Motion], Array]
BESIDE = 2e-4  # rad: the sides of a jump stand so little beside it, a hundredth of a millimetre on paper
JUMP = 1e-5  # of the largest value: what differs by less on both sides does not jump


@dataclass(frozen=True, eq=False)
class Side:
    """One side, -1 before and +1 after, of the jumps at angles `turned` from position 0, rad, (J,), within the cycle
    or at its ends, and the motion there."""

    side: int
    turned: Array
    motion: Motion


@dataclass(frozen=True, eq=False)
class Jumps:
    """`turned`: angles of the jumps by a law from position 0, rad, ascending; that at the end of a closed cycle is the
    one in position 0. `sides`: before and after these and after corners."""

    turned: Array
    sides: tuple[Side, ...]
    period: float

    def standing(self, turned: Array) -> Array:
        """Which of the positions at angles turned, (P,), stand at a jump by a law: they have what is after it."""
        again = np.concatenate([self.turned, self.turned + self.period])  # position N is position 0
        off = np.abs(np.asarray(turned)[:, None] - again)
        return np.asarray((off <= BEFORE).any(axis=-1))


@dataclass(frozen=True, eq=False)
class Drawn:
    """`turned`: the angles at which a diagram is drawn, rad, ascending, (Q,): its own and the sides of the jumps."""

    turned: Array
    order: Array
    sides: tuple[Side, ...]

    def of(self, own: Array, quantity: Of) -> Array:
        """A function of the motion, (Q,); `own`: at the diagram's own positions."""
        beside = [np.broadcast_to(quantity(one.motion), one.turned.shape) for one in self.sides]
        count = len(self.order) - sum(len(one) for one in beside)
        return np.concatenate([np.broadcast_to(own, (count,)), *beside])[self.order]


def jumps(found: Kinematics) -> Jumps:
    """Of the accelerations of the driving link, of the outputs and of the links that turn."""
    cycle, driver = found.cycle, found.linkage.mechanism.driver.link
    every: list[Of] = [travel.output.acceleration for travel in (*found.travels, *found.links)]
    every.append(lambda motion: motion.angular_acceleration(driver))
    sizes = [np.nanmax(np.abs(of(found.diagram)), initial=0.0) for of in every]
    at = _breaks(cycle)
    before, after = cycle.motion(at - BEFORE), cycle.motion(at)
    there = np.zeros(at.shape, dtype=bool)
    for of, size in zip(every, sizes, strict=True):
        there |= np.abs(of(after) - of(before)) > JUMP * size
    at = at[there]
    ends = np.where(at == 0.0, cycle.period, at)
    sides = [Side(-1, ends, cycle.motion(at - BEFORE)), Side(1, at, cycle.motion(at))]
    sides += [Side(side, cycle.repeated(x), cycle.beside(cycle.repeated(x), side)) for x, side in cycle.sides]
    return Jumps(at, tuple(one for one in sides if one.turned.size), cycle.period)


def _breaks(cycle: Cycle) -> Array:
    """Angles turned, of the whole cycle, at which a law may jump, rad; of a law that repeats its beginning too."""
    found = cycle.breaks
    if cycle.law is not None and cycle.closed:
        found = np.append(found, 0.0)
    found = distinct(found[found < cycle.sweep - BEFORE])
    return np.sort(cycle.repeated(found))


def drawn(found: Kinematics, at: Jumps) -> Drawn:
    """The angles of a diagram of the motion."""
    beside = [np.clip(one.turned + one.side * BESIDE, 0.0, found.cycle.period) for one in at.sides]
    turned = np.concatenate([found.diagram_turned, *beside])
    order = np.argsort(turned, kind="stable")
    return Drawn(turned[order], order, at.sides)
