"""A finished plan of velocities or accelerations and the calculations that belong to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from tmm_report.mechanics.structure import Group
from tmm_report.quantity.formula import Formula, Symbol, VectorEquation
from tmm_report.quantity.written import Worked

Role = Literal[
    "absolute", "relative", "bend", "rate"
]  # bend: normal or Coriolis; rate: tangential or relative


@dataclass(frozen=True)
class Scales:
    """m, m/s and m/s² per mm of paper."""

    length: float
    velocity: float
    acceleration: float


@dataclass(frozen=True)
class Stroke:
    """A vector of a plan, mm of paper."""

    start: complex
    end: complex
    key: str
    symbol: Symbol
    role: Role


@dataclass(frozen=True)
class Projections:
    """The contours of a group above class II projected on the axes, Σ coefficient·unknown = right, SI.

    `unknown`: keys of its angular and sliding rates. `rows`: the point in which a contour closes, the axis, the
    coefficients and the right side. `solution`: the unknown rates with their signs.
    """

    unknown: tuple[str, ...]
    rows: tuple[tuple[str, str, tuple[float, ...], float], ...]
    solution: tuple[float, ...]

    @property
    def closed(self) -> list[str]:
        """The points in which the contours close."""
        return list(dict.fromkeys(row[0] for row in self.rows))


@dataclass(frozen=True, eq=False)
class Step:
    """One group in a plan: its vector equations, what is known beforehand, and what is read off the plan.

    `vertices`: points found by the equations. `projections`: of a group whose equations are solved together.
    """

    group: Group
    vertices: tuple[str, ...]
    equations: tuple[VectorEquation, ...]
    before: tuple[Formula, ...]  # lengths, normal and Coriolis accelerations, their segments
    after: tuple[Formula, ...]
    points: tuple[Formula, ...]  # points of the group's links found by similarity
    projections: Projections | None = None


@dataclass(frozen=True, eq=False)
class Plan:
    """A plan of velocities ("v") or accelerations ("a") at one table position.

    `scale`: m/s or m/s² per mm. `vertices`: lettering -> place, mm, the pole at 0. `segments`: lettering of the ends,
    "pb" -> length read, mm. `values`: key -> written magnitude, SI; `per_mm`: key -> value of 1 mm of paper.
    `lead`: formulas of the driving link. `turns`: link -> mm of plan per m of the link, complex.
    `worked`: every number of the calculations.
    """

    kind: Literal["v", "a"]
    position: int
    scale: float
    pole: str
    vertices: Mapping[str, complex]
    strokes: tuple[Stroke, ...]
    segments: Mapping[str, float]
    values: Mapping[str, float]
    per_mm: Mapping[str, float]
    lead: tuple[Formula, ...]
    steps: tuple[Step, ...]
    turns: Mapping[str, complex]
    worked: Worked

    def vector(self, key: str) -> complex:
        """A drawn vector by its key, mm."""
        return next(s.end - s.start for s in self.strokes if s.key == key)
