"""A pair with two pairs of teeth in contact: where they touch, and the rule by which conjugate points are found.

Two pairs touch a base pitch apart, in K1 and K2. A point t1 of the profile of wheel 1 comes into contact in T, where
the arc about O1 through t1 meets the line of action; the point t2 of the other profile that touches it there lies on
the arc about O2 through T. Source: Artobolevsky, Theory of mechanisms and machines, ch. 22.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.solve.path import Path, mates_of
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Phase:
    """`points`: radii of curvature of wheel 1 at K1, K2 and T, m; `rho`: of both wheels there, (3,) each; `radii`:
    distances of the points from O1 and O2, (3,) each, m."""

    points: dict[str, float]
    rho: tuple[Array, Array]
    radii: tuple[Array, Array]


def phase_of(pair: Pair, path: Path) -> Phase | None:
    """Both contacts as far from the ends of the active part as can be; None where one pair alone is in mesh."""
    if pair.eps <= 1:
        return None
    begin, end, middle = (path.points[name] for name in "ABP")
    pitch = float(pair.p_b) * (1 if end > begin else -1)
    first = (begin + end - pitch) / 2
    points = {"K1": first, "K2": first + pitch}
    farther = max(points.values(), key=lambda rho: abs(rho - middle))
    points["T"] = (middle + farther) / 2
    one = np.array(list(points.values()))
    rho = one, mates_of(pair, one)
    radii = tuple(np.hypot(float(d) / 2, r) for d, r in zip(pair.d_b, rho, strict=True))
    return Phase(points, rho, radii)  # type: ignore[arg-type]
