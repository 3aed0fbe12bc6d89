"""The two meshes of a planetary stage, wheel 1 with its crown and wheel 3 with the other: conditions and lengths."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.pair_sizes import involute_start, least_ring
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import Task
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Rows:
    """Both rows, (2,). `teeth`: z1 ± z2 and z3 ± z2'; `contact`: contact ratios; `line`: a_w sin α_w, m; `start`: the
    radius of curvature at which the satellite's involute begins, m.

    Of a mesh with a ring, else nan: `tips`, how far the tips clear each other, rad, and `radial`, the same while the
    satellite is put into the ring radially; `curvature` of the ring's tip of
    full height, m; `cut`: the tip diameter to which the ring is cut down clear of the fillets, m, nan where it is not;
    `least`: teeth of a ring that its satellite allows, both without shift, else nan.
    """

    teeth: Array
    contact: Array
    line: Array
    start: Array
    tips: Array
    radial: Array
    curvature: Array
    cut: Array
    least: Array

    @property
    def rings(self) -> list[int]:
        """The rows that have a ring."""
        return [int(row) for row in np.flatnonzero(np.isfinite(self.tips))]


def rows(task: Task, teeth: tuple[int, int, int, int], sizes: p.Sizes) -> Rows:
    """The rows of one stage whose sizes are known."""
    z = np.array(teeth)
    contact = np.array([float(p.contact_ratio(task.scheme, sizes, z, row)) for row in (0, 1)])
    line = sizes.centre_distance * np.sin(sizes.angles)
    tips, past, curvature, cut = (np.array(of) for of in zip(*_rings(task, teeth, sizes), strict=True))
    starts = np.array([_start(task, sizes, row) for row in (0, 1)])
    least = np.array([_least(task, teeth, sizes, row) for row in (0, 1)])
    return Rows(p.teeth_sums(task.scheme, z), contact, line, starts, tips, past, curvature, cut, least)


def _least(task: Task, teeth: tuple[int, int, int, int], sizes: p.Sizes, row: int) -> float:
    central, crown = p.ROWS[row]
    if task.scheme.rows[row] == p.EXTERNAL or sizes.shifts[central] or sizes.shifts[crown]:
        return np.nan
    return float(least_ring(teeth[crown], task.rack))


def _start(task: Task, sizes: p.Sizes, row: int) -> float:
    crown = p.ROWS[row][1]
    return float(involute_start(sizes.pitch[crown], task.modules[row], sizes.shifts[crown], task.rack))


def _rings(
    task: Task, teeth: tuple[int, int, int, int], sizes: p.Sizes
) -> Iterator[tuple[float, float, float, float]]:
    """`tips`, `radial`, `curvature` and `cut` of each row."""
    for row, kind in enumerate(task.scheme.rows):
        if kind == p.EXTERNAL:
            yield np.nan, np.nan, np.nan, np.nan
            continue
        wheel = p.ROWS[row][0]
        full, cut = float(sizes.tip[wheel]), float(sizes.trimmed[wheel])
        tips = float(p.internal_pair(task.scheme, sizes, teeth, row).tips)
        curvature = float(np.sqrt(full**2 - sizes.base[wheel] ** 2)) / 2
        past = float(p.radial_pair(task.scheme, sizes, np.array(teeth), row))
        yield tips, past, curvature, cut if cut > full * (1 + 1e-12) else np.nan
