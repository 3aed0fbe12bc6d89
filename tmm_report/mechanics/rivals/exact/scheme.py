"""A mechanism as points, lines and pairs in exact numbers, and the equations that its pairs put on its links.

Every link has three coordinates: the place of the origin of its axes and its angle. A pivot gives two equations
(its point is one on both links), so does a guide (the sliding point lies on the line; both lines have one
direction). The driving link's coordinates are known. Nothing is taken apart into groups here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any

from tmm_report.mechanics.lever.assur_groups import Pair, Structure
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.rivals.exact.numbers import MOST, Number, context, cross, dot, exact, point, unit
from tmm_report.records import dataclass


@dataclass(eq=False)
class Body:
    """Motion of a link's axes: place of the origin, unit direction of x, their rates; exact."""

    r: Number
    u: Number
    v: Number = 0
    w: Number = 0
    a: Number = 0
    e: Number = 0

    def place(self, at: Number) -> Number:
        return self.r + self.u * at

    def velocity(self, at: Number) -> Number:
        return self.v + 1j * self.w * (self.u * at)

    def acceleration(self, at: Number) -> Number:
        return self.a + (1j * self.e - self.w * self.w) * (self.u * at)


Pose = dict[str, Body]
Drives = Callable[
    [Any, Pose], Pose
]  # driver angle, motion of the driving link -> that of the links it drives by a law


@dataclass(frozen=True, eq=False)
class Joint:
    """A pair with exact numbers. Of a pivot `first` and `second` are its links in their order; of a guide the link that
    slides, then the one that carries it. `at`: places in their axes; `along`: unit directions of the line there."""

    pair: Pair
    first: str
    second: str
    at: tuple[Number, Number]
    along: tuple[Number, Number] | None = None

    def line(self, pose: Pose) -> tuple[Number, Number]:
        """Direction of the guide, and the sliding point from the guide's own, world axes."""
        assert self.along is not None
        slider, carrier = pose[self.first], pose[self.second]
        return carrier.u * self.along[1], slider.place(self.at[0]) - carrier.place(self.at[1])

    def aligned(self, pose: Pose) -> tuple[Number, Number]:
        assert self.along is not None
        return pose[self.second].u * self.along[1], pose[self.first].u * self.along[0]


def joint(pair: Pair) -> Joint:
    if pair.kind == "R":
        first, second = pair.links
        return Joint(pair, first, second, (point(pair.at[first]), point(pair.at[second])))
    slider = str(pair.slider)
    links = (slider, pair.other(slider))
    at, along = (
        tuple(of(part[link]) for link in links) for of, part in ((point, pair.at), (unit, pair.along))
    )
    return Joint(pair, *links, at, along)  # type: ignore[arg-type]


@dataclass(frozen=True, eq=False)
class Scheme:
    """A structure in exact numbers. `unknown`: the links whose coordinates the pairs determine; `size`, m, by which
    lengths are measured in the equations; `drives`: motion of links that follow the driving link by a law."""

    structure: Structure
    joints: tuple[Joint, ...]
    unknown: tuple[str, ...]
    size: Number
    drives: Drives | None = None

    @cached_property
    def between(self) -> tuple[Joint, ...]:
        """The pairs that bind unknown links: each gives two equations."""
        return tuple(j for j in self.joints if j.first in self.column or j.second in self.column)

    @cached_property
    def column(self) -> Mapping[str, int]:
        return {link: 3 * k for k, link in enumerate(self.unknown)}


def scheme(structure: Structure, known: Sequence[str] = (), drives: Drives | None = None) -> Scheme:
    """`known`: the links that `drives` moves."""
    mechanism = structure.mechanism
    given = {FRAME, mechanism.driver.link, *known}
    with context().workdps(MOST):
        joints = tuple(joint(pair) for pair in structure.pairs)
        size = max(abs(place) for j in joints for place in j.at) or context().mpf(1)
    return Scheme(structure, joints, tuple(x for x in mechanism.moving if x not in given), size, drives)


def driven(made: Scheme, phi: Any, omega: Any = None) -> Pose:
    """The frame, the driving link at its angle `phi`, rad, and what follows it by a law."""
    own, structure = context(), made.structure
    driver = structure.mechanism.driver
    pivot, arm = (point(structure.driver_pair.at[link]) for link in (FRAME, driver.link))
    u, w = own.expj(exact(phi)), exact(driver.omega if omega is None else omega)
    still = Body(own.mpc(0), own.mpc(1), own.mpc(0), own.mpf(0), own.mpc(0), own.mpf(0))
    crank = Body(pivot - u * arm, u, -1j * w * (u * arm), w, w * w * (u * arm), own.mpf(0))
    pose = {FRAME: still, driver.link: crank}
    return pose if made.drives is None else pose | made.drives(phi, pose)


# ---------------------------------------------------------------- the equations of a pair


def gap(j: Joint, pose: Pose, size: Number) -> tuple[Number, Number]:
    """What is left of both equations; lengths over `size`."""
    if j.along is None:
        z = pose[j.first].place(j.at[0]) - pose[j.second].place(j.at[1])
        return z.real / size, z.imag / size
    t, d = j.line(pose)
    return cross(t, d) / size, cross(*j.aligned(pose))


Coefficients = Mapping[str, tuple[Number, Number, Number]]  # link -> of its v_x / size, v_y / size, ω


def rates(j: Joint, pose: Pose, size: Number) -> tuple[Coefficients, Coefficients]:
    """Both equations differentiated: what stands before the rates of the coordinates of its two links."""
    a, b = pose[j.first], pose[j.second]
    p, q = 1j * (a.u * j.at[0]) / size, 1j * (b.u * j.at[1]) / size
    if j.along is None:
        return (
            {j.first: (1, 0, p.real), j.second: (-1, 0, -q.real)},
            {j.first: (0, 1, p.imag), j.second: (0, -1, -q.imag)},
        )
    t, d = j.line(pose)
    own = dot(*j.aligned(pose))
    return (
        {
            j.first: (-t.imag, t.real, cross(t, p)),
            j.second: (t.imag, -t.real, -dot(t, d) / size - cross(t, q)),
        },
        {j.first: (0, 0, own), j.second: (0, 0, -own)},
    )


def bends(j: Joint, pose: Pose, size: Number) -> tuple[Number, Number]:
    """Second derivatives of both equations with no acceleration of the coordinates."""
    a, b = pose[j.first], pose[j.second]
    normal = (b.w * b.w * (b.u * j.at[1]) - a.w * a.w * (a.u * j.at[0])) / size
    if j.along is None:
        return normal.real, normal.imag
    t, d = j.line(pose)
    passing = (a.velocity(j.at[0]) - b.velocity(j.at[1])) / size
    return -b.w * b.w * cross(t, d) / size - 2 * b.w * dot(t, passing) + cross(t, normal), 0
