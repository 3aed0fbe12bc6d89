"""One number reads the same wherever a note prints it: with the same digits, or with fewer of them, rounded rightly.

The rules of print: a number has five significant digits, in a column all have the decimals of the largest unless the
smallest would keep less than three digits; what is nought to the accuracy of the computation is 0, and a column of
noughts or dashes is none.
"""

from __future__ import annotations

import json
import math
import re
from collections import defaultdict
from collections.abc import Iterator
from typing import Any, NamedTuple

import pytest
from exhaustive import many
from note import Mark, Note, Table, mark_of, read, text_of
from printed import Printed, number, unit
from reading import CHOSEN, html, results, wrong
from test_against_results import NONE, PICTURE, Unknown, _following, cells, found, own_unit

QUICK = [name for name in ("compressor", "parallelogram_drive") if name in CHOSEN] or CHOSEN[:1]
each = pytest.mark.parametrize("name", many([*QUICK, *(n for n in CHOSEN if n not in QUICK)], len(QUICK)))
NOISE = 1e-7  # below a tenth of what a length of the smallest link, in m, is printed to
ERRORS = "method"  # tables of methods say how small their errors are


class Shown(NamedTuple):
    mark: Mark
    unit: str | None  # None: that of the results
    text: str
    where: str


def shown(note: Note) -> Iterator[Shown]:
    """Every number of the note that says which one it is."""
    for where, cell, _, _, unit_text, _ in cells(note):
        if cell.mark is not None:
            text, beside = own_unit(cell)
            yield Shown(cell.mark, beside or unit_text, text, where)
    for formula in note.formulas:
        for side, numbers in enumerate(formula.numbers):
            last = side == len(formula.sides) - 1 and len(numbers) == 1
            for figure in numbers:
                if figure.mark is not None:
                    text = formula.unit_text if last else "°" if figure.degrees else None
                    yield Shown(figure.mark, text, figure.text, f"{formula.where} {formula.text[:50]!r}")
    for parent in note.root.iter():
        for node in parent:
            mark = mark_of(node) if node.tag == "span" else None
            if mark is not None:
                following = _following(node.tail or "") or None
                yield Shown(mark, following, text_of(node), text_of(parent)[:50])


def alike(note: Note, document: dict[str, Any]) -> Iterator[str]:
    """What is printed twice with digits that are no rounding of one another."""
    places: dict[Any, dict[str, str]] = defaultdict(dict)
    for one in shown(note):
        printed = number(one.text)
        if printed is None or not math.isfinite(printed.value) or one.mark.table == PICTURE:
            continue
        try:
            value, own, symbol = found(document, one.mark)
        except Unknown:  # told by test_against_results
            continue
        if not isinstance(value, int | float) or not value:
            continue
        factor = (unit(one.mark.unit or own if one.unit is None else one.unit) or NONE).factor
        mark = (one.mark.table, one.mark.key, one.mark.row, one.mark.by)
        places[mark, f"{factor:.6g}"][one.text.lstrip("−")] = one.where
        if symbol:
            places[symbol, own, f"{abs(value):.12g}", f"{factor:.6g}"][one.text.lstrip("−")] = one.where
    for key, texts in places.items():
        for text, other in _against(list(texts)):
            yield f"{key[0]}: {text} at {texts[text]}, {other} at {texts[other]}"


def _against(texts: list[str]) -> Iterator[tuple[str, str]]:
    """Pairs of which the one with fewer decimals is not the other rounded."""
    known = sorted((step(text), value(text), text) for text in texts)
    for i, (_, fine, text) in enumerate(known):
        for half, coarse, other in known[i + 1 :]:
            if abs(fine - coarse) > half / 2 * (1 + 1e-9):
                yield text, other


def value(text: str) -> float:
    printed = number(text)
    assert printed is not None
    return printed.value


def step(text: str) -> float:
    """A unit of the last place as it is written: of 20650 that of ones."""
    printed = number(text)
    assert printed is not None
    return 2 * printed.half if "·" in text else 10.0**-printed.places


def uneven(note: Note) -> Iterator[str]:
    """Columns of one quantity whose numbers have other decimals than the largest, where three digits stay, or less
    digits than the others, zeros at the end being lost. Of a matrix each row has its own unit."""
    for table in note.tables:
        for j, head in enumerate(table.heads):
            column = [cell for cell in table.column(j) if _counts(cell.printed, cell.text)]
            if not head.symbol or len({(c.mark.key, c.mark.by, c.mark.unit) for c in column if c.mark}) != 1:
                continue
            if {c.mark.table for c in column if c.mark} == {"governor_matrix"}:
                continue
            places = {cell.printed.places for cell in column if cell.printed}
            if len(places) < 2:
                continue
            sizes = [abs(value(cell.text)) for cell in column]
            common = column[sizes.index(max(sizes))].printed
            digits = min(5, max(cell.printed.digits for cell in column if cell.printed))
            short = [
                c
                for c in column
                if c.printed and c.printed.places < max(places) and c.printed.digits < digits
            ]
            if short or (common and min(sizes) * 10**common.places >= 99.5):
                yield f"{table.where} {head.text!r}: {[cell.text for cell in column]}"


def _counts(printed: Printed | None, text: str) -> bool:
    return printed is not None and math.isfinite(printed.value) and "·" not in text and text != "0"


def empty(note: Note) -> Iterator[str]:
    """Columns of numbers that are all nought, and columns of dashes."""
    for table in note.tables:
        noughts = [_all(table, j, "0") for j in range(len(table.heads))]
        for j, head in enumerate(table.heads):
            if len(table.rows) > 1 and _all(table, j, "—"):
                yield f"{table.where} {head.text!r}: dashes"
            if noughts[j] and head.symbol and not table.words and not all(noughts[1:]):
                yield f"{table.where} {head.text!r}: noughts"


def _all(table: Table, j: int, text: str) -> bool:
    return len(table.rows) > 1 and all(cell.text == text for cell in table.column(j))


def noise(note: Note) -> Iterator[str]:
    """Numbers that nothing but rounding makes: so small that none of the course's quantities is."""
    for one in shown(note):
        printed = number(one.text)
        small = printed is not None and 0 < abs(printed.value) < NOISE
        if small and not one.mark.table.startswith(ERRORS) and not one.mark.key.startswith(ERRORS):
            yield f"{one.text} at {one.where} marked {one.mark}"


@each
def test_a_number_reads_the_same_everywhere(name):
    wrong(list(alike(html(name), results(name))))


@each
def test_columns_have_decimals_in_common(name):
    wrong(list(uneven(html(name))))


@each
def test_no_column_says_nothing(name):
    wrong(list(empty(html(name))))


@each
def test_no_noise_is_a_result(name):
    wrong(list(noise(html(name))))


INTERVAL = re.compile(r"(?:от|from|of) (\d+(?:[.,]\d+)?)°? (?:до|to) (\d+(?:[.,]\d+)?)°")
THROUGH = re.compile(
    r"через конец цикла|past the end of the cycle|over the end of the cycle|мёртвой точкой|dead point"
)


@each
def test_an_interval_of_angles_ends_behind_its_beginning(name):
    """Up to 360°, not to 0; one that runs over the end of the cycle says so."""
    found = [
        line[max(0, match.start() - 60) : match.end()]
        for line in html(name).words
        for match in INTERVAL.finditer(line)
        if float(match[1].replace(",", ".")) >= float(match[2].replace(",", ".")) and not THROUGH.search(line)
    ]
    wrong(found)


# --- the test itself, on what it must find

ROWS = """<main><div class="table whole" id="table1"><p>x</p><div><table><thead><tr><th>k</th>
<th><math><msub><mi>v</mi><mi>B</mi></msub></math>, m/s</th><th><math><mi>a</mi></math></th></tr></thead><tbody>{}
</tbody></table></div></div>{}</main>"""
ROW = (
    '<tr><td>{0}</td><td data-q="v_B" data-k="{0}" data-t="rates">{1}</td>'
    '<td data-q="a" data-k="{0}" data-t="rates">{2}</td></tr>'
)


def page(speeds: list[str], others: list[str], text: str = "") -> Note:
    rows = "".join(ROW.format(k, *both) for k, both in enumerate(zip(speeds, others, strict=True)))
    return read(ROWS.format(rows, text))


@pytest.mark.parametrize(
    ("text", "count"), [("58.48", 0), ("58.5", 0), ("58.484", 0), ("58.49", 1), ("58.4", 1), ("60", 1)]
)
def test_another_rounding_is_told(text, count):
    again = f'<p>the speed <span data-q="v_B" data-k="0" data-t="rates">{text}</span> m/s</p>'
    column = {"key": "v_B", "unit": "m/s", "symbol": "v_B", "values": [58.484, 1.0]}
    other = {"key": "a", "unit": "", "symbol": "a", "values": [1.0, 1.0]}
    document = json.loads(json.dumps({"values": [], "tables": {"rates": {"columns": [column, other]}}}))
    assert len(list(alike(page(["58.484", "1.000"], ["1", "1"], again), document))) == 2 * count


@pytest.mark.parametrize(
    ("speeds", "count"),
    [(["58.484", "1.000"], 0), (["58.484", "1"], 1), (["58.48", "0.00312"], 0), (["58.48", "1.2345"], 1)],
)
def test_uneven_columns_are_told(speeds, count):
    assert len(list(uneven(page(speeds, ["1", "1"])))) == count


def test_columns_of_noughts_dashes_and_noise_are_told():
    assert len(list(empty(page(["0", "0"], ["1", "1"])))) == 1
    assert len(list(empty(page(["—", "—"], ["1", "1"])))) == 1
    assert not list(empty(page(["0", "1"], ["—", "1"])))
    assert len(list(noise(page(["1", "6.9·10⁻¹⁴"], ["1", "1"])))) == 1
