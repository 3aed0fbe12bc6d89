"""Blocking contour of a spur pair: the feasible shifts, the limits round them and where the chosen shifts stand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from tmm_report.chapters.spur import solve as spur
from tmm_report.mechanics.blocking import Blocking, Lack, Line, Window

Array = Any


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`, what is asked for; points are x1 + i x2. `chosen`: the shifts taken."""

    blocking: Blocking
    chosen: complex

    @cached_property
    def window(self) -> Window:
        """The part of the plane that is drawn."""
        return self.blocking.window(self.chosen)

    @cached_property
    def region(self) -> tuple[Array, ...]:
        """Pieces of the boundary of the feasible region in the window, (N,) each."""
        return self.blocking.region(self.window)

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """The limits and the lines of equal quality in the window."""
        return self.blocking.lines(self.window, self.chosen)

    @cached_property
    def lacks(self) -> tuple[Lack, ...]:
        """The limits that the chosen point breaks."""
        return self.blocking.lacks(self.chosen)

    @cached_property
    def nearest(self) -> complex | None:
        """The feasible point nearest to the chosen one; None where there is none."""
        return self.blocking.nearest(self.chosen)

    @cached_property
    def nearest_at_distance(self) -> complex | None:
        """The same among the points of the same centre distance."""
        return self.blocking.nearest_at_distance(self.chosen)

    @property
    def feasible(self) -> bool:
        return not self.lacks


@lru_cache(maxsize=16)
def solve(found: spur.Found) -> Found:
    """The contour with the limits by which the stage itself is judged; kept for all who ask for it."""
    pair, z = found.pair, found.teeth.z
    blocking = Blocking(
        z[0], z[1], pair.m, pair.rack, pair.beta, bool(pair.internal), spur.POINTING, spur.CONTACT
    )
    return Found(blocking, complex(float(pair.x1), float(pair.x2)))
