"""The title block of a drawing, form 1 of GOST 2.104-2006 with its graph 26, mm, with letters of strokes: 3.5 mm high
and more."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from tmm_report.figures.primitives import Item, Path, Pen
from tmm_report.figures.sheets.strokes import SMALLEST, Letters, plain
from tmm_report.figures.title_block import CHANGE, WIDE, Cell
from tmm_report.records import dataclass

__all__ = ["TALL", "TURNED", "WIDE", "Said", "form", "turned"]

TALL = 55.0
TURNED = (70.0, 14.0)  # width and height of graph 26
THICK, THIN = Pen(0.6), Pen(0.2)
SPACE = 0.8  # mm: between letters and the line beside them
STEP = 1.45  # from line to line, in heights of the letters
TALLEST = 1.8  # heights of the letters that the only line of a cell needs, with what hangs below it
TIGHT = 0.6  # letters are not squeezed more
UPRIGHT = ((0, 0, 55), (7, 30, 55), (17, 0, 55), (40, 0, 55), (55, 0, 55), (65, 0, 55), (135, 0, 40), (150, 20, 40),
           (155, 15, 20), (167, 20, 40), (185, 0, 55))  # fmt: skip
LEVEL = (
    (0, 0, 185),
    (55, 0, 185),
    (40, 65, 185),
    (35, 0, 65),
    (35, 135, 185),
    (30, 0, 65),
    (20, 135, 185),
    (15, 65, 185),
)
FINE = tuple((y, 0, 65) for y in (50, 45, 40, 25, 20, 15, 10, 5))
HEADS: dict[str, Cell] = {
    "Лит.": (135, 35, 15, 5), "Масса": (150, 35, 17, 5), "Масштаб": (167, 35, 18, 5),
}  # fmt: skip


@dataclass(frozen=True)
class Said:
    """What is written: the designation, the name of the project and that of the sheet, whose it is, (role, name) of up
    to six people from above, the scale, the number of the sheet and that of all, and the words of the form itself by
    the Russian ones."""

    designation: str
    name: str
    sheet: str
    organisation: str
    people: Sequence[tuple[str, str]]
    scale: str
    number: int
    count: int
    words: Mapping[str, str]


def form(said: Said) -> tuple[list[Item], list[Letters]]:
    """Lines and letters; zero is the lower left corner."""
    thick = [((x + 1j * low), (x + 1j * high)) for x, low, high in UPRIGHT]
    thick += [(left + 1j * y, right + 1j * y) for y, left, right in LEVEL]
    thin = [(left + 1j * y, right + 1j * y) for y, left, right in FINE]
    thin += [(x + 20j, x + 35j) for x in (140, 145)]
    return [Path(tuple(thin), THIN), Path(tuple(thick), THICK)], list(_letters(said))


def turned(designation: str) -> tuple[list[Item], list[Letters]]:
    """The designation once more, on its head (graph 26), so that it is read on a sheet that lies the other way round;
    zero is the upper left corner of the frame."""
    wide, tall = TURNED
    corners = (0j, complex(wide), complex(wide, -tall), -1j * tall)
    upright = within((0, -tall, wide, tall), designation, 7.0)
    middle = complex(wide, -tall)  # twice
    letters = [replace(one, at=middle - one.at, turned=True) for one in upright]
    return [Path((corners,), THICK, closed=True)], letters


def _letters(said: Said) -> Iterator[Letters]:
    left = 0.0
    for wide, word in zip(CHANGE, ("Изм.", "Лист", "№ докум.", "Подп.", "Дата"), strict=True):
        yield from within((left, 30, wide, 5), said.words[word])
        left += wide
    for word, cell in HEADS.items():
        yield from within(cell, said.words[word])
    # the number of a sheet stands where there are several, that of all of them on the first alone
    number, count = said.number if said.count > 1 else "", said.count if said.number == 1 else ""
    yield from within((135, 15, 20, 5), f"{said.words['Лист']} {number}")
    yield from within((155, 15, 30, 5), f"{said.words['Листов']} {count}")
    yield from within((167, 20, 18, 15), said.scale, 5.0)
    yield from within((65, 40, 120, 15), said.designation, 7.0)
    yield from within((65, 27, 70, 13), said.name, 5.0)
    yield from within((65, 15, 70, 12), said.sheet, 5.0)
    yield from within((135, 0, 50, 15), said.organisation, 5.0)
    for row, (role, name) in enumerate(said.people):
        yield from within((0, 25 - 5 * row, 17, 5), role, align=-1)
        yield from within((17, 25 - 5 * row, 23, 5), name, align=-1)


def within(cell: Cell, text: str, largest: float = SMALLEST, align: int = 0) -> Iterator[Letters]:
    """A text within its cell, in the middle or from its left side (-1): in the largest letters that it has room for,
    else in the smallest ones squeezed; what these have no room for ends with an ellipsis."""
    left, bottom, wide, tall = cell
    room, text = wide - 2 * SPACE, " ".join(plain(text[:500]).split())
    tries = [(size, 1.0) for size in (7.0, 5.0, 3.5) if size <= largest] + [
        (SMALLEST, 0.8),
        (SMALLEST, TIGHT),
    ]
    for size, squeeze in tries:
        rows = _rows(text, size, room / squeeze)
        held = max(1, 1 + int((tall - TALLEST * size) / (STEP * size)))
        fits = len(rows) <= held and all(_wide(row, size) <= room / squeeze for row in rows)
        if fits:
            break
    shown = [
        _cut(row, size, room / squeeze, n == held - 1 < len(rows) - 1) for n, row in enumerate(rows[:held])
    ]
    x = left + SPACE if align else left + wide / 2
    top = bottom + tall / 2 + STEP * size * (len(shown) - 1) / 2
    for n, row in enumerate(shown):
        if row:
            yield Letters(complex(x, top - STEP * size * n), (row,), size, -1 if align else 0, squeeze)


def _wide(text: str, size: float) -> float:
    return Letters(0j, (text,), size).wide


def _rows(text: str, size: float, room: float) -> list[str]:
    rows = [""]
    for word in text.split():
        longer = f"{rows[-1]} {word}".strip()
        if rows[-1] and _wide(longer, size) > room:
            rows.append(word)
        else:
            rows[-1] = longer
    return rows


def _cut(row: str, size: float, room: float, more: bool) -> str:
    """As much of a row as there is room for; `more`: something goes on behind it."""
    if not more and _wide(row, size) <= room:
        return row
    while row and _wide(row + "...", size) > room:
        row = row[:-1]
    return row.rstrip() + "..."
