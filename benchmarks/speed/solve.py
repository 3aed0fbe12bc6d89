"""A warm `solve` of the compressor, part by part, against one motion of 36 positions: how many motions a solve costs.

    python -m benchmarks.speed.solve

Medians of rounds taking turns in one process. Printed, never asserted.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

import tmm_report
from benchmarks.measuring.timing import interleaved
from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.lever.force_plans import solve as force_plans
from tmm_report.chapters.lever.kinematics.solve import positions as kinematics
from tmm_report.chapters.lever.kinetostatics.solve import positions as kinetostatics
from tmm_report.chapters.lever.plans import solve as plans

COMPRESSOR = Path(__file__).parents[2] / "variants" / "compressor.yaml"
ROUNDS = 30


def main() -> None:
    variant = tmm_report.load(COMPRESSOR)
    found = tmm_report.solve(variant)
    turned = np.arange(36) * (2 * np.pi / 36)
    given, lever = variant.lever, found.lever
    positions, drawing = given.positions, given.drawing
    parts = {
        "motion of 36 positions": lambda: lever.kinematics.cycle.motion(turned),
        "kinematics": lambda: kinematics.solve(positions, lever.structure),
        "plans": lambda: plans.solve(drawing, positions.plans, lever.kinematics),
        "kinetostatics": lambda: kinetostatics.solve(given.loads, lever.kinematics),
        "force plans": lambda: force_plans.solve(
            drawing, positions.force_plan, lever.kinetostatics, lever.plans
        ),
        "gear drive": lambda: drive.solve(variant.drive),
        "all": lambda: tmm_report.solve(variant),
        "all, and results.json": lambda: tmm_report.render(tmm_report.solve(variant), "json"),
    }
    taken = interleaved(parts, ROUNDS)
    for name, seconds in taken.items():
        print(f"{name:<24}{1e3 * seconds:8.2f} ms{seconds / taken['motion of 36 positions']:8.1f}")


if __name__ == "__main__":
    main()
