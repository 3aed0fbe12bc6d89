"""Two involute wheels at a centre distance: circles, diameters, thicknesses of the teeth; everything broadcasts.

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
from typing import Any

import numpy as np

from tmm_report.mechanics.involute import inv

Array = Any
Both = tuple[Array, Array]


@dataclass(frozen=True)
class Rack:
    """The basic rack in the normal section: profile angle, rad, height ha*, clearance c* (in modules)."""

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


@dataclass(frozen=True, eq=False)
class Wheels:
    """Two wheels of z1 and z2 teeth, shifted by x1 and x2, at the centre distance a_w: their circles and thicknesses.

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
        return signs_of(self.z1, self.z2, self.internal)

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
        return arccos(self.a * np.cos(self.t.alpha) / self.a_w)

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
        alpha = arccos(self.d_b[i] / d)
        return d * (self.s[i] / self.d[i] + self.signs[i] * (self._inv_alpha - inv(alpha)))

    @cached_property
    def _inv_alpha(self) -> float:
        return inv(self.t.alpha)

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
        return self._both(lambda i: arccos(self.d_b[i] / self.d_a[i]))

    @cached_property
    def s_a(self) -> Both:
        """Thickness on the tip circles, transverse; negative: pointed below the tip circle."""
        return self.thickness(self.d_a)

    @cached_property
    def s_na(self) -> Both:
        """The same across a helical tooth, in the normal section."""
        slope = np.tan(self.beta)
        return self._both(lambda i: self.s_a[i] * np.cos(np.arctan(slope * self.d_a[i] / self.d[i])))


def least_shift(z: Array, rack: Rack, beta: float = 0.0) -> Array:
    """Least shift coefficient of an external wheel cut by a rack without undercut."""
    return rack.ha - z * np.sin(rack.transverse(beta).alpha) ** 2 / (2 * np.cos(beta))


def involute_start(d: Array, m: Array, x: Array, rack: Rack) -> Array:
    """ρ_l = r sin α − (ha* − x) m/sin α, m: radius of curvature where the rack's fillet ends; negative: undercut."""
    return d / 2 * np.sin(rack.alpha) - (rack.ha - x) * m / np.sin(rack.alpha)


def clear_ring_tip(base: Array, line: Array, start: Array) -> Array:
    """Radius of a ring's tip circle that just clears the fillets of its pinion, m (Litvin, Gear geometry, ch. 11).

    `base`: radius of the ring's base circle; `line`: a_w sin α_w; `start`: ρ_l of the pinion, at least 0 is taken.
    """
    return np.hypot(base, line + np.maximum(start, 0.0))


def least_teeth(rack: Rack) -> int:
    """Least teeth that the rack does not undercut, 2 ha*/sin²α, rounded as the course does: 17 for 17.097."""
    return round(2 * rack.ha / float(np.sin(rack.alpha)) ** 2)


RING_RULE = {1.0: 85, 0.8: 58}  # least teeth of a ring without shift by the course's rule, by ha*; at 20°


def ring_rule(rack: Rack) -> int | None:
    """Least teeth of a ring without shift by the course's rule; None for a rack that it does not know."""
    return RING_RULE.get(round(rack.ha, 9)) if abs(rack.alpha - np.pi / 9) < 1e-9 else None


def least_ring(z: Array, rack: Rack) -> Array:
    """Least teeth of a ring without shift whose tips, of full height, end no lower than the involute of a wheel of `z`
    teeth can begin: (z² sin²α − 4 ha*²)/(2 z sin²α − 4 ha*); ∞ where none do, up to 2 ha*/sin²α teeth.

    It is where the radius of curvature at the ring's tip is equal to a_w sin α: the tip lies in the limit point of the
    line of action.
    """
    s, z = np.sin(rack.alpha) ** 2, np.asarray(z, dtype=float)
    below = 2 * z * s - 4 * rack.ha
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(below > 0, (z**2 * s - 4 * rack.ha**2) / below, np.inf)[()]


def signs_of(z1: Array, z2: Array, internal: bool) -> Both:
    """−1 for the wheel that is a ring, 1 for the others."""
    if not internal:
        return 1, 1
    ring = np.greater_equal(z2, z1)  # whether wheel 2 is the ring
    return np.where(ring, 1, -1)[()], np.where(ring, -1, 1)[()]


def arccos(x: Array) -> Array:
    """nan outside −1…1."""
    with np.errstate(invalid="ignore"):
        return np.arccos(x)


def root(x: Array) -> Array:
    """Square root; nan of what is negative."""
    with np.errstate(invalid="ignore"):
        return np.sqrt(x)
