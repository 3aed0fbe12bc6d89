"""Who a variant is for: the columns of a table that say so, and a list of students."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice

from tmm_report import yamlread
from tmm_report.assignments.lines import plain, table, texts, wrong
from tmm_report.intake.delimited import decoded
from tmm_report.intake.ids import unique
from tmm_report.intake.sheets import BYTES, CHARACTERS
from tmm_report.problems import N_, Message, Problem, ProblemError
from tmm_report.records import dataclass

MOST = 100_000  # students of a list

_HEADS = {
    "id": "id ид",
    "student": "student name студент фио ф.и.о. фамилия",
    "group": "group группа група топ",
    "variant": "variant вариант варіант нұсқа",
}
_FIELDS = {head: field for field, heads in _HEADS.items() for head in heads.split()}
_CONTROL = re.compile("[\x00-\x1f\x7f-\x9f\ufeff\ufffe\uffff]")

Row = tuple[int, Sequence[str]]


@dataclass(frozen=True)
class Person:
    """One row of a list. `id`: of files and folders; the other texts may be empty."""

    id: str
    student: str = ""
    group: str = ""
    variant: str = ""

    @property
    def title(self) -> Mapping[str, str]:
        """What stands on the title page."""
        return {"student": self.student, "group": self.group, "variant": self.variant}


def field_of(head: str) -> str | None:
    """Which of id, student, group and variant a column's head names."""
    return _FIELDS.get(" ".join(plain(head).split()).casefold())


def tidy(text: str) -> str:
    """A text on one line. Raises ValueError for one with control characters."""
    tidied = " ".join(text.split())
    if _CONTROL.search(tidied):
        raise ValueError(tidied)
    return tidied


def numbered(count: int) -> list[Person]:
    """Nobody's variants, by their numbers."""
    return [Person(f"v{number:03}", variant=str(number)) for number in range(1, count + 1)]


def students(path: str | os.PathLike[str]) -> list[Person]:
    """The list of a group: a name a line (TXT), or a table with a column student. Raises ProblemError."""
    file = yamlread.file_label(path)
    is_text = os.fspath(path).lower().endswith(".txt")
    fields, rows = (["student"], _names(path, file)) if is_text else _table(path, file)
    problems: list[Problem] = []
    found = [person(fields, row, file, problems) for row in islice(rows, MOST + 1)]
    found = [one for one in found if one.student]
    if len(found) > MOST or not found:
        text = (
            N_("the list has more than %(most)s students")
            if found
            else N_("there are no students in the list")
        )
        problems.append(wrong(file, None, text, most=MOST))
    if problems:
        raise ProblemError(problems)
    return _counted(found)


def _counted(found: Sequence[Person]) -> list[Person]:
    """Each with an id of his own, and with a number of the variant."""
    ids = unique([(one.id or one.student, f"{one.group}\n{one.student}\n{n}") for n, one in enumerate(found)])
    return [
        replace(one, id=made, variant=one.variant or str(number))
        for number, (one, made) in enumerate(zip(found, ids, strict=True), 1)
    ]


def _names(path: str | os.PathLike[str], file: str) -> Iterable[Row]:
    content, _ = decoded(file, yamlread.opened(path, file, BYTES * 4))
    rows = enumerate(content.decode().splitlines(), 1)
    return ((number, [name]) for number, name in rows if name.strip())


def _table(path: str | os.PathLike[str], file: str) -> tuple[list[str], Iterable[Row]]:
    stream = table(path)
    fields = [field_of(cell) or "" for cell in stream.header]
    if "student" not in fields:
        right = Message(N_("name the columns in the first line: student, group"))
        raise ProblemError([wrong(file, stream.line, N_("the list has no column student"), right)])
    return fields, _read(stream.rows)


def _read(rows: Iterable[object]) -> Iterator[Row]:
    for row in rows:
        if isinstance(row, Problem):
            raise ProblemError([row])
        if isinstance(row, tuple):
            yield row[0].line if row else 1, texts(row)


def person(fields: Sequence[str], row: Row, file: str, problems: list[Problem]) -> Person:
    """Who a row is about; `fields`: what each column says of him, "" for those that say nothing."""
    said = {"id": ""}
    number, cells = row
    for field, cell in ((field, cell) for field, cell in zip(fields, cells, strict=False) if field):
        try:
            said[field] = tidy(cell)
            if len(said[field]) > CHARACTERS:
                text = N_("the text is longer than %(limit)s characters")
                problems.append(wrong(file, number, text, limit=CHARACTERS))
        except ValueError:
            problems.append(wrong(file, number, N_("a control character is not allowed")))
    return Person(**said)
