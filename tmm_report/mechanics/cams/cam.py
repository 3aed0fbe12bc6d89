"""A cam and its follower: the follower's motion, the contact, the profile, exactly and all positions at once.

The cam is the driving link and turns by φ about O. A follower has one coordinate q (a displacement along its guide, or
an angle about its pivot), which the cam makes a function of φ: q = q0 + σS(θ), θ the cam's angle from the beginning of
its law. World vectors are taken from O; primes are derivatives by φ. In axes that turn with the cam a curve z has the
derivatives z' − iz and z'' − 2iz' − z.

    roller   the pitch curve is the path of the roller's centre B in the cam's axes; c1 = B' − iB, c2 = B'' − 2iB' − B,
             1/ρ = −Im(c̄1 c2)/|c1|³, K = B + ρm, m = −i c1/|c1| (towards the cam); the contact is B + r m
    flat     the face is tangent to the profile: n(z − O) = h on it; p = β' − 1 where its normal n = exp iβ turns;
             contact O + n(h + i h'/p), ρ = h + h''/p² − h' p'/p³, K the contact − ρn

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Levitsky, Cam mechanisms, ch. 3 (replacing mechanism).
"""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Law
from tmm_report.mechanics.cams.sizes.least_size import Size
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.lever.mechanism import Mechanism

Array = Any
FLATTEST = 1e6  # radii of curvature above this many sizes of the cam are taken as this many: a straight piece


class Moved(NamedTuple):
    """A vector and its first two derivatives by the cam's angle."""

    z: Array
    d: Array
    dd: Array


@dataclass(frozen=True, eq=False)
class Sliding:
    """The follower slides on a fixed guide: its point B goes along the unit vector `along`. q: from the foot of the
    perpendicular from O, `foot` (from O, m); `turn`: direction of the follower's x axis."""

    along: complex
    foot: complex
    turn: complex

    def point(self, q: Array, dq: Array, ddq: Array) -> Moved:
        """B from O."""
        return Moved(self.foot + q * self.along, dq * self.along, ddq * self.along)

    def ahead(self, arm: Array) -> Array:
        """Unit direction in which a point of the follower moves when it is lifted."""
        return np.full(np.shape(arm), self.along)

    @property
    def offset(self) -> float:
        """Distance of B's line from the cam's axis, m, + where the axis lies to the left of the lift."""
        return float(-cross(self.along, self.foot))


@dataclass(frozen=True, eq=False)
class Swinging:
    """The follower swings about the fixed point C, `pivot` from O, m; `arm`: from C to B in the follower's axes. q: the
    angle of CB with the x axis. `side`: +1 where B is left of the line from C to O: the lift turns it so."""

    pivot: complex
    arm: complex
    side: int

    def point(self, q: Array, dq: Array, ddq: Array) -> Moved:
        w = abs(self.arm) * np.exp(1j * q)
        return Moved(self.pivot + w, 1j * w * dq, (1j * ddq - dq * dq) * w)

    def ahead(self, arm: Array) -> Array:
        """`arm`: from C to the point."""
        return self.side * 1j * arm / np.abs(arm)


class Motioned(Protocol):
    """What gives the follower's coordinate: a law over the base circle, or the cam's own profile."""

    def of(self, phi: Array) -> Moved:
        """q, dq/dφ, d²q/dφ² at angles of the cam's x axis, rad."""


@dataclass(frozen=True, eq=False)
class ByLaw:
    """q = q0 + σS(θ), θ = `sense`·(φ − `start`)."""

    law: Law
    low: float  # q0
    side: int  # σ
    start: float
    sense: int

    def of(self, phi: Array) -> Moved:
        s, d, dd = self.law.of(self.theta(phi))
        return Moved(self.low + self.side * s, self.side * self.sense * d, self.side * dd)

    def theta(self, phi: Array) -> Array:
        """The cam's angle from the beginning of its law, rad."""
        return self.sense * (np.asarray(phi) - self.start)


class Contact(NamedTuple):
    """Where cam and follower touch, world axes, from O, m, (..., P): the point `at`; `normal`: unit, from the cam to
    the follower; `centre` of the profile's curvature and of the pitch curve's, `radius` of the latter (of the profile,
    where the face is flat), + where the curve is convex."""

    at: Array
    normal: Array
    centre: Array
    radius: Array


@dataclass(frozen=True, eq=False)
class Cam:
    """A cam pair. `name`: of the link that replaces it, `point` B and `centre` K: what that link joins.

    `axis`: O, world, m; `roller`: radius, m, 0 of a knife edge, None of a flat face whose direction in the follower's
    axes is `face`; `guide`: name of the line that replaces a flat face; `limit`: of the pressure angle, rad, `back`: of
    that of a return, where it is limited; `sized`: by what the base circle was found, where it is the smallest.
    """

    name: str
    cam: str
    follower: str
    point: str
    centre: str
    axis: complex
    motion: Sliding | Swinging
    given: Motioned
    roller: float | None
    limit: float
    base: float
    face: complex = 1.0
    guide: str = ""
    back: float | None = None
    sized: Size | None = None

    @property
    def flat(self) -> bool:
        return self.roller is None

    @cached_property
    def size(self) -> float:
        """Greatest distance of the follower's point from the cam's axis, m."""
        return float(np.max(np.abs(self.moved(np.linspace(0, FULL_TURN, 181))[1].z)))

    def moved(self, phi: Array) -> tuple[Moved, Moved]:
        """The follower's coordinate, and its point B from O, with their derivatives by φ."""
        q = self.given.of(phi)
        return q, self.motion.point(*q)

    def turn(self, q: Array) -> Array:
        """Direction of the follower's x axis at a coordinate."""
        if isinstance(self.motion, Sliding):
            return self.motion.turn
        return np.exp(1j * q) * np.conj(self.motion.arm) / abs(self.motion.arm)

    def contact(self, phi: Array) -> Contact:
        """The contact at angles of the cam's x axis."""
        return self.touched(*self.moved(phi))

    def touched(self, q: Moved, b: Moved) -> Contact:
        """The contact where the follower has `moved`."""
        return self._of_face(q, b) if self.flat else self._of_roller(b)

    def _of_roller(self, b: Moved) -> Contact:
        c1, c2 = b.d - 1j * b.z, b.dd - 2j * b.d - b.z
        speed = np.abs(c1)
        inward = -1j * c1 / speed
        radius = bounded(-(speed**3), cross(c1, c2), self.size)
        return Contact(b.z + self.roller * inward, -inward, b.z + radius * inward, radius)

    def _of_face(self, q: Moved, b: Moved) -> Contact:
        h, p = self.support(q, b)
        normal = self.normal(q.z)
        radius = h.z + h.dd / p.z**2 - h.d * p.d / p.z**3
        at = normal * (h.z + 1j * h.d / p.z)
        return Contact(at, normal, at - radius * normal, radius)

    def normal(self, q: Array) -> Array:
        """Unit normal of a flat face, away from the cam, world axes."""
        across = 1j * self.face * self.turn(q)
        if isinstance(self.motion, Sliding):
            way = dot(across, self.motion.along)
        else:
            way = self.motion.side * dot(self.motion.arm, self.face)
        return np.broadcast_to(np.where(way > 0, across, -across), np.shape(q))

    def support(self, q: Moved, b: Moved) -> tuple[Moved, Moved]:
        """Distance h of a flat face from O, m; and p = β' − 1 with its derivative."""
        n = self.normal(q.z)
        if isinstance(self.motion, Sliding):
            slant = dot(n, self.motion.along)
            still = np.zeros(np.shape(q.z))
            return Moved(dot(n, b.z), slant * q.d, slant * q.dd), Moved(still - 1, still, still)
        across, along = dot(1j * n, self.motion.pivot), dot(n, self.motion.pivot)
        h = Moved(dot(n, b.z), across * q.d, across * q.dd - along * q.d**2)
        return h, Moved(q.d - 1, q.dd, np.zeros(np.shape(q.z)))

    def pressure(self, phi: Array) -> Array:
        """Pressure angle, rad: from the follower's motion when it is lifted to the normal, (..., P)."""
        q, b = self.moved(phi)
        return self.pressure_at(b, self.touched(q, b))

    def pressure_at(self, b: Moved, touch: Contact) -> Array:
        """The same where point and contact are known."""
        driven = touch.at if self.flat else b.z  # the roller's centre, or the face at the contact
        arm = driven if isinstance(self.motion, Sliding) else driven - self.motion.pivot
        return np.angle(touch.normal * np.conj(self.motion.ahead(arm)))

    # ------------------------------------------------------------ in the cam's own axes

    def profile(self, phi: Array) -> Array:
        """Points of the profile in axes that turn with the cam, from O, m."""
        return self.contact(phi).at * np.exp(-1j * phi)

    def pitch(self, phi: Array) -> Array:
        """The path of B in axes that turn with the cam, from O, m."""
        return self.moved(phi)[1].z * np.exp(-1j * phi)

    def own_radius(self, phi: Array) -> Array:
        """Radius of curvature of the profile itself, m, + where it is convex."""
        return self.radius_at(self.contact(phi))

    def radius_at(self, touch: Contact) -> Array:
        """The same where the contact is known."""
        return touch.radius - (self.roller or 0.0)


def swept(mechanism: Mechanism) -> Array:
    """World places on the circles that the cams sweep, m: a scheme of all positions must hold them."""
    phi = np.linspace(0, FULL_TURN, 73)
    found = [cam.axis + np.max(np.abs(cam.profile(phi))) * np.exp(1j * phi) for cam in mechanism.cams]
    return np.concatenate(found) if found else np.zeros(0, complex)


def bounded(top: Array, below: Array, size: float) -> Array:
    """top/below, no longer than a straight piece's."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.asarray(top / below, dtype=float)
    most = FLATTEST * size
    return np.where(np.isfinite(ratio), np.clip(ratio, -most, most), most)


# ---------------------------------------------------------------- the lowest position over the base circle


def lowest_sliding(motion: Sliding, base: float) -> float | None:
    """q of a roller's centre at the distance `base` from O, m; None where the offset is greater."""
    square = base**2 - abs(motion.foot) ** 2
    return float(np.sqrt(square)) if square > 0 else None


def lowest_swinging(motion: Swinging, base: float) -> float | None:
    """q of a roller's centre at the distance `base` from O, rad; None where triangle O, C, B does not close."""
    d, l = abs(motion.pivot), abs(motion.arm)
    cosine = (d * d + l * l - base * base) / (2 * d * l)
    towards = float(np.angle(-motion.pivot))
    return towards + motion.side * float(np.arccos(cosine)) if abs(cosine) < 1 else None


def lowest_face_sliding(motion: Sliding, face: complex, base: float) -> float | None:
    """q of a translating flat face at the distance `base` from O, m; None of a face along the motion."""
    n = 1j * face * motion.turn
    n = n if dot(n, motion.along) > 0 else -n
    slant = float(dot(n, motion.along))
    return (base - float(dot(n, motion.foot))) / slant if slant > 1e-6 else None


def lowest_face_swinging(motion: Swinging, face: complex, base: float) -> float | None:
    """q of a swinging flat face at the distance `base` from O, rad; None where it cannot touch the base circle."""
    d = abs(motion.pivot)
    n = 1j * face * (1 if motion.side * dot(motion.arm, face) > 0 else -1)
    turn = np.conj(motion.arm) / abs(motion.arm)
    from_arm = n * turn  # direction of the normal from that of CB
    own = abs(motion.arm) * float(np.real(np.conj(from_arm)))
    cosine = (base - own) / d
    if not abs(cosine) < 1:
        return None
    normal = float(np.angle(motion.pivot)) - motion.side * float(np.arccos(cosine))
    return normal - float(np.angle(from_arm))
