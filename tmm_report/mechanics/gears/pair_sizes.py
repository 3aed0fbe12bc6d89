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
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.cutting import ByCutter, ByRack, Cut, Cutter, real_start
from tmm_report.mechanics.gears.involute import inv
from tmm_report.mechanics.gears.rack import Rack, arccos, clear_ring_tip, involute_start, least_shift, root
from tmm_report.records import dataclass

__all__ = ["Both", "Cutter", "Rack", "Wheels", "arccos", "clear_ring_tip", "involute_start", "least_ring"]
__all__ += ["least_shift", "least_teeth", "ring_rule", "root", "signs_of"]

Array = Any
Both = tuple[Array, Array]


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
    trimmed: bool = False  # the ring's tips, too, where they would touch the fillets of the pinion
    cutter: Cutter | None = (
        None  # cuts the ring of an internal pair, both wheels of an external one; None: the rack
    )
    tips: Both | None = None  # diameters of the tip circles; None: they follow from the shifts

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

    # ------------------------------------------------------------ how they are cut

    @cached_property
    def cuts(self) -> tuple[Cut, Cut]:
        """How each wheel is cut, in the transverse section."""
        return self._cut(0), self._cut(1)

    def _cut(self, i: int) -> Cut:
        by_rack = ByRack(self._z[i], self.m_t, self._x[i], self.t)
        if self.cutter is None or (self.internal and np.all(self.signs[i] > 0)):
            return by_rack
        return by_cutter(by_rack, self.cutter, self.beta)

    @cached_property
    def _start(self) -> Both:
        return self._both(lambda i: real_start(self.cuts[i]))

    @cached_property
    def starts(self) -> Both:
        """Radii of curvature where the involutes really begin: above the fillets, or where an undercut ends.

        Of a ring it is where they end, at its root. ∞ where an undercut leaves none.
        """
        return self._plain(self._start)

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
    def beta_b(self) -> Array:
        """Angle of the helix on the base cylinders."""
        return np.arcsin(np.sin(self.beta) * np.cos(self.rack.alpha))

    @cached_property
    def backlash(self) -> Array:
        """Circumferential backlash on the working circles; negative: the teeth would overlap."""
        return self.p_w - self.s_w[0] - self.s_w[1]

    @cached_property
    def normal_backlash(self) -> Array:
        """Backlash along the line of action, in the normal section."""
        return self.backlash * np.cos(self.alpha_w) * np.cos(self.beta_b)

    # ------------------------------------------------------------ circles, diameters

    @cached_property
    def _d(self) -> Both:
        return self._both(lambda i: self.m_t * self._z[i])

    @cached_property
    def _d_f(self) -> Both:
        return self._both(lambda i: self.cuts[i].root)

    @cached_property
    def _full(self) -> Both:
        """Tip circles that keep the clearance, before any ring is cut down to clear fillets."""
        lost = self.shortening * self.m
        return self._both(lambda i: self._d[i] + 2 * self.m_t * (self.t.ha + self._x[i]) - 2 * lost)

    @cached_property
    def _d_a(self) -> Both:
        if self.tips is not None:
            return self._plain(self.tips)
        if not (self.internal and self.trimmed):
            return self._full
        return self._both(lambda i: self._full[i] if np.all(self.signs[i] > 0) else self._trimmed(i))

    def _trimmed(self, i: int) -> Array:
        """Tip circle of wheel i, where it is a ring one that touches no fillet of its pinion."""
        start = self._start[1 - i]
        start = np.where(np.isfinite(start), start, 0.0)
        clear = 2 * clear_ring_tip(self.d_b[i] / 2, self.a_w * np.sin(self.alpha_w), start)
        return np.where(self.signs[i] > 0, self._full[i], np.minimum(self._full[i], -clear))[()]

    @cached_property
    def trimming(self) -> Both:
        """By how much the tip circles of rings are widened to clear the fillets of their pinions, m; 0: of the rest."""
        kept = self.tips is not None
        return self._both(lambda i: 0 * self._full[i] if kept else np.abs(self._d_a[i] - self._full[i]))

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
        """Tip circles, as they are stated; else, equalised, d_a1 = 2 a_w − d_f2 − 2 c* m, where the tips are cut down;
        else of full height."""
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


def by_cutter(wheel: ByRack, cutter: Cutter, beta: float) -> ByCutter:
    """The same wheel cut by a pinion cutter whose shift is given in normal modules."""
    return ByCutter(wheel.z, wheel.m, wheel.x, wheel.rack, cutter, cutter.x * np.cos(beta))


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
