"""A mechanism solved at one angle of its driving link from a start in doubles, to any number of digits.

Places by Newton's method on the equations of all pairs at once, rates by the same equations differentiated. The numbers
of the mechanism and the angle may be doubles or numbers of mpmath.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.rivals.exact.numbers import (
    CONTRACTS,
    DIGITS,
    GUARD,
    Number,
    Row,
    context,
    inverse,
    point,
    solve,
    strain,
)
from tmm_report.mechanics.rivals.exact.scheme import Body, Joint, Pose, Scheme, bends, driven, gap, rates

Array = Any
Start = Mapping[str, tuple[Any, Any]]  # link -> rough origin of its axes, m, and direction of its x axis
NEAR = 1e6  # norm of the inverse of the equations from which a start in doubles may belong to another root
UNIQUE = 0.1  # of a first step times the norm of the inverse: below it the root reached is the nearest (Kantorovich)
STEPS = 30  # of Newton's method


def solved(
    scheme: Scheme,
    phi: Any,
    start: Start,
    digits: int = DIGITS,
    omega: Any = None,
    surely: bool = False,
) -> Pose | None:
    """The motion of all links at driver angle `phi`, rad; None where Newton's method does not settle at the root beside
    `start`, or in a singular position.

    `digits` that are to be right, with those that a near singular position takes on top. `omega`: rad/s, else the
    variant's. `surely`: only where the
    position is regular enough for a start in doubles to be trusted.
    """
    with context().workdps(digits + GUARD):
        pose = driven(scheme, phi, omega)
        for link in scheme.unknown:
            r, u = (point(x) for x in start[link])
            pose[link] = Body(r, u / abs(u))
        return pose if placed(scheme, pose, surely) and moved(scheme, pose) else None


def placed(scheme: Scheme, pose: Pose, surely: bool = False) -> bool:
    """Close all pairs by Newton's method; whether the root is the one beside the start."""
    own = context()
    rows = jacobian(scheme, pose)
    back = inverse(rows)
    bound = strain(rows, back)
    if not np.isfinite(bound) or (surely and bound > NEAR):
        return False
    quick, first, before = bound < NEAR, None, None
    for _ in range(STEPS):
        rest = gaps(scheme, pose)
        size = max(map(abs, rest), default=own.mpf(0))
        if size <= own.eps * 100 and quick:
            return True
        if quick and before is not None and size > before * CONTRACTS:
            quick = False
        step = _quick(back, rest, size) if quick else solve(jacobian(scheme, pose), rest)
        if step is None:
            return False
        length = max(map(abs, step), default=own.mpf(0))
        if first is None:
            first = length
            if first * bound > UNIQUE:
                return False
        _advance(scheme, pose, step)
        if not quick and length <= own.mpf(10) ** (-0.55 * own.dps):
            return True
        before = size
    return False


def _quick(back: Array, rest: Sequence[Number], size: Number) -> list[Number]:
    """A step by the inverse in doubles."""
    step = back @ np.array([float(value / size) for value in rest])
    return [size * x for x in step.tolist()]


def _advance(scheme: Scheme, pose: Pose, step: Sequence[Number]) -> None:
    """Move all unknown links back by a step of their coordinates."""
    own = context()
    for link, k in scheme.column.items():
        body = pose[link]
        u = body.u * own.expj(-step[k + 2])
        pose[link] = Body(body.r - scheme.size * own.mpc(step[k], step[k + 1]), u / abs(u))


def gaps(scheme: Scheme, pose: Pose) -> list[Number]:
    return [part for j in scheme.between for part in gap(j, pose, scheme.size)]


def jacobian(scheme: Scheme, pose: Pose) -> list[Row]:
    """The equations of all pairs differentiated by the coordinates of the unknown links."""
    return [
        {
            scheme.column[link] + c: value
            for link, values in equation.items()
            if link in scheme.column
            for c, value in enumerate(values)
            if value != 0
        }
        for j in scheme.between
        for equation in rates(j, pose, scheme.size)
    ]


def moved(scheme: Scheme, pose: Pose) -> bool:
    """Add the rates of the unknown links; whether there are any: not in a singular position."""
    rows = jacobian(scheme, pose)
    for link in scheme.unknown:
        pose[link].v = pose[link].a = context().mpc(0)
        pose[link].w = pose[link].e = context().mpf(0)
    x = solve(rows, [-value for value in _known(scheme, pose, "v", "w")])
    if x is None:
        return False
    _take(scheme, pose, x, "v", "w")
    bent = [part for j in scheme.between for part in bends(j, pose, scheme.size)]
    known = _known(scheme, pose, "a", "e")
    x = solve(rows, [-(first + second) for first, second in zip(known, bent, strict=True)])
    if x is None:
        return False
    _take(scheme, pose, x, "a", "e")
    return True


def _known(scheme: Scheme, pose: Pose, linear: str, angular: str) -> list[Number]:
    """What the known links put into the equations of rates."""

    def of(j: Joint) -> list[Number]:
        parts = []
        for equation in rates(j, pose, scheme.size):
            total = context().mpf(0)
            for link, (x, y, turn) in equation.items():
                if link not in scheme.column:
                    along = getattr(pose[link], linear)
                    total += (x * along.real + y * along.imag) / scheme.size
                    total += turn * getattr(pose[link], angular)
            parts.append(total)
        return parts

    return [part for j in scheme.between for part in of(j)]


def _take(scheme: Scheme, pose: Pose, x: Sequence[Number], linear: str, angular: str) -> None:
    for link, k in scheme.column.items():
        setattr(pose[link], linear, scheme.size * context().mpc(x[k], x[k + 1]))
        setattr(pose[link], angular, x[k + 2])
