"""The stored results of a sample, `name.expected.json` beside `name.yaml`: read as a stranger's file, written by us."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import field
from pathlib import Path
from typing import Any

from tmm_report import yamlread
from tmm_report.commands.check.numbers import VALUES, Cell, Sheet, Stored, Tolerance, Tolerances
from tmm_report.languages import DEFAULT, LANGUAGES
from tmm_report.problems import N_, Message, Problem, ProblemError, shown
from tmm_report.records import dataclass

FORMAT = 1
BYTES = 5_000_000
LONGEST_NUMBER = 40  # characters
LINES = 5000  # of a note: to set many against many takes the square of the time
SUFFIX = ".expected.json"

# How well drawings and checks agree is rounding: it differs from machine to machine.
ROUNDING = ("disagreement", "overlap", "clearance")
OF_ROUNDING = Tolerance(relative=1e-9, absolute=1e-9)


@dataclass(frozen=True, eq=False)
class Expected:
    """What is stored of one sample."""

    tolerances: Tolerances
    language: str
    numbers: Stored
    structure: Sequence[str] = field(default_factory=tuple)


def place(variant: Path) -> Path:
    """The stored file of a variant."""
    return variant.with_name(variant.stem + SUFFIX)


# ---------------------------------------------------------------- writing


def tolerances_of(sheets: Sequence[Sheet]) -> Tolerances:
    """Those that a new stored file states."""
    names = [
        f"{VALUES if sheet.name == VALUES else f'tables.{sheet.name}'}.{column}"
        for sheet in sheets
        for column in sheet.columns
        if column.endswith(ROUNDING)
    ]
    return Tolerances(places=dict.fromkeys(sorted(names), OF_ROUNDING))


def written(
    tolerances: Tolerances, language: str, sheets: Sequence[Sheet], structure: Sequence[str]
) -> bytes:
    """A stored file, a column a line, so that a change shows in its own line."""
    values = {key: cells[0] for s in sheets if s.name == VALUES for key, cells in s.columns.items()}
    tables = {sheet.name: sheet.columns for sheet in sheets if sheet.name != VALUES}
    parts = [
        f'"format": {FORMAT}',
        f'"language": {_json(language)}',
        f'"tolerance": {_lines(_stated(tolerances), 1)}',
        f'"values": {_lines(values, 1)}',
        f'"tables": {_lines(tables, 2)}',
        f'"structure": [\n  {_joined(map(_json, structure), 2)}\n ]',
    ]
    return ("{\n " + ",\n ".join(parts) + "\n}\n").encode()


def _stated(tolerances: Tolerances) -> dict[str, Any]:
    places = {
        name: one.relative if one.absolute == tolerances.common.absolute else vars(one)
        for name, one in tolerances.places.items()
    }
    return {**vars(tolerances.common), **places}


def _lines(value: Mapping[str, Any], depth: int, indent: int = 1) -> str:
    """An object with a line for each key, down to a depth."""
    items = (
        f"{_json(key)}: {_lines(item, depth - 1, indent + 1) if depth > 1 else _json(item)}"
        for key, item in value.items()
    )
    return "{\n" + " " * (indent + 1) + _joined(items, indent + 1) + "\n" + " " * indent + "}"


def _joined(items: Any, indent: int) -> str:
    return (",\n" + " " * indent).join(items)


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


# ---------------------------------------------------------------- reading


def read(path: Path) -> Expected:
    """The stored results. Raises ProblemError for what is no such file."""
    file = yamlread.file_label(path)
    document = _document(yamlread.opened(path, file, BYTES), file)
    try:
        return Expected(
            _tolerances(_object(document.get("tolerance", {}), ("tolerance",))),
            _language(document.get("language", DEFAULT)),
            _numbers(document),
            _texts(document.get("structure", []), ("structure",)),
        )
    except _Wrong as wrong:
        raise ProblemError([Problem(wrong.what, UPDATE, wrong.path, file)]) from None


UPDATE = Message(N_("remove it, then store anew: tmm-report check --update"))


class _Wrong(Exception):
    """What is wrong with a part of the file."""

    def __init__(self, path: tuple[str, ...], what: Message):
        super().__init__()
        self.path, self.what = tuple(map(shown, path)), what


def _document(source: bytes, file: str) -> dict[str, Any]:
    try:
        document = json.loads(
            source.decode("utf-8-sig"),
            parse_constant=_constant,
            parse_int=_whole,
            parse_float=_float,
            object_pairs_hook=_once,
        )
    except json.JSONDecodeError as error:
        wrong = Message(N_("this is no JSON: %(reason)s"), {"reason": error.msg})
        raise ProblemError([Problem(wrong, UPDATE, (), file, error.lineno, error.colno)]) from None
    except (ValueError, RecursionError):  # not UTF-8, no number, a key twice, nested without end
        raise ProblemError(
            [Problem(Message(N_("this is no file of stored results")), UPDATE, (), file)]
        ) from None
    if not isinstance(document, dict) or document.get("format") != FORMAT:
        wrong = Message(N_("these are no stored results of format %(format)s"), {"format": FORMAT})
        raise ProblemError([Problem(wrong, UPDATE, ("format",), file)])
    return document


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of which every key stands once."""
    found = dict(pairs)
    if len(found) < len(pairs):
        raise ValueError
    return found


def _constant(name: str) -> float:
    raise ValueError(name)


def _whole(text: str) -> int:
    if len(text) > LONGEST_NUMBER:
        raise ValueError
    return int(text)


def _float(text: str) -> float:
    number = float(text) if len(text) <= LONGEST_NUMBER else math.inf
    if not math.isfinite(number):
        raise ValueError
    return number


def _object(value: Any, path: tuple[str, ...]) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise _Wrong(path, Message(N_("this must be an object, {…}")))
    return value


def _language(value: Any) -> str:
    if not isinstance(value, str) or value not in LANGUAGES:
        raise _Wrong(
            ("language",), Message(N_("this must be one of %(words)s"), {"words": ", ".join(LANGUAGES)})
        )
    return value


def _tolerances(stated: dict[str, Any]) -> Tolerances:
    common = _tolerance(
        {key: stated[key] for key in ("relative", "absolute") if key in stated}, Tolerance(), ()
    )
    places = {key: value for key, value in stated.items() if key not in ("relative", "absolute")}
    return Tolerances(common, {key: _tolerance(value, common, (key,)) for key, value in places.items()})


def _tolerance(value: Any, common: Tolerance, path: tuple[str, ...]) -> Tolerance:
    """A number is a relative tolerance."""
    stated = value if isinstance(value, dict) else {"relative": value}
    numbers = {**vars(common), **stated}
    good = (isinstance(x, int | float) and not isinstance(x, bool) and x >= 0 for x in numbers.values())
    if set(numbers) != {"relative", "absolute"} or not all(good):
        text = N_('this must be a number from 0 up, or {"relative": …, "absolute": …} of such numbers')
        raise _Wrong(("tolerance", *path), Message(text))
    return Tolerance(float(numbers["relative"]), float(numbers["absolute"]))


def _numbers(document: dict[str, Any]) -> Stored:
    values = _object(document.get("values", {}), ("values",))
    tables = _object(document.get("tables", {}), ("tables",))
    found = {VALUES: {key: [_cell(x, ("values", key))] for key, x in values.items()}}
    for name, columns in tables.items():
        columns = _object(columns, ("tables", name))
        found[name] = {key: _column(cells, ("tables", name, key)) for key, cells in columns.items()}
    return found


def _column(cells: Any, path: tuple[str, ...]) -> list[Cell]:
    if not isinstance(cells, list):
        raise _Wrong(path, Message(N_("this must be a list, […]")))
    return [_cell(cell, path) for cell in cells]


def _cell(cell: Any, path: tuple[str, ...]) -> Cell:
    if cell is None or isinstance(cell, str | int | float):
        return cell
    raise _Wrong(path, Message(N_("this must be a number, a text or null")))


def _texts(value: Any, path: tuple[str, ...]) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(line, str) for line in value):
        raise _Wrong(path, Message(N_("this must be a list of texts")))
    if len(value) > LINES:
        raise _Wrong(path, Message(N_("this has more than %(limit)s lines"), {"limit": LINES}))
    return tuple(value)
