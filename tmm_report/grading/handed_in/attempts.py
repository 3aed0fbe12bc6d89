"""Attempts at a work: which files of a student are a later try at the same sheet, known by their names alone.

sheet.csv, sheet (1).csv      a copy with a number, as browsers and systems name it
sheet.xlsx, sheet2.xlsx       a number behind a name that stands there without one
attempt1/sheet.csv, attempt2/sheet.csv; Попытка 2/…      a folder for each attempt, which is a whole
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import PurePosixPath

from tmm_report.intake.sources import ATTEMPT

_COPY = re.compile(r"(.*?)[ _]*\(([0-9]{1,3})\)")
_WORD = re.compile(rf"(.*?)[ _.-]*{ATTEMPT.pattern}", re.IGNORECASE)
_BEHIND = re.compile(r"(.+)[ _.-]([0-9]{1,2})"), re.compile(r"(.+?)([0-9]{1,2})")
MOST = 20  # of them are marked


def attempts(names: Sequence[str]) -> list[list[int]]:
    """The files of each attempt, the first first, by their places among `names`, those in a student's folder.

    A file that is not handed in again stands for the attempts after it, too; a folder of an attempt is a whole.
    """
    folders: dict[int, list[int]] = {}
    for place, name in enumerate(names):
        folders.setdefault(_folder(name), []).append(place)
    found: list[list[int]] = []
    for _, places in sorted(folders.items()):
        found += _copies(places, [names[place] for place in places])
    return found[-MOST:]


def _folder(name: str) -> int:
    """The number of the attempt in whose folder a file is, 0 of those that are in none."""
    numbers = (ATTEMPT.fullmatch(part) for part in PurePosixPath(name).parts[:-1])
    return next((int(number[1]) for number in numbers if number), 0)


def _copies(places: Sequence[int], names: Sequence[str]) -> list[list[int]]:
    """The attempts among the files of one folder."""
    stems = {_plain(name) for name in names}
    numbered = [_number(_plain(name), stems) for name in names]
    tries: dict[str, dict[int, list[int]]] = {}
    for place, (stem, number) in zip(places, numbered, strict=True):
        tries.setdefault(stem, {}).setdefault(number, []).append(place)
    steps = sorted({number for _, number in numbered})
    return [_at(step, tries.values()) for step in steps]


def _at(step: int, tries: Iterable[Mapping[int, list[int]]]) -> list[int]:
    """Of each file its latest form up to a step; at the first step those that come later are not there yet."""
    found: list[int] = []
    for numbers in tries:
        if before := [number for number in numbers if number <= step]:
            found += numbers[max(before)]
    return sorted(found)


def _plain(name: str) -> str:
    """Folder and name without the suffix."""
    return str(PurePosixPath(name).with_suffix("")).casefold()


def _number(stem: str, stems: Iterable[str]) -> tuple[str, int]:
    """A name without the number of its attempt, and that number; 0 where it has none."""
    for pattern in (_COPY, _WORD):
        if found := pattern.fullmatch(stem):
            return found[1], int(found[2])
    behind = (pattern.fullmatch(stem) for pattern in _BEHIND)
    return next(((found[1], int(found[2])) for found in behind if found and found[1] in stems), (stem, 0))


def unnumbered(name: str) -> str:
    """A name without the number of a copy or an attempt: `ivanov (1)`, `ivanov_attempt2`."""
    found = _COPY.fullmatch(name) or _WORD.fullmatch(name)
    return found[1] if found and found[1] else name
