"""What a diagram by displacement counts: how far a point has gone along a direction, or a link has turned."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Force, Moment
from tmm_report.mechanics.calculus.laws import Diagram
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.mechanics.lever.cycle import Cycle
    from tmm_report.mechanics.lever.motion import Motion

Array = Any
LEAST = 1e-6  # of the mean of a link's directions: one that goes all round has none


@dataclass(frozen=True, eq=False)
class Coordinate:
    """The place of the point `name` along `zero`, unit complex, m; of a link its angle, rad, from the direction
    `middle` of its swing, in the sense `zero`, ±1."""

    name: str
    zero: complex
    middle: complex | None = None

    def value(self, motion: Motion) -> Array:
        if self.middle is None:
            return dot(motion.place(self.name), self.zero)
        return self.zero.real * np.angle(motion.turn(self.name) / self.middle)

    def rate(self, motion: Motion) -> Array:
        if self.middle is None:
            return dot(motion.velocity(self.name), self.zero)
        return self.zero.real * motion.angular_velocity(self.name)


def coordinate(load: Force | Moment, cycle: Cycle) -> Coordinate:
    """Of a load whose law is a diagram."""
    assert isinstance(load.law, Diagram)
    if isinstance(load, Force):
        return Coordinate(load.at, load.law.zero)
    mean = complex(np.nanmean(cycle.search[1].turn(load.on)))
    return Coordinate(load.on, load.law.zero, mean / abs(mean) if abs(mean) > LEAST else 1.0 + 0j)
