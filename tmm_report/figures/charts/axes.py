"""Panels of a graph on their sheet: where a value stands on paper, mm, its scale, its ticks, how it is written by them.

┌─────────────────────────┐
│ name    names of curves │     a row for each row of names; over the top panel the numbers of the positions too
│ left ┌────────┐ RIGHT   │     the panels stand one above another over one axis of x
│      └────────┘         │
└ below ──────────────────┘
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tmm_report.figures.lettering import Parts, width
from tmm_report.quantity.paper import round_scale
from tmm_report.records import dataclass

PAPER = 165.0  # mm: width of a graph that stands in the text of a page
TICK = 1.2  # length of a tick, mm
RIGHT = 4.0  # mm: margin
GAP = 1.2  # between a panel and the names of the next, mm
EVERY = 10.0  # mm between ticks of values
TALLEST, ALONE, LEAST = (
    50.0,
    70.0,
    20.0,
)  # mm: what curves fill of a panel at most; of the only one; in scarce room
EDGE = 2.0  # mm beyond a curve where no value is written
ROOMS = (
    105.0,
    158.0,
    222.0,
    364.0,
)  # mm: height of half a page and of two thirds, with their captions, of a whole page, of A3 standing
ALONG = (1.0, 1.25, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0)  # round scales along an axis, times a power of ten
ROUND = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0)  # steps of ticks, times a power of ten


class Hand(NamedTuple):
    """The letters of a graph, mm: height of figures by the axes, of values at extremes, of the names of curves; that of
    the names of axes; that of a row of names; how wide a text of a height is."""

    figure: float = 2.8
    name: float = 3.2
    row: float = 5.2
    wide: Callable[[Parts, float], float] = width

    @property
    def numbers(self) -> float:
        """The numbers of the positions."""
        return self.figure + 1.8

    @property
    def below(self) -> float:
        """Figures and name of x."""
        return self.figure + self.name + 6.5

    @property
    def spare(self) -> float:
        """Beyond a curve where a value is written."""
        return self.figure + 2.2

    @property
    def regimes(self) -> float:
        """The x of the bounds between regimes, and over them the numbers of these."""
        return 2 * self.figure + 4.9


@dataclass(frozen=True)
class Panel:
    """A frame on the sheet, mm from its lower left corner, and what its axes go from and to."""

    bottom: float
    tall: float
    x: tuple[float, float]
    y: tuple[float, float]
    left: float
    wide: float

    @property
    def top(self) -> float:
        return self.bottom + self.tall

    @property
    def right(self) -> float:
        return self.left + self.wide

    @property
    def x_scale(self) -> float:
        """What 1 mm along the axis of x stands for."""
        return (self.x[1] - self.x[0]) / self.wide

    @property
    def y_scale(self) -> float:
        """What 1 mm along the axis of values stands for."""
        return (self.y[1] - self.y[0]) / self.tall

    def across(self, x: float) -> float:
        return self.left + (x - self.x[0]) / self.x_scale

    def up(self, value: float) -> float:
        return self.bottom + (value - self.y[0]) / self.y_scale

    def places(self, x: np.ndarray, values: np.ndarray) -> np.ndarray:
        """(P,), x + iy in mm; nan where the values are."""
        return self.across(x) + 1j * self.up(values)  # type: ignore[arg-type]


@dataclass(frozen=True)
class Values:
    """What an axis of values holds: the least and the greatest, zero among them, and the room beyond either, mm."""

    low: float
    high: float
    under: float = EDGE
    over: float = EDGE

    def range(self, scale: float) -> tuple[float, float]:
        """What the axis goes from and to, 1 mm of it being `scale`."""
        return self.low - self.under * scale, self.high + self.over * scale

    def scale(self, tallest: float) -> float:
        """The smallest round scale at which they are no taller than `tallest`, mm."""
        return round_scale(self.high - self.low, tallest)

    def filled(self, scale: float) -> float:
        """Height of the curves at a scale, mm."""
        return (self.high - self.low) / scale

    def tall(self, scale: float) -> float:
        """Height of their panel, mm."""
        return self.filled(scale) + self.under + self.over

    def roomy(self, panel: Panel, spare: float) -> Panel:
        """Its panel with so much room at least, mm, where values are written."""
        scale = panel.y_scale
        low, high = panel.y
        low = min(low, self.low - spare * scale) if self.under > EDGE else low
        high = max(high, self.high + spare * scale) if self.over > EDGE else high
        return replace(panel, y=(low, high), tall=(high - low) / scale)


def values_of(numbers: Sequence[float] | np.ndarray, marked: Sequence[float] = ()) -> Values:
    """The range of some numbers and zero, with room where some of them are `marked` by a figure; nothing but zeros:
    -1 to 1."""
    finite = np.asarray(numbers, float)
    finite = finite[np.isfinite(finite)]
    low, high = float(finite.min(initial=0.0)), float(finite.max(initial=0.0))
    if low == high:
        return Values(-1.0, 1.0, 0.0, 0.0)
    near = 0.12 * (high - low)
    under = any(value < low + near for value in marked)
    over = any(value > high - near for value in marked)
    spare = Hand().spare
    return Values(low, high, spare if under else EDGE, spare if over else EDGE)


def scales_of(axes: Sequence[Values], rest: float) -> list[float]:
    """Round scales of panels that stand on one sheet with `rest` mm of names and figures: on the smallest that leaves
    curves `LEAST` at most; the lowest panels are then drawn larger while there is room."""
    coarse = [axis.scale(LEAST) for axis in axes]
    need = sum(map(Values.tall, axes, coarse)) + rest
    return _grown(axes, coarse, next((room for room in ROOMS if need <= room + 1e-6), ROOMS[-1]) - rest)


def _grown(axes: Sequence[Values], scales: list[float], room: float) -> list[float]:
    tallest = ALONE if len(axes) == 1 else TALLEST
    growing = set(range(len(axes)))
    while growing:
        k = min(
            growing, key=lambda k: (round(axes[k].filled(scales[k]), 6), k)
        )  # of equal ones not by rounding
        finer = _finer(scales[k])
        larger = [*scales[:k], finer, *scales[k + 1 :]]
        if axes[k].filled(finer) <= tallest + 1e-9 and sum(map(Values.tall, axes, larger)) <= room + 1e-6:
            scales = larger
        else:
            growing.remove(k)
    return scales


def _finer(scale: float) -> float:
    """The round scale before this."""
    decade = 10.0 ** math.floor(math.log10(scale * (1 + 1e-9)))
    before = [step * decade for step in (0.5, *ROUND) if step * decade < scale * (1 - 1e-9)]
    return float(f"{max(before):.12g}")


def round_axis(extent: float, room: float) -> float:
    """Length of an axis of `extent`, mm, at the smallest round scale that `room` mm hold: 144 for a turn, 2.5° to a
    millimetre, where there are 144."""
    return extent / axis_scale(extent, room)


def axis_scale(extent: float, room: float) -> float:
    """What a millimetre of that axis stands for."""
    least = extent / room * (1 - 1e-9)
    decade = 10.0 ** math.floor(math.log10(least))
    return min(s * d for s in ALONG for d in (decade, 10 * decade) if s * d >= least)


def round_ticks(low: float, high: float, intervals: int = 6) -> list[float]:
    """Multiples of the smallest round step by which no more than `intervals` of them fit between low and high."""
    rough = (high - low) / intervals
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(step for step in ROUND if step * power >= rough * (1 - 1e-9)) * power
    return multiples(low, high, step)


def multiples(low: float, high: float, step: float) -> list[float]:
    """Multiples of a step from `low` to `high`, its ends among them if they are such."""
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    return [k * step for k in range(first, last + 1)]


def value_ticks(panel: Panel) -> list[float]:
    """Round values along the axis of a panel, `EVERY` mm; of one whose scale is not round, about so."""
    step = EVERY * panel.y_scale
    decade = 10.0 ** math.floor(math.log10(step))
    return multiples(*panel.y, min((s * decade for s in ROUND), key=lambda s: abs(s - step)))


def figure(value: float, comma: bool) -> str:
    """A number of at most four significant digits, with a true minus."""
    text = f"{value:.4g}"
    if "e" in text:
        text = (
            f"{value:.0f}"
            if abs(value) >= 1
            else f"{value:.{3 - math.floor(math.log10(abs(value)))}f}".rstrip("0")
        )
    text = ("0" if float(text) == 0 else text).replace("-", "−")
    return text.replace(".", ",") if comma else text


MOST = 24  # numbers of positions that stand in a row without touching


def position_marks(panel: Panel, count: int) -> Iterator[tuple[float, str]]:
    """Place along x, mm, and number of each of `count` positions and of the end of the cycle, "" where there are too
    many to write all."""
    if count:
        every = -(-count // MOST)
        for k in range(count + 1):
            yield panel.left + panel.wide * k / count, "" if k % every else str(k)
