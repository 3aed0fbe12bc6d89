"""A student's files -> his numbers by the columns asked: YAML, CSV and XLSX, names and units as people write them.

A sheet has a line a position or a line a quantity:

    position  v_B, m/s  w_2, rad/s        key   value  unit
    1         8.12      -34.2             H_B   200    mm

YAML says the same: `7: {v_B: 4.44}`, `v_B: [0, 8.12, …]`, `rates_table: {7: {v_B: 4.44}}`, `values: {H_B: 200 mm}`,
`scales: {mu_v: 0.075}`, `units: {v_B: mm/s}`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report import yamlread
from tmm_report.grading.model import Answered, Answers, Asked, Expected, Name
from tmm_report.intake import cells, sheets
from tmm_report.judging.asked import of_motion
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake, shown
from tmm_report.quantity import naming
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.units import WrongValue, between
from tmm_report.records import dataclass

POSITION_HEADS = ("position", "положение", "становище", "орналасу", "k", "n", "№", "pos", "пол")
POSITION_WORDS = ("position", "положени", "становищ")  # within a head: № положения
ROW_WORDS = re.compile(r"(?:position|pos|положение|пол|становище|№|n|k)?[\s.:=№]*0*(\d{1,3})")
KEY_HEADS = ("key", "quantity", "величина", "обозначение", "позначення")
VALUE_HEADS = ("value", "значение", "число", "значення")
UNIT_HEADS = ("unit", "единица", "ед", "единицы", "одиниця")
SCALES = ("mu_l", "mu_v", "mu_a", "mu_F")
ABOUT = (
    "student",
    "variant",
    "group",
    "title",
)  # what a file says of its writer: who he is, the teacher's list says
FEW_POSITIONS = 2  # columns named by numbers: as many of them are positions
LARGEST_SCALE = 1e9
NOTES = 50  # more of them are counted, not told


@dataclass(frozen=True)
class Entry:
    """One cell as it was handed in. `row`: its position or thing, None where the file names none."""

    sheet: str
    quantity: str
    unit: str
    row: str | None
    text: str
    place: tuple[str, int, int]


def read(
    files: Sequence[tuple[str, bytes]],
    id: str,
    asked: Expected,
    also: Sequence[tuple[Quantity, Name]] = (),
    counts: Callable[[Asked], bool] = lambda one: True,
) -> Answers:
    """The answers of one student, of which there may be several files: (label, content) each.

    `also`: other quantities whose numbers are those of a column asked, R₅₄ for R₄₅. `counts`: whether a column is worth
    points: of several that a name can mean, z of the wheels or of a list of speeds, such a one is meant.

    What is wrong in them is among the notes: a cell, or a file that cannot be read at all.
    """
    notes: list[Problem] = []
    entries = [entry for label, content in files for entry in _readable(label, content, notes)]
    wanted = _Wanted(asked, also, counts)
    scales = _scales(entries, notes)
    columns = _columns(entries, wanted, notes)
    return Answers(id, columns, scales, tuple(_few(notes)))


def _few(notes: list[Problem]) -> list[Problem]:
    if len(notes) <= NOTES:
        return notes
    more = mistake(N_("and %(count)s more of such lines"), count=len(notes) - NOTES)
    return [*notes[:NOTES], replace(more, file=notes[0].file)]


# ---------------------------------------------------------------- cells of a file


def _readable(label: str, content: bytes, notes: list[Problem]) -> list[Entry]:
    try:
        return [*_entries(label, content, notes)]
    except ProblemError as error:
        notes += error.problems
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
    heads = [cells.header(text) for text in sheet.header]
    names = [_plain(name) for name, _ in heads]
    key = _first(names, KEY_HEADS)
    value = _first(names, VALUE_HEADS)
    if key is not None and value is not None:
        unit = _first(names, UNIT_HEADS)
        for row in sheet.rows:
            stated = row[unit].text if unit is not None else ""
            yield _entry(sheet, row[key].text, stated, None, row[value])
        return
    if len(names) > FEW_POSITIONS and all(map(_is_position, filter(None, names[1:]))):
        yield from _of_lying(sheet, names)
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


def _of_lying(sheet: sheets.Sheet, positions: Sequence[str]) -> Iterator[Entry]:
    """A table with a line a quantity and a column a position, as courses print them."""
    for row in sheet.rows:
        name, unit = cells.header(row[0].text)
        for position, cell in zip(positions[1:], row[1:], strict=False):
            if name and position:
                yield _entry(sheet, name, unit, position, cell)


def _are_units(row: Sequence[sheets.Cell], label: int) -> bool:
    """Whether the line under the head says the units: no position, no number, some words."""
    texts = [cell.text for cell in row if not cells.is_blank(cell.text)]
    return not row[label].text.strip() and bool(texts) and all(math.isnan(cells.number(x)) for x in texts)


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


def _first(names: Sequence[str], known: Sequence[str]) -> int | None:
    return next((index for index, name in enumerate(names) if name in known), None)


def _plain(name: str) -> str:
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
        elif _is_position(key):
            yield from self.row("", key, value, (key,))
        else:
            for inner, below in value.items():
                path = (key, inner)
                if isinstance(below, dict):
                    yield from self.row(key, inner, below, path)
                else:
                    # `values: {H_B: 200 mm}`, `v_B: {7: 4.44}`, or a list by positions in a table
                    one = (key, inner) if _is_position(inner) else (inner, None)
                    sheet = "" if _is_position(inner) or key in ("values", "scales") else key
                    yield from self.column(sheet, one[0], below, path, one[1])

    def row(self, sheet: str, row: str, value: Mapping[str, Any], path: yamlread.Path) -> Iterator[Entry]:
        """`7: {v_B: 4.44}`, or `v_B: {7: 4.44}` within a table."""
        for key, below in value.items():
            name, at = (row, key) if _is_position(key) and not _is_position(row) else (key, row)
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


def _is_position(key: str) -> bool:
    return re.fullmatch("[0-9]{1,3}", key) is not None


# ---------------------------------------------------------------- which column is meant


class _Wanted:
    """Finds the column asked that a name means. Names are remembered: a sheet has as many cells a name as positions."""

    def __init__(
        self, asked: Expected, also: Sequence[tuple[Quantity, Name]], counts: Callable[[Asked], bool]
    ):
        self.asked = asked
        self.counts = counts
        self.tables = {table for table, _ in asked}
        self.keys: dict[str, list[Asked]] = {}
        for one in sorted(asked.values(), key=lambda one: not one.by_position):
            self.keys.setdefault(one.key, []).append(one)
        self.quantities = [ones[0].quantity for ones in self.keys.values()]
        for quantity, name in also:
            if quantity.key not in self.keys and name in asked:
                self.keys[quantity.key] = [asked[name]]
                self.quantities.append(quantity)
        labels = {table: one.rows for (table, _), one in asked.items()}
        self.rows = {
            table: {_plain(row): index for index, row in enumerate(rows)} for table, rows in labels.items()
        }
        self.known: dict[tuple[str, str], tuple[Asked, ...]] = {}
        # of a sheet's column, the column by positions that it meant
        self.usual: dict[tuple[str, str], Asked] = {}

    def find(self, sheet: str, name: str) -> tuple[Asked, ...]:
        """The columns that the name can mean: in the sheet's own table, else those by positions first."""
        if (sheet, name) not in self.known:
            found = [one for quantity in self.meant(sheet, name) for one in self.keys[quantity.key]]
            table = self.table(sheet)
            found = [one for one in found if one.table == table] or found
            self.known[sheet, name] = tuple(
                sorted(found, key=lambda one: (not one.by_position, not self.counts(one)))
            )
        return self.known[sheet, name]

    def table(self, sheet: str) -> str | None:
        """The table that a sheet is named by; `sheet-stage1_wheels`, as templates are, is `stage1_wheels`."""
        named = sheet if sheet in self.tables else sheet.rpartition("-")[2]
        return named if named and named in self.tables else None  # single numbers have a table without a name

    def meant(self, sheet: str, name: str) -> list[Quantity]:
        """Of V_B, the velocity of a slider along its guide, and v_B, that of its plan, VB is the latter: so guides
        write it."""
        if name in self.keys:  # as sheets made by `template` have it
            return [self.keys[name][0].quantity]
        meant = naming.resolve(name, self.quantities)
        motion = [one for one in meant if name != one.key and all(map(of_motion, self.keys[one.key]))]
        if motion and not (self.table(sheet) or "").startswith("outputs_"):
            small = [
                one
                for one in naming.resolve(name[:1].lower() + name[1:], self.quantities)
                if one not in motion
            ]
            return small or meant
        return meant

    def cell(self, entry: Entry) -> tuple[Asked, int] | None:
        """The column and the row that a cell answers; None where there is none, or where it may be one of several."""
        if entry.row is not None and (usual := self.usual.get((entry.sheet, entry.quantity))) is not None:
            row = self.rows[usual.table].get(entry.row)
            if row is not None:
                return usual, row
        found = self._cell(entry)
        if found is not None and found[0].by_position:
            self.usual[entry.sheet, entry.quantity] = found[0]
        return found

    def _cell(self, entry: Entry) -> tuple[Asked, int] | None:
        found = self.find(entry.sheet, entry.quantity)
        if entry.row is None:
            single = [one for one in found if one.table == ""]
            return (single[0], 0) if len(single) == 1 else None
        row = _row(entry.row)
        if not any(row in self.rows[one.table] for one in found if one.table):
            row = _position(row)
        here = [one for one in found if one.table and row in self.rows[one.table]]
        if not here or (
            len(here) > 1 and here[0].key != here[1].key and here[1].by_position == here[0].by_position
        ):
            return None
        return here[0], self.rows[here[0].table][row]

    def unknown(self, name: str) -> Problem:
        """Why no column is meant by a name."""
        near = naming.nearest(name, self.quantities)
        right = Message(N_("did you mean %(near)s?"), {"near": near[0]}) if near else None
        return mistake(N_("%(key)s is not asked"), right=right, key=shown(name))


def _row(text: str) -> str:
    """The label of a row: of a position its number, "7.0" and "7" alike."""
    plain = _plain(text)
    return plain.partition(".")[0].partition(",")[0] if re.fullmatch(r"\d{1,3}[.,]0+", plain) else plain


def _position(row: str) -> str:
    """The number of a position in "01", "пол. 1" and "№ 1"; what is none stays as it is."""
    found = ROW_WORDS.fullmatch(row)
    return found[1] if found else row


# ---------------------------------------------------------------- columns


class _Column:
    """A column of answers while it is filled."""

    def __init__(self, asked: Asked):
        count = len(asked.rows)
        self.asked = asked
        self.values, self.given = np.full(count, np.nan), np.zeros(count, dtype=bool)
        self.texts, self.places = [""] * count, [""] * count
        self.unit = ""

    def fill(self, row: int, number: float, entry: Entry) -> None:
        self.values[row], self.given[row] = number, True
        self.texts[row], self.places[row] = shown(entry.text), _place(entry)
        self.unit = self.unit or entry.unit

    def answered(self) -> Answered:
        return Answered(self.values, self.given, tuple(self.texts), tuple(self.places), self.unit)


def _columns(entries: Iterable[Entry], wanted: _Wanted, notes: list[Problem]) -> dict[Name, Answered]:
    filled: dict[Name, _Column] = {}
    told: set[tuple[str, str]] = set()
    for entry in entries:
        if cells.is_blank(entry.text) or entry.quantity in SCALES:
            continue
        found = wanted.cell(entry)
        if found is None:
            _unknown(entry, wanted, told, notes)
            continue
        asked, row = found
        if (column := filled.get(asked.name)) is None:
            column = filled[asked.name] = _Column(asked)
        if column.given[row]:
            text = N_("%(key)s is answered twice; the first answer counts")
            notes.append(_note(entry, mistake(text, key=shown(entry.quantity))))
        else:
            column.fill(row, _number(entry, asked, told, notes), entry)
    return {name: filled[name].answered() for name in wanted.asked if name in filled}


def _unknown(entry: Entry, wanted: _Wanted, told: set[tuple[str, str]], notes: list[Problem]) -> None:
    """Told once for each name, or for each name and row."""
    known = wanted.find(entry.sheet, entry.quantity)
    key = (entry.quantity, (entry.row or "") if known else "")
    if key not in told:
        told.add(key)
        told_of = len(notes) < NOTES  # the others are counted: what they were near to is not looked for
        notes.append(_note(entry, _why(entry, wanted, known) if told_of else mistake("%(more)s", more="…")))


def _why(entry: Entry, wanted: _Wanted, known: Sequence[Asked]) -> Problem:
    """Why a cell answers nothing that is asked."""
    name = shown(entry.quantity)
    if not known:
        return wanted.unknown(entry.quantity)
    here = {
        one.key: one.quantity
        for one in known
        if entry.row is None or _row(entry.row) in wanted.rows[one.table]
    }
    if len(here) > 1:
        return naming.ambiguous(entry.quantity, [*here.values()])
    if entry.row is None:
        return mistake(N_("%(key)s needs the number of the position, or the name of the part"), key=name)
    right = Message(N_("known: %(words)s"), {"words": shown(", ".join(known[0].rows), 120)})
    return mistake(N_("%(key)s has no row %(row)s"), right=right, key=name, row=shown(entry.row))


def _number(entry: Entry, asked: Asked, told: set[tuple[str, str]], notes: list[Problem]) -> float:
    """The number in the unit asked; nan for what is none. A head's unit that is none is noted once."""
    number = cells.number(entry.text)
    if math.isnan(number):
        number, unit = _with_unit(entry.text)
        if math.isnan(number):
            notes.append(_note(entry, mistake(N_("%(given)s is not a number"), given=shown(entry.text))))
            return number
    else:
        unit = entry.unit
    try:
        return number * between(unit, asked.unit) if unit else number
    except WrongValue as error:
        if (entry.quantity, unit) not in told:
            told.add((entry.quantity, unit))
            text = N_("%(key)s: %(wrong)s; taken as %(unit)s")
            values = {"key": shown(entry.quantity), "wrong": error.wrong, "unit": asked.unit or "1"}
            notes.append(_note(entry, Problem(Message(text, values))))
        return number


def _with_unit(text: str) -> tuple[float, str]:
    """A number with its unit, `200 mm`; nan for what is none."""
    parts = (
        re.fullmatch(r"(.*[0-9.,])\s*([^\W\d_]{1,8}[^\s]{0,20}|[°%])", text.strip())
        if len(text) <= 60
        else None
    )
    if parts is None or re.fullmatch(r"[eExX][-+]?\d+", parts[2]):
        return math.nan, ""
    return cells.number(parts[1]), parts[2]


def _scales(entries: Iterable[Entry], notes: list[Problem]) -> dict[str, float]:
    found: dict[str, float] = {}
    for entry in entries:
        if entry.quantity in SCALES and not cells.is_blank(entry.text):
            number = cells.number(entry.text)
            if 0 < number < LARGEST_SCALE:
                found.setdefault(entry.quantity, number)
            else:
                notes.append(_note(entry, mistake(N_("%(given)s is not a scale"), given=shown(entry.text))))
    return found


def _note(entry: Entry, problem: Problem) -> Problem:
    file, line, column = entry.place
    return replace(problem, file=file, line=line, column=column)


def _place(entry: Entry) -> str:
    label, line, column = entry.place
    return f"{label}:{line}:{column}"
