"""How far a branch turns back beyond a limit before it goes on: next to nothing in a cusp.

Where the driver's angle only just turns back, rounding of the lengths decides whether it does. A stretch turned back
that is shorter than what limits are told to is no limit and a limit alike.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.random_groups.curve import local, onto
from benchmarks.random_groups.equations import Equations
from benchmarks.random_groups.trace import Run, trace

Array = Any
SHARP = 0.3  # second derivative of the angle by the arc above which a limit is no cusp
BEYOND = 1e-6  # of the arc: where the run back begins
FAR = 0.02  # rad
LEAST = 1e-9  # rad


def cusp(eq: Equations, run: Run, lane: int, sense: float) -> bool:
    """Whether beyond the limit of a lane less than LEAST is turned back."""
    x = run.at[lane][None]
    if not np.isfinite(x).all():
        return False
    path = run.path[lane]
    last = path[np.flatnonzero(np.isfinite(path[:, 0]))[-1]]
    t, _, bent, _ = local(eq, x, x - last)
    if abs(bent[0, 0]) > SHARP:
        return False
    beyond = onto(eq, x + BEYOND * t, x, t, np.array([BEYOND]), 4)[0]
    ahead = local(eq, beyond, t)[0]
    if ahead[0, 0] * sense >= 0:
        return True
    back = trace(eq, beyond, np.array([-sense]), 1, FAR)
    return bool(back.lost[0] or back.limit[0] < LEAST)
