"""Speed against accuracy: every method on mechanisms of classes II to IV, as `tmm-report methods` compares them.

    python -m benchmarks.accuracy.methods [VARIANT ...] [-o docs/charts/methods.svg] [--quick] [--store]

Times are by that of the closed form at as many positions; errors are against 40 digits, the worst of places,
velocities and accelerations of all points, or of reactions and the balancing moment. One mark a count: 12, 36, 100
positions a turn.
"""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterator
from pathlib import Path

from benchmarks.measuring import stored
from benchmarks.measuring.lines import Line, Panel, draw
from tmm_report import course, loading
from tmm_report.commands.methods.measured import Measured, measured
from tmm_report.mechanics.rivals.model import Trial
from tmm_report.mechanics.rivals.trials import worst

VARIANTS = Path(__file__).parents[2] / "variants"
SHOWN = ("compressor", "quick_return", "crank_rocker", "press")
DRAWN = 2  # of them
KEPT = 36  # positions a turn whose figures are stored
CLOSED = "groups"


def families(name: str, quick: bool) -> Iterator[Measured]:
    found = measured(course.solve(loading.load(VARIANTS / f"{name}.yaml")), 1e-6, False, quick)
    yield from (one for one in found.families if one.key in ("motion", "forces"))


def compared(family: Measured) -> dict[tuple[str, int], tuple[Trial, float]]:
    """Of each method and count the trial and its time by the closed form's."""
    own = {one.count: one.seconds for one in family.trials if one.method.key == CLOSED}
    return {(one.method.key, one.count): (one, one.seconds / own[one.count]) for one in family.trials}


def figures(name: str, family: Measured) -> dict[str, float]:
    found = {}
    for (key, count), (trial, ratio) in compared(family).items():
        if count == KEPT and trial.broken is None and math.isfinite(worst(trial.errors)):
            found[f"{name}: {family.key}: {key}: time"] = ratio
            found[f"{name}: {family.key}: {key}: error"] = worst(trial.errors)
    return found


def panel(name: str, family: Measured) -> Panel:
    lines: dict[str, list[tuple[float, float]]] = {}
    for (key, _), (trial, ratio) in compared(family).items():
        if trial.broken is None:
            title = key.replace("_", " ") + (" mm" if key.startswith("drawing") else "")
            lines.setdefault(title, []).append((ratio, worst(trial.errors)))
    return Panel(
        f"{name.replace('_', ' ')}: {family.key}", "time : closed form", "worst relative error",
        [Line(title, points) for title, points in lines.items()], limits=(None, (1e-17, 1.0)),
    )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("variants", nargs="*", default=SHOWN, help="names in variants/")
    parser.add_argument("-o", dest="chart", type=Path, help="draw the chart, SVG")
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    stored.add_option(parser)
    asked = parser.parse_args()
    each = [(name, one) for name in asked.variants for one in families(name, asked.quick)]
    stored.report("methods", {k: v for name, one in each for k, v in figures(name, one).items()}, asked.store)
    if asked.chart:
        panels = [panel(name, one) for name, one in each if one.key == "motion"]
        draw(panels[:DRAWN], asked.chart, height=4.6)


if __name__ == "__main__":
    main()
