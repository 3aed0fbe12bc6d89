"""Tables from outside, CSV and XLSX alike: a head and rows of text with their places, under limits.

Numbers come as text with all their digits; `cells.number` reads them. Every sheet is a rectangle: short rows are
filled up with empty cells.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import chain, islice
from pathlib import PurePosixPath
from typing import Any

from tmm_report.intake import delimited, workbook
from tmm_report.intake.cells import number
from tmm_report.intake.writing import unguarded
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.records import dataclass

BYTES = 2**20  # of a CSV file; more where more rows are allowed
ROWS = 2000
COLUMNS = 120
CHARACTERS = 200  # of a cell
CELLS = 600_000  # of all sheets of a file, with the empty ones that fill up short rows
SHEETS = 60
TITLES = 5  # rows above the head of a table, at most
_FAULTS = 20  # that many faulty rows of a sheet are told


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell's text without spaces around it, and where it stands: line of the file or row of the sheet, column."""

    text: str
    line: int
    column: int


@dataclass(frozen=True)
class Sheet:
    """`label` names it in messages; `line` is that of its head. `notes`: what was odd and could be passed over."""

    name: str
    label: str
    header: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    line: int = 1
    notes: tuple[Problem, ...] = ()


@dataclass(frozen=True)
class Stream:
    """A sheet read row by row, once: a row, or what is wrong with it."""

    label: str
    header: tuple[str, ...]
    rows: Iterator[tuple[Cell, ...] | Problem]
    line: int = 1
    notes: tuple[Problem, ...] = ()


def read_sheets(label: str, name: str, content: bytes, *, rows: int = ROWS) -> list[Sheet]:
    """The sheets of a file, of CSV one; `name` is the file's, its suffix says which kind. Sheets without a cell are
    left out.

    Raises ProblemError for what is larger than allowed, broken or hostile, with the places of all faulty rows.
    """
    found: list[Sheet] = []
    for title, stream in _streams(label, name, content, rows):
        found.append(_sheet(title, stream, CELLS - sum(_size(sheet) for sheet in found)))
    return found


def _size(sheet: Sheet) -> int:
    return len(sheet.rows) * len(sheet.header)


def stream_csv(label: str, content: bytes, *, rows: int = ROWS) -> Stream:
    """A CSV file row by row, for tables too large to be held. Raises ProblemError, and `rows` too, for a row after
    which there is no reading on."""
    if len(content) > BYTES * max(1, rows // ROWS):
        limit = BYTES * max(1, rows // ROWS) // 1024
        raise _refused(label, N_("the file is larger than %(limit)s kB"), limit=limit)
    text, notes = delimited.decoded(label, content)
    lines = delimited.rows(label, text, CHARACTERS)
    return _stream(label, ((line, [unguarded(cell) for cell in row]) for line, row in lines), rows, notes)


def _streams(label: str, name: str, content: bytes, rows: int) -> Iterator[tuple[str, Stream]]:
    path = PurePosixPath(name)
    suffix = path.suffix.lower()
    if suffix == ".csv":
        yield path.stem, stream_csv(label, content, rows=rows)
    elif suffix == ".xlsx":
        limits = workbook.Limits(rows=rows, columns=COLUMNS, characters=CHARACTERS, sheets=SHEETS)
        for title, place, lines, notes in workbook.worksheets(label, content, limits):
            yield title, _stream(place, iter(lines), rows, notes)
    else:
        raise _refused(label, N_("the file is none of %(kinds)s"), kinds="*.csv, *.xlsx")


def _sheet(name: str, stream: Stream, most: int) -> Sheet:
    """The whole of a sheet of at most so many cells. Raises ProblemError with its first faulty rows."""
    kept = []
    faults: list[Problem] = []
    for row in stream.rows:
        faults.append(row) if isinstance(row, Problem) else kept.append(row)
        if len(kept) * len(stream.header) > most:
            raise _refused(stream.label, N_("the workbook has too many cells"))
        if len(faults) >= _FAULTS:
            break
    if faults:
        raise ProblemError(faults)
    return Sheet(name, stream.label, stream.header, tuple(kept), stream.line, stream.notes)


def _stream(label: str, lines: Iterator[delimited.Row], rows: int, notes: Iterable[Problem]) -> Stream:
    line, header, lines = _head(lines)
    if len(header) > COLUMNS:
        raise _refused(label, N_("the table has more than %(limit)s columns"), line, limit=COLUMNS)
    return Stream(label, header, _rows(label, lines, len(header), rows), line, tuple(notes))


def _head(lines: Iterator[delimited.Row]) -> tuple[int, tuple[str, ...], Iterator[delimited.Row]]:
    """The head with its line, and the rows below. A few rows of titles above it are passed over."""
    waiting = list(islice(lines, TITLES + 1))
    texts = [_trimmed([cell.strip() for cell in row]) for _, row in waiting]
    widest = max((_said(row) for row in texts), default=0)
    start = next((k for k, row in enumerate(texts) if _is_head(row, widest)), 0)
    line, head = (waiting[start][0], texts[start]) if waiting else (1, [])
    return line, tuple(head), chain(waiting[start + 1 :], lines)


def _said(row: list[str]) -> int:
    """How many cells of a row say something."""
    return sum(map(bool, row))


def _is_head(row: list[str], widest: int) -> bool:
    """Whether a row names columns: most that the widest of the first rows has, the first of them by a word; what
    stands above, "Variant 7" or a name beside "Student", does not."""
    said = _said(row)
    return said >= 2 and 4 * said >= 3 * widest and math.isnan(number(row[0]))


def _rows(
    label: str, lines: Iterator[delimited.Row], width: int, rows: int
) -> Iterator[tuple[Cell, ...] | Problem]:
    for line, row in islice(lines, rows):
        texts = _trimmed([cell.strip() for cell in row])
        if len(texts) > width:
            yield replace(_WIDE, file=label, line=line, column=width + 1)
            continue
        texts += [""] * (width - len(texts))
        yield tuple(Cell(text, line, column) for column, text in enumerate(texts, 1))
    if following := next(lines, None):
        raise _refused(label, N_("the table has more than %(limit)s rows"), following[0], limit=rows)


_WIDE = mistake(
    N_("the row has more cells than the table's head"),
    right=Message(N_("a decimal comma needs ; between cells")),
)


def _trimmed(texts: list[str]) -> list[str]:
    """Without the empty cells at the end."""
    while texts and not texts[-1]:
        texts.pop()
    return texts


def _refused(label: str, text: str, line: int | None = None, **values: Any) -> ProblemError:
    return ProblemError([replace(mistake(text, **values), file=label, line=line)])
