"""What acts on a mechanism in exact numbers: the laws of the loads at its exact places and velocities.

Which piece of a law holds (a stroke, a stretch between two points) is taken from the doubles; its value is exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, assert_never

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.given import (
    ByAngle,
    ByDisplacement,
    ByPosition,
    ByStrokes,
    Constant,
    Force,
    Law,
    Loads,
)
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link, stated
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import reach, strokes, travelled
from tmm_report.mechanics.calculus.vectors import dot as in_doubles
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.exact.forces import Acting
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
    cycle = kinematics.cycle
    match law:
        case Constant(value):
            return [exact(value)] * len(turned)
        case ByPosition(values):
            angles = np.arange(len(values)) * (cycle.period / kinematics.positions.table)
            return _by_angle(kinematics, turned, angles, values)
        case ByAngle(angles, values):
            return _by_angle(kinematics, turned, np.array(angles), values)
        case ByDisplacement() | ByStrokes():
            assert name is not None
            rough = travelled(law, cycle, motion, name)
            curves: Sequence[Any] = (law.forward, law.back) if isinstance(law, ByDisplacement) else law.curves
            own = _curves(law, kinematics, motion, turned, rough, name)
            exactly = _travelled(law, kinematics, found, name)
            return [
                None if x is None else _read(x, near, curves[k])
                for x, near, k in zip(exactly, rough.tolist(), own.tolist(), strict=True)
            ]
        case _:
            assert_never(law)


def _by_angle(kinematics: Kinematics, turned: Array, angles: Array, values: Sequence[float]) -> Numbers:
    """Straight lines between the points, from the last to the first of the next cycle where it is closed."""
    cycle = kinematics.cycle
    x, y, period = [exact(a) for a in angles], [exact(v) for v in values], exact(cycle.period)
    if cycle.closed:
        x, y = [x[-1] - period, *x, x[0] + period], [y[-1], *y, y[0]]
        rough = np.concatenate([[angles[-1] - cycle.period], angles, [angles[0] + cycle.period]])
        turned = np.mod(turned, cycle.period)
    else:
        rough = angles
    return [_interpolated(exact(t), float(t), x, y, rough) for t in turned]


def _read(x: Number, near: float, curve: Sequence[tuple[float, float]]) -> Number:
    rough = np.array([a for a, _ in curve])
    return _interpolated(x, near, [exact(a) for a, _ in curve], [exact(v) for _, v in curve], rough)


def _interpolated(at: Number, near: float, x: list[Number], y: list[Number], rough: Array) -> Number:
    """As numpy's interp: constant beyond the ends; `near`: the same place in doubles, which tells the stretch."""
    k = int(np.searchsorted(rough, near, side="right")) - 1
    if k < 0 or k >= len(x) - 1:
        return y[0] if k < 0 else y[-1]
    return y[k] + (y[k + 1] - y[k]) * (at - x[k]) / (x[k + 1] - x[k])


def _curves(
    law: ByDisplacement | ByStrokes,
    kinematics: Kinematics,
    motion: Motion,
    turned: Array,
    x: Array,
    name: str,
) -> Array:
    """Which curve of an indicator diagram holds at each position, by its number."""
    if isinstance(law, ByStrokes):
        return strokes(law, kinematics.cycle, name).at(turned)
    rate = in_doubles(motion.velocity(name), law.zero)
    still = np.abs(rate) <= 1e-9 * np.nanmax(np.abs(rate), initial=0.0)
    return np.where(np.where(still, x < 0.5, rate <= 0), 0, 1)


def _travelled(law: ByDisplacement | ByStrokes, kinematics: Kinematics, found: Exact, name: str) -> Numbers:
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
