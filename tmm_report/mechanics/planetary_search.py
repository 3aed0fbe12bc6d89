"""The search for the teeth of a planetary stage: every candidate of a range judged at once, by arrays.

    found = search(Task(SCHEMES["sun-ring"], 6.56, (0.005, 0.005), "wheel1", "carrier"))
    found.teeth[:, ranked(task, found)[0]]        # z1, z2, z2', z3 of the best one

Teeth are integers (4, N): z1, z2, z2', z3; `planetary` tells the schemes and the conditions. Nothing here loops over
candidates.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Any

import numpy as np

from tmm_report.mechanics.planetary import (
    EXTERNAL,
    INTERNAL,
    MEMBERS,
    Member,
    Scheme,
    Sizes,
    assembles,
    basic_ratio,
    coaxiality_gap,
    contact_ratio,
    internal_pair,
    kinds,
    least_teeth,
    neighbourhood_gap,
    sizes,
    stage_ratio,
    teeth_sums,
)
from tmm_report.mechanics.spur import Rack

Array = Any
STANDARD = Rack()
LEAST_CONTACT = 1.05  # of the course
LARGEST_SHIFTED = 2  # teeth: a larger difference of the sums is not made up by profile shift


@dataclass(frozen=True)
class Task:
    """What teeth are sought for.

    `ratio`: ω_input/ω_output with the third member held, signed; `tolerance`: of it, relative. `satellites`: their
    numbers to try. `external`, `rings`: least and largest teeth of wheels with external and internal teeth.
    `shifted`: the largest difference of the sums of teeth, 0..2, that profile shift may make up.
    """

    scheme: Scheme
    ratio: float
    modules: tuple[float, float]
    input: Member
    output: Member
    tolerance: float = 0.04
    satellites: tuple[int, ...] = (2, 3, 4, 5, 6)
    rack: Rack = STANDARD
    external: tuple[int, int] = (12, 100)
    rings: tuple[int, int] = (20, 200)
    shifted: int = 0

    @property
    def held(self) -> Member:
        return next(member for member in MEMBERS if member not in (self.input, self.output))


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
    return np.abs(ratio - task.ratio) <= task.tolerance * abs(task.ratio) * (1 + 1e-12)


def coaxial(task: Task, z: Array) -> Array:
    """Both rows have a centre distance, and one: by the teeth, or opened by profile shift."""
    possible = np.all(teeth_sums(task.scheme, z) > 0, axis=0)
    return possible & (coaxiality_gap(task.scheme, task.modules, z) <= task.shifted + 1e-9)


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
    found = sizes(task.scheme, task.modules, task.rack, teeth)
    fails = [~holds(task, teeth, found) for holds in (not_undercut, no_interference, in_contact)]
    reasons = [Reason.UNDERCUT, Reason.INTERFERENCE, Reason.CONTACT]
    codes[alive] = np.select(fails, reasons, Reason.ACCEPTED)
    passed = codes[alive] == Reason.ACCEPTED
    return codes, alive[passed], found.at(passed)


def judge_satellites(task: Task, z: Array, found: Sizes, k: Array) -> Array:
    """Neighbourhood and assembly, uint8 (N,), of teeth with their sizes."""
    fails = [neighbourhood_gap(found, k) <= 0, ~assembles(task.scheme, z, k)]
    return np.select(fails, [Reason.NEIGHBOURHOOD, Reason.ASSEMBLY], Reason.ACCEPTED).astype(np.uint8)


# --- candidates


@dataclass(frozen=True, eq=False)
class Candidates:
    """Teeth (4, N), numbers of satellites (N,), 0: any, and why each is rejected (N,), a Reason."""

    teeth: Array
    satellites: Array
    reasons: Array

    @property
    def accepted(self) -> Array:
        """Indices of the solutions, (n,)."""
        return np.flatnonzero(self.reasons == Reason.ACCEPTED)

    def count(self, reason: Reason) -> int:
        return int(np.sum(self.reasons == reason))


def candidates(task: Task) -> Array:
    """All teeth in the task's ranges whose rows nearly share one centre distance, (4, N).

    Of a single row: every z1, z3 with the satellites that the distance leaves room for; of two rows: every z1, z2,
    z2' with the z3 nearest to coaxiality. Where shift may open a row, also the neighbouring numbers.
    """
    z = _single_row(task) if task.scheme.single else _two_rows(task)
    ranges = [task.external if kind == EXTERNAL else task.rings for kind in task.scheme.rows]
    inside = np.all(teeth_sums(task.scheme, z) > 0, axis=0)
    for wheel, (low, high) in ((0, ranges[0]), (1, task.external), (2, task.external), (3, ranges[1])):
        inside &= (z[wheel] >= low) & (z[wheel] <= high)
    return z[:, inside]


def _whole(limits: tuple[int, int]) -> Array:
    return np.arange(limits[0], limits[1] + 1, dtype=np.int32)


def _single_row(task: Task) -> Array:
    """z2 = (z3 − z1)/2 rounded down, and its neighbours within the shifted difference."""
    axes = np.meshgrid(_whole(task.external), _whole(task.rings), indexing="ij")
    z1, z3 = (axis.ravel() for axis in axes)
    gap = z3 - z1
    found = []
    for step in (0, 1, -1):
        z2 = gap // 2 + step
        near = np.abs(gap - 2 * z2) <= task.shifted if step else slice(None)
        found.append(np.stack([z1[near], z2[near], z3[near]]))
    z1, z2, z3 = np.concatenate(found, axis=1)
    return np.stack([z1, z2, z2, z3])


def _two_rows(task: Task) -> Array:
    """z3 from m1 (z1 ± z2) = m2 (z3 ± z2'), rounded, and its neighbours within the shifted difference."""
    first = task.external if task.scheme.rows[0] == EXTERNAL else task.rings
    axes = _whole(first), _whole(task.external), _whole(task.external)
    z1, z2, z2_ = (axis.ravel() for axis in np.meshgrid(*axes, indexing="ij"))
    wanted = np.round(task.modules[0] * (z1 + task.scheme.rows[0] * z2) / task.modules[1])
    nearest = wanted.astype(np.int32) - task.scheme.rows[1] * z2_
    # in teeth of row 2 the difference is larger where its module is the smaller one
    reach = (
        int(np.ceil(task.shifted * max(1.0, task.modules[0] / task.modules[1]) + 0.5)) if task.shifted else 0
    )
    found = [np.stack([z1, z2, z2_, nearest + step]) for step in range(-reach, reach + 1)]
    near = [coaxiality_gap(task.scheme, task.modules, z) <= task.shifted + 1e-9 for z in found]
    near[reach][:] = True  # the nearest is a candidate even where the modules leave it apart
    return np.concatenate([z[:, keep] for z, keep in zip(found, near, strict=True)], axis=1)


def search(task: Task) -> Candidates:
    """Every candidate judged; those that fail whatever the number of satellites stand once, with 0 of them."""
    teeth = candidates(task)
    reasons, alive, found = judge_teeth(task, teeth)
    failed = reasons != Reason.ACCEPTED
    each = np.repeat(np.arange(len(alive)), len(task.satellites))
    k = np.tile(np.array(task.satellites, dtype=np.int32), len(alive))
    good = teeth[:, alive[each]]
    return Candidates(
        np.concatenate([good, teeth[:, failed]], axis=1),
        np.concatenate([k, np.zeros(int(np.sum(failed)), dtype=np.int32)]),
        np.concatenate([judge_satellites(task, good, found.at(each), k), reasons[failed]]),
    )


def multiples(z: Array, k: Array) -> Array:
    """Whether a central wheel's teeth are a multiple of the satellites' number: all then mesh in one phase, (...)."""
    return (z[0] % k == 0) | (z[3] % k == 0)


def ranked(task: Task, found: Candidates) -> Array:
    """Indices of the solutions, best first, (n,).

    First those whose central wheels are no multiples of k, then those without shift, then the most compact; of
    equal ones, first three satellites (they share the load equally), then the ratio that is nearest.
    """
    index = found.accepted
    z, k = found.teeth[:, index], found.satellites[index]
    size = sizes(task.scheme, task.modules, task.rack, z).overall
    miss = np.abs(stage_ratio(basic_ratio(task.scheme, z), task.input, task.output) - task.ratio)
    shifted = coaxiality_gap(task.scheme, task.modules, z) > 1e-9
    order = np.lexsort((miss, np.abs(k - 3), np.round(size, 9), shifted, multiples(z, k)))
    return index[order]
