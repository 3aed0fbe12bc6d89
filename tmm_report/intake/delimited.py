"""CSV as people's spreadsheets write it -> rows of text with their lines: encodings, delimiters, quotes, limits."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from typing import Any

from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

_CONTROL = re.compile(rb"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]")
_QUOTED = re.compile('"[^"]*"?')
_LETTER = re.compile(r"[^\W\d_]")
FIRST = 12  # lines by which it is told what parts cells
_UTF8 = Message(N_("save the file as UTF-8"))
Row = tuple[int, list[str]]


def decoded(label: str, content: bytes) -> tuple[bytes, list[Problem]]:
    """The text as UTF-8 without a mark, and a note if it had to be guessed that it is in Windows-1251.

    Raises ProblemError for control characters, NUL among them, and for what is in no known encoding.
    """
    notes: list[Problem] = []
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        content = _utf8(label, content, "utf-16")
    content = content.removeprefix(b"\xef\xbb\xbf")
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        content = _utf8(label, content, "cp1251")
        text = N_("the file is not in UTF-8; it was read as Windows-1251")
        notes.append(replace(mistake(text, right=_UTF8), file=label))
    if bad := _CONTROL.search(content):
        raise _refused(
            label, len(content[: bad.start()].split(b"\n")), N_("a control character is not allowed")
        )
    return content, notes


def _utf8(label: str, content: bytes, encoding: str) -> bytes:
    try:
        return content.decode(encoding).encode("utf-8")
    except UnicodeError:
        raise _refused(label, None, N_("the file is in no known encoding"), _UTF8) from None


def rows(label: str, content: bytes, characters: int) -> Iterator[Row]:
    """(line, cells) of each row that is not blank, from decoded text; the cells are at most `characters` long.

    Raises ProblemError, on the row, for a longer cell and for unbalanced quotes.
    """
    lines = io.TextIOWrapper(io.BytesIO(content), "utf-8", newline="")
    delimiter, skipped = _delimiter(lines)
    reader = csv.reader(lines, delimiter=delimiter, strict=True)
    line = 0
    while (row := _next(reader, label, line + skipped + 1, characters)) is not None:
        if any(cell.strip() for cell in row):
            yield line + skipped + 1, row
        line = reader.line_num


def _next(reader: Any, label: str, line: int, characters: int) -> list[str] | None:
    """The next row, None at the end. The limit is the whole process's, so it is put back."""
    before = csv.field_size_limit(characters)
    try:
        return next(reader, None)
    except csv.Error as error:
        if "field limit" in str(error):
            text, right = N_("a cell is longer than %(limit)s characters, or its quote is not closed"), None
            raise _refused(label, line, text, right, limit=characters) from None
        raise _refused(label, line, N_("the quotes of this line are not balanced")) from None
    finally:
        csv.field_size_limit(before)


def _delimiter(lines: io.TextIOWrapper) -> tuple[str, int]:
    """What parts cells, and how many lines stand before the table: Excel's own `sep=;`.

    It is found from the lines below the titles, which the latter half of the first ones are. A semicolon wins, as the
    comma is then a decimal one or parts name and unit. A single column is taken to be parted by semicolons too, so
    that its decimal commas are none.
    """
    count, first = next(((number, line) for number, line in enumerate(lines, 1) if line.strip()), (0, ""))
    if said := re.fullmatch("sep=([;,\t])\\s*", first, re.IGNORECASE):
        return said[1], count
    lines.seek(0)
    bare = [_QUOTED.sub("", line) for line in islice(filter(str.strip, lines), FIRST)]
    lines.seek(0)
    table = bare[len(bare) // 2 :]
    for sign in ";\t":
        if table and 2 * sum(sign in line for line in table) >= len(table):
            return sign, 0
    return ("," if any("," in line and _LETTER.search(line) for line in bare) else ";"), 0


def _refused(
    label: str, line: int | None, text: str, right: Message | None = None, **values: Any
) -> ProblemError:
    return ProblemError([replace(mistake(text, (), right, **values), file=label, line=line)])
