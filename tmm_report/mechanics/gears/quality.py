"""Quality of a pair over the division of its shifts: pressure between the profiles, and within which shifts it works.

The centre distance, and so the sum of the shifts, is kept. Lengths in m; shifts broadcast.
Source: Bolotovsky, Involute gears: a reference book, part 1; Frolov (ed.), Theory of mechanisms and machines, ch. 13.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import root_between
from tmm_report.mechanics.gears.limits.pair import Limit, limits_of, unknown
from tmm_report.mechanics.gears.meshing import Pair
from tmm_report.mechanics.gears.shift_sharing import with_first_shift
from tmm_report.records import dataclass

Array = Any

FARTHEST = 5.0  # shifts are looked for between −5 and 5
STEP = 0.01  # of the grid on which the ends of what a limit allows are bracketed
JUMP = 1e-6  # of a margin, modules or radians: what is more than rounding
TOLD = (
    "undercut",
    "pointing",
    "contact",
    "interference",
    "fouling",
)  # limits that bound the shift of wheel 1


@dataclass(frozen=True)
class Allowed:
    """What a limit allows of the shift of wheel 1: from `low` to `high`, −∞ and ∞ where it sets no end there."""

    limit: Limit
    low: float
    high: float


def specific_pressure(pair: Pair, rho: Array) -> Array:
    """γ = m/ρ where wheel 1 has the radius of curvature `rho` (transverse): ρ of the cylinder on a plane that the two
    profiles stand for there, of helical teeth in their normal section."""
    one = pair.signs[0] * rho
    other = pair.side * pair.line - one
    with unknown():
        return pair.m * np.cos(pair.beta_b) * np.abs(1 / one + 1 / other)


def allowed(
    pair: Pair, thickness: float, ratio: float
) -> tuple[tuple[Allowed, ...], tuple[float, float] | None]:
    """What every limit alone allows of x1, and what all of them do together: of several stretches that which is nearest
    to the shift of the pair; None where there is none.

    `thickness` of the tips, modules, and contact `ratio`: the least.
    """
    limits = limits_of(pair, thickness, ratio)
    grid = np.arange(-FARTHEST, FARTHEST + STEP / 2, STEP)
    margins = np.array([_kept(limit, pair, grid) for limit in limits])
    alone = tuple(_alone(pair, limits, margins, grid))
    return alone, _stretch(partial(_least, limits, pair), np.min(margins, axis=0), grid, float(pair.x1))


def _alone(pair: Pair, limits: tuple[Limit, ...], margins: Array, grid: Array) -> Iterator[Allowed]:
    for limit, margin in zip(limits, margins, strict=True):
        of = partial(_kept, limit, pair)
        found = _stretch(of, margin, grid, float(pair.x1))
        if limit.kind in TOLD and found is not None:
            # where the margin jumps there are no such wheels: that is the end that another limit sets
            low, high = (x if abs(of(np.array(x))) < JUMP else np.inf for x in found)
            yield Allowed(limit, min(low, -low) if np.isinf(low) else low, high)


def _kept(limit: Limit, pair: Pair, x1: Array) -> Array:
    """The margin of a limit; −1 where there is no such pair."""
    trial = with_first_shift(pair, x1)
    with unknown():
        found = limit.margin(trial) + 0 * np.asarray(x1)
    return np.where(np.isfinite(found) | (found == np.inf), found, -1.0)


def _least(limits: tuple[Limit, ...], pair: Pair, x1: Array) -> Array:
    return np.min([_kept(limit, pair, x1) for limit in limits], axis=0)


def _stretch(
    margin: Callable[[Array], Array], values: Array, grid: Array, near: float
) -> tuple[float, float] | None:
    """The ends of the stretch of an ascending grid with no negative margin that is nearest to a shift."""
    good = np.flatnonzero(values >= 0)
    if not good.size:
        return None
    at = good[np.argmin(np.abs(grid[good] - near))]
    bad = np.flatnonzero(values < 0)
    below, above = bad[bad < at], bad[bad > at]

    low = root_between(margin, *grid[[below[-1], below[-1] + 1]]) if below.size else -np.inf
    high = root_between(margin, *grid[[above[0] - 1, above[0]]]) if above.size else np.inf
    return low, high
