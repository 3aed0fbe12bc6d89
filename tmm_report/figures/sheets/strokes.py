"""Letters of GOST 2.304 as strokes: narrow ones as of type A, with lines of a tenth of their height.

The glyphs are those of NewStroke (see templates/fonts), narrowed; a letter that it lacks is a box.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache, cached_property, lru_cache
from itertools import groupby
from typing import Literal, NamedTuple

from tmm_report.figures.lettering import Part, Parts
from tmm_report.figures.primitives import Box, Path, Pen
from tmm_report.records import dataclass
from tmm_report.resources import data_root

SMALLEST = 3.5  # mm: height of capitals on a sheet, indices among them
SIZES = (3.5, 5.0, 7.0, 10.0)
NARROW = 0.72  # of the glyphs' own width: what is left is that of type A, some 0.6 of the height with the gap
LINE = 0.1  # of a letter, in its heights
# how far indices stand below and above, those of one symbol more so, and a vector's bar, in heights of the base
DROP, RAISE, APART, BAR = 0.45, 0.6, 0.15, 1.2
UNIT = 21.0  # of the glyphs' grid: the height of a capital

Stroke = tuple[complex, ...]


class Glyph(NamedTuple):
    """Strokes of a letter one high, how far the next stands, how far it reaches below and above its baseline."""

    strokes: tuple[Stroke, ...]
    advance: float
    low: float = 0.0
    high: float = 1.0


class Run(NamedTuple):
    """A piece of a text: where its baseline begins, its height, and whether a bar stands over it."""

    text: str
    at: complex
    tall: float
    bar: bool = False

    @property
    def wide(self) -> float:
        return run_width(self.text, self.tall)

    @property
    def reach(self) -> tuple[float, float]:
        """Of its lowest and of its highest place."""
        glyphs = [glyph(char) for char in self.text]
        low, high = min(one.low for one in glyphs), max(one.high for one in glyphs)
        return self.at.imag + self.tall * low, self.at.imag + self.tall * (
            max(high, BAR) if self.bar else high
        )


@cache
def _glyphs() -> dict[str, str]:
    lines = (data_root() / "templates" / "fonts" / "strokes.txt").read_text("utf-8").split("\n")
    return {line[0]: line[1:] for line in lines if line}


@lru_cache(maxsize=4096)
def glyph(char: str) -> Glyph:
    code = _glyphs().get(char)
    if code is None:
        return Glyph(((0.1 + 0j, 0.7 + 0j, 0.7 + 1j, 0.1 + 1j, 0.1 + 0j),), 0.8 * NARROW)
    start, end = (ord(mark) - ord("R") for mark in code[:2])
    strokes = tuple(one for one in (_stroke(one, start) for one in code[2:].split(" R")) if one)
    heights = [z.imag for stroke in strokes for z in stroke] or [0.0]
    return Glyph(strokes, NARROW * (end - start) / UNIT, min(heights), max(heights))


def _stroke(code: str, start: int) -> Stroke:
    """Pairs of letters, counted from R: to the right, and down from what is 9 under the line of capitals."""
    pairs = zip(code[::2], code[1::2], strict=False)
    return tuple(complex(NARROW * (ord(x) - 82 - start), 9 - (ord(y) - 82)) / UNIT for x, y in pairs)


def run_width(text: str, tall: float) -> float:
    return tall * sum(glyph(char).advance for char in text)


def plain(text: str) -> str:
    """A text on one line: what is no sign at all is a space."""
    return "".join(char if char.isprintable() else " " for char in text).replace("№", "Nº")


@dataclass(frozen=True)
class Letters:
    """A text on a sheet: its middle in height, its left (-1), middle (0) or right end (1) by `align`; `tall`: of its
    capitals, mm; `squeeze`: by how much narrower it is than its letters are usually; `turned`: it stands on its head,
    turned about `at`, and the runs are where they would be upright."""

    at: complex
    parts: Parts
    tall: float = SMALLEST
    align: Literal[-1, 0, 1] = -1
    squeeze: float = 1.0
    turned: bool = False

    def place(self, upright: complex) -> complex:
        """Where a place of the upright text is on the sheet."""
        return 2 * self.at - upright if self.turned else upright

    @cached_property
    def wide(self) -> float:
        return self.squeeze * _laid(self.parts, self.tall)[1]

    @cached_property
    def runs(self) -> tuple[Run, ...]:
        """On the sheet, upright."""
        start = self.at - 0.5j * self.tall - self.wide * (1 + self.align) / 2
        return tuple(
            one._replace(at=start + complex(self.squeeze * one.at.real, one.at.imag))
            for one in _laid(self.parts, self.tall)[0]
        )

    @cached_property
    def box(self) -> Box:
        left = self.at.real - self.wide * (1 + self.align) / 2
        reach = [one.reach for one in self.runs] or [(self.at.imag, self.at.imag)]
        low, high = min(low for low, _ in reach), max(high for _, high in reach)
        first, last = self.place(complex(left, low)), self.place(complex(left + self.wide, high))
        return (
            (last.real, last.imag, first.real, first.imag)
            if self.turned
            else (left, low, left + self.wide, high)
        )

    @cached_property
    def path(self) -> Path:
        """As strokes."""
        strokes = (tuple(map(self.place, stroke)) for stroke in self._strokes())
        return Path(tuple(strokes), Pen(LINE * self.tall))

    def _strokes(self) -> Iterator[Stroke]:
        for run in self.runs:
            x = 0.0
            for char in run.text:
                drawn = glyph(char)
                for stroke in drawn.strokes:
                    yield tuple(
                        run.at + run.tall * complex(self.squeeze * (x + z.real), z.imag) for z in stroke
                    )
                x += drawn.advance
            yield from self.bars(run)

    def bars(self, run: Run) -> Iterator[Stroke]:
        """The line over a run that is a vector."""
        if run.bar:
            over = run.at + 1j * BAR * run.tall
            yield over, over + self.squeeze * run.wide

    def moved(self, by: complex) -> Letters:
        return replace(self, at=self.at + by)


@lru_cache(maxsize=4096)
def _laid(parts: Parts, tall: float) -> tuple[tuple[Run, ...], float]:
    """The runs of a text from zero on, and how wide they are."""
    runs, x = list[Run](), 0.0
    for words, some in groupby(parts, key=lambda part: isinstance(part, str)):
        for part in ["".join(map(str, some))] if words else some:  # words beside one another are one run
            found, x = _part(part, x, tall)
            runs += found
    return tuple(one for one in runs if one.text.strip()), x


def _part(part: Part, x: float, tall: float) -> tuple[list[Run], float]:
    if isinstance(part, str):
        text = plain(part)
        return [Run(text, complex(x), tall)], x + run_width(text, tall)
    base, sub, sup = plain(part.base), plain(part.sub), plain(part.sup)
    small = index_of(tall)
    end = x + run_width(base, tall)
    runs = [Run(base, complex(x), tall, part.bar)]
    more = APART if sub and sup else 0.0
    runs += [Run(sub, complex(end, -(DROP + more) * tall), small)] if sub else []
    runs += [Run(sup, complex(end, (RAISE + more) * tall), small)] if sup else []
    return runs, end + max(run_width(sub, small), run_width(sup, small))


def index_of(tall: float) -> float:
    """Capitals of an index: the next smaller size, never under the smallest."""
    return max([size for size in SIZES if size < tall], default=SMALLEST)
