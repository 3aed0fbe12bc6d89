"""What is right: the assembly of position 0 followed in the sense of rotation to its limit, and backwards.

Positions beyond the limit belong to the mechanism only where the run backwards reaches them on the same sheet.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.random_groups.draw import CROSSING, Batch
from benchmarks.random_groups.schemes import places
from benchmarks.random_groups.trace import TURN, Run, trace

Array = Any
Interval = tuple[float, float]
EPS = 2.3e-16
COUNT = 360  # angles of a turn at which places are compared


@dataclass(frozen=True, eq=False)
class Truth:
    """L lanes. Angles are turned from position 0 in the sense of rotation, rad."""

    forward: Run
    backward: Run
    returns: Array  # (L,) bool: a full turn brings back the assembly of position 0
    undecided: Array  # (L,) bool: another curve comes as near as rounding tells, or the curve was lost

    def __len__(self) -> int:
        return len(self.returns)

    @property
    def whole(self) -> Array:
        return ~(self.forward.limit <= TURN)  # the last step may look beyond the turn

    @property
    def overlaps(self) -> Array:
        """Whether what is found backwards is another sheet over what is found forwards."""
        return ~self.whole & ~(self.forward.limit + self.backward.limit < TURN)

    def gap(self, lane: int) -> Interval | None:
        """Where the mechanism does not exist."""
        if self.whole[lane]:
            return None
        end = TURN if self.overlaps[lane] else TURN - self.backward.limit[lane]
        return float(self.forward.limit[lane]), float(end)

    def allowed(self, lane: int) -> Interval:
        """What rounding of lengths alone changes the ends of the gap by, and no less than 1e-9, rad."""
        runs = self.forward, self.backward
        low, high = (max(1e-9, float(100 * EPS / max(run.across[lane], 1e-300))) for run in runs)
        return low, (1e-9 if self.overlaps[lane] else high)

    def path(self, lane: int) -> Array:
        """x at equal steps of a turn, (COUNT + 1, n), nan in the gap."""
        forward, backward = self.forward.path[lane], self.backward.path[lane][::-1]
        if self.whole[lane] or self.overlaps[lane]:
            return forward
        return np.where(np.isnan(forward), backward, forward)


def truth(batch: Batch) -> Truth:
    """The answer of every lane."""
    equations, x = batch.equations, batch.start
    forward = trace(equations, x, batch.sense, COUNT)
    backward = trace(equations, x, -batch.sense, COUNT)
    undecided = forward.lost | backward.lost
    if batch.family not in CROSSING:
        undecided |= np.isfinite(forward.crossed) | np.isfinite(backward.crossed)
    return Truth(forward, backward, _returns(batch, forward), undecided)


def _returns(batch: Batch, run: Run) -> Array:
    start = places(batch.scheme, batch.numbers, batch.size, batch.start)
    end = places(batch.scheme, batch.numbers, batch.size, run.path[:, -1])
    off = np.max([np.abs(end[p] - start[p]) / batch.size for p in start], axis=0)
    return off < 1e-6
