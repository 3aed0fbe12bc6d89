"""Results as tables of named columns: the one source of results.json and of the CSV files.

Every column carries its key, unit and meaning; docs/results.md describes the format. The room of each part of the
course gives its tables and values.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from itertools import islice
from types import ModuleType
from typing import Any

import numpy as np

from tmm_report.course import INITIAL_DATA, Results, chapters, room
from tmm_report.i18n import Translator
from tmm_report.jsontext import Pieces, framed, indented, members_of, number_lists
from tmm_report.quantity.model import Column, Quantity, Table, Value

__all__ = ["Column", "Table", "Value", "as_csv", "as_json", "tables", "values"]

Array = Any
FORMAT = 1


def tables(results: Results) -> list[Table]:
    """All tables of a variant's results."""
    return [table for quantities, found in _rooms(results) for table in quantities.tables(found)]


def values(results: Results) -> list[Value]:
    """The single numbers of a variant's results."""
    return [value for quantities, found in _rooms(results) for value in quantities.values(found)]


def listings(results: Results, say: Callable[[str], str]) -> Iterator[tuple[str, list[str]]]:
    """Name and lines of what is too long for the note and for the tables: all that a search has judged."""
    for quantities, found in _rooms(results):
        if hasattr(quantities, "listings"):
            yield from quantities.listings(found, say)


def _rooms(results: Results) -> Iterator[tuple[ModuleType, Any]]:
    """Quantities and Found of every chapter that was solved; a room is loaded only where it is needed."""
    if results.lever is not None:
        yield room(INITIAL_DATA, "quantities"), results.lever
    for name, found in chapters(results):
        yield room(name, "quantities"), found


def as_json(results: Results, tr: Translator) -> bytes:
    """results.json: every number with its key, unit and meaning; missing numbers are null."""
    document = {
        "format": FORMAT,
        "title": _title(results),
        **_structure(results),
        "values": [_value(value, tr) for value in values(results)],
    }
    members = [[member.encode()] for member in members_of(document, 0)]
    members.append([b'"tables": ', *_tables(tables(results), tr)])
    return b"".join([*framed(b"{}", members, 0), b"\n"])


def _value(value: Value, tr: Translator) -> dict[str, Any]:
    at = {} if value.at is None else {"at_deg": _finite(math.degrees(value.at))}
    side = {"side": value.side} if value.side else {}
    return {
        "key": value.key,
        **_symbol(value.quantity),
        "value": _finite(value.value),
        "unit": value.unit,
        "meaning": value.meaning.render(tr.gettext),
        **at,
        **side,
    }


DEPTH = 4  # at which a column stands in the document


def _tables(every: Sequence[Table], tr: Translator) -> Pieces:
    """Tables by their names."""
    columns = iter(_columns([column for table in every for column in table.columns], tr))
    items = []
    for table in every:
        name, meaning = indented(table.name), indented(table.meaning.render(tr.gettext))
        own = framed(b"[]", list(islice(columns, len(table.columns))), DEPTH - 1)
        inside = framed(b"{}", [[f'"meaning": {meaning}'.encode()], [b'"columns": ', *own]], DEPTH - 2)
        items.append([f"{name}: ".encode(), *inside])
    return framed(b"{}", items, DEPTH - 3)


def _columns(columns: Sequence[Column], tr: Translator) -> Iterator[Pieces]:
    """The columns of all tables: their numbers are written all at once, what their quantities say is kept."""
    rows = [_only_numbers(column.values) for column in columns]
    lists = number_lists([row for row in rows if row is not None], DEPTH + 1)
    for column, row in zip(columns, rows, strict=True):
        written = next(lists) if row is not None else indented(_plain(column.values), DEPTH + 1).encode()
        yield [_said(column, tr), written, b"\n" + b" " * DEPTH + b"}"]


def _said(column: Column, tr: Translator) -> bytes:
    """The beginning of a column: its key, symbol, unit and meaning; kept, as many columns are of one quantity."""
    if len(column.symbols):
        return _heading(column.quantity, tr, symbols=[str(symbol) for symbol in column.symbols])
    said = column.quantity.said
    if tr.language not in said:
        said[tr.language] = _once(column.quantity, tr)
    return said[tr.language]


HEADINGS: dict[tuple[Any, ...], bytes] = {}
MANY = 4096


def _once(quantity: Quantity, tr: Translator) -> bytes:
    """The heading of a quantity, kept for those of other variants that are named and meant as it is."""
    meaning = quantity.meaning
    values = ((name, type(value), value) for name, value in meaning.values.items())
    same = (tr.language, quantity.key, quantity.symbol, quantity.unit, meaning.text, *values)
    try:
        known = HEADINGS.get(same)
    except TypeError:  # a meaning within a meaning
        return _heading(quantity, tr)
    if known is None:
        known = _heading(quantity, tr)
        if len(HEADINGS) >= MANY:
            HEADINGS.clear()
        HEADINGS[same] = known
    return known


def _heading(quantity: Quantity, tr: Translator, **symbols: list[str]) -> bytes:
    meaning = quantity.meaning.render(tr.gettext)
    said = {"key": quantity.key, **_symbol(quantity), **symbols, "unit": quantity.unit, "meaning": meaning}
    indent = "\n" + " " * (DEPTH + 1)
    return f'{{{indent}{f",{indent}".join(members_of(said, DEPTH))},{indent}"values": '.encode()


def _symbol(quantity: Quantity) -> dict[str, str]:
    """The symbol of a quantity that is written as one."""
    return {} if quantity.symbol is None else {"symbol": str(quantity.symbol)}


def _structure(results: Results) -> dict[str, Any]:
    if results.lever is None:
        return {}
    found = results.lever.structure
    return {"structure": {"formula": found.formula, "groups": [g.label for g in found.groups]}}


def _title(results: Results) -> Mapping[str, str]:
    return {name: text for name, text in vars(results.variant.title).items() if text}


def _only_numbers(column: Any) -> Array | None:
    """A column of nothing but floating numbers as an array (P,), else None."""
    if isinstance(column, np.ndarray):
        return column if column.dtype == float else None
    return np.array(column, dtype=float) if {float, np.float64}.issuperset(map(type, column)) else None


def _plain(column: Iterable[Any]) -> list[Any]:
    """Another column for JSON: null for nan and infinity, and no negative zero."""
    return [x if isinstance(x, str | int) else _finite(float(x)) for x in column]


def _finite(x: float) -> float | None:
    """A number for JSON: null for nan and infinity, and no negative zero."""
    if isinstance(x, int):
        return x
    return x + 0.0 if math.isfinite(x) else None


def as_csv(results: Results, tr: Translator) -> dict[str, bytes]:
    """File name -> CSV of each table. With a decimal comma cells are parted by semicolons, as spreadsheets expect."""
    return {f"{table.name}.csv": _csv(table, tr) for table in tables(results)}


def _csv(table: Table, tr: Translator) -> bytes:
    out = io.StringIO()
    writer = csv.writer(out, delimiter=";" if tr.decimal == "," else ",", lineterminator="\r\n")
    writer.writerow([_text_cell(f"{c.key}, {c.unit}" if c.unit else c.key) for c in table.columns])
    for row in zip(*(c.values for c in table.columns), strict=True):
        writer.writerow([_cell(x, tr.decimal) for x in row])
    return ("\ufeff" + out.getvalue()).encode()  # the mark tells spreadsheets that the text is UTF-8


def _cell(x: Any, decimal: str) -> str:
    if isinstance(x, str):
        return _text_cell(x)
    return str(x) if isinstance(x, int) else _number_cell(float(x), decimal)


def _text_cell(text: str) -> str:
    """Text that a spreadsheet must not take for a formula gets an apostrophe in front."""
    return "'" + text if text[:1] in tuple("=+-@\t\r") else text


def _number_cell(x: float, decimal: str) -> str:
    return repr(x + 0.0).replace(".", decimal) if math.isfinite(x) else ""
