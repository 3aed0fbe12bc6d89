"""A picture of a note as it stands on a sheet: lines by GOST 2.303, letters by GOST 2.304, its title above it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache, cached_property, lru_cache
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.figures.charts.axes import Hand
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.charts.sheet import JOINED
from tmm_report.figures.crowded import within
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.figures.placing import relettered
from tmm_report.figures.primitives import Box, Item, Leader, Measure, Path, Text
from tmm_report.figures.sheets.lines import larger
from tmm_report.figures.sheets.strokes import LINE, SIZES, Letters
from tmm_report.records import dataclass

TITLE = 5.0  # mm: capitals of a title
BETWEEN = 0.5  # mm: kept free to either side of a label
CLEAR = 0.5  # mm: between letters and the lines of a grid
STEP = 2.1  # from line to line, in heights of the letters
CAPITAL = 0.7  # height of a capital of a note, in sizes of its text
LEAST = 110.0  # mm: a title is not set narrower, unless its letters need no more

Array = Any
Size = tuple[float, float]  # width and height, mm
Title = tuple[Parts, ...]  # what stands together on one line: a word, a symbol with its value


@dataclass(frozen=True)
class Block:
    """A picture with its title above it, on its own axes: items, letters, and what they take, mm; `clear`: no letters
    touch others or lines."""

    items: tuple[Item, ...]
    letters: tuple[Letters, ...]
    title: Title
    clear: bool = True

    @cached_property
    def box(self) -> Box:
        points = [z for item in self.items for z in item.corners()]
        boxes = [one.box for one in self.letters]
        left = min([z.real for z in points] + [box[0] for box in boxes], default=0.0)
        bottom = min([z.imag for z in points] + [box[1] for box in boxes], default=0.0)
        right = max([z.real for z in points] + [box[2] for box in boxes], default=0.0)
        top = max([z.imag for z in points] + [box[3] for box in boxes], default=0.0)
        return left, bottom, right, top

    @property
    def size(self) -> Size:
        left, bottom, right, top = self.box
        return right - left, top - bottom

    def at(self, left: float, bottom: float) -> Block:
        """Moved so that this is its lower left corner."""
        by = complex(left - self.box[0], bottom - self.box[1])
        items = tuple(one.moved(by) for one in self.items)
        return replace(self, items=items, letters=tuple(one.moved(by) for one in self.letters))


def block(picture: Drawing | Graph, title: Title, times: float = 1.0) -> Block:
    """A picture of a note as it stands on a sheet, `times` as large, its letters written and placed anew."""
    measures = [_measure(times, True), _measure(times, False)]
    if isinstance(picture, Graph):
        picture, times = picture.by(LARGE if times >= 2 else SMALL, times).drawing, 1.0
        measures = [_measure(times, False)]
    left, bottom, _, _ = picture.box
    placed = picture.moved(-complex(left, bottom)).items  # from its own corner: no digits are lost far away
    found, measure, clear = relettered([_open(item) for item in placed], measures)
    large = measure is _measure(times, True)
    letters = tuple(
        Letters(times * item.at, item.parts, _tall(item.parts, item.size * times, large), item.align)
        for item in found
        if isinstance(item, Text)
    )
    taken = [_around(one) for one in letters]
    items = tuple(larger(_off(item, taken, times), times) for item in found if not isinstance(item, Text))
    bare = Block(items, letters, title, clear)
    return replace(bare, letters=(*letters, *_titled(bare, title)))


def _open(item: Item) -> Item:
    """What joins the extremes of a graph is broken by letters as its grid is."""
    if isinstance(item, Path) and item.pen == JOINED:
        return replace(item, pen=replace(JOINED, colour="pale"))
    return item


def _around(one: Letters) -> Box:
    left, bottom, right, top = one.box
    return left - CLEAR, bottom - CLEAR, right + CLEAR, top + CLEAR


def _off(item: Item, taken: Sequence[Box], times: float) -> Item:
    """The lines of a grid, which letters of a note may stand on, end at those of a sheet."""
    if not isinstance(item, Path) or item.pen is None or item.pen.colour != "pale" or not taken:
        return item
    boxes = np.array(taken) / times
    pieces = [piece for stroke in item.strokes for pair in pairwise(stroke) for piece in _clear(pair, boxes)]
    return replace(item, strokes=tuple(pieces), closed=False)


def _clear(line: tuple[complex, complex], boxes: Array) -> Iterator[tuple[complex, complex]]:
    """What is left of a line outside of boxes (N, 4)."""
    start, along = line[0], line[1] - line[0]
    done = 0.0
    for low, high in sorted(within(boxes, np.array(line))):
        if low > done:
            yield start + done * along, start + low * along
        done = max(done, high)
    if done < 1:
        yield start + done * along, line[1]


def least(picture: Drawing | Graph, times: float) -> Size:
    """What a picture takes at least."""
    if isinstance(picture, Graph):
        top = picture.panels[0]
        return times * top.wide, times * sum(panel.tall for panel in picture.panels) + 2 * TITLE
    places = [z for item in picture.items if not isinstance(item, Text | Leader) for z in item.corners()]
    x, y = [z.real for z in places] or [0.0], [z.imag for z in places] or [0.0]
    return times * (max(x) - min(x)), times * (max(y) - min(y)) + 2 * TITLE


def _tall(parts: Parts, size: float, large: bool) -> float:
    """Of a text which a note would have `size` mm high: the height nearest to that of its capitals; of a symbol with an
    index, where there is room, larger than the index can be."""
    if large and any(isinstance(part, Symbol) and (part.sub or part.sup) for part in parts):
        return SIZES[1]
    return min(SIZES[:2], key=lambda tall: abs(math.log(tall / (CAPITAL * size))))


@cache
def _measure(times: float, large: bool) -> Measure:
    """What letters of a sheet take in the note's drawing, with their lines."""

    @lru_cache(maxsize=4096)
    def taken(parts: Parts, size: float) -> Box:
        tall = _tall(parts, size * times, large)
        left, bottom, right, top = Letters(0j, parts, tall, 0).box
        half = LINE * tall / 2
        aside = half + BETWEEN
        return (left - aside) / times, (bottom - half) / times, (right + aside) / times, (top + half) / times

    return taken


def _wide(parts: Parts, size: float) -> float:
    return Letters(0j, parts, _tall(parts, size, False)).wide


SMALL, LARGE = Hand(4.2, 5.5, 9.0, _wide), Hand(4.2, 7.5, 11.0, _wide)  # letters of graphs


def _titled(bare: Block, title: Title) -> Iterator[Letters]:
    """The lines of a title, above the middle of a picture."""
    left, _, right, top = bare.box
    rows = wrapped(title, TITLE, max(right - left, LEAST))
    middle = (left + right) / 2
    for n, row in enumerate(reversed(rows)):
        one = Letters(complex(middle, top + 1.4 * TITLE + STEP * TITLE * n), row, TITLE, 0)
        yield replace(one, squeeze=min(1.0, max(right - left, LEAST) / max(one.wide, 1e-9)))


def wrapped(title: Title, tall: float, room: float) -> list[Parts]:
    """A title on as many lines as it needs; what stands together is wider than a line only alone on it."""
    rows: list[Parts] = []
    for words in title:
        longer = (*rows[-1], " ", *words) if rows else words
        if rows and Letters(0j, longer, tall).wide <= room:
            rows[-1] = longer
        else:
            rows.append(words)
    return rows
