"""What teeth are sought of a planetary stage, and the combinations of teeth that are tried, in blocks.

for teeth in blocks(task): ...      # (4, n) each: z1, z2, z2', z3
extent(task)                        # how many there are at most, without making them
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.planetary.stage import (
    EXTERNAL,
    MEMBERS,
    Member,
    Scheme,
    Sizes,
    sizes,
    teeth_sums,
)
from tmm_report.records import dataclass

Array = Any
STANDARD = Rack()
LARGEST_SHIFTED = 2  # teeth: a larger difference of the sums is not made up by profile shift
BLOCK = 1 << 15  # combinations that are judged together


@dataclass(frozen=True)
class Task:
    """What teeth are sought for.

    `ratio`: ω_input/ω_output with the third member held, signed; `tolerance`: of it, relative. `satellites`: their
    numbers to try. `external`, `rings`: least and largest teeth of wheels with external and internal teeth.
    `shifted`: the largest difference of the sums of teeth, 0..2, that profile shift may make up. `weight`, 0..1: what
    the nearness of the ratio counts beside the size of the stage where solutions are ranked. `distance`: the centre
    distance, m, None: the larger of the rows'; `shifts`: x1, x2, x2', x3 as stated, or those of the crowns alone (the
    central wheels nan), in transverse modules; None: as the centre distance asks.
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
    weight: float = 0.0
    distance: float | None = None
    shifts: tuple[float, float, float, float] | None = None

    @property
    def held(self) -> Member:
        return next(member for member in MEMBERS if member not in (self.input, self.output))

    def sizes(self, z: Array) -> Sizes:
        """The sizes for teeth (4, ...)."""
        return sizes(self.scheme, self.modules, self.rack, z, self.distance, self.shifts)


def coaxiality_gap(task: Task, z: Array) -> Array:
    """What the rows' centre distances differ by, in teeth of the smaller row, (...): 0 where teeth alone agree.

    Where the centre distance is stated: what the farther row differs by from it, in teeth of that row.
    """
    module = np.array(task.modules).reshape(2, *[1] * (np.ndim(z) - 1))
    twice = module * teeth_sums(task.scheme, z)
    if task.distance is not None:
        return np.max(np.abs(twice - 2 * task.distance) / module, axis=0)
    smaller = np.where(twice[0] <= twice[1], module[0], module[1])
    return np.abs(twice[0] - twice[1]) / smaller


# --- the combinations


def candidates(task: Task) -> Array:
    """All teeth in the task's ranges whose rows nearly share one centre distance, (4, N).

    Of a single row: every z1, z3 with the satellites that the distance leaves room for; of two rows: every z1, z2,
    z2' with the z3 nearest to coaxiality. Where shift may open a row, also the neighbouring numbers.
    """
    return np.concatenate([np.zeros((4, 0), dtype=np.int32), *blocks(task)], axis=1)


def blocks(task: Task) -> Iterator[Array]:
    """The same in blocks, (4, n) each: what is judged together takes little room, however wide the ranges are."""
    make = _single_row if task.scheme.single else _two_rows
    for axes in _boxes(_axes(task), _depth(task)):
        grid = [axis.ravel() for axis in np.meshgrid(*axes, indexing="ij")]
        z = make(task, *grid)
        yield z[:, np.all(teeth_sums(task.scheme, z) > 0, axis=0)]


def extent(task: Task) -> int:
    """How many combinations of a central wheel and the crowns, or of both central wheels, the ranges hold."""
    return math.prod(len(axis) for axis in _axes(task))


def _ranges(task: Task) -> tuple[tuple[int, int], tuple[int, int]]:
    """Of wheels 1 and 3."""
    one, three = (task.external if kind == EXTERNAL else task.rings for kind in task.scheme.rows)
    return one, three


def _axes(task: Task) -> tuple[Array, ...]:
    """z1, z3 of a single row; z1, z2, z2' of two."""
    one, three = _ranges(task)
    wheels = (one, three) if task.scheme.single else (one, task.external, task.external)
    return tuple(np.arange(low, high + 1, dtype=np.int32) for low, high in wheels)


def _depth(task: Task) -> int:
    """How many combinations a node of the grid makes at most."""
    if task.scheme.single:
        return 5
    low, high = _ranges(task)[1]
    ratio = 1.0 if task.distance else task.modules[0] / task.modules[1]
    return 1 + min(math.ceil(task.shifted * (1 + ratio)), high - low)


def _boxes(axes: tuple[Array, ...], depth: int) -> Iterator[tuple[Array, ...]]:
    """The grid in boxes of about BLOCK combinations, cut along the first axis and, where need be, the second."""
    first, second, *rest = axes
    behind = depth * math.prod(len(axis) for axis in rest)
    down = max(1, BLOCK // behind)
    across = max(1, BLOCK // (behind * min(down, len(second))))
    for i in range(0, len(first), across):
        for j in range(0, len(second), down):
            yield (first[i : i + across], second[j : j + down], *rest)


def _single_row(task: Task, z1: Array, z3: Array) -> Array:
    """z2 = (z3 − z1)/2 rounded down, and its neighbours within the shifted difference."""
    stated = task.distance is not None
    gap, reach = z3 - z1, task.shifted * (2 if stated else 1)
    found = []
    for step in (0, 1, -1, 2, -2) if stated else (0, 1, -1):
        z2 = gap // 2 + step
        near = np.abs(gap - 2 * z2) <= reach if step else slice(None)
        found.append(np.stack([z1[near], z2[near], z2[near], z3[near]]))
    z = np.concatenate(found, axis=1)
    return z[:, (z[1] >= task.external[0]) & (z[1] <= task.external[1])]


def _two_rows(task: Task, z1: Array, z2: Array, z2_: Array) -> Array:
    """z3 from m1 (z1 ± z2) = m2 (z3 ± z2'), rounded, and its neighbours within the shifted difference.

    Where row 1 is the smaller one, the difference is counted in its teeth: so many more of row 2 as its module is
    smaller.
    """
    one, two = task.modules
    if task.distance is None:
        twice, below, above = (
            one * (z1 + task.scheme.rows[0] * z2) / two,
            task.shifted,
            task.shifted * one / two,
        )
    else:
        twice, below, above = np.full(z1.shape, 2 * task.distance / two), task.shifted, task.shifted
    near = np.rint(twice)  # a candidate even where the modules leave it apart
    first = np.minimum(np.ceil(twice - below - 1e-9), near)
    last = np.maximum(np.floor(twice + above + 1e-9), near)
    other = task.scheme.rows[1] * z2_
    low, high = _ranges(task)[1]
    first, last = np.maximum(first - other, low), np.minimum(last - other, high)
    counts = np.maximum(last - first + 1, 0).astype(np.int64)
    each = np.repeat(np.arange(len(z1)), counts)
    step = np.arange(len(each)) - np.repeat(np.cumsum(counts) - counts, counts)
    z3 = (first[each] + step).astype(np.int32)
    return np.stack([z1[each], z2[each], z2_[each], z3])
