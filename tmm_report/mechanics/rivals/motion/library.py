"""A general root finder of a library on the constraint equations, position by position, as its user would call it.

MINPACK's hybrid method of Powell (hybrj) with its own tolerance, from the root of the position before. The Jacobian is
given: by its own differences it loses a column where an unknown is a rounding error beside 0, as a slider's are. It
says whether it settled; whether the root belongs to the same assembly it cannot know, and nobody asks.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.motion.coordinates import Coordinates
from tmm_report.mechanics.rivals.motion.newton import CLOSED, followed

Array = Any


def root_finder(cycle: Cycle, count: int) -> Motion:
    """Motion by scipy's `root`; nan where it did not settle, unless the equations close all the same. Rates by the
    Jacobian of the root that it found. Raises ArithmeticError where position 0 cannot be assembled.
    """
    return followed(cycle, count, _march, check=False)


def _march(c: Coordinates, start: Array, phi: Sequence[float]) -> Array:
    from scipy.optimize import root

    found = np.full((len(phi), c.count), np.nan)
    q = start
    for k, angle in enumerate(phi):
        at = np.array([angle])
        settled = root(lambda x: tuple(part[0] for part in c.equations(x[None], at)), q, jac=True)  # noqa: B023
        if settled.success or np.abs(settled.fun).max() <= CLOSED:  # no progress is made beyond rounding
            found[k] = q = settled.x
    return found
