"""Diagrams of linear and angular velocities of a drive, constructed on paper and read off.

All axes lie in one plane; y is measured along it from the axis of the input shaft. The velocity of a point of a member
is linear in y, so that two points give the member's line: the velocity of the driving member is laid off, points in
mesh and axes of satellites are common to two members, fixed axes and fixed wheels give zeros.

        y │  .B   the line of a satellite passes through A and C
          │.' .A
        O └────── v

Rays from the pole P parallel to the lines cut off on a straight line at the pole distance H segments s that are
in proportion to the angular velocities. Source: Artobolevsky, Theory of mechanisms and machines, ch. VII.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

from tmm_report.chapters.gears.drive.places import Spot, breadth, height, placed, spots_of, velocity_of
from tmm_report.chapters.gears.drive.sheet import Line, Sheet
from tmm_report.chapters.gears.drive.stages import Stage
from tmm_report.chapters.lever.plans.solve import Comparison
from tmm_report.mechanics.gears.trains import Train
from tmm_report.quantity.paper import Pen, round_scale, rounded
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import Scale

# mm: the scheme's height, the largest velocity, the plan of angular velocities
TALL, WIDE, LONG = 150.0, 90.0, 155.0
SIDEWAYS = 75.0  # mm: of wheels along a shaft that their axes cross
POLE = 60.0  # mm: the largest pole distance


@dataclass(frozen=True)
class DriveScales:
    """Scales of the drive's diagrams, SI units per mm of paper; what is left out is chosen."""

    length: Annotated[Scale | None, Field(description="m/mm, of the kinematic scheme")] = None
    velocity: Annotated[Scale | None, Field(description="(m/s)/mm, of the diagram of linear velocities")] = (
        None
    )
    angular: Annotated[Scale | None, Field(description="(rad/s)/mm, of the plan of angular velocities")] = (
        None
    )


@dataclass(frozen=True, eq=False)
class Plans:
    """The constructed diagrams. `velocity`: of the spots by name, mm as read, signed; `axes`: m, y of each member's
    axis; `sides`: of each stage, +1 where its satellites stand above the main axis; `first`: the spot of the input
    member whose velocity is laid off; `accuracy` mm."""

    length_scale: float
    velocity_scale: float
    angular_scale: float
    accuracy: float
    axes: Mapping[str, float]
    sides: tuple[int, ...]
    spots: tuple[Spot, ...]
    velocity: Mapping[str, float]
    lines: tuple[Line, ...]
    first: Spot
    comparison: tuple[Comparison, ...] = ()

    @property
    def pole(self) -> float:
        """The pole distance H, mm."""
        return self.velocity_scale / (self.length_scale * self.angular_scale)

    def segment(self, member: str) -> float:
        """The segment s of a member in the plan of angular velocities, mm, signed."""
        return next(line.s for line in self.lines if member in line.members)

    def ratio(self, one: str, other: str) -> float:
        """The ratio of two members' speeds by their segments; inf where the second is zero."""
        below = self.segment(other)
        return self.segment(one) / below if below else float("inf")


def draw(
    stages: Sequence[Stage],
    train: Train,
    known: Mapping[str, float],
    speed: Mapping[str, float],
    scales: DriveScales,
    accuracy: float,
) -> Plans:
    """Construct and read the diagrams from the speeds `known` alone, rad/s; `speed`, of all the members, serves to
    choose the scales and to compare. `accuracy`: m of paper."""
    sides, axes = placed(stages)
    spots = tuple(spots_of(stages, axes))
    analytic = {spot.name: velocity_of(spot, train.by_name, axes, speed) for spot in spots}
    largest = max(height(stages, axes, sides), breadth(stages) * TALL / SIDEWAYS)
    chosen = _chosen(scales, largest, analytic.values(), speed.values())
    pen = Pen(accuracy)
    sheet = Sheet(train, axes, spots, chosen, pen)
    sheet.construct(known)
    velocity = {spot.name: float(rounded(sheet.v[spot.name], pen.read_step)) for spot in spots}
    plans = Plans(
        chosen["length"],
        chosen["velocity"],
        chosen["angular"],
        pen.read_step,
        axes,
        sides,
        spots,
        velocity,
        tuple(sheet.lines()),
        sheet.farthest(stages[0].input),
    )
    return replace(plans, comparison=tuple(_compared(plans, analytic, speed)))


# --- scales and comparison


def _chosen(
    scales: DriveScales, tall: float, velocities: Iterable[float], speeds: Iterable[float]
) -> dict[str, float]:
    """The stated scales, or round ones that fit the paper, the pole distance too."""
    length = scales.length or round_scale(tall, TALL)
    velocity = scales.velocity or round_scale(_span(velocities), WIDE)
    angular = max(round_scale(_span(speeds), LONG), round_scale(velocity / length, POLE))
    return {"length": length, "velocity": velocity, "angular": scales.angular or angular}


def _span(values: Iterable[float]) -> float:
    """From the least to the largest, zero among them."""
    values = [0.0, *values]
    return max(values) - min(values)


def _compared(
    plans: Plans, analytic: Mapping[str, float], speed: Mapping[str, float]
) -> Iterator[Comparison]:
    """Magnitudes by the diagrams against the analytical ones: velocities of the spots, then angular velocities."""
    scale, step = plans.velocity_scale, plans.accuracy
    for name, v in plans.velocity.items():
        yield Comparison(f"v_{name}", abs(v) * scale, abs(analytic[name]), scale * step)
    scale = plans.angular_scale
    for line in plans.lines:
        name = line.members[0]
        yield Comparison(f"w_{name}", abs(line.s) * scale, abs(speed[name]), scale * step)
