"""The scale of the drawing of a planetary stage from the front."""

from __future__ import annotations

from tmm_report.mechanics.gears.planetary.search import Task
from tmm_report.mechanics.gears.planetary.stage import INTERNAL, Sizes

ACROSS = 155.0  # mm of paper that the stage may fill
RIM = 2.5  # thickness of a ring's rim beyond the roots, modules
SCALES = (1, 2, 2.5, 4, 5)  # of reduction and enlargement, with powers of ten


def reach(task: Task, sizes: Sizes) -> float:
    """Radius of what is drawn, m."""
    outer = [float(sizes.overall) / 2]
    rows = zip(task.scheme.rows, (0, 3), task.modules, strict=True)
    outer += [float(sizes.root[wheel]) / 2 + RIM * m for kind, wheel, m in rows if kind == INTERNAL]
    return max(outer)


def scale(task: Task, sizes: Sizes) -> float:
    """Metres in a millimetre of paper: the standard scale at which the stage is largest."""
    least = 2 * reach(task, sizes) / ACROSS * 1e3  # of reduction
    steps = sorted(step * 10.0**power for step in SCALES for power in range(-3, 4))
    steps += [1 / step for step in steps]
    return min(step for step in steps if step >= least * (1 - 1e-9)) / 1e3
