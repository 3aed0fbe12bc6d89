"""What an eccentric epicyclic mechanism states."""

from __future__ import annotations

import math
from fractions import Fraction

from tmm_report.chapters.gears.eccentric.paths import Point
from tmm_report.mechanics.gears.eccentric.mechanism import EXACT
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.records import dataclass

STANDARD = Rack()
SUN, RING, CARRIER = "1", "3", "H"


@dataclass(frozen=True, eq=False)
class Given:
    """What is stated; lengths in m, `speed` in rad/s.

    `ratio`: z3/z1, a magnitude; `teeth`: sun and ring, or sun, largest satellite and ring, in place of choosing them;
    `clearance`: δ between the tip circles of neighbours; `backlash`: normal, of every mesh; `t`: the set of the family,
    None: the most compact of those that hold most satellites; `satellites`: which of KINDS, None: as many as fit;
    `most_ring`: largest ring looked at; `speed`: of the input; `tolerance`: of the ratio, relative,
    for sets near it; `width` of the faces and `density` kg/m³ of the satellites; `points`: whose paths are drawn.
    """

    module: float
    ratio: Fraction | None = None
    eccentricity: float | None = None
    teeth: tuple[int, ...] | None = None
    rack: Rack = STANDARD
    clearance: float = 0.0
    backlash: float = 0.0
    t: int | None = None
    satellites: tuple[str, ...] | None = None
    most_ring: int | None = None
    speed: float | None = None
    name: str = ""
    tolerance: float | None = None
    width: float | None = None
    density: float | None = None
    points: tuple[Point, ...] = ()

    @property
    def slack(self) -> float:
        """The residue of assembly that the backlash takes up, pitches: half a backlash in each of two meshes."""
        pitch = math.pi * self.module
        return self.backlash / math.cos(self.rack.alpha) / pitch + EXACT
