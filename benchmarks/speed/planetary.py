"""Planetary stage: time to judge a million candidates, against sorting as many numbers.

    python -m benchmarks.speed.planetary

Printed, never asserted. The candidates are all combinations of teeth of a scheme, as `search` meets them.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from benchmarks.measuring.timing import interleaved
from tmm_report.mechanics.gears.planetary.search import Task, candidates, search
from tmm_report.mechanics.gears.planetary.stage import SCHEMES


def main() -> None:
    print("scheme                 candidates    search, s    sort, s    search : sort")
    for name, scheme in SCHEMES.items():
        task = Task(scheme, 6.6 if name == "sun-ring" else 14.0, (5e-3, 5e-3), "wheel1", "carrier")
        task = replace(task, external=(12, 110), rings=(20, 360))
        count = candidates(task).shape[1]
        numbers = np.random.default_rng(1).random(count)
        taken = interleaved({"search": lambda t=task: search(t), "sort": lambda x=numbers: np.sort(x)}, 5)
        ratio = taken["search"] / taken["sort"]
        print(f"{name:22} {count:10}    {taken['search']:9.3f}    {taken['sort']:7.3f}    {ratio:13.1f}")


if __name__ == "__main__":
    main()
