"""Primitives of a drawing, mm of paper: lines, arcs, arrows, lettering, each written as SVG and as TikZ.

Each knows its outline (polylines, mm), its shifted copy, its SVG and its TikZ; a place is one complex number, y up.
The numbers of places in SVG are written for the whole drawing at once: an item adds its places to a list and leaves a
`%.7g` for each of their two numbers, x and −y.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import field, replace
from functools import cached_property, lru_cache
from itertools import chain
from typing import Literal

import numpy as np

from tmm_report.figures.lettering import Parts, svg_parts, tex_parts, width, xml_text
from tmm_report.records import dataclass

Box = tuple[float, float, float, float]  # left, bottom, right, top
Measure = Callable[[Parts, float], Box]  # of a text of a size: what it takes, its middle at zero

TEXT = 3.2  # height of lettering, mm
HEAD = 3.0  # length of an arrowhead, mm

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

_ROUND = tuple(cmath.rect(1, math.pi * i / 8) for i in range(17))


@dataclass(frozen=True)
class Path:
    """Polylines drawn as one: a line, a polyline, a polygon (`closed`), a hatching of many strokes."""

    strokes: tuple[tuple[complex, ...], ...]
    pen: Pen | None = NORMAL
    fill: str = ""
    closed: bool = False
    opacity: float = 1.0  # of the fill
    held: frozenset[complex] = frozenset()  # of its points, those it goes through though it is drawn by fewer

    def outline(self) -> list[tuple[complex, ...]]:
        return [(*stroke, stroke[0]) if self.closed else stroke for stroke in self.strokes]

    def moved(self, by: complex) -> Path:
        strokes = tuple(tuple(z + by for z in stroke) for stroke in self.strokes)
        return replace(self, strokes=strokes, held=frozenset(z + by for z in self.held))

    def corners(self) -> Iterable[complex]:
        return chain.from_iterable(self.strokes)

    def svg(self, places: list[complex]) -> str:
        places += self.corners()
        d = "".join([_svg_stroke(len(stroke), self.closed) for stroke in self.strokes])
        return f'<path d="{d}"{_svg_look(self.pen, self.fill, self.opacity)}/>'

    def tikz(self) -> str:
        end = " -- cycle" if self.closed else ""
        strokes = " ".join(" -- ".join(map(tikz_point, stroke)) + end for stroke in self.strokes)
        return rf"\path[{_tikz_look(self.pen, self.fill, self.opacity)}] {strokes};"


@dataclass(frozen=True)
class Circle:
    centre: complex
    radius: float
    pen: Pen | None = NORMAL
    fill: str = ""

    def outline(self) -> list[tuple[complex, ...]]:
        return [tuple(self.centre + self.radius * turn for turn in _ROUND)]

    def corners(self) -> Iterable[complex]:
        reach = complex(self.radius, self.radius)
        return self.centre - reach, self.centre + reach

    def moved(self, by: complex) -> Circle:
        return replace(self, centre=self.centre + by)

    def svg(self, places: list[complex]) -> str:
        places.append(self.centre)
        look = _svg_look(self.pen, self.fill, 1.0)
        return f'<circle cx="%.7g" cy="%.7g" r="{written(self.radius)}"{look}/>'

    def tikz(self) -> str:
        look = _tikz_look(self.pen, self.fill, 1.0)
        return rf"\path[{look}] {tikz_point(self.centre)} circle[radius={written(self.radius)}];"


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
        return [self._points]

    @cached_property
    def _points(self) -> tuple[complex, ...]:
        count = 2 + int(abs(self.end - self.start) / 0.1)
        step = (self.end - self.start) / (count - 1)
        return tuple(self.at(self.start + step * i) for i in range(count))

    def corners(self) -> Iterable[complex]:
        return self._points

    def moved(self, by: complex) -> Arc:
        return replace(self, centre=self.centre + by)

    def svg(self, places: list[complex]) -> str:
        places += self.at(self.start), self.at(self.end)
        large, sweep = int(abs(self.end - self.start) > math.pi), int(self.end < self.start)
        r = written(self.radius)
        d = f"M%.7g %.7gA{r} {r} 0 {large} {sweep} %.7g %.7g"
        return f'<path d="{d}"{_svg_look(self.pen, "", 1.0)}/>'

    def tikz(self) -> str:
        angles = f"start angle={math.degrees(self.start):.4f},end angle={math.degrees(self.end):.4f}"
        arc = f"arc[{angles},radius={written(self.radius)}]"
        return rf"\path[{_tikz_look(self.pen, '', 1.0)}] {tikz_point(self.at(self.start))} {arc};"


@dataclass(frozen=True)
class Arrow:
    """A segment from `start` to `end` with a filled head, never longer than a quarter of the segment.

    `of`: key of the quantity that it shows, "" where there is none. `aside`: how far it stands to the left of its own
    line, mm, where another lies upon it there.
    """

    start: complex
    end: complex
    pen: Pen = NORMAL
    head: float = HEAD
    of: str = ""
    aside: float = 0.0

    @cached_property
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
        return [(self.start, self.end), *self.parts[1].outline()]

    def corners(self) -> Iterable[complex]:
        return self.start, *self.parts[1].strokes[0]

    def moved(self, by: complex) -> Arrow:
        return replace(self, start=self.start + by, end=self.end + by)

    def svg(self, places: list[complex]) -> str:
        shaft, head = self.parts
        drawn = shaft.svg(places) + head.svg(places)
        aside = f' data-aside="{written(self.aside)}"' if self.aside else ""
        return f'<g data-q="{_as_it_is(xml_text(self.of))}"{aside}>{drawn}</g>' if self.of else drawn

    def tikz(self) -> str:
        shaft, head = self.parts
        return shaft.tikz() + "\n" + head.tikz()


@dataclass(frozen=True)
class Tag:
    """A text that seeks its place beside one of its `anchors`, best on the side `prefer` (unit or 0); `loose`: its
    middle is best at the anchor itself, and no line leads to it."""

    parts: Parts
    anchors: tuple[complex, ...]
    gap: float = 1.2  # clear distance from the anchor, mm
    prefer: complex = 0j
    size: float = TEXT
    colour: str = "black"
    loose: bool = False

    def moved(self, by: complex) -> Tag:
        return replace(self, anchors=tuple(z + by for z in self.anchors))


@dataclass(frozen=True)
class Text:
    """Lettering at a place: its middle in height, its left (-1), middle (0) or right end (1) by `align`; `tag`: what it
    is of that has sought its place."""

    at: complex
    parts: Parts
    size: float = TEXT
    align: Literal[-1, 0, 1] = -1
    colour: str = "black"
    tag: Tag | None = field(default=None, compare=False)

    @property
    def baseline(self) -> complex:
        return self.at - 0.35j * self.size

    @cached_property
    def box(self) -> Box:
        return self.taken(letters_box)

    def taken(self, measure: Measure) -> Box:
        """What it takes where its letters are those of a measure."""
        left, bottom, right, top = measure(self.parts, self.size)
        left, right = ((x - left) - (right - left) * (1 + self.align) / 2 for x in (left, right))
        x, y = self.at.real, self.at.imag
        return x + left, y + bottom, x + right, y + top

    def outline(self) -> list[tuple[complex, ...]]:
        x0, y0, x1, y1 = self.box
        return [(complex(x0, y0), complex(x1, y0), complex(x1, y1), complex(x0, y1))]

    def corners(self) -> Iterable[complex]:
        x0, y0, x1, y1 = self.box
        return complex(x0, y0), complex(x1, y1)

    def moved(self, by: complex) -> Text:
        return replace(self, at=self.at + by, tag=self.tag and self.tag.moved(by))

    def svg(self, places: list[complex]) -> str:
        places.append(self.baseline)
        anchor = ("", ' text-anchor="middle"', ' text-anchor="end"')[self.align + 1]
        size = f' font-size="{self.size}"' if self.size != TEXT else ""
        fill = f' fill="#{COLOURS[self.colour]}"' if self.colour != "black" else ""
        text = _as_it_is(svg_parts(self.parts, self.size))
        return f'<text x="%.7g" y="%.7g"{anchor}{size}{fill}>{text}</text>'

    def tikz(self) -> str:
        anchor = ("base west", "base", "base east")[self.align + 1]
        # a whole number of points, for the fonts of TeX come in these
        look = (
            rf"anchor={anchor},text={tikz_colour(self.colour)},font=\drawingfont{{{self.size / 0.3515:.0f}}}"
        )
        return rf"\node[{look}] at {tikz_point(self.baseline)} {{{tex_parts(self.parts)}}};"


Item = Path | Circle | Arc | Arrow | Text


class Leader(Path):
    """The thin line that leads to a label put far from its place."""


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


def heights(parts: Parts) -> tuple[float, float]:
    """Depth below and height above the baseline, in sizes of the text."""
    low, high = 0.22, 0.76
    for part in parts:
        if not isinstance(part, str):
            low = 0.38 if part.sub else low
            high = 0.92 if part.sup or part.bar else high
    return low, high


def letters_box(parts: Parts, size: float) -> Box:
    """Of the letters of a note."""
    low, high = heights(parts)
    half = width(parts, size) / 2
    return -half, -(0.35 + low) * size, half, (high - 0.35) * size


# --- how a number, a place and a pen are written ---


def written(value: float) -> str:
    """To a thousandth of a mm, without a tail of zeros and without -0."""
    return f"{round(value, 3) + 0.0:.7g}"


def with_places(svg: str, places: Sequence[complex]) -> str:
    """The SVG with the numbers of its places as `written` writes them, all at once."""
    numbers = np.array(places, complex).conj().view(float)
    rounded = np.round(numbers, 3)
    # numpy rounds the product with 1000, which decides a half otherwise than the number itself
    halves = np.nonzero(np.abs(np.abs(1000 * (numbers - rounded)) - 0.5) < 1e-6)[0]
    rounded[halves] = [round(x, 3) for x in numbers[halves].tolist()]
    return svg % tuple((rounded + 0.0).tolist())


def _as_it_is(text: str) -> str:
    """Text among which numbers are put in."""
    return text.replace("%", "%%")


@lru_cache
def _svg_stroke(points: int, closed: bool) -> str:
    return "M" + "L".join(["%.7g %.7g"] * points) + ("Z" if closed else "")


@lru_cache
def _svg_look(pen: Pen | None, fill: str, opacity: float) -> str:
    look = f' fill="#{COLOURS[fill]}"' if fill else ""
    look += f' fill-opacity="{opacity:g}"' if opacity < 1 else ""
    if pen is not None:
        look += f' stroke="#{COLOURS[pen.colour]}" stroke-width="{written(pen.width)}"'
        look += f' stroke-dasharray="{" ".join(map(written, pen.dash))}"' if pen.dash else ""
    return look


def tikz_point(z: complex) -> str:
    return f"({written(z.real)},{written(z.imag)})"


def tikz_colour(name: str) -> str:
    return "drawing" + name


@lru_cache
def _tikz_look(pen: Pen | None, fill: str, opacity: float) -> str:
    look = [f"fill={tikz_colour(fill)}"] if fill else []
    look += [f"fill opacity={opacity:g}"] if opacity < 1 else []
    if pen is not None:
        look += [f"draw={tikz_colour(pen.colour)}", f"line width={written(pen.width)}mm"]
    if pen is not None and pen.dash:
        pairs = zip(pen.dash[::2], pen.dash[1::2], strict=True)
        look += ["dash pattern=" + " ".join(f"on {written(on)}mm off {written(off)}mm" for on, off in pairs)]
    return ",".join(look)
