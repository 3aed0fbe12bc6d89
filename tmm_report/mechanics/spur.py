"""A pair of involute wheels in mesh: line of action, contact ratio, specific sliding, what may go wrong.

The wheels themselves, and how they are counted and signed, are in `wheels`. Everything broadcasts.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.involute import inv, inverse
from tmm_report.mechanics.wheels import (
    Both,
    Rack,
    Wheels,
    arccos,
    involute_start,
    least_shift,
    root,
    signs_of,
)

__all__ = ["Pair", "Rack", "Sliding", "fouling", "least_shift", "meshed", "shift_sum"]

Array = Any


class Sliding(NamedTuple):
    """Specific sliding of both wheels along a path; `rho`: radius of curvature of wheel 1 there, m."""

    rho: Array
    first: Array
    second: Array


@dataclass(frozen=True, eq=False)
class Pair(Wheels):
    """The two wheels in mesh."""

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
        return self._both(lambda i: root(self.d_a[i] ** 2 - self.d_b[i] ** 2) / 2)

    @cached_property
    def _rho_p(self) -> Both:
        return self._both(lambda i: self._line - self._rho_a[1 - i])

    @cached_property
    def rho_p(self) -> Both:
        """Radii of curvature at the lower points of the active profiles, where the other wheel's tip touches."""
        return self._plain(self._rho_p)

    @cached_property
    def _rho_l(self) -> Both:
        return self._both(lambda i: involute_start(self._d[i], self.m_t, self._x[i], self.t))

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
        z, (r, R) = self._ordered((self.z1, self.z2)), self._ordered(self.d_a)
        return fouling(z, (r / 2, R / 2), self._ordered(self.alpha_a), self.a_w, self.alpha_w)

    def _ordered(self, both: Both) -> Both:
        """Of an internal pair: what belongs to the pinion, what to the ring."""
        first = self.signs[1] < 0
        return np.where(first, both[0], both[1]), np.where(first, both[1], both[0])


def fouling(z: Both, tips: Both, angles: Both, a_w: Array, alpha_w: Array) -> Array:
    """Gap between the tips of pinion and ring off the line of action, as an angle of the ring, rad, (...).

    Of (pinion, ring): numbers of teeth, radii of the tips, m, and profile angles there. At the crossing of the tip
    circles each wheel stands at an angle δ from the centre line, and the ring must lead. ∞ where the pinion's tips do
    not come to those of the ring, −∞ where they enclose them; nan for a ring's tip inside its base circle.
    Source: Litvin, Gear geometry and applied theory, ch. 11 (the same as GOST 19274).
    """
    (r, R), (tip, Tip) = tips, (inv(alpha) for alpha in angles)
    delta = arccos((R**2 - a_w**2 - r**2) / (2 * a_w * r))
    Delta = arccos((R**2 + a_w**2 - r**2) / (2 * a_w * R))
    gap = (z[0] * (tip + delta) - z[1] * (Tip + Delta) + (z[1] - z[0]) * inv(alpha_w)) / z[1]
    gap = np.where(a_w + r <= R, np.inf, gap)
    return np.where(r - a_w >= R, -np.inf, gap)[()]


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
    s1, s2 = signs_of(z1, z2, internal)
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
