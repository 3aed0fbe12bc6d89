"""What acts on a mechanism in exact numbers: the laws of the loads at its exact places and velocities.

Which piece of a law holds (a stroke, a stretch between two points) is taken from the doubles; its value is exact.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.given import Force, Loads
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link, stated
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import reach
from tmm_report.chapters.lever.kinetostatics.solve.law_arguments import reading
from tmm_report.mechanics.calculus.laws import Diagram, Law
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.exact.forces import Acting
from tmm_report.mechanics.rivals.exact.laws import Digits
from tmm_report.mechanics.rivals.exact.moving import Exact, at
from tmm_report.mechanics.rivals.exact.numbers import Number, dot, exact, point
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
            (moment.on, _signed(_magnitudes(moment.law, kinematics, motion, found, turned, None), couple))
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
    sizes = _magnitudes(force.law, kinematics, motion, found, turned, force.at)
    if not isinstance(force.direction, str):
        return [None if x is None else x * point(force.direction) for x in sizes]
    way, still = (1 if force.direction == "along" else -1), np.asarray(size) == 0
    return [
        None if x is None or v is None else 0 * x if lies else way * x * v / abs(v)
        for x, v, lies in zip(sizes, found.row(force.at, Body.velocity), still.tolist(), strict=True)
    ]


def _magnitudes(
    law: Law, kinematics: Kinematics, motion: Motion, found: Exact, turned: Array, name: str | None
) -> Numbers:
    read = reading(law, kinematics, motion, turned, name)
    near, which = (np.broadcast_to(row, np.shape(turned)).tolist() for row in (read.at, read.which))
    if isinstance(law, Diagram):
        assert name is not None
        places = _travelled(law, kinematics, found, name)
    else:
        places = [exact(x) for x in near]
    return [
        None if x is None else read.law.value(x, curve, Digits(rough))
        for x, rough, curve in zip(places, near, which, strict=True)
    ]


def _travelled(law: Diagram, kinematics: Kinematics, found: Exact, name: str) -> Numbers:
    """Displacement over stroke of a point from the extreme in `zero`."""
    _, (low, high) = reach(kinematics.cycle, name, law.zero)
    least, most = (extreme(kinematics, name, law.zero, end.turned) for end in (low, high))
    zero = point(law.zero)
    places = found.row(name, Body.place)
    return [None if z is None else (most - dot(z, zero)) / (most - least) for z in places]


def extreme(kinematics: Kinematics, name: str, along: complex, turned: float) -> Number:
    """The extreme coordinate of a point along a direction that is reached at about the angle `turned`, rad, m: by the
    parabola through its value, rate and second derivative there, whose error is the fourth power of the angle's."""
    there = at(kinematics.cycle, float(kinematics.cycle.phi(np.array(turned))))
    way = point(along)
    place, rate, second = (
        dot(there.row(name, of)[0], way) for of in (Body.place, Body.velocity, Body.acceleration)
    )
    return place - rate * rate / (2 * second) if kinematics.cycle.closed else place
