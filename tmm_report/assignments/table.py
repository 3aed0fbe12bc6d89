"""Variants from a template and a table, a row a student: read and filled in one at a time, however many there are.

for id, label, content in variants_of(Path("compressor.ranges.yaml"), Path("assignments.csv")): ...
"""

from __future__ import annotations

import hashlib
import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from pathlib import Path as File

from tmm_report import yamlread
from tmm_report.assignments import lines, ranges
from tmm_report.assignments.fill import TITLE, Form, form
from tmm_report.assignments.keys import path_of, value_at
from tmm_report.assignments.lines import plain, texts, wrong
from tmm_report.assignments.model import Parameter, Template, complete
from tmm_report.assignments.numbers import Cell, dimension_of
from tmm_report.assignments.people import Person, Row, field_of, person, tidy
from tmm_report.intake import sheets
from tmm_report.intake.cells import header
from tmm_report.intake.cells import number as number_of
from tmm_report.intake.ids import safe
from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.quantity.units import WrongValue, parse
from tmm_report.records import dataclass
from tmm_report.variant.errors import near

Made = tuple[str, str, bytes | ProblemError]
"""Output name, label for messages, and the text of a variant, or what is wrong in its row."""


@dataclass(frozen=True, eq=False)
class Columns:
    """What the columns of a table are. `fields`: what each says of the student, "" of others; `parameters`: by the
    number of the column; `all`: those and the parameters that follow from them."""

    file: str
    fields: tuple[str, ...]
    parameters: tuple[tuple[int, Parameter], ...]
    all: tuple[Parameter, ...]


def variants_of(template: File, table: File) -> Iterator[Made]:
    """The variants of a table's rows, lazily. `template`: a variant, or the ranges file from which it was drawn.

    Raises ProblemError with what is wrong of the template and of the table's head, or where it has no rows.
    """
    document = yamlread.read(template)
    stated: Sequence[Parameter] = ()
    if ranges.is_ranges(document):
        found = ranges.of_document(document, template)
        base, stated = found.template, found.parameters
    else:
        base = ranges.template_of(document, template)
    stream = lines.table(table)
    columns = _columns(stream, base, stated, yamlread.file_label(table))
    made = _made(stream.rows, columns, form(base, columns.all))
    first = next(made, None)
    if first is None:
        raise ProblemError([wrong(columns.file, None, N_("the table is empty"))])
    return itertools.chain([first], made)


# ---------------------------------------------------------------- the head


def _columns(stream: sheets.Stream, template: Template, stated: Sequence[Parameter], file: str) -> Columns:
    known, problems, line = {one.name: one for one in stated}, list[Problem](), stream.line
    fields, found = [], list[tuple[int, Parameter]]()
    for n, text in enumerate(stream.header):
        name, unit = header(plain(text))
        fields.append(field_of(name) or field_of(name.removeprefix("title.")) or "")
        if name and not fields[-1]:
            try:
                found.append((n, _column(name, unit, template, known)))
            except ProblemError as error:
                problems += [
                    replace(problem, file=file, line=line, column=n + 1) for problem in error.problems
                ]
    missing = [p.name for p in stated if not p.of and p.name not in {one.name for _, one in found}]
    problems += [wrong(file, line, N_("there is no column %(name)s"), name=name) for name in missing]
    twice = _twice(fields, found)
    problems += [wrong(file, line, N_("two columns say %(name)s"), name=shown(name)) for name in twice]
    if problems:
        raise ProblemError(problems)
    named = {one.name: one for _, one in found}
    following = tuple(one for one in stated if one.of and one.name not in named)
    return Columns(file, tuple(fields), tuple(found), (*named.values(), *following))


def _twice(fields: Sequence[str], found: Sequence[tuple[int, Parameter]]) -> list[str]:
    """What two columns say."""
    named = [*(field for field in fields if field), *(path for _, one in found for path in one.paths)]
    twice = dict.fromkeys(one for n, one in enumerate(named) if one in named[:n])
    return [one if isinstance(one, str) else ".".join(map(str, one)) for one in twice]


def _column(name: str, unit: str, template: Template, known: dict[str, Parameter]) -> Parameter:
    """The parameter of a column: one of the ranges, or a dotted key of the template. Raises ProblemError."""
    try:
        if name not in known and "." not in name:
            wrong = Message(N_("unknown column %(name)s"), {"name": shown(name)})
            raise ProblemError([Problem(wrong, near(name, [*known, "id", *TITLE]))])
        own = known.get(name) or _dotted(name, template)
        dimension = dimension_of(own.unit)
        if unit and (dimension or not dimension_of(unit)):
            parse(f"1 {unit}", dimension or "number")
    except WrongValue as error:
        raise ProblemError([Problem(error.wrong, error.right, (shown(name),))]) from None
    return replace(own, unit=unit or (own.unit if name in known else ""))


def _dotted(name: str, template: Template) -> Parameter:
    path = path_of(name, template.data)
    if isinstance(value_at(template.data, path), dict | list):
        right = Message(N_("for example, %(example)s"), {"example": "mechanism.links.2.points.B, mm"})
        wrong = Message(N_("%(key)s of the template is not a single value"), {"key": shown(name, 120)})
        raise ProblemError([Problem(wrong, right)])
    return Parameter(name, (path,))


# ---------------------------------------------------------------- the rows


def _made(rows: Iterator[tuple[sheets.Cell, ...] | Problem], columns: Columns, blank: Form) -> Iterator[Made]:
    """A variant a row. A row that cannot be read is given out as what is wrong with it, and the rest go on."""
    taken: set[bytes] = set()
    for count in itertools.count(1):
        try:
            row = next(rows, None)
        except ProblemError as error:  # from here on the file is no table
            yield _free(f"row-{count}", count, taken), columns.file, error
            return
        if row is None:
            return
        if isinstance(row, Problem):
            yield _free(f"row-{row.line}", count, taken), f"{columns.file}:{row.line}", ProblemError([row])
        else:
            yield _one((row[0].line, texts(row)), count, columns, blank, taken)


def _one(row: Row, count: int, columns: Columns, blank: Form, taken: set[bytes]) -> Made:
    problems: list[Problem] = []
    who = _named(
        person(columns.fields, row, columns.file, problems), count, row, columns.file, taken, problems
    )
    cells = _cells(row, columns, problems)
    made = ProblemError(problems) if problems else _text(blank, columns, cells, who)
    return who.id, f"{columns.file}:{row[0]}", made


def _text(blank: Form, columns: Columns, cells: dict[str, Cell], who: Person) -> bytes:
    complete(columns.all, cells)
    return blank.text(columns.all, cells, who.title)


def _named(
    who: Person, count: int, row: Row, file: str, taken: set[bytes], problems: list[Problem]
) -> Person:
    """The person with an output name that no row before has."""
    wanted = safe(who.id or who.student or who.variant or f"v{count:03}")
    if _is_new(wanted, taken):
        return replace(who, id=wanted)
    if who.id:
        right = Message(N_("every student has an id of his own"))
        problems.append(
            wrong(file, row[0], N_("the id %(id)s stands in the table twice"), right, id=shown(who.id))
        )
    return replace(who, id=_free(safe(f"{wanted[:40]}-{count}"), count, taken))


def _free(wanted: str, count: int, taken: set[bytes]) -> str:
    """The output name, or one made of it that no row before has."""
    names = (wanted + f"-{count}" * more for more in itertools.count())
    return next(name for name in names if _is_new(name, taken))


def _is_new(name: str, taken: set[bytes]) -> bool:
    before = len(taken)
    taken.add(_trace(name))
    return len(taken) > before


def _trace(name: str) -> bytes:
    """What is remembered of a name, as file systems compare it: a million of them take little memory."""
    return hashlib.blake2b(name.casefold().encode(), digest_size=8).digest()


def _cells(row: Row, columns: Columns, problems: list[Problem]) -> dict[str, Cell]:
    found: dict[str, Cell] = {}
    for n, parameter in columns.parameters:
        try:
            found[parameter.name] = _cell(row[1][n], parameter)
        except WrongValue as error:
            wrong = Message("%(name)s: %(what)s", {"name": shown(parameter.head, 80), "what": error.wrong})
            problems.append(Problem(wrong, error.right, file=columns.file, line=row[0]))
    return found


def _cell(text: str, parameter: Parameter) -> Cell:
    """A number in the parameter's unit, or a word. Raises WrongValue."""
    if not text:
        right = Message(N_("write the value or take the column out"))
        raise WrongValue(Message(N_("there is no value here")), right)
    value = number_of(text)
    if not math.isnan(value):
        return Decimal(repr(value))
    if parameter.unit or parameter.scales:
        raise WrongValue(Message(N_("%(value)s is not a number"), {"value": shown(text)}))
    try:
        return tidy(text)
    except ValueError:
        raise WrongValue(Message(N_("a control character is not allowed"))) from None
