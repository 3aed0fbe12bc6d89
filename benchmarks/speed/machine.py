"""What each chapter of the machine in motion adds to a warm `solve`, against a solve of the compressor.

    python -m benchmarks.speed.machine

Each chapter on every ready variant that has it; medians of rounds taking turns in one process. Printed, never asserted.
"""

from __future__ import annotations

from dataclasses import fields, replace
from functools import partial
from pathlib import Path

import tmm_report
from benchmarks.measuring.timing import interleaved
from tmm_report.course import Variant

VARIANTS = Path(__file__).parents[2] / "variants"
BEFORE = ("lever", "drive", "eccentric", "title", "language", "decimal_sign", "places", "file")
ROUNDS = 9


def asked(variant: Variant) -> list[str]:
    """Names of the chapters of the machine in motion that a variant has."""
    return [one.name for one in fields(variant) if one.name not in BEFORE and getattr(variant, one.name)]


def added(variant: Variant) -> dict[str, float]:
    """Seconds that each of its chapters adds to the rest of the solve."""
    rivals = {"": partial(tmm_report.solve, variant)}
    rivals |= {name: partial(tmm_report.solve, replace(variant, **{name: None})) for name in asked(variant)}
    taken = interleaved(rivals, ROUNDS)
    return {name: taken[""] - taken[name] for name in rivals if name}


def main() -> None:
    compressor = replace(tmm_report.load(VARIANTS / "compressor.yaml"), flywheel=None, balancing=None)
    unit = interleaved({"": partial(tmm_report.solve, compressor)}, ROUNDS)[""]
    print(f"the compressor without flywheel and balancing: {1e3 * unit:.1f} ms")
    print(f"{'variant':<24}{'chapter':<14}{'ms':>9}{'of the compressor':>20}")
    for file in sorted(VARIANTS.glob("*.yaml")):
        for name, seconds in added(tmm_report.load(file)).items():
            print(f"{file.stem:<24}{name:<14}{1e3 * seconds:9.1f}{seconds / unit:20.2f}")


if __name__ == "__main__":
    main()
