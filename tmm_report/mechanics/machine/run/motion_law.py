"""The motion of a machine from one state to another, in the way that its moments allow:

- by speed: J is constant and the moment is one of the speed alone: dt = J dω/M, dφ = J ω dω/M;
- by angle: the moment is one of the angle alone: J ω²/2 = T0 + ∫M dφ, dt = dφ/ω;
- by time: all else: dφ/dt = ω, dω/dt = (M − J′ω²/2)/J, integrated step by step.

The first two are integrals by Gauss's formula on pieces between the breaks. By time the first and the last cycle are
`ode.integrate` (LSODA), whose unknowns are joined by the works of the characteristics, and the cycles between them,
where the machine neither starts nor stops, collocation in the angle. (Artobolevsky, Theory of mechanisms and machines,
ch. 16)

Here stand what a motion is and where it ends; the ways are `by_speed`, `by_angle`, `by_time`, chosen by `running.run`.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.machine.reduced import Acting, Plant
from tmm_report.records import dataclass

Array = Any
Way = Literal["speed", "angle", "time"]
SAMPLES = 120  # intervals between the samples of a motion
MOST = 2400  # of a motion of many turns
TURNS, STEPPED = (
    1000,
    200,
)  # cycles that are passed, stepped through: who has not arrived then does not arrive


class NeverReached(ArithmeticError):
    """The motion does not come to where it is to end.

    `why`: "level": its speed tends to `omega`, at which no moment is left; "away": from `omega`, at the beginning, the
    moments change it the other way; "stall": it stops at the angle `phi`;
    "long": after turning by `phi` its speed is `omega`.
    """

    def __init__(self, why: Literal["level", "away", "stall", "long"], omega: float = 0.0, phi: float = 0.0):
        super().__init__(why)
        self.why, self.omega, self.phi = why, omega, phi


@dataclass(frozen=True, eq=False)
class Run:
    """`t`, `phi`, `omega` (P,): samples of the motion, P = SAMPLES + 1, ascending in time; `works`: of each that acts,
    from the first to the last, J; `steps`: evaluations of the moments by time, 0 of an integral."""

    plant: Plant
    way: Way
    t: Array
    phi: Array
    omega: Array
    works: dict[str, float]
    steps: int = 0
    rates: Array = None  # of the speed by the integrator's own polynomial, (P,): a second way to `epsilon`

    @cached_property
    def inertia(self) -> Array:
        return self._at(self.plant.inertia)

    def _at(self, values: Array) -> Array:
        return self.plant.panels.at(np.broadcast_to(values, self.plant.panels.shape), self.phi)

    def of(self, one: Acting) -> Array:
        """Moment of one that acts, N m, (P,)."""
        return self._at(one.values) if one.by_angle else one.at(self.omega, self.t) + np.zeros(len(self.t))

    @cached_property
    def moment(self) -> Array:
        """Of all that acts, less what the gears lose by the acceleration."""
        return self._acting - self.lost

    @cached_property
    def _acting(self) -> Array:
        return sum((self.of(one) for one in self.plant.acting), np.zeros(len(self.t)))

    @cached_property
    def lost(self) -> Array:
        """What the gears lose more than at a constant speed, N m, (P,)."""
        return self.plant.lost(self._acting, self.omega, self.inertia, self._at(self.plant.slope))

    @cached_property
    def epsilon(self) -> Array:
        """Angular acceleration by the equation in differential form, rad/s², (P,)."""
        return (self.moment - self._at(self.plant.slope) * self.omega**2 / 2) / self.inertia

    @cached_property
    def gained(self) -> float:
        """Change of the kinetic energy, J."""
        energy = self.inertia * self.omega**2 / 2
        return float(energy[-1] - energy[0])

    @property
    def error(self) -> float:
        """What the balance of energy lacks, relative to the largest of the works and of the change; where nothing works
        and nothing changes the kinetic energy, relative to a millionth of that: its rounding is no lack."""
        works, energy = self.works.values(), float(np.max(self.inertia * self.omega**2)) / 2
        return abs(sum(works) - self.gained) / (max(map(abs, (*works, self.gained, 1e-6 * energy))) or 1.0)

    @cached_property
    def residual(self) -> float:
        """Worst difference of dω/dt of the found motion from the angular acceleration by the equation, relative to the
        largest: without the two samples next to each end."""
        if self.rates is None:
            return 0.0
        off = np.abs(self.rates - self.epsilon)
        return float(np.quantile(off, 0.95) / (np.abs(self.epsilon).max() or 1.0))


@dataclass(frozen=True, eq=False)
class Goal:
    """Where a motion ends: at a speed, rad/s, after a time, s, or after an angle, rad: one of them; or where the speed
    is `near`, ω at the points of the panels, (K, n)."""

    speed: float | None = None
    time: float | None = None
    angle: float | None = None
    near: Array = None
