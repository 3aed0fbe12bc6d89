"""Geometry of a pair of involute wheels, external or internal, straight or helical; everything broadcasts.

Helical teeth are computed in the transverse section. Inside, an internal wheel (ring) has a negative number of
teeth and a negative shift, as in ISO 21771, so that one formula serves both kinds; what comes out is positive.
Shift coefficients follow GOST 16532 and 19274: a positive shift of a ring moves its profile outwards.
Source: Artobolevsky, Theory of mechanisms, ch. 22; Bolotovsky, Involute gears: a reference book.

Every pair of dimensions is a tuple (wheel 1, wheel 2); wheel 1 drives. Lengths in m, angles in rad.
Where no such pair exists (teeth jammed, tips inside the base circle) the numbers are nan.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.involute import inv, inverse

Array = Any
Both = tuple[Array, Array]


@dataclass(frozen=True)
class Rack:
    """The basic rack in the normal section: profile angle, height ha*, clearance c* (in modules)."""

    alpha: float = np.pi / 9
    ha: float = 1.0
    c: float = 0.25

    def transverse(self, beta: float) -> Rack:
        """The same rack in the transverse section, in transverse modules."""
        turn = np.cos(beta)
        return Rack(np.arctan(np.tan(self.alpha) / turn), self.ha * turn, self.c * turn)

    @property
    def fillet(self) -> float:
        """Radius of the rack's tip, modules: the arc tangent to the flank and the tip line, 0.38 for 20°, c* = 0.25."""
        return self.c / (1 - np.sin(self.alpha))


class Sliding(NamedTuple):
    """Specific sliding of both wheels along a path; `rho`: radius of curvature of wheel 1 there, m."""

    rho: Array
    first: Array
    second: Array


@dataclass(frozen=True, eq=False)
class Pair:
    """Two wheels of z1 and z2 teeth, shifted by x1 and x2, at the centre distance a_w.

    `m`: normal module; `beta`: helix angle on the pitch cylinder; `internal`: the wheel of more teeth is a ring.
    z1, z2, x1, x2, a_w broadcast together. A distance wider than `meshed` gives leaves backlash.
    """

    z1: Array
    z2: Array
    m: float
    rack: Rack
    beta: float
    x1: Array
    x2: Array
    a_w: Array
    internal: bool = False
    shortened: bool = True  # tips cut down where the clearance would be less than c* m

    # ------------------------------------------------------------ signed, transverse

    @cached_property
    def t(self) -> Rack:
        """The rack in the transverse section."""
        return self.rack.transverse(self.beta)

    @cached_property
    def m_t(self) -> float:
        return self.m / np.cos(self.beta)

    @cached_property
    def signs(self) -> Both:
        """−1 for a ring."""
        return _signs(self.z1, self.z2, self.internal)

    @cached_property
    def _z(self) -> Both:
        return self.signs[0] * self.z1, self.signs[1] * self.z2

    @cached_property
    def _x(self) -> Both:
        """Signed shifts in transverse modules."""
        turn = np.cos(self.beta)
        return self.signs[0] * self.x1 * turn, self.signs[1] * self.x2 * turn

    @cached_property
    def side(self) -> Array:
        """Sign of the centre distance: −1 for an internal pair."""
        return np.sign(self._z[0] + self._z[1])

    def _both(self, of: Callable[[int], Array]) -> Both:
        return of(0), of(1)

    def _plain(self, signed: Both) -> Both:
        return self.signs[0] * signed[0], self.signs[1] * signed[1]

    # ------------------------------------------------------------ the pair

    @cached_property
    def ratio(self) -> Array:
        """ω1/ω2: negative for an external pair."""
        return -self._z[1] / self._z[0]

    @cached_property
    def a(self) -> Array:
        """Reference centre distance, m: that of unshifted wheels."""
        return self.m_t * np.abs(self._z[0] + self._z[1]) / 2

    @cached_property
    def alpha_w(self) -> Array:
        """Operating pressure angle; nan where the base circles do not leave room for it."""
        return _arccos(self.a * np.cos(self.t.alpha) / self.a_w)

    @cached_property
    def x_sum(self) -> Array:
        """x1 + x2 of an external pair; the ring's shift less the pinion's of an internal one."""
        return self.side * (self.signs[0] * self.x1 + self.signs[1] * self.x2)

    @cached_property
    def y(self) -> Array:
        """Coefficient of the shift of the centres, normal modules."""
        return (self.a_w - self.a) / self.m

    @cached_property
    def shortening(self) -> Array:
        """Δy, normal modules: what the tips lose to keep the clearance c* m; 0 where nothing is lost."""
        lost = self.side * (self.x_sum - self.y)
        return np.maximum(lost, 0.0) if self.shortened else np.zeros_like(lost)

    @cached_property
    def p(self) -> float:
        """Transverse pitch."""
        return np.pi * self.m_t

    @cached_property
    def p_b(self) -> float:
        """Base pitch (transverse)."""
        return self.p * np.cos(self.t.alpha)

    @cached_property
    def p_w(self) -> Array:
        """Pitch on the working circles."""
        return self.p_b / np.cos(self.alpha_w)

    @cached_property
    def backlash(self) -> Array:
        """Circumferential backlash on the working circles; negative: the teeth would overlap."""
        return self.p_w - self.s_w[0] - self.s_w[1]

    @cached_property
    def normal_backlash(self) -> Array:
        """Backlash along the line of action, in the normal section."""
        beta_b = np.arcsin(np.sin(self.beta) * np.cos(self.rack.alpha))
        return self.backlash * np.cos(self.alpha_w) * np.cos(beta_b)

    # ------------------------------------------------------------ circles, diameters

    @cached_property
    def _d(self) -> Both:
        return self._both(lambda i: self.m_t * self._z[i])

    @cached_property
    def _d_f(self) -> Both:
        return self._both(lambda i: self._d[i] - 2 * self.m_t * (self.t.ha + self.t.c - self._x[i]))

    @cached_property
    def _d_a(self) -> Both:
        lost = self.shortening * self.m
        return self._both(lambda i: self._d[i] + 2 * self.m_t * (self.t.ha + self._x[i]) - 2 * lost)

    @cached_property
    def d(self) -> Both:
        """Pitch circles."""
        return self._plain(self._d)

    @cached_property
    def d_b(self) -> Both:
        """Base circles."""
        return self._both(lambda i: self.d[i] * np.cos(self.t.alpha))

    @cached_property
    def d_w(self) -> Both:
        """Working circles."""
        return self._both(lambda i: self.d_b[i] / np.cos(self.alpha_w))

    @cached_property
    def d_f(self) -> Both:
        """Root circles."""
        return self._plain(self._d_f)

    @cached_property
    def d_a(self) -> Both:
        """Tip circles. Equalised, d_a1 = 2 a_w − d_f2 − 2 c* m, where the tips are cut down; else of full height."""
        return self._plain(self._d_a)

    @cached_property
    def height(self) -> Both:
        """Height of the teeth."""
        return self._both(lambda i: (self._d_a[i] - self._d_f[i]) / 2)

    @cached_property
    def clearance(self) -> Both:
        """Radial clearance at the root of each wheel."""
        A = self.side * self.a_w
        return self._both(lambda i: A - (self._d_f[i] + self._d_a[1 - i]) / 2)

    # ------------------------------------------------------------ thicknesses (arcs)

    def thickness(self, d: Both) -> Both:
        """Thickness of the teeth on the circles of diameters `d`, no less than the base circles."""
        return self._both(lambda i: self._thickness(i, d[i]))

    def _thickness(self, i: int, d: Array) -> Array:
        alpha = _arccos(self.d_b[i] / d)
        return d * (self.s[i] / self.d[i] + self.signs[i] * (inv(self.t.alpha) - inv(alpha)))

    @cached_property
    def s(self) -> Both:
        """Thickness on the pitch circles."""
        return self._both(lambda i: self.m_t * (np.pi / 2 + 2 * self._x[i] * np.tan(self.t.alpha)))

    @cached_property
    def s_b(self) -> Both:
        """Thickness on the base circles."""
        return self.thickness(self.d_b)

    @cached_property
    def s_w(self) -> Both:
        """Thickness on the working circles."""
        return self.thickness(self.d_w)

    @cached_property
    def alpha_a(self) -> Both:
        """Profile angle at the tips."""
        return self._both(lambda i: _arccos(self.d_b[i] / self.d_a[i]))

    @cached_property
    def s_a(self) -> Both:
        """Thickness on the tip circles, transverse; negative: pointed below the tip circle."""
        return self.thickness(self.d_a)

    @cached_property
    def s_na(self) -> Both:
        """The same across a helical tooth, in the normal section."""
        slope = np.tan(self.beta)
        return self._both(lambda i: self.s_a[i] * np.cos(np.arctan(slope * self.d_a[i] / self.d[i])))

    # ------------------------------------------------------------ line of action

    @cached_property
    def _line(self) -> Array:
        """N1N2, signed as the radii of curvature are: negative for an internal pair."""
        return self.side * self.a_w * np.sin(self.alpha_w)

    @cached_property
    def line(self) -> Array:
        """N1N2, the line of action between the base circles."""
        return np.abs(self._line)

    @cached_property
    def _rho_a(self) -> Both:
        return self._both(lambda i: self.signs[i] * self.rho_a[i])

    @cached_property
    def rho_a(self) -> Both:
        """Radii of curvature at the tips."""
        return self._both(lambda i: _sqrt(self.d_a[i] ** 2 - self.d_b[i] ** 2) / 2)

    @cached_property
    def _rho_p(self) -> Both:
        return self._both(lambda i: self._line - self._rho_a[1 - i])

    @cached_property
    def rho_p(self) -> Both:
        """Radii of curvature at the lower points of the active profiles, where the other wheel's tip touches."""
        return self._plain(self._rho_p)

    @cached_property
    def _rho_l(self) -> Both:
        sine = np.sin(self.t.alpha)
        return self._both(lambda i: self._d[i] * sine / 2 - (self.t.ha - self._x[i]) * self.m_t / sine)

    @cached_property
    def rho_l(self) -> Both:
        """Radii of curvature where the involute begins above the fillet of a rack; negative: undercut."""
        return self._plain(self._rho_l)

    @cached_property
    def rho_w(self) -> Both:
        """Radii of curvature at the pitch point."""
        return self._both(lambda i: self.d_w[i] * np.sin(self.alpha_w) / 2)

    @cached_property
    def active(self) -> Array:
        """Length of the active part of the line of action, AB."""
        return self._rho_a[0] + self._rho_a[1] - self._line

    @cached_property
    def eps(self) -> Array:
        """Transverse contact ratio."""
        return self.active / self.p_b

    def overlap(self, width: float) -> float:
        """Overlap ratio of helical teeth of the face width `width`, m."""
        return width * np.sin(abs(self.beta)) / (np.pi * self.m)

    @cached_property
    def two_pairs(self) -> Array:
        """Share of the time in which at least two pairs of teeth are in mesh, 0..1."""
        return np.clip(self.eps - 1, 0.0, 1.0)

    # ------------------------------------------------------------ specific sliding

    def sliding(self, rho: Array) -> Sliding:
        """Specific sliding where wheel 1 has the radius of curvature `rho`: (v1 − v2)/v1 and (v2 − v1)/v2."""
        first = self.signs[0] * rho
        rolling = (self._line - first) * self._z[0] / (first * self._z[1])  # v2 : v1 along the profiles
        with np.errstate(divide="ignore", invalid="ignore"):
            return Sliding(rho, 1 - rolling, 1 - 1 / rolling)

    @cached_property
    def root_sliding(self) -> Both:
        """Specific sliding at the lower points of the active profiles; the extreme of each wheel.

        −∞ where the contact passes the end of the line of action: there the sliding has no bound.
        """
        roots = self.sliding(self.rho_p[0]).first, self.sliding(self.rho_a[0]).second
        return self._both(lambda i: np.where(self.rho_p[i] > 0, roots[i], -np.inf)[()])

    @cached_property
    def tip_sliding(self) -> Both:
        """Specific sliding at the tips."""
        lower, upper = self.sliding(self.rho_p[0]), self.sliding(self.rho_a[0])
        return upper.first, lower.second

    @cached_property
    def sliding_difference(self) -> Array:
        """Positive where the root of wheel 1 slides more than that of wheel 2, smooth everywhere, m².

        λ_p1 = 1 − z1 ρ_a2/(z2 ρ_p1) and λ_p2 = 1 − z2 ρ_a1/(z1 ρ_p2), their equality with the denominators cleared.
        """
        z1, z2 = self._z
        return z1**2 * self._rho_a[1] * self._rho_p[1] - z2**2 * self._rho_a[0] * self._rho_p[0]

    # ------------------------------------------------------------ what may go wrong

    @cached_property
    def x_min(self) -> Both:
        """Least shifts without undercut by a rack, ha* − z sin²α/2; −∞ for a ring."""
        return self._both(
            lambda i: np.where(
                self.signs[i] > 0, least_shift(self.d[i] / self.m_t, self.rack, self.beta), -np.inf
            )[()]
        )

    @cached_property
    def interference(self) -> Both:
        """Radius of curvature in hand between the active profile and the end of the involute, m; negative: none.

        An undercut profile is taken to begin at the base circle, for its loss is judged by `x_min`. The root of a ring
        is taken as a rack would cut it.
        """
        floor = self._both(
            lambda i: np.where(self.signs[i] > 0, np.maximum(self._rho_l[i], 0.0), self._rho_l[i])
        )
        return self._both(lambda i: self._rho_p[i] - floor[i])

    @cached_property
    def fouling(self) -> Array:
        """Gap between the tips of an internal pair off the line of action, as an angle of the ring, rad.

        Negative: the tips overlap where their circles cross; nan for an external pair.
        """
        if not self.internal:
            return np.full(np.shape(self.a_w), np.nan)[()]
        return _fouling(self)

    def _ordered(self, both: Both) -> Both:
        """Of an internal pair: what belongs to the pinion, what to the ring."""
        first = self.signs[1] < 0
        return np.where(first, both[0], both[1]), np.where(first, both[1], both[0])


def _fouling(pair: Pair) -> Array:
    """At the crossing of the tip circles each wheel stands at an angle δ from the centre line: the ring must lead."""
    z, Z = pair._ordered((pair.z1, pair.z2))
    r, R = (d / 2 for d in pair._ordered(pair.d_a))
    tip, Tip = (inv(alpha) for alpha in pair._ordered(pair.alpha_a))
    a = pair.a_w
    delta = _arccos((R**2 - a**2 - r**2) / (2 * a * r))
    Delta = _arccos((R**2 + a**2 - r**2) / (2 * a * R))
    gap = (z * (tip + delta) - Z * (Tip + Delta) + (Z - z) * inv(pair.alpha_w)) / Z
    gap = np.where(a + r <= R, np.inf, gap)  # the tip circles do not cross
    return np.where(r - a >= R, -np.inf, gap)[()]


def meshed(
    z1: Array,
    z2: Array,
    m: float,
    rack: Rack,
    beta: float = 0.0,
    x1: Array = 0.0,
    x2: Array = 0.0,
    internal: bool = False,
    shortened: bool = True,
) -> Pair:
    """The pair at the centre distance without backlash; nan where the shifts leave no such distance."""
    s1, s2 = _signs(z1, z2, internal)
    t, teeth = rack.transverse(beta), s1 * z1 + s2 * z2
    x_sum = (s1 * x1 + s2 * x2) * np.cos(beta)
    v = inv(t.alpha) + 2 * x_sum * np.tan(t.alpha) / teeth
    alpha_w = inverse(np.where(v >= 0, v, np.nan))
    a_w = m / np.cos(beta) * np.abs(teeth) / 2 * np.cos(t.alpha) / np.cos(alpha_w)
    return Pair(z1, z2, m, rack, beta, x1, x2, a_w, internal, shortened)


def shift_sum(
    z1: Array, z2: Array, m: float, rack: Rack, beta: float, a_w: Array, internal: bool = False
) -> Array:
    """x1 + x2 (the ring's less the pinion's of an internal pair) that fills the distance without backlash."""
    pair = Pair(z1, z2, m, rack, beta, 0.0, 0.0, a_w, internal)
    teeth = pair.a * 2 / pair.m_t
    return teeth * (inv(pair.alpha_w) - inv(pair.t.alpha)) / (2 * np.tan(pair.t.alpha) * np.cos(beta))


def least_shift(z: Array, rack: Rack, beta: float = 0.0) -> Array:
    """Least shift coefficient of an external wheel cut by a rack without undercut."""
    return rack.ha - z * np.sin(rack.transverse(beta).alpha) ** 2 / (2 * np.cos(beta))


def _signs(z1: Array, z2: Array, internal: bool) -> Both:
    if not internal:
        return 1, 1
    ring = np.greater_equal(z2, z1)  # whether wheel 2 is the ring
    return np.where(ring, 1, -1)[()], np.where(ring, -1, 1)[()]


def _arccos(x: Array) -> Array:
    with np.errstate(invalid="ignore"):
        return np.arccos(x)


def _sqrt(x: Array) -> Array:
    with np.errstate(invalid="ignore"):
        return np.sqrt(x)
