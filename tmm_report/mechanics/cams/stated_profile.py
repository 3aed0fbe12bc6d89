"""A cam stated by its profile: a circle, or points joined by a periodic spline in polar coordinates about its axis.

The follower is found where the offset curve of the profile (the pitch curve) meets the path of the roller's centre, by
Newton's method from the nearest of the points laid on the curve; its velocity and acceleration are those of the
replacing link from the centre of curvature K, which stands still on the cam to the second order:

    iK + iω w = q' B_q,     −K + (iε − ω²) w = q'' B_q + q'² B_qq,     w = KB

A flat face that slides rests on the farthest point: h = max n·p, so h' = n·iK, h'' = −n·K.
A circle is exact to rounding; of a spline through points of a smooth curve, n a turn, places are exact to O(n⁻⁴),
accelerations to O(n⁻²). Source: Levitsky, Cam mechanisms, ch. 3; de Boor, A practical guide to splines, ch. 4.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import interpolated
from tmm_report.mechanics.calculus.vectors import cross, dot, resolve
from tmm_report.mechanics.cams.cam import Moved, Sliding, Swinging, bounded
from tmm_report.mechanics.cams.follower_laws import FULL_TURN, Spline
from tmm_report.records import dataclass

Array = Any
LAID = 720  # points by which the contact is first found
AT_ONCE = 256  # angles at which it is sought at once: a few MB of points


@dataclass(frozen=True, eq=False)
class Circle:
    """A circular cam: its centre from the axis and its radius, m."""

    centre: complex
    radius: float

    def of(self, u: Array) -> Moved:
        """The point at the parameter u, rad, in the cam's axes, and its derivatives by u."""
        arm = self.radius * np.exp(1j * u)
        return Moved(self.centre + arm, 1j * arm, -arm)


@dataclass(frozen=True, eq=False)
class Polar:
    """A profile through points: their polar angles, ascending within a turn, rad, and radii, m."""

    angles: tuple[float, ...]
    radii: tuple[float, ...]

    @cached_property
    def spline(self) -> Spline:
        x = np.array([*self.angles, self.angles[0] + FULL_TURN])
        return Spline(x, np.array([*self.radii, self.radii[0]]))

    def of(self, u: Array) -> Moved:
        r, d, dd = self.spline.of(u)
        turn = np.exp(1j * u)
        return Moved(r * turn, (d + 1j * r) * turn, (dd + 2j * d - r) * turn)


@dataclass(frozen=True, eq=False)
class ByProfile:
    """The follower's coordinate as its profile makes it. `roller`: radius, m; None: a face along `face`."""

    curve: Circle | Polar
    motion: Sliding | Swinging
    roller: float | None
    face: complex = 1.0

    def of(self, phi: Array) -> Moved:
        """q, dq/dφ, d²q/dφ² at angles of the cam's x axis, rad; nan where cam and follower do not meet."""
        phi = np.asarray(phi, dtype=float)
        parts = np.split(phi.ravel(), range(AT_ONCE, phi.size, AT_ONCE))
        found = map(self._of_face if self.roller is None else self._of_roller, parts)
        return Moved(*(np.concatenate(one).reshape(phi.shape) for one in zip(*found, strict=True)))

    # ------------------------------------------------------------ a roller

    def _of_roller(self, phi: Array) -> Moved:
        u = self._met(phi)
        turned = np.exp(1j * phi)
        b, _ = self._pitch(u)
        q = self._coordinate(b * turned)
        K, _ = self.curvature(u)
        w, K = (b - K) * turned, K * turned
        _, rate, bend = self.motion.point(q, 1.0, 0.0)
        with np.errstate(invalid="ignore", divide="ignore"):
            d, turn = resolve(1j * K, rate, -1j * w)
            dd, _ = resolve(-K - turn**2 * w - d**2 * bend, rate, -1j * w)
        return Moved(q, d, dd)

    def _pitch(self, u: Array) -> tuple[Array, Array]:
        """A point of the pitch curve in the cam's axes and its derivative by u."""
        p, d, dd = self.curve.of(u)
        speed = np.abs(d)
        curvature = cross(d, dd) / speed**3
        r = self.roller or 0.0
        return p - 1j * r * d / speed, d * (1 + r * curvature)

    def curvature(self, u: Array) -> tuple[Array, Array]:
        """Centre of curvature in the cam's axes and radius of the profile, m, + where it is convex."""
        p, d, dd = self.curve.of(u)
        speed = np.abs(d)
        radius = bounded(speed**3, cross(d, dd), float(np.max(np.abs(p), initial=1e-9)))
        return p + 1j * radius * d / speed, radius

    def _coordinate(self, b: Array) -> Array:
        """The coordinate at which the follower's point is at a place, from O."""
        if isinstance(self.motion, Sliding):
            return dot(self.motion.along, b - self.motion.foot)
        towards = np.angle(-self.motion.pivot)
        return towards + np.angle((b - self.motion.pivot) * np.exp(-1j * towards))

    def _gap(self, b: Array) -> Array:
        """How far a place is from the path of the follower's point, m."""
        if isinstance(self.motion, Sliding):
            return cross(self.motion.along, b - self.motion.foot)
        return np.abs(b - self.motion.pivot) - abs(self.motion.arm)

    def _met(self, phi: Array) -> Array:
        """The parameter at which the pitch curve meets the follower's path, the farthest lifted of all."""
        laid = np.arange(LAID) * FULL_TURN / LAID
        turned = np.exp(1j * phi)[..., None]
        b = self._pitch(laid)[0] * turned
        gap = self._gap(b)
        # the last is followed by the first itself: one worked out again at a whole turn may round to the other side
        crossed = (gap <= 0) != (np.roll(gap, -1, axis=-1) <= 0)
        lifted = self._coordinate(b) * (1 if isinstance(self.motion, Sliding) else self.motion.side)
        found = np.where(crossed, lifted, -np.inf)
        at = np.argmax(found, axis=-1)
        first = np.take_along_axis(gap, at[..., None], axis=-1)[..., 0]
        begin = np.where(np.isfinite(np.max(found, axis=-1)), laid[at], np.nan)

        def gap_at(u: Array) -> Array:
            return self._gap(self._pitch(u)[0] * turned[..., 0])

        return interpolated(gap_at, begin, begin + FULL_TURN / LAID, first, np.zeros(np.shape(begin)))[0]

    # ------------------------------------------------------------ a flat face that slides

    def _of_face(self, phi: Array) -> Moved:
        assert isinstance(self.motion, Sliding)
        n = 1j * self.face * self.motion.turn
        n = n if dot(n, self.motion.along) > 0 else -n
        back = n * np.exp(-1j * phi)  # the normal in the cam's axes
        laid = np.arange(LAID) * FULL_TURN / LAID
        p = self.curve.of(laid).z
        u = laid[np.argmax(dot(back[..., None], p), axis=-1)]
        ends = u - FULL_TURN / LAID, u + FULL_TURN / LAID

        def falls(u: Array) -> Array:  # past the point that lies farthest along the normal
            return dot(back, self.curve.of(u)[1])

        u = interpolated(falls, *ends, falls(ends[0]), np.zeros(np.shape(u)))[0]
        K, radius = self.curvature(u)
        h = dot(back, K) + radius
        slant = dot(n, self.motion.along)
        return Moved((h - dot(n, self.motion.foot)) / slant, dot(back, 1j * K) / slant, -dot(back, K) / slant)
