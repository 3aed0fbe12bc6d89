"""CPU time of what is shipped, as it is shipped, in yardsticks (see yardstick.py).

    python -m benchmarks.speed.shipped [--rounds N] [--store]
    PYTHONPATH=CHECKOUT:. python benchmarks/speed/shipped.py     # of another checkout, say of the commit before

Warm, in one process, things and yardsticks taking turns: `variants/compressor.yaml` with nothing taken out, its solve
alone, with results.json and with the HTML note; the HTML note of crank_rocker; and a variant of a batch through the
stack, from its text to its results.json. Every solve begins with results that nobody has read.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial
from pathlib import Path

from benchmarks.measuring import stored
from benchmarks.measuring.yardstick import Taken, in_yardsticks
from tmm_report import course, load, loading, render, solve
from tmm_report.stack import solve_many

VARIANTS = Path(__file__).parents[2] / "variants"
COMPRESSOR, ROCKER = VARIANTS / "compressor.yaml", VARIANTS / "crank_rocker.yaml"
BATCH = 8
AIMS = {"solve": 12, "solve, results.json": 20, "solve, HTML": 130}


def things() -> dict[str, Callable[[], object]]:
    compressor, rocker = load(COMPRESSOR), load(ROCKER)
    return {
        "load": lambda: load(COMPRESSOR),
        "solve": lambda: solve(compressor),
        "solve, results.json": lambda: render(solve(compressor), "json"),
        "solve, HTML": lambda: render(solve(compressor), "html"),
        "crank_rocker: solve, HTML": lambda: render(solve(rocker), "html"),
        f"a batch of {BATCH}, results.json": partial(_batch, COMPRESSOR.read_text("utf-8")),
    }


def _batch(text: str) -> None:
    """Variants that differ in a length, as students' do."""
    lengths = (f"B: {300 + k} mm" for k in range(BATCH))
    for found in solve_many([loading.loads(text.replace("B: 300 mm", own)) for own in lengths]):
        assert isinstance(found, course.Results)
        render(found, "json")


def told(name: str, taken: Taken) -> str:
    aim = f"   aim {AIMS[name]}" if name in AIMS else ""
    return f"{name:<32}{taken.least:8.1f}{taken.median:8.1f}{taken.ms:10.1f}{aim}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--rounds", type=int, default=15)
    stored.add_option(parser)
    options = parser.parse_args()
    taken = in_yardsticks(things(), options.rounds)
    print(f"{'yardsticks of CPU time':<32}{'least':>8}{'median':>8}{'least, ms':>10}")
    for name, own in taken.items():
        print(told(name, own))
    each = taken[f"a batch of {BATCH}, results.json"].least / BATCH
    print(f"{'of the batch, each variant':<32}{each:8.1f}")
    figures = {f"{name}: yardsticks": own.least for name, own in taken.items()}
    stored.report("shipped", figures | {"a variant of the batch: yardsticks": each}, options.store)


if __name__ == "__main__":
    main()
