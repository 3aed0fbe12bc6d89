"""A student's file -> its cells, each with the quantity, the row and the unit that it is said to be of.

Sheets have a line a position or a line a quantity, with a title above them, units in heads, in a row or a column of
their own, or behind the numbers; YAML says the same (see `answers`).
"""

from __future__ import annotations

import math
import re
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from tmm_report import yamlread
from tmm_report.intake import cells, sheets
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.units import is_unit
from tmm_report.records import dataclass


def _heads(words: str) -> frozenset[str]:
    return frozenset(words.split(", "))


# heads of columns as students write them, in English, Russian, Ukrainian, Kazakh
POSITION_HEADS = _heads("position, pos, k, n, №, положение, пол, положення, становище, орын, орналасу")
POSITION_WORDS = ("position", "положени", "положенн", "становищ")  # within a head: № положения
POSITION = re.compile(r"(?:position|pos|положение|пол|положення|становище|орын|№)?[\s.:=№]*0*([0-9]{1,3})")
KEY_HEADS = _heads("key, quantity, ключ, величина, обозначение, позначення, кілт, шама")
VALUE_HEADS = _heads("value, значение, число, значення, мәні, мән")
UNIT_HEADS = _heads(
    "unit, units, единица, единицы, единица измерения, единицы измерения, ед, ед. изм, ед.изм, размерность, "
    "одиниця, одиниці, бірлік, бірлігі"
)
MEANING_HEADS = _heads("meaning, name, смысл, название, наименование, что это, назва, що це, бұл не, атауы")
ABOUT = ("student", "variant", "group", "title")  # of the writer: who he is, the teacher's list says
FEW_POSITIONS = 2  # columns named by numbers: as many of them are positions


@dataclass(frozen=True)
class Entry:
    """One cell as it was handed in. `row`: its position or thing, None where the file names none."""

    sheet: str
    quantity: str
    unit: str
    row: str | None
    text: str
    place: tuple[str, int, int]


def readable(label: str, content: bytes, notes: list[Problem], unread: list[Problem]) -> list[Entry]:
    """The cells of a file. What is odd in it is added to the notes; why it cannot be read at all, to both."""
    try:
        return [*_entries(label, content, notes)]
    except ProblemError as error:
        notes += error.problems
        unread += error.problems
        return []


def _entries(label: str, content: bytes, notes: list[Problem]) -> Iterator[Entry]:
    suffix = label.rpartition(".")[2].lower()
    if suffix in ("yaml", "yml"):
        yield from _of_yaml(yamlread.loads(content, label, notes), label, notes)
        return
    for sheet in sheets.read_sheets(label, label, content):
        notes.extend(sheet.notes)
        yield from _of_sheet(sheet)


def _of_sheet(sheet: sheets.Sheet) -> Iterator[Entry]:
    heads = [_head(text) for text in sheet.header]
    names = [plain(name) for name, _ in heads]
    key = _first(names, KEY_HEADS)
    value = _first(names, VALUE_HEADS)
    if key is not None and value is not None:
        unit = _first(names, UNIT_HEADS)
        for row in sheet.rows:
            stated = row[unit].text if unit is not None else ""
            yield _entry(sheet, row[key].text, stated, None, row[value])
        return
    if positions := _lying(names):
        yield from _of_lying(sheet, positions, _first(names, UNIT_HEADS))
        return
    label = _label(names)
    rows = list(sheet.rows)
    if rows and _are_units(rows[0], label):
        below = [cells.header(f"x ({cell.text})")[1] for cell in rows.pop(0)]
        heads = [(name, own or unit_) for (name, own), unit_ in zip(heads, below, strict=False)]
    for row in rows:
        for (name, unit_), cell, index in zip(heads, row, range(len(row)), strict=False):
            if index != label and name and cell.text:
                yield _entry(sheet, name, unit_, row[label].text.strip(), cell)


def _head(text: str) -> tuple[str, str]:
    """Name and unit of a column: also `v_B м/с` and `v_B / (м/с)`."""
    name, unit = cells.header(text)
    if not unit and (found := re.fullmatch(r"(\S+) +(\S.*)", name)) and is_unit(found[2]):
        return found[1], found[2]
    return name.rstrip(" /:"), unit


def _lying(names: Sequence[str]) -> dict[int, str]:
    """Of a table with a line a quantity and a column a position, as courses print them: the position of each column;
    nothing of another table."""
    found = {
        index: position[1]
        for index, name in enumerate(names)
        if index and (position := POSITION.fullmatch(name.rstrip(".,")))
    }
    others = (name for index, name in enumerate(names) if index and index not in found)
    known = all(not name or name in UNIT_HEADS | MEANING_HEADS for name in others)
    return found if known and len(found) >= FEW_POSITIONS else {}


def _of_lying(sheet: sheets.Sheet, positions: Mapping[int, str], unit: int | None) -> Iterator[Entry]:
    for row in sheet.rows:
        name, own = _head(row[0].text)
        stated = own or (row[unit].text if unit is not None else "")
        for index, position in positions.items():
            if name:
                yield _entry(sheet, name, stated, position, row[index])


def _are_units(row: Sequence[sheets.Cell], label: int) -> bool:
    """Whether the line under the head says the units: no position, no number, some words."""
    said = plain(row[label].text)
    texts = [cell.text for at, cell in enumerate(row) if at != label and not cells.is_blank(cell.text)]
    words = bool(texts) and all(math.isnan(cells.number(text)) for text in texts)
    return words and (not said or said in UNIT_HEADS)


def _label(names: Sequence[str]) -> int:
    """The column that names the rows: that of the positions, else the first."""
    known = _first(names, POSITION_HEADS)
    if known and len(names[known]) == 1:  # n is a quantity, too: speed
        known = 0
    if known is None:
        with_word = (i for i, name in enumerate(names) if any(word in name for word in POSITION_WORDS))
        known = next(with_word, 0)
    return known


def _entry(sheet: sheets.Sheet, quantity: str, unit: str, row: str | None, cell: sheets.Cell) -> Entry:
    return Entry(
        sheet.name, quantity.strip(), unit.strip(), row, cell.text, (sheet.label, cell.line, cell.column)
    )


def _first(names: Sequence[str], known: Container[str]) -> int | None:
    return next((index for index, name in enumerate(names) if name in known), None)


def plain(name: str) -> str:
    """A name as names are compared."""
    return name.strip().strip(".").casefold()


def _of_yaml(document: yamlread.Document, label: str, notes: list[Problem]) -> Iterator[Entry]:
    data = document.data
    if not isinstance(data, dict):
        right = Message(N_("start from the sheet that `tmm-report grade --template` writes"))
        raise ProblemError([replace(mistake(N_("the file has no answers"), right=right), file=label)])
    units = data.get("units")
    walker = _Yaml(document, label, notes, units if isinstance(units, dict) else {})
    for key, value in data.items():
        if key not in ("units", *ABOUT):
            yield from walker.top(key, value)


@dataclass(frozen=True, eq=False)
class _Yaml:
    """The cells of a YAML file of answers."""

    document: yamlread.Document
    label: str
    notes: list[Problem]
    units: Mapping[str, Any]

    def top(self, key: str, value: Any) -> Iterator[Entry]:
        """`7: {…}`, `v_B: […]`, `H_B: 200 mm`, `values: {…}` or a table by its name."""
        if not isinstance(value, dict):
            yield from self.column("", key, value, (key,))
        elif is_position(key):
            yield from self.row("", key, value, (key,))
        else:
            for inner, below in value.items():
                path = (key, inner)
                if isinstance(below, dict):
                    yield from self.row(key, inner, below, path)
                else:
                    # `values: {H_B: 200 mm}`, `v_B: {7: 4.44}`, or a list by positions in a table
                    one = (key, inner) if is_position(inner) else (inner, None)
                    sheet = "" if is_position(inner) or key in ("values", "scales") else key
                    yield from self.column(sheet, one[0], below, path, one[1])

    def row(self, sheet: str, row: str, value: Mapping[str, Any], path: yamlread.Path) -> Iterator[Entry]:
        """`7: {v_B: 4.44}`, or `v_B: {7: 4.44}` within a table."""
        for key, below in value.items():
            name, at = (row, key) if is_position(key) and not is_position(row) else (key, row)
            yield from self.column(sheet, name, below, (*path, key), at)

    def column(
        self, sheet: str, name: str, value: Any, path: yamlread.Path, row: str | None = None
    ) -> Iterator[Entry]:
        """A single answer, or a list of them by positions."""
        if isinstance(value, list) and row is None:
            for index, item in enumerate(value):
                yield self.entry(sheet, name, str(index), item, (*path, index))
        else:
            yield self.entry(sheet, name, row, value, path)

    def entry(self, sheet: str, name: str, row: str | None, value: Any, path: yamlread.Path) -> Entry:
        line, column = self.document.places.get(path, (1, 1))
        text = "" if value is None else self.document.raw.get(path, str(value))
        if isinstance(value, dict | list):
            self.notes.append(
                replace(
                    mistake(N_("a number is expected here"), path), file=self.label, line=line, column=column
                )
            )
            text = ""
        unit = self.units.get(name, "")
        return Entry(
            sheet, name, unit if isinstance(unit, str) else "", row, text, (self.label, line, column)
        )


def is_position(key: str) -> bool:
    return re.fullmatch("[0-9]{1,3}", key) is not None
