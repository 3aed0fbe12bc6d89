"""A variant with a question asked backwards: solved with many values of its unknown, then with the one that is found.

What the search needs of the course stands here: the variant that states a number in the place of the unknown, as little
of it as the demanded number takes, and its results by chapters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from tmm_report import course
from tmm_report.course import INITIAL_DATA, OTHERS, Results, Variant, chapters, room
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

if TYPE_CHECKING:
    from tmm_report.chapters.find.given import Given
    from tmm_report.chapters.find.solve import Answer

T = TypeVar("T")
Each = Callable[[Sequence[Variant]], Iterable[Results | ProblemError]]
DRAWN = ("plans", "force_plans", "reduction", "readings")  # chapters that need the plans


def solve(variant: Variant, each: Each | None = None) -> Results:
    """`course.solve`, with the unknown found first where the variant asks backwards; its results are those of the
    variant that states it. `each`: solves many variants, one by one unless it is given. Raises ProblemError."""
    if (asked := variant.find) is None:
        return course.solve(variant)
    run = each or _one_by_one

    def tried(numbers: Sequence[float], chapter: str) -> Iterator[Answer]:
        stated = [_or_mistakes(partial(restated, asked, variant.file, number)) for number in numbers]
        solved = iter(run([_narrowed(one, chapter) for one in stated if isinstance(one, Variant)]))
        for one in stated:
            found = one if isinstance(one, ProblemError) else next(solved)
            yield found if isinstance(found, ProblemError) else _told(found, chapter)

    found = room("find", "solve").solve(asked, tried)
    try:
        results = course.solve(restated(asked, variant.file, found.number))
    except ProblemError as error:
        text = N_("the variant is not solved with what is found, %(name)s = %(x)s: see what else is told")
        told = {"name": asked.unknown.name, "x": asked.unknown.written(found.number)}
        right = Message(N_("narrow the range, or choose another root"))
        raise ProblemError([*error.problems, mistake(text, ("find",), right, **told)]) from None
    return replace(results, find=found, variant=replace(results.variant, doubts=variant.doubts))


def restated(asked: Given, file: str, number: float) -> Variant:
    """The variant with a number, in the unit of the range, in the place of the unknown. Raises ProblemError for one
    that may not stand there."""
    document, path = asked.document, asked.unknown.path
    assert document is not None
    data = put(document.data, path, asked.unknown.written(number))
    raw = {place: text for place, text in document.raw.items() if place != path}
    rest = {key: value for key, value in data.items() if key != "find"}
    return course.of_document(replace(document, data=rest, raw=raw), file, [])


def put(data: Any, path: Sequence[str | int], value: object) -> Any:
    """Data with another value at a path; what does not lie on the way is shared."""
    if not path:
        return value
    key, *rest = path
    if isinstance(data, list):
        return [put(item, rest, value) if k == key else item for k, item in enumerate(data)]
    return {**data, key: put(data[key], rest, value)}


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
    others: dict[str, Any] = {name: None for name in OTHERS if name != chapter}
    if (lever := variant.lever) is not None:
        bare = replace(lever.positions, plans=(), force_plan=())
        positions = lever.positions if chapter in DRAWN else bare
        methods = lever.methods if chapter == "methods" else None
        lever = replace(lever, positions=positions, readings={}, methods=methods)
    return replace(variant, lever=lever, **others)


def _told(results: Results, chapter: str) -> Answer:
    """Tables and single numbers by chapters; why there are none where the mechanism does not close all round."""
    lever = results.lever
    if lever is not None and lever.partial:
        return ProblemError([Problem(lever.kinematics.gaps[0].text)])
    own = [(INITIAL_DATA, lever)] if lever is not None else []
    rooms = ((name, room(name, "quantities"), found) for name, found in (*own, *chapters(results)))
    return [(name, of.tables(found), of.values(found)) for name, of, found in rooms if chapter in ("", name)]
