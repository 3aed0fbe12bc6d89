"""Whether `tmm-report methods` names the same method at every run on a machine that does other things too.

    python -m benchmarks.accuracy.same_winner    # ten scenes, four runs each, beside two busy processes

Prints, for each thing that methods are compared for, what was named and how often, and how many of the winners changed.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing import Process
from pathlib import Path

from tmm_report import load, solve
from tmm_report.commands.methods.measured import measured
from tmm_report.mechanics.rivals.choice import ACCURACY

VARIANTS = Path(__file__).resolve().parents[2] / "variants"
SCENES = (
    "compressor", "crank_rocker", "grain_screen", "hay_press", "hoist_drive", "piston_pump", "quick_return", "shaper",
    "slotter", "tram_start",
)  # fmt: skip


def busy() -> None:
    while True:
        sum(k * k for k in range(10_000))


@contextmanager
def beside(processes: int) -> Iterator[None]:
    others = [Process(target=busy, daemon=True) for _ in range(processes)]
    for one in others:
        one.start()
    try:
        yield
    finally:
        for one in others:
            one.terminate()


def named(scene: str, quick: bool) -> dict[str, str]:
    found = measured(solve(load(VARIANTS / f"{scene}.yaml")), ACCURACY, False, quick)
    return {
        family.key: f"{family.best.method.key} {family.best.count}" if family.best else "none"
        for family in found.families
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=4)
    parser.add_argument("--busy", type=int, default=2)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    changed = asked = 0
    with beside(options.busy):
        for scene in SCENES:
            runs = [named(scene, options.quick) for _ in range(options.runs)]
            for key in runs[0]:
                counted = Counter(run[key] for run in runs)
                asked, changed = asked + 1, changed + (len(counted) > 1)
                print(
                    f"{scene:16} {key:10}",
                    ", ".join(f"{name} ×{n}" for name, n in counted.items()),
                    flush=True,
                )
    print(f"{changed} of {asked} winners changed between {options.runs} runs")


if __name__ == "__main__":
    main()
