"""A symmetrical cam of circular arcs: the base circle, two flanks (arcs, or straight lines tangent to both circles),
the nose; and how it lifts its follower, in closed form.

From the cam's centre, the axis of symmetry along x: the base circle of radius r1 about 0, the nose of radius r2 about
r, flanks of radius R about −(R − r1) exp ±iα, which leave the base circle at ±α, the half angle of action. So

    r + r2 = r1 + h        (R − r2)² = (R − r1)² + r² + 2(R − r1) r cos α        straight: r cos α = r1 − r2

and two of r2, h, α, r, with R the others; the flank passes into the nose where the normal is at γ:
(R − r2) exp iγ = r + (R − r1) exp iα; straight: γ = α.

On an arc of radius ρ about c a roller of radius r0 is at the distance ρ + r0 from c, along a straight flank at a
constant distance from that line, under a flat face that touches an arc the face is at the distance ρ from c: its place
follows from where c, or the line, has been turned by the cam.

Source: Rattan, Theory of machines, ch. 7; Khurmi, Gupta, Theory of machines, ch. 20; Ballaney, Theory of machines.
"""

from __future__ import annotations

from cmath import rect
from functools import cached_property
from math import acos, cos, inf, isfinite, pi, sqrt
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.records import dataclass

Array = Any
Three = tuple[Array, Array, Array]
FULL_TURN = 2 * np.pi
EDGE = 1e-9  # rad: an angle as near as this before the end of a piece, or of a phase of a law, belongs to the next


class Impossible(ValueError):
    """Sizes of which no cam can be made; the first argument says which."""


@dataclass(frozen=True)
class Outline:
    """r1, r2, r, R, m; R infinite of straight flanks; `stated`: of which sizes the others were found. Raises
    Impossible."""

    base: float
    nose: float
    distance: float
    flank: float = inf
    stated: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not (self.nose > 0 and self.distance > 0 and self.lift > 0):
            raise Impossible("sizes")
        if isfinite(self.flank) and not self.flank > max(self.base, self.nose):
            raise Impossible("flank")
        if not abs(self._cosine) < 1 or not 0 < self.joint <= self.half_angle:
            raise Impossible("angle")

    @property
    def straight(self) -> bool:
        return not isfinite(self.flank)

    @property
    def lift(self) -> float:
        """h of a follower whose line passes through the cam's centre, m."""
        return self.distance + self.nose - self.base

    @property
    def _cosine(self) -> float:
        if self.straight:
            return (self.base - self.nose) / self.distance
        away = self.flank - self.base
        return ((self.flank - self.nose) ** 2 - away**2 - self.distance**2) / (2 * away * self.distance)

    @cached_property
    def half_angle(self) -> float:
        """α, rad."""
        return acos(self._cosine)

    @cached_property
    def joint(self) -> float:
        """γ, rad: of the normal where flank and nose meet."""
        if self.straight:
            return self.half_angle
        return float(np.angle(self.distance + (self.flank - self.base) * np.exp(1j * self.half_angle)))

    def centre(self, side: int) -> complex:
        """Of the flank at the angle `side`·α, m."""
        return -rect(self.flank - self.base, side * self.half_angle)


def outline(
    base: float,
    nose: float | None = None,
    lift: float | None = None,
    half_angle: float | None = None,
    distance: float | None = None,
    flank: float | None = None,
) -> Outline:
    """The cam of what is stated of it, m and rad: of `nose`, `lift`, `half_angle`, `distance` two beside the `flank`
    (inf of a straight one), or three without. Raises Impossible."""
    sizes = {"nose": nose, "lift": lift, "half_angle": half_angle, "distance": distance, "flank": flank}
    stated = tuple(key for key, size in sizes.items() if size is not None)
    a = None if half_angle is None else cos(half_angle)
    radii = [nose, lift, distance]
    if sum(x is not None for x in radii) >= 2:
        if distance is None:
            assert nose is not None and lift is not None
            distance = base + lift - nose
        elif nose is None:
            assert lift is not None
            nose = base + lift - distance
        assert nose is not None
        if flank is None:
            assert a is not None
            flank = _flank(base, nose, distance, a)
        return Outline(base, nose, distance, flank, stated)
    assert a is not None and flank is not None
    away = flank - base
    if distance is not None:
        nose = (
            base - distance * a
            if not isfinite(flank)
            else flank - sqrt(away**2 + distance**2 + 2 * away * distance * a)
        )
    elif nose is not None:
        distance = _distance(base, nose, flank, a)
    else:
        assert lift is not None
        below = 1 - a if not isfinite(flank) else 2 * (away * (1 - a) - lift)
        over = lift if not isfinite(flank) else lift * (2 * away - lift)
        if not below > 0:
            raise Impossible("angle")
        distance = over / below
        nose = base + lift - distance
    return Outline(base, nose, distance, flank, stated)


def _flank(base: float, nose: float, distance: float, a: float) -> float:
    """R; a straight flank is one without end."""
    below = 2 * (base - nose - distance * a)
    over = distance**2 + base**2 - nose**2 - 2 * base * distance * a
    if abs(below) < 1e-12 * base:
        return inf
    if below < 0:
        raise Impossible("hollow")
    return over / below


def _distance(base: float, nose: float, flank: float, a: float) -> float:
    """r by the sum of the vectors to the flank's centre and from it to the nose's."""
    if not isfinite(flank):
        if not a > 0:
            raise Impossible("angle")
        return (base - nose) / a
    away = flank - base
    square = (flank - nose) ** 2 - away**2 * (1 - a * a)
    if square < 0:
        raise Impossible("angle")
    return sqrt(square) - away * a


# ---------------------------------------------------------------- followers


class Slider(NamedTuple):
    """Slides by a line at the `offset`, m, above zero on the side where the cam moves the way of the lift; `roller`:
    radius, m; None of a flat face across its motion."""

    offset: float
    roller: float | None


class Rocker(NamedTuple):
    """Swings about a pivot `apart` from the cam's centre, m, `alike`: rising in the sense of the cam; the roller's
    centre on an `arm`, m; `roller` None: a flat face `arm` beyond the pivot as seen from the cam."""

    arm: float
    apart: float
    alike: bool
    roller: float | None

    @property
    def side(self) -> int:
        return 1 if self.alike else -1

    @property
    def pivot(self) -> complex:
        """From the cam's centre; the cam turns counter-clockwise."""
        return complex(-self.side * self.apart)


class Turned(NamedTuple):
    """A place and its derivatives by the cam's angle."""

    z: Array
    d: Array
    dd: Array


def _turned(z: complex, turn: Array) -> Turned:
    at = z * turn
    return Turned(at, 1j * at, -at)


@dataclass(frozen=True, eq=False)
class ArcLaw:
    """The law by which a cam of arcs lifts its follower, from the beginning of the rise on; m or rad. Raises Impossible
    ("reach") where the follower does not come round."""

    outline: Outline
    follower: Slider | Rocker

    def __post_init__(self) -> None:
        found = self.edges
        if self.outline.straight and self.follower.roller is None:
            raise Impossible("face")
        if not np.all(np.isfinite(found)) or np.any(np.diff([*found, FULL_TURN]) <= EDGE):
            raise Impossible("reach")

    @cached_property
    def _joints(self) -> Array:
        """The angle of the cam's axis of symmetry at which the follower touches each joint, rad, from the beginning of
        the rise to that of the dwell."""
        one = self.outline
        ends = [
            (one.base * np.exp(1j * one.half_angle), one.half_angle),
            (one.distance + one.nose * np.exp(1j * one.joint), one.joint),
        ]
        ends += [(point.conjugate(), -normal) for point, normal in reversed(ends)]
        return np.array([self._when(complex(point), normal) for point, normal in ends])

    @cached_property
    def edges(self) -> Array:
        """Where rising flank, nose, falling flank and base circle begin to lift, rad of the cam's angle."""
        return np.concatenate([[0.0], np.mod(self._joints[1:] - self._joints[0], FULL_TURN)])

    @property
    def breaks(self) -> tuple[float, ...]:
        """Angles at which the acceleration jumps, rad."""
        return tuple(float(x) for x in self.edges)

    @cached_property
    def apex(self) -> float:
        """The angle of the greatest displacement, rad: of the nose, where the velocity passes zero."""
        low, high = float(self.edges[1]), float(self.edges[2])
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if self.within(1, middle)[1] > 0 else (low, middle)
        return (low + high) / 2

    @cached_property
    def lift(self) -> float:
        return float(self.within(1, self.apex)[0])

    def within(self, piece: int, theta: Array) -> Three:
        """S, dS/dθ, d²S/dθ² as the rising flank, the nose or the falling flank, 0, 1, 2, has them, its ends too."""
        return self._displaced(self._piece(piece, np.exp(1j * (np.asarray(theta) + self._joints[0]))))

    def of(self, theta: Array) -> Three:
        """S, dS/dθ, d²S/dθ²."""
        theta = np.mod(np.asarray(theta, dtype=float) + EDGE, FULL_TURN) - EDGE
        number = np.clip(np.searchsorted(self.edges - EDGE, theta, side="right") - 1, 0, 3)
        found = tuple(np.zeros(theta.shape) for _ in range(3))
        for piece in range(3):
            here = number == piece
            if np.any(here):
                for whole, part in zip(found, self.within(piece, theta[here]), strict=True):
                    whole[here] = part
        return found  # type: ignore[return-value]

    def _displaced(self, q: Turned) -> Three:
        """From the lowest place, above zero where lifted."""
        if isinstance(self.follower, Slider):
            return q.z - self._low, q.d, q.dd
        side = self.follower.side
        return side * (np.mod(q.z - self._low + pi, FULL_TURN) - pi), side * q.d, side * q.dd

    def _piece(self, piece: int, turn: Array) -> Turned:
        """The follower's coordinate on the rising flank, the nose, the falling flank, the cam's axis turned."""
        one = self.outline
        if piece == 1:
            return self._on_arc(_turned(complex(one.distance), turn), one.nose)
        side = 1 - piece
        if one.straight:
            return self._on_line(_turned(rect(1.0, side * one.half_angle), turn), one.base)
        return self._on_arc(_turned(one.centre(side), turn), one.flank)

    # ------------------------------------------------------------ the follower's coordinate

    @cached_property
    def _low(self) -> float:
        """On the base circle."""
        one = self.follower
        if isinstance(one, Slider):
            return self.outline.base if one.roller is None else self._height(self.outline.base + one.roller)
        if one.roller is None:
            return self._normal(self.outline.base)
        return self._angle(self.outline.base + one.roller)

    def _when(self, point: complex, normal: float) -> float:
        """The angle of the cam's axis at which a point of the profile with its normal touches."""
        one = self.follower
        if one.roller is None:
            ahead = pi / 2 if isinstance(one, Slider) else self._normal(float(dot(point, rect(1.0, normal))))
            return ahead - normal
        b = point + rect(one.roller, normal)
        if isinstance(one, Slider):
            place = complex(one.offset, self._height(abs(b)))
        else:
            place = one.pivot + rect(one.arm, self._angle(abs(b)))
        return float(np.angle(place / b))

    def _height(self, away: float) -> float:
        """Of a slider's roller so far from the cam's centre."""
        square = away**2 - self.follower.offset**2 if isinstance(self.follower, Slider) else -1.0
        return sqrt(square) if square > 0 else np.nan

    def _angle(self, away: float) -> float:
        """Of a rocker's arm whose roller is so far from the cam's centre, from the x axis."""
        assert isinstance(self.follower, Rocker)
        arm, apart, _, _ = self.follower
        cosine = (apart**2 + arm**2 - away**2) / (2 * apart * arm)
        side = self.follower.side
        towards = 0.0 if side > 0 else pi
        return towards + side * acos(cosine) if abs(cosine) < 1 else np.nan

    def _normal(self, away: float) -> float:
        """Of a rocker's face so far from the cam's centre, outward, from the x axis."""
        assert isinstance(self.follower, Rocker)
        cosine = (away - self.follower.arm) / self.follower.apart
        side = self.follower.side
        return (pi if side > 0 else 0.0) - side * acos(cosine) if abs(cosine) < 1 else np.nan

    def _on_arc(self, c: Turned, radius: float) -> Turned:
        """Over an arc about c."""
        one = self.follower
        if isinstance(one, Slider):
            if one.roller is None:
                return Turned(c.z.imag + radius, c.d.imag, c.dd.imag)
            return _slid(Turned(c.z.real - one.offset, c.d.real, c.dd.real), c, radius + one.roller)
        w = Turned(c.z - one.pivot, c.d, c.dd)
        if one.roller is None:
            return _leaned(w, one.arm - radius, one.side)
        return _swung(w, one.arm, radius + one.roller, one.side)

    def _on_line(self, n: Turned, away: float) -> Turned:
        """Over a straight flank with the normal n, so far from the cam's centre."""
        one = self.follower
        assert one.roller is not None
        far = away + one.roller
        if isinstance(one, Slider):
            e = one.offset
            q = (far - e * n.z.real) / n.z.imag
            d = (-e * n.d.real - q * n.d.imag) / n.z.imag
            return Turned(q, d, (-e * n.dd.real - 2 * d * n.d.imag - q * n.dd.imag) / n.z.imag)
        g, rate, bend = (
            (constant - dot(way, one.pivot)) / one.arm
            for constant, way in ((far, n.z), (0.0, n.d), (0.0, n.dd))
        )
        delta = -one.side * np.arccos(g)
        d = -rate / np.sin(delta)
        return Turned(np.angle(n.z) + delta, d + 1, -(bend + g * d**2) / np.sin(delta))


def _slid(x: Turned, c: Turned, rod: float) -> Turned:
    """A slider a `rod` above c, which is x to the side of its line."""
    root = np.sqrt(rod**2 - x.z**2)
    d = x.z * x.d / root
    return Turned(c.z.imag + root, c.d.imag - d, c.dd.imag - (x.d**2 + x.z * x.dd + d**2) / root)


def _swung(w: Turned, arm: float, rod: float, side: int) -> Turned:
    """The angle of an arm whose end is a `rod` from a point w from its pivot."""
    away = np.abs(w.z)
    q = np.angle(w.z) + side * np.arccos((away**2 + arm**2 - rod**2) / (2 * away * arm))
    b = arm * np.exp(1j * q)
    along = b - w.z  # |b − w|² = rod²: (b' − w')·(b − w) = 0, and that once more
    ahead = dot(1j * b, along)
    d = dot(w.d, along) / ahead
    gone = 1j * b * d - w.d
    dd = -(dot(gone, gone) + dot(-b * d**2 - w.dd, along)) / ahead
    return Turned(q, d, dd)


def _leaned(w: Turned, short: float, side: int) -> Turned:
    """The angle of the normal of a face about its pivot, a point w from it being `short` of it along the normal."""
    nu = np.angle(w.z) + side * np.arccos(short / np.abs(w.z))
    n = np.exp(1j * nu)
    ahead = dot(1j * n, w.z)
    d = -dot(n, w.d) / ahead
    dd = (d**2 * dot(n, w.z) - dot(n, w.dd) - 2 * d * dot(1j * n, w.d)) / ahead
    return Turned(nu, d, dd)
