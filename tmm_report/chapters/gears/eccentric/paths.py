"""Paths of points of the output wheel while the body H of the axes turns once.

With the sun stopped the axis O3 of the ring goes round O1 on a circle of radius e, and by Willis with u13(H) = −z3/z1
the ring turns by 1 + z1/z3 of a turn: z(θ) = e exp(iθ) + ρ exp(i[(1 + z1/z3) θ + α]) from O1. With the ring stopped the
axis of the sun goes round O3, and z(θ) = −e exp(iθ) + ρ exp(i[(1 + z3/z1) θ + α]) from O3.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any

POSITIONS = 12
CURVE = 360  # points of a drawn path


@dataclass(frozen=True)
class Point:
    """A named point of the sun ("1") or of the ring ("3"): `radius` from its axis, m, `angle` from the line O1O3 at
    θ = 0, rad."""

    name: str
    wheel: str
    radius: float
    angle: float


@dataclass(frozen=True, eq=False)
class Traced:
    """A point's path from the axis of the wheel that stands still: `theta` of H, rad, `places`, m, (13,) each; `rate`:
    turns of its wheel for one of H; `arm`: of the wheel's axis from the axis that stands still, m, signed; `turns`: of
    H until the path closes."""

    point: Point
    theta: Array
    places: Array
    rate: float
    arm: float
    turns: int

    def curve(self) -> Array:
        """The path over one turn of H, (361,)."""
        return self.at(np.linspace(0, 2 * np.pi, CURVE + 1))

    def at(self, theta: Array) -> Array:
        turned = self.rate * theta + self.point.angle
        return self.arm * np.exp(1j * theta) + self.point.radius * np.exp(1j * turned)


def traced(point: Point, sun: int, ring: int, e: float) -> Traced:
    """`sun`, `ring`: teeth."""
    of_ring = point.wheel == "3"
    own, other = (ring, sun) if of_ring else (sun, ring)
    theta = np.linspace(0, 2 * np.pi, POSITIONS + 1)
    turns = own // math.gcd(own, other)
    empty = Traced(point, theta, theta, 1 + other / own, e if of_ring else -e, turns)
    return Traced(point, theta, empty.at(theta), empty.rate, empty.arm, turns)
