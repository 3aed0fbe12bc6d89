"""The graph of specific sliding under the line of action, at the length scale of the drawing of the mesh."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.draw.sheet import SMALL, Num
from tmm_report.chapters.gears.spur.solve.mesh import Mesh
from tmm_report.figures.charts.axes import round_ticks
from tmm_report.figures.dimensions import HEAD, head, spread
from tmm_report.figures.drawing import (
    DASHED,
    NORMAL,
    THIN,
    Drawing,
    Item,
    Pen,
    Tag,
    Text,
    dot,
    line,
    polyline,
)
from tmm_report.figures.lettering import Symbol, joined

Array = Any

CURVES = (Pen(0.6, "blue"), Pen(0.6, "red"))  # of wheels 1 and 2, as their flanks on the drawing of the mesh
BESIDE = 14.0  # mm of N1N2 that are seen beside the active part, where its ends are farther
LETTER = 4.0  # mm between the names of neighbouring points
AXIS = 14.0  # mm from the field to the axis of ordinates
BEYOND = 1.12  # how far the ordinates go beyond those of the active part


def sliding_drawing(mesh: Mesh, names: tuple[str, str], per_mm: float, num: Num, title: str = "") -> Drawing:
    """λ1 and λ2 over N1N2, the driving wheel's N on the left; `per_mm`: what 1 mm of an ordinate stands for."""
    field = _Field(mesh, per_mm)
    items = [*_axes(field, num), *_points(field)]
    tags: list[Tag] = []
    for i in (0, 1):
        items += _curve(field, i)
        tags += _values(field, i, names[i], num)
    return Drawing(tuple(items), title).labelled(tags)


class _Field:
    """Abscissae are mm of paper from the pitch point along N1N2, away from N1 of the driving wheel."""

    def __init__(self, mesh: Mesh, per_mm: float):
        self.mesh, self.per_mm = mesh, per_mm
        self.sign = 1 if mesh.places["B"] > mesh.places["A"] else -1
        ends = {"N1": -mesh.places["P"], "N2": mesh.pair.line - mesh.places["P"]}
        if mesh.pair.internal:
            ends["N2"] = -mesh.places["P"] + (1 if mesh.pair.signs[0] < 0 else -1) * float(mesh.pair.line)
        self.ends = {name: mesh.length(float(way)) for name, way in ends.items()}
        self.points = {name: mesh.length(mesh.place(name)) for name in mesh.places}
        low, high = sorted((self.points["A"], self.points["B"]))
        inner = list(self.ends.values())
        self.low = max(low - BESIDE, max((at for at in inner if at < low), default=-math.inf))
        self.high = min(high + BESIDE, min((at for at in inner if at > high), default=math.inf))
        self.active = low, high

    def sliding(self, i: int, at: Array) -> Array:
        """At places of the paper, mm from the pitch point."""
        rho = np.asarray(at) / self.mesh.mm + self.mesh.places["P"]
        found = self.mesh.pair.sliding(rho)
        return (found.first, found.second)[i]

    def y(self, value: Array) -> Array:
        return np.asarray(value) / self.per_mm

    @property
    def room(self) -> tuple[float, float]:
        """Lowest and highest ordinates of the active part, mm."""
        values = [self.y(self.sliding(i, np.array(self.active))) for i in (0, 1)]
        return float(np.min(values)), float(np.max(values))


def _curve(field: _Field, i: int) -> Iterator[Item]:
    """Whole over the active part, dashed beyond it as far as the field goes."""
    low, high = field.active
    foot, top = (BEYOND * y for y in field.room)
    for start, end, pen in (
        (field.low, low, DASHED), (low, high, CURVES[i]), (high, field.high, DASHED),
    ):  # fmt: skip
        x = np.linspace(start, end, 61)
        y = field.y(field.sliding(i, x))
        inside = np.isfinite(y) & (y >= foot - 1e-9) & (y <= top + 1e-9)
        if np.count_nonzero(inside) > 1:
            dashed = pen is DASHED
            yield polyline(
                (complex(a, b) for a, b in zip(x[inside], y[inside], strict=True)),
                Pen(DASHED.width, CURVES[i].colour, DASHED.dash) if dashed else pen,
            )


def _axes(field: _Field, num: Num) -> Iterator[Item]:
    """N1N2 with its ends or the arrows that point to them, the axis of ordinates with round figures."""
    foot, top = field.room
    yield line(complex(field.low - 4, 0), complex(field.high + 4, 0), NORMAL)
    left = field.low - AXIS
    yield line(complex(left, foot - 3), complex(left, top + 6), NORMAL)
    yield head(complex(left, top + 6), -1j * HEAD)
    yield Text(complex(left - 2, top + 6), (Symbol("λ"),), align=1)
    for tick in round_ticks(foot * field.per_mm, top * field.per_mm):
        y = float(tick) / field.per_mm
        if foot - 2 <= y <= top + 2:
            yield line(complex(left - 1.2, y), complex(left, y), THIN)
            yield Text(complex(left - 2, y), (num(float(tick)),), SMALL, 1)


def _points(field: _Field) -> Iterator[Item]:
    """A, C, P, D, B, N1 and N2 under the graph, with lines up from those of the active part."""
    foot, top = field.room
    low = foot - 6
    seen = {name: at for name, at in field.ends.items() if field.low - 1e-6 <= at <= field.high + 1e-6}
    places = sorted((field.points | seen).items(), key=lambda place: place[1])
    letters_at = spread([at for _, at in places], LETTER)  # C may all but fall on P
    for (name, at), letter_at in zip(places, letters_at, strict=True):
        yield line(complex(at, low), complex(at, top + 2), THIN)
        yield Text(complex(letter_at, low - 2.5), (Symbol(name[0], name[1:]),), SMALL, 0)
        yield dot(complex(at, 0), 0.6)
    for away in (-1, 1):
        beyond = [name for name, at in field.ends.items() if name not in seen and away * at > 0]
        if beyond:
            edge = field.low - 4 if away < 0 else field.high + 4
            yield head(complex(edge, 0), -away * HEAD)
            letters = joined([Symbol(name[0], name[1:]) for name in beyond])
            yield Text(complex(edge, 3.0), letters, SMALL, 0)


def _values(field: _Field, i: int, name: str, num: Num) -> Iterator[Tag]:
    """The values at both ends of the active part, and the name of the curve."""
    for at in field.active:
        value = float(field.sliding(i, at))
        away = complex(math.copysign(1, at), math.copysign(0.5, value))
        label = (Symbol("λ", name), f" = {num(value)}")
        yield Tag(label, (complex(at, float(field.y(value))),), 1.0, away, SMALL, CURVES[i].colour)
