"""What is given of the mechanism balanced on its foundation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from tmm_report.records import dataclass

FULL, PIVOTED, SUBSTITUTED, OPTIMUM, ROTORS = "full", "pivoted", "substituted", "optimum", "rotors"
METHODS = (FULL, PIVOTED, SUBSTITUTED, OPTIMUM, ROTORS)
STATED = "stated"


@dataclass(frozen=True)
class Counterweight:
    """Of a link: its mass, kg, or its distance from the pivot, m; the other is found."""

    mass: float | None = None
    distance: float | None = None


@dataclass(frozen=True)
class Existing:
    """A counterweight that is there: mass, kg, distance from the link's pivot, m, angle from the line from the pivot to
    the link's next joint, rad, + counter-clockwise."""

    mass: float
    distance: float
    angle: float


@dataclass(frozen=True, eq=False)
class Given:
    """`about`: the point of the shaking moment, "" for the pivot of the driving link; `part`: of the reciprocating
    masses that the substituted masses balance; `radii`: of the rotors of the first and the second order, m, None where
    they are not asked for; `highest`: order of the harmonics of the force."""

    methods: tuple[str, ...] = (FULL, SUBSTITUTED, OPTIMUM)
    counterweights: Mapping[str, Counterweight] = field(default_factory=dict)
    existing: Mapping[str, Existing] = field(default_factory=dict)
    part: float = 0.5
    about: str = ""
    radii: tuple[float, float] | None = None
    highest: int = 6
