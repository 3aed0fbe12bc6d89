"""One cycle of the driving link: numbering of positions, extreme positions and extremes by root finding."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, assert_never

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.cams.extremes import Extreme as Extreme
from tmm_report.mechanics.cams.follower_laws import BEFORE
from tmm_report.mechanics.lever.cams.kinks import breaks
from tmm_report.mechanics.lever.cycle_search import FULL_TURN, Search
from tmm_report.mechanics.lever.cycle_search import Quantity as Quantity
from tmm_report.mechanics.lever.cycle_search import Rate as Rate
from tmm_report.mechanics.lever.cycle_search import Slope as Slope
from tmm_report.mechanics.lever.cycle_search import noise_of as noise_of
from tmm_report.mechanics.lever.mechanism import ZeroAngle, ZeroExtreme
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.lever.singular import Critical, criticals
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.calculus.motion_laws import MotionLaw

Array = Any

EQUAL = 1e-12  # values nearer than this part of the largest are one
WITHIN = np.array([-1e-9, -1e-13, 1e-13, 1e-9])  # rad from a limit: to its rounding, and surely within


def least_and_greatest(
    values: Array, turned: Array, usual: Array | None = None, side: Array = 0
) -> tuple[Extreme, Extreme]:
    """Extremes among values (P,) at angles `turned`, rad; nan is passed over; of nothing but nan, nan.

    `side`: on which side of a corner each stands, 0 elsewhere. `usual`: which values, (P,) of bool, are not those
    beside a limit, where they may grow without bound: by the largest of these it is judged whether two are one.
    """
    low, high = np.fmin.reduce(values), np.fmax.reduce(values)
    if np.isnan(low):
        return Extreme(np.nan, np.nan), Extreme(np.nan, np.nan)
    alike = EQUAL * float(np.nanmax(np.abs(values if usual is None else values[usual]), initial=0.0))
    sides = np.broadcast_to(side, values.shape)
    return (
        _first(values <= low + alike, values, turned, sides),
        _first(values >= high - alike, values, turned, sides),
    )


def larger(extremes: tuple[Extreme, Extreme]) -> Extreme:
    """Of the least and the greatest value the one with the larger magnitude; of equal ones the first."""
    first, second = sorted(extremes, key=lambda extreme: extreme.turned)
    return second if abs(second.value) > abs(first.value) * (1 + EQUAL) else first


def _first(alike: Array, values: Array, turned: Array, side: Array) -> Extreme:
    """Of values that rounding alone tells apart the first from position 0."""
    at = np.flatnonzero(alike)
    first = at[np.argmin(turned[at])]
    return Extreme(float(values[first]), float(turned[first]), int(side[first]))


@dataclass(frozen=True, eq=False)
class Cycle(Search):
    """Position 0 and the sweep of the driving link: positions are numbered in the sense of rotation.

    The motion repeats with each `sweep`, and is searched over one of them; loads repeat with the `period`, which may
    take several turns.
    """

    @property
    def turns(self) -> int:
        """How many turns the cycle takes."""
        return self.linkage.mechanism.driver.turns

    @property
    def period(self) -> float:
        """The whole cycle, rad."""
        return self.sweep * self.turns

    def turned(self, count: int) -> Array:
        """Angle turned from position 0 at `count` equal steps of the cycle, rad, (P,): 0..count-1, or to count if not
        closed."""
        return np.arange(count if self.closed else count + 1) * (self.period / count)

    def once(self, count: int) -> Array:
        """The same angles with the last, each within its own turn, rad, (count + 1,): where the motion repeats, the
        angle does to the last bit. Position N of a full turn is position 0, but where the motion does not come back to
        it: then position N ends the turn, and of turns beyond it there is no motion, nan."""
        k = np.arange(count + 1)
        turned = (k * self.turns % count if self.closed else k) * (self.sweep / count)
        if self.closed and not self.returns:
            turned = np.where(k * self.turns <= count, k * (self.period / count), np.nan)
        if self.closed and np.any(self.corners == 0.0):
            turned[-1] = self.sweep
        return turned

    def repeated(self, turned: Array) -> Array:
        """Angles turned (P,) within one turn, and the same of every other turn of the cycle, rad."""
        return np.concatenate([turned + k * self.sweep for k in range(self.turns)])

    def extremes(self, value: Quantity, rate: Rate) -> tuple[Extreme, Extreme]:
        """The least and the greatest `value` of the motion; `rate` is its derivative by time or angle."""
        return self.extremes_of([value], [self.roots(rate)])[0]

    def extremes_of(
        self, values: Sequence[Quantity], still: Sequence[Array]
    ) -> list[tuple[Extreme, Extreme]]:
        """The least and the greatest of several values, which stand still at the angles turned `still`."""
        ends = [0.0] if self.returns else [0.0, self.sweep]
        where = [np.concatenate([roots, ends, self.ends]) for roots in still]
        found = self.sampled(values, where)
        sides = [np.zeros(x.shape, dtype=int) for x in where]
        for at, side in self.sides if self.corners.size else ():
            motion = self.beside(at, side)
            found = [
                np.concatenate([row, np.broadcast_to(np.real(of(motion)), at.shape)])
                for row, of in zip(found, values, strict=True)
            ]
            where = [np.concatenate([x, at]) for x in where]
            sides = [np.concatenate([row, np.full(at.shape, side)]) for row in sides]
        return [
            least_and_greatest(row, x, ~np.isin(x, self._beside_limits), side)
            for row, x, side in zip(found, where, sides, strict=True)
        ]

    @property
    def sides(self) -> tuple[tuple[Array, int], tuple[Array, int]]:
        """Angles turned of the corners within the sweep, before them and after them, rad: of one in position 0 the
        turn ends before it and begins after it."""
        before = self.corners if not self.closed else np.where(self.corners == 0.0, self.sweep, self.corners)
        return (before[before <= self.sweep], -1), (self.corners[self.corners < self.sweep], 1)

    @cached_property
    def limits(self) -> Array:
        """Angles turned from position 0 at which a group comes to the limit of its assembly, rad, of a turn."""
        limits = np.array([x for critical in self.critical for x in critical.limits])
        return self.turned_at(limits)

    @cached_property
    def poles(self) -> Array:
        """Angles turned within the sweep at which guides of a dyad are parallel and its links run away, rad."""
        turned = self.turned_at([x for critical in self.critical for x in critical.parallel])
        return np.sort(turned[turned <= self.sweep])

    @cached_property
    def ends(self) -> Array:
        """Angles turned just within the limits of assembly, rad: something may be extreme there and not stand still."""
        turned = np.concatenate([self._beside_limits, self._jumps])
        return turned[turned <= self.sweep]

    @cached_property
    def _beside_limits(self) -> Array:
        return np.mod((self.limits[:, None] + WITHIN).ravel(), FULL_TURN)

    @property
    def breaks(self) -> Array:
        """Angles turned, within a turn, at which the laws of cams or of the driving link have breaks, rad."""
        if self.law is None:
            return self.turned_at(breaks(self.linkage.mechanism))
        return np.array(self.law.breaks, dtype=float) * (FULL_TURN / self.law.period)

    @property
    def _jumps(self) -> Array:
        """Angles turned at which accelerations may jump by a law of a cam or of the driving link, and just before
        them, rad."""
        found = self.breaks
        return np.mod((found[:, None] + np.array([-BEFORE, 0.0])).ravel(), FULL_TURN)


def cycle_of(linkage: Linkage) -> Cycle:
    """The cycle with position 0 as the variant states it, its linkage going smoothly through change points.

    Raises ProblemError if position 0 does not exist.
    """
    zero, law = linkage.mechanism.driver.zero, linkage.mechanism.driver.law
    if law is not None:  # wherever position 0 is: the law begins there
        zero = ZeroAngle(float(law.of_phase(0.0)[0]))
    match zero:
        case ZeroAngle(angle):
            smooth, critical = criticals(linkage, angle)
        case ZeroExtreme():
            smooth, critical = criticals(linkage, 0.0, begins=False)
            angle = extreme_angle(smooth, zero, critical)
            # stated assemblies hold at position 0, and from there groups above class II are followed
            if any(c.changes or (c.run is not None and not c.run.whole) for c in critical):
                smooth, critical = criticals(linkage, angle)
        case _:
            assert_never(zero)
    if law is not None:
        _law_goes(law, critical)
    return Cycle(smooth, angle, critical)


def _law_goes(law: MotionLaw, critical: Sequence[Critical]) -> None:
    """Raises ProblemError where a driving link that moves by a law cannot be followed: it may turn back."""
    path = ("mechanism", "driver", "law")
    for one in critical:
        of = {"group": one.group.group.label}
        if one.run is not None:
            text = N_(
                "group %(group)s is above class II: it is followed with a uniformly turning driving link alone"
            )
            raise ProblemError([mistake(text, path, Message(N_("state a speed")), **of)])
        if law.when(one.changes).size:
            text = N_(
                "by this law group %(group)s goes through a change point, where it may go on in two ways"
            )
            raise ProblemError([mistake(text, path, Message(N_("another law, or other lengths")), **of)])


def extreme_angle(linkage: Linkage, zero: ZeroExtreme, critical: tuple[Critical, ...] = ()) -> float:
    """Driver angle of the extreme position that is to be position 0, rad."""
    start = Cycle(linkage, 0.0, critical)
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
