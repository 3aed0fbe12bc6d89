"""Results as tables of named columns: the one source of results.json and of the CSV files.

Every column carries its key, unit and meaning; docs/results.md describes the format. The room of each part of the
course gives its tables and values.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import is_dataclass
from types import ModuleType
from typing import Any, cast

import numpy as np

from tmm_report.course import Results, room, with_data
from tmm_report.i18n import Translator
from tmm_report.problems import N_, Message, Problem, ProblemError, in_language
from tmm_report.quantity.model import Column, Quantity, Table, Value

__all__ = ["Column", "Table", "Value", "as_csv", "as_dxf", "as_json", "tables", "values"]

FORMAT = 1


def tables(results: Results) -> list[Table]:
    """All tables of a variant's results."""
    return [table for quantities, found in _rooms(results) for table in quantities.tables(found)]


def values(results: Results) -> list[Value]:
    """The single numbers of a variant's results."""
    return [value for quantities, found in _rooms(results) for value in quantities.values(found)]


def sought(results: Results) -> Iterator[Value]:
    """The few numbers that a reader looks for first: stroke, time ratio, greatest velocity and moment, flywheel …"""
    for quantities, found in _rooms(results):
        if hasattr(quantities, "headline"):
            yield from quantities.headline(found)
        elif hasattr(quantities, "HEADLINE"):
            by_key = {value.key: value for value in quantities.values(found)}
            yield from (by_key[key] for key in quantities.HEADLINE if key in by_key)


def listings(results: Results, say: Callable[[str], str]) -> Iterator[tuple[str, list[str]]]:
    """Name and lines of what is too long for the note and for the tables: all that a search has judged."""
    for quantities, found in _rooms(results):
        if hasattr(quantities, "listings"):
            yield from quantities.listings(found, say)


def _rooms(results: Results) -> Iterator[tuple[ModuleType, Any]]:
    """Quantities and Found of every chapter that was solved; a room is loaded only where it is needed."""
    for name, found in with_data(results):
        yield room(name, "quantities"), found


def as_json(results: Results, tr: Translator) -> bytes:
    """results.json: every number with its key, unit and meaning, to its last digit; missing numbers are null."""
    from pydantic_core import (
        to_json,  # several times as fast as the standard library, and has read the variant
    )

    document = {
        "format": FORMAT,
        "title": _title(results, tr),
        **_structure(results),
        "values": [_value(value, tr) for value in values(results)],
        "tables": {table.name: _table(table, tr) for table in tables(results)},
    }
    return to_json(document, indent=1, inf_nan_mode="null") + b"\n"


def _value(value: Value, tr: Translator) -> dict[str, Any]:
    at = {} if value.at is None else {"at_deg": math.degrees(value.at) + 0.0}
    side = {"side": value.side} if value.side else {}
    return {
        "key": value.key,
        **_symbol(value.quantity),
        "value": _plain(value.value),
        "unit": value.unit,
        "meaning": value.meaning.render(tr.gettext),
        **at,
        **side,
    }


def _table(table: Table, tr: Translator) -> dict[str, Any]:
    columns = [{**_said(column, tr), "values": _numbers(column.values)} for column in table.columns]
    return {"meaning": table.meaning.render(tr.gettext), "columns": columns}


def _said(column: Column, tr: Translator) -> dict[str, Any]:
    """Key, symbols, unit and meaning of a column."""
    said = _of_quantity(column.quantity, tr)
    if not len(column.symbols):
        return said
    named = {name: said[name] for name in ("key", "symbol") if name in said}
    return named | {"symbols": [str(symbol) for symbol in column.symbols]} | said


def _of_quantity(quantity: Quantity, tr: Translator) -> dict[str, Any]:
    """What is said of a quantity, kept with it: many columns are of one."""
    words = tr.language, tr.words
    if words not in quantity.said:
        meaning = quantity.meaning.render(tr.gettext)
        said = {"key": quantity.key, **_symbol(quantity), "unit": quantity.unit, "meaning": meaning}
        quantity.said[words] = said
    return quantity.said[words]


def _symbol(quantity: Quantity) -> dict[str, str]:
    """The symbol of a quantity that is written as one."""
    return {} if quantity.symbol is None else {"symbol": str(quantity.symbol)}


def _structure(results: Results) -> dict[str, Any]:
    if results.lever is None:
        return {}
    found = results.lever.structure
    return {"structure": {"formula": found.formula, "groups": [g.label for g in found.groups]}}


def _title(results: Results, tr: Translator) -> Mapping[str, Any]:
    """The lines of the title page, in the language of the meanings."""
    return {name: _translated(text, tr) for name, text in vars(results.variant.title).items() if text}


def _translated(text: Any, tr: Translator) -> Any:
    if isinstance(text, tuple):
        return [_translated(one, tr) for one in text]
    if is_dataclass(text):
        return {name: _translated(one, tr) for name, one in vars(text).items()}
    return in_language(text, tr.gettext)


def _numbers(column: Any) -> list[Any]:
    """A column for JSON; no zero has a sign."""
    if isinstance(column, np.ndarray) and column.dtype == float:
        return cast("list[Any]", (column + 0.0).tolist())
    return [x + 0.0 if type(x) is float else _plain(x) for x in column]


def _plain(x: Any) -> str | float:
    """A text, a whole number, or a number without a negative zero."""
    return x if isinstance(x, str | int) else float(x) + 0.0


def as_dxf(results: Results) -> dict[str, bytes]:
    """File name -> DXF of each cam, mm, in its own axes. Raises ProblemError of a variant without one."""
    from tmm_report.figures.dxf import Outline, Ring, dxf  # only drawings for CAD need it

    found: dict[str, bytes] = {}
    for quantities, chapter in _rooms(results):
        for name, layers in quantities.cad_outlines(chapter) if hasattr(quantities, "cad_outlines") else ():
            shapes = {
                layer: [Ring(0j, one) if np.ndim(one) == 0 else Outline(one) for one in curves]
                for layer, curves in layers.items()
            }
            found[f"{name}.dxf"] = dxf(shapes)
    if not found:
        text = N_("a drawing for CAD (dxf) is that of a cam: this variant has none")
        raise ProblemError([Problem(Message(text), Message(N_("the block cam, or mechanism.cams")))])
    return found


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
