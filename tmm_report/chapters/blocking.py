"""Blocking contour of a spur pair: the feasible shifts, the limits round them and where the chosen shifts stand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from tmm_report.chapters import spur
from tmm_report.mechanics.blocking import Blocking, Lack, Line, Window

Array = Any


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`; points are x1 + i x2. `chosen`: the shifts taken; `region`: pieces of the boundary (N,).

    `lacks`: the limits the chosen point breaks; `nearest`: the feasible point nearest to it, and `nearest_at_distance`:
    that of the same centre distance; None where there is none.
    """

    blocking: Blocking
    chosen: complex
    window: Window
    region: tuple[Array, ...]
    lines: tuple[Line, ...]
    lacks: tuple[Lack, ...]
    nearest: complex | None
    nearest_at_distance: complex | None

    @property
    def feasible(self) -> bool:
        return not self.lacks


@lru_cache(maxsize=16)
def solve(found: spur.Found) -> Found:
    """The contour with the limits by which the stage itself is judged."""
    pair, z = found.pair, found.teeth.z
    blocking = Blocking(
        z[0], z[1], pair.m, pair.rack, pair.beta, bool(pair.internal), spur.POINTING, spur.CONTACT
    )
    chosen = complex(float(pair.x1), float(pair.x2))
    window = blocking.window(chosen)
    return Found(
        blocking,
        chosen,
        window,
        blocking.region(window),
        blocking.lines(window, chosen),
        blocking.lacks(chosen),
        blocking.nearest(chosen),
        blocking.nearest_at_distance(chosen),
    )
