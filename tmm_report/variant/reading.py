"""A document -> the chapters' blocks, validated each by itself, or every mistake of the file at once."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from copy import deepcopy
from typing import Any

from pydantic import ValidationError

from tmm_report import yamlread
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.variant import errors
from tmm_report.variant.model import Block, Read, Room, Rooms
from tmm_report.yamlread import Document, Path, located


def read(document: Document, file: str, soft: Iterable[Problem], rooms: Rooms) -> Read:
    """The blocks of the file; `soft`: mistakes met in its text. Raises ProblemError with all mistakes."""
    problems, data = list(soft), document.data
    if not isinstance(data, dict):
        right = Message(N_("start from the one that `tmm-report new` writes"))
        problems.append(mistake(N_("the file has no variant"), right=right))
        raise _error(problems, document, file)
    needed = rooms.owning(set(data))
    data, empty = _without_empty(_as_written(document, needed), ())
    problems += empty
    blocks, wrong = _blocks(data, needed, rooms)
    reported = {problem.path for problem in problems}
    problems += [problem for problem in wrong if problem.path not in reported]
    found = Read(data, frozenset(problem.path for problem in problems), blocks)
    if len(blocks) == len(needed):
        problems += [problem for room in needed for problem in room.mistakes(found)]
    if problems or len(blocks) < len(needed):
        raise _error(problems, document, file)
    return found


def _error(problems: Iterable[Problem], document: Document, file: str) -> ProblemError:
    """All of them with their places, in the order of the file."""
    found = [located(problem, document.places, file) for problem in problems]
    return ProblemError(sorted(found, key=lambda problem: (problem.line or 0, problem.column or 0)))


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


def _blocks(
    data: dict[str, Any], needed: Iterable[Room], rooms: Rooms
) -> tuple[dict[type[Block], Block], list[Problem]]:
    """Each room's block of the file, and the mistakes of what is wrong in itself."""
    blocks: dict[type[Block], Block] = {}
    known = [key for room in needed for key in room.Block.model_fields]
    problems = [_unknown(key, known) for key in data if key not in known]
    for kind in (room.Block for room in needed):
        written = {key: data[key] for key in kind.model_fields if key in data}
        block = _validated(kind, written, problems, rooms) if written else kind.model_construct()
        if block is not None:
            blocks[kind] = block
    return blocks, problems


def _unknown(key: str, known: Iterable[str]) -> Problem:
    return mistake(N_("unknown key %(key)s"), (key,), errors.near(key, sorted(known)), key=shown(key))


def _validated(
    kind: type[Block], data: dict[str, Any], problems: list[Problem], rooms: Rooms
) -> Block | None:
    """The block of what is right in itself; the mistakes of what is not are added to `problems`.

    What is wrong is taken out and the rest validated again: a part that cannot do without it goes with it.
    """
    rest = data
    for attempt in range(yamlread.DEPTH + 2):
        try:
            return kind.model_validate(rest)
        except ValidationError as error:
            found = errors.problems(error, rest, lambda: [room.Block for room in rooms.all()])
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
