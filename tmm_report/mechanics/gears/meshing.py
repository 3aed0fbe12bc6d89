"""A pair of involute wheels in mesh: line of action, contact ratio, specific sliding, what may go wrong.

The wheels themselves, and how they are counted and signed, are in `wheels`. Everything broadcasts.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.gears.cutting import ByCutter
from tmm_report.mechanics.gears.involute import inv, inverse
from tmm_report.mechanics.gears.pair_sizes import Both, Cutter, Rack, Wheels, least_shift, signs_of
from tmm_report.mechanics.gears.rack import root
from tmm_report.mechanics.gears.ring_interference import Cutting, cutting_of, fouling, radial
from tmm_report.records import dataclass

__all__ = ["Cutter", "Pair", "Rack", "Sliding", "fouling", "least_shift", "meshed", "shift_sum"]

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
    def _rho_m(self) -> Both:
        return self._both(lambda i: self._line - self._rho_a[1 - i])

    @cached_property
    def rho_m(self) -> Both:
        """Radii of curvature where the other wheel's tip would touch, had the involute no end before."""
        return self._plain(self._rho_m)

    @cached_property
    def _top(self) -> Both:
        """Radii of curvature where the teeth end: at the tip circle, or in a point below it."""
        return self._both(self._top_of)

    def _top_of(self, i: int) -> Array:
        point = self.signs[i] * inverse(np.maximum(self.signs[i] * self.s_b[i] / self.d_b[i], 0.0))
        return np.minimum(self._rho_a[i], self.d_b[i] / 2 * np.tan(point))

    @cached_property
    def tops(self) -> Both:
        """Radii of curvature where the involutes end at the tips: at the tip circle, or in a point below it."""
        return self._plain(self._top)

    @cached_property
    def _rho_p(self) -> Both:
        return self._both(lambda i: np.maximum(self._line - self._top[1 - i], self._start[i]))

    @cached_property
    def rho_p(self) -> Both:
        """Radii of curvature at the lower points of the active profiles: where the other wheel's tip touches, or where
        the involute begins (of a ring: ends) if that comes first."""
        return self._plain(self._rho_p)

    @cached_property
    def _rho_u(self) -> Both:
        return self._both(lambda i: self._line - self._rho_p[1 - i])

    @cached_property
    def rho_u(self) -> Both:
        """Radii of curvature at the upper points of the active profiles: the tips, unless the mate's involute ends."""
        return self._plain(self._rho_u)

    @cached_property
    def _rho_l(self) -> Both:
        return self._both(lambda i: self.cuts[i].start)

    @cached_property
    def rho_l(self) -> Both:
        """Radii of curvature where the tool's tip leaves the involute, above the fillet; negative: undercut."""
        return self._plain(self._rho_l)

    @cached_property
    def rho_w(self) -> Both:
        """Radii of curvature at the pitch point."""
        return self._both(lambda i: self.d_w[i] * np.sin(self.alpha_w) / 2)

    @cached_property
    def active(self) -> Array:
        """Length of the active part of the line of action, AB, between the points where both teeth are involutes."""
        return self._line - self._rho_p[0] - self._rho_p[1]

    @cached_property
    def eps(self) -> Array:
        """Transverse contact ratio, of the involutes that there really are; ≤ 0 where none meet."""
        return self.active / self.p_b

    @cached_property
    def active_tips(self) -> Array:
        """Length of the line of action between the tip circles, as if the involutes reached as far."""
        return self._rho_a[0] + self._rho_a[1] - self._line

    @cached_property
    def eps_tips(self) -> Array:
        """Contact ratio by the tip circles alone, the textbook's formula."""
        return self.active_tips / self.p_b

    @cached_property
    def cut_short(self) -> Array:
        """Whether the contact is shorter than between the tip circles."""
        return self.active < self.active_tips - 1e-9 * self.p_b

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
        with np.errstate(divide="ignore", invalid="ignore"):
            rolling = (self._line - first) * self._z[0] / (first * self._z[1])  # v2 : v1 along the profiles
            return Sliding(rho, 1 - rolling, 1 - 1 / rolling)

    @cached_property
    def root_sliding(self) -> Both:
        """Specific sliding at the lower points of the active profiles; the extreme of each wheel.

        −∞ where the contact passes the end of the line of action: there the sliding has no bound.
        """
        roots = self.sliding(self.rho_p[0]).first, self.sliding(self.rho_u[0]).second
        return self._both(lambda i: np.where(self.rho_p[i] > 0, roots[i], -np.inf)[()])

    @cached_property
    def tip_sliding(self) -> Both:
        """Specific sliding at the upper points of the active profiles, the tips."""
        lower, upper = self.sliding(self.rho_p[0]), self.sliding(self.rho_u[0])
        return upper.first, lower.second

    @cached_property
    def sliding_difference(self) -> Array:
        """Positive where the root of wheel 1 slides more than that of wheel 2, smooth everywhere, m².

        λ_p1 = 1 − z1 ρ_u2/(z2 ρ_p1) and λ_p2 = 1 − z2 ρ_u1/(z1 ρ_p2), their equality with the denominators cleared.
        """
        z1, z2 = self._z
        return z1**2 * self._rho_u[1] * self._rho_p[1] - z2**2 * self._rho_u[0] * self._rho_p[0]

    # ------------------------------------------------------------ what may go wrong

    @cached_property
    def x_min(self) -> Both:
        """Least shifts without undercut, of a wheel cut by a rack ha* − z sin²α/2; −∞ for a ring."""
        turn = np.cos(self.beta)
        return self._both(lambda i: np.where(self.signs[i] > 0, self.cuts[i].least_shift / turn, -np.inf)[()])

    @cached_property
    def interference(self) -> Both:
        """Radius of curvature in hand between where the other wheel's tip touches and where the involute begins, m.

        Negative: the tip would run into the fillet, or into the gap that an undercut has left.
        """
        return self._both(lambda i: self._rho_m[i] - self._start[i])

    @cached_property
    def involute_left(self) -> Both:
        """Length of the line of action that each wheel's involute spans, m; none left where not positive."""
        return self._both(lambda i: self._top[i] - self._start[i])

    @cached_property
    def spaces(self) -> Both:
        """Width of the spaces at the root circle of a ring, m; ∞ of an external wheel."""
        return self._both(self._space)

    def _space(self, i: int) -> Array:
        pitch = np.pi * self.d_f[i] / (self.z1, self.z2)[i]
        return np.where(self.signs[i] < 0, pitch - self._thickness(i, self.d_f[i]), np.inf)[()]

    @cached_property
    def cutting(self) -> tuple[Cutting | None, Cutting | None]:
        """What is in hand when each ring is cut by its pinion cutter; None of other wheels."""
        return self._cutting(0), self._cutting(1)

    def _cutting(self, i: int) -> Cutting | None:
        cut = self.cuts[i]
        if not isinstance(cut, ByCutter) or not np.all(self.signs[i] < 0):
            return None
        return cutting_of(cut, (self.z1, self.z2)[i], self.d_a[i] / 2, self.alpha_a[i])

    def cut_ring(self, i: int) -> Cutting:
        """The same of a ring that is known to be cut by a pinion cutter."""
        found = self.cutting[i]
        assert found is not None
        return found

    @cached_property
    def radial(self) -> Array:
        """Room in hand when an internal pair is put together radially, as an angle of the ring, rad; nan: external.

        Negative: a tooth of the pinion cannot pass one of the ring in every position, and the pinion is put in axially.
        """
        if not self.internal:
            return np.full(np.shape(self.a_w), np.nan)[()]
        z, tips = self._ordered((self.z1, self.z2)), self._ordered(self.d_a)
        return radial(z, (tips[0] / 2, tips[1] / 2), self._ordered(self.alpha_a), self.a_w, self.alpha_w)

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
    trimmed: bool = False,
    cutter: Cutter | None = None,
) -> Pair:
    """The pair at the centre distance without backlash; nan where the shifts leave no such distance."""
    s1, s2 = signs_of(z1, z2, internal)
    t, teeth = rack.transverse(beta), s1 * z1 + s2 * z2
    x_sum = (s1 * x1 + s2 * x2) * np.cos(beta)
    v = inv(t.alpha) + 2 * x_sum * np.tan(t.alpha) / teeth
    alpha_w = inverse(np.where(v >= 0, v, np.nan))
    a_w = m / np.cos(beta) * np.abs(teeth) / 2 * np.cos(t.alpha) / np.cos(alpha_w)
    return Pair(z1, z2, m, rack, beta, x1, x2, a_w, internal, shortened, trimmed, cutter)


def shift_sum(
    z1: Array, z2: Array, m: float, rack: Rack, beta: float, a_w: Array, internal: bool = False
) -> Array:
    """x1 + x2 (the ring's less the pinion's of an internal pair) that fills the distance without backlash."""
    pair = Pair(z1, z2, m, rack, beta, 0.0, 0.0, a_w, internal)
    teeth = pair.a * 2 / pair.m_t
    return teeth * (inv(pair.alpha_w) - inv(pair.t.alpha)) / (2 * np.tan(pair.t.alpha) * np.cos(beta))
