"""A centrifugal brake: shoes on springs fly out to a drum and hold the speed of what drives them.

Contact begins where m ρ ω² is the force of the spring at the drum: ω₀. From there on M_b = K (ω² − ω₀²), K = n f m ρ R.
(Artobolevsky, Theory of mechanisms and machines, ch. 20)

A shoe on an arm that swings about a pivot A of the disc: about A the centrifugal force acts at l_C = a sin ψ_m, the
normal force of the drum at l_N = a sin ψ, its friction at l_T = R − a cos ψ, the spring at l_F. So N (l_N ± f l_T) =
C l_C − F l_F, with − where the shoe goes before its pivot and the friction draws it on: it locks where f l_T ≥ l_N.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True)
class Lever:
    """The arm of a shoe. `pivot`: distance of the pivot from the axis, m; `shoe`, `mass_centre`: angles at the axis
    from the pivot, rad; `spring`: distance of its line from the pivot, m; `drawn_on`: whether the shoe goes before its
    pivot, so that friction draws it on to the drum."""

    pivot: float
    shoe: float
    mass_centre: float
    spring: float
    drawn_on: bool

    @property
    def normal(self) -> float:
        """Distance of the normal force from the pivot, l_N, m."""
        return self.pivot * math.sin(self.shoe)

    @property
    def centrifugal(self) -> float:
        """Distance of the centrifugal force from the pivot, l_C, m."""
        return self.pivot * math.sin(self.mass_centre)

    def tangential(self, drum: float) -> float:
        """Distance of the friction from the pivot, l_T, m."""
        return drum - self.pivot * math.cos(self.shoe)


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
    lever: Lever | None = None

    @property
    def swing(self) -> float:
        """Angle by which an arm swings until its shoe touches, rad; a small one."""
        return self.gap / self.lever.normal if self.lever else 0.0

    @property
    def at_contact(self) -> float:
        """Radius of the mass centres when the shoes touch, m."""
        return self.radius + (self.swing * self.lever.centrifugal if self.lever else self.gap)

    @property
    def drawn(self) -> float:
        """By which a spring is drawn out until its shoe touches, m."""
        return self.swing * self.lever.spring if self.lever else self.gap

    @property
    def spring(self) -> float:
        """Force of a spring when its shoe touches, N."""
        return self.preload + self.stiffness * self.drawn

    @property
    def held_off(self) -> float:
        """Centrifugal force that the spring of 1 N holds."""
        return self.lever.spring / self.lever.centrifugal if self.lever else 1.0

    @property
    def presses(self) -> float:
        """Normal force by the surplus of the centrifugal force; below nought where the shoe locks itself."""
        if self.lever is None:
            return 1.0
        friction = self.friction * self.lever.tangential(self.drum)
        return self.lever.centrifugal / (self.lever.normal + (-friction if self.lever.drawn_on else friction))

    @property
    def locks(self) -> bool:
        """Whether friction alone holds a shoe on the drum once it touches."""
        lever = self.lever
        return (
            lever is not None
            and lever.drawn_on
            and self.friction * lever.tangential(self.drum) >= lever.normal
        )

    @property
    def contact(self) -> float:
        """Speed at which the shoes touch, rad/s."""
        return float(np.sqrt(self.spring * self.held_off / (self.mass * self.at_contact)))

    @property
    def K(self) -> float:
        """M_b = K (ω² − ω₀²), kg m²."""
        return self.mass * self.per_mass

    @property
    def per_mass(self) -> float:
        """K of shoes of 1 kg, m²."""
        return self.count * self.friction * self.at_contact * self.drum * self.presses

    def turned_back(self) -> Brake:
        """The same that turns the other way."""
        return (
            replace(self, lever=replace(self.lever, drawn_on=not self.lever.drawn_on)) if self.lever else self
        )

    def mass_for(self, moment: float, speed: float) -> float:
        """Of a shoe, so that the brake holds the speed, kg: ω² = (F h/ρ + M/k)/m, with K = k m."""
        return (self.spring * self.held_off / self.at_contact + moment / self.per_mass) / speed**2

    def spring_for(self, moment: float, speed: float) -> float:
        """Force of a spring at contact, so that the brake holds the speed, N; below nought where the shoes are too
        light."""
        return self.mass * self.at_contact * (speed**2 - moment / self.K) / self.held_off

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
