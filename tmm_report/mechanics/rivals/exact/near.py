"""Near a singular position: reached from a regular one beside it, by ever shorter steps, from both sides.

There a start in doubles has lost its digits, and may lie nearer to the other assembly than to its own. Steps halve the
way that is left; each is taken only if it leads surely to the nearest root (see `solving.UNIQUE`).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmm_report.mechanics.rivals.exact.numbers import Number, context, exact
from tmm_report.mechanics.rivals.exact.scheme import Body, Pose
from tmm_report.mechanics.rivals.exact.solving import Start

Solve = Callable[[Any, Start, int], Pose | None]  # driver angle, start, digits -> motion
Regular = Callable[[float], Pose | None]  # the same from a start in doubles, where that can be trusted

BESIDE = (0.03, 0.01, 0.1, 0.003, 0.2)  # rad: how far regular positions are sought
DIGITS = 160  # carried on the way
LEAST = 1e-25  # rad: nearer than this there is no position but the limit
SHORTER = 0.5  # of the way that is left
PATIENCE = 12  # of shortenings of one step


def approached(solve: Solve, regular: Regular, phi: float, sense: int) -> Pose | None:
    """The motion at driver angle `phi`, rad, as it is come to in the sense of rotation, or else from the other side; in
    a singular position the mean of both sides beside it, None where they do not agree."""
    sides: list[Pose] = []
    for way in (-sense, sense):
        if (side := _from(solve, regular, phi, way)) is not None:
            pose, there = side
            if there:
                return pose
            sides.append(pose)
    if len(sides) < 2:
        return None
    return _mean(sides[0], sides[1]) if _agree(sides[0], sides[1], 1e-15) else None


def _from(solve: Solve, regular: Regular, phi: float, way: int) -> tuple[Pose, bool] | None:
    """The motion at `phi`, or `LEAST` beside it, from the regular positions on one side; whether it is the former."""
    with context().workdps(DIGITS):
        for beside in BESIDE:
            angle = phi + way * beside
            if (pose := regular(angle)) is not None:
                return _walk(solve, phi, angle, pose)
    return None


def _walk(solve: Solve, phi: float, angle: float, pose: Pose) -> tuple[Pose, bool] | None:
    goal, at = exact(phi), exact(angle)
    while True:
        there = solve(goal, ahead(pose, goal - at), DIGITS)
        if there is not None:
            return there, True
        if abs(goal - at) < LEAST:
            return pose, False
        share = SHORTER
        for _ in range(PATIENCE):
            target = at + (goal - at) * share
            step = solve(target, ahead(pose, target - at), DIGITS)
            if step is not None:
                break
            share /= 2
        else:
            return None
        at, pose = target, step


def ahead(pose: Pose, turned: Number) -> Start:
    """Where the links are after the driving link has turned on by so much, by their rates."""
    own = context()
    omega = next(body.w for body in pose.values() if body.w != 0)
    time = turned / omega
    return {
        link: (
            body.r + body.v * time + body.a * (time * time / 2),
            body.u * own.expj(body.w * time + body.e * (time * time / 2)),
        )
        for link, body in pose.items()
    }


RATES = ("r", "u", "v", "w", "a", "e")


def _agree(a: Pose, b: Pose, part: float) -> bool:
    return all(
        abs(getattr(a[link], name) - getattr(b[link], name))
        <= part * max(1e-3, *(abs(getattr(pose[other], name)) for pose in (a, b) for other in pose))
        for link in a
        for name in RATES
    )


def _mean(a: Pose, b: Pose) -> Pose:
    means = ({name: (getattr(a[link], name) + getattr(b[link], name)) / 2 for name in RATES} for link in a)
    return {link: Body(**mean) for link, mean in zip(a, means, strict=True)}
