"""Drawings in millimetres of paper: a frozen tuple of primitives, written as SVG and as TikZ.

1 unit is 1 mm, so the printed length of a segment is its drawn length; x to the right, y up; a place is one
complex number. The arrowheads are filled polygons, so nothing needs an id.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Literal

from tmm_report.figures.lettering import Parts, svg_parts, tex_parts, width, xml_text

Box = tuple[float, float, float, float]  # left, bottom, right, top

TEXT = 3.2  # height of lettering, mm
HEAD = 3.0  # length of an arrowhead, mm
CLEAR = 0.2  # free space sought round lettering, mm

COLOURS = {
    "black": "000000",
    "grey": "7F7F7F",
    "blue": "1B4F9C",
    "red": "B3261E",
    "green": "1E6B3A",
    "pale": "C9D6E8",
    "white": "FFFFFF",
}


@dataclass(frozen=True)
class Pen:
    """How a line is drawn: width and dashes in mm, a colour of COLOURS."""

    width: float
    colour: str = "black"
    dash: tuple[float, ...] = ()


THICK = Pen(0.6)
NORMAL = Pen(0.35)
THIN = Pen(0.18)
DASHED = Pen(0.25, dash=(2.0, 1.0))
AXIS = Pen(0.18, dash=(5.0, 1.0, 0.6, 1.0))


# --- primitives: each knows its outline (polylines, mm), its shifted copy, its SVG and its TikZ ---


@dataclass(frozen=True)
class Path:
    """Polylines drawn as one: a line, a polyline, a polygon (`closed`), a hatching of many strokes."""

    strokes: tuple[tuple[complex, ...], ...]
    pen: Pen | None = NORMAL
    fill: str = ""
    closed: bool = False
    opacity: float = 1.0  # of the fill

    def outline(self) -> list[tuple[complex, ...]]:
        return [(*stroke, stroke[0]) if self.closed else stroke for stroke in self.strokes]

    def moved(self, by: complex) -> Path:
        return replace(self, strokes=tuple(tuple(z + by for z in stroke) for stroke in self.strokes))

    def svg(self) -> str:
        end = "Z" if self.closed else ""
        d = "".join("M" + "L".join(map(_svg_point, stroke)) + end for stroke in self.strokes)
        return f'<path d="{d}"{_svg_look(self.pen, self.fill, self.opacity)}/>'

    def tikz(self) -> str:
        end = " -- cycle" if self.closed else ""
        strokes = " ".join(" -- ".join(map(_tikz_point, stroke)) + end for stroke in self.strokes)
        return rf"\path[{_tikz_look(self.pen, self.fill, self.opacity)}] {strokes};"


@dataclass(frozen=True)
class Circle:
    centre: complex
    radius: float
    pen: Pen | None = NORMAL
    fill: str = ""

    def outline(self) -> list[tuple[complex, ...]]:
        return [tuple(self.centre + self.radius * turn for turn in _ROUND)]

    def moved(self, by: complex) -> Circle:
        return replace(self, centre=self.centre + by)

    def svg(self) -> str:
        x, y = _number(self.centre.real), _number(-self.centre.imag)
        return f'<circle cx="{x}" cy="{y}" r="{_number(self.radius)}"{_svg_look(self.pen, self.fill, 1.0)}/>'

    def tikz(self) -> str:
        look = _tikz_look(self.pen, self.fill, 1.0)
        return rf"\path[{look}] {_tikz_point(self.centre)} circle[radius={_number(self.radius)}];"


@dataclass(frozen=True)
class Arc:
    """An arc from angle `start` to `end`, rad, counter-clockwise when end > start; less than a full turn."""

    centre: complex
    radius: float
    start: float
    end: float
    pen: Pen = NORMAL

    def at(self, angle: float) -> complex:
        return self.centre + cmath.rect(self.radius, angle)

    def outline(self) -> list[tuple[complex, ...]]:
        count = 2 + int(abs(self.end - self.start) / 0.1)
        step = (self.end - self.start) / (count - 1)
        return [tuple(self.at(self.start + step * i) for i in range(count))]

    def moved(self, by: complex) -> Arc:
        return replace(self, centre=self.centre + by)

    def svg(self) -> str:
        r, large, sweep = (
            _number(self.radius),
            int(abs(self.end - self.start) > math.pi),
            int(self.end < self.start),
        )
        d = f"M{_svg_point(self.at(self.start))}A{r} {r} 0 {large} {sweep} {_svg_point(self.at(self.end))}"
        return f'<path d="{d}"{_svg_look(self.pen, "", 1.0)}/>'

    def tikz(self) -> str:
        angles = f"start angle={math.degrees(self.start):.4f},end angle={math.degrees(self.end):.4f}"
        arc = f"arc[{angles},radius={_number(self.radius)}]"
        return rf"\path[{_tikz_look(self.pen, '', 1.0)}] {_tikz_point(self.at(self.start))} {arc};"


@dataclass(frozen=True)
class Arrow:
    """A segment from `start` to `end` with a filled head, never longer than a quarter of the segment.

    `of`: key of the quantity that it shows, "" where there is none.
    """

    start: complex
    end: complex
    pen: Pen = NORMAL
    head: float = HEAD
    of: str = ""

    def parts(self) -> tuple[Path, Path]:
        """The shaft, which stops inside the head to keep the tip sharp, and the head; its tip is `end`."""
        along = self.end - self.start
        length = abs(along)
        head = min(self.head, length / 4)
        unit = along / length
        base = self.end - head * unit
        pen = self.pen if self.pen.width <= 0.3 * head else replace(self.pen, width=0.3 * head)
        wing = 0.17j * head * unit
        shaft = Path(((self.start, base + 0.3 * head * unit),), pen)
        return shaft, Path(((self.end, base + wing, base - wing),), None, pen.colour, closed=True)

    def outline(self) -> list[tuple[complex, ...]]:
        return [(self.start, self.end), *self.parts()[1].outline()]

    def moved(self, by: complex) -> Arrow:
        return replace(self, start=self.start + by, end=self.end + by)

    def svg(self) -> str:
        shaft, head = self.parts()
        drawn = shaft.svg() + head.svg()
        return f'<g data-q="{xml_text(self.of)}">{drawn}</g>' if self.of else drawn

    def tikz(self) -> str:
        shaft, head = self.parts()
        return shaft.tikz() + "\n" + head.tikz()


@dataclass(frozen=True)
class Text:
    """Lettering at a place: its middle in height, its left (-1), middle (0) or right end (1) by `align`."""

    at: complex
    parts: Parts
    size: float = TEXT
    align: Literal[-1, 0, 1] = -1
    colour: str = "black"

    @property
    def baseline(self) -> complex:
        return self.at - 0.35j * self.size

    @property
    def box(self) -> Box:
        wide = width(self.parts, self.size)
        left = self.at.real - wide * (1 + self.align) / 2
        low, high = _heights(self.parts)
        base = self.baseline.imag
        return left, base - low * self.size, left + wide, base + high * self.size

    def outline(self) -> list[tuple[complex, ...]]:
        x0, y0, x1, y1 = self.box
        return [(complex(x0, y0), complex(x1, y0), complex(x1, y1), complex(x0, y1))]

    def moved(self, by: complex) -> Text:
        return replace(self, at=self.at + by)

    def svg(self) -> str:
        x, y = _number(self.baseline.real), _number(-self.baseline.imag)
        anchor = ("", ' text-anchor="middle"', ' text-anchor="end"')[self.align + 1]
        size = f' font-size="{self.size}"' if self.size != TEXT else ""
        fill = f' fill="#{COLOURS[self.colour]}"' if self.colour != "black" else ""
        return f'<text x="{x}" y="{y}"{anchor}{size}{fill}>{svg_parts(self.parts, self.size)}</text>'

    def tikz(self) -> str:
        anchor = ("base west", "base", "base east")[self.align + 1]
        # a whole number of points, for the fonts of TeX come in these
        look = (
            rf"anchor={anchor},text={_tikz_colour(self.colour)},font=\drawingfont{{{self.size / 0.3515:.0f}}}"
        )
        return rf"\node[{look}] at {_tikz_point(self.baseline)} {{{tex_parts(self.parts)}}};"


Item = Path | Circle | Arc | Arrow | Text


def line(start: complex, end: complex, pen: Pen = NORMAL) -> Path:
    return Path(((start, end),), pen)


def polyline(points: Iterable[complex], pen: Pen = NORMAL) -> Path:
    return Path((tuple(points),), pen)


def polygon(
    points: Iterable[complex], pen: Pen | None = NORMAL, fill: str = "", opacity: float = 1.0
) -> Path:
    return Path((tuple(points),), pen, fill, True, opacity)


def dot(at: complex, radius: float = 0.6, colour: str = "black") -> Circle:
    return Circle(at, radius, None, colour)


def hatching(start: complex, end: complex, side: complex, pen: Pen = THIN, step: float = 1.5) -> Path:
    """Strokes along the line from `start` to `end`, slanting to the side of the unit vector `side`, mm."""
    along = (end - start) / abs(end - start)
    stroke = step * (side - along)
    count = max(2, round(abs(end - start) / step))
    feet = [start + along * abs(end - start) * (i + 1) / count for i in range(count)]
    return Path(tuple((foot, foot + stroke) for foot in feet), pen)


# --- the drawing ---


@dataclass(frozen=True)
class Tag:
    """A text that seeks its place beside one of its `anchors`, best on the side `prefer` (unit or 0)."""

    parts: Parts
    anchors: tuple[complex, ...]
    gap: float = 1.2  # clear distance from the anchor, mm
    prefer: complex = 0j
    size: float = TEXT
    colour: str = "black"


@dataclass(frozen=True)
class Drawing:
    """Primitives in the order they are drawn, mm of paper; `title` is read aloud to who cannot see it."""

    items: tuple[Item, ...]
    title: str = ""
    margin: float = field(default=1.0, kw_only=True)

    @cached_property
    def box(self) -> Box:
        """Left, bottom, right and top of all items with the margin, mm."""
        places = [z for item in self.items for stroke in item.outline() for z in stroke] or [0j]
        xs, ys = [z.real for z in places], [z.imag for z in places]
        return min(xs) - self.margin, min(ys) - self.margin, max(xs) + self.margin, max(ys) + self.margin

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, mm."""
        left, bottom, right, top = self.box
        return right - left, top - bottom

    def moved(self, by: complex) -> Drawing:
        return replace(self, items=tuple(item.moved(by) for item in self.items))

    def labelled(self, tags: Sequence[Tag]) -> Drawing:
        """The drawing with each tag put where it covers least of the lines and of the tags before it."""
        return replace(self, items=self.items + tuple(_placed(tags, self.items)))

    def noted(self, *notes: str | Parts) -> Drawing:
        """The drawing with lines of text under its left end; empty ones are left out."""
        left, bottom, _, _ = self.box
        rows: list[Parts] = [(note,) if isinstance(note, str) else note for note in notes if note]
        texts = [Text(complex(left + self.margin, bottom - (2 + 5 * i)), row) for i, row in enumerate(rows)]
        return replace(self, items=(*self.items, *texts))


def together(places: Mapping[str, complex], within: float = 0.5) -> list[tuple[list[str], complex]]:
    """Names grouped where their places coincide `within` mm: [(names, place of the first)]."""
    groups: list[tuple[list[str], complex]] = []
    for name, place in places.items():
        for names, at in groups:
            if abs(place - at) <= within:
                names.append(name)
                break
        else:
            groups.append(([name], place))
    return groups


# --- placing of labels ---

Segment = tuple[float, float, float, float, float]  # x, y of the start, x, y of the end, weight

_SIDES = tuple(cmath.rect(1, math.pi * k / 4) for k in (1, 3, 7, 5, 0, 4, 2, 6))  # corners first
_RINGS = (1.0, 2.2)  # how many gaps away from the anchor


def _placed(tags: Sequence[Tag], items: Sequence[Item]) -> list[Text]:
    segments = [segment for item in items for segment in _segments(item)]
    texts = [item for item in items if isinstance(item, Text)]
    taken = [text.box for text in texts]
    found = []
    for tag in tags:
        text = _best(tag, segments, taken)
        taken.append(text.box)
        found.append(text)
    return found


def _segments(item: Item) -> list[Segment]:
    """Lines that lettering should keep off: a thick one more than a thin one, the inside of a white block too."""
    if isinstance(item, Text):
        return []
    strokes: list[tuple[complex, ...]] = item.outline()
    weight = item.pen.width / NORMAL.width if item.pen else 1.0
    if isinstance(item, Circle) and item.radius < 2:
        reach = item.radius * (1 + 1j)
        strokes = [(item.centre - reach, item.centre + reach)]
    if isinstance(item, Path) and item.fill == "white":
        strokes += [pair for corners in item.strokes for pair in zip(corners, corners[2:], strict=False)]
    return [(a.real, a.imag, b.real, b.imag, weight) for stroke in strokes for a, b in pairwise(stroke)]


def _best(tag: Tag, segments: Sequence[Segment], taken: Sequence[Box]) -> Text:
    """The candidate that covers least; they come in the order of liking, so a clear one ends the search."""
    low, high = _heights(tag.parts)
    half = complex(width(tag.parts, tag.size) / 2, tag.size * (low + high) / 2)
    around = _around(tag, half)
    near = _within(around, segments)
    rivals = [box for box in taken if _shared(_grown(around, 2 * CLEAR), box)]
    wide, tall = half.real + CLEAR, half.imag + CLEAR
    best_cost, best = math.inf, (0j, 0j)
    for dislike, centre, off in _candidates(tag, half):
        if dislike >= best_cost:
            break
        box = (centre.real - wide, centre.imag - tall, centre.real + wide, centre.imag + tall)
        cost = dislike + _covered(box, near) + 4 * sum([_shared(box, other) for other in rivals])
        if cost < best_cost:
            best_cost, best = cost, (centre, off)
    return _text_at(tag, *best, (high - low) / 2)


def _around(tag: Tag, half: complex) -> Box:
    """The box that holds all the candidates."""
    xs, ys = [a.real for a in tag.anchors], [a.imag for a in tag.anchors]
    wide, tall = 2 * half.real + _RINGS[-1] * tag.gap, 2 * half.imag + _RINGS[-1] * tag.gap
    return min(xs) - wide, min(ys) - tall, max(xs) + wide, max(ys) + tall


def _grown(box: Box, by: float) -> Box:
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by


def _within(box: Box, segments: Sequence[Segment]) -> list[Segment]:
    x0, y0, x1, y1 = box
    return [
        s
        for s in segments
        if (s[0] > x0 or s[2] > x0)
        and (s[0] < x1 or s[2] < x1)
        and (s[1] > y0 or s[3] > y0)
        and (s[1] < y1 or s[3] < y1)
    ]


def _candidates(tag: Tag, half: complex) -> list[tuple[float, complex, complex]]:
    """(dislike, centre of the box, from the nearest point of the box to its centre), the best liked first."""
    found = []
    for later, anchor in enumerate(tag.anchors):
        for rank, side in enumerate(_SIDES):
            off = complex(_sign(side.real) * half.real, _sign(side.imag) * half.imag)
            wrong = 0.5 * abs(side - tag.prefer) if tag.prefer else 0.0
            for ring in _RINGS:
                dislike = 0.05 * later + 0.01 * rank + wrong + 0.4 * (ring - 1)
                found.append((dislike, anchor + ring * tag.gap * side + off, off))
    return sorted(found, key=lambda candidate: candidate[0])


def _sign(value: float) -> float:
    return 0.0 if abs(value) < 1e-6 else math.copysign(1.0, value)


def _text_at(tag: Tag, centre: complex, off: complex, lift: float) -> Text:
    """A Text with the box around `centre`, aligned to its anchor's side: a narrower font keeps the gap."""
    align: Literal[-1, 0, 1] = -1 if off.real > 0 else 1 if off.real < 0 else 0
    at = complex(centre.real + abs(off.real) * align, centre.imag - tag.size * (lift - 0.35))
    return Text(at, tag.parts, tag.size, align, tag.colour)


def _covered(box: Box, segments: Sequence[Segment]) -> float:
    """Weighted length of the segments inside the box, mm, and a little for each of them."""
    total = 0.0
    for ax, ay, bx, by, weight in _within(box, segments):
        low, high = 0.0, 1.0
        for start, along, least, most in ((ax, bx - ax, box[0], box[2]), (ay, by - ay, box[1], box[3])):
            if abs(along) < 1e-9:
                if not least < start < most:
                    high = -1.0
                continue
            t1, t2 = (least - start) / along, (most - start) / along
            low, high = max(low, min(t1, t2)), min(high, max(t1, t2))
        if high > low:
            total += weight * (0.3 + (high - low) * math.hypot(bx - ax, by - ay))
    return total


def _shared(box: Box, other: Box) -> float:
    """Area two boxes share, mm²."""
    wide = min(box[2], other[2]) - max(box[0], other[0])
    tall = min(box[3], other[3]) - max(box[1], other[1])
    return wide * tall if wide > 0 and tall > 0 else 0.0


def _heights(parts: Parts) -> tuple[float, float]:
    """Depth below and height above the baseline, in sizes of the text."""
    symbols = [part for part in parts if not isinstance(part, str)]
    low = 0.38 if any(s.sub for s in symbols) else 0.22
    high = 0.92 if any(s.sup or s.bar for s in symbols) else 0.76
    return low, high


# --- SVG ---

_ROUND = tuple(cmath.rect(1, math.pi * i / 8) for i in range(17))
_FONTS = "'STIX Two Text','Times New Roman','Liberation Serif','DejaVu Serif',serif"


FAR = 1000.0  # mm: TeX knows no length over 5.7 m, and a browser counts in single precision


def _near_origin(drawing: Drawing) -> Drawing:
    """A drawing of a mechanism that stands far from its axes' origin, moved to it."""
    left, bottom, right, top = drawing.box
    far = max(abs(left), abs(bottom), abs(right), abs(top)) > FAR
    return drawing.moved(-complex(left, bottom)) if far else drawing


def svg(drawing: Drawing, turned: bool = False) -> str:
    """The drawing as one `svg` element of its size in mm; no ids, no scripts, nothing fetched.

    `turned`: by 90° counter-clockwise, as a wide sheet lies in a tall page.
    """
    drawing = _near_origin(drawing)
    left, bottom, right, top = drawing.box
    wide, tall = _number(right - left), _number(top - bottom)
    corner = (-top, -right) if turned else (left, -top)
    size = (tall, wide) if turned else (wide, tall)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{size[0]}mm" height="{size[1]}mm"'
        f' viewBox="{_number(corner[0])} {_number(corner[1])} {size[0]} {size[1]}">'
    )
    look = 'fill="none" stroke-linecap="round" stroke-linejoin="round"' + (
        ' transform="rotate(-90)"' if turned else ""
    )
    style = f'<g {look} font-family="{_FONTS}" font-size="{TEXT}">'
    body = "".join([item.svg() if not isinstance(item, Text) else "" for item in drawing.items])
    texts = "".join([item.svg() for item in drawing.items if isinstance(item, Text)])
    return (
        f'{head}<title>{xml_text(drawing.title)}</title>{style}{body}<g fill="#000000">{texts}</g></g></svg>'
    )


def _number(value: float) -> str:
    """To a thousandth of a mm, without a tail of zeros and without -0."""
    return f"{round(value, 3) + 0.0:.7g}"


def _svg_point(z: complex) -> str:
    return f"{round(z.real, 3) + 0.0:.7g} {round(-z.imag, 3) + 0.0:.7g}"


@lru_cache
def _svg_look(pen: Pen | None, fill: str, opacity: float) -> str:
    look = f' fill="#{COLOURS[fill]}"' if fill else ""
    look += f' fill-opacity="{opacity:g}"' if opacity < 1 else ""
    if pen is not None:
        look += f' stroke="#{COLOURS[pen.colour]}" stroke-width="{_number(pen.width)}"'
        look += f' stroke-dasharray="{" ".join(map(_number, pen.dash))}"' if pen.dash else ""
    return look


# --- TikZ ---


def tikz(drawing: Drawing) -> str:
    """The drawing as a `tikzpicture`; the document loads tikz, amsmath and fonts for its letters."""
    drawing = _near_origin(drawing)
    left, bottom, right, top = drawing.box
    corners = _tikz_point(complex(left, bottom)), _tikz_point(complex(right, top))
    box = rf"\useasboundingbox {corners[0]} rectangle {corners[1]};"
    colours = [rf"\definecolor{{{_tikz_colour(name)}}}{{HTML}}{{{code}}}" for name, code in COLOURS.items()]
    font = r"\providecommand{\drawingfont}[1]{\fontsize{#1}{#1}\selectfont}"
    options = "x=1mm,y=1mm,line cap=round,line join=round,every node/.style={inner sep=0pt,outer sep=0pt}"
    lines = [item.tikz() for item in drawing.items if not isinstance(item, Text)]
    texts = [item.tikz() for item in drawing.items if isinstance(item, Text)]
    return "\n".join(
        [rf"\begin{{tikzpicture}}[{options}]", font, *colours, box, *lines, *texts, r"\end{tikzpicture}", ""]
    )


def _tikz_point(z: complex) -> str:
    return f"({_number(z.real)},{_number(z.imag)})"


def _tikz_colour(name: str) -> str:
    return "drawing" + name


@lru_cache
def _tikz_look(pen: Pen | None, fill: str, opacity: float) -> str:
    look = [f"fill={_tikz_colour(fill)}"] if fill else []
    look += [f"fill opacity={opacity:g}"] if opacity < 1 else []
    if pen is not None:
        look += [f"draw={_tikz_colour(pen.colour)}", f"line width={_number(pen.width)}mm"]
    if pen is not None and pen.dash:
        pairs = zip(pen.dash[::2], pen.dash[1::2], strict=True)
        look += ["dash pattern=" + " ".join(f"on {_number(on)}mm off {_number(off)}mm" for on, off in pairs)]
    return ",".join(look)
