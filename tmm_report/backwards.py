"""Questions asked backwards: a variant that leaves numbers unknown is solved with those that meet its demands.

Above the course, for it solves whole variants; whatever takes a user's variant to its results calls this `solve`.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
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
    """What a variant is solved with that leaves numbers unknown: those found, in a variant that states them."""
    restated = asked.restated
    assert restated is not None

    def tried(places: Sequence[find.Numbers], chapters: Collection[str], bare: bool) -> Iterator[find.Answer]:
        stated = [_or_mistakes(partial(restated, numbers)) for numbers in places]
        solved = iter(each([_narrowed(one, chapters, bare) for one in stated if isinstance(one, Variant)]))
        for one in stated:
            found = one if isinstance(one, ProblemError) else next(solved)
            yield found if isinstance(found, ProblemError) else _told(found, chapters)

    found = course.find.solve(asked, tried)
    try:
        results = course.solve(restated(found.numbers))
    except ProblemError as error:
        text = N_("the variant is not solved with what is found, %(what)s: see what else is told")
        pairs = zip(asked.unknowns, found.numbers, strict=True)
        told = {"what": ", ".join(f"{one.name} = {one.written(number)}" for one, number in pairs)}
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


def _narrowed(variant: Variant, chapters: Collection[str], bare: bool) -> Variant:
    """What of a variant the numbers of some chapters need; all of it for none. `bare`: without what is costly of these,
    as their records say themselves."""
    if not chapters:
        return variant
    others: dict[str, Any] = {name: None for name in course.OTHERS if name not in chapters}
    if bare:
        stated = {name: getattr(variant, name) for name in course.OTHERS if name in chapters}
        others |= {name: getattr(one, "bare", one) for name, one in stated.items()}
    if (lever := variant.lever) is not None:
        drawn = not {"plans", "force_plans", "reduction", "readings"}.isdisjoint(chapters)
        positions = lever.positions if drawn else replace(lever.positions, plans=(), force_plan=())
        methods = lever.methods if "methods" in chapters else None
        lever = replace(lever, positions=positions, readings={}, methods=methods)
    return replace(variant, lever=lever, **others)


def _told(results: Results, chapters: Collection[str]) -> find.Answer:
    """Tables and single numbers by chapters; why there are none where the mechanism does not close all round."""
    lever = results.lever
    if lever is not None and lever.partial:
        return ProblemError([Problem(lever.kinematics.gaps[0].text)])
    rooms = ((name, course.room(name, "quantities"), found) for name, found in course.with_data(results))
    return [
        (name, of.tables(found), of.values(found))
        for name, of, found in rooms
        if not chapters or name in chapters
    ]
