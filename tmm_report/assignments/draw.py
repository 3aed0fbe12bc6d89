"""Variants drawn from ranges by a seed: row k is the same however many rows are asked for, and no two are alike."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field

import numpy as np

from tmm_report.assignments.model import Ranges
from tmm_report.assignments.numbers import Cell
from tmm_report.assignments.prove import Rejection
from tmm_report.problems import N_, Message, Problem, ProblemError
from tmm_report.records import dataclass

TRIES = 500  # of one row
DRAWS = 2000  # random draws of a row, those met before among them
SEARCHED = 100_000  # ranges of so many variants are searched to the end where draws find no more

Choice = tuple[int, ...]
"""A variant by the numbers of its options."""

Rejects = Callable[[int, Mapping[str, Cell]], Rejection | None]
"""Why the row with this number cannot have these values."""


@dataclass(eq=False)
class Draw:
    """What has been tried so far."""

    ranges: Ranges
    seen: set[Choice] = field(default_factory=set)
    found: int = 0
    reasons: Counter[str] = field(default_factory=Counter)
    words: dict[str, Message] = field(default_factory=dict)

    @property
    def rejected(self) -> int:
        return self.reasons.total()

    @property
    def tries(self) -> int:
        return self.found + self.rejected

    def reject(self, why: Rejection) -> None:
        self.reasons[why.kind] += 1
        self.words.setdefault(why.kind, why.why)

    def listed(self, most: int = 8) -> list[tuple[int, Message]]:
        """How many were rejected, and why, the most frequent first."""
        order = sorted(self.reasons.items(), key=lambda item: (-item[1], item[0]))
        return [(count, self.words[kind]) for kind, count in order[:most]]


def held(ranges: Ranges) -> int:
    """How many different variants the ranges hold."""
    return math.prod(len(parameter.options) for parameter in ranges.drawn)


def rows(draw: Draw, count: int, seed: int, rejects: Rejects) -> Iterator[Mapping[str, Cell]]:
    """The values of rows 1 … count, each accepted by `rejects`. Raises ProblemError where there are not so many.

    Different rows differ in one parameter at least, by a step at least.
    """
    if count > held(draw.ranges):
        raise ProblemError([_too_few(draw, count)])
    for number in range(1, count + 1):
        yield _row(draw, number, count, seed, rejects)


def _row(draw: Draw, number: int, count: int, seed: int, rejects: Rejects) -> Mapping[str, Cell]:
    fresh = _candidates(draw, number, seed)
    for choice in itertools.islice(fresh, TRIES):
        draw.seen.add(choice)
        cells = draw.ranges.cells(choice)
        why = rejects(number, cells)
        if why is None:
            draw.found += 1
            return cells
        draw.reject(why)
    raise ProblemError([_none_left(draw, number, count), *_reasons(draw)])


def _candidates(draw: Draw, number: int, seed: int) -> Iterator[Choice]:
    """Variants not tried yet, at random; where nearly all have been tried, the rest in their order.

    The raw numbers of PCG64 are the same in every version of numpy; its distributions are not promised to be.
    """
    counts = [len(parameter.options) for parameter in draw.ranges.drawn]
    bits = np.random.PCG64(np.random.SeedSequence([seed, number]))
    for _ in range(DRAWS):
        choice = tuple(int(raw) % n for raw, n in zip(bits.random_raw(len(counts)), counts, strict=True))
        if choice not in draw.seen:
            yield choice
    if held(draw.ranges) <= SEARCHED:
        everything = itertools.product(*map(range, counts))
        yield from (choice for choice in everything if choice not in draw.seen)


# ---------------------------------------------------------------- where there are not so many


_WIDEN = Message(N_("widen the ranges, take smaller steps or ask less of the variants"))


def _too_few(draw: Draw, count: int) -> Problem:
    text = N_("the ranges hold %(held)s different variants, %(asked)s are asked for")
    return Problem(Message(text, {"held": held(draw.ranges), "asked": count}), _WIDEN, file=draw.ranges.file)


def _none_left(draw: Draw, number: int, count: int) -> Problem:
    values = {
        "held": held(draw.ranges),
        "found": draw.found,
        "asked": count,
        "tries": TRIES,
        "number": number,
    }
    if len(draw.seen) == held(draw.ranges):
        text = N_(
            "of %(held)s different variants that the ranges hold %(found)s can be set, %(asked)s are asked for"
        )
    else:
        text = N_("no variant %(number)s of %(asked)s was found in %(tries)s tries")
    return Problem(Message(text, values), _WIDEN, file=draw.ranges.file)


def _reasons(draw: Draw) -> Iterator[Problem]:
    """What rejected how many, the most frequent first."""
    text = N_("%(count)s of %(tries)s tries rejected: %(why)s")
    for count, why in draw.listed():
        values = {"count": count, "tries": draw.tries, "why": why}
        yield Problem(Message(text, values), file=draw.ranges.file)
