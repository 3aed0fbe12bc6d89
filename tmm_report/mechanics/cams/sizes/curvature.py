"""Radius of curvature of the path of a roller's centre in the cam's axes, by the law alone, + where it is convex.

Slides: ρ = (Y² + u²)^1.5/(Y² + u(2S' − e) − YS''), Y = s0 + S, u = S' − e. Swings, B from the cam's axis:
z1 = B' − iB, z2 = B'' − 2iB' − B (primes by the cam's angle, the cam counter-clockwise): ρ = −|z1|³/Im(z̄1 z2).

Source: Levitsky, Cam mechanisms, ch. 3; Artobolevsky, Theory of mechanisms and machines, ch. 26.
"""

from __future__ import annotations

from math import inf
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.cams.follower_laws import Law
from tmm_report.mechanics.cams.sizes.searched import Demand, greatest

Array = Any


class OnLine(NamedTuple):
    """A roller that slides: e and s0, m."""

    offset: float
    start: float

    def radius(self, S: Array, slope: Array, bend: Array) -> Array:
        Y, u = self.start + S, slope - self.offset
        with np.errstate(divide="ignore"):
            return (Y * Y + u * u) ** 1.5 / (Y * Y + u * (2 * slope - self.offset) - Y * bend)


class OnArm(NamedTuple):
    """A roller that swings: its arm, the distance of the pivots, m, the lowest angle between them, rad; whether it
    rises in the sense in which the cam turns."""

    arm: float
    apart: float
    start: float
    alike: bool

    def radius(self, S: Array, slope: Array, bend: Array) -> Array:
        side = 1 if self.alike else -1
        w = side * self.arm * np.exp(1j * side * (self.start + S))
        b = w - side * self.apart
        d, dd = 1j * w * side * slope, (1j * side * bend - slope**2) * w
        z1, z2 = d - 1j * b, dd - 2j * d - b
        with np.errstate(divide="ignore"):
            return -(np.abs(z1) ** 3) / cross(z1, z2)


def least_convex(law: Law, place: OnLine | OnArm) -> float:
    """The least radius of the pitch curve where it is convex, m; inf of one that is nowhere."""
    return -_least(law, place, 1).b


def least_hollow(law: Law, place: OnLine | OnArm) -> float:
    """The same where it is concave: what the outer wall of a groove has inside."""
    return -_least(law, place, -1).b


def _least(law: Law, place: OnLine | OnArm, way: int) -> Demand:
    def sharp(S: Array, slope: Array, bend: Array) -> Array:
        radius = way * place.radius(S, slope, bend)
        return np.where(radius > 0, -radius, -inf)

    return greatest(law, sharp)
