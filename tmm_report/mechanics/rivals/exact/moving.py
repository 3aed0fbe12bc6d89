"""The exact motion of a mechanism over its positions, laid out as the program's own."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.lever import motion as in_doubles
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.mechanics.rivals.exact.cams import followers
from tmm_report.mechanics.rivals.exact.near import approached
from tmm_report.mechanics.rivals.exact.numbers import DIGITS, Number, exact, point, rows_of
from tmm_report.mechanics.rivals.exact.scheme import Body, Pose, Scheme, scheme
from tmm_report.mechanics.rivals.exact.solving import Start, solved
from tmm_report.mechanics.rivals.model import Pair
from tmm_report.records import dataclass

Array = Any
HAIR = np.array([-1e-6, 1e-6])  # rad: a limit of assembly as near as this may be this side of it or that


@dataclass(frozen=True, eq=False)
class Exact:
    """The exact motion at driver angles `phi`, (P,), rad: the motion of every link at each, None where there is none
    (it does not close, or its rates have no limit)."""

    linkage: Linkage
    scheme: Scheme
    phi: Array
    poses: Sequence[Pose | None]

    @cached_property
    def points(self) -> tuple[str, ...]:
        """Named points in the order of `Motion.point_index`: rows of places, velocities and accelerations."""
        return tuple(self.linkage.carriers)

    @cached_property
    def links(self) -> tuple[str, ...]:
        """Moving links: rows of angular velocities and accelerations."""
        return tuple(self.linkage.mechanism.moving)

    @cached_property
    def pairs(self) -> Mapping[str, Pair]:
        """Rows by position, (rows, P): "place", "velocity", "acceleration" of points, complex; "angular velocity",
        "angular acceleration" of links."""
        w, size = abs(exact(self.linkage.mechanism.driver.omega)), self.scheme.size
        return {
            "place": self._of_points(Body.place, size),
            "velocity": self._of_points(Body.velocity, w * size),
            "acceleration": self._of_points(Body.acceleration, w * w * size),
            "angular velocity": self._of_links(lambda body: body.w, w),
            "angular acceleration": self._of_links(lambda body: body.e, w * w),
        }

    def row(self, name: str, of: Callable[[Body, Number], Number]) -> list[Number | None]:
        """`Body.place`, `velocity` or `acceleration` of a named point at every position."""
        link = self.linkage.arms[name][0]
        at = point(self.linkage.mechanism.links[link].points[name])
        return [None if pose is None else of(pose[link], at) for pose in self.poses]

    def _of_points(self, of: Callable[[Body, Number], Number], usual: Number) -> Pair:
        return rows_of([self.row(name, of) for name in self.points], usual)

    def _of_links(self, of: Callable[[Body], Number], usual: Number) -> Pair:
        rows = [[None if pose is None else of(pose[link]) for pose in self.poses] for link in self.links]
        return rows_of(rows, usual)


def motion(cycle: Cycle, phi: Array, digits: int = DIGITS) -> Exact:
    """The exact motion at angles `phi` of the driving link, rad, each the binary number that it is."""
    linkage, angles = cycle.linkage, np.atleast_1d(np.asarray(phi, dtype=float))
    made = scheme_of(linkage)
    found = in_doubles.solve(linkage, angles)
    poses = [
        _at(linkage, made, start, angle, digits) for start, angle in zip(starts(found), angles, strict=True)
    ]
    return Exact(linkage, made, angles, poses)


def at(cycle: Cycle, phi: float, digits: int = DIGITS) -> Exact:
    """The same at one angle."""
    return motion(cycle, np.array([phi]), digits)


def scheme_of(linkage: Linkage) -> Scheme:
    """A linkage in exact numbers, the followers of its cams moved by their laws."""
    given = [link for cam in linkage.mechanism.cams for link in (cam.name, cam.follower)]
    return scheme(linkage.structure, given, followers(linkage))


def starts(found: Motion) -> list[Start | None]:
    """Of every position of a motion in doubles, (P,), the rough places of its links; None where it does not close."""
    s, shape = found.state, found.shape
    links = found.linkage.mechanism.moving
    u = {link: np.broadcast_to(s.u[link], shape) for link in links}
    r = {link: np.broadcast_to(s.r[link] - s.u[link] * s.o[link], shape) for link in links}
    closes = np.broadcast_to(found.closes, shape)
    return [
        {link: (complex(r[link][k]), complex(u[link][k])) for link in links} if closes[k] else None
        for k in range(shape[0])
    ]


def _at(linkage: Linkage, made: Scheme, start: Start | None, phi: float, digits: int) -> Pose | None:
    """One position, from its start in doubles or, where that cannot be trusted, from regular positions beside it."""

    def solve(angle: Any, rough: Start, carried: int) -> Pose | None:
        return solved(made, angle, rough, carried)

    def regular(angle: float) -> Pose | None:
        beside = starts(in_doubles.solve(linkage, np.array([angle])))[0]
        return None if beside is None else solved(made, angle, beside, digits, surely=True)

    if start is not None and (pose := solved(made, phi, start, digits, surely=True)) is not None:
        return pose
    if start is None and not in_doubles.solve(linkage, phi + HAIR).closes.any():
        return None
    return approached(solve, regular, phi, 1 if linkage.mechanism.driver.omega > 0 else -1)
