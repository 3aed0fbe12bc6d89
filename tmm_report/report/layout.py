"""How a table of the note is cut into parts that fit the width of an A4 page."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.quantity.ref import Ref
from tmm_report.records import dataclass

TEXT_WIDTH = 165.0  # mm, of A4 between margins of 30 and 15 mm
CHAR, PADDING = (
    2.15,
    2.6,
)  # mm: a digit of a table's font, in the widest of the fonts asked for; both cell margins
WHOLE = 20  # rows: a longer table may be cut by the end of a page


class Cell(str):
    """A printed number, or a word that stands for one, that knows where it stands in the results.

    `full`: the number with the zeros at its end that were left out.
    """

    ref: Ref
    full: str

    def __new__(cls, text: str, ref: Ref, full: str = "") -> Cell:
        cell = super().__new__(cls, text)
        cell.ref, cell.full = ref, full or text
        return cell


class Words(Markup):
    """Ready words that stand for a number or a text of the results."""

    ref: Ref

    def __new__(cls, text: Markup, ref: Ref) -> Words:
        cell = super().__new__(cls, text)
        cell.ref = ref
        return cell


class Column(NamedTuple):
    head: Any
    cells: Sequence[str]
    least: int = 6  # characters that the head needs

    @property
    def width(self) -> float:
        return PADDING + CHAR * max(self.least, *(len(cell) for cell in self.cells))


@dataclass(frozen=True)
class Part:
    """What stands side by side on the page. `shares`: widths of the columns in parts of the text's width."""

    head: Sequence[Any]
    rows: Sequence[Sequence[Any]]
    shares: Sequence[float]

    @property
    def long(self) -> bool:
        return len(self.rows) > WHOLE


@dataclass(frozen=True)
class Table:
    caption: Any
    parts: Sequence[Part]
    words: bool = False  # of text: as wide as the page


def worded(
    caption: Any, head: Sequence[Any], rows: Iterable[Sequence[Any]], shares: Sequence[float]
) -> Table:
    """A table with text in its cells; widths in proportion to `shares`, but no word of the head is broken."""
    head, lines, shares = _told(head, [list(row) for row in rows], shares)
    least = [(PADDING + CHAR * _longest_word(str(cell))) / TEXT_WIDTH for cell in head]
    wide = [max(0.0, share / sum(shares) - low) for share, low in zip(shares, least, strict=True)]
    room = max(0.0, 1 - sum(least)) / (sum(wide) or 1.0)
    whole = sum(least) + room * sum(wide)
    parts = [(low + room * more) / whole for low, more in zip(least, wide, strict=True)]
    return Table(caption, [Part(head, _aligned(lines), parts)], words=True)


DASH = "\N{EM DASH}"


def _told(
    head: Sequence[Any], rows: list[list[Any]], shares: Sequence[float]
) -> tuple[list[Any], list[list[Any]], list[float]]:
    """The columns that say something: one of dashes alone is left out, the first stays."""
    kept = [k for k in range(len(head)) if k == 0 or not rows or any(str(row[k]) != DASH for row in rows)]
    return [head[k] for k in kept], [[row[k] for k in kept] for row in rows], [shares[k] for k in kept]


def _aligned(rows: list[list[Any]]) -> list[list[Any]]:
    """Numbers of one column of the results with as many decimals under one another as their digits allow."""
    columns = [padded(column) for column in zip(*rows, strict=True)]
    return [list(row) for row in zip(*columns, strict=True)]


def padded(cells: Sequence[Any]) -> Sequence[Any]:
    """Numbers of one column of the results with as many decimals as their digits allow; other cells as they are."""
    numbers = [cell for cell in cells if isinstance(cell, Cell) and _DECIMAL.fullmatch(cell.full)]
    if len({(cell.ref.key, cell.ref.by, cell.ref.unit) for cell in numbers}) != 1:
        return cells
    most = max(map(_decimals, numbers))
    return [_to(cell, most) if any(cell is number for number in numbers) else cell for cell in cells]


def _to(cell: Cell, places: int) -> Cell:
    """The number with so many decimals, or as many as it was rounded to."""
    known, own = _decimals(cell.full), _decimals(cell)
    more = min(places, known) - own
    return Cell(cell.full[: len(cell.full) - (known - own - more)], cell.ref, cell.full) if more > 0 else cell


_DECIMAL = re.compile(r"[−-]?\d+[.,]\d+")


def _decimals(text: str) -> int:
    match = re.search(r"[.,](\d+)$", text)
    return len(match[1]) if match else 0


def _longest_word(text: str) -> int:
    """Letters of the longest word of a cell that may hold markup."""
    return max((len(word) for word in re.findall(r"[^\W\d_]+(?![^<]*>)", text)), default=0)


def numeric(caption: Any, first: Column, columns: Sequence[Column]) -> Table:
    """A table of numbers, cut into parts as wide as the page; each begins with the first column.

    A column of dashes alone is left out.
    """
    columns = [column for column in columns if not column.cells or any(c != DASH for c in column.cells)]
    return Table(caption, [_part([first, *block]) for block in _blocks(columns, TEXT_WIDTH - first.width)])


def _blocks(columns: Sequence[Column], room: float) -> Iterator[Sequence[Column]]:
    """Neighbouring columns, about equally many in each block, none wider than the room."""
    widest = max((column.width for column in columns), default=room)
    most = max(1, int(room / widest))
    count = max(1, -(-len(columns) // most))
    size = max(1, -(-len(columns) // count))
    return (columns[k : k + size] for k in range(0, max(1, len(columns)), size))


def _part(columns: Sequence[Column]) -> Part:
    rows = list(zip(*(column.cells for column in columns), strict=True))
    return Part([c.head for c in columns], rows, [c.width / TEXT_WIDTH for c in columns])
