"""What accelerates a geared part passes the gears between it and the main shaft, and is lost there in part.

A part takes the moment x = M + J ε from the main shaft, M and J reduced without losses. Where x is above zero the power
goes from the main shaft to the part, which costs x/η; where it is below, the part drives and gives back x η. So each
part decides by itself on which side its η stands, anew at each moment: in a run-down most inertias drive. Over ε the
moment taken is a broken straight line that rises, bent at ε = −M/J of each part. (Artobolevsky, ch. 14–15)
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.machine import reduced_train
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Passing:
    """`inertia`, kg m², `moment`, N m (above zero it resists), `efficiency`: of each part, on the main shaft without
    losses, (m,); inertias and efficiencies are above zero.

    What the moments M alone lose is counted with the loads; here is what ε adds to it.
    """

    inertia: Array
    moment: Array
    efficiency: Array

    @cached_property
    def _still(self) -> Array:
        return reduced_train.moment(1.0, self.moment, self.efficiency)

    def lost(self, epsilon: Array) -> Array:
        """What the gears lose more than at a constant speed, N m, (...), at the acceleration ε, rad/s²; below zero
        where the inertia relieves them."""
        gained = self.inertia * np.asarray(epsilon)[..., None]
        more = reduced_train.moment(1.0, self.moment + gained, self.efficiency) - self._still - gained
        return more.sum(axis=-1)

    @cached_property
    def bends(self) -> Array:
        """ε at which a part's power turns, ascending, (m,)."""
        return np.sort(-self.moment / self.inertia)

    @cached_property
    def _steps(self) -> tuple[Array, Array]:
        """At the bends what is lost, (m,); its slope before the first, between them and after the last, (m + 1,)."""
        order = np.argsort(-self.moment / self.inertia)
        J, eta = self.inertia[order], self.efficiency[order]
        drives, driven = J * (eta - 1), J * (1 / eta - 1)
        before = np.concatenate([[0.0], np.cumsum(driven)])
        after = np.concatenate([np.cumsum(drives[::-1])[::-1], [0.0]])
        return self.lost(self.bends), before + after

    def acceleration(self, moment: Array, inertia: Array) -> Array:
        """ε, rad/s², (...), by J ε + `lost`(ε) = `moment`; `inertia` J of the whole machine without losses."""
        at, slopes = self._steps
        J, left = np.asarray(inertia, float)[..., None], np.asarray(moment, float)
        k = (left[..., None] > J * self.bends + at).sum(axis=-1)
        near = np.maximum(k - 1, 0)
        rest = left - J[..., 0] * self.bends[near] - at[near]
        return self.bends[near] + rest / (J[..., 0] + slopes[k])

    def moments(self, inertia: float) -> Array:
        """The moments `acceleration` is bent at, N m, ascending, (m,)."""
        return inertia * self.bends + self._steps[0]
