"""Search of the teeth of a compound train of any scheme: 3K, closed differentials, double and triple rows, idlers.

Every wheel has a range; those that coaxiality fixes follow from the others, the rest are tried in all combinations, in
blocks. A set is judged by coaxiality and ranges, ratio, interference, then for each number of satellites by assembly
and neighbourhood. Lengths are in modules.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from enum import IntEnum
from functools import reduce
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.compound import conditions
from tmm_report.mechanics.gears.compound.conditions import Coaxial, Crowd
from tmm_report.mechanics.gears.compound.rows import Row, Step, by_steps, row_ratio
from tmm_report.mechanics.gears.trains import Train
from tmm_report.records import dataclass

Array = Any
BLOCK = 1 << 16


class Reason(IntEnum):
    """Why a set is rejected, in the order in which it is judged."""

    ACCEPTED = 0
    COAXIALITY = 1
    RATIO = 2
    INTERFERENCE = 3
    ASSEMBLY = 4
    NEIGHBOURHOOD = 5


@dataclass(frozen=True, eq=False)
class Task:
    """What teeth are sought. `ranges`: least and largest teeth by wheel, equal where they are stated; `steps`: of the
    ratio, from the body `output`; `input`: a body; `ratio`: signed; `tolerance`: relative; `satellites`: their numbers
    to try; `shifted`: by how many teeth profile shift may open a mesh; `module` by wheel; `flat`: of each mesh."""

    train: Train
    rows: tuple[Row, ...]
    steps: tuple[Step, ...]
    still: tuple[str, ...]
    input: str
    output: str
    ratio: float
    tolerance: float
    ranges: Mapping[str, tuple[int, int]]
    satellites: tuple[int, ...]
    shifted: int
    module: Mapping[str, float]
    flat: tuple[bool, ...]

    @property
    def wheels(self) -> tuple[str, ...]:
        return tuple(self.ranges)


@dataclass(frozen=True, eq=False)
class Candidates:
    """Teeth (wheels, n) of the accepted sets, best first, with their satellites (n,), ratio (n,) and size (n,) in
    modules; `counts`: of all sets by reason."""

    wheels: tuple[str, ...]
    teeth: Array
    satellites: Array
    ratio: Array
    size: Array
    counts: Mapping[Reason, int]

    @property
    def examined(self) -> int:
        return sum(self.counts.values())

    def set(self, row: int) -> dict[str, int]:
        return {name: int(z) for name, z in zip(self.wheels, self.teeth[:, row], strict=True)}


# --- what follows from what


def followers(task: Task) -> dict[str, Coaxial]:
    """The wheels that coaxiality gives from others, in an order in which it can: by its later mesh, of an internal one
    the ring."""
    free = {name for name, (low, high) in task.ranges.items() if low < high}
    found: dict[str, Coaxial] = {}
    pairs = conditions.coaxial_pairs(task.train, task.flat)
    for pair in pairs:
        mesh = task.train.meshes[pair.other]
        for name in (mesh.j, mesh.i):
            other = task.train.meshes[pair.first]
            used = {one for later in pairs if later in found.values() for one in _wheels(task, later)}
            if name in free - set(found) - used and name not in (other.i, other.j):
                found[name] = pair
                break
    return found


def _wheels(task: Task, pair: Coaxial) -> set[str]:
    meshes = (task.train.meshes[pair.first], task.train.meshes[pair.other])
    return {name for mesh in meshes for name in (mesh.i, mesh.j)}


def extent(task: Task) -> int:
    """How many combinations are tried, without making them."""
    following = followers(task)
    free = [name for name in task.ranges if name not in following]
    return math.prod(_length(task, name) for name in free) * (1 + 2 * task.shifted) ** len(following)


def _length(task: Task, name: str) -> int:
    low, high = task.ranges[name]
    return high - low + 1


def blocks(task: Task) -> Iterator[dict[str, Array]]:
    """Teeth by wheel, (n,) each: all combinations of the free wheels and the whole numbers beside what follows."""
    following = followers(task)
    free = [name for name in task.ranges if name not in following]
    total, depth = math.prod(_length(task, name) for name in free), (1 + 2 * task.shifted) ** len(following)
    size = max(1, BLOCK // depth)
    for start in range(0, total, size):
        place = np.arange(start, min(total, start + size), dtype=np.int64)
        teeth = {}
        for name in reversed(free):
            place, digit = np.divmod(place, _length(task, name))
            teeth[name] = digit + task.ranges[name][0]
        for name, pair in following.items():
            teeth = _followed(task, teeth, name, pair)
        yield {name: teeth[name] for name in task.ranges}


def _followed(task: Task, teeth: dict[str, Array], name: str, pair: Coaxial) -> dict[str, Array]:
    """With the wheel that makes the distances equal, rounded, and its neighbours within the shift."""
    train, module = task.train, task.module
    mesh = train.meshes[pair.other]
    twice = conditions.twice_distance(train, pair.first, teeth, module[train.meshes[pair.first].i])
    mate = mesh.i if name == mesh.j else mesh.j
    # a ring lies round its mate; the other wheel of an internal mesh lies within the ring, the last one stated
    whole = twice / module[name]
    exact = whole - teeth[mate]
    if mesh.internal:
        exact = teeth[mate] + whole if name == mesh.j else teeth[mate] - whole
    nearest = np.rint(exact).astype(np.int64)
    steps = np.arange(-task.shifted, task.shifted + 1)
    spread = {key: np.repeat(value, len(steps)) for key, value in teeth.items()}
    return {**spread, name: (nearest[:, None] + steps).ravel()}


# --- judging


def judge(task: Task, teeth: Mapping[str, Array]) -> tuple[Array, Array]:
    """Reasons that hold for any number of satellites (n,), ACCEPTED where none does; the ratios (n,)."""
    z = {name: np.asarray(value) for name, value in teeth.items()}
    exact = {name: value.astype(float) for name, value in z.items()}
    with np.errstate(divide="ignore", invalid="ignore"):
        known = {task.output: 1.0}
        ratio = by_steps(task.steps, known, lambda row: row_ratio(task.train, row, exact), still=task.still)[
            task.input
        ]
        ratio = np.broadcast_to(np.asarray(ratio, dtype=float), next(iter(z.values())).shape)
        misses = ~(np.abs(ratio / task.ratio - 1) <= task.tolerance * (1 + 1e-12))
    fails = [~coaxial(task, z), misses, ~clear(task, z)]
    reasons = [Reason.COAXIALITY, Reason.RATIO, Reason.INTERFERENCE]
    return np.select(fails, reasons, Reason.ACCEPTED).astype(np.uint8), ratio


def coaxial(task: Task, z: Mapping[str, Array]) -> Array:
    """Every wheel within its range, every pair of distances equal but for what shift makes up, (n,)."""
    found: Array = np.bool_(True)
    for name, (low, high) in task.ranges.items():
        found = found & (z[name] >= low) & (z[name] <= high)
    train = task.train
    for mesh in train.meshes:  # a ring is larger than what runs in it
        found = found & ((z[mesh.j] > z[mesh.i]) | (not mesh.internal))
    for pair in conditions.coaxial_pairs(train, task.flat):
        one, other = (
            conditions.twice_distance(train, k, z, task.module[train.meshes[k].i])
            for k in (pair.first, pair.other)
        )
        least = min(task.module[train.meshes[k].i] for k in (pair.first, pair.other))
        found = found & (np.abs(one - other) <= (task.shifted + 1e-9) * least)
    return found


def clear(task: Task, z: Mapping[str, Array]) -> Array:
    """No internal mesh interferes, its wheels without shift, (n,); where shift is allowed that is left to it."""
    found: Array = np.bool_(True)
    for k, mesh in enumerate(task.train.meshes):
        if mesh.internal and task.flat[k] and not task.shifted:
            found = found & (z[mesh.j] >= conditions.least_ring(z[mesh.i]) - 1e-9)
    return found


def judge_satellites(task: Task, z: Mapping[str, Array], k: int) -> Array:
    """Assembly and neighbourhood, (n,)."""
    fails = [~conditions.assembles(task.train, task.rows, z, k), ~_apart(task, z, k)]
    shape = next(iter(z.values())).shape
    fails = [np.broadcast_to(one, shape) for one in fails]
    return np.select(fails, [Reason.ASSEMBLY, Reason.NEIGHBOURHOOD], Reason.ACCEPTED).astype(np.uint8)


def _apart(task: Task, z: Mapping[str, Array], k: int) -> Array:
    found: Array = np.bool_(True)
    for crowd in conditions.crowds(task.train, task.flat):
        found = found & (conditions.gap(task.train, crowd, z, task.module, k) > 0)
    return found


def size_of(task: Task, z: Mapping[str, Array]) -> Array:
    """Diameter of what the train fills, (n,): twice the reach of satellites, and of every wheel, to their tips."""
    train = task.train
    wheels: list[Array] = [task.module[name] * (z[name] + 2.0) for name in task.ranges]
    wheels += [_reach(task, crowd, z) for crowd in conditions.crowds(train, task.flat)]
    return reduce(np.maximum, wheels)


def _reach(task: Task, crowd: Crowd, z: Mapping[str, Array]) -> Array:
    distance = conditions.twice_distance(
        task.train, crowd.mesh, z, task.module[task.train.meshes[crowd.mesh].i]
    )
    return distance + reduce(np.maximum, [task.module[name] * (z[name] + 2.0) for name in crowd.crowns])


# --- the search


def search(task: Task, most: int = 200) -> Candidates:
    """Every set judged; of the solutions the `most` best are kept: the smallest, of equal ones first three satellites
    (they share the load equally), then the nearest to the ratio."""
    counts = dict.fromkeys(Reason, 0)
    best: Kept = []
    for teeth in blocks(task):
        reasons, ratio = judge(task, teeth)
        good = reasons == Reason.ACCEPTED
        _count(counts, reasons[~good])
        some, of = {name: z[good] for name, z in teeth.items()}, ratio[good]
        for k in task.satellites or (0,):
            verdict = judge_satellites(task, some, k) if k else np.zeros(len(of), dtype=np.uint8)
            _count(counts, verdict)
            kept = verdict == Reason.ACCEPTED
            chosen = {name: z[kept] for name, z in some.items()}
            best = _better(task, best, chosen, k, of[kept], most)
    return _joined(task, best, counts)


Kept = list[tuple[float, int, float, int, tuple[int, ...], float]]  # size, |k − 3|, miss, k, teeth, ratio


def _count(counts: dict[Reason, int], reasons: Array) -> None:
    for code, number in zip(*np.unique(reasons, return_counts=True), strict=True):
        counts[Reason(int(code))] += int(number)


def _better(task: Task, best: Kept, z: Mapping[str, Array], k: int, ratio: Array, most: int) -> Kept:
    """The best so far with those of a block, sorted."""
    if not len(ratio):
        return best
    size: Array = np.round(size_of(task, z), 9)
    miss: Array = np.round(np.abs(ratio / task.ratio - 1), 12)
    places = np.lexsort((miss, size))[:most]
    found = [
        (
            float(size[p]),
            abs(k - 3),
            float(miss[p]),
            k,
            tuple(int(z[name][p]) for name in task.wheels),
            float(ratio[p]),
        )
        for p in places
    ]
    return sorted([*best, *found])[:most]


def _joined(task: Task, best: Kept, counts: Mapping[Reason, int]) -> Candidates:
    count = len(task.wheels)
    teeth = np.array([one[4] for one in best], dtype=np.int64).reshape(-1, count).T
    satellites, ratio, size = ([one[part] for one in best] for part in (3, 5, 0))
    return Candidates(
        task.wheels,
        teeth,
        np.array(satellites, dtype=np.int64),
        np.array(ratio, dtype=float),
        np.array(size, dtype=float),
        {reason: number for reason, number in counts.items() if number},
    )
