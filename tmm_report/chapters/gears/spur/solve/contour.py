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
    """Points are x1 + i x2. `chosen`: the shifts taken; `lacks`: the limits that they break; `nearest`: the feasible
    point nearest to them, `same_distance` the nearest of the same centre distance; None where there is none.

    The lines of the plane serve the picture alone and take some ten times as long as all the rest: they are found when
    it is drawn.
    """

    blocking: Blocking
    chosen: complex
    lacks: tuple[Lack, ...]
    nearest: complex | None
    same_distance: complex | None

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
    blocking = Blocking(
        z1, z2, pair.m, pair.rack, pair.beta, bool(pair.internal), POINTING, CONTACT, sliding=sliding,
        shortened=pair.shortened, trimmed=pair.trimmed, cutter=pair.cutter,
    )  # fmt: skip
    chosen = complex(float(pair.x1), float(pair.x2))
    return Contour(
        blocking,
        chosen,
        blocking.lacks(chosen),
        blocking.nearest(chosen),
        blocking.nearest_at_distance(chosen),
    )
