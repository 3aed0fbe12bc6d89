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
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad
from tmm_report.mechanics.lever.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.extremes import peaks
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Found:
    """`permitted`: the least angle, rad; `couplers`: dyads whose links meet in a joint."""

    permitted: float
    kinematics: Kinematics
    couplers: tuple[Dyad, ...]


def solve(kinematics: Kinematics, permitted: float) -> Found:
    """The dyad of a cam's follower is none: its link is another in every position, and its angle the pressure angle."""
    own = (one for one in kinematics.linkage.groups if isinstance(one, Dyad) and not isinstance(one, CamDyad))
    dyads = (one for one in own if one.kind in (1, 2))
    return Found(permitted, kinematics, tuple(dyads))


def angle(of: Dyad, motion: Motion) -> Array:
    """(P,), rad."""
    return np.arcsin(np.minimum(motion.sines[of.group.label], 1.0))


def span(of: Dyad, motion: Motion) -> Array:
    """Of the outer joints, or of the outer joint from the guide through the inner one, (P,), m."""
    outer = motion.place(of.outer_a.name)
    if of.kind == 1:
        return np.abs(motion.place(of.outer_b.name) - outer)
    guide = motion.turn(of.carrier_b) * of.outer_b.along[of.carrier_b]
    return np.abs(cross(guide, motion.place(of.inner.name) - outer))


def least(of: Dyad, found: Kinematics) -> Extreme:
    """Over the cycle; of one with gaps or limits among the positions of the diagram."""
    if not found.cycle.closed or found.limited:
        return least_and_greatest(angle(of, found.diagram), found.diagram_turned)[0]
    over = panels(found.cycle.sweep, found.cycle.corners)
    cosine = np.cos(angle(of, found.cycle.motion(over.x.ravel()))).reshape(over.shape)
    (_, peak), *_ = peaks(over, cosine[None] ** 2)  # smooth where the acute angle has a corner, at 90°
    return Extreme(float(np.arccos(np.sqrt(peak.value))), peak.turned, peak.side)
