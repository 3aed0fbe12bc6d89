"""Where the loads of a cycle have kinks and jumps, so that integrals over it can step from one to the next."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Force, Loads, Moment
from tmm_report.chapters.lever.kinetostatics.solve.coordinates import Coordinate, coordinate
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import reach, strokes
from tmm_report.chapters.lever.kinetostatics.solve.law_arguments import over_cycle
from tmm_report.chapters.lever.kinetostatics.ties import End
from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.laws import ByDisplacement, ByStrokes, Diagram
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.cycle import Cycle, Quantity
from tmm_report.mechanics.lever.motion import Motion

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any


def breaks(given: Loads, kinematics: Kinematics) -> Array:
    """Angles turned from position 0 at which a load, or the motion itself in a corner, has a kink or a jump, rad,
    ascending."""
    cycle = kinematics.cycle
    loads: list[Force | Moment] = [*given.forces, *given.moments]
    laws = [over_cycle(load.law, kinematics) for load in loads if not isinstance(load.law, Diagram)]
    fixed = [one.at for law in laws for one in law.breaks()]
    passed = [of for load in loads for of in _passed(load, cycle)]
    found = [cycle.repeated(roots) for roots in cycle.roots_of(passed)] if passed else []
    for force in given.forces:
        if isinstance(force.law, ByStrokes):
            found += _in_strokes(coordinate(force, cycle), force.law, cycle)
    found.append(cycle.repeated(cycle.breaks))
    found.append(cycle.repeated(cycle.corners))
    return distinct(np.concatenate([np.array(fixed, dtype=float), *found]))


def _passed(load: Force | Moment, cycle: Cycle) -> Iterator[Quantity]:
    """What passes through zero where the load has a kink or a jump, in every turn alike: a displacement that is stated,
    a point or a link that turns back."""
    match load:
        case End():
            yield _towards(load, cycle)
        case Force(law=ByDisplacement() as law) | Moment(law=ByDisplacement() as law):
            yield from _ways(coordinate(load, cycle), law, cycle)
        case Force(at=at, way=str()):
            along = _fastest(cycle, at)
            yield lambda motion: dot(motion.velocity(at), along)
        case Moment(on=on, direction=str()):
            yield lambda motion: motion.angular_velocity(on)


def _towards(end: End, cycle: Cycle) -> Quantity:
    """What passes through zero where the two points of a spring or damper pass through one another: its force turns
    round there."""
    at, other = end.at, end.way.point
    far = cycle.search[1].place(other) - cycle.search[1].place(at)
    along = far[np.nanargmax(np.abs(far))]
    return lambda motion: dot(motion.place(other) - motion.place(at), along / np.abs(along))


def _ways(of: Coordinate, law: ByDisplacement, cycle: Cycle) -> Iterator[Quantity]:
    """The ends of the strokes, and the displacements at which an indicator diagram has its points."""
    yield of.rate
    low, high = cycle.extremes(of.value, of.rate)
    for x in _inside(law):
        yield partial(_beyond, of, high.value - x * (high.value - low.value))


def _in_strokes(of: Coordinate, law: ByStrokes, cycle: Cycle) -> Iterator[Array]:
    """The same of a diagram of several turns: a displacement is met in those strokes alone whose curves have it."""
    own = strokes(law, cycle, of)
    yield own.begins
    _, (low, high) = reach(cycle, of)
    points = _inside(law)
    places = [high.value - x * (high.value - low.value) for x in points]
    met = cycle.roots_of([partial(_beyond, of, place) for place in places]) if places else []
    for curves, roots in zip(points.values(), met, strict=True):
        turned = cycle.repeated(roots)
        yield turned[np.isin(own.at(turned), curves)]


def _inside(law: Diagram) -> dict[float, list[int]]:
    """The breaks of a diagram within the stroke, ascending, and which of its curves have each."""
    found: dict[float, list[int]] = {}
    for one in sorted(law.breaks()):
        if 0 < one.at < 1:
            found.setdefault(one.at, []).append(one.which)
    return found


def _beyond(of: Coordinate, place: float, motion: Motion) -> Array:
    """How far a coordinate is beyond a place, (P,), m or rad."""
    return of.value(motion) - place


def _fastest(cycle: Cycle, at: str) -> complex:
    """The direction of a point's velocity where it is fastest: a point that stops turns back there."""
    velocity = cycle.search[1].velocity(at)
    fastest = velocity[np.nanargmax(np.abs(velocity))]
    return complex(fastest / np.abs(fastest)) if np.abs(fastest) > 0 else 1 + 0j
