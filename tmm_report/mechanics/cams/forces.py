"""Forces between a cam and its follower with friction: in the guide or the pivot, in the roller's pin, on the face.

The follower needs Q along its lift, N, of one that swings about its pivot, N m: load, weight, spring and mω²S'' or
Jω²ψ''. The cam gives it R = |N|u, u = ±n + τ tan δ: n the normal from the cam to the follower, + of the profile, − of
the outer wall of a groove; τ the way in which the cam's surface drags; sin δ = f r_p/r of a roller on its pin (R is
tangent to the circle of friction), tan δ = f of an edge or a face.

    slides, a along the lift      |N| (u·a − σf(|k₁| + |k₂|)) = Q,  σ the sign of S'
        guide from b to b + c     k₁ + k₂ = −u·ia,  k₁b + k₂(b + c) = −(KB × u): what bears on its ends for |N| = 1
    swings about P                |N| (P̄C × u) − σρ ||N|u + w| = Q,  ρ = f d/2, w the other forces on the follower

It jams where the bracket is not above zero; without friction but that of the guide, u·ia = sin α, this is
N = Q/(cos α − f(1 + 2b/c) sin α), tan α < c/(f(c + 2b)). A force below zero is what would have to pull the follower to
a cam that can only push: there it has left the cam, and the force is told without friction.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 11, 26; Levitsky, Cam mechanisms, ch. 5.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.cams.cam import Cam, Moved, Sliding
from tmm_report.records import dataclass

Array = Any
STILL = 1e-9  # of the greatest: a derivative below it is a follower that stands


@dataclass(frozen=True)
class Guide:
    """A guide of a sliding follower: its `length` c and the `overhang` b from the follower's point to its nearer end,
    m; `lowest`: b is that of the lowest position, and lessens with the lift."""

    length: float
    overhang: float
    friction: float
    lowest: bool = False

    def at(self, S: Array) -> Array:
        """The overhang at displacements."""
        return self.overhang - S if self.lowest else self.overhang + 0 * S

    def jams_from(self, S: Array) -> Array:
        """The pressure angle at which nothing but its friction stops a follower that rises, rad; 90° without any."""
        if self.friction == 0:
            return np.full(np.shape(S), np.pi / 2)
        return np.arctan(self.length / (self.friction * (self.length + 2 * self.at(S))))


@dataclass(frozen=True)
class Pin:
    """A journal: of a roller, of the pivot of a swinging follower; radius, m."""

    radius: float
    friction: float

    @property
    def circle(self) -> float:
        """Radius of the circle of friction, m."""
        return self.radius * self.friction


@dataclass(frozen=True)
class Rubs:
    """What rubs. `face`: coefficient of friction of an edge or of a flat face on the cam."""

    guide: Guide | None = None
    pin: Pin | None = None
    face: float = 0.0
    pivot: Pin | None = None

    @property
    def any(self) -> bool:
        return bool(
            self.face or any(one is not None and one.friction for one in (self.guide, self.pin, self.pivot))
        )


@dataclass(frozen=True, eq=False)
class Needs:
    """What the follower needs, (P,): `Q` along its lift, N or N m; `beside`: the forces on one that swings beside that
    of the cam and of its pivot, N, complex: a couple is none."""

    Q: Array
    beside: Array = 0j


@dataclass(frozen=True, eq=False)
class Pressed:
    """Forces at the positions, (P,). `N`: along the normal, N, below zero where the follower has `left` a cam that only
    pushes, or is pulled by a groove; `R`: of the cam on the follower, complex; `torque`: of the drive, in the sense of
    rotation, N m; `smooth`: the same without friction; `lost`: power of each friction by its name, for ω = 1, W s;
    `ends`: what bears on the ends of a guide, (2, P), N; `jams`; `share`: the bracket over what it is without
    friction: the part of the cam's force that friction leaves."""

    N: Array
    R: Array
    torque: Array
    smooth: Array
    lost: dict[str, Array]
    ends: Array | None
    left: Array
    jams: Array
    share: Array

    @property
    def wasted(self) -> Array:
        """All that friction takes, for ω = 1."""
        return sum(self.lost.values(), np.zeros(np.shape(self.N)))


@dataclass(frozen=True, eq=False)
class Touching:
    """The contact at positions: place `at` and `direction` u from O, the follower's point `b`; `drag`: velocity of the
    cam's surface along τ over what it rubs on, for ω = 1: m of a face, rad of a roller on its pin."""

    at: Array
    direction: Array
    b: Array
    drag: Array
    S1: Array


def lift_of(cam: Cam, q: Moved, sense: int) -> tuple[Array, Array, Array]:
    """The follower's coordinate in the sense of its lift with its derivatives by the angle turned in the sense of
    rotation, (P,): m of one that slides, rad of one that swings. The coordinate counts from where the cam's does."""
    way = 1 if isinstance(cam.motion, Sliding) else cam.motion.side
    return way * q.z, way * sense * q.d, way * q.dd


def touching(
    cam: Cam, moved: tuple[Moved, Moved], sense: int, rubs: Rubs, outer: Array | bool = False
) -> Touching:
    """The contact with its friction where the follower has `moved`. `outer`: on the outer wall of a groove."""
    q, b = moved
    found = cam.touched(q, b)
    flank = np.where(outer, -1.0, 1.0)
    at = found.at if cam.flat else b.z - flank * (cam.roller or 0.0) * found.normal
    rate = 0.0 if isinstance(cam.motion, Sliding) else sense * q.d
    tangent = 1j * found.normal
    surface = sense * 1j * at
    if cam.roller:
        spin = cross(at - b.z, surface - sense * b.d) / cam.roller**2
        drag, leaned = spin - rate, _leaned(rubs.pin, cam.roller)
        # the pin holds the roller back, so the cam drags it on in the sense of its spin
        way = np.sign(drag) * np.sign(cross(at - b.z, tangent))
    else:
        own = sense * b.d if isinstance(cam.motion, Sliding) else rate * 1j * (at - cam.motion.pivot)
        slides = dot(surface - own, tangent)
        drag, leaned, way = slides, rubs.face, np.sign(slides)
    direction = flank * found.normal + way * leaned * tangent
    return Touching(at, direction, b.z, np.abs(drag), lift_of(cam, q, sense)[1])


def _leaned(pin: Pin | None, roller: float) -> float:
    """tan δ of a roller on a pin that rubs."""
    if pin is None:
        return 0.0
    sine = pin.circle / roller
    return sine / np.sqrt(1 - sine * sine)


def pressed(
    cam: Cam,
    moved: tuple[Moved, Moved],
    sense: int,
    needs: Needs,
    rubs: Rubs,
    S: Array,
    groove: bool = False,
) -> Pressed:
    """Forces where the follower has `moved`, (P,). `S`: displacement, m or rad; `groove`: the cam holds the follower to
    itself by a second wall."""
    Q = needs.Q + np.zeros(np.shape(S))
    none = Rubs()
    smooth = touching(cam, moved, sense, none)
    arm = _lifting(cam, smooth)
    plain = Q / arm
    without = sense * cross(smooth.at, plain * smooth.direction)
    pulled = Q < 0
    outer = pulled & groove
    here = touching(cam, moved, sense, rubs, outer)
    sign = np.where(outer, -1.0, 1.0)
    size, share, ends = _solved(cam, here, needs, Q, rubs, S, sign, sign * arm)
    freed = pulled & ~outer
    jams = ~(share > 0) & (Q != 0) & ~freed
    left = freed | (~jams & (size < 0))
    N = np.where(freed, plain, np.where(jams, np.nan, sign * size))
    R = np.where(freed, plain * smooth.direction, np.where(jams, np.nan, size * here.direction))
    held = np.where(left | jams, 0.0, size)
    torque = np.where(freed, without, sense * cross(here.at, R))
    lost = _lost(cam, here, needs, rubs, held, ends)
    return Pressed(N, R, torque, without, lost, None if ends is None else held * ends, left, jams, share)


def _lifting(cam: Cam, here: Touching) -> Array:
    """What a cam's force of |N| = 1 does along the lift: a part of it, or its moment about the pivot, m."""
    if isinstance(cam.motion, Sliding):
        return dot(here.direction, cam.motion.along)
    return cam.motion.side * cross(here.at - cam.motion.pivot, here.direction)


def _solved(
    cam: Cam, here: Touching, needs: Needs, Q: Array, rubs: Rubs, S: Array, sign: Array, smooth: Array
) -> tuple[Array, Array, Array | None]:
    """|N|, the part that friction leaves, and what bears on the ends of a guide for |N| = 1, (2, P)."""
    lifting, way = _lifting(cam, here), ways(here.S1)
    with np.errstate(divide="ignore", invalid="ignore"):
        if isinstance(cam.motion, Sliding):
            ends = bears(cam.motion, here, rubs.guide, S)
            kept = lifting if ends is None else lifting - way * rubs.guide.friction * np.abs(ends).sum(axis=0)  # type: ignore[union-attr]
            return Q / kept, kept / smooth, ends
        circle = rubs.pivot.circle if rubs.pivot else 0.0
        u, w = here.direction, needs.beside + 0j
        # (kx − Q)² = ρ²|xu + w|², whose discriminant is written so that it vanishes with ρ²; of both roots that on
        # the side on which friction adds
        inside = np.abs(lifting * w + Q * u) ** 2 - (circle * cross(u, w)) ** 2
        middle = lifting * Q + circle**2 * dot(u, w)
        size = (middle + way * sign * circle * np.sqrt(np.maximum(inside, 0.0))) / (
            lifting**2 - (circle * np.abs(u)) ** 2
        )
        size = np.where(way == 0, Q / lifting, size)
        kept = np.where(way * sign > 0, np.sign(lifting) * (np.abs(lifting) - circle * np.abs(u)), lifting)
        return size, kept / smooth, None


def ways(S1: Array) -> Array:
    """Which way the follower goes, +1 lifted, −1, and 0 where it stands."""
    return np.where(np.abs(S1) <= STILL * np.max(np.abs(S1), initial=0.0), 0.0, np.sign(S1))


def bears(motion: Sliding, here: Touching, guide: Guide | None, S: Array) -> Array | None:
    """What bears on the near and the far end of a guide, along ia, for |N| = 1."""
    if guide is None:
        return None
    across = dot(here.direction, 1j * motion.along)
    turning = cross(here.at - here.b, here.direction)
    far = (guide.at(S) * across - turning) / guide.length
    return np.stack([-across - far, far])


def _lost(
    cam: Cam, here: Touching, needs: Needs, rubs: Rubs, size: Array, ends: Array | None
) -> dict[str, Array]:
    """Power of each friction for ω = 1: force or moment by what slides or turns."""
    found: dict[str, Array] = {}
    force = size * np.abs(here.direction)
    if cam.roller and rubs.pin:
        found["pin"] = rubs.pin.circle * force * here.drag
    if not cam.roller and rubs.face:
        found["face"] = rubs.face * size * here.drag
    if ends is not None and rubs.guide:
        found["guide"] = rubs.guide.friction * size * np.abs(ends).sum(axis=0) * np.abs(here.S1)
    if rubs.pivot and not isinstance(cam.motion, Sliding):
        bears = np.abs(size * here.direction + needs.beside)
        found["pivot"] = rubs.pivot.circle * bears * np.abs(here.S1) * (size != 0)
    return found
