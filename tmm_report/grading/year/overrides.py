"""Marks set by hand: `overrides.csv` in the folder of the marks, which no run writes and every run keeps to.

id;points;reason
ivanov;85;defended orally
"""

from __future__ import annotations

import math
import os
from collections.abc import Collection, Iterator
from dataclasses import field, replace
from pathlib import Path

from tmm_report.grading.model import Override
from tmm_report.grading.year.whose import folded
from tmm_report.intake import cells, sheets
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.records import dataclass
from tmm_report.yamlread import file_label, opened

FILE = "overrides.csv"
HEADS = {
    "id": "id",
    "points": "points",
    "баллы": "points",
    "балл": "points",
    "оценка": "points",
    "reason": "reason",
    "причина": "reason",
    "основание": "reason",
    "бали": "points",
    "бал": "points",
    "оцінка": "points",
    "підстава": "reason",
    "ұпай": "points",
    "баға": "points",
    "себебі": "reason",
    "негіздеме": "reason",
}
_HEAD = Message(N_("the first row names the columns: id, points, reason"))


@dataclass(frozen=True)
class Overrides:
    """`marks`: by id. `problems`: rows that are no marks; `held`: of whom, whose marks wait for them to be right."""

    marks: dict[str, Override] = field(default_factory=dict)
    problems: list[Problem] = field(default_factory=list)
    held: dict[str, Problem] = field(default_factory=dict)


def overrides(path: Path, ids: Collection[str], worth: float) -> Overrides:
    """The marks that a file sets; none where there is no such file. `worth`: of a work. Raises ProblemError for a file
    that cannot be read."""
    found = Overrides()
    if not os.path.lexists(path):
        return found
    known = {folded(id): id for id in ids}
    seen: set[str] = set()
    for place, id, points, reason in _rows(path):
        name = known.get(folded(id))
        problem = _wrong(id, name, points, worth)
        if name is not None and name in seen:
            problem = mistake(
                N_("%(id)s has two marks set by hand"), right=Message(N_("keep one")), id=shown(id)
            )
            found.marks.pop(name, None)
        if problem is None and name is not None:
            found.marks[name] = Override(cells.number(points), shown(reason, sheets.CHARACTERS))
        elif problem is not None:
            told = replace(problem, file=place[0], line=place[1])
            found.problems.append(told)
            if name is not None:
                found.held[name] = told
        seen.add(name or "")
    return found


def _rows(path: Path) -> Iterator[tuple[tuple[str, int], str, str, str]]:
    """File and line, id, points and reason of each row that says anything."""
    label = file_label(path)
    for sheet in sheets.read_sheets(label, path.name, opened(path, label, sheets.BYTES)):
        keys = [HEADS.get(cells.header(head)[0].strip().casefold(), "") for head in sheet.header]
        if not {"id", "points"} <= {*keys}:
            missing = "id" if "id" not in keys else "points"
            problem = mistake(
                N_("%(file)s has no column %(column)s"), right=_HEAD, file=label, column=missing
            )
            raise ProblemError([replace(problem, file=label, line=sheet.line)])
        for row in sheet.rows:
            texts = dict(zip(keys, (cell.text for cell in row), strict=False))
            if any(texts.values()):
                yield (label, row[0].line), texts["id"], texts["points"], texts.get("reason", "")


def _wrong(id: str, known: str | None, points: str, worth: float) -> Problem | None:
    if known is None:
        right = Message(N_("ids are those of marks.csv"))
        return mistake(N_("there is no work %(id)s"), right=right, id=shown(id) or "''")
    number = cells.number(points)
    if math.isnan(number) or not 0 <= number <= worth:
        right = Message(N_("a number from 0 to %(worth)s"), {"worth": f"{worth:g}"})
        return mistake(N_("%(points)s are no points"), right=right, points=shown(points) or "''")
    return None
