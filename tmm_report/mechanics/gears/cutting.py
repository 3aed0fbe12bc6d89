"""How a wheel is cut, by a rack or by a pinion cutter, and where its involute really begins.

Everything is in the transverse section and broadcasts: lengths in m, shifts in transverse modules; an internal wheel
(ring) has a negative number of teeth and a negative shift, as in `wheels`, and its radii come out negative too.
The rack is rounded at its tip (`rack.fillet`), the teeth of a pinion cutter are sharp there and higher than those of
the basic rack by the clearance. Source: Litvin, Gear geometry and applied theory, ch. 6 and 11; GOST 19274.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import interpolated
from tmm_report.mechanics.gears.involute import inv, inverse
from tmm_report.mechanics.gears.rack import Rack, arccos, involute_start
from tmm_report.records import dataclass

Array = Any
Curve = Callable[[Array], Array]

FEW = 8  # shifts of one wheel for which a table is not worth its making
NODES = 33
LONGEST, SHORTEST = 2.0, 0.1  # of shifts: how far below the least one a table goes
SMOOTH = 1e-10  # of a tooth of the wheel: what the last terms of a table may be, the rounding of its numbers
NEAR = 0.02  # modules: an undercut of so small a negative ρ_l ends close to the base circle


@dataclass(frozen=True)
class Cutter:
    """A pinion cutter of `z` teeth, itself made with the shift `x` (new: above zero, worn: below), normal modules."""

    z: int
    x: float = 0.0


@dataclass(frozen=True, eq=False)
class ByRack:
    """A wheel of `z` teeth and module `m`, m, cut by the rack with the shift `x`."""

    z: Array
    m: float
    x: Array
    rack: Rack

    @property
    def root(self) -> Array:
        """Diameter of the root circle, m."""
        return self.m * self.z - 2 * self.m * (self.rack.ha + self.rack.c - self.x)

    @property
    def start(self) -> Array:
        """ρ_l, radius of curvature where the fillet ends, m; negative of an external wheel: undercut."""
        return involute_start(self.m * self.z, self.m, self.x, self.rack)

    @property
    def least_shift(self) -> Array:
        """Least shift without undercut."""
        return self.rack.ha - self.z * np.sin(self.rack.alpha) ** 2 / 2

    def undercut_end(self) -> Array:
        """Radius of curvature where the fillet of an undercut external wheel crosses its involute, m, (N,).

        The fillet is drawn by the rounded tip of the rack, over the slope θ of its normal: 0 at the root circle,
        π/2 − α where the rounding ends. It passes the base circle within the tooth and leaves it above.
        """
        r, alpha = self.z / 2 + 0 * self.x, self.rack.alpha
        rho = fillet_radius(self.rack)
        up = self.rack.ha + self.rack.c - rho
        wide = max(math.pi / 4 - up * math.tan(alpha) - rho / math.cos(alpha), 0.0)
        deep = up - self.x

        def fillet(theta: Array) -> Array:
            normal, roll = deep / np.cos(theta) + rho, (deep * np.tan(theta) - wide) / r
            space = (r - normal * np.exp(-1j * theta)) * np.exp(-1j * roll)
            return space.conj() * np.exp(1j * math.pi / self.z)

        half = base_half_angle(self.z, self.x, alpha)
        return self.m * _crossing(fillet, r * math.cos(alpha), half, math.pi / 2 - alpha)


@dataclass(frozen=True, eq=False)
class ByCutter:
    """The same cut by a pinion cutter of `tool.z` teeth; `shift`: its own, transverse modules."""

    z: Array
    m: float
    x: Array
    rack: Rack
    tool: Cutter
    shift: float

    @cached_property
    def alpha(self) -> Array:
        """Pressure angle of the cutting; nan where the shifts leave none."""
        total = self.z + self.tool.z
        v = inv(self.rack.alpha) + 2 * (self.x + self.shift) * np.tan(self.rack.alpha) / total
        return inverse(np.where(v >= 0, v, np.nan))

    @cached_property
    def distance(self) -> Array:
        """Distance of the axes in the last pass, m; that of a ring is negative."""
        return self.m * (self.z + self.tool.z) / 2 * np.cos(self.rack.alpha) / np.cos(self.alpha)

    @property
    def base(self) -> float:
        """Radius of the cutter's base circle, m."""
        return self.m * self.tool.z / 2 * math.cos(self.rack.alpha)

    @property
    def tip(self) -> float:
        """Radius of its tip circle, m."""
        return self.m * (self.tool.z / 2 + self.rack.ha + self.rack.c + self.shift)

    @property
    def tip_angle(self) -> float:
        """Profile angle at its tips, rad."""
        return math.acos(self.base / self.tip)

    @property
    def curvature(self) -> float:
        """Radius of curvature of its profile at the tip, m."""
        return math.sqrt(self.tip**2 - self.base**2)

    @property
    def line(self) -> Array:
        """Between the base circles along the line of action in cutting, m; that of a ring is negative."""
        return self.distance * np.sin(self.alpha)

    @property
    def root(self) -> Array:
        """Diameter of the root circle, m."""
        return 2 * self.distance - 2 * self.tip

    @property
    def start(self) -> Array:
        """ρ_l, radius of curvature of the wheel where the cutter's tip leaves its involute, m."""
        return self.line - self.curvature

    @property
    def least_shift(self) -> Array:
        """Least shift of an external wheel without undercut: the tip passes through the end of the line of action."""
        total = self.z + self.tool.z
        alpha = np.arctan(self.curvature / (self.m * total / 2 * np.cos(self.rack.alpha)))
        return (inv(alpha) - inv(self.rack.alpha)) * total / (2 * np.tan(self.rack.alpha)) - self.shift

    def undercut_end(self) -> Array:
        """As `ByRack.undercut_end`; the fillet is drawn by the corner of the cutter's tooth, over its turn from the
        line of centres. The corner leaves the line of action at the turn α_a0 − α_w0."""
        tool, r, a = self.tool.z, self.tip, self.distance + 0 * self.x
        corner = float(tip_half_angle(tool, self.shift, self.rack))

        def fillet(turn: Array) -> Array:
            space = (a - r * np.exp(-1j * turn)) * np.exp(1j * (corner - turn) * tool / self.z)
            return space.conj() * np.exp(1j * math.pi / self.z)

        base = self.m * self.z / 2 * np.cos(self.rack.alpha) + 0 * self.x
        half = base_half_angle(self.z, self.x, self.rack.alpha)
        return _crossing(fillet, base, half, self.tip_angle - self.alpha)


Cut = ByRack | ByCutter
MadeBy = tuple[Cutter, float] | None  # a pinion cutter and its shift; None: a rack


def real_start(cut: Cut) -> Array:
    """Radius of curvature where the involute really begins, m, signed: above the fillet or where an undercut ends.

    ∞ where the undercut leaves no involute at all.
    """
    z, x, start = np.broadcast_arrays(cut.z, np.asarray(cut.x, dtype=float), cut.start)
    under = (start < 0) & (z > 0)
    if not under.any():
        return start[()]
    found = start.copy()
    if np.size(cut.z) == 1 and np.count_nonzero(under) > FEW:
        found[under] = _tabled(cut, float(z.flat[0]), x[under], start[under])
        return found[()]
    places, back = np.unique(np.stack([z[under], x[under]]), axis=1, return_inverse=True)
    if places.shape[1] == 1:
        found[under] = _undercut_of_one(*places[:, 0].tolist(), cut.m, cut.rack, _made_by(cut))
    else:
        found[under] = _undercut(_with(cut, places[0], places[1]))[back.ravel()]
    return found[()]


def _tabled(cut: Cut, z: float, x: Array, start: Array) -> Array:
    """The same for many shifts of one wheel: by a table as far as it goes."""
    limit, span, series = _table(z, cut.rack, _made_by(cut))
    beyond = x < limit - span
    place = 1 + 2 * (x - limit) / max(span, SHORTEST)
    found = -start * np.polynomial.chebyshev.chebval(np.maximum(place, -1.0), series)
    if beyond.any():
        places, back = np.unique(x[beyond], return_inverse=True)
        found[beyond] = _undercut(_with(cut, np.full(len(places), z), places))[back.ravel()]
    return found


def _made_by(cut: Cut) -> MadeBy:
    return None if isinstance(cut, ByRack) else (cut.tool, cut.shift)


@lru_cache(maxsize=64)
def _undercut_of_one(z: float, x: float, m: float, rack: Rack, made_by: MadeBy) -> float:
    """`_undercut` of one wheel: asked for by its mistakes, its conditions and its blocking contour in turn."""
    own = np.array([z]), m, np.array([x]), rack
    return float(_undercut(ByRack(*own) if made_by is None else ByCutter(*own, *made_by))[0])


@lru_cache(maxsize=64)
def _table(z: float, rack: Rack, made_by: MadeBy) -> tuple[float, float, Array]:
    """The undercut's end over −ρ_l, a smooth function of the shift: its least shift without undercut, how far below it
    the table goes, and its Chebyshev series there."""
    cut: Cut = ByRack(z, 1.0, 0.0, rack) if made_by is None else ByCutter(z, 1.0, 0.0, rack, *made_by)
    limit, span = float(cut.least_shift), LONGEST
    nodes = np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)
    while span >= SHORTEST:
        deep = _with(cut, np.full(NODES, z), limit + span * (nodes - 1) / 2)
        with np.errstate(invalid="ignore", divide="ignore"):
            shares = _undercut(deep) / -deep.start
        series = np.polynomial.chebyshev.chebfit(nodes, np.nan_to_num(shares, posinf=0.0), NODES - 1)
        if np.isfinite(shares).all() and np.abs(series[-4:]).max() < SMOOTH * z:
            return limit, span, series
        span /= 2
    return limit, 0.0, series  # of no use


def _undercut(cut: Cut) -> Array:
    """Radius of curvature where the fillet of an undercut wheel crosses its involute, m, (N,).

    Close to the base circle the curves part with the third power of it, and the crossing would be known to few digits;
    there it is −ρ_l/2 times a smooth function of ρ_l, which is found from three deeper undercuts.
    """
    start, near = cut.start, np.nonzero(cut.start > -NEAR * cut.m)[0]
    z, limit = cut.z[near], (cut.least_shift + 0 * cut.x)[near]
    deep = [limit - k * NEAR * math.sin(cut.rack.alpha) for k in (1, 2, 3)]
    # all curves that are to be followed, at once
    every = _with(cut, np.concatenate([cut.z, z, z, z]), np.concatenate([cut.x, *deep]))
    with np.errstate(invalid="ignore", divide="ignore"):
        ends = every.undercut_end()
    found = ends[: len(start)]
    deeper = every.start[len(start) :].reshape(3, -1)
    nodes = np.array([0 * z, *deeper])
    shares = np.array([0.5 + 0 * z, *(-ends[len(start) :].reshape(3, -1) / deeper)])
    found[near] = -start[near] * _interpolated(nodes, shares, start[near])
    return found


def _interpolated(nodes: Array, values: Array, x: Array) -> Array:
    """The cubic through four points, (4, N), at x (N,); Lagrange."""
    total = np.zeros_like(x)
    for k in range(len(nodes)):
        others = np.delete(nodes, k, axis=0)
        total = total + values[k] * np.prod((x - others) / (nodes[k] - others), axis=0)
    return total


def _with(cut: Cut, z: Array, x: Array) -> Cut:
    if isinstance(cut, ByRack):
        return ByRack(z, cut.m, x, cut.rack)
    return ByCutter(z, cut.m, x, cut.rack, cut.tool, cut.shift)


def _crossing(fillet: Curve, base: Array, half: Array, last: Array) -> Array:
    """Radius of curvature where a fillet crosses the involute above the base circle, (N,); ∞ where it never does.

    `half`: half the angle of a tooth on the base circle; `last`: where the tool leaves the line of action.
    """
    last = np.broadcast_to(np.asarray(last, dtype=float), np.shape(base)).copy()

    def above(t: Array) -> Array:
        return np.abs(fillet(t)) - base

    def apart(t: Array) -> Array:
        point = fillet(t)
        rise = np.sqrt(np.maximum(np.abs(point / base) ** 2 - 1, 0.0))
        return np.angle(point) - (half - rise + np.arctan(rise))

    zero = np.zeros_like(last)
    low = interpolated(above, zero, last, above(zero), np.zeros_like(last))[0]
    low = np.where(above(zero) >= 0, zero, low)
    first, end = apart(low), apart(last)
    crossed = (first < 0) & (end > 0)
    t = interpolated(apart, low, np.where(crossed, last, low + 1e-9), first, zero)[0]
    found = np.sqrt(np.maximum(np.abs(fillet(np.where(crossed, t, low))) ** 2 - base**2, 0.0))
    return np.where((first < 0) & ~(end > 0), np.inf, found)


def fillet_radius(rack: Rack) -> float:
    """Rounding of the rack's tip in modules, 0.38 at 20° and c* = 0.25; less where its tooth is too narrow for it."""
    room = (math.pi / 4 - (rack.ha + rack.c) * math.tan(rack.alpha)) * math.cos(rack.alpha)
    return min(float(rack.fillet), room / (1 - math.sin(rack.alpha)))


def base_half_angle(z: Array, x: Array, alpha: float) -> Array:
    """Half the angle of a tooth (of a ring: of a space) on the base circle, rad: s/d + inv α."""
    return (np.pi / 2 + 2 * x * np.tan(alpha)) / z + inv(alpha)


def tip_half_angle(z: Array, x: Array, rack: Rack) -> Array:
    """The same of a pinion cutter at its tips; below 0: its teeth come to a point before, nan: it has no involutes."""
    return base_half_angle(z, x, rack.alpha) - inv(
        arccos(z / 2 * np.cos(rack.alpha) / np.maximum(z / 2 + rack.ha + rack.c + x, 1e-9))
    )
