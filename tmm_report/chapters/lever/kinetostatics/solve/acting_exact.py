"""What acts on a mechanism in exact numbers: the laws of the loads at its exact places and velocities.

Which piece of a law holds (a stroke, a stretch between two points) is taken from the doubles; its value is exact.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.given import Carried, Force, Loads, Moment
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link, stated
from tmm_report.chapters.lever.kinetostatics.solve.coordinates import Coordinate, coordinate
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import reach
from tmm_report.chapters.lever.kinetostatics.solve.law_arguments import reading
from tmm_report.chapters.lever.kinetostatics.ties import End, Spring, Twist
from tmm_report.mechanics.calculus.laws import Diagram
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.exact.forces import Acting
from tmm_report.mechanics.rivals.exact.laws import Digits
from tmm_report.mechanics.rivals.exact.moving import Exact, at
from tmm_report.mechanics.rivals.exact.numbers import Number, context, dot, exact, point
from tmm_report.mechanics.rivals.exact.scheme import Body

Array = Any
Numbers = list[Number | None]


def acting(given: Loads, kinematics: Kinematics, motion: Motion, found: Exact, turned: Array) -> Acting:
    """The stated loads at the positions of `motion`, angles `turned` from position 0, rad; `found`: the exact motion
    there."""
    forces, moments = stated(given, kinematics, motion, turned)
    return Acting(
        [
            (loaded_link(motion, force), force.at, _force(force, size, kinematics, motion, found, turned))
            for force, (_, size) in zip(given.forces, forces, strict=True)
        ],
        [
            (moment.on, _signed(_magnitudes(moment, kinematics, motion, found, turned), couple))
            for moment, (couple, _) in zip(given.moments, moments, strict=True)
        ],
        given.gravity,
    )


def _signed(sizes: Numbers, couples: Array) -> Numbers:
    """Magnitudes with the signs that the moments have in doubles; 0 where the link stands still."""
    signs = np.sign(couples).tolist()
    return [None if x is None else sign * abs(x) for x, sign in zip(sizes, signs, strict=True)]


def _force(
    force: Force, size: Array, kinematics: Kinematics, motion: Motion, found: Exact, turned: Array
) -> Numbers:
    """The vector of a force at every position."""
    if isinstance(force, End):
        return _pulled(force, size, kinematics, found)
    sizes = _magnitudes(force, kinematics, motion, found, turned)
    if isinstance(force.way, Carried):
        own, link = context().expj(exact(force.way.angle)), force.way.link
        turns = [None if pose is None else pose[link].u for pose in found.poses]
        return [None if x is None or u is None else x * own * u for x, u in zip(sizes, turns, strict=True)]
    if not isinstance(force.way, str):
        return [None if x is None else x * point(force.way) for x in sizes]
    way, still = (1 if force.way == "along" else -1), np.asarray(size) == 0
    return [
        None if x is None or v is None else 0 * x if lies else way * x * v / abs(v)
        for x, v, lies in zip(sizes, found.row(force.at, Body.velocity), still.tolist(), strict=True)
    ]


def _pulled(end: End, size: Array, kinematics: Kinematics, found: Exact) -> Numbers:
    """The force of a spring, c (l − l₀) e, or of a damper, b l′ e; None where its points meet."""
    free = _free(end, kinematics)
    lengths, speeds = (_between(end.at, end.way.point, found, one) for one in (Body.place, Body.velocity))
    known = np.isfinite(np.broadcast_to(size, len(lengths))).tolist()
    return [
        None if d is None or v is None or not known_ else _drawn(end, d, v, free)
        for d, v, known_ in zip(lengths, speeds, known, strict=True)
    ]


def _drawn(end: End, apart: Number, speed: Number, free: Number) -> Number:
    way = apart / abs(apart)
    if isinstance(end.tie, Spring):
        return exact(end.tie.stiffness) * (abs(apart) - free) * way
    return exact(end.tie.viscosity) * dot(way, speed) * way  # type: ignore[attr-defined]


def _between(one: str, other: str, found: Exact, of: Any) -> Numbers:
    rows = zip(found.row(one, of), found.row(other, of), strict=True)
    return [None if a is None or b is None else b - a for a, b in rows]


def _free(end: End, kinematics: Kinematics) -> Number:
    """Free length of a spring, exact also where a preload at a position or a length tells it."""
    if not isinstance(end.tie, Spring):
        return exact(0.0)
    if end.tie.free_length is not None:
        return exact(end.tie.free_length)
    if end.tie.at_length is not None:
        length = exact(end.tie.at_length)
    else:
        there = at(kinematics.cycle, float(kinematics.table.phi[end.tie.at_position or 0]))
        apart = _between(*end.tie.between, there, Body.place)[0]
        assert apart is not None  # the position is there, or the variant is refused
        length = abs(apart)
    return length - exact(end.tie.preload) / exact(end.tie.stiffness)


def _magnitudes(
    load: Force | Moment, kinematics: Kinematics, motion: Motion, found: Exact, turned: Array
) -> Numbers:
    read = reading(load, kinematics, motion, turned)
    near, which = (np.broadcast_to(row, np.shape(turned)).tolist() for row in (read.at, read.which))
    if isinstance(load, Twist):
        places = _turned(load, kinematics, near, found)
    elif isinstance(load.law, Diagram):
        places = _travelled(coordinate(load, kinematics.cycle), kinematics, found)
    else:
        places = [exact(x) for x in near]
    return [
        None if x is None else read.law.value(x, curve, Digits(rough))
        for x, rough, curve in zip(places, near, which, strict=True)
    ]


def _turned(load: Twist, kinematics: Kinematics, near: list[float], found: Exact) -> Numbers:
    """How far a link has turned against the other from position 0, by the exact directions; `near`: in doubles."""
    begin = _against(load, at(kinematics.cycle, float(kinematics.table.phi[0])))[0]
    angle = context().arg
    ways = zip(_against(load, found), near, strict=True)
    return [
        None if way is None else exact(rough) + angle(way / begin * context().expj(-exact(rough)))
        for way, rough in ways
    ]


def _against(load: Twist, found: Exact) -> Numbers:
    def own(pose: Any, link: str) -> Number:
        return exact(1.0) if link == FRAME else pose[link].u

    return [None if pose is None else own(pose, load.on) / own(pose, load.other) for pose in found.poses]


def _travelled(of: Coordinate, kinematics: Kinematics, found: Exact) -> Numbers:
    """Displacement over stroke from the extreme in `zero`."""
    _, (low, high) = reach(kinematics.cycle, of)
    least, most = (extreme(kinematics, of, end.turned) for end in (low, high))
    return [None if z is None else (most - z) / (most - least) for z in _coordinates(of, found)[0]]


def _coordinates(of: Coordinate, found: Exact) -> tuple[Numbers, Numbers, Numbers]:
    """The coordinate at every position with its first two derivatives by the time."""
    if of.middle is None:
        way = point(of.zero)
        rows = (found.row(of.name, one) for one in (Body.place, Body.velocity, Body.acceleration))
        place, rate, second = ([None if z is None else dot(z, way) for z in row] for row in rows)
        return place, rate, second
    sense, middle = int(of.zero.real), point(of.middle)
    bodies = [None if pose is None else pose[of.name] for pose in found.poses]
    return (
        [None if one is None else sense * context().arg(one.u / middle) for one in bodies],
        [None if one is None else sense * one.w for one in bodies],
        [None if one is None else sense * one.e for one in bodies],
    )


def extreme(kinematics: Kinematics, of: Coordinate, turned: float) -> Number:
    """The extreme of a coordinate that is reached at about the angle `turned`, rad; m or rad: by the parabola through
    its value, rate and second derivative there, whose error is the fourth power of the angle's."""
    there = at(kinematics.cycle, float(kinematics.cycle.phi(np.array(turned))))
    place, rate, second = (row[0] for row in _coordinates(of, there))
    assert place is not None and rate is not None and second is not None
    return place - rate * rate / (2 * second) if kinematics.cycle.closed else place
