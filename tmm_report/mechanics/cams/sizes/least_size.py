"""Least size of a cam by the permitted pressure angles of its roller or knife edge.

A roller that slides has the pressure angle tan α = (S' − e)/(s0 + S): in the plane of S' and S it keeps the permitted
α₁ of the rise and α₂ of the return where

    s0 ≥ b₁ − e cot α₁,  b₁ = max(S' cot α₁ − S)     rise
    s0 ≥ b₂ + e cot α₂,  b₂ = max(−S' cot α₂ − S)    return, where it is limited
    s0 ≥ e cot α₁                                    the dwells, and both ends of the rise

and the least radius of the pitch curve is r0² = s0² + e².

A roller on a lever l, whose pivot is at the distance d, lifted by ψ from the lowest angle ψ0 with the line of pivots,
has k tan α = (l(1 + kψ') − d cos(ψ0 + ψ))/(d sin(ψ0 + ψ)), k = −1 where it rises as the cam turns, else 1: within ±α₁
where ψ0 + ψ lies between ±(arccos c − α₁) and the less of arccos c + α₁ and 2π − arccos c − α₁, c = l(1 + kψ') cos
α₁/d. Where d is free, or no ψ0 is found, the zone of `centres.py` says which d are possible.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Levitsky, Cam mechanisms, ch. 4.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property, partial
from itertools import combinations
from math import cos, hypot, inf, pi, sqrt, tan
from typing import Any, Literal, NamedTuple

import numpy as np

from tmm_report.mechanics.cams.follower_laws import Law
from tmm_report.mechanics.cams.sizes.centres import Centres, Way
from tmm_report.mechanics.cams.sizes.least_face import Face, TurnedFace
from tmm_report.mechanics.cams.sizes.searched import Demand, greatest
from tmm_report.records import dataclass

Array = Any
Bound = Literal["rise", "return", "dwell"]
SLACK = 1e-12  # of the size: a bound that is passed by less is kept
NEAR = 1e-9  # rad: the same of an angle


class Line(NamedTuple):
    """A bound: s0 ≥ b + k e."""

    bound: Bound
    b: float
    k: float


class Place(NamedTuple):
    """Of the axis: offset, lowest distance along the follower's line, the bounds that hold it there; m."""

    e: float
    s0: float
    by: tuple[Bound, ...]

    @property
    def radius(self) -> float:
        return hypot(self.e, self.s0)


@dataclass(frozen=True, eq=False)
class Zone:
    """`rise`, `back`: permitted pressure angles, rad; no `back`: the return has none."""

    law: Law
    rise: float
    back: float | None = None

    @cached_property
    def of_rise(self) -> Demand:
        return greatest(self.law, lambda S, slope, _: slope / tan(self.rise) - S)

    @cached_property
    def of_return(self) -> Demand | None:
        back = self.back
        return None if back is None else greatest(self.law, lambda S, slope, _: -slope / tan(back) - S)

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        found = [Line("rise", self.of_rise.b, -1 / tan(self.rise)), Line("dwell", 0.0, 1 / tan(self.rise))]
        if self.of_return is not None and self.back is not None:
            found.append(Line("return", self.of_return.b, 1 / tan(self.back)))
        return tuple(found)

    def at(self, e: float) -> Place:
        """With a stated offset."""
        line = max(self.lines, key=lambda one: one.b + one.k * e)
        return Place(e, line.b + line.k * e, (line.bound,))

    @cached_property
    def best(self) -> Place:
        """The offset of the least cam: s0 is convex in e, so it is where two bounds meet, or the foot of the
        perpendicular on one."""
        places = [*self._feet(), *self._corners()]
        return min((one for one in places if self._keeps(one)), key=lambda one: one.radius)

    def _feet(self) -> Iterator[Place]:
        for bound, b, k in self.lines:
            e = -b * k / (1 + k * k)
            yield Place(e, b + k * e, (bound,))

    def _corners(self) -> Iterator[Place]:
        for one, other in combinations(self.lines, 2):
            if one.k != other.k:
                e = (one.b - other.b) / (other.k - one.k)
                yield Place(e, one.b + one.k * e, (one.bound, other.bound))

    def _keeps(self, place: Place) -> bool:
        low = max(b + k * place.e for _, b, k in self.lines)
        return place.s0 >= low - SLACK * max(abs(low), place.radius)


class Turned(NamedTuple):
    """The least angle of a lever with the line of the pivots, rad, and what asks for it: the way of the follower,
    whether the cam would press along the lever's far side, and where in the law."""

    least: float
    way: Way
    beyond: bool
    asked: Demand


@dataclass(frozen=True, eq=False)
class Lever:
    """A swinging roller: `arm`, `apart`: l and d, m; `alike`: whether it rises in the sense in which the cam turns;
    `rise`, `back`: permitted pressure angles, rad; no `back`: the return has none."""

    law: Law
    arm: float
    apart: float
    alike: bool
    rise: float
    back: float | None = None

    @cached_property
    def lowest(self) -> Turned | None:
        """The least ψ0; None where no cam keeps the angles with these pivots."""
        if any(self._never(way, limit) for way, limit in self._limited):
            return None
        found = [
            Turned(demand.b, way, beyond, demand)
            for way, limit in self._limited
            for beyond in (False, True)
            for demand in [self._greatest(way, partial(self._low, limit, -1 if beyond else 1))]
        ]
        least = max(found, key=lambda one: one.least)
        most = min(-self._greatest(way, partial(self._high, limit)).b for way, limit in self._limited)
        return least if least.least <= most + NEAR and 0 < least.least < pi else None

    @property
    def _limited(self) -> list[tuple[Way, float]]:
        return self.centres.limits

    @cached_property
    def centres(self) -> Centres:
        """Where the axis may stand with any distance of the pivots."""
        return Centres(self.law, self.arm, self.alike, self.rise, self.back)

    def radius(self, lowest: float) -> float:
        """Least radius of the pitch curve with an angle ψ0, m."""
        return sqrt(self.arm**2 + self.apart**2 - 2 * self.arm * self.apart * cos(lowest))

    def c(self, slope: Array, limit: float) -> Array:
        return self.arm * (1 - slope if self.alike else 1 + slope) * cos(limit) / self.apart

    def _low(self, limit: float, side: int, S: Array, slope: Array) -> Array:
        return side * (np.arccos(np.clip(self.c(slope, limit), -1, 1)) - limit) - S

    def _high(self, limit: float, S: Array, slope: Array) -> Array:
        steep = np.arccos(np.clip(self.c(slope, limit), -1, 1)) + limit
        return S - np.minimum(steep, 2 * pi - steep)

    def _greatest(self, way: str, of: Callable[[Array, Array], Array]) -> Demand:
        """Over the rises and dwells, or over the returns."""
        sense = -1 if way == "return" else 1
        return greatest(self.law, lambda S, slope, _: np.where(sense * slope >= 0, of(S, slope), -inf))

    def _never(self, way: str, limit: float) -> bool:
        """Whether somewhere no angle of the lever at all keeps the limit."""
        return self._greatest(way, lambda _, slope: np.abs(self.c(slope, limit))).b > 1


Size = Zone | Lever | Face | TurnedFace
"""By what the least size of a cam was found."""
