"""The line of action of a spur pair: its points, and the specific sliding along it."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.gears.meshing import Pair, Sliding
from tmm_report.records import dataclass

Array = Any
PLACES = 121  # where the sliding is found for its diagram


@dataclass(frozen=True, eq=False)
class Path:
    """`points`: radii of curvature of wheel 1, m, at the points of the line of action in the order of their passing.

    A, B: ends of the active part; D, C: one base pitch from them; P: the pitch point. Between A and C, D and B two
    pairs of teeth are in mesh, where the contact ratio is over 1. `mates`: radii of curvature of wheel 2 there, m;
    `at`: specific sliding there, `along`: over the whole active part.
    """

    points: dict[str, float]
    mates: Array
    at: Sliding
    along: Sliding


def path_of(pair: Pair) -> Path:
    """The line of action of a pair that is in mesh."""
    points = _points(pair)
    rho = np.array(list(points.values()))
    along = np.linspace(points["A"], points["B"], PLACES)
    return Path(points, mates_of(pair, rho), pair.sliding(rho), pair.sliding(along))


def _points(pair: Pair) -> dict[str, float]:
    begin, end = float(pair.rho_p[0]), float(pair.rho_u[0])
    way = float(pair.p_b) * float(pair.signs[0])
    places = {"A": begin, "C": end - way, "P": float(pair.rho_w[0]), "D": begin + way, "B": end}
    return {name: places[name] for name in "ACPDB"}


def mates_of(pair: Pair, rho: Array) -> Array:
    """Radii of curvature of wheel 2 where wheel 1 has `rho`, m."""
    if not pair.internal:
        return pair.line - rho
    return rho - pair.line if pair.signs[0] < 0 else rho + pair.line
