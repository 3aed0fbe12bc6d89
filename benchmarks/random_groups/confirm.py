"""The search held against all assemblies: two ways that share nothing but the constraints.

Every point of the followed branch must be one of all the assemblies at its angle; between two angles the branch goes on
in that assembly which lies nearest to where its rate points; and a limit takes two assemblies away.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.random_groups.assemblies import apart, assemblies
from benchmarks.random_groups.draw import Batch
from benchmarks.random_groups.equations import Equations, solved
from benchmarks.random_groups.search import COUNT, Truth

Array = Any
BESIDE = 3e-4  # rad from a limit: nearer, its two assemblies are one but for rounding


@dataclass(frozen=True)
class Confirmed:
    """Of one mechanism: greatest distance of the branch from the nearest of all assemblies; steps in which the nearest
    to the prediction is another one; assemblies that the limit takes away, None where there is none."""

    apart: float
    slips: int
    taken: int | None


def confirmed(batch: Batch, truth: Truth, lane: int, every: int = 4) -> Confirmed:
    """One mechanism, at each `every`th of the angles of its path."""
    one = batch.of(np.array([lane]))
    eq, path = one.equations, truth.forward.path[lane][::every]
    path = path[np.isfinite(path[:, 0])]
    many = eq.of(np.zeros(len(path), dtype=int))
    sets = assemblies(many, _known(eq, path))
    misses = [float(apart(x, ways, eq.angles).min(initial=9.0)) for x, ways in zip(path, sets, strict=True)]
    return Confirmed(max(misses), _slips(many, path, sets, every), _taken(one, eq, truth, lane))


def _known(eq: Equations, x: Array) -> Array:
    """The angles known before the group: φ, and of a dyad in front its rod's."""
    return x[:, : eq.unknowns - (3 if eq.moves else 2)]


def _slips(many: Equations, path: Array, sets: list[Array], every: int) -> int:
    J = many.rates(path)
    with np.errstate(all="ignore"):
        slope = -solved(J[:, :, 1:], J[:, :, 0])
    step = 2 * np.pi / COUNT * every
    count = 0
    for k in range(len(path) - 1):
        ahead = path[k].copy()
        turn = np.sign(path[k + 1, 0] - path[k, 0])
        ahead[0] = path[k + 1, 0]
        ahead[1:] += turn * step * slope[k]
        if not len(sets[k + 1]):
            continue
        chosen = int(np.argmin(apart(ahead, sets[k + 1], many.angles)))
        count += bool(apart(path[k + 1], sets[k + 1], many.angles)[chosen] > 1e-6)
    return count


def _taken(one: Batch, eq: Equations, truth: Truth, lane: int) -> int | None:
    limit, x = truth.forward.limit[lane], truth.forward.at[lane]
    if np.isinf(limit) or eq.unknowns - (3 if eq.moves else 2) > 1:
        return None
    phi = x[0] + one.sense[0] * BESIDE * np.array([-1.0, 1.0])
    before, after = assemblies(eq.of(np.zeros(2, dtype=int)), phi[:, None])
    return len(before) - len(after)
