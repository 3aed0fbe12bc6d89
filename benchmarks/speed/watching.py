"""From saving a variant to its note on the open page (`solve --watch`), against a cold `solve` of the same.

    python -m benchmarks.speed.watching [NAME ...] [--rounds N] [--store]

Wall time of a program that watches, as the one who saves waits for it: finding out that the file has been written
whole (up to 0.15 s), solving, the note. The first round, which loads everything, is left out. Saves and cold solves
take turns; medians.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from benchmarks.measuring import stored
from tmm_report.commands.watch import ROUND

ROOT = Path(__file__).parents[2]
NAMES = ("shaper", "compressor")
PATIENCE = 120  # s, for a round
SOLVE = (sys.executable, "-m", "tmm_report", "solve")


def shown(page: Path) -> str:
    """What the open page asks for again and again: it changes with every round."""
    return page.read_text("utf-8") if page.exists() else ""


def awaited(page: Path, before: str) -> None:
    end = time.monotonic() + PATIENCE
    while shown(page) in (before, ""):
        if time.monotonic() > end:
            raise TimeoutError(f"no round within {PATIENCE} s")
        time.sleep(0.002)


def measured(name: str, rounds: int) -> tuple[float, float]:
    """Seconds of a round and of a cold solve."""
    text = (ROOT / "variants" / f"{name}.yaml").read_text("utf-8")
    watched: list[float] = []
    cold: list[float] = []
    with TemporaryDirectory() as place:
        file, page = Path(place, "my.yaml"), Path(place, "watched", ROUND)
        file.write_text(text, "utf-8")
        program = subprocess.Popen(
            [*SOLVE, str(file), "-o", str(page.parent), "--watch", "--quiet"], cwd=ROOT
        )
        try:
            awaited(page, "")
            for turn in range(rounds):
                before = shown(page)
                began = time.perf_counter()
                file.write_text(f"{text}# {turn}\n", "utf-8")
                awaited(page, before)
                watched.append(time.perf_counter() - began)
                began = time.perf_counter()
                subprocess.run(
                    [*SOLVE, str(file), "-o", str(Path(place, "cold")), "--quiet"], cwd=ROOT, check=True
                )
                cold.append(time.perf_counter() - began)
        finally:
            program.terminate()
            program.wait()
    return median(watched), median(cold)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("names", nargs="*", default=NAMES, help="ready variants")
    parser.add_argument("--rounds", type=int, default=7, help="saves")
    stored.add_option(parser)
    options = parser.parse_args()
    ratios = {}
    for name in options.names:
        watched, cold = measured(name, options.rounds)
        print(f"{name}: a round {watched:.2f} s, a cold solve {cold:.2f} s")
        ratios[f"{name}, round of --watch : cold solve"] = watched / cold
    stored.report("watching", ratios, options.store)


if __name__ == "__main__":
    main()
