"""Rivals in turns by CPU time: a busy machine stretches the wall time of what is long more than of what is short."""

from __future__ import annotations

import resource
from collections.abc import Callable, Mapping
from statistics import median
from time import process_time


def in_turns(
    rivals: Mapping[str, Callable[[], object]], rounds: int, clock: Callable[[], float] = process_time
) -> dict[str, float]:
    """Median CPU time of one call of each rival, s, over `rounds` rounds after one for warming up."""
    times: dict[str, list[float]] = {name: [] for name in rivals}
    for turn in range(rounds + 1):
        for name, call in rivals.items():
            start = clock()
            call()
            if turn:
                times[name].append(clock() - start)
    return {name: median(taken) for name, taken in times.items()}


def of_children() -> float:
    """CPU time of the processes that this one has started and seen end, s."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
