"""How a table of the note is cut into parts that fit the width of an A4 page."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.quantity.ref import Ref

TEXT_WIDTH = 165.0  # mm, of A4 between margins of 30 and 15 mm
CHAR, PADDING = (
    2.15,
    2.6,
)  # mm: a digit of a table's font, in the widest of the fonts asked for; both cell margins
WHOLE = 20  # rows: a longer table may be cut by the end of a page


class Cell(str):
    """A printed number, or a word that stands for one, that knows where it stands in the results."""

    ref: Ref

    def __new__(cls, text: str, ref: Ref) -> Cell:
        cell = super().__new__(cls, text)
        cell.ref = ref
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
    least = [(PADDING + CHAR * _longest_word(str(cell))) / TEXT_WIDTH for cell in head]
    wide = [max(0.0, share / sum(shares) - low) for share, low in zip(shares, least, strict=True)]
    room = max(0.0, 1 - sum(least)) / (sum(wide) or 1.0)
    whole = sum(least) + room * sum(wide)
    parts = [(low + room * more) / whole for low, more in zip(least, wide, strict=True)]
    return Table(caption, [Part(head, [list(row) for row in rows], parts)], words=True)


def _longest_word(text: str) -> int:
    """Letters of the longest word of a cell that may hold markup."""
    return max((len(word) for word in re.findall(r"[^\W\d_]+(?![^<]*>)", text)), default=0)


def numeric(caption: Any, first: Column, columns: Sequence[Column]) -> Table:
    """A table of numbers, cut into parts as wide as the page; each begins with the first column."""
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
