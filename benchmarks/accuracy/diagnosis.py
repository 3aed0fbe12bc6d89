"""Planted mistakes and how many are named rightly: 2000 students' works, of every kind alike and of none.

    python -m benchmarks.accuracy.diagnosis [HOW_MANY]

Printed, never asserted. A mistake is named rightly when it is the only one named, with what belongs to it (steps,
factor, whose variant), on more than half of the columns that it made wrong and on none that it was not made in. "two"
are works with two mistakes in different columns.
"""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "judging"))
from planted import LIMIT, MAKERS, Plant, Work, World, planted

from tmm_report.grading.model import Cause
from tmm_report.judging.diagnose import diagnose, prepared

TWO = (("mm for m", "swapped"), ("sign", "rpm for rad/s"), ("scale", "power of ten"), ("component", "sign"))


def main(count: int) -> None:
    world, rng = World.made(), np.random.default_rng(2026)
    everyone = prepared({id: one for family in world.variants.values() for id, one in family.items()})
    tries: list[tuple[str, ...]] = [(), *((kind,) for kind in MAKERS), *TWO]
    tried, right, seconds, cells, off = Counter(), Counter(), [], 0, 0
    missed: Counter[str] = Counter()
    for k in range(count):
        kinds = tries[k % len(tries)]
        work = planted(world, rng, *kinds)
        judged = work.judged()
        start = perf_counter()
        causes = diagnose(work.answers, work.expected, judged, limit=LIMIT, others=everyone)
        seconds.append(perf_counter() - start)
        name = "two" if len(kinds) > 1 else (kinds or ("none",))[0]
        tried[name] += 1
        right[name] += named(work, causes)
        if not named(work, causes):
            missed[
                f"{' + '.join(kinds) or 'none'} -> {' + '.join(sorted(c.kind for c in causes)) or 'nothing'}"
            ] += 1
        if not kinds:
            cells += sum(int(one.asked.sum()) for one in judged.values())
            off += sum(
                int((one.asked & work.answers.columns[n].given & ~one.ok).sum()) for n, one in judged.items()
            )
    for name in tried:
        print(f"{name:20} {right[name]:4} of {tried[name]:4}  {100 * right[name] / tried[name]:5.1f} %")
    print(f"all {100 * sum(right.values()) / count:.1f} %; honest cells judged wrong: {off} of {cells}")
    print(f"a work: median {1e3 * median(seconds):.1f} ms, longest {1e3 * max(seconds):.1f} ms")
    for what, times in missed.most_common(20):
        print(f"  {times:3} {what}")


def named(work: Work, causes: list[Cause]) -> bool:
    """Whether just the planted mistakes are named."""
    return len(causes) == len(work.plants) and all(any(same(p, c) for c in causes) for p in work.plants)


def same(plant: Plant, cause: Cause) -> bool:
    """Whether a cause is the mistake planted."""
    names = set(cause.names)
    told = cause.kind == plant.kind and (cause.detail == plant.detail or cause.kind in ("scale", "swapped"))
    return told and len(names & plant.names) > len(plant.names) / 2 and names <= plant.among


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2000)
