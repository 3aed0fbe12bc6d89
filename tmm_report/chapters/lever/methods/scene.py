"""What the methods of forces work on: the motion of the mechanism, and its loads at any number of positions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.solve.positions import loading, resultants
from tmm_report.mechanics.lever.forces.reactions import Load
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.model import Loaded

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.given import Loads


def scene(given: Loads, kinematics: Kinematics) -> Loaded:
    """Its `loads` hold for a motion at equal steps of the cycle, the last included, as `Cycle.once` has them: loads of
    a cycle of several turns differ where the motion does not."""
    cycle = kinematics.cycle

    def loads(motion: Motion) -> dict[str, Load]:
        count = motion.shape[-1] - 1
        turned = np.arange(count + 1) * (cycle.period / count)
        return resultants(given, motion, loading(given, kinematics, motion, turned))

    return Loaded(cycle, loads)
