"""What is given of an engine of several cylinders."""

from __future__ import annotations

from dataclasses import field

from tmm_report.quantity.paper import ACCURACY
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Cylinder:
    """`bank`: of its axis from the upward vertical, `crank`: of its crank from that of angle 0, rad, counter-clockwise;
    `at`: its place along the crankshaft, m."""

    name: str
    bank: float
    crank: float
    at: float


@dataclass(frozen=True)
class Rod:
    """Mass, kg, and distance of its centre from the crankpin, m."""

    mass: float
    centre: float


@dataclass(frozen=True)
class Counterweight:
    """Opposite the crank of every cylinder: two of the three are stated, the third is found. `share`: of the
    reciprocating mass that it balances beside all the rotating one; `radius` m; `mass` kg."""

    share: float | None = None
    radius: float | None = None
    mass: float | None = None


@dataclass(frozen=True, eq=False)
class Given:
    """SI. `piston`: reciprocating mass without the rod's part, `rotating`: mass at the crankpin without the rod's
    part, of each cylinder; `about`: the plane of the moments, m, None: the middle of the cylinders; `accuracy`: of the
    polygons, m of paper."""

    cylinders: tuple[Cylinder, ...]
    radius: float
    length: float
    speed: float
    piston: float
    rotating: float = 0.0
    rod: Rod | None = None
    counterweight: Counterweight | None = None
    about: float | None = None
    firing: tuple[str, ...] = field(default=())
    strokes: int = 4
    accuracy: float = ACCURACY
    name: str = ""
