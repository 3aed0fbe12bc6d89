"""Groups of class III and IV: following a group over the turn, then 36 positions; a mechanism of dyads beside.

    python -m benchmarks.speed.higher [--store]

Printed, never asserted. "first" assembles the mechanism, follows its groups from the sketch all round and solves 36
positions; "again" solves 36 further positions from the nodes kept. Ratios are to the compressor, dyads alone, in the
same run. "random" are mechanisms of `random_groups`, "chain" groups of class III, each driven by the one before it.
"""

from __future__ import annotations

import argparse
import tracemalloc
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from time import perf_counter

import numpy as np

from benchmarks.measuring import stored
from benchmarks.measuring.timing import interleaved
from benchmarks.random_groups.draw import FAMILIES
from benchmarks.random_groups.families import drawn
from tmm_report.loading import load, loads
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.mechanism import Driver, Link, Mechanism
from tmm_report.problems import ProblemError

VARIANTS = Path(__file__).parents[2] / "variants"
NAMES = ("compressor", "quick_return", "press")  # dyads alone, class III, class IV
FEW = np.arange(36) * (2 * np.pi / 36)
EACH = 16  # mechanisms of a family
SEED = 3
COUNTS = (12, 100, 1000, 10_000, 100_000)
CHAIN = {"B": 0.5 + 0.1j, "C": 0.9 + 0.5j, "D": 0.9 - 0.3j, "E": 0.5 + 1.1j, "F": 1.4 - 0.9j, "P": 1.3 + 0.1j}


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    stored.add_option(parser)
    args = parser.parse_args()
    figures = {**ready(), **chains(), **families(), **growth()}
    stored.report("higher", figures, args.store)


def first(mechanism: Mechanism) -> object:
    return motion.solve(assemble(mechanism), FEW)


def ready() -> dict[str, float]:
    """The ready variants, ms and by the compressor's time."""
    made = {name: load(VARIANTS / f"{name}.yaml").lever.mechanism for name in NAMES}
    rivals = {f"{name}, first": partial(first, m) for name, m in made.items()}
    for name, m in made.items():
        linkage = assemble(m)
        motion.solve(linkage, FEW)
        rivals[f"{name}, 36 again"] = partial(motion.solve, linkage, FEW)
    taken = interleaved(rivals, 30)
    return {
        key: value
        for name in NAMES[1:]
        for what in ("first", "36 again")
        for key, value in _both(f"{name}, {what}", taken[f"{name}, {what}"], taken[f"compressor, {what}"])
    }


def _both(name: str, seconds: float, by: float) -> Iterator[tuple[str, float]]:
    yield f"{name} : dyads", seconds / by
    yield f"{name}, ms", 1e3 * seconds


def chains() -> dict[str, float]:
    """Groups of class III behind one another, by one of them."""
    taken = interleaved({str(n): partial(first, chain(n)) for n in (1, 2, 4)}, 10)
    return {f"chain of {n}, first : one group": taken[n] / taken["1"] for n in ("2", "4")}


def chain(count: int) -> Mechanism:
    """So many groups, each a ternary link on three rods: one on the link before, two on the frame."""
    frame, links = {"O": 0j}, {}
    start, before = 0.08 + 0j, "1"
    points: dict[str, dict[str, complex]] = {"1": {"O": 0j, "P0": start}}
    for n in range(count):
        at = {f"{name}{n}": start + x for name, x in CHAIN.items() if name != "P"}
        tip = {f"P{n + 1}": start + CHAIN["P"]}
        frame |= {name: at[name] for name in (f"E{n}", f"F{n}")}
        points[f"T{n}"] = {name: at[name] for name in (f"B{n}", f"C{n}", f"D{n}")} | tip
        points[f"a{n}"] = {f"P{n}": start, f"B{n}": at[f"B{n}"]}
        points[f"b{n}"] = {name: at[name] for name in (f"E{n}", f"C{n}")}
        points[f"c{n}"] = {name: at[name] for name in (f"F{n}", f"D{n}")}
        start, before = start + CHAIN["P"], f"T{n}"
    points.setdefault(before, {})
    links = {name: Link(name, at, 1.0, None, 0.0) for name, at in {"0": frame, **points}.items()}
    sketch = {p: x for at in (frame, *points.values()) for p, x in at.items()}
    return Mechanism(links, Driver("1", 1.0), {}, (), sketch=sketch)


def families() -> dict[str, float]:
    """Median and 95 % of the first solution of random mechanisms, by the compressor's, and in ms."""
    dyads = load(VARIANTS / "compressor.yaml").lever.mechanism
    alone = interleaved({"": partial(first, dyads)}, 30)[""]
    found: dict[str, float] = {}
    for family in FAMILIES:
        times = []
        batch = drawn(family, EACH, SEED)
        for lane in range(EACH):
            mechanism = loads(batch.file(lane)).lever.mechanism
            try:
                times.append(interleaved({"": partial(first, mechanism)}, 3)[""])
            except ProblemError:  # a sketch in a singular position, told in words
                continue
        median, most = np.median(times), np.quantile(times, 0.95)
        found |= {
            f"random {family}, median : dyads": median / alone,
            f"random {family}, 95 % : dyads": most / alone,
            f"random {family}, median, ms": 1e3 * median,
        }
    return found


def growth() -> dict[str, float]:
    """µs and bytes a position as their number grows, class III."""
    linkage = assemble(load(VARIANTS / "quick_return.yaml").lever.mechanism)
    motion.solve(linkage, FEW)
    found = {}
    for count in COUNTS:
        phi = np.linspace(0, 2 * np.pi, count, endpoint=False)
        times = []
        for _ in range(5):
            begin = perf_counter()
            motion.solve(linkage, phi)
            times.append(perf_counter() - begin)
        found[f"{count} positions again, us each"] = 1e6 * float(np.median(times)) / count
    tracemalloc.start()
    motion.solve(linkage, phi)
    found[f"{COUNTS[-1]} positions again, bytes each"] = tracemalloc.get_traced_memory()[1] / COUNTS[-1]
    tracemalloc.stop()
    return found


if __name__ == "__main__":
    np.seterr(all="ignore")
    main()
