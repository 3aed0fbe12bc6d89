"""A drawing sheet by GOST 2.301 and 2.104: pictures with their titles in its frame, above the title block (form 1).

Zero is the lower left corner of the paper, mm. Lines are those of GOST 2.303, letters those of GOST 2.304.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.figures.drawing import Drawing
from tmm_report.figures.primitives import Box, Item, Path, Pen
from tmm_report.figures.sheets.block import Block, Size
from tmm_report.figures.sheets.form import TALL as BLOCK
from tmm_report.figures.sheets.form import TURNED, WIDE, Said, form, turned
from tmm_report.figures.sheets.lines import MAIN
from tmm_report.figures.sheets.strokes import SMALLEST, Letters
from tmm_report.records import dataclass

Array = Any

BINDING, EDGE = 20.0, 5.0  # mm: from the frame to the edge of the paper
SETTLED = 12  # rounds after which pictures that share the room stay where they are
GAP = 8.0  # mm between pictures, and between them and the frame


@dataclass(frozen=True)
class Format:
    """A format of GOST 2.301: width and height, mm."""

    name: str
    wide: float
    tall: float

    @property
    def field(self) -> Box:
        """What is inside the frame: left, bottom, right, top."""
        return BINDING, EDGE, self.wide - EDGE, self.tall - EDGE

    @property
    def block(self) -> Box:
        """Where the title block stands."""
        right = self.wide - EDGE
        return right - WIDE, EDGE, right, EDGE + BLOCK

    @property
    def turned(self) -> Box:
        """Where the designation stands on its head."""
        left, _, _, top = self.field
        return left, top - TURNED[1], left + TURNED[0], top


FORMATS = (
    Format("A4", 210, 297), Format("A3", 420, 297), Format("A2", 594, 420), Format("A1", 841, 594),
    Format("A0", 1189, 841), Format("A0x2", 1682, 1189), Format("A0x3", 2523, 1189),
)  # fmt: skip
LARGEST = 3  # the largest on which more than one picture is put


@dataclass(frozen=True)
class Sheet:
    """`name`: of its file; `blocks`: in their places; what the title block says, with its numbers."""

    name: str
    format: Format
    blocks: tuple[Block, ...]
    said: Said

    @cached_property
    def frame(self) -> tuple[tuple[Item, ...], tuple[Letters, ...]]:
        left, bottom, right, top = self.format.field
        corners = (complex(left, bottom), complex(right, bottom), complex(right, top), complex(left, top))
        lines, letters = form(self.said)
        once_more, on_its_head = turned(self.said.designation)
        x, y, _, _ = self.format.block
        paper = (
            0j,
            complex(self.format.wide),
            complex(self.format.wide, self.format.tall),
            complex(0, self.format.tall),
        )
        items: list[Item] = [Path((paper,), Pen(0.1), closed=True), Path((corners,), Pen(MAIN), closed=True)]
        items += [one.moved(complex(x, y)) for one in lines]
        items += [one.moved(complex(left, top)) for one in once_more]
        letters += [one.moved(complex(left - x, top - y)) for one in on_its_head]
        mark = Letters(
            complex(right, EDGE / 2 + 0.5), (f"{self.said.words['Формат']} {self.format.name}",), SMALLEST, 1
        )
        return tuple(items), (*(one.moved(complex(x, y)) for one in letters), mark)

    @property
    def letters(self) -> tuple[Letters, ...]:
        return (*self.frame[1], *(one for block in self.blocks for one in block.letters))

    @property
    def items(self) -> tuple[Item, ...]:
        return (*self.frame[0], *(one for block in self.blocks for one in block.items))

    @property
    def drawing(self) -> Drawing:
        """The sheet with its letters as strokes: its box is the paper."""
        strokes = [one.path for one in self.letters if one.path.strokes]
        return Drawing((*self.items, *strokes), self.said.sheet, margin=0.0)


def free_of(format: Format) -> Array:
    """The largest rectangles (N, 4) of the field that hold neither the title block nor the designation."""
    left, bottom, right, top = format.field
    free = np.array([[left + GAP, bottom + GAP, right - GAP, top - GAP]])
    return _less(_less(free, format.block), format.turned)


def _less(free: Array, taken: Box) -> Array:
    """What is left of free rectangles (N, 4) beside what is taken, with a gap around it: the largest ones."""
    left, bottom, right, top = taken[0] - GAP, taken[1] - GAP, taken[2] + GAP, taken[3] + GAP
    apart = (free[:, 2] <= left) | (right <= free[:, 0]) | (free[:, 3] <= bottom) | (top <= free[:, 1])
    parts = np.repeat(free[~apart], 4, axis=0)
    for k, (side, end) in enumerate(((2, left), (0, right), (3, bottom), (1, top))):
        parts[k::4, side] = end
    parts = parts[(parts[:, 2:] - parts[:, :2] > 1).all(axis=1)]
    found = np.concatenate([free[apart], parts])
    low, high = found[:, :2], found[:, 2:]
    inside = (low[:, None] >= low).all(axis=-1) & (high[:, None] <= high).all(axis=-1)
    inside &= ~np.triu(inside & inside.T)  # of equal ones the first is kept
    return found[~inside.any(axis=1)]


def places(format: Format, sizes: Sequence[Size]) -> dict[int, tuple[float, float]]:
    """Lower left corners, mm, of as many as the sheet holds, by their numbers: large ones first, each as high and as
    far to the left as it can be."""
    found, free = dict[int, tuple[float, float]](), free_of(format)
    for n in sorted(range(len(sizes)), key=lambda n: -sizes[n][0] * sizes[n][1]):
        wide, tall = sizes[n]
        room = free[(free[:, 2:] - free[:, :2] >= (wide, tall)).all(axis=1)].tolist()
        if room:
            left, _, _, top = min(room, key=lambda one: (-one[3], one[0]))
            found[n] = left, top - tall
            free = _less(free, (left, top - tall, left + wide, top))
    return found


def spread(format: Format, blocks: Sequence[Block]) -> list[Block]:
    """Blocks moved so that no side is left white: each, the lowest and leftmost first, to the middle of what
    is free between others, up and down and across, until they have settled."""
    boxes = [list(one.box) for one in blocks]
    for _ in range(SETTLED):
        for along in (1, 0):
            for box in sorted(boxes, key=lambda box: box[along]):
                low, high = _free(format, boxes, box, along)
                half = (box[along + 2] - box[along]) / 2
                box[along], box[along + 2] = (low + high) / 2 - half, (low + high) / 2 + half
    return [one.at(left, bottom) for one, (left, bottom, _, _) in zip(blocks, boxes, strict=True)]


def _free(format: Format, boxes: Sequence[list[float]], box: list[float], along: int) -> tuple[float, float]:
    """From where to where a box may be moved across (0), or up and down (1), with its gaps."""
    low, high = format.field[along], format.field[along + 2]
    aside = 1 - along
    for other in (*boxes, format.block, format.turned):
        if other[aside] < box[aside + 2] + GAP and box[aside] < other[aside + 2] + GAP:
            low = max(low, other[along + 2]) if other[along + 2] <= box[along] else low
            high = min(high, other[along]) if other[along] >= box[along + 2] else high
    return low + GAP, high - GAP


def placed(format: Format, blocks: Sequence[Block]) -> dict[int, Block]:
    """Those at their places."""
    found = places(format, [one.size for one in blocks])
    return {n: blocks[n].at(*corner) for n, corner in found.items()}
