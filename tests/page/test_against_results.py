"""Every marked number of a note is the number of results.json to its printed digits, in the unit printed with it,
under the symbol that the results give it. All that is wrong is told in one run.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any
from xml.etree.ElementTree import Element

import pytest
from babel.messages.pofile import read_po
from latex import GREEK
from note import Cell, Figure, Formula, Head, Mark, Note, Table, mark_of, symbols, text_of
from printed import NONE, Printed, Unit, number, unit
from reading import BOTH, html, results, wrong

from tmm_report.resources import data_root

Where = Any  # a number, a text or None of results.json, with its unit and symbol
PICTURE = "picture"  # the scale of a picture is held against what is drawn, in test_drawings
COARSE = ("%", "°")  # printed to two decimals, however small


class Unknown(LookupError):
    """A mark that names nothing of the results."""


def found(document: dict[str, Any], mark: Mark) -> tuple[Any, str, str]:
    """Value, unit and symbol that a mark names. Raises Unknown."""
    if mark.key == "pi":
        return math.pi, "rad", "π"
    if mark.table == PICTURE:
        return None, "", ""
    if not mark.table:
        for entry in document["values"]:
            if entry["key"] == mark.key and mark.by:
                return entry[mark.by], "deg" if mark.by == "at_deg" else "", ""
            if entry["key"] == mark.key:
                return entry["value"], entry["unit"], entry.get("symbol", "")
        raise Unknown(f"no value {mark.key}")
    if mark.table not in document["tables"]:
        raise Unknown(f"no table {mark.table}")
    columns = {column["key"]: column for column in document["tables"][mark.table]["columns"]}
    return _of_quantity(columns, mark) if mark.by else _of_row(columns, mark)


def _of_quantity(columns: dict[str, Any], mark: Mark) -> tuple[Any, str, str]:
    """From a table of which each row is a quantity with its own unit."""
    rows = [k for k, key in enumerate(columns["key"]["values"]) if key == mark.key]
    if not rows or mark.by not in columns:
        raise Unknown(f"no row {mark.key} or column {mark.by} in {mark.table}")
    k = rows[0] if len(rows) == 1 or mark.row not in rows else mark.row
    own = columns["unit"]["values"][k] if "unit" in columns else ""
    column = columns[mark.by]
    symbol = columns["symbol"]["values"][k] if "symbol" in columns else ""
    return column["values"][k], column["unit"] or (own if mark.by != "key" else ""), symbol


def _of_row(columns: dict[str, Any], mark: Mark) -> tuple[Any, str, str]:
    if mark.key not in columns:
        raise Unknown(f"no column {mark.key} in {mark.table}")
    column = columns[mark.key]
    rows = columns["position"]["values"] if "position" in columns else list(range(len(column["values"])))
    if mark.row not in rows:
        raise Unknown(f"no row {mark.row} in {mark.table}")
    place = rows.index(mark.row)
    own = columns["unit"]["values"][place] if "unit" in columns and not column["unit"] else column["unit"]
    symbols = column.get("symbols") or []
    # the column's own symbol heads it; a row's stands in formulas
    symbol = "|".join(dict.fromkeys([column.get("symbol", ""), *symbols[place : place + 1]]))
    return column["values"][place], own, symbol


def differs(printed: Printed, half: float, printed_unit: Unit, value: Any, own: str, size: bool) -> str:
    """What is wrong with a printed number, "" if nothing is."""
    if value is None or math.isnan(printed.value):
        return "" if value is None and not math.isfinite(printed.value) else f"is {value}"
    mine = unit(own)
    if mine is None:
        return f"unit {own} of the results is not known"
    if mine.dimension != printed_unit.dimension:
        return f"is {value} {own}, another unit is printed"
    if size and printed.value < 0:
        return "a magnitude with a sign"
    expected = value * (mine.factor / printed_unit.factor)
    expected = abs(expected) if size else expected
    off = abs(printed.value - expected)
    return "" if off <= half * (1 + 1e-9) + 1e-12 * abs(expected) else f"is {expected:.9g}"


def exactness(printed: Printed, places: int, unit_text: str, aligned: bool = False) -> float:
    """Half a unit of the place to which a number is rounded. `places`: decimals of its column; `aligned`: it has as
    many as its largest.

    Zeros at the end may be left out: what has no decimals like others of its column, or few digits, is exact to more
    than it shows.
    """
    if printed.value == 0:
        return 0.5 * 10.0**-places if places else 0.005 if unit_text in COARSE else 1e-6
    if (
        printed.places > 1
        or printed.digits > 3
        or unit_text in COARSE
        or printed.places == places > 0 - aligned
    ):
        return printed.half
    if abs(printed.value) < 1e-4:  # a power of ten is printed
        return printed.half
    return min(printed.half, 5e-4 * abs(printed.value))


# --- cells of tables ---


def cells(note: Note) -> Iterator[tuple[str, Cell, Table, Head, str, int]]:
    """Where, cell, table, head, unit printed for it, decimals of its column."""
    for table in note.tables:
        labels = [_label(row) for row in table.rows]
        for j, head in enumerate(table.heads):
            places = table.places(j)
            for k, row in enumerate(table.rows):
                text = head.unit_text or ("" if j == 0 else labels[k])
                where = f"{table.where} {table.caption[:40]!r} row {k} {head.text!r} {row[j].text!r}"
                yield where, row[j], table, head, text, places


def _label(row: list[Cell]) -> str:
    """The unit that stands with the name of a row."""
    for cell in row:
        parts = re.split(r",\s", cell.text)
        if len(parts) > 1 and parts[-1] and cell.printed is None and unit(parts[-1]) is not None:
            return parts[-1]
    return ""


def own_unit(cell: Cell) -> tuple[str, str]:
    """Number and unit of a cell that holds both."""
    match = re.fullmatch(
        r"([−\d.,·⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)\s*([^\W\d]\S*|[°%])", cell.text.replace("\N{NO-BREAK SPACE}", " ")
    )
    return (match[1], match[2]) if match and unit(match[2]) is not None else (cell.text, "")


def wrong_cells(note: Note, document: dict[str, Any]) -> Iterator[str]:
    for where, cell, table, head, unit_text, places in cells(note):
        yield from wrong_inside(where, cell, unit_text, document)
        mark = cell.mark
        if mark is None:
            continue
        try:
            value, own, symbol = found(document, mark)
        except Unknown as unknown:
            yield f"{where} marked {mark}: {unknown}"
            continue
        digits, beside = own_unit(cell)
        printed = number(digits)
        if value is None and cell.text.startswith("≈"):  # a difference of what is nothing in both
            continue
        if mark.table == PICTURE or (digits == "0" and noise(document, mark, value)):
            continue
        if printed is None or isinstance(value, str):
            yield from wrong_text(where, cell, mark, value)
            continue
        text = beside or unit_text
        shown = unit(text) if text else NONE
        j = table.heads.index(head)
        zero_of_whole = printed.value == 0 and table.whole(j)
        half = 0.5 if zero_of_whole else exactness(printed, places, text, table.aligned(j, cell))
        problem = differs(printed, half, shown or NONE, value, own, mark.size)
        if problem:
            yield f"{where} {text} marked {mark}: {problem}"
        elif head.symbol and symbol and not named(head.symbol, symbol) and not mark.by:
            yield f"{where} marked {mark}: its symbol is {symbol}"


def noise(document: dict[str, Any], mark: Mark, value: Any) -> bool:
    """Whether a number is less than half a unit of the fifth digit of its column's largest, and so prints 0."""
    columns = document["tables"].get(mark.table, {"columns": []})["columns"]
    column = next((column["values"] for column in columns if column["key"] == mark.key), [])
    largest = max((abs(one) for one in column if isinstance(one, int | float)), default=0.0)
    if not isinstance(value, int | float) or not largest:
        return False
    return abs(value) <= 0.5 * 10.0 ** (math.floor(math.log10(largest)) - 4)


DIRECTIONS = {
    "0": ("to the right", "вправо"),
    "180": ("to the left", "влево"),
    "90": ("upwards", "вверх"),
    "-90": ("downwards", "вниз"),
    "against": ("against", "против"),
    "along": ("in the ", "по "),
    "counter-clockwise": ("counter-clockwise", "против часовой"),
    "clockwise": ("clockwise", "по часовой"),
}


def wrong_text(where: str, cell: Cell, mark: Mark, value: Any) -> Iterator[str]:
    """Names are printed as they are; words of directions say what the sign or angle says."""
    text = cell.text
    if isinstance(value, str) and mark.key == "direction":
        plain = text.replace("−", "-")
        said = any(text.startswith(word) for word in DIRECTIONS.get(value, ())) or value in plain
        if not said:
            yield f"{where} marked {mark}: the direction is {value}"
    elif isinstance(value, str):
        if re.fullmatch(r"[\dHh]['′]?", value) and letters(value) not in letters(text):
            yield f"{where} marked {mark}: the name is {value}"
    elif "→" in text:  # from one member to another: to the next one where the sign is plus
        one, _, other = text.partition("→")
        if (one < other) != (value > 0):
            yield f"{where} marked {mark}: is {value}"
    elif value is not None and not re.search(r"[^\W\d_]", text):
        yield f"{where} marked {mark}: is {value}"


# index words and Greek letters as the page writes them
def _index_words() -> dict[str, str]:
    with (data_root() / "templates/locale/ru/LC_MESSAGES/note.po").open("rb") as file:
        words = {
            entry.id: entry.string for entry in read_po(file) if entry.context == "index" and entry.string
        }
    return dict(sorted(words.items(), key=lambda word: -len(word[1])))  # a word before its beginning


WRITTEN = _index_words()


def named(printed: str, symbols: str) -> bool:
    """Whether a printed symbol is one of those, parted by |."""
    return any(letters(printed) == letters(symbol) for symbol in symbols.split("|") if symbol)


def letters(symbol: str) -> str:
    """Letters and digits of a symbol however its indices are written, in whatever language."""
    text = re.sub(_NAMES, lambda run: GREEK[run[0]], symbol.replace("'", "′"))
    text = re.sub("|".join(WRITTEN.values()), lambda word: _ENGLISH[word[0]], text)
    return "".join(sign for sign in text if sign.isalnum() or sign == "′")


_NAMES = "|".join(sorted(GREEK, key=len, reverse=True))
_ENGLISH = {word: name for name, word in WRITTEN.items()}


# --- formulas and running text ---


def wrong_formulas(note: Note, document: dict[str, Any]) -> Iterator[str]:
    for formula in note.formulas:
        for side, numbers in enumerate(formula.numbers):
            last = side == len(formula.sides) - 1 and len(numbers) == 1
            for figure in numbers:
                if figure.mark is not None:
                    yield from _wrong_number(formula, figure, last, document)


def _wrong_number(formula: Formula, figure: Figure, last: bool, document: dict[str, Any]) -> Iterator[str]:
    mark = figure.mark
    assert mark is not None
    where = f"{formula.where or 'text'} {formula.text!r} {figure.text!r} marked {mark}"
    try:
        value, own, symbol = found(document, mark)
    except Unknown as unknown:
        yield f"{where}: {unknown}"
        return
    if mark.table == PICTURE:
        return
    text = formula.unit_text if last else "°" if figure.degrees else (mark.unit or own)
    printed = figure.printed
    problem = differs(
        printed,
        exactness(printed, 0, text) if printed.value else 1e-6,
        unit(text) or NONE,
        value,
        own,
        mark.size,
    )
    if problem:
        yield f"{where}: {problem}"
    sums = re.search(r"[+−·=]", formula.names[0])  # the left side is an expression of its own
    if not problem and last and symbol and not sums and not any(named(n, symbol) for n in formula.names):
        yield f"{where}: its symbol is {symbol}"


def wrong_spans(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """Numbers in running text, with the unit that follows them."""
    for parent in note.root.iter():
        if parent.tag != "td" and any(node.tag == "span" for node in parent):
            yield from _wrong_in(parent, f"{text_of(parent)[:60]!r}", "", document)


def wrong_inside(where: str, cell: Cell, unit_text: str, document: dict[str, Any]) -> Iterator[str]:
    """Numbers that stand in a cell among other text: with its unit where none follows."""
    yield from _wrong_in(cell.node, where, unit_text, document)


def _wrong_in(parent: Element, where: str, unit_text: str, document: dict[str, Any]) -> Iterator[str]:
    for node in parent:
        mark = mark_of(node) if node.tag == "span" else None
        if mark is None:
            continue
        try:
            value, own, _ = found(document, mark)
        except Unknown as unknown:
            yield f"{where} {text_of(node)!r} marked {mark}: {unknown}"
            continue
        printed = number(text_of(node))
        if isinstance(value, str) and re.fullmatch(r"\d+|[A-Z]", value) and value != text_of(node):
            yield f"{where} {text_of(node)!r} marked {mark}: the name is {value}"
        if printed is None or isinstance(value, str) or printed.value == value == 0:
            continue
        text = _following(node.tail or "") or unit_text
        half = exactness(printed, 0, text) if printed.value else 0.005
        problem = differs(printed, half, unit(text) or NONE, value, own, mark.size)
        if problem:
            yield f"{where} {text_of(node)!r} marked {mark}: {problem}"


def _following(tail: str) -> str:
    """The unit that follows a number in running text, "" if none does."""
    match = re.match(r"[\s\N{NO-BREAK SPACE}]*([^\s,.;:)\N{NO-BREAK SPACE}]+|[°%])", tail)
    return match[1] if match and unit(match[1]) is not None else ""


@pytest.mark.parametrize(("name", "other"), BOTH)
def test_marked_numbers_are_those_of_the_results(name, other):
    note, document = html(name, other), results(name, other)
    found = [*wrong_cells(note, document), *wrong_formulas(note, document), *wrong_spans(note, document)]
    wrong(found)


# --- nothing without a mark ---

# columns of names, of which some are digits
NAMES = {
    *(
        "Link",
        "Wheel",
        "Member",
        "Satellite",
        "No.",
        "Stopped",
        "Held",
        "Input",
        "Driving link",
        "Output link",
    ),
    *(
        "Driving wheel",
        "Carrier",
        "Stage",
        "Звено",
        "Колесо",
        "Сателлит",
        "№",
        "Остановлено звено",
        "Стойка",
        "Вход",
    ),
    *("Ведущее звено", "Выходное звено", "Ведущее колесо", "Водило", "Ступень"),
}


def unmarked(note: Note) -> Iterator[str]:
    for where, cell, _table, head, *_ in cells(note):
        if cell.printed is not None and cell.mark is None and cell.text != "—" and head.text not in NAMES:
            yield where
    for formula in note.formulas:
        allowed = [figure.text for figure in _constants(formula)]
        for figure in (figure for side in formula.numbers for figure in side):
            if figure.mark is None and figure.text in allowed:
                continue
            if figure.mark is None:
                yield f"{formula.where or 'text'} {formula.text!r} {figure.text!r}"


def _constants(formula: Formula) -> list[Figure]:
    """The formula's own numbers: those among its symbols, as the 2 of 2πr, and the 0 of an equation."""
    found = []
    for side, numbers in zip(formula.sides, formula.numbers, strict=True):
        if any(True for _ in symbols(side)) or [figure.text for figure in numbers] == ["0"]:
            found += [figure for figure in numbers if figure.mark is None]
    return found


@pytest.mark.parametrize(("name", "other"), BOTH)
def test_every_printed_number_is_marked(name, other):
    wrong(list(unmarked(html(name, other))))
