"""What is given to the kinematics beside the mechanism: the positions, and by what method their motion is found."""

from __future__ import annotations

from typing import Literal

from tmm_report.records import dataclass

By = Literal["angle", "time", "length"]

AUTO = "auto"  # the cheapest method that holds the accuracy


@dataclass(frozen=True)
class Positions:
    """How many positions the tables and diagrams have over the cycle, and which table positions are drawn."""

    table: int = 12
    diagram: int = 36
    plans: tuple[int, ...] = (1,)
    force_plan: tuple[int, ...] = (1,)
    instants: tuple[tuple[float, By], ...] = ()
    """Beside the table: angles turned from position 0, rad, times, s, or strokes of what drives, m."""


@dataclass(frozen=True)
class Way:
    """By what method the motion of the positions is found: its key, or AUTO. `accuracy`: what the numbers are to hold,
    relative; None where it is not stated."""

    method: str
    accuracy: float | None = None
