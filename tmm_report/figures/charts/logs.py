"""A chart with logarithmic axes in millimetres of paper: series of points, named where they end, and what none beats.

drawing = loglog([Series(x + 1j * y, ("Newton",), (0,)), …], ("t, µs",), ("error",), level=1e-6)
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.figures.drawing import (
    NORMAL,
    THIN,
    Drawing,
    Item,
    Path,
    Pen,
    Tag,
    Text,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.records import dataclass

Array = Any

WIDE, TALL = 132.0, 92.0  # mm: of the field between the axes
SMALL = 2.8  # height of the figures, mm
TICK = 1.2  # mm
ROW = 5.0  # mm between figures by the upright axis, at least
FEW = 2.5  # powers of ten along the axis of x, up to which 2 and 5 times them have figures, too
MARK = 1.25  # radius of a marker, mm
ROOM = 0.09  # beyond the values, in their extent: names of series stand there
GRID, STAIRS, LEVEL = Pen(0.13, "pale"), Pen(1.3, "pale"), Pen(0.35, "red", (4.0, 1.2))
LOOKS = (
    (Pen(0.32), 12, 0.0),
    (Pen(0.32, "blue", (2.4, 0.9)), 4, math.pi / 4),
    (Pen(0.32, "red", (2.4, 0.8, 0.5, 0.8)), 3, math.pi / 2),
    (Pen(0.32, "green", (0.7, 0.6)), 4, 0.0),
    (Pen(0.32, "grey", (3.2, 0.8, 0.5, 0.8, 0.5, 0.8)), 3, -math.pi / 2),
    (Pen(0.32, "blue"), 5, math.pi / 2),
    (Pen(0.32, "green", (3.0, 1.0)), 6, 0.0),
)


@dataclass(frozen=True, eq=False)
class Series:
    """Points (P,), x + iy, both above zero; nan is left out. `front`: the numbers of those that none beats."""

    points: Array | Sequence[complex]
    name: Parts = ()
    front: Sequence[int] = ()


@dataclass(frozen=True)
class Decades:
    """An axis from one power of ten to another, mm long."""

    low: float
    high: float
    long: float

    def at(self, value: float) -> float:
        """Where a value stands, mm."""
        return (math.log10(value) - self.low) * self.long / (self.high - self.low)

    def ticks(self, apart: float) -> list[int]:
        """Every power of ten, or every second, …: no nearer than `apart`, mm."""
        step = max(1, math.ceil(apart * (self.high - self.low) / self.long))
        first = math.ceil(self.low / step - 1e-9) * step
        return list(range(first, math.floor(self.high + 1e-9) + 1, step))


def decades(values: Array, long: float, spare: float = 0.04) -> Decades:
    """An axis, mm long, that holds all the values, which are above zero, and some room to spare, in their extent."""
    known = np.asarray(values, float)
    known = known[np.isfinite(known) & (known > 0)]
    low, high = (float(np.log10(end)) for end in (known.min(), known.max())) if known.size else (0.0, 1.0)
    room = max(spare * (high - low), 0.1)
    return Decades(low - room, max(high, low + 0.5) + room, long)


def beyond(values: Sequence[float], long: float) -> Decades:
    """An axis of stated figures, with a tenth beyond either end."""
    return decades(np.array([0.9 * min(values), 1.1 * max(values)]), long)


def loglog(
    series: Sequence[Series],
    xlabel: Parts,
    ylabel: Parts,
    *,
    level: float | None = None,
    named: Parts = (),
    stairs: bool = True,
    xticks: Sequence[float] = (),
    tall: float = TALL,
    title: str = "",
) -> Drawing:
    """The chart. `level`: a value across the field, `named` beside its right end; `stairs` join what none beats;
    `xticks`: figures along the axis of x, in place of the powers of ten; `tall`: height of the field, mm."""
    points = np.concatenate([np.atleast_1d(one.points) for one in series]) if series else np.array([1 + 1j])
    heights = np.append(points.imag, [] if level is None else [level])
    x = beyond(xticks, WIDE) if len(xticks) else decades(points.real, WIDE)
    y = decades(heights, tall, ROOM)
    items: list[Item] = [*(_stairs(series, x, y) if stairs else ()), *_field(x, y, xlabel, ylabel, xticks)]
    tags: list[Tag] = []
    best: list[Item] = []  # over all others
    if level is not None:
        items.append(line(1j * y.at(level), complex(WIDE, y.at(level)), LEVEL))
        tags.append(Tag(named, (complex(WIDE - 2, y.at(level)),), prefer=1j, size=SMALL, colour="red"))
    for number, one in enumerate(series):
        pen, corners, turn = LOOKS[number % len(LOOKS)]
        places = _places(one, x, y)
        if len(places) > 1:
            items.append(polyline([at for _, at in places], pen))
        items += [_marker(at, corners, turn, pen.colour, False) for k, at in places if k not in one.front]
        best += [_marker(at, corners, turn, pen.colour, True) for k, at in places if k in one.front]
        if places and one.name:
            anchors = tuple(at for _, at in reversed(places))
            tags.append(Tag(one.name, anchors, gap=1.8, size=SMALL, colour=pen.colour))
    return Drawing((*items, *best), title).labelled(tags)


def _places(one: Series, x: Decades, y: Decades) -> list[tuple[int, complex]]:
    """Numbers of the points that there are, and where they stand, mm."""
    points = np.atleast_1d(np.asarray(one.points, dtype=complex))
    return [
        (k, complex(x.at(z.real), y.at(z.imag)))
        for k, z in enumerate(points)
        if cmath.isfinite(z) and z.real > 0 and z.imag > 0
    ]


def _marker(at: complex, corners: int, turn: float, colour: str, filled: bool) -> Path:
    """Filled where none beats it."""
    places = [at + cmath.rect(MARK, turn + 2 * math.pi * k / corners) for k in range(corners)]
    return polygon(places, Pen(0.3, colour), colour if filled else "white")


def _stairs(series: Sequence[Series], x: Decades, y: Decades) -> Iterator[Item]:
    """Over what none beats: to the right of each step everything is both slower and no more accurate."""
    best = sorted(
        (at for one in series for number, at in _places(one, x, y) if number in one.front),
        key=lambda at: at.real,
    )
    if len(best) > 1:
        corners = [complex(b.real, a.imag) for a, b in pairwise(best)]
        yield polyline([z for pair in zip(best, [*corners, best[-1]], strict=True) for z in pair], STAIRS)


def _field(x: Decades, y: Decades, xlabel: Parts, ylabel: Parts, xticks: Sequence[float]) -> Iterator[Item]:
    """Frame, grid of the powers of ten, their figures, what the axes are."""
    for value, text in _figures(x, xticks):
        at = x.at(value)
        yield line(complex(at, 0), complex(at, y.long), GRID)
        yield line(complex(at, 0), complex(at, -TICK), THIN)
        yield Text(complex(at, -TICK - 2.4), text, SMALL, 0)
    for power in y.ticks(ROW):
        at = y.at(10.0**power)
        yield line(1j * at, complex(WIDE, at), GRID)
        yield line(1j * at, complex(-TICK, at), THIN)
        yield Text(complex(-TICK - 0.8, at), (_ten(power),), SMALL, 1)
    yield polygon((0, WIDE, complex(WIDE, y.long), 1j * y.long), NORMAL)
    yield Text(complex(WIDE / 2, -TICK - 7.0), xlabel, SMALL, 0)
    yield Text(complex(0, y.long + 3.2), ylabel, SMALL, -1)


def _figures(x: Decades, stated: Sequence[float]) -> Iterator[tuple[float, Parts]]:
    """Values along the axis of x with their figures: those stated, else powers of ten, with 2 and 5 times them where
    there is room."""
    if len(stated):
        yield from ((value, (f"{value:g}",)) for value in stated)
        return
    powers = range(math.floor(x.low), math.floor(x.high) + 1)
    if x.high - x.low > FEW:
        yield from ((10.0**power, (_ten(power),)) for power in x.ticks(12.0))
        return
    for power in powers:
        for digit in (1, 2, 5):
            value = digit * 10.0**power
            if x.low <= math.log10(value) <= x.high:
                yield (
                    value,
                    (
                        f"{value:g}" if 0 <= power < 5 else f"{digit}·",
                        *(() if 0 <= power < 5 else (_ten(power),)),
                    ),
                )


def _ten(power: int) -> Symbol:
    """10⁻⁶; 1 and 10 as such."""
    if power in (0, 1):
        return Symbol(str(10**power), italic=False)
    return Symbol("10", sup=f"{power}".replace("-", "\N{MINUS SIGN}"), italic=False)
