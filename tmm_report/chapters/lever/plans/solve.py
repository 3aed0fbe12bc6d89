"""Chapter 2, graph-analytical method: plans of velocities and accelerations constructed to scale and read off.

A plan is constructed on paper: the vector equation of each dyad is solved by crossing two lines, points of a link
are found by the theorem of similarity, lengths are read to the drawing's accuracy and multiplied by the scale.
Nothing is taken from the analytical velocities and accelerations, only the drawn positions of the links.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 4; Frolov (ed.), Theory of mechanisms, ch. 3.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import rates
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.plans.drafting import Named, Plan, Scales, acceleration_plan, velocity_plan
from tmm_report.chapters.lever.plans.given import Drawing
from tmm_report.chapters.lever.plans.scales import Choice
from tmm_report.chapters.lever.plans.scales import scales as scales_of
from tmm_report.mechanics.lever.cams.replacing_dyad import in_position, rests
from tmm_report.quantity.paper import Pen
from tmm_report.records import dataclass

LIMIT = 5.0  # %, allowed difference of the graph-analytical method


@dataclass(frozen=True)
class Comparison:
    """One value by two methods, angular ones with their signs. `delta`: 200 (g − a)/(g + a), %; None where both are
    below `floor`: ≈ 0; ±200 where the signs are opposite."""

    key: str
    graph: float
    analytic: float
    floor: float

    @property
    def delta(self) -> float | None:
        if max(abs(self.graph), abs(self.analytic)) <= self.floor:
            return None
        if self.graph * self.analytic < 0:
            return math.copysign(200.0, self.graph)
        return 200.0 * (self.graph - self.analytic) / (self.graph + self.analytic)

    @property
    def ok(self) -> bool:
        return self.delta is None or abs(self.delta) <= LIMIT or self.unreadable

    @property
    def unreadable(self) -> bool:
        """Whether more than is allowed differs, of a value so small that the difference cannot be read off the plan."""
        large = self.delta is not None and abs(self.delta) > LIMIT
        return large and abs(self.graph - self.analytic) <= self.floor


@dataclass(frozen=True, eq=False)
class Drawn:
    """Both plans of one position, compared with the analytical method."""

    position: int
    velocity: Plan
    acceleration: Plan
    comparison: tuple[Comparison, ...]


@dataclass(frozen=True, eq=False)
class Plans:
    """Found by `solve`. `length_scale`: m/mm of the scheme; `accuracy`: mm of paper."""

    drawn: tuple[Drawn, ...]
    length_scale: float
    velocity_scale: float
    acceleration_scale: float
    accuracy: float
    named: Named  # the rates of the note by key
    singular: tuple[int, ...]  # positions asked for, whose plans have no crossing point
    choices: tuple[Choice, ...] = ()  # segments stated, from which scales follow
    by_law: bool = False  # whether the driving link moves by a law of the time

    @property
    def worst(self) -> float:
        """Largest |delta| of the program's own plans, %, of differences that can be read off them."""
        counted = (c for d in self.drawn for c in d.comparison if not c.unreadable)
        return max((abs(c.delta) for c in counted if c.delta is not None), default=0.0)

    @property
    def unreadable(self) -> bool:
        """Whether some difference is beyond the allowed one and not counted."""
        return any(c.unreadable for d in self.drawn for c in d.comparison)


def solve(drawing: Drawing, plans: Sequence[int], kinematics: Kinematics) -> Plans:
    """Construct the plans of the table positions `plans`."""
    wanted = sorted(set(plans))
    still = np.flatnonzero(rests(kinematics.table))  # in a dwell of a cam there is nothing to draw
    wanted = [k for k in wanted if k not in still]
    regular = [k for k in wanted if k not in (*kinematics.singular, *kinematics.missing)]
    pen = Pen(drawing.accuracy)
    named = rates(kinematics.linkage)
    scales, choices = scales_of(drawing, kinematics, regular, named)
    drawn = tuple(_draw(kinematics, k, scales, pen, named) for k in regular)
    singular = tuple(k for k in wanted if k not in regular)
    return Plans(
        drawn,
        scales.length,
        scales.velocity,
        scales.acceleration,
        pen.read_step,
        named,
        singular,
        choices,
        kinematics.by_law,
    )


def _draw(kinematics: Kinematics, k: int, scales: Scales, pen: Pen, named: Named) -> Drawn:
    motion = in_position(kinematics.cycle.motion(kinematics.turned[k : k + 1]))
    velocity = velocity_plan(motion, k, scales, pen, named)
    acceleration = acceleration_plan(motion, k, scales, pen, named, velocity)
    found = {**velocity.signed, **acceleration.signed}
    per_mm = {**velocity.per_mm, **acceleration.per_mm}
    analytic = {key: _told(kinematics.values[key][k]) for key in found}
    # the driving link's own rates are given, not read off, but by them those of the wheels that it moves are worked
    moved = {f"{letter}_{one.link}" for one in kinematics.linkage.structure.wheels for letter in "we"}
    read = [key for key in found if per_mm[key] > 0 or (key in moved and found[key])]
    comparison = tuple(
        Comparison(key, found[key], analytic[key], per_mm[key] * pen.read_step) for key in read
    )
    return Drawn(k, velocity, acceleration, comparison)


def _told(value: Any) -> float:
    """The size of a vector, an angular value with its sign."""
    return float(abs(value)) if np.iscomplexobj(value) else float(value)
