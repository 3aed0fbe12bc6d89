"""A pair in motion: the velocities of the point of contact, and what its speed allows the profiles to slide.

At a point K of the line of action the tooth of wheel i has the velocity ω_i O_iK. Its part along the line of action,
ω_i r_bi, is the same for both wheels; its part across, ω_i N_iK, is not: their difference is the velocity of sliding,
v_sl = V_1τ − V_2τ = (ω_1 + ω_2) PK for an external pair, (ω_1 − ω_2) PK for an internal one.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 22.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.records import dataclass

Array = Any

SLOW, FAST = 15.0, 20.0  # pitch-line velocities between which the limit falls, m/s
WIDEST, NARROWEST = 6.0, 3.0  # largest specific sliding of slow and of fast pairs


def sliding_limit(velocity: float) -> float:
    """Largest specific sliding at a pitch-line velocity, m/s: 6 up to 15 m/s, 3 from 20 m/s on, between them linear.

    The course states 3 … 6 at 15 … 20 m/s; that the smaller value belongs to the faster pair follows from the wear,
    which grows with the velocity.
    """
    return float(np.interp(velocity, (SLOW, FAST), (WIDEST, NARROWEST)))


@dataclass(frozen=True, eq=False)
class Motion:
    """Magnitudes at the points of the line of action, (P,) each, m/s. `omega`: angular velocities, rad/s, magnitudes.

    `pitch`: pitch-line velocity; `along`: of both teeth along the line of action, `across`: across it, `whole`: of the
    points themselves; `sliding`: v_sl, above zero where wheel 1 is the faster across.
    """

    omega: tuple[float, float]
    pitch: float
    along: float
    across: tuple[Array, Array]
    whole: tuple[Array, Array]
    sliding: Array

    @property
    def fastest(self) -> int:
        """At which of the points the profiles slide fastest."""
        return int(np.argmax(np.abs(self.sliding)))


def motion_of(pair: Pair, speed: float, rho: Array, mates: Array) -> Motion:
    """`speed`: of wheel 1, rad/s; `rho`, `mates`: radii of curvature of both wheels at the points, m."""
    omega = abs(speed), abs(speed / float(pair.ratio))
    along = omega[0] * float(pair.d_b[0]) / 2
    across = omega[0] * np.asarray(rho), omega[1] * np.asarray(mates)
    whole = np.hypot(along, across[0]), np.hypot(along, across[1])
    pitch = omega[0] * float(pair.d_w[0]) / 2
    sliding = across[0] - across[1]
    sliding = np.where(np.abs(sliding) < 1e-12 * pitch, 0.0, sliding)  # in the pitch point they roll
    return Motion(omega, pitch, along, across, whole, sliding)
