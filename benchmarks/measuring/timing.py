"""Fair timing on a busy machine: the rivals take turns, A B A B ..., and medians are compared."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from statistics import median
from time import perf_counter
from typing import TypeVar

K = TypeVar("K", bound=Hashable)


def interleaved(rivals: Mapping[K, Callable[[], object]], rounds: int) -> dict[K, float]:
    """Median wall time of one call of each rival, s, over `rounds` rounds after one for warming up."""
    times: dict[K, list[float]] = {name: [] for name in rivals}
    for turn in range(rounds + 1):
        for name, call in rivals.items():
            start = perf_counter()
            call()
            if turn:
                times[name].append(perf_counter() - start)
    return {name: median(taken) for name, taken in times.items()}
