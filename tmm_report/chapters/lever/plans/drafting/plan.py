"""A finished plan of velocities or accelerations and the calculations that belong to it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from tmm_report.mechanics.lever.assur_groups import Group
from tmm_report.quantity.formula import Formula, Symbol, Var, VectorEquation
from tmm_report.quantity.written import Worked
from tmm_report.records import dataclass

Role = Literal[
    "absolute", "relative", "bend", "rate", "line"
]  # bend: normal or Coriolis; rate: tangential or relative; line: a known direction of a construction


@dataclass(frozen=True)
class Scales:
    """m, m/s and m/s² per mm of paper."""

    length: float
    velocity: float
    acceleration: float


@dataclass(frozen=True)
class Stroke:
    """A vector of a plan, mm of paper; `key`: of its quantity, "" of one that is only construction."""

    start: complex
    end: complex
    key: str
    symbol: Symbol | None
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


@dataclass(frozen=True)
class LegLine:
    """The line of a leg: through both its joints, `ends`; or across its `guide`, through point `at`."""

    ends: str
    guide: str
    at: str


@dataclass(frozen=True, eq=False)
class Special:
    """The special point of a class III group's basis link, constructed first.

    `place`: its coordinates in the scheme, m.
    `lines`: of the legs that cross in it. `equations`: of the special point, and of `third`, the inner end of the third
    leg. `formulas`: normal accelerations of the basis link that are laid off.
    """

    name: str
    letter: str
    link: str
    third: str
    place: tuple[Var, Var]
    lines: tuple[LegLine, LegLine]
    equations: tuple[VectorEquation, VectorEquation]
    formulas: tuple[Formula, ...]


@dataclass(frozen=True, eq=False)
class Step:
    """One group in a plan: its vector equations, what is known beforehand, and what is read off the plan.

    `vertices`: points found by the equations. `projections`: of a group whose equations are solved together; `special`:
    of one that is constructed through a special point.
    """

    group: Group
    vertices: tuple[str, ...]
    equations: tuple[VectorEquation, ...]
    before: tuple[Formula, ...]  # lengths, normal and Coriolis accelerations, their segments
    after: tuple[Formula, ...]
    points: tuple[Formula, ...]  # points of the group's links found by similarity
    projections: Projections | None = None
    special: Special | None = None


@dataclass(frozen=True)
class Sense:
    """How the sense of a link's angular velocity or acceleration is found: the plan's vector `ends` (its velocity about
    the link's other point, or its tangential acceleration), moved to the link's point `to`, turns the link.

    `sense`: 1 counter-clockwise, -1 clockwise, 0 not at all. `like`: of a link that has no vector of its own, the link
    as which it turns.
    """

    link: str
    ends: str
    to: str
    sense: int
    like: str = ""


@dataclass(frozen=True, eq=False)
class Plan:
    """A plan of velocities ("v") or accelerations ("a") at one table position.

    `scale`: m/s or m/s² per mm. `vertices`: lettering -> place, mm, the pole at 0. `segments`: lettering of the ends,
    "pb" -> length read, mm; `ends`: key -> lettering of the segment that it is read off, `laid`: by
    which it is laid off. `values`: key -> written magnitude, SI; `per_mm`: key -> value of 1 mm of paper.
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
    ends: Mapping[str, str]
    laid: Mapping[str, str]
    values: Mapping[str, float]
    per_mm: Mapping[str, float]
    lead: tuple[Formula, ...]
    steps: tuple[Step, ...]
    turns: Mapping[str, complex]
    worked: Worked
    senses: tuple[Sense, ...]

    @property
    def signed(self) -> dict[str, float]:
        """`values`, angular ones with the sign that the plan gives them, + counter-clockwise."""
        return {key: value * self._sign(key) if value else 0.0 for key, value in self.values.items()}

    @property
    def points(self) -> dict[str, complex]:
        """`vertices` without those that are only construction."""
        ends = {stroke.end for stroke in self.strokes if stroke.key}
        return {name: z for name, z in self.vertices.items() if name == self.pole or z in ends}

    def _sign(self, key: str) -> float:
        letter, _, link = key.partition("_")
        return -1.0 if letter in ("w", "e") and self.turns[link].imag < 0 else 1.0

    def vector(self, key: str) -> complex:
        """A drawn vector by its key, mm."""
        return next(s.end - s.start for s in self.strokes if s.key == key)
