"""The title block of a text document by GOST 2.104-2006, mm: form 2 on its first sheet, form 2a on those after it.

Zero is the lower left corner of the block, which stands in the lower right corner of the frame of its sheet. The number
of the sheet, and of form 2 that of all sheets, are put in where the pages are counted.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from tmm_report.figures.drawing import Drawing, Item, Path, Pen, Text
from tmm_report.figures.lettering import width
from tmm_report.records import dataclass

THICK, THIN = Pen(0.5), Pen(0.25)
SIZES = (7.0, 5.0, 3.5, 2.5, 1.8)  # of letters, GOST 2.304
STEP = 1.4  # between lines, in sizes of their letters
SPACE = 0.8  # mm: between letters and the line beside them
WIDE = 185.0  # of a block
CHANGE = (7.0, 10.0, 23.0, 15.0, 10.0)  # widths of the columns at the left
Cell = tuple[float, float, float, float]  # left, bottom, width, height


class Form(NamedTuple):
    """Height of the block; where the number of the sheet and that of all sheets stand."""

    tall: float
    number: Cell
    sheets: Cell | None = None


FIRST = Form(40.0, (150.0, 15.0, 15.0, 5.0), (165.0, 15.0, 20.0, 5.0))  # form 2
NEXT = Form(15.0, (175.0, 0.0, 10.0, 8.0))  # form 2a


@dataclass(frozen=True)
class Said:
    """What is written: the designation, the name of the document, whose it is, (role, name) of up to five people from
    above, and the words of the form itself by the Russian ones."""

    designation: str
    name: str
    organisation: str
    people: Sequence[tuple[str, str]]
    words: Mapping[str, str]


def first(said: Said) -> Drawing:
    """Form 2."""
    thick = [(0, 25, 185, 25), (0, 30, 65, 30), (135, 20, 185, 20), (135, 15, 185, 15), (7, 25, 7, 40)]
    thick += [(x, 0, x, 40) for x in (17, 40, 55, 65)] + [
        (135, 0, 135, 25),
        (150, 15, 150, 25),
        (165, 15, 165, 25),
    ]
    thin = [(0, y, 65, y) for y in (5, 10, 15, 20, 35)] + [(140, 15, 140, 20), (145, 15, 145, 20)]
    items = [*_lines(FIRST.tall, thick, thin), *_changes(25.0, said.words)]
    items += [
        *_texts([((65, 25, 120, 15), said.designation)], 7.0),
        *_texts([((65, 0, 70, 25), said.name)], 5.0),
    ]
    items += _texts([((135, 0, 50, 15), said.organisation)], 3.5)
    heads: dict[str, Cell] = {"Лит.": (135, 20, 15, 5), "Лист": (150, 20, 15, 5), "Листов": (165, 20, 20, 5)}
    items += _texts([(cell, said.words[word]) for word, cell in heads.items()])
    rows = [20.0 - 5 * row for row in range(len(said.people))]
    roles: list[tuple[Cell, str]] = [
        ((0, low, 17, 5), role) for low, (role, _) in zip(rows, said.people, strict=True)
    ]
    names: list[tuple[Cell, str]] = [
        ((17, low, 23, 5), name) for low, (_, name) in zip(rows, said.people, strict=True)
    ]
    items += [*_texts(roles, align=-1), *_texts(names, align=-1)]
    return Drawing(tuple(items), margin=0.0)


def following(said: Said) -> Drawing:
    """Form 2a."""
    thick = [(x, 0, x, 15) for x in (7, 17, 40, 55, 65, 175)] + [(175, 8, 185, 8), (0, 5, 65, 5)]
    items = [*_lines(NEXT.tall, thick, [(0, 10, 65, 10)]), *_changes(0.0, said.words)]
    items += [
        *_texts([((65, 0, 110, 15), said.designation)], 7.0),
        *_texts([((175, 8, 10, 7), said.words["Лист"])]),
    ]
    return Drawing(tuple(items), margin=0.0)


def _lines(tall: float, thick: Sequence[Cell], thin: Sequence[Cell]) -> Iterator[Item]:
    box = [(0, 0, WIDE, 0), (0, tall, WIDE, tall), (0, 0, 0, tall), (WIDE, 0, WIDE, tall)]
    for pen, lines in ((THIN, thin), (THICK, [*box, *thick])):
        yield Path(tuple((complex(x, y), complex(to, up)) for x, y, to, up in lines), pen)


def _changes(bottom: float, words: Mapping[str, str]) -> Iterator[Item]:
    """The heads of the columns of changes."""
    left, cells = 0.0, list[tuple[Cell, str]]()
    for wide, word in zip(CHANGE, ("Изм.", "Лист", "№ докум.", "Подп.", "Дата"), strict=True):
        cells.append(((left, bottom, wide, 5.0), words[word]))
        left += wide
    yield from _texts(cells)


def _texts(cells: Sequence[tuple[Cell, str]], largest: float = 2.5, align: int = 0) -> Iterator[Item]:
    """Texts of one kind, each within its cell, in the middle or from its left side (-1), all in the largest letters
    that each has room for, on as many lines as these need; what the smallest ones have no room for ends with an
    ellipsis."""
    size = min(_size(cell, text, largest) for cell, text in cells)
    for (left, bottom, wide, tall), text in cells:
        room, held = wide - 2 * SPACE, _held(tall, size)
        lines = _on_lines(text, size, room)
        lines = [
            _cut(line, size, room, n == held - 1 < len(lines) - 1) for n, line in enumerate(lines[:held])
        ]
        x = left + SPACE if align else left + wide / 2
        top = bottom + tall / 2 + STEP * size * (len(lines) - 1) / 2
        for n, line in enumerate(lines):
            if line:
                yield Text(complex(x, top - STEP * size * n), (line,), size, -1 if align else 0)


def _size(cell: Cell, text: str, largest: float) -> float:
    """Of the largest letters in which a text has room in its cell, or of the smallest."""
    room = cell[2] - 2 * SPACE
    for size in (size for size in SIZES if size <= largest):
        lines = _on_lines(text, size, room)
        if len(lines) <= _held(cell[3], size) and all(width((line,), size) <= room for line in lines):
            return size
    return SIZES[-1]


def _held(tall: float, size: float) -> int:
    """How many lines of letters of this size a cell holds."""
    return max(1, int(tall / (STEP * size)))


def _on_lines(text: str, size: float, room: float) -> list[str]:
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and width((longer,), size) > room:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def _cut(line: str, size: float, room: float, more: bool) -> str:
    """As much of a line as there is room for; `more`: something goes on behind it."""
    if not more and width((line,), size) <= room:
        return line
    while line and width((line + "…",), size) > room:
        line = line[:-1]
    return line.rstrip() + "…"
