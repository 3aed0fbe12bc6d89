"""What is read of a workbook's parts: the list of strings, which styles show dates, the cells of a sheet."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from datetime import datetime, timedelta
from functools import lru_cache
from typing import Any

from tmm_report.intake.parts import Enough, Reader, local
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.records import dataclass

STRINGS = 250_000

_DATES = {
    *range(14, 23),
    *range(27, 37),
    *range(45, 48),
    *range(50, 59),
}  # numbers of Excel's own date formats
_ESCAPED = re.compile("_x([0-9A-Fa-f]{4})_")
_HIDDEN = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f\ud800-\udfff\ufffe\uffff]")
_STORED = re.compile(r"[-+]?[0-9]{0,40}\.?[0-9]{0,40}([eE][-+]?[0-9]{1,5})?")
_DIGITS = "0123456789"
_TOLD = 20  # notes of a sheet
_ABOVE = 20  # so many rows may stand above those counted: a title, blank ones, the head


@dataclass(frozen=True)
class Limits:
    """Of each sheet: rows under the head, columns, characters of a cell; of the workbook: sheets."""

    rows: int
    columns: int
    characters: int
    sheets: int


def clean(text: str) -> str:
    """Text without Excel's escapes and without what can be neither seen nor written."""
    return _HIDDEN.sub("", _ESCAPED.sub(lambda found: chr(int(found[1], 16)), text))


class _Text(Reader):
    """Collects the text of elements between `open` and `close`, no more than is needed to see that it is too long."""

    def __init__(self, characters: int):
        self.most, self.taking, self.length = characters + 1, False, 0
        self.pieces: list[str] = []

    def fresh(self) -> None:
        self.taking, self.length, self.pieces = False, 0, []

    def text(self, text: str) -> None:
        if self.taking and self.length < self.most:
            self.pieces.append(text[: self.most])
            self.length += len(text)

    @property
    def collected(self) -> str:
        return "".join(self.pieces)


class Strings(_Text):
    """The texts of the workbook's list of strings: `si` with `t`, or runs with a `t` each; `rPh` is how to say it."""

    def __init__(self, characters: int):
        super().__init__(characters)
        self.found: list[str] = []
        self.said = False

    def start(self, name: str, attributes: dict[str, str]) -> None:
        tag = local(name)
        if tag == "si":
            self.fresh()
        elif tag == "rPh":
            self.said = True
        elif tag == "t":
            self.taking = not self.said

    def end(self, name: str) -> None:
        tag = local(name)
        if tag == "si":
            self.found.append(clean(self.collected))
            if len(self.found) > STRINGS:
                raise Enough
        elif tag == "rPh":
            self.said = False
        elif tag == "t":
            self.taking = False


class Styles(Reader):
    """The number formats of the cells' styles, by the order in which cells refer to them."""

    def __init__(self) -> None:
        self.own: dict[str, str] = {}
        self.formats: list[str] = []
        self.inside = False

    def start(self, name: str, attributes: dict[str, str]) -> None:
        tag = local(name)
        if tag == "numFmt":
            self.own[attributes.get("numFmtId", "")] = attributes.get("formatCode", "")
        elif tag == "cellXfs":
            self.inside = True
        elif tag == "xf" and self.inside:
            self.formats.append(attributes.get("numFmtId", ""))

    def end(self, name: str) -> None:
        if local(name) == "cellXfs":
            self.inside = False

    @property
    def dates(self) -> frozenset[str]:
        """The styles, as cells name them, that show a number as a date or a time."""
        dated = {str(number) for number in _DATES} | {key for key, code in self.own.items() if _dated(code)}
        return frozenset(str(index) for index, key in enumerate(self.formats) if key in dated)


def _dated(code: str) -> bool:
    """Whether a number format has a day, month, year, hour or second outside quotes, brackets and escapes."""
    bare = re.sub(r'"[^"]*"|\[[^\]\[]*\]|\\.|_.', "", code[:200])
    return bool(re.search("[dmyhs]", bare, re.IGNORECASE)) and "general" not in bare.lower()


class Grid(_Text):
    """The cells of a worksheet within the limits: {row: {column: text}}."""

    def __init__(self, label: str, strings: list[str], dates: frozenset[str], limits: Limits):
        super().__init__(limits.characters)
        self.label, self.strings, self.dates, self.limits = label, strings, dates, limits
        self.cells: dict[int, dict[int, str]] = {}
        self.row, self.column, self.said = 0, 0, False
        self.kind, self.style = "n", ""  # of the cell: "s" is an index of strings, "n" a number
        self.cut = False  # whether cells beyond the limits were met
        self.notes: list[Problem] = []
        self.faults: list[Problem] = []

    def start(self, name: str, attributes: dict[str, str]) -> None:
        tag = local(name)
        if tag == "c":
            self.column = _column(attributes.get("r", "")[:12].rstrip(_DIGITS)) or self.column + 1
            self.kind, self.style = attributes.get("t", "n"), attributes.get("s", "")
            self.fresh()
        elif tag in ("v", "t"):
            self.taking = not self.said and (tag == "t") == (self.kind == "inlineStr")
        elif tag == "rPh":
            self.said = True
        elif tag == "row":
            self.begin_row(attributes.get("r", ""))

    def begin_row(self, number: str) -> None:
        self.row = int(number) if re.fullmatch("[0-9]{1,7}", number) else self.row + 1
        self.column = 0
        if self.row > self.limits.rows + _ABOVE:
            self.beyond()
            raise Enough

    def end(self, name: str) -> None:
        tag = local(name)
        if tag == "c":
            if self.pieces:
                self.store()
        elif tag in ("v", "t"):
            self.taking = False
        elif tag == "rPh":
            self.said = False
        elif tag == "sheetData":
            raise Enough

    def store(self) -> None:
        if self.column > self.limits.columns:
            self.beyond()
            return
        text = self.value(self.collected).strip()
        if not text:
            return
        if len(text) > self.limits.characters:
            self.fault(N_("a cell is longer than %(limit)s characters"), limit=self.limits.characters)
        self.cells.setdefault(self.row, {})[self.column] = text

    def value(self, text: str) -> str:
        """The text of the cell: numbers with all their digits, dates written out."""
        if self.kind == "s":
            return self.listed(text)
        if self.kind == "b":
            return {"1": "TRUE", "0": "FALSE"}.get(text, text)
        if self.kind != "n":
            return clean(text)
        return self.date(text) if self.style in self.dates else _number(text)

    def listed(self, index: str) -> str:
        """A text of the workbook's list."""
        if index.isascii() and index.isdigit() and len(index) < 8 and int(index) < len(self.strings):
            return self.strings[int(index)]
        self.fault(N_("the cell stands for a text that the workbook does not hold"))
        return ""

    def date(self, text: str) -> str:
        """Spreadsheets take 1.5 for the first of May: nobody's number, so it comes as a date and is told."""
        value = _finite(text)
        if not 0 <= value < 2_958_466:  # the end of the year 9999
            return text
        day = datetime(1899, 12, 30) + timedelta(days=value)
        written = day.isoformat(" ", "seconds").removesuffix(" 00:00:00")
        self.note(N_("the spreadsheet holds a date here, %(date)s"), _NO_DATE, date=written)
        return written

    def beyond(self) -> None:
        if not self.cut:
            text = N_("cells beyond row %(rows)s or column %(columns)s are not read")
            note = mistake(text, rows=self.limits.rows + 1, columns=self.limits.columns)
            self.notes.append(replace(note, file=self.label))
        self.cut = True

    def note(self, text: str, right: Message | None, **values: Any) -> None:
        if len(self.notes) < _TOLD:
            self.notes.append(self.here(mistake(text, (), right, **values)))

    def fault(self, text: str, **values: Any) -> None:
        if len(self.faults) < _TOLD:
            self.faults.append(self.here(mistake(text, **values)))

    def here(self, problem: Problem) -> Problem:
        return replace(problem, file=self.label, line=self.row, column=self.column)

    def lines(self) -> list[tuple[int, list[str]]]:
        return [
            (row, [cells.get(column, "") for column in range(1, max(cells) + 1)])
            for row, cells in sorted(self.cells.items())
        ]


_NO_DATE = Message(N_("give the cell the format of a number and write the number again"))


@lru_cache(maxsize=1024)
def _column(letters: str) -> int:
    """The number of the column with such letters; 0 for what are none."""
    number = 0
    for letter in letters.upper() if len(letters) <= 3 and letters.isascii() and letters.isalpha() else "":
        number = 26 * number + ord(letter) - 64
    return number


def _number(text: str) -> str:
    """A stored number with the digits that it needs; what is no finite number stays as it is."""
    value = _finite(text)
    if math.isnan(value):
        return clean(text)
    return str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)


def _finite(text: str) -> float:
    if not _STORED.fullmatch(text.strip()):
        return math.nan
    try:
        value = float(text)
    except ValueError:
        return math.nan
    return value if math.isfinite(value) else math.nan
