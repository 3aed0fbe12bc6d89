"""Outlines of toothed wheels in their transverse section, and proofs that meshing teeth do not overlap.

    pinion = external(14, 0.006, 0.1765, rack, tip=0.0486)      # rack: spur.Rack (alpha rad, ha*, c*)
    wheel = external(28, 0.006, 0.5625, rack, tip=0.0929)
    wide = ring(112, 0.005, 0.0, rack)
    pinion.placed(centre, turn)                                 # (..., N) complex, m
    turn2 = mating_turn(pinion, wheel, turn1, direction)        # no backlash at the working centre distance
    overlap(outline1, outline2); clearance(outline1, outline2)  # of `polygons`, m², m; wheels as `placed` gives them
    over_pitch(pinion, wheel, distance, count)                  # both at `count` positions over a pitch
    touching_turn(pinion, wheel, distance, turn1)               # the same where there is backlash: flanks touch
    contact_ratio(pinion, wheel, distance)                      # counted from the outlines

An outline is a closed polygon, complex (N,), counter-clockwise, centre 0, the middle of tooth 0 on the +x axis; its
sides keep within twice `tolerance` of the true curve, and inside the metal, so that what overlaps in the polygons
overlaps in truth. That of a ring bounds the opening: the metal lies outside. For helical teeth give m, x and
the rack of the transverse section.

Source of the shapes: Litvin, Fuentes, Gear geometry and applied theory, ch. 6 (rack-cut fillet) and 11 (internal).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.polygons import overlaps_and_clearances
from tmm_report.mechanics.calculus.roots import root_between
from tmm_report.mechanics.gears.involute import inv, inverse
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.gears.meshing import Rack

Array = Any
Curve = Callable[[Array], Array]

FINE = 1e-4  # of the module: how far a side of the polygon may leave the true curve


@dataclass(frozen=True, eq=False)
class Wheel:
    """A toothed wheel. `outline` (N,) complex; radii in m; `base_angle`: half of the angle of a tooth (of a ring: of a
    space) on the base circle, rad; `junction`: radius where the involute gives way to the fillet."""

    z: int
    outline: Array
    base: float
    tip: float
    root: float
    junction: float
    base_angle: float
    internal: bool = False

    def placed(self, centre: Array, turn: Array) -> Array:
        """The outline moved to `centre`, m, and turned by `turn`, rad; (..., N)."""
        turned = self.outline * np.exp(1j * np.asarray(turn))[..., None]
        if np.ndim(centre):
            return centre[..., None] + turned
        turned += centre  # a large array is not copied
        return turned

    @property
    def pitch_angle(self) -> float:
        return 2 * math.pi / self.z

    def flank(self, radii: Array, tooth: int = 0, side: int = 1) -> Array:
        """Points of the involute at `radii` (N,), not under the base circle; `side` +1: the flank that looks counter-
        clockwise."""
        rise = np.sqrt(np.maximum(np.square(np.asarray(radii) / self.base) - 1, 0.0))
        upper = involute(self.base, self.base_angle, rise)
        if self.internal:  # the space beside tooth 0, half a pitch on
            upper = upper.conj() * np.exp(0.5j * self.pitch_angle)
        return (upper if side > 0 else upper.conj()) * np.exp(1j * tooth * self.pitch_angle)


def involute(base: float, base_angle: float, rise: Array, beyond: float = 0.0) -> Array:
    """Upper flank of a tooth on the +x axis at `rise` = tan of the pressure angle; m. `beyond`: offset along the
    normal, outwards."""
    return (base * (1 + 1j * rise) + 1j * beyond) * np.exp(1j * (base_angle - rise))


def fillet_radius(rack: Rack) -> float:
    """Rounding of the rack's tip in modules, 0.38 at 20° and c* = 0.25; less where its tooth is too narrow for it."""
    room = (math.pi / 4 - (rack.ha + rack.c) * math.tan(rack.alpha)) * math.cos(rack.alpha)
    return min(float(rack.fillet), room / (1 - math.sin(rack.alpha)))


# --- a wheel with external teeth, cut by the rack ---


@dataclass(frozen=True)
class Trochoid:
    """The fillet, over the slope `theta` of the normal: 0 at the root circle, π/2 − α where its side begins.

    The rounded corner of the rack has its centre `deep` under the pitch line and `wide` off the middle of its tooth;
    the common normal goes through the pitch point.
    """

    r: float
    deep: float
    wide: float
    rho: float
    half_pitch: float

    def __call__(self, theta: Array) -> Array:
        """Points of the fillet at the upper flank of the tooth on the +x axis, m."""
        normal = self.deep / np.cos(theta) + self.rho
        roll = (self.deep * np.tan(theta) - self.wide) / self.r
        space = (self.r - normal * np.exp(-1j * theta)) * np.exp(-1j * roll)
        return space.conj() * np.exp(1j * self.half_pitch)


def external(
    z: int, m: float, x: float, rack: Rack, tip: float | None = None, tolerance: float | None = None
) -> Wheel:
    """A wheel cut by the rack with rounded tip, undercut where it must be. `m`, `tip` (radius), `tolerance` in m.

    `tip` left out: the full height of the rack. A tooth that comes to a point below its tip circle ends in it.
    """
    fillet, base_angle, theta, flank = _cut(z, m, x, rack, tip)
    r, base, top = m * z / 2, flank.base, flank.top
    root = r - fillet.deep - fillet.rho
    fine, rise_top = tolerance or FINE * m, math.sqrt((top / base) ** 2 - 1)
    half = np.concatenate(
        [
            _arc(top, 0.0, base_angle - rise_top + math.atan(rise_top), fine)[:-1],
            _sampled(lambda u: involute(base, base_angle, u), rise_top, flank.rise, fine),
            # moved into the metal by `fine`, for it is hollow and its chords would leave the metal
            _sampled(replace(fillet, rho=fillet.rho + fine), theta, 0.0, fine)[1:],
            _arc(root - fine, math.pi / z - fillet.wide / r, math.pi / z, fine)[1:],
        ]
    )
    outline = _all_round(half, z)
    return Wheel(z, outline, base, top, root, flank.junction, base_angle)


class Flank(NamedTuple):
    """Radii of the involute of a wheel as cut, m: base circle, where the involute begins and ends.

    `rise`: tan of the pressure angle where it begins.
    """

    base: float
    rise: float
    top: float

    @property
    def junction(self) -> float:
        return self.base * math.hypot(1, self.rise)


def flank(z: int, m: float, x: float, rack: Rack, tip: float | None = None) -> Flank:
    """The involute of a wheel cut by the rack, without its outline. Raises ValueError where none is left."""
    return _cut(z, m, x, rack, tip)[3]


def _cut(z: int, m: float, x: float, rack: Rack, tip: float | None) -> tuple[Trochoid, float, float, Flank]:
    """The fillet, half the angle of a tooth on the base circle, the slope where the fillet ends, and the involute."""
    r, alpha = m * z / 2, rack.alpha
    base, base_angle = r * math.cos(alpha), base_half_angle(z, x, alpha)
    fillet = _trochoid(z, m, x, rack)
    theta, rise = _junction(fillet, base, base_angle, alpha)
    top = min(tip or r + m * (rack.ha + x), base / math.cos(float(inverse(base_angle))))
    if base * math.hypot(1, rise) >= top:
        raise ValueError(f"a wheel of {z} teeth with the shift {x:g} m is undercut up to its tip circle")
    return fillet, base_angle, theta, Flank(base, rise, top)


def base_half_angle(z: int, x: float, alpha: float) -> float:
    """Half the angle of a tooth (of a ring: of a space) on the base circle, rad: s/d + inv α."""
    return (math.pi / 2 + 2 * x * math.tan(alpha)) / z + float(inv(alpha))


def _trochoid(z: int, m: float, x: float, rack: Rack) -> Trochoid:
    rho = fillet_radius(rack)
    up = rack.ha + rack.c - rho  # the centre of the rounding under the middle line of the rack
    wide = math.pi / 4 - up * math.tan(rack.alpha) - rho / math.cos(rack.alpha)
    return Trochoid(m * z / 2, m * (up - x), m * max(wide, 0.0), m * rho, math.pi / z)


def _junction(fillet: Trochoid, base: float, base_angle: float, alpha: float) -> tuple[float, float]:
    """Where fillet and involute meet: slope of the fillet's normal there, and tan of the involute's pressure angle."""
    last = math.pi / 2 - alpha
    rise = (fillet.r * math.sin(alpha) - fillet.deep / math.sin(alpha) - fillet.rho) / base
    if rise >= 0:
        return last, rise

    # undercut: the fillet passes the base circle inside the tooth and cuts the involute above it
    def apart(theta: Array) -> Array:
        point = fillet(theta)
        rise = np.sqrt(np.maximum(np.abs(point / base) ** 2 - 1, 0.0))
        return np.angle(point) - (base_angle - rise + np.arctan(rise))

    low = root_between(lambda theta: np.abs(fillet(theta)) - base, 0.0, last)
    theta = root_between(apart, low, last) if apart(low) < 0 else low
    return theta, math.sqrt(max(0.0, float(np.abs(fillet(theta)) / base) ** 2 - 1))


# --- a wheel with internal teeth ---


def ring(
    z: int, m: float, x: float, rack: Rack, tip: float | None = None, root: float | None = None,
    tolerance: float | None = None,
) -> Wheel:  # fmt: skip
    """A ring wheel whose spaces are the teeth of an external wheel (z, x): involutes, and a round fillet at the root.

    `tip` and `root` (radii, m) left out: r − m(ha* − x) and r + m(ha* + c* + x). The fillet has the radius of the
    rack's rounding, or what the space has room for; under the base circle a tooth goes on radially.
    """
    r = m * z / 2
    base, base_angle = r * math.cos(rack.alpha), base_half_angle(z, x, rack.alpha)
    tip = tip or r - m * (rack.ha - x)
    root = root or r + m * (rack.ha + rack.c + x)
    fine = tolerance or FINE * m
    rack_end = r * math.sin(rack.alpha) + m * (rack.ha + x) / math.sin(rack.alpha)
    rho, rise, root = _ring_fillet(base, base_angle, root, m * fillet_radius(rack), rack_end)
    centre = base_angle - rise + math.atan(rise - rho / base)
    corner = (root - rho) * np.exp(1j * centre)
    rise_tip = math.sqrt(max(0.0, (tip / base) ** 2 - 1))
    # all of it moved into the metal by `fine`: the space is convex, and its chords would leave the metal
    half = np.concatenate(
        [
            _arc(root + fine, 0.0, centre, fine)[:-1],
            (corner + _arc(rho + fine, centre, base_angle - rise + math.pi / 2, fine))[:-1],
            _sampled(lambda u: involute(base, base_angle, u, beyond=fine), rise, rise_tip, fine),
            _arc(tip + fine, base_angle - rise_tip + math.atan(rise_tip), math.pi / z, fine)[
                int(tip >= base) :
            ],
        ]
    )
    outline = _all_round(half, z) * np.exp(1j * math.pi / z)
    return Wheel(z, outline, base, tip, root, base * math.hypot(1, rise), base_angle, internal=True)


def _ring_fillet(
    base: float, base_angle: float, root: float, wanted: float, rack_end: float
) -> tuple[float, float, float]:
    """Radius of the fillet of a ring, m, tan of the pressure angle where it begins, and the root radius.

    It leaves the involute that a rack would cut, to the radius of curvature `rack_end`, but is a quarter of `wanted` at
    least. A space too narrow for that is rounded off before it comes to the root circle.
    """

    def rise(rho: Array, root: Array) -> Array:
        return (np.sqrt((root - rho) ** 2 - base**2) + rho) / base

    def middle(rho: Array, root: Array) -> Array:  # angle of the fillet's centre from the middle of the space
        return base_angle - rise(rho, root) + np.arctan(rise(rho, root) - rho / base)

    wanted = min(wanted, 0.99 * (root - base))
    least = rho = wanted / 4
    if middle(least, root) < 0:
        root = root_between(lambda r: middle(least, r), base + least, root)
    elif rise(least, root) * base > rack_end:
        rho = wanted
        if rise(rho, root) * base < rack_end:
            rho = root_between(lambda x: rise(x, root) * base - rack_end, least, rho)
        rho = rho if middle(rho, root) >= 0 else root_between(lambda x: middle(x, root), least, rho)
    return rho, float(rise(rho, root)), root


# --- sampling ---


def _sampled(curve: Curve, start: float, end: float, fine: float) -> Array:
    """Points of the curve so close that no chord is farther than `fine` from it: |p''| h² / 8, p'' across the curve."""
    trial = curve(np.linspace(start, end, 65))
    along = trial[2:] - trial[:-2]
    bend = np.abs((np.diff(trial, 2) * along.conj()).imag / np.abs(along)).max() * 64**2
    return curve(np.linspace(start, end, 2 + int(math.sqrt(bend / (8 * fine)))))


def _arc(radius: float, start: float, end: float, fine: float) -> Array:
    count = 2 + int(abs(end - start) * math.sqrt(radius / (8 * fine)))
    return radius * np.exp(1j * np.linspace(start, end, count))


def _all_round(half: Array, z: int) -> Array:
    """The outline from its piece between the middle of a tooth on the +x axis and the middle of the next space."""
    tooth = np.concatenate([half.conj()[:0:-1], half[:-1]])
    return (tooth * np.exp(2j * math.pi * np.arange(z) / z)[:, None]).ravel()


# --- wheels in mesh ---


def mating_turn(one: Wheel, other: Wheel, turn: Array, direction: float = 0.0) -> Array:
    """Turn of `other`, rad, that puts a space of it against a tooth of `one` turned by `turn`.

    `direction`: from the centre of `one` to the pitch point, rad. `other` may be the ring, `one` not.
    """
    half = math.pi / other.z
    rolled = (np.asarray(turn) - direction) * one.z / other.z
    return direction + half + (rolled if other.internal else math.pi - rolled)


def centre_beside(other: Wheel, distance: float) -> float:
    """Where the centre of `other` is when `one` stands in 0 and the pitch point on its +x axis."""
    return -distance if other.internal else distance


def over_pitch(one: Wheel, other: Wheel, distance: float, count: int = 24) -> tuple[Array, Array]:
    """Overlap, m², and smallest clearance, m, at `count` positions over a pitch; (count,) each."""
    turns = one.pitch_angle * np.arange(count) / count
    first = one.placed(0.0, turns)
    second = other.placed(centre_beside(other, distance), mating_turn(one, other, turns))
    return overlaps_and_clearances(first, second, other.internal)


def touching_turn(one: Wheel, other: Wheel, distance: float, turn: Array) -> Array:
    """Turn of `other`, rad, at which the flank that looks counter-clockwise on tooth 0 of `one` touches it.

    The pitch point lies on the +x axis from `one`; backlash, if any, is left behind the other flanks.
    """
    alpha = pressure_angle(one, other, distance)
    half, other_half = (wheel.base_angle - float(inv(alpha)) for wheel in (one, other))
    rolled = (np.asarray(turn) + half) * one.base / other.base
    return rolled - math.pi / other.z - other_half if other.internal else math.pi - other_half - rolled


def pressure_angle(one: Wheel, other: Wheel, distance: float) -> float:
    """Operating pressure angle, rad."""
    return math.acos((other.base - one.base if other.internal else one.base + other.base) / distance)


def contact_ratio(one: Wheel, other: Wheel, distance: float, count: int = 2000) -> float:
    """Mean number of pairs of flanks in touch over a pitch, counted at `count` positions on the polygons' sides.

    A pair touches where both flanks meet the line of action in one point; `one` drives counter-clockwise.
    """
    turns = one.pitch_angle * np.arange(-4 * count, 4 * count) / count
    alpha, centre = pressure_angle(one, other, distance), centre_beside(other, distance)
    first = _met(_flank_sides(one), turns, 0.0, one.base, alpha)
    # between the base circles alone: beyond their ends flanks cross the line of action and do not touch
    end = np.inf if other.internal else distance * math.sin(alpha)
    between = (first > 0) & (first < end)
    turns, first = turns[between], first[between]
    turned = touching_turn(one, other, distance, turns)
    second = _met(_flank_sides(other), turned, centre, one.base, alpha)
    base_pitch = one.pitch_angle * one.base
    return float(np.count_nonzero(np.abs(first - second) < 1e-3 * base_pitch)) / count


def _flank_sides(wheel: Wheel) -> Array:
    """Vertices of the outline on the flank of tooth 0 that looks counter-clockwise; of a ring, on the one that such a
    flank drives, beyond the first space."""
    tooth = wheel.outline[: len(wheel.outline) // wheel.z]
    half = tooth[len(tooth) // 2 :]
    radii, slack = np.abs(half), 1e-9 * wheel.tip
    # not along the circle of the tips
    climbs = np.abs(np.diff(radii, prepend=radii[0], append=radii[-1])) > slack
    low, high = sorted((wheel.junction, wheel.tip))
    return half[(climbs[:-1] | climbs[1:]) & (radii > low - slack) & (radii < high + slack)]


def _met(flank: Array, turns: Array, centre: float, base: float, alpha: float) -> Array:
    """How far along the line of action, from N1, a flank (N,) turned about `centre` by `turns` (P,) meets it, m, (P,);
    nan where it does not."""
    # in axes turned by α the line of action is x = base
    turn, aside, middle = np.exp(1j * (turns + alpha)), centre * np.exp(1j * alpha), flank.mean()
    near = np.nonzero(np.abs((aside + turn * middle).real - base) <= np.abs(flank - middle).max())[0]
    turn = turn[near]  # of a million vertices a third, and of those only the x
    # not by matmul: threads of its library, once woken, wait busily and cost more than all the rest of a note
    x = np.multiply.outer(turn.real, flank.real)
    x -= np.multiply.outer(turn.imag, flank.imag)
    behind = x < base - aside.real
    crosses = behind[:, :-1] != behind[:, 1:]
    met, side = np.nonzero(crosses.any(axis=1))[0], np.argmax(crosses, axis=1)
    a, b = (aside + turn[met] * flank[side[met] + k] for k in (0, 1))
    place = np.full(len(turns), np.nan)
    place[near[met]] = a.imag + (base - a.real) * (b - a).imag / (b - a).real
    return place
