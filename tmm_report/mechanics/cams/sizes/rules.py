"""Rules by which a roller and the least radius of a cam are chosen, as guides of course projects give them.

    r ≤ 0.4 r0                       the roller and the least radius of its centre's path
    r ≤ 0.7 … 0.8 ρ                  and its least radius of curvature where it is convex; of a groove also where not
    r0 ≥ 0.8 d + r                   the cam and its shaft of the diameter d
    [α] = 25 … 35° (30°)             of a follower that slides
    [α] = 40 … 50° (45°)             of one that swings
    [α] = 60 … 70°                   of a return that is driven by a spring or a weight

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Levitsky, Cam mechanisms, ch. 4; Popov, Coursework in
the theory of mechanisms, ch. 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, inf
from typing import NamedTuple

OF_RADIUS = 0.4
OF_CURVATURE = 0.8
OF_SHAFT = 0.8


class Limits(NamedTuple):
    """What a roller may have at most, m: by the least radius, by the curvature where it is convex; by that where it is
    hollow, in a groove, else inf."""

    by_radius: float
    by_curvature: float
    by_hollow: float = inf

    @property
    def most(self) -> float:
        return min(self)


def roller_limits(
    radius: float, curvature: float, hollow: float = inf, share: float = OF_CURVATURE
) -> Limits:
    """Of the pitch curve: its least radius and radius of curvature, m; `hollow`: that where it is concave, in a
    groove."""
    return Limits(OF_RADIUS * radius, share * curvature, share * hollow)


def chosen(most: float, step: float, row: Sequence[float] = ()) -> float | None:
    """The greatest of a row that is no more, or a whole number of steps; None where all are more."""
    fits = [one for one in row if one <= most * (1 + 1e-12)] if row else [step * floor(most / step + 1e-9)]
    return max((one for one in fits if one > 0), default=None)


def by_shaft(diameter: float, roller: float) -> float:
    """Least radius of the pitch curve about a shaft, m."""
    return OF_SHAFT * diameter + roller
