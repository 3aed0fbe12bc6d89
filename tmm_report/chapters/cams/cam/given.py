"""What is given of a cam that stands alone."""

from __future__ import annotations

from typing import Literal

from tmm_report.mechanics.cams.cam import Cam
from tmm_report.records import dataclass

Follower = Literal["roller", "knife", "flat"]


@dataclass(frozen=True, eq=False)
class Given:
    """A cam with its follower over a turn: `sense` +1 counter-clockwise; `omega`: rad/s, above zero, None where no
    speed is stated; `table`, `diagram`: equal parts of the turn for the tables and the curves."""

    cam: Cam
    sense: int
    omega: float | None = None
    table: int = 12
    diagram: int = 72
