"""Panels of a graph on their sheet: where a value stands on paper, mm, its ticks, how a number is written by it.

┌ ABOVE ───────────────┐
│ LEFT ┌────────┐ RIGHT │     the panels stand one above another over one axis of x, GAP apart
│      └────────┘       │
└ BELOW ───────────────┘
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

WIDTH = 165.0  # mm
PANEL = 48.0  # height of a panel with its share of the gaps, mm
LEFT, RIGHT, ABOVE, BELOW = 20.0, 4.0, 6.0, 12.0  # margins for the figures and labels, mm
GAP = 0.07  # between panels, in heights of a panel
SPARE = 0.16  # room over the greatest value and under the least, in their difference
ROUND = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0)  # steps of ticks, times a power of ten


@dataclass(frozen=True)
class Panel:
    """A frame on the sheet, mm from its lower left corner, and what its axes go from and to."""

    bottom: float
    tall: float
    x: tuple[float, float]
    y: tuple[float, float]
    left: float = LEFT
    wide: float = WIDTH - LEFT - RIGHT

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
        """(P, 2), mm; nan where the values are."""
        across, up = np.broadcast_arrays(self.across(x), self.up(values))  # type: ignore[arg-type]
        return np.stack([across, up], axis=-1)


def sheet_height(count: int) -> float:
    """Height of a sheet with so many panels, mm."""
    return PANEL * count + ABOVE + BELOW


def panels(x: tuple[float, float], ranges: Sequence[tuple[float, float]]) -> list[Panel]:
    """A panel for each range of values, from the top of the sheet down."""
    count = len(ranges)
    tall = PANEL * count / (count + GAP * (count - 1))
    bottoms = [BELOW + (count - 1 - k) * tall * (1 + GAP) for k in range(count)]
    return [Panel(bottom, tall, x, y) for bottom, y in zip(bottoms, ranges, strict=True)]


def value_range(values: Sequence[float] | np.ndarray) -> tuple[float, float]:
    """What an axis goes from and to: all the values and zero with room to spare; nothing but zeros: -1 to 1."""
    finite = np.asarray(values, float)
    finite = finite[np.isfinite(finite)]
    low, high = float(finite.min(initial=0.0)), float(finite.max(initial=0.0))
    if low == high:
        return -1.0, 1.0
    spare = SPARE * (high - low)
    return low - spare, high + spare


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


def figure(value: float, comma: bool) -> str:
    """A number of at most four significant digits, with a true minus."""
    text = f"{value:.4g}"
    if "e" in text:
        text = f"{value:.0f}" if abs(value) >= 1 else text
    text = ("0" if float(text) == 0 else text).replace("-", "−")
    return text.replace(".", ",") if comma else text
