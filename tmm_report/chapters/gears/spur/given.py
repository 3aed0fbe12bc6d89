"""What a spur stage states."""

from __future__ import annotations

from typing import Literal

from tmm_report.mechanics.gears.meshing import Cutter, Rack
from tmm_report.quantity.paper import ACCURACY
from tmm_report.records import dataclass

Rule = Literal["rule", "limit", "equal sliding"]
EQUAL: Rule = "equal sliding"
STANDARD = Rack()


@dataclass(frozen=True, eq=False)
class Given:
    """What a spur stage states; lengths in m, `helix` in rad.

    `ratio`: ω1/ω2, negative for an external pair. `teeth` None: found from the centre distance; that None: found from
    the shifts. `shift`: how the sum of shifts is divided, or both. `wheels`: their numbers in the drive, the driving
    one first. `accuracy`: to which places are read off the drawing of the mesh, m of paper. `sliding_limit`: largest
    specific sliding, None: by the pitch-line velocity. `cutter`: a pinion cutter that cuts the ring, or both external
    wheels; None: dimensions as if all were cut by a rack.
    """

    ratio: float
    module: float
    centre_distance: float | None = None
    teeth: tuple[int, int] | None = None
    wheels: tuple[str, str] = ("1", "2")
    rack: Rack = STANDARD
    helix: float = 0.0
    width: float | None = None
    shift: Rule | tuple[float, float] = "rule"
    shortened: bool = True
    efficiency: float = 0.98
    name: str = ""
    accuracy: float = ACCURACY
    sliding_limit: float | None = None
    cutter: Cutter | None = None

    @property
    def internal(self) -> bool:
        return self.ratio > 0
