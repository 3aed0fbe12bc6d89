"""A measure of work that every machine has: a piece of plain numpy and plain Python, timed in the run of the thing.

400 sums of |e^{ia}·a| over 36 angles, as small arrays as a solve has, and `json.dumps` of 200 lists of ten numbers:
one yardstick, 2.0 ms of CPU time on an idle core of the machine of README.md. What else the machine does slows both.
"""

from __future__ import annotations

import gc
import json
from collections.abc import Callable, Hashable, Mapping
from statistics import median
from time import process_time
from typing import NamedTuple, TypeVar

import numpy as np

K = TypeVar("K", bound=Hashable)
ANGLES = np.arange(36) * (2 * np.pi / 36)
LISTS = [[(row + 1) * np.pi * 10.0**column for column in range(-5, 5)] for row in range(200)]


class Taken(NamedTuple):
    """CPU time of one call: the least and the median of the rounds, both in yardsticks, and the least in ms."""

    least: float
    median: float
    ms: float


def yardstick() -> None:
    for _ in range(400):
        np.abs(np.exp(1j * ANGLES) * ANGLES).sum()
    json.dumps(LISTS)


def in_yardsticks(things: Mapping[K, Callable[[], object]], rounds: int) -> dict[K, Taken]:
    """CPU time of one call of each thing, after one for warming up. In every round each thing stands between two
    yardsticks; the least is set against the least of all yardsticks, the median is that of the ratios of the rounds."""
    times: dict[K, list[float]] = {name: [] for name in things}
    sticks: dict[K, list[float]] = {name: [] for name in things}
    for turn in range(rounds + 1):
        for name, call in things.items():
            before, taken, after = cpu(yardstick), cpu(call), cpu(yardstick)
            if turn:
                times[name].append(taken)
                sticks[name].append((before + after) / 2)
    stick = min(min(own) for own in sticks.values())
    return {
        name: Taken(
            min(own) / stick,
            median(t / s for t, s in zip(own, sticks[name], strict=True)),
            1e3 * min(own),
        )
        for name, own in times.items()
    }


def cpu(call: Callable[[], object]) -> float:
    """CPU time of one call, s; rubbish of the calls before is collected beforehand."""
    gc.collect()
    start = process_time()
    call()
    return process_time() - start
