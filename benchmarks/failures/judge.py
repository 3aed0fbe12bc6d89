"""Cells of the table: right, an honest refusal, or wrong without a word.

A number is right if it is off by no more than 1e-6 of the largest value of its quantity over the positions, or by no
more than ten conditioning bounds, nor than a hundredth; of a method that is approximate everywhere, by no more than ten
times what it is off on a harmless scene. A refusal is nan, an exception, or a sentence. A number where there is none, a
motion through a gap of which nothing is said, another assembly: wrong.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from benchmarks.failures.scenes import CORNER, NOWHERE
from benchmarks.failures.truth import MOST, SLACK, Key, Truth, finite

RIGHT, REFUSED, WRONG, NONE = "right", "refused", "wrong", "–"
Found = Mapping[Key, np.ndarray]  # quantity -> values by position


@dataclass(frozen=True)
class Cell:
    """`error`: the worst of what is right, or of what is wrong, over the quantity's size; `word`: of a refusal or of
    what is wrong."""

    verdict: str
    error: float = 0.0
    word: str = ""

    @property
    def text(self) -> str:
        """In full."""
        size = f"{self.error:.0e}" if self.error else "exact"
        if self.verdict == RIGHT:
            return f"right, {size}" + (f"; {self.word}" if self.word else "")
        if self.verdict == WRONG:
            return f"**wrong** {self.word or size}"
        return (f"the rest right, {size}; {self.word}" if self.error else self.word) if self.word else NONE

    @property
    def short(self) -> str:
        if self.verdict == RIGHT:
            return f"{self.error:.0e}" if self.error else "exact"
        if self.verdict == WRONG:
            return "**wrong**" + (f" {self.error:.0e}" if self.error else "")
        return "refuses" if self.verdict == REFUSED else NONE


def judged(
    truth: Truth,
    found: Found,
    kinds: tuple[str, ...],
    said: str = "",
    usual: Mapping[str, float] | None = None,
) -> Cell:
    """`said`: what was said beside the numbers, which excuses none of them; `usual`: error by kind of a method that is
    approximate everywhere."""
    wrong, right, lost, made_up = 0.0, 0.0, set(), set()
    size, compared = len(truth.angles), 0
    for key, values in found.items():
        if key[0] not in kinds:
            continue
        for k in range(size):
            value = complex(np.broadcast_to(values, (size,))[k])
            if key not in truth.at[k]:
                if finite(value) and _changes(truth, key, k):
                    made_up.add(k)
                continue
            if not finite(value):
                lost.add(k)
                continue
            compared += 1
            off = truth.off(k, key, value)
            slack = max(SLACK, 10 * (usual or {}).get(key[0], 0.0))
            if off <= slack or off <= min(MOST, truth.allowed(k, key)):
                right = max(right, off)
            else:
                wrong = max(wrong, off)
    if wrong:
        return Cell(WRONG, wrong)
    if made_up:
        return Cell(WRONG, 0.0, f"{len(made_up)} positions that are none")
    if truth.scene.told and "place" in kinds and not said and not lost:
        return Cell(WRONG, 0.0, f"no word of {truth.scene.told}")
    if not lost and not compared:
        return Cell(NONE)
    nowhere = sum(root in (NOWHERE, CORNER) for root in truth.roots)
    if lost:
        nothing = f"nan at {len(lost)} of {size - nowhere}"
        return Cell(REFUSED, right, f"{nothing}; {said}" if said else nothing)
    return Cell(RIGHT, right, said)


def _changes(truth: Truth, key: Key, k: int) -> bool:
    """Whether a number at a position where nothing is true can be wrong: of what moves; in a corner of rates alone."""
    if truth.roots[k] == CORNER and key[0] == "place":
        return False
    known = [values[key] for values in truth.at if key in values]
    return (
        bool(known)
        and any(abs(one - known[0]) > 1e-9 * truth.sizes[key] for one in known)
        and not _driven(truth, key)
    )


def _driven(truth: Truth, key: Key) -> bool:
    """Points of the frame and of the driving link are where they are in any case."""
    m = truth.mechanism
    return key[1] in m.links["0"].points or key[1] in m.links[m.driver.link].points


def usual_errors(truth: Truth, found: Found) -> dict[str, float]:
    """By kind, the worst error on a harmless scene."""
    worst: dict[str, float] = {}
    for key, values in found.items():
        for k in range(len(truth.angles)):
            value = complex(np.broadcast_to(values, (len(truth.angles),))[k])
            if key in truth.at[k] and finite(value):
                worst[key[0]] = max(worst.get(key[0], 0.0), truth.off(k, key, value))
    return worst
