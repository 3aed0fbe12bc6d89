"""Where the loads of a cycle have kinks and jumps, so that integrals over it can step from one to the next."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import (
    ByAngle,
    ByDisplacement,
    ByPosition,
    ByStrokes,
    Force,
    Law,
    Loads,
    Moment,
)
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import reach, strokes
from tmm_report.mechanics.calculus.distinct import distinct
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.lever.cams.kinks import breaks as cam_breaks
from tmm_report.mechanics.lever.cycle import Cycle, Quantity
from tmm_report.mechanics.lever.motion import Motion

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any


def breaks(given: Loads, kinematics: Kinematics) -> Array:
    """Angles turned from position 0 at which a load, or the motion itself in a corner, has a kink or a jump, rad,
    ascending."""
    cycle = kinematics.cycle
    count = kinematics.positions.table
    loads: list[Force | Moment] = [*given.forces, *given.moments]
    fixed = [x for load in loads for x in _stated(load.law, cycle, count)]
    passed = [of for load in loads for of in _passed(load, cycle)]
    found = [cycle.repeated(roots) for roots in cycle.roots_of(passed)] if passed else []
    for force in given.forces:
        if isinstance(force.law, ByStrokes):
            found += _in_strokes(force.at, force.law, cycle)
    found.append(
        cycle.repeated(np.mod(cycle.sense * (cam_breaks(cycle.linkage.mechanism) - cycle.zero), FULL_TURN))
    )
    found.append(cycle.repeated(cycle.corners))
    return distinct(np.concatenate([np.array(fixed, dtype=float), *found]))


def _stated(law: Law, cycle: Cycle, count: int) -> Iterator[float]:
    """Those that a law states by angle."""
    match law:
        case ByPosition(values):
            yield from np.arange(len(values)) * (cycle.period / count)
        case ByAngle(angles, _):
            yield from angles


def _passed(load: Force | Moment, cycle: Cycle) -> Iterator[Quantity]:
    """What passes through zero where the load has a kink or a jump, in every turn alike: a displacement that is stated,
    a point or a link that turns back."""
    match load:
        case Force(at=at, law=ByDisplacement() as law):
            yield from _strokes(at, law, cycle)
        case Force(at=at, direction=str()):
            along = _fastest(cycle, at)
            yield lambda motion: dot(motion.velocity(at), along)
        case Moment(on=on, direction=str()):
            yield lambda motion: motion.angular_velocity(on)


def _strokes(at: str, law: ByDisplacement, cycle: Cycle) -> Iterator[Quantity]:
    """The ends of the strokes, and the displacements at which an indicator diagram has its points."""

    def rate(motion: Motion) -> Array:
        return dot(motion.velocity(at), law.zero)

    yield rate
    low, high = cycle.extremes(lambda motion: dot(motion.place(at), law.zero), rate)
    for x in sorted({x for way in (law.forward, law.back) for x, _ in way if 0 < x < 1}):
        yield partial(_beyond, at, law.zero, high.value - x * (high.value - low.value))


def _in_strokes(at: str, law: ByStrokes, cycle: Cycle) -> Iterator[Array]:
    """The same of a diagram of several turns: a displacement is met in those strokes alone whose curves have it."""
    own = strokes(law, cycle, at)
    yield own.begins
    _, (low, high) = reach(cycle, at, law.zero)
    points = sorted({x for curve in law.curves for x, _ in curve if 0 < x < 1})
    places = [high.value - x * (high.value - low.value) for x in points]
    met = cycle.roots_of([partial(_beyond, at, law.zero, place) for place in places]) if places else []
    for x, roots in zip(points, met, strict=True):
        turned = cycle.repeated(roots)
        has = np.array([any(x == point for point, _ in curve) for curve in law.curves])
        yield turned[has[own.at(turned)]]


def _beyond(at: str, along: complex, place: float, motion: Motion) -> Array:
    """How far a point is beyond a place along a direction, (P,), m."""
    return dot(motion.place(at), along) - place


def _fastest(cycle: Cycle, at: str) -> complex:
    """The direction of a point's velocity where it is fastest: a point that stops turns back there."""
    velocity = cycle.search[1].velocity(at)
    fastest = velocity[np.nanargmax(np.abs(velocity))]
    return complex(fastest / np.abs(fastest)) if np.abs(fastest) > 0 else 1 + 0j
