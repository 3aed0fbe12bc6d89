"""Cost as work grows: positions of one compressor, variants of a stack, kinematics and forces of all.

    python -m benchmarks.speed.growth [--store] [-o docs/charts]

One variant at 12 … 100 000 positions, and 1 … 100 000 variants at 36: nanoseconds a position by the general solver as
a whole, by straight lines in blocks and by numpy written by hand, and the memory that each took at its greatest. Kept
are the greatest balancing moment and the greatest force of the guide. Each measurement is a process of its own.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np

from benchmarks.measuring import stored
from benchmarks.speed import compressor_36
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.many.blocks import blocks
from tmm_report.mechanics.lever.many.compiled import straight

POSITIONS = (12, 36, 100, 1000, 10_000, 100_000)
VARIANTS = (1, 10, 100, 1000, 10_000, 100_000)
WAYS = ("by hand", "general", "in blocks")
MOST_WHOLE = 400_000  # positions that are solved as a whole: beyond them gigabytes
LEAST_TIME = 0.3  # s, of all rounds of a measurement


def scene(axis: str, count: int) -> tuple[compressor_36.Compressor, np.ndarray]:
    if axis == "positions":
        return compressor_36.Compressor(), -np.arange(count) * (2 * np.pi / count)
    k = compressor_36.Compressor() if count == 1 else compressor_36.stack(count)
    return k, -np.arange(36) * (2 * np.pi / 36)


Job = Callable[[], float]


def kept(found: motion.Motion, gravity: complex) -> float:
    forces = statics.solve(found, statics.inertia_and_gravity(found, gravity))
    return greatest(forces.balancing, forces.reactions["0-3"].force)


def greatest(*of: np.ndarray) -> float:
    return max(float(np.max(np.abs(x))) for x in of)


def general(k: compressor_36.Compressor, phi: np.ndarray) -> Job:
    scheme = compressor_36.linkage(k)
    return lambda: kept(motion.solve(scheme, phi), k.gravity)


def in_blocks(k: compressor_36.Compressor, phi: np.ndarray) -> Job:
    scheme = straight(compressor_36.linkage(k))
    return lambda: max(kept(found, k.gravity) for _, found in blocks(scheme, phi))


def by_hand(k: compressor_36.Compressor, phi: np.ndarray) -> Job:
    def run() -> float:
        found = compressor_36.by_hand(k, phi, 0.0, 0.0)
        return greatest(found["balancing"], found["0-3"])

    return run


WAY: dict[str, Callable[[compressor_36.Compressor, np.ndarray], Job]] = dict(
    zip(WAYS, (by_hand, general, in_blocks), strict=True)
)


def measured(way: str, axis: str, count: int) -> tuple[float, float]:
    """CPU time a position, ns, and MB of memory above what the scene and the libraries take."""
    k, phi = scene(axis, count)
    job = WAY[way](k, phi)
    WAY[way](*scene("positions", 12))()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    times: list[float] = []
    while sum(times) < LEAST_TIME or len(times) < 3:
        start = process_time()
        job()
        times.append(process_time() - start)
    positions = phi.size * (count if axis == "variants" else 1)
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    return 1e9 * median(times) / positions, grown / 1024


def in_process(way: str, axis: str, count: int) -> tuple[float, float]:
    call = [sys.executable, "-m", "benchmarks.speed.growth", "--one", way, axis, str(count)]
    return tuple(json.loads(subprocess.run(call, check=True, capture_output=True, text=True).stdout))


def draw(found: dict[tuple[str, str, int], tuple[float, float]], folder: Path) -> None:
    import matplotlib

    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "growth", "svg.fonttype": "none", "font.size": 9})
    from matplotlib import pyplot as plt

    figure, axes = plt.subplots(2, 2, figsize=(8, 5.6), sharex="col", layout="constrained")
    for column, (axis, counts) in enumerate((("positions", POSITIONS), ("variants", VARIANTS))):
        for row, unit in enumerate(("ns a position", "MB above the start")):
            ax = axes[row][column]
            for way, mark in zip(WAYS, "so^", strict=True):
                own = [n for n in counts if (way, axis, n) in found]
                y = [max(found[way, axis, n][row], 0.1) for n in own]
                ax.loglog(own, y, marker=mark, markersize=4, linewidth=1, label=way)
            ax.minorticks_off()
            ax.set_ylim(*((100, 20_000), (0.08, 400))[row])
            ax.grid(True, which="major", linewidth=0.3)
            ax.set_ylabel(unit)
        axes[1][column].set_xlabel(axis if axis == "positions" else "variants at 36 positions")
    axes[0][0].legend(frameon=False)
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / "growth.svg", metadata={"Date": None})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", type=Path, help="folder for growth.svg")
    parser.add_argument("--one", nargs=3, help=argparse.SUPPRESS)
    stored.add_option(parser)
    options = parser.parse_args()
    if options.one:
        way, axis, count = options.one
        print(json.dumps(measured(way, axis, int(count))))
        return
    found: dict[tuple[str, str, int], tuple[float, float]] = {}
    figures: dict[str, float] = {}
    for axis, counts in (("positions", POSITIONS), ("variants", VARIANTS)):
        for count in counts:
            whole = count * (36 if axis == "variants" else 1) <= MOST_WHOLE
            for way in WAYS if whole else WAYS[2:]:
                found[way, axis, count] = in_process(way, axis, count)
                ns, mb = found[way, axis, count]
                print(f"{count:8d} {axis:<10} {way:<10}{ns:12.0f} ns a position{mb:10.1f} MB", flush=True)
                figures[f"{count} {axis}: {way}, MB"] = mb
                if way != WAYS[0] and whole:
                    hand = found[WAYS[0], axis, count][0]
                    figures[f"{count} {axis}: {way} : by hand"] = ns / hand
        first, last = (found[WAYS[2], axis, n][0] for n in counts[-2:])
        figures[f"{axis}: cost of a position at {counts[-1]} : at {counts[-2]}, in blocks"] = last / first
    stored.report("growth", figures, options.store)
    if options.o:
        draw(found, options.o)


if __name__ == "__main__":
    main()
