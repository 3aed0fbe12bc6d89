"""A sheet for students to fill in: the cells that are asked, with keys, meanings and units, as XLSX, CSV or YAML."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.grading.model import Asked, Expected, Name
from tmm_report.i18n import Translator
from tmm_report.intake import writing
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import unit_text

Array = Any
Row = Sequence[str | float | int | None]

SCALES = (
    ("mu_l", "m/mm", N_("scale of lengths of the student's own drawing")),
    ("mu_v", "(m/s)/mm", N_("scale of the student's own velocity polygon")),
    ("mu_a", "(m/s²)/mm", N_("scale of the student's own acceleration polygon")),
    ("mu_F", "N/mm", N_("scale of the student's own force polygon")),
)
WIDEST = 100  # columns of one file of CSV
FORMATS = (".xlsx", ".csv", ".yaml")


def template(
    asked: Expected,
    worth: Mapping[Name, Array],
    suffix: str,
    tr: Translator,
    whose: str = "",
    senses: Sequence[str] = (),
) -> dict[str, bytes]:
    """Ending of the file's name -> content: one file, of CSV one for each kind of table. `whose` stands above each
    table; `senses`: which way positive numbers point, said below the single numbers."""
    tables = _tables(asked, worth)
    above: list[Row] = [[whose]] if whose else []
    match suffix:
        case ".xlsx":
            sheets = {name: [*above, *_sheet(columns, rows, tr)] for name, (columns, rows) in tables.items()}
            sheets["values"] = [*above, *_values(asked, worth, tr, senses)]
            return {".xlsx": writing.xlsx_bytes(sheets, titles=len(above))}
        case ".csv":
            made = _csv(asked, worth, tables, tr, senses)
            return {end: writing.csv_bytes([*above, *rows], tr.decimal) for end, rows in made.items()}
        case ".yaml":
            comment = f"# {_one_line(whose)}\n" if whose else ""
            return {".yaml": (comment + "".join(_yaml(asked, worth, tables, tr, senses))).encode()}
        case _:
            raise ValueError(f"no template as {suffix!r}")


Tables = Mapping[str, tuple[list[Asked], list[str]]]


def _tables(asked: Expected, worth: Mapping[Name, Array]) -> dict[str, tuple[list[Asked], list[str]]]:
    """Table -> its columns and the labels of its rows in which something is asked."""
    found: dict[str, tuple[list[Asked], list[str]]] = {}
    for table in dict.fromkeys(name[0] for name in worth if name[0]):
        columns = [asked[name] for name in worth if name[0] == table]
        some = np.logical_or.reduce([worth[one.name] > 0 for one in columns])
        found[table] = columns, [row for row, here in zip(columns[0].rows, some, strict=True) if here]
    return found


def _head(one: Asked, tr: Translator) -> str:
    unit = unit_text(one.unit, tr.language)
    return f"{one.key}, {unit}" if unit else one.key


def _sheet(columns: Sequence[Asked], rows: Sequence[str], tr: Translator) -> Iterator[Row]:
    first = N_("position") if columns[0].by_position else N_("row")
    yield [tr.gettext(first), *(_head(one, tr) for one in columns)]
    for row in rows:
        yield [int(row) if columns[0].by_position else row, *(None for _ in columns)]


def _values(
    asked: Expected, worth: Mapping[Name, Array], tr: Translator, senses: Sequence[str] = ()
) -> Iterator[Row]:
    """A line a single number; then the scales of the student's own plans, and which way positive numbers point."""
    yield [tr.gettext(head) for head in (N_("key"), N_("value"), N_("unit"), N_("meaning"))]
    for name in worth:
        if not name[0]:
            one = asked[name].quantity
            yield [one.key, None, unit_text(one.unit, tr.language), one.meaning.render(tr.gettext)]
    for key, unit, meaning in SCALES:
        yield [key, None, unit_text(unit, tr.language), tr.gettext(meaning)]
    for line in senses:
        yield [None, None, None, line]


def _csv(
    asked: Expected, worth: Mapping[Name, Array], tables: Tables, tr: Translator, senses: Sequence[str] = ()
) -> dict[str, Iterator[Row]]:
    """One file of all that goes by positions, one a table where it would be too wide or have a key twice; one of each
    other table, and one of the single numbers."""
    wide = [one for columns, _ in tables.values() for one in columns if one.by_position]
    files: dict[str, Iterator[Row]] = {}
    together = len(wide) <= WIDEST and len({one.key for one in wide}) == len(wide)
    if wide and together:
        rows = sorted(
            {int(row) for columns, rows in tables.values() if columns[0].by_position for row in rows}
        )
        files[".csv"] = _sheet(wide, [str(row) for row in rows], tr)
    for name, (columns, labels) in tables.items():
        if not (together and columns[0].by_position):
            files[f"-{name}.csv"] = _sheet(columns, labels, tr)
    files["-values.csv"] = _values(asked, worth, tr, senses)
    return files


def _yaml(
    asked: Expected, worth: Mapping[Name, Array], tables: Tables, tr: Translator, senses: Sequence[str] = ()
) -> Iterator[str]:
    """Lines of a YAML file with the numbers left out."""
    yield f"# {tr.gettext(HOW)}\n"
    yield from (f"# {_one_line(line)}\n" for line in senses)
    for name, (columns, rows) in tables.items():
        yield f"\n{name}:\n"
        for one in columns:
            yield f"  # {_head(one, tr)}: {_one_line(one.quantity.meaning.render(tr.gettext))}\n"
        keys = ", ".join(f"{json.dumps(one.key, ensure_ascii=False)}: " for one in columns)
        for row in rows:
            yield f"  {json.dumps(row, ensure_ascii=False)}: {{{keys}}}\n"
    single = [asked[name] for name in worth if not name[0]]
    if single:
        yield "\nvalues:\n"
        for one in single:
            meaning = _one_line(one.quantity.meaning.render(tr.gettext))
            yield f"  {json.dumps(one.key, ensure_ascii=False)}:  # {_head(one, tr)}: {meaning}\n"
    yield "\nscales:\n"
    for key, unit, text in SCALES:
        yield f"  {key}:  # {unit_text(unit, tr.language)}: {tr.gettext(text)}\n"


def whose_line(title: Mapping[str, str], tr: Translator) -> str:
    """Whose sheet it is; what is not known is left to be filled in."""
    values = {key: title.get(key) or "_" * 12 for key in ("student", "group", "variant")}
    return tr.gettext(N_("Student: %(student)s, group: %(group)s, variant: %(variant)s")) % values


HOW = N_(
    "Write the numbers behind the colons; 4,44 and 4.44 are the same. What is left out counts as no answer."
)


def _one_line(text: str) -> str:
    return " ".join(text.split())


def different(templates: Mapping[str, bytes]) -> Message | None:
    """Why one sheet will not do for all variants: those that ask for other cells than the first; None if it does."""
    first = next(iter(templates.values()), b"")
    others = [id for id, content in templates.items() if content != first]
    if not others:
        return None
    text = N_("%(count)s of the variants ask for other cells than the first: %(names)s")
    names = ", ".join(others[:5]) + ("…" if len(others) > 5 else "")
    return Message(text, {"count": len(others), "names": names})
