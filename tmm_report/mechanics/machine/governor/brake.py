"""A centrifugal brake: shoes on springs fly out to a drum and hold the speed of what drives them.

Contact begins where m ρ ω² is the force of the spring at the drum: ω₀. From there on M_b = K (ω² − ω₀²), K = n f m ρ R.
(Artobolevsky, Theory of mechanisms and machines, ch. 20)
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True)
class Brake:
    """`count` shoes of the `mass`, their mass centres at `radius` when they rest, `gap` from the drum of the radius
    `drum`, each pulled in by a spring of the stiffness and the force at rest; `friction`: coefficient. SI."""

    mass: float
    radius: float
    gap: float
    drum: float
    friction: float
    stiffness: float
    preload: float = 0.0
    count: int = 2

    @property
    def at_contact(self) -> float:
        """Radius of the mass centres when the shoes touch, m."""
        return self.radius + self.gap

    @property
    def spring(self) -> float:
        """Force of a spring when its shoe touches, N."""
        return self.preload + self.stiffness * self.gap

    @property
    def contact(self) -> float:
        """Speed at which the shoes touch, rad/s."""
        return float(np.sqrt(self.spring / (self.mass * self.at_contact)))

    @property
    def K(self) -> float:
        """M_b = K (ω² − ω₀²), kg m²."""
        return self.count * self.friction * self.mass * self.at_contact * self.drum

    def moment(self, omega: Array) -> Array:
        """Braking moment, N m (P,); nought below contact."""
        return self.K * np.maximum(np.asarray(omega) ** 2 - self.contact**2, 0.0)

    def held(self, moment: Array) -> Array:
        """Speed at which the brake balances a driving moment, rad/s."""
        return np.sqrt(self.contact**2 + np.asarray(moment) / self.K)

    def start(self, moment: float, inertia: float, t: Array) -> Array:
        """ω(t) from rest under a constant driving moment, rad/s (P,): M t/J up to contact, then, of J ω' = K (ω_h² −
        ω²), ω_h tanh(K ω_h (t − t₀)/J + artanh(ω₀/ω_h))."""
        free = moment * np.asarray(t, dtype=float) / inertia
        held = self.held(moment)
        since = np.maximum(t - self.contact * inertia / moment, 0.0)
        braked = held * np.tanh(self.K * held * since / inertia + np.arctanh(self.contact / held))
        return np.where(free < self.contact, free, braked)

    def time_to(self, part: float, moment: float, inertia: float) -> float:
        """After which ω is `part` of the speed held, s; not less than at contact."""
        held = float(self.held(moment))
        wanted = max(part, self.contact / held)
        return self.contact * inertia / moment + (
            np.arctanh(wanted) - np.arctanh(self.contact / held)
        ) * inertia / (self.K * held)
