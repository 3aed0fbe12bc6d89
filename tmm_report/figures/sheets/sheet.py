"""A drawing sheet by GOST 2.301 and 2.104: pictures with their titles in its frame, above the title block (form 1).

Zero is the lower left corner of the paper, mm. Lines are those of GOST 2.303, letters those of GOST 2.304.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property

from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts
from tmm_report.figures.primitives import Arc, Arrow, Box, Circle, Item, Path, Pen, Text
from tmm_report.figures.sheets.form import TALL as BLOCK
from tmm_report.figures.sheets.form import TURNED, WIDE, Said, form, turned
from tmm_report.figures.sheets.strokes import SMALLEST, Letters
from tmm_report.records import dataclass

MAIN = 0.6  # mm: s of GOST 2.303
HALF, THIN = 0.3, 0.2  # s/2 and s/3, between which thin lines are
BOLD = 0.38  # mm: what is at least as wide in a note is a main line
LIGHT = 0.26  # what is at most as wide in it is as thin as may be
DASHED, CENTRE, PHANTOM = (4.0, 1.5), (8.0, 1.2, 0.6, 1.2), (8.0, 1.5, 0.5, 1.5, 0.5, 1.5)
LONG, SHORT = (8.0, 2.0), (2.0, 1.0)  # dashed lines are from the one to the other
BINDING, EDGE = 20.0, 5.0  # mm: from the frame to the edge of the paper
GAP = 8.0  # mm between pictures, and between them and the frame
TITLE = 5.0  # mm: capitals of a title
STEP = 1.8  # from line to line, in heights of the letters
LEAST = 110.0  # mm: a title is not set narrower, unless its letters need no more


Title = tuple[Parts, ...]  # what stands together on one line: a word, a symbol with its value


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
class Block:
    """A picture with its title above it, on its own axes: items, letters, and what they take, mm."""

    items: tuple[Item, ...]
    letters: tuple[Letters, ...]
    title: Title

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
    def size(self) -> tuple[float, float]:
        left, bottom, right, top = self.box
        return right - left, top - bottom

    def at(self, left: float, bottom: float) -> Block:
        """Moved so that this is its lower left corner."""
        by = complex(left - self.box[0], bottom - self.box[1])
        items = tuple(one.moved(by) for one in self.items)
        return Block(items, tuple(one.moved(by) for one in self.letters), self.title)


def block(drawing: Drawing, title: Title, times: float = 1.0) -> Block:
    """A picture of a note as it stands on a sheet, `times` as large; letters stay what they are on a sheet."""
    left, bottom, _, _ = drawing.box
    drawing = drawing.moved(
        -complex(left, bottom)
    )  # counted from its own corner: no digits are lost far away
    base = 5.0 if times >= 2 else SMALLEST
    items = tuple(_larger(item, times) for item in drawing.items if not isinstance(item, Text))
    letters = tuple(
        Letters(times * item.at, item.parts, base, item.align)
        for item in drawing.items
        if isinstance(item, Text)
    )
    bare = Block(items, letters, title)
    return replace(bare, letters=(*letters, *_titled(bare, title)))


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


def _larger(item: Item, times: float) -> Item:
    match item:
        case Path():
            strokes = tuple(tuple(times * z for z in stroke) for stroke in item.strokes)
            return replace(item, strokes=strokes, held=frozenset(), pen=_pen(item.pen), fill=_fill(item.fill))
        case Circle():
            return replace(
                item,
                centre=times * item.centre,
                radius=_radius(item, times),
                pen=_pen(item.pen),
                fill=_fill(item.fill),
            )
        case Arc():
            return replace(item, centre=times * item.centre, radius=times * item.radius, pen=_ruled(item.pen))
        case Arrow():
            return replace(item, start=times * item.start, end=times * item.end, pen=_ruled(item.pen))
        case Text():
            return item


def _radius(item: Circle, times: float) -> float:
    """A dot, which has no line, is a sign and not a size."""
    return item.radius if item.pen is None else times * item.radius


def _pen(pen: Pen | None) -> Pen | None:
    return None if pen is None else _ruled(pen)


def _ruled(pen: Pen) -> Pen:
    """The line of GOST 2.303 for that of a note: black, main or thin, and of what is broken always thin."""
    if not pen.dash:
        return Pen(MAIN if pen.width >= BOLD else THIN if pen.width <= LIGHT else HALF)
    if len(pen.dash) == 2:  # curves of one graph are told from one another by these
        return Pen(HALF, dash=LONG if pen.dash[0] >= 4 else DASHED if pen.dash[0] >= 1.8 else SHORT)
    return Pen(HALF, dash=CENTRE if len(pen.dash) == 4 else PHANTOM)


def _fill(fill: str) -> str:
    return fill if fill in ("", "white", "pale", "grey") else "black"


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


def free_of(format: Format, taken: Sequence[Box]) -> list[Box]:
    """The largest rectangles of the field that hold none of what is taken, with a gap around it."""
    left, bottom, right, top = format.field
    free = [(left + GAP, bottom + GAP, right - GAP, top - GAP)]
    for box in (format.block, format.turned, *taken):
        hit = (box[0] - GAP, box[1] - GAP, box[2] + GAP, box[3] + GAP)
        free = [part for one in free for part in _without(one, hit)]
        free = [one for one in free if not any(one is not other and _inside(one, other) for other in free)]
    return free


def _without(one: Box, hit: Box) -> list[Box]:
    left, bottom, right, top = one
    if hit[0] >= right or hit[2] <= left or hit[1] >= top or hit[3] <= bottom:
        return [one]
    parts = [
        (left, bottom, hit[0], top),
        (hit[2], bottom, right, top),
        (left, bottom, right, hit[1]),
        (left, hit[3], right, top),
    ]
    return [part for part in parts if part[2] - part[0] > 1 and part[3] - part[1] > 1]


def _inside(one: Box, other: Box) -> bool:
    return (
        one != other
        and other[0] <= one[0]
        and other[1] <= one[1]
        and other[2] >= one[2]
        and other[3] >= one[3]
    )


def places(format: Format, blocks: Sequence[Block]) -> dict[int, tuple[float, float]]:
    """Lower left corners, mm, of as many as the sheet holds, by their numbers: large ones first, each as high and as
    far to the left as it can be."""
    found, taken = dict[int, tuple[float, float]](), list[Box]()
    for n in sorted(range(len(blocks)), key=lambda n: -blocks[n].size[0] * blocks[n].size[1]):
        wide, tall = blocks[n].size
        room = [one for one in free_of(format, taken) if one[2] - one[0] >= wide and one[3] - one[1] >= tall]
        if room:
            left, _, _, top = min(room, key=lambda one: (-one[3], one[0]))
            found[n] = left, top - tall
            taken.append((left, top - tall, left + wide, top))
    return found


def placed(format: Format, blocks: Sequence[Block]) -> dict[int, Block]:
    """Those at their places."""
    return {n: blocks[n].at(*corner) for n, corner in places(format, blocks).items()}
