"""What is written for spreadsheets, CSV and XLSX: numbers are numbers, and foreign text is text, never a formula.

Same rows, same bytes: nothing of the day or of the machine is written.
"""

from __future__ import annotations

import csv
import io
import math
import numbers
import re
import zipfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

Value = str | float | int | None

_FORMULA = tuple("=+-@\t\r\n＝＋－＠")
_BEGUN = re.compile(r"[\s\u00ad\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]*[=+\-@\t\r\n＝＋－＠]")
_INNER = re.compile("([,;\t\r\n][\"']?)([=+\\-@＝＋－＠])")
_HIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\ud800-\udfff\ufffe\uffff]")
_ESCAPE = re.compile("_(?=x[0-9A-Fa-f]{4}_)")
_TITLE = re.compile(r"[\[\]:*?/\\]")
_SAVED = re.compile(rb"(<dcterms:(?:created|modified)[^>]*>)[^<]*")
_LONGEST = 32_767  # characters of a cell
_WIDTHS = (8, 40)  # of a column, when nothing is said


def csv_bytes(rows: Iterable[Sequence[Value]], decimal: str) -> bytes:
    """A CSV file as spreadsheets expect it: where the decimal sign is a comma, cells are parted by semicolons.

    Text that a spreadsheet would take for a formula gets an apostrophe in front; numbers never do. What is no
    number (nan, infinity, None) is an empty cell.
    """
    return b"".join(csv_lines(rows, decimal))


def csv_lines(rows: Iterable[Sequence[Value]], decimal: str) -> Iterator[bytes]:
    """The same row by row, for tables too long to be held: the first line begins with the mark of UTF-8."""
    out = io.StringIO()
    writer = csv.writer(out, delimiter=";" if decimal == "," else ",", lineterminator="\r\n")
    mark = "\ufeff"
    for row in rows:
        writer.writerow([_csv_cell(value, decimal) for value in row])
        yield (mark + out.getvalue()).encode()
        mark = ""
        out.seek(0)
        out.truncate()


def _csv_cell(value: Value, decimal: str) -> str:
    if isinstance(value, str):
        return guarded(_clean(value))
    if value is None or not math.isfinite(value):
        return ""
    return _number(value).replace(".", decimal)


def guarded(text: str) -> str:
    """Text that no spreadsheet takes for a formula, neither the whole nor what follows a sign by which a
    spreadsheet of another country would part it."""
    inner = _INNER.sub(r"\1'\2", text)
    return "'" + inner if _BEGUN.match(inner) else inner


def unguarded(text: str) -> str:
    """The text without the apostrophe that `guarded` puts in front."""
    return text[1:] if text[:1] == "'" and _BEGUN.match(text, 1) else text


def _clean(text: str) -> str:
    """Without what can be neither seen nor written in XML; ends of lines are one character."""
    return _HIDDEN.sub("", text.replace("\r\n", "\n"))


def xlsx_bytes(
    sheets: Mapping[str, Sequence[Sequence[Value]]],
    widths: Mapping[str, Sequence[float]] | None = None,
    titles: int = 0,
) -> bytes:
    """A workbook with a sheet for each name, its head bold and in view, with so many rows of titles above it; `widths`
    of its columns by sheet.

    Text cells are typed as text, so that none is a formula. Names are cut to what Excel allows, and told apart.
    """
    from openpyxl import Workbook

    book = Workbook(write_only=True)
    for title, (name, rows) in zip(_titles(sheets), sheets.items(), strict=True):
        _fill(
            book.create_sheet(title), rows, (widths or {}).get(name) or _measured(rows[titles:]), titles + 1
        )
    if not sheets:
        book.create_sheet("Sheet")
    out = io.BytesIO()
    book.save(out)
    return _dateless(out)


def _fill(sheet: Any, rows: Sequence[Sequence[Value]], widths: Sequence[float], head: int) -> None:
    """Write the rows; what stands before them in the file, widths and the frozen head, is said before."""
    from openpyxl.styles import Font
    from openpyxl.utils import get_column_letter

    bold = Font(bold=True)
    sheet.freeze_panes = f"A{head + 1}"
    for column, width in enumerate(widths, 1):
        sheet.column_dimensions[get_column_letter(column)].width = width
    for index, row in enumerate(rows):
        sheet.append([_xlsx_cell(sheet, value, bold if index < head else None) for value in row])


def _xlsx_cell(sheet: Any, value: Value, font: Any) -> Any:
    """A cell typed as what it is. It is filled behind the library's back, which would make a formula of "=1" and
    write numbers with 16 digits."""
    from openpyxl.cell import WriteOnlyCell

    cell = WriteOnlyCell(sheet, None)
    if isinstance(value, str):
        cell._value, cell.data_type = _xlsx_text(value), "s"
        if value.startswith(_FORMULA):
            cell.quotePrefix = True
    elif value is not None and math.isfinite(value):
        cell._value, cell.data_type = _number(value), "n"
    if font is not None:
        cell.font = font
    return cell


def _number(value: float | int) -> str:
    return str(int(value)) if isinstance(value, numbers.Integral) else repr(float(value) + 0.0)


def _xlsx_text(text: str) -> str:
    """Text as XLSX spells it: `_x0041_` would be read as A, so that its first sign is spelled out."""
    return _ESCAPE.sub("_x005F_", _clean(text).replace("\r", "\n"))[:_LONGEST]


def _measured(rows: Sequence[Sequence[Value]]) -> list[float]:
    """Widths by the longest of the first texts of each column."""
    width = max((len(row) for row in rows), default=0)
    texts = [[str(row[column]) for row in rows[:50] if column < len(row)] for column in range(width)]
    least, most = _WIDTHS
    return [float(min(most, max([least, *(len(text) + 2 for text in column)]))) for column in texts]


def _titles(names: Iterable[str]) -> list[str]:
    """Names fit for sheets: at most 31 characters, without `[]:*?/\\` and apostrophes around, no two alike."""
    titles: list[str] = []
    taken = {"history"}  # Excel keeps it to itself
    for name in names:
        wanted = _TITLE.sub("_", " ".join(_clean(name).split()))[:31].strip("' ") or "Sheet"
        title, number = wanted, 1
        while title.casefold() in taken:
            number += 1
            title = f"{wanted[: 31 - len(str(number)) - 1]}-{number}"
        taken.add(title.casefold())
        titles.append(title)
    return titles


def _dateless(saved: io.BytesIO) -> bytes:
    """The workbook packed anew with one date for all: that of its parts, and of its making."""
    out = io.BytesIO()
    with zipfile.ZipFile(saved) as old, zipfile.ZipFile(out, "w") as new:
        for name in old.namelist():
            info = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            info.create_system, info.compress_type = 0, zipfile.ZIP_DEFLATED
            content = old.read(name)
            if name == "docProps/core.xml":
                content = _SAVED.sub(rb"\g<1>2000-01-01T00:00:00Z", content)
            new.writestr(info, content)
    return out.getvalue()
