"""How a table of the note is cut into parts that fit the width of the page: when it is printed, as the note's profile
says how wide that is."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from itertools import groupby
from typing import Any, NamedTuple

from markupsafe import Markup

from tmm_report.quantity.ref import Ref
from tmm_report.records import dataclass
from tmm_report.report.paper.measure import whole, widest_word
from tmm_report.report.paper.sheets import USUAL, Paper

LEAST = 99.5  # of units of the last decimal: what is less has not three digits in its column
WHOLE = 20  # rows: a longer table may be cut by the end of a page
TALL, NARROW = 10, 0.48  # rows of a table, and its share of the page, that stands in halves in a shorter note


class Cell(str):
    """A printed number, or a word that stands for one, that knows where it stands in the results.

    `full`: the number with the zeros at its end that were left out; `to`: the number to so many decimals.
    """

    ref: Ref
    full: str
    to: Callable[[int], str] | None

    def __new__(cls, text: str, ref: Ref, full: str = "", to: Callable[[int], str] | None = None) -> Cell:
        cell = super().__new__(cls, text)
        cell.ref, cell.full, cell.to = ref, full or text, to
        return cell


class Words(Markup):
    """Ready words that stand for a number or a text of the results."""

    ref: Ref

    def __new__(cls, text: Markup, ref: Ref) -> Words:
        cell = super().__new__(cls, text)
        cell.ref = ref
        return cell


class Column(NamedTuple):
    """`letter`: of one quantity; a column without one is not left out though it is all nought."""

    head: Any
    cells: Sequence[str]
    letter: Any = None

    def width(self, paper: Paper) -> float:
        """mm, no word of the head and no number being broken."""
        return _least(self.head, self.cells, paper)

    @property
    def aligned(self) -> Column:
        return self._replace(cells=padded(self.cells))

    @property
    def nought(self) -> bool:
        """Whether it is 0 in each of its rows, to all digits that are printed."""
        return self.letter is not None and len(self.cells) > 1 and all(cell == "0" for cell in self.cells)


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
    cut: Callable[[Paper], Sequence[Part]]
    words: bool = False  # of text: as wide as the page
    nought: Sequence[Any] = ()  # letters of the columns that are 0 in every row, and said so below it

    @property
    def parts(self) -> Sequence[Part]:
        """On the usual paper."""
        return self.cut(USUAL)


def worded(
    caption: Any, head: Sequence[Any], rows: Iterable[Sequence[Any]], shares: Sequence[float]
) -> Table:
    """A table with text in its cells; widths in proportion to `shares`, but no word is broken.

    What is wider than the page is cut into parts; each begins with the first column.
    """
    head, lines, shares = _told(head, [list(row) for row in rows], shares)
    lines = _aligned(lines)
    columns = list(zip(*lines, strict=True)) or [()] * len(head)

    def cut(paper: Paper) -> list[Part]:
        least = [_least(name, cells, paper) for name, cells in zip(head, columns, strict=True)]
        blocks = _blocks(least[1:], paper.width - least[0])
        kept = [[0, *(1 + k for k in block)] for block in blocks]
        return [
            Part(
                [head[k] for k in ks],
                [[row[k] for k in ks] for row in lines],
                _shared([shares[k] for k in ks], [least[k] / paper.width for k in ks]),
            )
            for ks in kept
        ]

    return Table(caption, cut, words=True)


def _shared(shares: Sequence[float], least: Sequence[float]) -> list[float]:
    """Parts of the page's width: in proportion, but none is less than it must be."""
    wide = [max(0.0, share / sum(shares) - low) for share, low in zip(shares, least, strict=True)]
    room = max(0.0, 1 - sum(least)) / (sum(wide) or 1.0)
    whole = sum(least) + room * sum(wide)
    return [(low + room * more) / whole for low, more in zip(least, wide, strict=True)]


def _least(head: Any, cells: Iterable[Any], paper: Paper) -> float:
    """The width of a column, mm, in which nothing is broken that may not be."""
    texts = {str(cell) for cell in cells}
    if all(map(_NUMERIC.fullmatch, texts)):  # of numbers the longest is the widest, but for a comma or a sign
        most = max(map(len, texts), default=0)
        texts = {text for text in texts if len(text) > most - 2}
    return paper.padding + paper.em * max(map(widest_word, (str(head), *texts)))


_NUMERIC = re.compile(r"[\d.,−-]*|—")


DASH = "\N{EM DASH}"


def _told(
    head: Sequence[Any], rows: list[list[Any]], shares: Sequence[float]
) -> tuple[list[Any], list[list[Any]], list[float]]:
    """The columns that say something: one of dashes alone is left out, the first stays."""
    kept = [k for k in range(len(head)) if k == 0 or not rows or any(str(row[k]) != DASH for row in rows)]
    return [head[k] for k in kept], [[row[k] for k in kept] for row in rows], [shares[k] for k in kept]


def _aligned(rows: list[list[Any]]) -> list[list[Any]]:
    """Numbers of one column of the results under one another."""
    columns = [padded(column) for column in zip(*rows, strict=True)]
    return [list(row) for row in zip(*columns, strict=True)]


def padded(cells: Sequence[Any]) -> Sequence[Any]:
    """Numbers of one column of the results under one another, other cells as they are.

    All have the decimals of the largest, as far as one of them needs them; where the smallest would lose its digits,
    each has its own, with the zeros at its end.
    """
    numbers = [cell for cell in cells if isinstance(cell, Cell) and cell.to and _NUMBER.fullmatch(cell.full)]
    if len(numbers) < 2 or len({(cell.ref.key, cell.ref.by, cell.ref.unit) for cell in numbers}) != 1:
        return cells
    places = min(_decimals(max(numbers, key=_size).full), max(map(_decimals, numbers)))
    most, own = max(map(_decimals, numbers)), set(map(id, numbers))
    common = all(_kept(cell, places) for cell in numbers)
    return [
        _to(cell, places if common else min(most, _decimals(cell.full))) if id(cell) in own else cell
        for cell in cells
    ]


def _size(cell: Cell) -> float:
    return float(cell.full.lstrip("−-").replace(",", "."))


def _kept(cell: Cell, places: int) -> bool:
    """Whether a number keeps its digits, or three of them, to so many decimals."""
    return _decimals(cell) <= places or _size(cell) * 10**places >= LEAST


def _to(cell: Cell, places: int) -> Cell:
    return Cell(cell.to(places), cell.ref, cell.full, cell.to) if cell.to else cell


_NUMBER = re.compile(r"(?!0$)[−-]?\d+(?:[.,]\d+)?")  # but 0, which has no digits to be rounded
_PLACES = re.compile(r"[.,](\d+)$")


def _decimals(text: str) -> int:
    match = _PLACES.search(text)
    return len(match[1]) if match else 0


def numeric(caption: Any, first: Column, columns: Sequence[Column]) -> Table:
    """A table of numbers, cut into parts as wide as the page; each begins with the first column.

    A column of dashes alone is left out; of noughts alone, too, and told below the table.
    """
    first, columns = first.aligned, [column.aligned for column in columns]
    columns = [column for column in columns if not column.cells or any(c != DASH for c in column.cells)]
    columns, nought = _telling(columns)

    def cut(paper: Paper) -> list[Part]:
        widths = [column.width(paper) for column in columns]
        blocks = _blocks(widths, paper.width - first.width(paper))
        return [part([first, *(columns[k] for k in block)], paper) for block in blocks]

    return Table(caption, cut, nought=nought)


def _telling(columns: Sequence[Column]) -> tuple[list[Column], list[Any]]:
    """Columns that are not all nought, and the letters of the others; where nothing else is left, all stay."""
    telling = [column for column in columns if not column.nought]
    if not telling:
        return list(columns), []
    return telling, [column.letter for column in columns if column.nought]


def runs(numbers: Sequence[int]) -> list[list[int]]:
    """Numbers that follow one another, together."""
    found: list[list[int]] = []
    for k in numbers:
        if found and k == found[-1][-1] + 1:
            found[-1].append(k)
        else:
            found.append([k])
    return found


def joined(first: Column, columns: Sequence[Column]) -> tuple[Column, list[Column]]:
    """Three and more rows that follow one another and differ by nothing but their numbers, as one row: "15–23"."""
    rows = list(zip(*(column.cells for column in columns), strict=True))
    alike = [list(run) for _, run in groupby(range(len(rows)), key=rows.__getitem__)]
    blocks = [block for run in alike for block in ([run] if len(run) > 2 else [[k] for k in run])]
    names = [
        first.cells[run[0]] if len(run) == 1 else f"{first.cells[run[0]]}–{first.cells[run[-1]]}"
        for run in blocks
    ]
    kept = [run[0] for run in blocks]
    return first._replace(cells=names), [one._replace(cells=[one.cells[k] for k in kept]) for one in columns]


def _blocks(widths: Sequence[float], room: float) -> list[range]:
    """Neighbouring columns by their numbers, about equally many in each block, no block wider than the room."""
    for size in range(len(widths), 1, -1):
        size = -(-len(widths) // -(-len(widths) // size))  # as many blocks, about equally long
        blocks = [range(k, min(k + size, len(widths))) for k in range(0, len(widths), size)]
        if all(sum(widths[k] for k in block) <= room for block in blocks):
            return blocks
    return [range(k, k + 1) for k in range(len(widths))] or [range(0)]


def part(columns: Sequence[Column], paper: Paper = USUAL) -> Part:
    """Columns side by side; the room that is left goes to heads that would stand on several lines."""
    rows = list(zip(*(column.cells for column in columns), strict=True))
    least = [column.width(paper) for column in columns]
    more = [
        max(0.0, paper.padding + paper.em * whole(str(column.head)) - width)
        for column, width in zip(columns, least, strict=True)
    ]
    share = min(1.0, max(0.0, paper.width - sum(least)) / (sum(more) or 1.0))
    widths = [width + share * extra for width, extra in zip(least, more, strict=True)]
    return Part([c.head for c in columns], rows, [width / paper.width for width in widths])


def folded(part: Part) -> Part:
    """A tall narrow part in two halves side by side, the second beside the first."""
    if len(part.rows) < TALL or sum(part.shares) > NARROW:
        return part
    half = -(-len(part.rows) // 2)
    beside = [*part.rows[half:], [""] * len(part.head)][:half]
    rows = [[*row, *other] for row, other in zip(part.rows[:half], beside, strict=True)]
    return Part([*part.head, *part.head], rows, [*part.shares, *part.shares])


def packed(caption: Any, first: Column, lead: list[Column], groups: Sequence[list[Column]]) -> Table:
    """A table cut so that the columns of a group stand side by side; each part begins with the first columns."""
    first, lead = first.aligned, [column.aligned for column in lead]
    told = [_telling([column.aligned for column in group]) for group in groups]

    def cut(paper: Paper) -> list[Part]:
        room = paper.width - sum(column.width(paper) for column in (first, *lead))
        parts: list[list[Column]] = []
        for group, _ in told:
            width = sum(column.width(paper) for column in group)
            if parts and sum(column.width(paper) for column in parts[-1]) + width <= room:
                parts[-1] += group
            else:
                parts.append(list(group))
        return [part([first, *lead, *block], paper) for block in parts]

    return Table(caption, cut, nought=[letter for _, nought in told for letter in nought])
