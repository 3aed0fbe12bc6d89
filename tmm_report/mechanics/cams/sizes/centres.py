"""The zone in which the axis of a cam may stand under a swinging roller, by the permitted pressure angles.

From the follower's pivot, the x axis along its lowest arm, lifts counter-clockwise: v = exp iψ along the arm of length
l, u = iv the way in which its roller is lifted, p the axis of the cam. The pressure angle is

    tan α = k (l(1 + kψ') − p·v)/(−p·u)

with k = −1 where the follower rises in the sense in which the cam turns, else 1, so that |α| ≤ [α] is two linear
conditions on p for every position of the follower:

    ±(l(1 + kψ') − p·v) ≤ −p·u tan [α]

On paper: through the end of lψ' laid off along the arm from the roller's centre (away from the pivot for k = 1), lines
at 90° ∓ [α] to the arm; the axis lies between them for all positions. Their common zone is convex; its point nearest to
the lowest centre of the roller gives the least cam, that nearest to the pivot the least distance of the pivots. Both
are found by the two conditions that hold them, the worst one taken in at every step; three that have no point in common
show that there is no zone (Helly's theorem).

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Levitsky, Cam mechanisms, ch. 4.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from math import tan
from typing import Any, Literal, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.cams.follower_laws import Law
from tmm_report.mechanics.cams.sizes.searched import Demand, greatest
from tmm_report.records import dataclass

Array = Any
Way = Literal["rise", "return"]
STEPS = (
    200  # conditions taken in, far more than it takes: each step is one of Newton's method on the zone's edge
)
SLACK = 1e-13  # of the arm: a condition that is passed by less is kept


class Condition(NamedTuple):
    """dot(p, normal) ≤ most, of a unit normal, m; asked at a place of the law by a way of the follower; `beyond`: that
    the cam does not press along the arm's far side."""

    normal: complex
    most: float
    at: Demand
    way: Way
    beyond: bool

    def excess(self, p: complex) -> float:
        """How far a place is outside, m."""
        return float(dot(p, self.normal)) - self.most


class Centre(NamedTuple):
    """A place of the cam's axis from the follower's pivot, m, and the conditions that hold it there, two at most."""

    p: complex
    by: tuple[Condition, ...]


class NoZone(ValueError):
    """`args[0]`: conditions that no place keeps together."""


@dataclass(frozen=True, eq=False)
class Centres:
    """`arm`: l, m; `alike`: whether the follower rises in the sense in which the cam turns; `rise`, `back`: permitted
    pressure angles, rad, a dwell is limited by both; no `back`: the return has none."""

    law: Law
    arm: float
    alike: bool
    rise: float
    back: float | None = None

    @property
    def limits(self) -> list[tuple[Way, float]]:
        return [("rise", self.rise), *([("return", self.back)] if self.back is not None else [])]  # type: ignore[list-item]

    @cached_property
    def best(self) -> Centre:
        """That of the least cam. Raises NoZone."""
        return self.nearest(self.arm + 0j)

    @cached_property
    def closest(self) -> Centre:
        """That of the least distance of the pivots. Raises NoZone."""
        return self.nearest(0j)

    def radius(self, centre: Centre) -> float:
        """Of the least pitch circle about a place, m."""
        return abs(centre.p - self.arm)

    def nearest(self, to: complex) -> Centre:
        """The zone's place that is nearest to another. Raises NoZone."""
        found = Centre(to, ())
        for _ in range(STEPS):
            worst = self.worst(found.p)
            if worst.excess(found.p) <= SLACK * self.arm:
                break
            found = _nearest(to, (*found.by, worst), SLACK * self.arm)
        return found

    def worst(self, p: complex) -> Condition:
        """The condition of all positions that a place fails most, or keeps most narrowly."""
        at = greatest(
            self.law, lambda S, slope, _: np.max([one[0] for one in self._asked(p, S, slope)], axis=0)
        )
        asked = self._asked(p, np.array(at.S), np.array(at.slope))
        ways = [(way, beyond) for way, _ in self.limits for beyond in (False, True)]
        which = int(np.argmax([one[0] for one in asked]))
        return Condition(complex(asked[which][1]), float(asked[which][2]), at, *ways[which])

    def conditions(self, theta: Array) -> tuple[Array, Array]:
        """Unit normals and bounds, m, of all conditions at angles of the law, (K,)."""
        S, slope, _ = self.law.of(theta)
        asked = self._asked(0j, S, slope)
        good = np.concatenate([np.isfinite(one[0]) for one in asked])
        return np.concatenate([one[1] for one in asked])[good], np.concatenate([one[2] for one in asked])[
            good
        ]

    def _asked(self, p: complex, S: Array, slope: Array) -> list[tuple[Array, Array, Array]]:
        """How far p is outside, −inf where nothing is asked, unit normals and bounds, of both sides of each limit."""
        v, found = np.exp(1j * S), []
        laid = self.arm * (1 - slope if self.alike else 1 + slope)
        for way, limit in self.limits:
            t = tan(limit)
            size = np.hypot(1.0, t)
            asks = slope >= 0 if way == "rise" else slope <= 0
            for side in (1, -1):
                normal, most = (1j * t - side) * v / size, -side * laid / size
                found.append((np.where(asks, dot(p, normal) - most, -np.inf), normal, most))
        return found


def _nearest(to: complex, conditions: Sequence[Condition], slack: float) -> Centre:
    """The place nearest to another that keeps all of three conditions or less, the last of which holds it. Raises
    NoZone."""
    last, others = conditions[-1], conditions[:-1]
    places = [Centre(to - last.excess(to) * last.normal, (last,))]
    places += [Centre(at, (one, last)) for one in others if (at := _crossing(one, last)) is not None]
    kept = [one for one in places if all(c.excess(one.p) <= slack for c in others if c not in one.by)]
    if not kept:
        raise NoZone(tuple(conditions))
    return min(kept, key=lambda one: abs(one.p - to))


def _crossing(one: Condition, other: Condition) -> complex | None:
    """Where both bounds are met; None of parallel ones."""
    across = (np.conj(one.normal) * other.normal).imag
    if abs(across) < 1e-14:
        return None
    return complex(1j * (one.normal * other.most - other.normal * one.most) / across) * 1.0


def zone(normals: Array, most: Array, around: Iterable[complex]) -> list[complex]:
    """The part of a convex polygon that keeps all conditions, clipped by that which cuts off most at each step; empty
    where there is none."""
    corners = np.array(list(around))
    for _ in range(len(most)):
        beyond = dot(corners[:, None], normals[None]) - most
        corner, which = np.unravel_index(int(np.argmax(beyond)), beyond.shape)
        if beyond[corner, which] <= 1e-9 * np.max(np.abs(corners)):
            break
        corners = _clipped(corners, beyond[:, which])
        if len(corners) < 3:
            return []
    return [complex(z) for z in corners]


def _clipped(corners: Array, beyond: Array) -> Array:
    """What is left of a polygon where `beyond` of its corners is below zero."""
    found: list[complex] = []
    for k, here in enumerate(corners):
        a, b = beyond[k - 1], beyond[k]
        if (a > 0) != (b > 0):
            found.append(corners[k - 1] + (here - corners[k - 1]) * a / (a - b))
        if b <= 0:
            found.append(here)
    return np.array(found)
