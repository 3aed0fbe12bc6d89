"""A thousand compressor variants on two processes: results.json through the stack against a plain loop over `solve`.

    python -m benchmarks.speed.thousand [N]

Lengths, masses and the speed are drawn by a seed. Every variant is read from its text, solved with all numbers at 12
table and 36 diagram positions, and its results.json (of N/20 variants also its note, HTML) is written to a folder.
Printed, never asserted; the rivals take turns on the same two processes.
"""

from __future__ import annotations

import random
import re
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from time import perf_counter, process_time
from typing import Any, Literal

from tmm_report import render, solve
from tmm_report.loading import loads
from tmm_report.problems import ProblemError
from tmm_report.running.pool import chunked, over
from tmm_report.stack import solve_each

COMPRESSOR = Path(__file__).parents[2] / "variants" / "compressor.yaml"
JOBS, CHUNK, ROUNDS = 2, 32, 2
SPREAD = 0.1  # of every number about its own

Task = tuple[int, str]
Work = Callable[..., Iterator[tuple[int, Any]]]


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    for drive in (False, True):
        tasks = list(enumerate(variants(count, drive)))
        print(
            f"{count} variants, {'with' if drive else 'without'} the gear drive: results.json; notes of {count // 20}"
        )
        _race({"stack": by_stack, "loop": by_loop}, tasks, CHUNK)
        _race({"notes": partial(by_loop, fmt="html")}, tasks[: count // 20], 2)
    print(f"largest process: {_peak():.0f} MB")


def variants(count: int, drive: bool) -> Iterator[str]:
    """Texts of variants: the compressor without its readings, with other lengths, masses and speed."""
    others = "readings", "flywheel", "balancing", *(() if drive else ("drive",))
    text = _without(COMPRESSOR.read_text("utf-8"), *others)
    head, rest = text.split("\nmechanism:")
    mechanism, tail = rest.split("\nloads:")
    draw = random.Random(1)
    for number in range(count):
        own = re.sub(r"(\d[\d.]*)( (?:mm|kg|s)\b)", partial(_drawn, draw), mechanism)
        yield f"{head}\nmechanism:{own}\nloads:{tail}".replace("variant: 1\n", f"variant: {number}\n")


def _drawn(draw: random.Random, found: re.Match[str]) -> str:
    return f"{float(found[1]) * draw.uniform(1 - SPREAD, 1 + SPREAD):.4g}{found[2]}"


def _without(text: str, *blocks: str) -> str:
    for block in blocks:
        text = re.sub(rf"\n{block}:.*?(?=\n\w|\Z)", "", text, flags=re.DOTALL)
    return text


# ---------------------------------------------------------------- what a process does with its variants


def by_stack(tasks: Sequence[Task], folder: Path) -> Iterator[tuple[int, float]]:
    last = process_time()
    for index, found in enumerate(solve_each([loads(text) for _, text in tasks])):
        if isinstance(found, ProblemError):
            raise found
        _keep(render(found, "json"), folder, tasks[index][0])
        now = process_time()
        yield index, now - last
        last = now


def by_loop(
    tasks: Sequence[Task], folder: Path, fmt: Literal["json", "html"] = "json"
) -> Iterator[tuple[int, float]]:
    for index, (number, text) in enumerate(tasks):
        last = process_time()
        _keep(render(solve(loads(text)), fmt), folder, number)
        yield index, process_time() - last


def _keep(files: dict[str, bytes], folder: Path, number: int) -> None:
    for name, content in files.items():
        (folder / f"{number}-{name}").write_bytes(content)


# ---------------------------------------------------------------- the clock


def _race(rivals: Mapping[str, Work], tasks: Sequence[Task], size: int) -> None:
    """The best of a few rounds, in which rivals take turns. "alone": what the processes' own time comes to where
    they are alone on the machine."""
    best: dict[str, tuple[float, float]] = {}
    for turn in range(ROUNDS):
        for name, work in rivals.items():
            taken = _taken(work, tasks, size)
            best[name] = tuple(map(min, taken, best[name])) if turn else taken
    for name, (wall, cpu) in best.items():
        ratio = f"{cpu / best['stack'][1]:8.2f} of the stack" if len(best) > 1 else ""
        print(
            f"  {name:<6}{wall:7.2f} s, alone {cpu / JOBS:6.2f} s: {1e3 * cpu / len(tasks):6.1f} ms a variant "
            f"on one core, {JOBS * len(tasks) / cpu:5.1f} a second{ratio}"
        )


def _taken(work: Work, tasks: Sequence[Task], size: int) -> tuple[float, float]:
    """Wall time from start to end, processes' starting included, and their own time on the tasks, s; of their first
    chunks, in which they are not yet warm, that of the others is taken."""
    start, own = perf_counter(), []
    with tempfile.TemporaryDirectory() as folder:
        for _, seconds in over(
            partial(work, folder=Path(folder)), chunked(tasks, size), jobs=JOBS, seconds=600
        ):
            own.append(seconds)
    warm = own[JOBS * size :] or own
    return perf_counter() - start, sum(warm) * len(tasks) / len(warm)


def _peak() -> float:
    """Of all processes that were run, the most memory that one of them held, MB."""
    import resource

    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


if __name__ == "__main__":
    main()
