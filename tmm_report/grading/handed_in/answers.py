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
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

import numpy as np

from tmm_report.grading.handed_in.entries import Entry, plain, readable
from tmm_report.grading.model import Answered, Answers, Asked, Expected, Name
from tmm_report.intake import cells
from tmm_report.judging.asked import of_motion
from tmm_report.problems import N_, Message, Problem, mistake, shown
from tmm_report.quantity import naming
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.units import WrongValue, between, is_unit

ROW_WORDS = re.compile(r"(?:position|pos|положение|пол|становище|№|n|k)?[\s.:=№]*0*(\d{1,3})")
SCALES = ("mu_l", "mu_v", "mu_a", "mu_F")
LARGEST_SCALE = 1e9
LONGEST = 60  # characters of a number with its unit
_UNIT_BEGINS = re.compile(r"(?<=\s)1\s?/|(?<![^\W\d_])[^\W\d_]|[°%]|[(\[](?=[^\W\d_])")
NOTES = 50  # more of them are counted, not told


def read(
    files: Sequence[tuple[str, bytes]],
    id: str,
    asked: Expected,
    also: Sequence[tuple[Quantity, Name]] = (),
    counts: Callable[[Asked], bool] = lambda one: True,
    unread: list[Problem] | None = None,
) -> Answers:
    """The answers of one student, of which there may be several files: (label, content) each.

    `also`: other quantities whose numbers are those of a column asked, R₅₄ for R₄₅. `counts`: whether a column is worth
    points: of several that a name can mean, z of the wheels or of a list of speeds, such a one is meant.

    What is wrong in them is among the notes: a cell, or a file that cannot be read at all; the latter is added to
    `unread`, too.
    """
    notes: list[Problem] = []
    faults: list[Problem] = [] if unread is None else unread
    entries = [entry for label, content in files for entry in readable(label, content, notes, faults)]
    wanted = _Wanted(asked, also, counts)
    scales = _scales(entries, notes)
    columns = _columns(entries, wanted, notes)
    return Answers(id, columns, scales, tuple(_few(notes)))


def _few(notes: list[Problem]) -> list[Problem]:
    if len(notes) <= NOTES:
        return notes
    more = mistake(N_("and %(count)s more of such lines"), count=len(notes) - NOTES)
    return [*notes[:NOTES], replace(more, file=notes[0].file)]


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
            table: {plain(row): index for index, row in enumerate(rows)} for table, rows in labels.items()
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
    label = plain(text)
    return label.partition(".")[0].partition(",")[0] if re.fullmatch(r"\d{1,3}[.,]0+", label) else label


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
    """A number with its unit, `200 mm`, `11,5 1/с²`, `3,2 Н м`; nan for what is none."""
    if len(text) > LONGEST:
        return math.nan, ""
    for begun in reversed([*_UNIT_BEGINS.finditer(text)]):
        number, unit = cells.number(text[: begun.start()].strip()), text[begun.start() :].strip()
        if not math.isnan(number) and not re.fullmatch(r"[eExX][-+]?\d+", unit):
            return (number, unit) if len(unit.split()) == 1 or is_unit(unit) else (math.nan, "")
    return math.nan, ""


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
