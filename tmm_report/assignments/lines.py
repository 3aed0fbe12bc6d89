"""The rows of a teacher's table, one at a time: a CSV of a million rows is never held as rows."""

from __future__ import annotations

import os
from collections.abc import Sequence

from tmm_report import yamlread
from tmm_report.intake.sheets import BYTES, ROWS, Cell, Stream, read_sheets, stream_csv
from tmm_report.problems import N_, Message, Problem, ProblemError

MANY = 1_000_000  # rows

_FORMULA = tuple("=+-@\t\r＝＋－＠")


def table(path: str | os.PathLike[str]) -> Stream:
    """A CSV file row by row, or the first sheet of a workbook. Raises ProblemError."""
    file = yamlread.file_label(path)
    content = yamlread.opened(path, file, min(_size(path), BYTES * (MANY // ROWS)))
    if os.fspath(path).lower().endswith(".csv"):
        return stream_csv(file, content, rows=MANY)
    sheets = read_sheets(file, os.path.basename(path), content, rows=MANY)
    if not sheets:
        raise ProblemError([wrong(file, None, N_("the table is empty"))])
    first = sheets[0]
    return Stream(first.label, first.header, iter(first.rows), first.line, first.notes)


def _size(path: str | os.PathLike[str]) -> int:
    """Of the file, 1 of one that cannot be opened: as much memory is taken to read it as is allowed."""
    try:
        return max(1, os.stat(path).st_size)
    except (OSError, ValueError):
        return 1


def texts(row: Sequence[Cell]) -> list[str]:
    """The cells of a row, without the apostrophe that keeps a spreadsheet from taking a text for a formula."""
    return [plain(cell.text) for cell in row]


def plain(text: str) -> str:
    return text[1:] if text[:1] == "'" and text[1:].startswith(_FORMULA) else text


def wrong(file: str, line: int | None, text: str, right: Message | None = None, **values: object) -> Problem:
    """A mistake of a line of a file; `text` is a message id."""
    return Problem(Message(text, values), right, file=file, line=line)
