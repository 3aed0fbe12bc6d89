"""The demanded numbers as functions of parts of the ranges of the unknowns: the variant is solved for each."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.find.given import Given
from tmm_report.chapters.find.target import Chapter, target
from tmm_report.mechanics.calculus.seek import PARTS
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake

Array = Any
Numbers = tuple[float, ...]
Answer = Sequence[Chapter] | ProblemError
Course = Callable[[Sequence[Numbers], Collection[str], bool], Iterable[Answer]]
"""Values of the unknowns in their own units, the chapters that are asked for (none: all), whether barely, without what
is costly in them -> of each its results, or why there are none."""
Sample = tuple[Numbers, Sequence[Chapter]]

SIDEWAYS = 0.38  # of the range: the step between two samples, which no grid has


class Asking:
    """Parts of the ranges, (N, unknowns) -> the demanded numbers there, (N, demands). `left`: how many variants may
    still be solved; `reason`: the first for which there was no number; `samples`: parts of the ranges with all that the
    variant has there, two where two can be solved; `bare`: whether the numbers are the same without what is costly."""

    def __init__(self, given: Given, course: Course, most: int):
        self.given, self.course, self.left, self.most = given, course, most, most
        self.reason: Message | None = None
        self.samples = self._sampled()
        self.targets = tuple(target(one, self.samples[0][1]) for one in given.demands)
        self.chapters = {one.chapter for one in self.targets}
        self.bare = self._barely()

    def _sampled(self) -> list[Sample]:
        """Raises ProblemError: none can be solved."""
        found: list[Sample] = []
        first: ProblemError | None = None
        for parts in self._places():
            (answer,) = self.course([self.given.at(parts)], (), False)
            if isinstance(answer, ProblemError):
                first = first or answer
                continue
            found.append((parts, answer))
            if len(found) == 2:
                break
        if found:
            return found
        assert first is not None
        text = N_("with no value of the range %(name)s can the variant be solved: %(why)s")
        name = " × ".join(one.name for one in self.given.unknowns)
        path = ("find", "unknown", self.given.unknown.name)
        raise ProblemError([mistake(text, path, name=name, why=first.problems[0].said)])

    @property
    def doubts(self) -> list[Problem]:
        """What was not tried for want of solvings."""
        if self.left > 0:
            return []
        text = N_("the search ended after %(count)s solvings of the variant: there may be more roots")
        right = Message(N_("narrow the range"))
        return [doubt(text, ("find", "unknown"), right, count=self.most)]

    def _barely(self) -> bool:
        parts, whole = self.samples[0]
        (answer,) = self.course([self.given.at(parts)], self.chapters, True)
        return not isinstance(answer, ProblemError) and all(
            one.number(answer) == one.number(whole) for one in self.targets
        )

    def _places(self) -> Iterator[Numbers]:
        """The middle, the ends, a coarse grid, all a little to the side of one another."""
        grid = (0.5, 0.5 - SIDEWAYS, 0.0, 1.0, *np.linspace(0, 1, PARTS // 4 + 1).tolist())
        for one in grid:
            other = (one + SIDEWAYS) % 1.0 if 0 < one < 1 else one
            yield (one, *[other] * (len(self.given.unknowns) - 1))

    def __call__(self, parts: Array) -> Array:
        places = [self.given.at(one) for one in parts.tolist()][: max(0, self.left)]
        self.left -= len(places)
        found = np.full((len(parts), len(self.targets)), np.nan)
        for k, answer in enumerate(self.course(places, self.chapters, self.bare)):
            if isinstance(answer, ProblemError):
                self.reason = self.reason or answer.problems[0].said
            else:
                found[k] = [one.number(answer) for one in self.targets]
        return found
