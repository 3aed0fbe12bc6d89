"""What the sketches of ordinary stages share: wheels with their axes, distances, arrows of rotation; mm of paper."""

from __future__ import annotations

import math

from tmm_report.figures.drawing import AXIS, NORMAL, THIN, Arrow, Circle, Item, Pen, Tag, dot, line
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.schemes.marks import turning

PITCH = Pen(0.35, dash=(5.0, 1.0, 0.6, 1.0))  # of a pitch circle
OUT = 5.0  # of a dimension line from what it measures


def wheel(centre: complex, radius: float, pen: Pen = NORMAL) -> list[Item]:
    """A circle with its centre lines."""
    reach = radius + 3
    return [
        Circle(centre, radius, pen), dot(centre),
        line(centre - 1j * reach, centre + 1j * reach, AXIS), line(centre - reach, centre + reach, AXIS),
    ]  # fmt: skip


def turns(centre: complex, radius: float, sense: int) -> list[Item]:
    """An arrow of rotation within a wheel, + counter-clockwise."""
    return turning(centre, max(2.5, 0.55 * radius), math.radians(-100 * sense), math.radians(200 * sense))


def distance(start: complex, end: complex, low: float, letter: Symbol) -> tuple[list[Item], Tag]:
    """A dimension line below at the height `low`, between two points of the line of centres."""
    left, right = complex(start.real, low), complex(end.real, low)
    middle = (left + right) / 2
    items: list[Item] = [
        line(start, left - 1.5j, THIN), line(end, right - 1.5j, THIN),
        Arrow(middle, left, THIN), Arrow(middle, right, THIN),
    ]  # fmt: skip
    return items, Tag((letter,), (middle,), prefer=1j)
