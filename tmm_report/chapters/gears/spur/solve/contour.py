"""Blocking contour of a spur pair: the feasible shifts, the limits round them and where the chosen shifts stand."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from tmm_report.chapters.gears.spur.solve.conditions import CONTACT, POINTING
from tmm_report.mechanics.gears.limits.blocking_contour import Blocking, Lack, Line, Window
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Contour:
    """Points are x1 + i x2; `chosen`: the shifts taken. All else is found when it is asked for, the lines of the plane,
    some ten times as long as all the rest, when it is drawn."""

    blocking: Blocking
    chosen: complex

    @cached_property
    def lacks(self) -> tuple[Lack, ...]:
        """The limits that the chosen shifts break."""
        return self.blocking.lacks(self.chosen)

    @cached_property
    def nearest(self) -> complex | None:
        """The feasible point nearest to the chosen one; None where there is none."""
        return self.blocking.nearest(self.chosen)

    @cached_property
    def same_distance(self) -> complex | None:
        """The nearest feasible point of the same centre distance; None where there is none."""
        return self.blocking.nearest_at_distance(self.chosen)

    @property
    def feasible(self) -> bool:
        return not self.lacks

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


def contour_of(pair: Pair, sliding: float) -> Contour:
    """The contour with the limits by which the stage itself is judged; `sliding`: the largest specific sliding."""
    z1, z2 = int(pair.z1), int(pair.z2)
    usual = pair.tips is not None  # the contour is that of tips that follow from the shifts
    blocking = Blocking(
        z1, z2, pair.m, pair.rack, pair.beta, bool(pair.internal), POINTING, CONTACT, sliding=sliding,
        shortened=pair.shortened or usual, trimmed=pair.trimmed or usual, cutter=pair.cutter,
    )  # fmt: skip
    return Contour(blocking, complex(float(pair.x1), float(pair.x2)))
