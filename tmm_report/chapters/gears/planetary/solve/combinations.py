"""Combinations of teeth of a planetary stage with what is said of each."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import Candidates, Reason, Task, multiples, ranked, search
from tmm_report.mechanics.gears.planetary.sought import coaxiality_gap
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Combinations:
    """`teeth` (4, n): z1, z2, z2', z3; `satellites` (n,), 0: any; `ratio` (n,) and its `deviation`, relative;
    `multiple`: whether a central wheel's teeth are a multiple of the satellites' number; `reason`: of rejection."""

    teeth: Array
    satellites: Array
    ratio: Array
    deviation: Array
    multiple: Array
    reason: Array


@dataclass(frozen=True, eq=False)
class Solutions:
    """The combinations that satisfy every condition, best first. `overall` (n,): the diameter that the stage fills, m;
    `shifted` (n,): whether coaxiality is by profile shift."""

    of: Combinations
    overall: Array
    shifted: Array


def combinations(task: Task, found: Candidates, order: Array) -> Combinations:
    """Those of the indices (n,)."""
    z, k = found.teeth[:, order], found.satellites[order]
    ratio = p.stage_ratio(p.basic_ratio(task.scheme, z), task.input, task.output)
    repeats = multiples(z, np.maximum(k, 1)) & (k > 0)
    return Combinations(z, k, ratio, ratio / task.ratio - 1, repeats, found.reasons[order])


def solutions(task: Task, found: Candidates, ranking: Array) -> Solutions:
    z = found.teeth[:, ranking]
    overall = task.sizes(z).overall
    shifted = coaxiality_gap(task, z) > 1e-9
    return Solutions(combinations(task, found, ranking), overall, shifted)


def every(task: Task) -> Combinations:
    """All that were judged: the solutions, best first, then the others, the nearest to success first."""
    found = search(task, rejected=True)
    ranking = ranked(task, found)
    bad = np.flatnonzero(found.reasons != Reason.ACCEPTED)
    z = found.teeth[:, bad]
    ratio = p.stage_ratio(p.basic_ratio(task.scheme, z), task.input, task.output)
    with np.errstate(invalid="ignore"):
        miss = np.abs(ratio - task.ratio)
    nearest = np.lexsort((miss, -found.reasons[bad].astype(int)))
    return combinations(task, found, np.concatenate([ranking, bad[nearest]]))
