"""Chapter 2, graph-analytical method: plans of velocities and accelerations constructed to scale and read off.

A plan is constructed on paper: the vector equation of each dyad is solved by crossing two lines, points of a link
are found by the theorem of similarity, lengths are read to the drawing's accuracy and multiplied by the scale.
Nothing is taken from the analytical velocities and accelerations, only the drawn positions of the links.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 4; Frolov (ed.), Theory of mechanisms, ch. 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tmm_report.chapters.kinematics.quantities import rates
from tmm_report.chapters.kinematics.solve import Kinematics
from tmm_report.chapters.plans.drafting import Named, Plan, Scales, acceleration_plan, velocity_plan
from tmm_report.chapters.plans.given import Drawing
from tmm_report.quantity.paper import Pen, round_scale

PAPER = 150.0  # mm: a round scale is chosen so that the longest vector is at most this
LIMIT = 5.0  # %, allowed difference of the graph-analytical method


@dataclass(frozen=True)
class Comparison:
    """One value by two methods. `delta`: 200 (g − a)/(g + a), %; None where both are below `floor`: ≈ 0."""

    key: str
    graph: float
    analytic: float
    floor: float

    @property
    def delta(self) -> float | None:
        if max(self.graph, self.analytic) <= self.floor:
            return None
        return 200.0 * (self.graph - self.analytic) / (self.graph + self.analytic)

    @property
    def ok(self) -> bool:
        return self.delta is None or abs(self.delta) <= LIMIT or abs(self.graph - self.analytic) <= self.floor


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

    @property
    def worst(self) -> float:
        """Largest |delta| of the program's own plans, %."""
        return max(
            (abs(c.delta) for d in self.drawn for c in d.comparison if c.delta is not None), default=0.0
        )


def solve(drawing: Drawing, plans: Sequence[int], kinematics: Kinematics) -> Plans:
    """Construct the plans of the table positions `plans`."""
    wanted = sorted(set(plans))
    regular = [k for k in wanted if k not in (*kinematics.singular, *kinematics.missing)]
    pen = Pen(drawing.accuracy)
    named = rates(kinematics.linkage)
    scales = _scales(drawing, kinematics, regular, named)
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
    )


def _scales(drawing: Drawing, kinematics: Kinematics, positions: list[int], named: Named) -> Scales:
    """The stated scales, or round ones that keep the longest vector of these positions on the paper."""

    def longest(unit: str) -> float:
        rows = [np.abs(x[positions]) for key, x in kinematics.values.items() if named[key].unit == unit]
        return float(np.nanmax(rows)) if positions else 0.0

    places = kinematics.diagram.places
    size = max(np.nanmax(part) - np.nanmin(part) for part in (places.real, places.imag))
    return Scales(
        drawing.length or round_scale(float(size), PAPER),
        drawing.velocity or round_scale(longest("m/s"), PAPER),
        drawing.acceleration or round_scale(longest("m/s²"), PAPER),
    )


def _draw(kinematics: Kinematics, k: int, scales: Scales, pen: Pen, named: Named) -> Drawn:
    motion = kinematics.cycle.motion(kinematics.turned[k : k + 1])
    velocity = velocity_plan(motion, k, scales, pen, named)
    acceleration = acceleration_plan(motion, k, scales, pen, named, velocity)
    found = {**velocity.values, **acceleration.values}
    per_mm = {**velocity.per_mm, **acceleration.per_mm}
    analytic = {key: float(np.abs(kinematics.values[key][k])) for key in found}
    # the driving link's own rates are given, not read off
    read = [key for key in found if per_mm[key] > 0]
    comparison = tuple(
        Comparison(key, found[key], analytic[key], per_mm[key] * pen.read_step) for key in read
    )
    return Drawn(k, velocity, acceleration, comparison)
