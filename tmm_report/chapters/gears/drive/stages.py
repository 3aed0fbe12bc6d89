"""The stages of a drive: which kinds there are and how each is solved."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import lru_cache
from typing import assert_never

from tmm_report.chapters.gears.drive.bounds import check_search
from tmm_report.chapters.gears.planetary.solve import stage as planetary
from tmm_report.chapters.gears.spur.solve import pair as spur
from tmm_report.mechanics.gears.trains import Member
from tmm_report.problems import Problem, ProblemError

Given = spur.Given | planetary.Given
Stage = spur.Found | planetary.Found


def solve_all(given: tuple[Given, ...]) -> tuple[Stage, ...]:
    """Every stage in its own room. Raises ProblemError with the mistakes of all of them."""
    return _all(given)


@lru_cache(maxsize=8)
def _all(given: tuple[Given, ...]) -> tuple[Stage, ...]:
    """The last ones are kept: the speed of a link that a drive turns is asked for before it is solved in its turn, and
    students of one class share the columns of a table of drives."""
    check_search(given)
    found: list[Stage] = []
    problems: list[Problem] = []
    for k, stage in enumerate(given):
        try:
            found.append(_solved(stage))
        except ProblemError as error:
            problems += [_placed(problem, k) for problem in error.problems]
    if problems:
        raise ProblemError(problems)
    return tuple(found)


def _solved(given: Given) -> Stage:
    match given:
        case spur.Given():
            return spur.solve(given)
        case planetary.Given():
            return planetary.solve(given)
        case _:
            assert_never(given)


def doubts_of(stages: Iterable[Stage]) -> Iterator[Problem]:
    """What looks odd in the stages, each with its place in the variant."""
    for k, stage in enumerate(stages):
        yield from (_placed(problem, k) for problem in getattr(stage, "doubts", ()))


def _placed(problem: Problem, stage: int) -> Problem:
    """The problem of a stage with the stage's place in the variant before its own path."""
    return replace(problem, path=("drive", "stages", stage, *problem.path))


def member(stage: Stage, name: str) -> Member:
    """A member of the stage by its name."""
    return next(m for m in stage.members if m.name == name)
