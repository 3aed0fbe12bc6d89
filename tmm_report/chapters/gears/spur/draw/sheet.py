"""The sheet on which a pair of wheels is drawn: its circles with their radii, and three teeth of either wheel.

All places come from `Mesh` in millimetres of paper, the pitch point at 0.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.solve.mesh import Mesh
from tmm_report.figures.dimensions import spread
from tmm_report.figures.drawing import AXIS, THIN, Arc, Item, Moves, Moving, Pen, Tag, Text, polyline
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.records import dataclass

Array = Any
Num = Callable[[float], str]

TEETH = Pen(0.5)
ACTIVE = (Pen(1.0, "blue"), Pen(1.0, "red"))  # working flanks of wheels 1 and 2
SMALL = 2.8  # height of the lettering of dimensions, mm
FARTHEST = 110.0  # a circle farther than this from the working circle is not drawn, mm
FAR = 75.0  # a centre farther than this from the pitch point is not drawn, mm
LETTER = 4.6  # mm between the lines of a column of labels


@dataclass
class Sheet:
    """What is drawn so far. `names`: numbers of the wheels; `num` prints a length in mm or an angle in degrees; `way`:
    where the teeth in the middle touch, m along the line of action from the pitch point; `drawn`: the first and the
    last tooth, counted from those."""

    mesh: Mesh
    names: tuple[str, str]
    num: Num
    way: float = 0.0
    drawn: tuple[int, int] = (-1, 1)
    items: list[Item] = field(default_factory=list)
    tags: list[Tag] = field(default_factory=list)
    teeth: list[Item] = field(default_factory=list)  # those of the items that are teeth

    @property
    def half_width(self) -> float:
        return self.mesh.half_width

    def outer(self, i: int) -> int:
        """−1 for a ring, whose metal lies beyond its root circle."""
        return -1 if self.mesh.wheels[i].internal else 1

    def up(self, i: int) -> complex:
        """From the centre of a wheel to the pitch point."""
        return -self.mesh.centre(i) / abs(self.mesh.centre(i))

    def at(self, i: int, radius: float, angle: float) -> complex:
        """On a circle of wheel i, `angle` counter-clockwise from the pitch point, rad."""
        return self.mesh.centre(i) + radius * self.up(i) * cmath.exp(1j * angle)

    def angle(self, i: int, z: complex) -> float:
        return cmath.phase((z - self.mesh.centre(i)) / self.up(i))

    def side(self, i: int, radius: float) -> float:
        """Half the angle of a circle that keeps within the width of the sheet, rad."""
        return math.asin(min(0.95, self.half_width / radius))

    def tag(
        self, base: str, sub: str, at: complex, prefer: complex = 0j, value: str = "", colour: str = "black"
    ) -> None:
        parts: Parts = (Symbol(base, sub), f" = {value}") if value else (Symbol(base, sub),)
        self.tags.append(Tag(parts, (at,), prefer=prefer, size=SMALL, gap=0.8, colour=colour))


def circles(sheet: Sheet, i: int) -> None:
    """Tip, working, pitch, base and root circles, lettered in a column: on the left for the wheel below."""
    pair, name = sheet.mesh.pair, sheet.names[i]
    rows = [
        ("a", pair.d_a, THIN),
        ("w", pair.d_w, AXIS),
        ("", pair.d, AXIS),
        ("b", pair.d_b, THIN),
        ("f", pair.d_f, THIN),
    ]
    column = []
    for index, diameters, pen in rows:
        radius = sheet.mesh.radius(diameters, i)
        if index == "" and abs(radius - sheet.mesh.radius(pair.d_w, i)) < 0.2:
            continue  # the working circle is the pitch circle
        if abs(radius - sheet.mesh.radius(pair.d_w, i)) > FARTHEST:
            continue  # the base circle of a very large wheel is off the sheet
        half = sheet.side(i, radius)
        middle = cmath.phase(sheet.up(i))
        sheet.items.append(Arc(sheet.mesh.centre(i), radius, middle - half, middle + half, pen))
        left = -1 if i == sheet.mesh.small else 1
        end = max((sheet.at(i, radius, turn * half) for turn in (-1, 1)), key=lambda z: left * z.real)
        column.append((end, (Symbol("r", index + name), f" = {sheet.num(float(diameters[i]) / 2 * 1e3)}")))
    _column(sheet, column, -1 if i == sheet.mesh.small else 1)


def _column(sheet: Sheet, rows: Sequence[tuple[complex, Parts]], side: int) -> None:
    """Labels beside the ends of circles, spread so far that none covers another, each with its leader."""
    rows = sorted(rows, key=lambda row: row[0].imag)
    heights = spread([end.imag for end, _ in rows], LETTER)
    edge = side * (sheet.half_width + 3.5)
    for (end, parts), y in zip(rows, heights, strict=True):
        sheet.items.append(polyline((end, complex(edge, y)), THIN))
        sheet.items.append(Text(complex(edge + side, y), parts, SMALL, 1 if side < 0 else -1))


# --- teeth ---


def teeth(sheet: Sheet, i: int) -> None:
    """Three teeth of a wheel (of a ring, the teeth round three spaces), their working flanks thick."""
    mesh, wheel = sheet.mesh, sheet.mesh.wheels[i]
    outline, count = mesh.outline(i, sheet.way), len(wheel.outline) // wheel.z
    first, last = sheet.drawn
    drawn = np.take(outline, range(first * count, (last + 1) * count + 1), mode="wrap")
    items: list[Item] = [polyline(map(complex, _seen(drawn, sheet.half_width)), TEETH)]
    for tooth in range(first, last + 1):
        flank = _active(sheet, i, tooth)
        if np.abs(flank.real).max() <= sheet.half_width:
            items.append(polyline(map(complex, flank), ACTIVE[i]))
    sheet.items += items
    sheet.teeth += items


def turning(sheet: Sheet) -> Moves:
    """One tooth of either wheel, which stands for all as the pair turns."""
    mesh, parts = sheet.mesh, []
    for i, wheel in enumerate(mesh.wheels):
        count = len(wheel.outline) // wheel.z
        outline = np.take(mesh.outline(i, sheet.way), range(count + 1), mode="wrap")
        tooth = (
            polyline(map(complex, outline), TEETH),
            polyline(map(complex, _active(sheet, i, 0)), ACTIVE[i]),
        )
        sense = mesh.sense * (1 if i == mesh.small or mesh.pair.internal else -1)
        parts.append(
            Moving(
                tooth, mesh.centre(i), sheet.names[i], sense, pitch=wheel.pitch_angle, half=sheet.half_width
            )
        )
    return Moves(tuple(parts), tuple(sheet.teeth))


def _active(sheet: Sheet, i: int, tooth: int) -> Array:
    return sheet.mesh.flank(i, between(*_active_radii(sheet.mesh, i)), sheet.way, tooth)


def _seen(outline: Array, half_width: float) -> Array:
    """The longest piece of an outline that keeps within the width of the sheet."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], np.abs(outline.real) <= half_width, [0]])))
    longest = int(np.argmax(edges[1::2] - edges[::2]))
    return outline[edges[2 * longest] : edges[2 * longest + 1]]


def between(start: float, end: float) -> Array:
    return np.linspace(start, end, 24)


def _active_radii(mesh: Mesh, i: int) -> tuple[float, float]:
    """Radii between which the flank of a wheel touches the other, m."""
    rho = [abs(mesh.points[end] - mesh.points[f"N{i + 1}"]) / mesh.mm for end in "AB"]
    return tuple(math.hypot(mesh.wheels[i].base, r) for r in rho)  # type: ignore[return-value]
