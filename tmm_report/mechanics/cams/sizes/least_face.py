"""Least size of a cam under a flat face, by the curvature of its profile.

Of a face that slides across itself the radius of curvature is r0 + S + S'', and the contact is S' along the face.

Of a face that swings, at the distance b from its pivot (above zero on the far side of it from the cam), pivots at the
distance d, ψ the angle of the face with the line of the pivots,

    ρ = b + d(A sin ψ + B cos ψ),  A = (1 + 2kψ')/(1 + kψ')²,  B = ψ''/(1 + kψ')³

k = −1 where the face is lifted in the sense in which the cam turns, else 1; the contact is at d cos ψ/(1 + kψ') from
the foot of the pivot's perpendicular on the face, and tan α = b/(that distance). With A = R cos δ, B = R sin δ a
position asks that sin(ψ + δ) ≥ (ρ₁ − b)/(dR). The base circle is r0 = b + d sin ψ0.

Source: Levitsky, Cam mechanisms, ch. 4; Artobolevsky, Theory of mechanisms and machines, ch. 26.
"""

from __future__ import annotations

from functools import cached_property
from math import asin, atan2, ceil, hypot, pi, tan
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.cams.follower_laws import Law
from tmm_report.mechanics.cams.sizes.searched import Demand, greatest
from tmm_report.records import dataclass

Array = Any
STEPS = 200  # far more than it takes
SLACK = 1e-13  # of the distance of the pivots: what is missed by less is kept


class Face(NamedTuple):
    """A flat face across its motion: the least radius of `curvature` under it, m, and what it asks."""

    curvature: float
    asked: Demand


def under_face(law: Law, curvature: float) -> Face:
    """Of the least base circle, `asked.b`, m, with a least radius of curvature, m; at a jump of the acceleration by the
    side that asks for more."""
    return Face(curvature, greatest(law, lambda S, _, bend: curvature - S - bend))


@dataclass(frozen=True, eq=False)
class TurnedFace:
    """A swinging face: `away`, `apart`: b and d, m; `alike`: whether it is lifted in the sense in which the cam turns;
    `curvature`: least radius of curvature, m; `rise`: permitted pressure angle of rises and dwells, rad."""

    law: Law
    away: float
    apart: float
    alike: bool
    curvature: float
    rise: float

    @cached_property
    def lowest(self) -> float | None:
        """The least ψ0, rad; None where none will do. From that of no base circle at all up, over what the position
        asks that is kept worst: no angle that is passed over keeps all."""
        if self.overtaken:
            return None
        psi = self._none
        for _ in range(STEPS):
            asked = self.worst(psi)
            if asked.b <= SLACK * self.apart:
                return psi
            above = self._above(psi, asked)
            if above is None or above >= pi / 2:
                return None
            psi = above
        return psi

    @property
    def any_will_do(self) -> bool:
        """Whether the smallest base circle would have no radius."""
        return self.lowest == self._none

    @property
    def _none(self) -> float:
        return asin(min(max(-self.away / self.apart, -1.0), 1.0))

    @property
    def overtaken(self) -> bool:
        """Whether the face somewhere swings as fast as the cam turns, or faster: no point of it is then the contact."""
        return greatest(self.law, lambda S, slope, bend: -self._rate(slope)).b >= 0

    def worst(self, lowest: float) -> Demand:
        """Where an angle ψ0 keeps the curvature, or the place of the contact, worst: by how much not, m."""

        def short(S: Array, slope: Array, bend: Array) -> Array:
            return np.maximum(*(most - part for most, part in self._asked(lowest, S, slope, bend)))

        return greatest(self.law, short)

    def radius(self, lowest: Array) -> Array:
        """Of the base circle with an angle ψ0, m."""
        return self.away + self.apart * np.sin(lowest)

    def contact(self, lowest: Array, S: Array, slope: Array) -> Array:
        """Distance of the contact along the face from the foot of the pivot's perpendicular, m."""
        return self.apart * np.cos(lowest + S) / self._rate(slope)

    def curved(self, lowest: Array, S: Array, slope: Array, bend: Array) -> Array:
        """Radius of curvature of the profile, m."""
        A, B = self._parts(slope, bend)
        return self.away + self.apart * (A * np.sin(lowest + S) + B * np.cos(lowest + S))

    def _rate(self, slope: Array) -> Array:
        return 1 - slope if self.alike else 1 + slope

    def _parts(self, slope: Array, bend: Array) -> tuple[Array, Array]:
        """A, B."""
        rate = self._rate(slope)
        return (2 * rate - 1) / rate**2, bend / rate**3

    def _asked(self, lowest: float, S: Array, slope: Array, bend: Array) -> tuple[tuple[Array, Array], ...]:
        """What must be reached, m, and what is: by the curvature, and by the contact, which stays as far from the pivot
        as the permitted pressure angle asks."""
        near = np.where(slope >= 0, abs(self.away) / tan(self.rise) * self._rate(slope), 0.0)
        return (
            (self.curvature, self.curved(lowest, S, slope, bend)),
            (near, self.apart * np.cos(lowest + S)),
        )

    def _above(self, lowest: float, at: Demand) -> float | None:
        """The next angle above that keeps what is asked at a place of the law; None where none does."""
        S, slope, bend = (float(x) for x in self.law.of(at.theta))
        (curvature, radius), (near, contact) = self._asked(lowest, S, slope, bend)
        sharp = curvature - radius >= near - contact
        A, B = self._parts(slope, bend) if sharp else (0.0, 1.0)
        q = (self.curvature - self.away if sharp else float(near)) / (self.apart * hypot(A, B))
        if q > 1:
            return None
        least = asin(max(q, -1.0)) - atan2(B, A) - S
        return least + 2 * pi * ceil((lowest - least) / (2 * pi))
