"""`tmm-report assign`: individual variants drawn from ranges, every one proven, as a table and as files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from tmm_report.assignments import people as lists
from tmm_report.assignments.draw import Draw, rows
from tmm_report.assignments.fill import form
from tmm_report.assignments.model import Ranges
from tmm_report.assignments.numbers import Cell
from tmm_report.assignments.people import Person, numbered
from tmm_report.assignments.prove import Proof, Rejection, proof
from tmm_report.assignments.ranges import read
from tmm_report.commands.files import write
from tmm_report.commands.talk import Talk, failure, unwritable, written
from tmm_report.i18n import Translator
from tmm_report.languages import DEFAULT, stated_in
from tmm_report.problems import N_, Message, ProblemError
from tmm_report.yamlread import BYTES, opened

MOST = 100_000
SUFFIXES = (".csv", ".xlsx")
HEADS = ("id", "student", "group", "variant")

Drawn = Sequence[tuple[Person, Mapping[str, Cell]]]


def run(
    ranges: Path,
    count: int | None,
    seed: int,
    students: Path | None,
    output: Path,
    folder: Path | None,
    language: str | None,
    talk: Talk,
) -> bool:
    """Draw the variants and write their table, and with `folder` their files. Raises ProblemError."""
    _check(count, seed, students, output)
    stated = _read(ranges)
    tr = Translator(language or str(stated.template.data.get("language", DEFAULT)))
    talk.speak(tr.language)
    people = _people(count, students)
    talk.stage(Message(N_("solving the template")))
    held = proof(stated, form(stated.template, stated.parameters))
    draw = Draw(stated)
    drawn = list(zip(people, _drawn(draw, held, people, seed, talk), strict=True))
    _write(output.parent, {output.name: _table(stated, drawn, output, tr.decimal)})
    if folder is not None:
        _write(
            folder,
            {f"{one.id}.yaml": held.form.text(stated.parameters, cells, one.title) for one, cells in drawn},
        )
    _tell(draw, talk)
    talk.tell(written(output, *([f"{folder}/"] if folder is not None else [])))
    return True


def _read(ranges: Path) -> Ranges:
    """Raises ProblemError, in the language that the ranges state."""
    try:
        return read(ranges)
    except ProblemError as error:
        raise ProblemError(error.problems, error.language or _language(ranges)) from None


def _language(ranges: Path) -> str:
    """That which a file of ranges states; "" where it cannot be read."""
    try:
        return stated_in(opened(ranges, str(ranges), BYTES))
    except ProblemError:
        return ""


def _check(count: int | None, seed: int, students: Path | None, output: Path) -> None:
    """What is wrong with the command line. Raises ProblemError."""
    if count is None and students is None:
        raise failure(N_("say how many variants: -n 30, or --students list.csv"))
    if count is not None and not 1 <= count <= MOST:
        raise failure(N_("-n: from 1 to %(most)s variants"), most=MOST)
    if not 0 <= seed < 2**63:
        raise failure(N_("--seed: a whole number that is not negative is expected"))
    if output.suffix.lower() not in SUFFIXES:
        raise failure(N_("%(file)s: the table is written as .csv or .xlsx"), file=output)


def _people(count: int | None, students: Path | None) -> list[Person]:
    """Who gets a variant: the students of the list, then nobody yet. Raises ProblemError."""
    known = lists.students(students) if students is not None else []
    if count is None:
        return known
    if count < len(known):
        raise failure(
            N_("-n %(count)s: the list has %(students)s students"), count=count, students=len(known)
        )
    return [*known, *numbered(count)[len(known) :]]


def _drawn(
    draw: Draw, held: Proof, people: Sequence[Person], seed: int, talk: Talk
) -> Iterator[Mapping[str, Cell]]:
    """The values of everyone's variant, proven under his name."""

    def rejects(number: int, cells: Mapping[str, Cell]) -> Rejection | None:
        return held.rejects(cells, people[number - 1].title)

    text = N_("drawing: %(done)s of %(all)s, tries: %(tries)s")
    for cells in rows(draw, len(people), seed, rejects):
        talk.stage(Message(text, {"done": draw.found, "all": len(people), "tries": draw.tries}))
        yield cells


def _tell(draw: Draw, talk: Talk) -> None:
    """How many were drawn, and what rejected the others."""
    text = N_("variants drawn: %(found)s, every one solved; rejected on the way: %(rejected)s")
    talk.tell(Message(text, {"found": draw.found, "rejected": draw.rejected}))
    for count, why in draw.listed():
        talk.tell(Message("  %(count)s: %(why)s", {"count": count, "why": why}))


# ---------------------------------------------------------------- the files


def _table(ranges: Ranges, drawn: Drawn, output: Path, decimal: str) -> bytes:
    """The table by its suffix: a row a student, a column a parameter."""
    from tmm_report.intake.writing import csv_bytes, xlsx_bytes

    head: list[str | float | int] = [*HEADS, *(parameter.head for parameter in ranges.parameters)]
    table = [head, *(_row(ranges, one, cells) for one, cells in drawn)]
    if output.suffix.lower() == ".xlsx":
        return xlsx_bytes({"assignments": table})
    return csv_bytes(table, decimal)


def _row(ranges: Ranges, one: Person, cells: Mapping[str, Cell]) -> list[str | float | int]:
    group = one.group or ranges.template.group
    return [one.id, one.student, group, one.variant, *(_cell(cells[p.name]) for p in ranges.parameters)]


def _cell(cell: Cell) -> str | float | int:
    """A number as short as it is."""
    if isinstance(cell, str):
        return cell
    return int(cell) if cell == int(cell) else float(cell)


def _write(folder: Path, files: Mapping[str, bytes]) -> None:
    try:
        write(folder, files)
    except OSError as error:
        raise unwritable(folder, error) from None
