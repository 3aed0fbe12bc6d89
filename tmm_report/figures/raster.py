"""Drawings as PNG pictures of their true size, for notes that are written in a word processor.

    png(drawing)        # bytes: 300 dots an inch, fewer where they would be over 20 million; white ground

Only here matplotlib is known, and it is loaded when the first picture is printed: its renderer Agg, and its own STIX
fonts, read by their files, so that a picture is the same to the last byte whatever fonts and settings a machine has.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cache, lru_cache
from io import BytesIO
from typing import Any
from zlib import Z_RLE

import numpy as np

from tmm_report.figures.drawing import COLOURS, Arc, Arrow, Box, Circle, Drawing, Item, Path, Pen, Text
from tmm_report.figures.lettering import DROP, RAISE, SMALL, Part, Parts, leaning_runs, leans, width
from tmm_report.records import dataclass

Array = Any

DOTS = 300.0  # an inch
INCH, POINT = 25.4, 25.4 / 72  # mm
MOST, LONGEST = 20e6, 30_000  # pixels of a picture and of its longer side
FLAT = 0.003  # mm: how far a chord is from its arc

MOVE, LINE, CLOSE = 1, 2, 79  # what a path does with a vertex, as matplotlib counts it


@dataclass(frozen=True, eq=False)
class Outline:
    """Lines and areas: vertices (V,), x + iy, and (V,) what is done with each."""

    places: Array
    codes: Array


@dataclass(frozen=True, eq=False)
class Ink:
    """An outline on paper, mm, and how it is drawn and filled."""

    outline: Outline
    pen: Pen | None = None
    fill: str = ""
    opacity: float = 1.0


def png(drawing: Drawing) -> bytes:
    """The drawing as a PNG picture on white. It says how many dots there are to an inch and holds the drawing's title;
    the same drawing gives the same bytes."""
    lines = [item for item in drawing.items if not isinstance(item, Text)]
    texts = [item for item in drawing.items if isinstance(item, Text)]
    inks = [ink for item in (*lines, *texts) for ink in inked(item)]
    return _printed(inks, drawing.box, drawing.title.encode("utf-8", "replace").decode())


def dots(size: tuple[float, float]) -> float:
    """Dots an inch of a picture of this width and height, mm."""
    area, longest = size[0] * size[1] / INCH**2, max(size) / INCH
    return min(DOTS, math.sqrt(MOST / area), LONGEST / longest)


# --- shapes ---


def inked(item: Item) -> Iterator[Ink]:
    """What a primitive leaves on paper."""
    match item:
        case Path():
            strokes = [np.array(stroke, complex) for stroke in item.strokes]
            yield Ink(traced(strokes, item.closed), item.pen, item.fill, item.opacity)
        case Circle():
            yield Ink(traced([_bent(item.centre, item.radius, 0.0, math.tau)], True), item.pen, item.fill)
        case Arc():
            yield Ink(traced([_bent(item.centre, item.radius, item.start, item.end)]), item.pen)
        case Arrow():
            yield from (ink for part in item.parts for ink in inked(part))
        case Text():
            yield Ink(_placed(item), None, item.colour)


def traced(strokes: Sequence[Array], closed: bool = False) -> Outline:
    """Polylines, each (V,), as one outline."""
    return _joined([_stroke(stroke, closed) for stroke in strokes])


def _stroke(places: Array, closed: bool) -> Outline:
    places = np.append(places, places[:1]) if closed else places
    codes = np.full(len(places), LINE, np.uint8)
    codes[:1] = MOVE
    if closed:
        codes[-1:] = CLOSE
    return Outline(places, codes)


def _joined(outlines: Sequence[Outline]) -> Outline:
    if not outlines:
        return Outline(np.empty(0, complex), np.empty(0, np.uint8))
    return Outline(
        np.concatenate([one.places for one in outlines]), np.concatenate([one.codes for one in outlines])
    )


def _bent(centre: complex, radius: float, start: float, end: float) -> Array:
    """Points (V,) along an arc, so near one another that no chord is seen."""
    step = 2 * math.acos(max(1 - FLAT / radius, 0.5)) if radius > FLAT else math.pi / 3
    return centre + radius * np.exp(1j * np.linspace(start, end, 2 + int(abs(end - start) / step)))


# --- lettering ---

_UPRIGHT = ("STIXGeneral.ttf", "DejaVuSans.ttf")  # the second for what the first has not
_ITALIC = ("STIXGeneralItalic.ttf", *_UPRIGHT)
_LINE, _ABOVE = 0.05, 0.1  # thickness of a bar and how far it is above its letters, in sizes of the text


def _placed(text: Text) -> Outline:
    """The letters of a text, mm of paper; a text wider than its estimated box is narrowed to it."""
    letters, wide = lettered(text.parts)
    share = min(1.0, width(text.parts, 1.0) / max(wide, 1e-9))
    start = text.baseline - text.size * share * wide * (1 + text.align) / 2
    return Outline(
        start + text.size * (share * letters.places.real + 1j * letters.places.imag), letters.codes
    )


@lru_cache(maxsize=4096)
def lettered(parts: Parts) -> tuple[Outline, float]:
    """The letters of a text one high on a baseline that begins where their ink does, and how wide that is."""
    outlines: list[Outline] = []
    end = 0.0
    for part in parts:
        found, end = _part(part, end)
        outlines += found
    text = _joined(outlines)
    left, right = (text.places.real.min(), text.places.real.max()) if len(text.codes) else (0.0, 0.0)
    return Outline(text.places - left, text.codes), float(right - left)


def _part(part: Part, start: float) -> tuple[list[Outline], float]:
    """Letters of a part that begins at `start`, and where the next begins. An upper index stands over the lower."""
    if isinstance(part, str):
        return _run(part, False, start)
    base, end = _run(part.base, leans(part), start)
    if part.bar and base:
        base.append(_bar(base, start, end))
    low, low_end = _index(part.sub, end, -DROP)
    high, high_end = _index(part.sup, max(end, _right(base)), RAISE)
    return [*base, *low, *high], max(low_end, high_end) if part.sub or part.sup else end


def _index(text: str, start: float, rise: float) -> tuple[list[Outline], float]:
    outlines: list[Outline] = []
    end = start
    for run, leaning in leaning_runs(text):
        found, end = _run(run, leaning, end, SMALL, rise)
        outlines += found
    return outlines, end


def _run(
    text: str, leaning: bool, start: float, size: float = 1.0, rise: float = 0.0
) -> tuple[list[Outline], float]:
    """Letters of one face and size, and where the next begins."""
    outlines, x = [], start
    for char in text:
        outline, advance = glyph(char, leaning)
        if len(outline.codes):
            outlines.append(Outline(complex(x, rise) + size * outline.places, outline.codes))
        x += size * advance
    return outlines, x


def _bar(letters: Sequence[Outline], start: float, end: float) -> Outline:
    """The bar over the letters of a vector."""
    foot = 1j * (max(float(one.places.imag.max()) for one in letters) + _ABOVE)
    left, right = start + 0.05 * (end - start), max(end, _right(letters))
    return traced([np.array([left, right, right + 1j * _LINE, left + 1j * _LINE]) + foot], True)


def _right(letters: Sequence[Outline]) -> float:
    return max((float(one.places.real.max()) for one in letters), default=0.0)


@cache
def glyph(char: str, leaning: bool) -> tuple[Outline, float]:
    """Outline of a letter one high, from its place on the baseline, and how far the next one stands from it. What no
    font has is an empty box."""
    fonts = [_font(name) for name in (_ITALIC if leaning else _UPRIGHT)]
    font = next((font for font in fonts if font.get_char_index(ord(char))), fonts[-1])
    advance = font.load_glyph(font.get_char_index(ord(char))).linearHoriAdvance / 0x10000
    points, codes = font.get_path()
    places, ends = points @ (1, 1j) / _EM, np.flatnonzero(codes == CLOSE)
    places[ends] = places[ends - 1]  # what closes a contour has no place of its own
    return Outline(places, codes), advance / _EM


_EM = 1000.0  # pixels: so large that no outline is bent to the grid of pixels


@cache
def _font(name: str) -> Any:
    from matplotlib import get_data_path
    from matplotlib.ft2font import FT2Font

    font = FT2Font(f"{get_data_path()}/fonts/ttf/{name}")
    font.set_size(_EM, 72)
    return font


# --- printing ---


def _printed(inks: Sequence[Ink], box: Box, title: str) -> bytes:
    """Inks on white paper, of which the picture shows a box, mm, as a PNG file."""
    from matplotlib.image import imsave

    density = dots((box[2] - box[0], box[3] - box[1]))
    stream = BytesIO()
    imsave(
        stream, _drawn(inks, box, density), format="png", origin="upper", dpi=density,
        metadata={"Software": None, "Title": title},  # type: ignore[dict-item]  # None: nothing is said of it
        pil_kwargs={"compress_type": Z_RLE},  # drawings are long runs of white: as small, and a third sooner
    )  # fmt: skip
    return stream.getvalue()


def _drawn(inks: Sequence[Ink], box: Box, density: float) -> Any:
    """The pixels, (rows, columns, 4), as matplotlib holds them."""
    from matplotlib.backends.backend_agg import RendererAgg
    from matplotlib.path import Path as Outlined
    from matplotlib.transforms import Affine2D

    left, bottom, right, top = box
    on_paper = Affine2D().translate(-left, -bottom).scale(density / INCH)
    across, up = (max(1, round(side * density / INCH)) for side in (right - left, top - bottom))
    renderer = RendererAgg(across, up, density)
    np.asarray(renderer.buffer_rgba()).fill(255)
    for ink in inks:
        points = np.column_stack([ink.outline.places.real, ink.outline.places.imag])
        path = Outlined(points, ink.outline.codes)
        path.should_simplify = False
        fill = rgb(ink.fill, ink.opacity) if ink.fill else None
        renderer.draw_path(_graphics(renderer, ink.pen), path, on_paper, fill)
    return renderer.buffer_rgba()


def _graphics(renderer: Any, pen: Pen | None) -> Any:
    """What the renderer is told of a line; it counts in points."""
    graphics = renderer.new_gc()
    graphics.set_snap(False)
    graphics.set_linewidth(pen.width / POINT if pen else 0.0)
    if pen:
        graphics.set_foreground(rgb(pen.colour), isRGBA=True)
        graphics.set_capstyle("round")
        graphics.set_joinstyle("round")
        graphics.set_dashes(0, [length / POINT for length in pen.dash] or None)
    return graphics


@cache
def rgb(colour: str, opacity: float = 1.0) -> tuple[float, float, float, float]:
    """A colour of COLOURS as shares of red, green and blue, and how much it covers."""
    red, green, blue = (part / 255 for part in bytes.fromhex(COLOURS[colour]))
    return red, green, blue, opacity
