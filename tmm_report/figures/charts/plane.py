"""Curves of one quantity against another in millimetres of paper: an energy–mass diagram, a hodograph, a chart of
stability. They may close, turn back and cross themselves; a graph over the angle or the time is `graphs`.

    frame = framed([curve, other], scales=(0.005, 20.0))         # units of the axes for a millimetre; left out: fitted
    drawing = plane(frame, [Trace(curve, ("1",)), …], ("J, kg·m²",), ("T, J",), num, spots=[Spot(at, ("a",))])
    line(frame.at(z1), frame.at(z2))                              # anything else is drawn on it by its own places
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.figures.charts.axes import axis_scale, round_ticks
from tmm_report.figures.drawing import (
    NORMAL,
    THIN,
    Drawing,
    Item,
    Path,
    Pen,
    Tag,
    Text,
    dot,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Parts, scales_along, width
from tmm_report.quantity.paper import round_scale
from tmm_report.records import dataclass

Array = Any
Num = Callable[[float], str]

FIELD = (120.0, 100.0)  # mm: largest width and height between the axes
SPARE = 0.06  # room round the curves, in their extent
NARROWEST = 30.0  # mm: of an axis
SMALL = 2.8  # height of the figures, mm
TICK = 1.2  # mm
LOOKS = (
    Pen(0.45),
    Pen(0.4, "blue", (3.0, 1.0)),
    Pen(0.4, "red", (3.0, 0.9, 0.6, 0.9)),
    Pen(0.4, "green", (1.0, 0.8)),
    Pen(0.35, "grey", (5.0, 1.0)),
)


@dataclass(frozen=True)
class Frame:
    """The field between the axes: its lower left and upper right corners, x + iy in the units of the axes, and what
    1 mm stands for along either."""

    low: complex
    high: complex
    x_scale: float
    y_scale: float

    def at(self, z: complex) -> complex:
        """Where a point of the field is drawn, mm."""
        away = z - self.low
        return complex(away.real / self.x_scale, away.imag / self.y_scale)

    def places(self, z: Array) -> list[complex]:
        """Where points (P,) are drawn, mm; what is nan is left out."""
        z = np.asarray(z, dtype=complex)
        return [self.at(complex(one)) for one in z[np.isfinite(z)]]

    @property
    def corner(self) -> complex:
        """The upper right corner, mm."""
        return self.at(self.high)

    def holds(self, z: complex) -> bool:
        """Whether a point lies in the field."""
        return self.low.real <= z.real <= self.high.real and self.low.imag <= z.imag <= self.high.imag


@dataclass(frozen=True, eq=False)
class Trace:
    """A curve (P,), x + iy in the units of the axes; nan breaks it. `pen`: None: by its number; `marks`: numbers of
    points that get a dot; `fill`: a colour of the drawing, of the inside."""

    points: Array
    name: Parts = ()
    pen: Pen | None = None
    closed: bool = False
    marks: Sequence[int] = ()
    fill: str = ""


@dataclass(frozen=True)
class Spot:
    """A point with a text beside it."""

    at: complex
    text: Parts = ()
    colour: str = "black"


def framed(
    curves: Sequence[Array],
    *,
    scales: tuple[float, float] | None = None,
    equal: bool = False,
    zero: bool = True,
    field: tuple[float, float] = FIELD,
) -> Frame:
    """A frame that holds all the curves. `equal`: both axes at one round scale, as vectors need it; `zero`: the origin
    is in it; `scales`: the units that a millimetre stands for, in place of the round ones that fill the field."""
    z = np.concatenate([np.atleast_1d(np.asarray(curve, dtype=complex)) for curve in curves])
    z = np.append(z[np.isfinite(z)], 0j) if zero else z[np.isfinite(z)]
    low, high = _room(z.real.min(), z.real.max()), _room(z.imag.min(), z.imag.max())
    spans = low[1] - low[0], high[1] - high[0]
    x, y = scales or (
        axis_scale(span, room) if span else 0.0 for span, room in zip(spans, field, strict=True)
    )
    if equal:
        x = y = round_scale(max(x, y), 1.0)
    across, up = _wide(low, x), _wide(high, y)
    return Frame(complex(across[0], up[0]), complex(across[1], up[1]), x, y)


def _wide(ends: tuple[float, float], scale: float) -> tuple[float, float]:
    """Both ends of an axis moved apart until it is long enough for figures."""
    more = max(0.0, NARROWEST * scale - (ends[1] - ends[0])) / 2
    return ends[0] - more, ends[1] + more


def _room(low: float, high: float) -> tuple[float, float]:
    """Both ends with room to spare; zero stays an end where the curves do not pass it."""
    spare = SPARE * (high - low) or abs(high) / 2 or 1.0
    return (0.0 if low == 0 else low - spare), (0.0 if high == 0 else high + spare)


def plane(
    frame: Frame,
    traces: Sequence[Trace],
    xlabel: Parts,
    ylabel: Parts,
    num: Num,
    *,
    spots: Sequence[Spot] = (),
    more: Sequence[Item] = (),
    tags: Sequence[Tag] = (),
    title: str = "",
) -> Drawing:
    """The curves on their axes. `num` writes a number by a tick; `more`: other items, mm; `tags`: texts that seek
    their place; names of the traces stand in a legend under the axes."""
    pens = [trace.pen or LOOKS[k % len(LOOKS)] for k, trace in enumerate(traces)]
    items: list[Item] = list(_filled(frame, traces))
    items += _axes(frame, xlabel, ylabel, num)
    for trace, pen in zip(traces, pens, strict=True):
        items += _curve(frame, trace, pen)
    items += [*more, *(dot(frame.at(spot.at), colour=spot.colour) for spot in spots)]
    items += _legend(
        frame, [(trace.name, pen) for trace, pen in zip(traces, pens, strict=True) if trace.name]
    )
    letters = [Tag(spot.text, (frame.at(spot.at),), colour=spot.colour) for spot in spots if spot.text]
    scales = scales_along([(xlabel, frame.x_scale), (ylabel, frame.y_scale)])
    return Drawing(tuple(items), title, scales=scales).labelled([*letters, *tags])


def _filled(frame: Frame, traces: Sequence[Trace]) -> Iterator[Path]:
    for trace in traces:
        if trace.fill:
            yield polygon(frame.places(trace.points), None, trace.fill, 0.6)


def _curve(frame: Frame, trace: Trace, pen: Pen) -> Iterator[Item]:
    points = np.asarray(trace.points, dtype=complex)
    points = np.append(points, points[:1]) if trace.closed else points
    gaps = np.flatnonzero(~np.isfinite(points))
    for piece in np.split(points, gaps):
        places = frame.places(piece)
        if len(places) > 1:
            yield polyline(places, pen)
    yield from (dot(frame.at(complex(points[k])), 0.5, pen.colour) for k in trace.marks)


def _axes(frame: Frame, xlabel: Parts, ylabel: Parts, num: Num) -> Iterator[Item]:
    """The frame of the field with ticks and figures, the axes through zero where they are seen."""
    corner, low, high = frame.corner, frame.low, frame.high
    xs = {x: (x - low.real) / frame.x_scale for x in _ticks(low.real, high.real, corner.real)}
    ys = {y: (y - low.imag) / frame.y_scale for y in _ticks(low.imag, high.imag, corner.imag)}
    named = _apart(xs, num)
    yield polygon((0, corner.real, corner, 1j * corner.imag), NORMAL)
    pale = Pen(0.13, "pale")
    for value, x in xs.items():
        yield line(complex(x, 0), complex(x, corner.imag), THIN if value == 0 else pale)
        yield line(complex(x, 0), complex(x, -TICK), THIN)
        if value in named:
            yield Text(complex(x, -TICK - 2.4), (num(value),), SMALL, 0)
    for value, y in ys.items():
        yield line(complex(0, y), complex(corner.real, y), THIN if value == 0 else pale)
        yield line(complex(0, y), complex(-TICK, y), THIN)
        yield Text(complex(-TICK - 0.8, y), (num(value),), SMALL, 1)
    yield Text(complex(corner.real / 2, -TICK - 7.0), xlabel, SMALL, 0)
    yield Text(complex(0, corner.imag + 3.2), ylabel, SMALL, -1)


def _apart(places: Mapping[float, float], num: Num) -> set[float]:
    """Of ticks and their places, mm, those whose figures stand in a row without touching: all, every second, …"""
    step = min(np.diff(list(places.values())), default=1.0)
    widest = max((width((num(value),), SMALL) for value in places), default=0.0)
    return set(list(places)[:: max(1, math.ceil((widest + 1.0) / step))])


def _ticks(low: float, high: float, long: float) -> list[float]:
    """Round numbers along an axis, some 15 mm apart at least."""
    return [
        0.0 if abs(x) < 1e-12 * (high - low) else x for x in round_ticks(low, high, max(3, int(long / 15)))
    ]


def _legend(frame: Frame, named: Sequence[tuple[Parts, Pen]]) -> Iterator[Item]:
    """A sample of each line with its name, in rows under the axes."""
    x, y, right = 0.0, -TICK - 13.0, max(frame.corner.real, 60.0)
    for name, pen in named:
        wide = 12.0 + width(name, SMALL) + 4.0
        if x > 0 and x + wide > right:
            x, y = 0.0, y - 5.0
        yield line(complex(x, y), complex(x + 10, y), pen)
        yield Text(complex(x + 12, y), name, SMALL)
        x += wide
