"""A document -> the chapters' blocks, validated each by itself, or every mistake of the file at once."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator
from copy import deepcopy
from dataclasses import replace
from itertools import islice
from typing import Any

from pydantic import ValidationError

from tmm_report import yamlread
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.variant import errors, sizes
from tmm_report.variant.leaves import leaves
from tmm_report.variant.model import Block, Read, Room, Rooms
from tmm_report.variant.russian import meant
from tmm_report.variant.slips import lookalike, odd
from tmm_report.yamlread import Document, Path, located

Further = Callable[[Read], Iterable[Problem]]

MOST_TOLD = 50  # mistakes of a file that are told one by one
MOST_FOUND = 2000  # mistakes that one block says of its parts: a file can have a million


def read(
    document: Document,
    file: str,
    soft: Iterable[Problem],
    rooms: Rooms,
    further: Further = lambda read: (),
    doubted: bool = True,
) -> Read:
    """The blocks of the file; `soft`: mistakes met in its text; `further`: what solving says wrong of the keys that
    have no mistakes, asked only where others have some; `doubted`: whether anybody asks what looks odd, which is a
    quarter of the reading. Raises ProblemError with all mistakes."""
    problems, data = list(soft), document.data
    if not isinstance(data, dict):
        right = Message(N_("start from the one that `tmm-report new` writes"))
        problems.append(mistake(N_("the file has no variant"), right=right))
        raise _error(problems, document, file)
    if large := sizes.beyond(data):
        raise _error(large, document, file)
    document, alike = lookalike.top_keys(document, rooms.keys())
    needed = rooms.owning(set(document.data))
    document, more = lookalike.mended(document, [room.Block for room in needed])
    data, empty = _without_empty(_as_written(document, needed), ())
    problems += [*alike, *more, *_worded(empty, document.data, needed, rooms)]
    blocks, wrong = _blocks(data, needed, rooms)
    reported = {problem.path for problem in problems}
    problems += [problem for problem in wrong if problem.path not in reported]
    found = Read(data, frozenset(problem.path for problem in problems), blocks)
    if len(blocks) == len(needed) and not _without_mechanism(data, rooms):
        for room in needed:
            problems += islice(room.mistakes(found), MOST_FOUND)
        if problems:
            keys = frozenset(problem.path for problem in problems if problem.path)
            problems += [*further(replace(found, broken=keys)), *odd.all_lengths(found)]
    if problems or len(blocks) < len(needed):
        raise _error(problems, document, file)
    return replace(found, doubts=tuple(_placed(_doubts(found, needed), document, file))) if doubted else found


def _without_mechanism(data: dict[str, Any], rooms: Rooms) -> bool:
    """Whether there is no mechanism, and a block of an unknown name that may be it: all others would miss it."""
    known = rooms.keys()
    return "mechanism" not in data and any(
        isinstance(value, dict) and key not in known for key, value in data.items()
    )


def _doubts(found: Read, needed: Iterable[Room]) -> Iterator[Problem]:
    """Numbers that look as if they had missed their unit; what the rooms that have doubts find odd."""
    yield from odd.doubts(found)
    for room in needed:
        if (doubts := getattr(room, "doubts", None)) is not None:
            yield from doubts(found)


def _error(problems: Iterable[Problem], document: Document, file: str) -> ProblemError:
    found = _placed((_with_comma(problem, document) for problem in problems), document, file)
    if len(found) > MOST_TOLD:
        rest = Message(N_("and %(count)s more mistakes"), {"count": len(found) - MOST_TOLD})
        found[MOST_TOLD:] = [Problem(rest, file=file)]
    return ProblemError(found)


def _with_comma(problem: Problem, document: Document) -> Problem:
    """A mistake of a list in which a comma looks like a decimal one: how the list is written then."""
    path = problem.path if problem.path in document.commas else problem.path[:-1]
    if path not in document.commas or problem.doubt:
        return problem
    wanted = problem.wrong.values.get("count", problem.wrong.values.get("max_length"))
    if isinstance(wanted, int) and document.commas[path].count(",") + 1 != wanted:
        return problem  # with points for commas there would not be so many either
    text = N_("a decimal comma inside [ ] parts two values: write %(list)s")
    return replace(problem, right=Message(text, {"list": shown(document.commas[path], 80)}))


def _placed(problems: Iterable[Problem], document: Document, file: str) -> list[Problem]:
    """All of them with their places, in the order of the file."""
    found = [located(problem, document.places, file) for problem in problems]
    return sorted(found, key=lambda problem: (problem.line or 0, problem.column or 0))


def _as_written(document: Document, rooms: Iterable[Room]) -> dict[str, Any]:
    """The data with numbers as they were written where a block holds texts."""
    data = dict(document.data)
    for key in (key for room in rooms for key in room.Block.AS_WRITTEN):
        if isinstance(texts := data.get(key), dict):
            data[key] = {name: document.raw.get((key, name), value) for name, value in texts.items()}
    return data


def _without_empty(value: Any, path: Path) -> tuple[Any, list[Problem]]:
    """The data without the keys that have no value, and a Problem for each."""
    problems: list[Problem] = []
    items = list(value.items() if isinstance(value, dict) else enumerate(value))
    kept: dict[Any, Any] = {}
    for key, item in items:
        if item is None:
            right = Message(N_("write the value or take the key out"))
            problems.append(mistake(N_("there is no value here"), (*path, key), right))
        elif isinstance(item, dict | list):
            kept[key], inner = _without_empty(item, (*path, key))
            problems += inner
        else:
            kept[key] = item
    return (kept if isinstance(value, dict) else [kept.get(index) for index, _ in items]), problems


def _worded(empty: list[Problem], data: Any, needed: Iterable[Room], rooms: Rooms) -> Iterator[Problem]:
    """The mistakes of keys without a value; of those that are unknown besides, that they are."""
    if not empty:
        return
    blocks = [room.Block for room in needed]
    owned = {leaf.path: leaf.known for leaf in leaves(blocks, data) if leaf.known}
    for n, problem in enumerate(empty):
        if (path := problem.path) in owned and n < errors.WORDED:
            right = errors.unknown(
                path, data, owned[path], lambda: [room.Block for room in rooms.all()], data
            )
            problem = mistake(N_("unknown key %(key)s"), path, right, key=shown(path[-1]))
        yield problem


def _blocks(
    data: dict[str, Any], needed: Iterable[Room], rooms: Rooms
) -> tuple[dict[type[Block], Block], list[Problem]]:
    """Each room's block of the file, and the mistakes of what is wrong in itself."""
    blocks: dict[type[Block], Block] = {}
    known = [key for room in needed for key in room.Block.model_fields]
    strange = [key for key in data if key not in known]
    problems, strange = _foreign(strange)
    problems += [_unknown(key, data, known, rooms, n < errors.WORDED) for n, key in enumerate(strange)]
    for kind in (room.Block for room in needed):
        written = {key: data[key] for key in kind.model_fields if key in data}
        block = _validated(kind, written, problems, rooms, data) if written else kind.model_construct()
        if block is not None:
            blocks[kind] = block
    return blocks, problems


def _foreign(strange: list[str]) -> tuple[list[Problem], list[str]]:
    """One mistake for all keys that are written in letters of no known key; the other unknown keys."""
    foreign = [
        key
        for key in strange
        if any(char.isalpha() for char in key) and not re.search("[A-Za-z]", key) and not meant(key)
    ]
    if len(foreign) < 2:
        return [], strange
    text = N_("keys are English words, and these are not: %(keys)s")
    right = Message(N_("start from the one that `tmm-report new` writes"))
    told = mistake(text, (foreign[0],), right, keys=shown(", ".join(foreign), 120))
    return [told], [key for key in strange if key not in foreign]


def _unknown(key: str, data: Any, known: list[str], rooms: Rooms, worded: bool) -> Problem:
    right = (
        errors.unknown_block(key, data, known, lambda: [room.Block for room in rooms.all()])
        if worded
        else None
    )
    return mistake(N_("unknown key %(key)s"), (key,), right, key=shown(key))


def _validated(
    kind: type[Block], data: dict[str, Any], problems: list[Problem], rooms: Rooms, stated: Collection[str]
) -> Block | None:
    """The block of what is right in itself; the mistakes of what is not are added to `problems`; `stated`: the keys
    at the top of the file.

    What is wrong is taken out and the rest validated again: a part that cannot do without it goes with it.
    """
    rest = data
    for attempt in range(yamlread.DEPTH + 2):
        try:
            return kind.model_validate(rest)
        except ValidationError as error:
            found = errors.problems(error, kind, rest, lambda: [room.Block for room in rooms.all()], stated)
        if attempt == 0:
            problems += found
            rest = deepcopy(data)
        for path in dict.fromkeys(problem.path for problem in found):
            _prune(rest, path, kind.HOLES)
    return None


def _prune(data: dict[str, Any], path: Path, holes: Collection[Path]) -> None:
    """Take out what is at the path: a key, or the list that the item is in. What lacks a key goes itself."""
    inside: Any = data
    for part in path[:-1]:
        if inside is None or (isinstance(inside, dict) and part not in inside):
            return  # gone with another mistake
        inside = inside[part]
    if path[:-1] in holes:
        inside[path[-1]] = None
    elif isinstance(inside, dict) and path and path[-1] in inside:
        del inside[path[-1]]
    elif path:
        _prune(data, path[:-1], holes)
