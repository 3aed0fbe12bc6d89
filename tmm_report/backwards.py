"""Questions asked backwards: a variant that leaves a number unknown is solved with the number that meets its demand.

Above the course, for it solves whole variants; whatever takes a user's variant to its results calls this `solve`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from tmm_report import course
from tmm_report.course import Moved, Results, Variant
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

if TYPE_CHECKING:
    from tmm_report.chapters.find import solve as find

T = TypeVar("T")
Each = Callable[[Sequence[Variant]], Iterable[Results | ProblemError]]


def solve(variant: Variant, moved: Moved | None = None, each: Each | None = None) -> Results:
    """As `course.solve`, and what the variant asks backwards. `each`: what solves the variants that are tried."""
    if variant.find is not None:
        return _backwards(variant, variant.find, each or _one_by_one)
    return course.solve(variant, moved)


def _backwards(variant: Variant, asked: find.Given, each: Each) -> Results:
    """What a variant is solved with that leaves a number unknown: the number found, in a variant that states it."""
    restated = asked.restated
    assert restated is not None

    def tried(numbers: Sequence[float], chapter: str) -> Iterator[find.Answer]:
        stated = [_or_mistakes(partial(restated, number)) for number in numbers]
        solved = iter(each([_narrowed(one, chapter) for one in stated if isinstance(one, Variant)]))
        for one in stated:
            found = one if isinstance(one, ProblemError) else next(solved)
            yield found if isinstance(found, ProblemError) else _told(found, chapter)

    found = course.find.solve(asked, tried)
    try:
        results = course.solve(restated(found.number))
    except ProblemError as error:
        text = N_("the variant is not solved with what is found, %(name)s = %(x)s: see what else is told")
        told = {"name": asked.unknown.name, "x": asked.unknown.written(found.number)}
        right = Message(N_("narrow the range, or choose another root"))
        raise ProblemError([*error.problems, mistake(text, ("find",), right, **told)]) from None
    return replace(results, find=found, variant=replace(results.variant, doubts=variant.doubts))


def _one_by_one(variants: Sequence[Variant]) -> Iterator[Results | ProblemError]:
    return (_or_mistakes(partial(course.solve, one)) for one in variants)


def _or_mistakes(run: Callable[[], T]) -> T | ProblemError:
    try:
        return run()
    except ProblemError as error:
        return error


def _narrowed(variant: Variant, chapter: str) -> Variant:
    """What of a variant the numbers of a chapter need; all of it for ""."""
    if not chapter:
        return variant
    others: dict[str, Any] = {name: None for name in course.OTHERS if name != chapter}
    if (lever := variant.lever) is not None:
        drawn = chapter in ("plans", "force_plans", "reduction", "readings")
        positions = lever.positions if drawn else replace(lever.positions, plans=(), force_plan=())
        methods = lever.methods if chapter == "methods" else None
        lever = replace(lever, positions=positions, readings={}, methods=methods)
    return replace(variant, lever=lever, **others)


def _told(results: Results, chapter: str) -> find.Answer:
    """Tables and single numbers by chapters; why there are none where the mechanism does not close all round."""
    lever = results.lever
    if lever is not None and lever.partial:
        return ProblemError([Problem(lever.kinematics.gaps[0].text)])
    own = [(course.INITIAL_DATA, lever)] if lever is not None else []
    rooms = (
        (name, course.room(name, "quantities"), found) for name, found in (*own, *course.chapters(results))
    )
    return [(name, of.tables(found), of.values(found)) for name, of, found in rooms if chapter in ("", name)]
