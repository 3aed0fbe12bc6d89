"""Transmission angles over the cycle: how favourably each coupler drives the link that it meets in a joint.

Of a dyad of turning pairs it is the acute angle between its links, of one with a guide that between the link and the
normal of the guide: 90° is best, at 0° nothing is transmitted. (Artobolevsky, Theory of mechanisms and machines,
ch. 26)
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.extremes import peaks
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Coupler:
    """A dyad whose links meet in a joint."""

    dyad: Dyad
    kinematics: Kinematics

    def angle(self, motion: Motion) -> Array:
        """(P,), rad."""
        return np.arcsin(np.minimum(motion.sines[self.dyad.group.label], 1.0))

    def span(self, motion: Motion) -> Array:
        """Of the outer joints, or of the outer joint from the guide through the inner one, (P,), m."""
        of, outer = self.dyad, motion.place(self.dyad.outer_a.name)
        if of.kind == 1:
            return np.abs(motion.place(of.outer_b.name) - outer)
        guide = motion.turn(of.carrier_b) * of.outer_b.along[of.carrier_b]
        return np.abs(cross(guide, motion.place(of.inner.name) - outer))

    def least(self) -> Extreme:
        """Over the cycle; of one with gaps or limits among the positions of the diagram."""
        found = self.kinematics
        if not found.cycle.closed or found.limited:
            return least_and_greatest(self.angle(found.diagram), found.diagram_turned)[0]
        over = panels(found.cycle.sweep, found.cycle.corners)
        cosine = np.cos(self.angle(found.cycle.motion(over.x.ravel()))).reshape(over.shape)
        (_, peak), *_ = peaks(over, cosine[None] ** 2)  # smooth where the acute angle has a corner, at 90°
        return Extreme(float(np.arccos(np.sqrt(peak.value))), peak.turned, peak.side)


@dataclass(frozen=True, eq=False)
class Found:
    """`permitted`: the least angle, rad."""

    permitted: float
    couplers: tuple[Coupler, ...]


def solve(kinematics: Kinematics, permitted: float) -> Found:
    dyads = (one for one in kinematics.linkage.groups if isinstance(one, Dyad) and one.kind in (1, 2))
    return Found(permitted, tuple(Coupler(one, kinematics) for one in dyads))
