"""The search for the teeth of a planetary stage: every candidate of a range judged at once, by arrays.

    found = search(Task(SCHEMES["sun-ring"], 6.56, (0.005, 0.005), "wheel1", "carrier"))
    found.teeth[:, ranked(task, found)[0]]        # z1, z2, z2', z3 of the best one

Teeth are integers (4, N): z1, z2, z2', z3; `planetary` tells the schemes and the conditions. Nothing here loops over
candidates.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from enum import IntEnum
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.planetary.sought import (
    LARGEST_SHIFTED,
    STANDARD,
    Task,
    blocks,
    candidates,
    coaxiality_gap,
    extent,
)
from tmm_report.mechanics.gears.planetary.stage import (
    EXTERNAL,
    INTERNAL,
    Sizes,
    assembles,
    basic_ratio,
    contact_ratio,
    internal_pair,
    kinds,
    least_teeth,
    neighbourhood_gap,
    stage_ratio,
    teeth_sums,
)
from tmm_report.records import dataclass

__all__ = ["LARGEST_SHIFTED", "STANDARD", "Task", "candidates", "extent", "search"]

Array = Any
LEAST_CONTACT = 1.05  # of the course
KEPT = 10_000  # solutions: of more, the best
POOL = 4  # times as many solutions wait to be ranked


# --- conditions


class Reason(IntEnum):
    """Why a candidate is rejected: the first condition that fails, in the order of the course."""

    ACCEPTED = 0
    RATIO = 1
    COAXIALITY = 2
    UNDERCUT = 3
    INTERFERENCE = 4
    CONTACT = 5
    NEIGHBOURHOOD = 6
    ASSEMBLY = 7


def ratio_holds(task: Task, z: Array) -> Array:
    ratio = stage_ratio(basic_ratio(task.scheme, z), task.input, task.output)
    return np.abs(ratio - task.ratio) <= allowed(task) * (1 + 1e-12)


def coaxial(task: Task, z: Array) -> Array:
    """Both rows have a centre distance, and one: by the teeth, or opened by profile shift."""
    sums = teeth_sums(task.scheme, z)
    possible = np.all(sums > 0, axis=0)
    if task.distance is not None:  # no nearer than the base circles let it
        module = np.array(task.modules).reshape(2, *[1] * (np.ndim(z) - 1))
        possible &= np.all(module * sums / 2 * np.cos(task.rack.alpha) < task.distance, axis=0)
    return possible & (coaxiality_gap(task, z) <= task.shifted + 1e-9)


def not_undercut(task: Task, z: Array, found: Sizes) -> Array:
    """No wheel with external teeth is undercut, (...)."""
    outside = [k for k, kind in enumerate(kinds(task.scheme)) if kind == EXTERNAL]
    least = least_teeth(task.rack, found.shifts[outside])
    return np.all(np.asarray(z)[outside] >= least - 1e-9, axis=0)


def no_interference(task: Task, z: Array, found: Sizes) -> Array:
    free = np.ones(np.shape(z)[1:], dtype=bool)
    for row, kind in enumerate(task.scheme.rows):
        if kind == INTERNAL:
            free &= internal_pair(task.scheme, found, z, row).free
    return free


def in_contact(task: Task, z: Array, found: Sizes) -> Array:
    """The contact ratio of both rows is enough: a row opened by shift has less of it."""
    ratios = [contact_ratio(task.scheme, found, z, row) for row in (0, 1)]
    return np.minimum(*ratios) >= LEAST_CONTACT


def judge(task: Task, z: Array, k: Array) -> Array:
    """The Reason of each candidate, uint8 (N,), for teeth (4, N) and numbers of satellites (N,)."""
    z, k = np.asarray(z), np.asarray(k)
    codes, alive, found = judge_teeth(task, z)
    codes[alive] = judge_satellites(task, z[:, alive], found, k[alive])
    return codes


def judge_teeth(task: Task, z: Array) -> tuple[Array, Array, Sizes]:
    """The conditions that hold for any number of satellites: codes (N,), indices and sizes of those that pass."""
    codes = np.full(z.shape[1], Reason.RATIO, dtype=np.uint8)
    alive = np.flatnonzero(ratio_holds(task, z))
    fits = coaxial(task, z[:, alive])
    codes[alive[~fits]] = Reason.COAXIALITY
    alive = alive[fits]
    teeth = z[:, alive]
    found = task.sizes(teeth)
    fails = [~holds(task, teeth, found) for holds in (not_undercut, no_interference, in_contact)]
    reasons = [Reason.UNDERCUT, Reason.INTERFERENCE, Reason.CONTACT]
    codes[alive] = np.select(fails, reasons, Reason.ACCEPTED)
    passed = codes[alive] == Reason.ACCEPTED
    return codes, alive[passed], found.at(passed)


def judge_satellites(task: Task, z: Array, found: Sizes, k: Array) -> Array:
    """Neighbourhood and assembly, uint8 (N,), of teeth with their sizes."""
    fails = [neighbourhood_gap(found, k) <= 0, ~assembles(task.scheme, z, k)]
    return np.select(fails, [Reason.NEIGHBOURHOOD, Reason.ASSEMBLY], Reason.ACCEPTED).astype(np.uint8)


# --- the search


@dataclass(frozen=True, eq=False)
class Candidates:
    """Teeth (4, N), numbers of satellites (N,), 0: any, and why each is rejected (N,), a Reason: of the solutions, and
    where all are wanted of the others too. `counts`: how many there were of each Reason, kept here or not."""

    teeth: Array
    satellites: Array
    reasons: Array
    counts: Mapping[Reason, int] = field(default_factory=dict)

    @property
    def accepted(self) -> Array:
        """Indices of the solutions, (n,)."""
        return np.flatnonzero(self.reasons == Reason.ACCEPTED)

    def count(self, reason: Reason) -> int:
        return self.counts.get(reason, 0)

    @property
    def solutions(self) -> int:
        """How many solutions there are; of very many only the best stand here."""
        return self.count(Reason.ACCEPTED)

    @property
    def examined(self) -> int:
        return sum(self.counts.values())


def search(task: Task, rejected: bool = False, most: int = KEPT) -> Candidates:
    """Every candidate judged, block by block; those that fail whatever the number of satellites are counted once, with
    0 of them. Of the solutions the `most` best are kept; `rejected`: all of them, and the others beside them."""
    kept: list[Candidates] = []
    counts = dict.fromkeys(Reason, 0)
    waiting = 0
    for teeth in blocks(task):
        some = _judged(task, teeth, counts, rejected)
        kept.append(some)
        waiting += len(some.satellites)
        if waiting > POOL * most and not rejected:
            kept = [_best(task, _joined(kept, {}), most)]
            waiting = len(kept[0].satellites)
    found = _joined(kept, counts)
    return found if rejected or waiting <= most else _best(task, found, most)


def _judged(task: Task, teeth: Array, counts: dict[Reason, int], rejected: bool) -> Candidates:
    """A block of combinations; `counts` are added to."""
    reasons, alive, found = judge_teeth(task, teeth)
    failed = reasons != Reason.ACCEPTED
    good = teeth[:, alive]
    verdicts = np.stack([judge_satellites(task, good, found, k) for k in task.satellites], axis=-1)
    for code, number in zip(
        *np.unique(np.append(reasons[failed], verdicts), return_counts=True), strict=True
    ):
        counts[Reason(code)] += int(number)
    wanted = np.ones(verdicts.shape, dtype=bool) if rejected else verdicts == Reason.ACCEPTED
    place, of_k = np.nonzero(wanted)
    k = np.array(task.satellites, dtype=np.int32)[of_k]
    if not rejected:
        return Candidates(good[:, place], k, verdicts[wanted])
    return Candidates(
        np.concatenate([good[:, place], teeth[:, failed]], axis=1),
        np.concatenate([k, np.zeros(int(np.sum(failed)), dtype=np.int32)]),
        np.concatenate([verdicts[wanted], reasons[failed]]),
    )


def _joined(parts: list[Candidates], counts: dict[Reason, int]) -> Candidates:
    none = Candidates(
        np.zeros((4, 0), dtype=np.int32), np.zeros(0, dtype=np.int32), np.zeros(0, dtype=np.uint8)
    )
    parts = [none, *parts]
    return Candidates(
        np.concatenate([part.teeth for part in parts], axis=1),
        np.concatenate([part.satellites for part in parts]),
        np.concatenate([part.reasons for part in parts]),
        {reason: number for reason, number in counts.items() if number},
    )


def _best(task: Task, found: Candidates, most: int) -> Candidates:
    """The best of solutions, `most` of them."""
    order = ranked(task, found)[:most]
    return Candidates(found.teeth[:, order], found.satellites[order], found.reasons[order], found.counts)


def multiples(z: Array, k: Array) -> Array:
    """Whether a central wheel's teeth are a multiple of the satellites' number: all then mesh in one phase, (...)."""
    return (z[0] % k == 0) | (z[3] % k == 0)


def ranked(task: Task, found: Candidates) -> Array:
    """Indices of the solutions, best first, (n,).

    First those whose central wheels are no multiples of k, then those without shift, then by (1 − w) ln D + w Δu/[Δu]:
    with the weight w = 0 the most compact, with w = 1 the nearest to the ratio; of equal ones, first three satellites
    (they share the load equally), then the ratio that is nearest, then the fewer teeth.
    """
    index = found.accepted
    z, k = found.teeth[:, index], found.satellites[index]
    size = np.round(task.sizes(z).overall, 9)
    miss = np.abs(stage_ratio(basic_ratio(task.scheme, z), task.input, task.output) - task.ratio)
    shifted = coaxiality_gap(task, z) > 1e-9
    if task.weight:
        size = np.round((1 - task.weight) * np.log(size) + task.weight * miss / allowed(task), 9)
    order = np.lexsort((k, *z[::-1], miss, np.abs(k - 3), size, shifted, multiples(z, k)))
    return index[order]


def allowed(task: Task) -> float:
    """The largest deviation of the ratio."""
    return task.tolerance * abs(task.ratio)
