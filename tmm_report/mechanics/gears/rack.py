"""The basic rack, and what of a wheel's tooth follows from it alone."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any


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


def arccos(x: Array) -> Array:
    """nan outside −1…1."""
    with np.errstate(invalid="ignore"):
        return np.arccos(x)


def root(x: Array) -> Array:
    """Square root; nan of what is negative."""
    with np.errstate(invalid="ignore"):
        return np.sqrt(x)
