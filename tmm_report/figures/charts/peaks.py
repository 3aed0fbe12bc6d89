"""Where the value at an extreme is written: over a greatest, under a least, beside it where a curve, another value or
the line of zero is in the way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import field

import numpy as np

from tmm_report.figures.charts.axes import Panel
from tmm_report.records import dataclass

Box = tuple[float, float, float, float]  # left, foot, right, top, mm
GROUND = 0.5  # mm: of a value, over and under it together
OFF = 1.2  # mm: between an extreme and its value
FINE = 0.4  # mm along x between the points by which a curve is known
CURVES, ZERO, OTHERS, OUTSIDE = 4.0, 4.0, 50.0, 200.0  # what it costs to cover them


@dataclass(eq=False)
class Crowd:
    """What stands in a panel: its curves, (P,) complex mm each, the values written so far, how high these are, mm."""

    panel: Panel
    curves: Sequence[np.ndarray]
    figure: float
    written: list[Box] = field(default_factory=list)
    _x: np.ndarray = field(init=False)
    _lines: list[np.ndarray] = field(init=False)

    def __post_init__(self) -> None:
        count = max(2, round(self.panel.wide / FINE) + 1)
        self._x = np.linspace(self.panel.left, self.panel.right, count)
        self._lines = [np.interp(self._x, curve.real, curve.imag) for curve in self.curves if len(curve)]

    def over(self, x: float) -> list[Box]:
        """The values written across an upright line, mm."""
        return [box for box in self.written if box[0] < x < box[2]]

    def cost(self, box: Box) -> float:
        """How much a value in a box covers."""
        left, foot, right, top = box
        first, last = np.searchsorted(self._x, (left - 0.3, right + 0.3))
        near = slice(max(0, int(first) - 1), int(last) + 1)
        found = sum(CURVES for line in self._lines if _crosses(line[near], foot - 0.4, top + 0.4))
        found += ZERO * (foot < self.panel.up(0.0) < top)
        found += OTHERS * sum(_overlap(box, other) for other in self.written)
        return found + OUTSIDE * (foot < self.panel.bottom + 0.2 or top > self.panel.top - 0.2)


def placed(crowd: Crowd, at: complex, wide: float, up: bool) -> Box:
    """The box of a value `wide` mm wide beside a point: of several the one that covers least, the first liked best."""
    least, best = math.inf, (0.0, 0.0, 0.0, 0.0)
    size = complex(wide, crowd.figure + GROUND)
    for k, box in enumerate(_boxes(crowd.panel, at, size, 1 if up else -1)):
        if (cost := crowd.cost(box) + 0.1 * k) < least:
            least, best = cost, box
        if least <= 0.1 * (k + 1):  # those that follow are liked less
            break
    crowd.written.append(best)
    return best


def _boxes(panel: Panel, at: complex, size: complex, side: int) -> Iterator[Box]:
    """Over or under the point, to its sides, farther away, on the other side, closer; none goes out at the
    panel's sides."""
    half, near = size.real / 2, OFF + size.imag / 2
    beside = half + 1.6
    for up in (near, near + 2.2, -near, near + 4.4, -near - 2.2, -near - 4.4, near - 0.45):
        for along in (0.0, beside, -beside):
            yield _box(panel, at + complex(along, side * up), size)
        if up == near:
            yield _box(panel, at + beside, size)
            yield _box(panel, at - beside, size)


def _box(panel: Panel, middle: complex, size: complex) -> Box:
    wide, tall = size.real / 2, size.imag / 2
    x = min(max(middle.real, panel.left + 0.6 + wide), panel.right - 0.6 - wide)
    return x - wide, middle.imag - tall, x + wide, middle.imag + tall


def _crosses(line: np.ndarray, foot: float, top: float) -> bool:
    """Whether a curve comes between two heights; from one of its points to the next it is straight."""
    low, high = np.minimum(line[:-1], line[1:]), np.maximum(line[:-1], line[1:])
    return bool(np.any((low <= top) & (high >= foot)))


def _overlap(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
