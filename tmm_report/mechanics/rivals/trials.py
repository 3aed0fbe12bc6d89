"""Rivals tried on one scene: the errors of each against an exact value, and the time of each, taken in turns.

rivals = Rivals(MOTIONS, cycle, errors_of, (12, 36, 100))
found = trials(rivals, seconds=3.0)
best = cheapest(found, 1e-6)
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import groupby
from time import perf_counter, process_time
from typing import Any, Generic, TypeVar

import numpy as np

from tmm_report.mechanics.lever.forces.reactions import Statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.model import Found, Method, Pair, Scene, Trial
from tmm_report.problems import Message
from tmm_report.records import dataclass

Array = Any

COUNTS = (12, 36, 100)  # positions of a turn at which rivals are tried
ROUNDS = 31  # of taking turns, at most
SAMPLE, MOST_REPEATS = 5e-4, 50  # seconds of one reading of the clock, made up of so many runs at most
NEAR = 1.6  # times within this ratio are measured again before a winner is named
SAME = 1.1  # times within this ratio are equal: which of the two is less is chance
# of this process alone, whatever else the machine does; on Windows it ticks 64 times a second
clock = perf_counter if sys.platform == "win32" else process_time
ROUNDING = 1e-14  # relative: errors below it are rounding, which of two is smaller is chance
NOTHING = 1e-9  # of the largest row: a row that is smaller is rounding, and no error is measured by it
Errors = Mapping[str, float]
J = TypeVar("J", bound="Judged")


@dataclass(frozen=True, eq=False)
class Rivals(Generic[Scene, Found]):
    """Methods for one quantity, their scene, and how what they find is judged: `errors(count, found)` by kinds."""

    methods: Sequence[Method[Scene, Found]]
    scene: Scene
    errors: Callable[[int, Found], Errors]
    counts: Sequence[int] = COUNTS

    @property
    def refused(self) -> list[tuple[Method[Scene, Found], Message]]:
        """The methods that cannot be used on the scene, and why."""
        said = ((method, method.refuses(self.scene)) for method in self.methods)
        return [(method, why) for method, why in said if why is not None]

    @property
    def usable(self) -> list[Method[Scene, Found]]:
        return [method for method in self.methods if method.refuses(self.scene) is None]


# ---------------------------------------------------------------- errors


def tried(rivals: Rivals[Scene, Found]) -> list[Trial]:
    """Every usable method at every count, with its errors; seconds are nan: nothing is timed."""
    return [
        _tried(rivals, method, count if method.counted else 0)
        for count in rivals.counts
        for method in rivals.usable
        if method.counted or count == rivals.counts[0]
    ]


def _tried(rivals: Rivals[Scene, Found], method: Method[Scene, Found], count: int) -> Trial:
    """One method at one count. What breaks down has no errors."""
    try:
        with np.errstate(all="ignore"):
            errors = dict(rivals.errors(count, method.run(rivals.scene, count)))
    except ArithmeticError as error:  # LinAlgError is none, but ValueError
        return Trial(method, count, math.nan, {}, str(error) or type(error).__name__)
    return Trial(method, count, math.nan, errors)


def motion_rows(motion: Motion) -> dict[str, Array]:
    """What is compared of a motion, by kinds: rows of points, (N, P), m, m/s, m/s²."""
    return {"place": motion.places, "velocity": motion.velocities, "acceleration": motion.accelerations}


def force_rows(pairs: Sequence[str], found: Statics) -> dict[str, Array]:
    """What is compared of forces, by kinds: reactions in the pairs by their keys, complex N, (Q, P), where the method
    finds reactions; the balancing moment, N m, (1, P)."""
    rows = {"moment": np.atleast_2d(found.balancing)}
    if not found.reactions:
        return rows
    return {"reaction": np.array([found.reactions[key].force for key in pairs]), **rows}


def errors_of(exact: Mapping[str, Pair], rows: Mapping[str, Array]) -> Errors:
    """Largest relative errors by kinds, of the kinds that were found."""
    measures = {"place": error_of_places}
    return {kind: measures.get(kind, error_of)(exact[kind], values) for kind, values in rows.items()}


def error_of(exact: Pair, found: Array) -> float:
    """`Pair.error` over the rows that are more than rounding beside the largest."""
    sizes = np.nanmax(np.abs(exact.high), axis=-1, initial=0.0)
    rows = sizes > NOTHING * np.max(sizes, initial=0.0)
    return Pair(exact.high[rows], exact.low[rows]).error(np.asarray(found)[rows])


def error_of_places(exact: Pair, found: Array) -> float:
    """Largest error of places (N, P), relative to the longest way that a point goes, the larger side of the box it
    keeps to: how far from the origin of axes the mechanism is drawn says nothing of its motion."""
    known = np.isfinite(exact.high)
    sides = (
        np.max(part, axis=-1, where=known, initial=-np.inf)
        - np.min(part, axis=-1, where=known, initial=np.inf)
        for part in (exact.high.real, exact.high.imag)
    )
    way = max((float(np.max(side, initial=0.0)) for side in sides), default=0.0)
    return exact.error(np.asarray(found), np.full((len(exact.high), 1), way))


def doubles(rows: Mapping[str, Array]) -> dict[str, Pair]:
    """Values in double precision that others are judged by."""
    return {kind: Pair(values, np.zeros_like(values)) for kind, values in rows.items()}


def worst(errors: Errors) -> float:
    """The largest error of all kinds; nan where one of them is nan or nothing was found."""
    return float(np.max(list(errors.values()))) if errors else math.nan


# ---------------------------------------------------------------- times


def trials(rivals: Rivals[Scene, Found], seconds: float) -> list[Trial]:
    """Every usable method at every count, its errors and its time: rivals take turns for about so many seconds."""
    found = tried(rivals)
    running = [one for one in found if one.broken is None]
    times = interleaved([_run(rivals, one) for one in running], seconds)
    timed = {id(one): taken for one, taken in zip(running, times, strict=True)}
    return [replace(one, seconds=timed.get(id(one), math.nan)) for one in found]


def run_off(rivals: Rivals[Scene, Found], judged: J, seconds: float) -> J:
    """The same with those timed again that may be the cheapest: a wrong winner is told from noise by them alone."""
    kinds, found = judged.kinds, judged.trials
    good = [
        one for one in judged.candidates if full(one.errors, kinds) and worst(one.errors) <= judged.accuracy
    ]
    least = min((one.seconds for one in good), default=math.nan)
    near = {
        (one.method.key, count)
        for one in good
        if one.seconds <= NEAR * least
        for count in judged.counts(one) or (0,)
    }
    again = [one for one in found if (one.method.key, one.count) in near]
    if len({one.method.key for one in again}) < 2:
        return judged
    times = interleaved([_run(rivals, one) for one in again], seconds)
    timed = {id(one): min(one.seconds, taken) for one, taken in zip(again, times, strict=True)}
    return replace(
        judged, trials=tuple(replace(one, seconds=timed.get(id(one), one.seconds)) for one in found)
    )


def _run(rivals: Rivals[Scene, Found], trial: Trial) -> Callable[[], object]:
    return lambda: trial.method.run(rivals.scene, trial.count)


def interleaved(runs: Sequence[Callable[[], object]], seconds: float) -> list[float]:
    """CPU seconds of each, the least of its samples, all warm. They take turns, so that what else the machine does
    troubles all alike; what is slow is run less often, at least once, and what is quick several times a sample."""
    taken: list[list[float]] = [[] for _ in runs]
    repeats = [1] * len(runs)
    share, end = seconds / max(1, len(runs)), clock() + seconds
    for _ in range(ROUNDS):
        for k, run in enumerate(runs):
            if taken[k] and sum(taken[k]) * repeats[k] > share:
                continue
            taken[k].append(_sample(run, repeats[k]))
            repeats[k] = min(MOST_REPEATS, max(1, math.ceil(SAMPLE / max(min(taken[k]), 1e-9))))
        if clock() > end:
            break
    return [min(own) for own in taken]


def _sample(run: Callable[[], object], repeats: int) -> float:
    start = clock()
    with np.errstate(all="ignore"):
        for _ in range(repeats):
            run()
    return (clock() - start) / repeats


# ---------------------------------------------------------------- what follows


def by_method(found: Sequence[Trial]) -> Iterator[list[Trial]]:
    """The trials of each method, by rising count."""
    order = list(dict.fromkeys(one.method.key for one in found))
    ordered = sorted(found, key=lambda one: (order.index(one.method.key), one.count))
    for _, own in groupby(ordered, key=lambda one: one.method.key):
        yield list(own)


def kinds_of(found: Sequence[Trial]) -> tuple[str, ...]:
    """The kinds of quantities of a family, in their order: what any of its methods finds."""
    return tuple(dict.fromkeys(kind for one in found for kind in one.errors))


def full(errors: Errors, kinds: Sequence[str]) -> bool:
    """Whether all kinds were found, at every position."""
    return bool(kinds) and all(math.isfinite(errors.get(kind, math.nan)) for kind in kinds)


def pareto(found: Sequence[Trial]) -> list[Trial]:
    """Those that no other beats in both time and worst error, from the quickest to the most accurate; what does not
    find all kinds does not count, and of rounding errors none is better than another."""
    kinds = kinds_of(found)
    known = [one for one in found if full(one.errors, kinds) and math.isfinite(one.seconds)]
    front: list[Trial] = []
    for one in sorted(known, key=lambda one: (one.seconds, worst(one.errors))):
        if not front or max(ROUNDING, worst(one.errors)) < worst(front[-1].errors):
            front.append(one)
    return front


def over(found: Sequence[Trial], counts: Sequence[int]) -> list[Trial]:
    """Of each method what it takes and misses at several counts together: seconds added, the largest errors. Its count
    is theirs, added."""
    return [
        Trial(own[0].method, sum(counts), sum(one.seconds for one in own), _largest(own))
        for own in by_method([one for one in found if one.count in counts and one.broken is None])
        if len(own) == len(set(counts))
    ]


def _largest(own: Sequence[Trial]) -> Errors:
    return {kind: float(np.max([one.errors[kind] for one in own])) for kind in own[0].errors}


def cheapest(found: Sequence[Trial], accuracy: float) -> Trial | None:
    """The quickest that finds all kinds with errors no larger than `accuracy`; None where there is none. Each method
    stands with the fewest steps that hold, as more of them cost no less, whatever the clock says. Of those whose times
    are equal the most accurate, and of rounding errors none is better: then the first."""
    kinds = kinds_of(found)
    good = [one for one in found if full(one.errors, kinds) and worst(one.errors) <= accuracy]
    fewest = [own[0] for own in by_method(good)]
    least = min((one.seconds for one in fewest), default=math.nan)
    equal = [one for one in fewest if one.seconds <= SAME * least]
    return min(equal, key=lambda one: max(ROUNDING, worst(one.errors)), default=None)


@dataclass(frozen=True, eq=False)
class Judged:
    """The rivals for one thing, `key`, as tried: `refused` with the reasons; `asked`: the counts that make up the task,
    for which together the cheapest that holds the accuracy is found. Without any a count is a setting of its method,
    and each is a candidate."""

    key: str
    trials: tuple[Trial, ...]
    refused: tuple[tuple[Method[Any, Any], Message], ...]
    accuracy: float
    asked: tuple[int, ...]

    @cached_property
    def kinds(self) -> tuple[str, ...]:
        return kinds_of(self.trials)

    @cached_property
    def candidates(self) -> tuple[Trial, ...]:
        """One task by every method: what it takes and misses at the counts asked together."""
        if len(self.asked) > 1:
            return tuple(over(self.trials, self.asked))
        return tuple(
            one for one in self.trials if one.broken is None and one.count in (self.asked or (one.count,))
        )

    @cached_property
    def rows(self) -> tuple[Trial, ...]:
        """All trials and candidates, by method and rising count."""
        added = self.candidates if len(self.asked) > 1 else ()
        return tuple(one for own in by_method([*self.trials, *added]) for one in own)

    def counts(self, one: Trial) -> tuple[int, ...]:
        """The counts of a row: of a candidate all that are asked; () where the method chooses its own."""
        if len(self.asked) > 1 and any(one is other for other in self.candidates):
            return self.asked
        return (one.count,) if one.count else ()

    @cached_property
    def front(self) -> frozenset[int]:
        """Numbers of the rows of candidates that no other beats in both seconds and worst error."""
        best = pareto(self.candidates)
        return frozenset(k for k, one in enumerate(self.rows) if any(one is other for other in best))

    @cached_property
    def best(self) -> Trial | None:
        """The cheapest candidate that holds the accuracy."""
        return cheapest(self.candidates, self.accuracy)
