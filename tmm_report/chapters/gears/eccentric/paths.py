"""Paths of points of the output wheel while the body H of the axes turns once.

With the sun stopped the axis O3 of the ring goes round O1 on a circle of radius e, and by Willis with u13(H) = −z3/z1
the ring turns by 1 + z1/z3 of a turn: z(θ) = e exp(iθ) + ρ exp(i[(1 + z1/z3) θ + α]) from O1. With the ring stopped the
axis of the sun goes round O3, and z(θ) = −e exp(iθ) + ρ exp(i[(1 + z3/z1) θ + α]) from O3.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.given import Point
from tmm_report.records import dataclass

Array = Any

POSITIONS = 12
CURVE = 360  # points of a drawn path


@dataclass(frozen=True, eq=False)
class Traced:
    """A named point's path from the axis of the wheel that stands still: `theta` of H, rad, `places`, m, (13,) each;
    `rate`: turns of its wheel for one of H; `arm`: of its axis from the one that stands still, m, signed; `turns`: of
    H until the path closes."""

    name: str
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


def traced(name: str, point: Point, sun: int, ring: int, e: float) -> Traced:
    """`sun`, `ring`: teeth."""
    own, other = (ring, sun) if point.of_ring else (sun, ring)
    theta = np.linspace(0, 2 * np.pi, POSITIONS + 1)
    turns = own // math.gcd(own, other)
    empty = Traced(name, point, theta, theta, 1 + other / own, e if point.of_ring else -e, turns)
    return Traced(name, point, theta, empty.at(theta), empty.rate, empty.arm, turns)
