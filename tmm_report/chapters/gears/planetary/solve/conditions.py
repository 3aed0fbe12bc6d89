"""The conditions of the chosen teeth: the value, the limit, what is in hand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Literal, NamedTuple

import numpy as np

from tmm_report.chapters.gears.planetary.solve.meshes import Rows
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import LEAST_CONTACT, Task

Key = Literal["ratio", "undercut", "tips", "radial", "contact", "gap"]


class Condition(NamedTuple):
    """`wheels`: places, among the teeth, of those concerned; value and limit in `unit`; `least`: whether the value must
    be above the limit."""

    key: Key
    wheels: tuple[int, ...]
    value: float
    limit: float
    unit: str = ""
    least: bool = True

    @property
    def margin(self) -> float:
        """What is in hand."""
        return self.value - self.limit if self.least else self.limit - self.value


def conditions(task: Task, teeth: Sequence[int], k: int, sizes: p.Sizes, rows: Rows) -> Iterator[Condition]:
    """In the order of the note."""
    ratio = float(p.stage_ratio(p.basic_ratio(task.scheme, teeth), task.input, task.output))
    yield Condition("ratio", (), 100 * abs(ratio / task.ratio - 1), 100 * task.tolerance, "%", least=False)
    for wheel in _outside(task.scheme):
        yield Condition(
            "undercut", (wheel,), teeth[wheel], float(p.least_teeth(task.rack, sizes.shifts[wheel]))
        )
    for row in rows.rings:
        yield Condition("tips", (p.ROWS[row][0],), float(np.degrees(rows.tips[row])), 0.0, "deg")
        yield Condition("radial", (p.ROWS[row][0],), float(np.degrees(rows.radial[row])), 0.0, "deg")
    for row, pair in enumerate(((0, 1), (2, 3))):
        yield Condition("contact", pair, float(rows.contact[row]), LEAST_CONTACT)
    yield Condition("gap", (), float(p.neighbourhood_gap(sizes, k)), 0.0, "m")


def _outside(scheme: p.Scheme) -> list[int]:
    """Wheels with external teeth, the crown of a single row once."""
    wheels = [k for k, kind in enumerate(p.kinds(scheme)) if kind == p.EXTERNAL]
    return [k for k in wheels if k != 2 or not scheme.single]
