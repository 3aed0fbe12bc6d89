"""Blocking contour: the plane of shifts in millimetres of paper, its lines lettered, the feasible region shaded."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.gears.spur.solve.contour import Contour
from tmm_report.figures.charts.axes import axis_scale
from tmm_report.figures.drawing import (
    NORMAL,
    THICK,
    THIN,
    Arrow,
    Circle,
    Drawing,
    Item,
    Pen,
    Tag,
    Text,
    dot,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Parts, Scale, Symbol, width
from tmm_report.mechanics.gears.limits.blocking_contour import Line, Window
from tmm_report.quantity.symbols import Symbol as Quantity
from tmm_report.records import dataclass

Array = Any
Num = Callable[[float], str]

FIELD = (140.0, 150.0)  # mm: largest width and height of the plane
SLIVER = 4.0  # mm: a smaller piece of the region has no room for a point and is not drawn
STEPS = (0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)
TICKS = 12  # at most along an axis
SHORT = 0.04  # of the plane's width: a shorter piece of a line is not drawn
SMALL = 2.8  # height of the lettering, mm

PENS = {
    "undercut": Pen(0.45),
    "pointing": Pen(0.35, "blue"),
    "contact": Pen(0.35, "red"),
    "space": Pen(0.35, "grey"),
    "tips": Pen(0.35, "grey"),
    "trimming": Pen(0.35, "grey"),
    "cutter fouling": Pen(0.35, "grey"),
    "root sliding": Pen(0.25),
    "interference": Pen(0.35, "green"),
    "fouling": Pen(0.35, "grey"),
    "sliding": Pen(0.3, "black", (3.0, 1.0)),
    "distance": Pen(0.25, "black", (5.0, 1.0, 0.6, 1.0)),
}
DASHES = ((), (2.4, 0.9), (0.9, 0.7))  # of the bound, and of the other levels of one quality


@dataclass(frozen=True)
class Plane:
    """x1 + i x2 on paper: the lower left corner of the window at 0."""

    window: Window

    @property
    def scale(self) -> float:
        """Millimetres of paper for a unit of shift, a round one."""
        span = self.window[1] - self.window[0]
        extents = ((span.real, FIELD[0]), (span.imag, FIELD[1]))
        return min(1 / axis_scale(extent, room) for extent, room in extents)

    def at(self, x: Array) -> Array:
        return (x - self.window[0]) * self.scale

    @property
    def corner(self) -> complex:
        return complex(self.at(self.window[1]))


def contour(found: Contour, names: tuple[str, str], num: Num, title: str = "") -> Drawing:
    """The contour with its lines lettered where they have room; `num` prints a level or a tick."""
    plane = Plane(found.window)
    items: list[Item] = [
        polygon(map(complex, piece), None, "pale", 0.7) for piece in pieces_of(found, plane) if _closed(piece)
    ]
    items += _axes(plane, names, num)
    tags = []
    for drawn in found.lines:
        pieces = [plane.at(piece) for piece in drawn.pieces]
        long = [piece for piece in pieces if _length(piece) > SHORT * plane.corner.real]
        items += [polyline(map(complex, piece), _pen(drawn, found)) for piece in long]
        if long:
            tags.append(_tag(drawn, max(long, key=_length), plane.corner, names, num))
    items += [polyline(map(complex, piece), THICK) for piece in pieces_of(found, plane)]
    marks, letters = _points(found, plane)
    scales = (Scale(Quantity("x"), 1 / plane.scale, ""),)
    return Drawing((*items, *marks), title, scales=scales).labelled([*letters, *tags])


def pieces_of(found: Contour, plane: Plane) -> list[Array]:
    """The boundary of the feasible region on paper, without slivers at the edge of the window; mm."""
    pieces = [plane.at(piece) for piece in found.region]
    return [piece for piece in pieces if max(np.ptp(piece.real), np.ptp(piece.imag)) > SLIVER]


def _pen(drawn: Line, found: Contour) -> Pen:
    """A line of the bound is whole, the other levels of its quality are dashed."""
    pen = PENS[drawn.kind]
    bounds = {(limit.kind, limit.wheel): limit.bound for limit in found.blocking.limits}
    bound = bounds.get((drawn.kind, drawn.wheel), drawn.level)
    if drawn.level == bound:
        return pen
    return Pen(pen.width, pen.colour, DASHES[1 if drawn.level > 0 and drawn.level != 1 else 2])


def _closed(piece: Array) -> bool:
    return bool(abs(piece[0] - piece[-1]) < 1e-9)


def _length(piece: Array) -> float:
    return float(np.abs(np.diff(piece)).sum())


def _axes(plane: Plane, names: tuple[str, str], num: Num) -> Iterator[Item]:
    """The frame with ticks and figures, the axes through zero where they are seen."""
    corner, low, high = plane.corner, *plane.window
    right, top = corner.real, corner.imag  # the letters stand clear of a figure at the very end of their axis
    yield polygon((0, corner.real, corner, 1j * corner.imag), NORMAL)
    for value in _ticks(low.real, high.real):
        x = (value - low.real) * plane.scale
        yield line(complex(x, 0), complex(x, 1.2), THIN)
        yield Text(complex(x, -2.6), (num(value),), SMALL, 0)
        right = max(right, x + width((num(value),), SMALL) / 2)
        if value == 0:
            yield line(complex(x, 0), complex(x, corner.imag), THIN)
    for value in _ticks(low.imag, high.imag):
        y = (value - low.imag) * plane.scale
        yield line(complex(0, y), complex(1.2, y), THIN)
        yield Text(complex(-1.2, y), (num(value),), SMALL, 1)
        top = max(top, y + SMALL / 2)
        if value == 0:
            yield line(complex(0, y), complex(corner.real, y), THIN)
    yield Text(complex(right + 1.5, -2.6), (Symbol("x", names[0]),))
    yield Text(complex(-1.2, top + 3), (Symbol("x", names[1]),), align=1)


def _ticks(low: float, high: float) -> list[float]:
    step = next((s for s in STEPS if (high - low) / s <= TICKS), STEPS[-1])
    first = math.ceil(low / step - 1e-9)
    return [round(k * step, 10) for k in range(first, math.floor(high / step + 1e-9) + 1)]


def _tag(drawn: Line, piece: Array, corner: complex, names: tuple[str, str], num: Num) -> Tag:
    """A label that seeks its place along the line, away from the frame where it can."""
    wide, tall = width(_label(drawn, names, num), SMALL) + 3, 6.0
    within = (piece.real > wide) & (piece.real < corner.real - wide)
    within &= (piece.imag > tall) & (piece.imag < corner.imag - tall)
    inwards = 0j if within.any() else complex(corner / 2 - piece.mean())
    piece = piece[within] if within.any() else piece
    shares = (0.5, 0.3, 0.7, 0.15, 0.85, 0.4, 0.6, 0.05, 0.95)
    anchors = tuple(complex(piece[int(share * (len(piece) - 1))]) for share in shares)
    prefer = inwards and 3 * inwards / abs(inwards)  # a line in a corner of the frame is lettered inside it
    return Tag(_label(drawn, names, num), anchors, 0.6, prefer, SMALL, PENS[drawn.kind].colour)


def _label(drawn: Line, names: tuple[str, str], num: Num) -> Parts:
    name = names[drawn.wheel - 1] if drawn.wheel else ""
    if drawn.kind == "undercut":
        return (Symbol("x", f"min{name}"),)
    if drawn.kind == "pointing":
        return (
            Symbol("s", f"a{name}"),
            " = 0" if drawn.level == 0 else f" = {num(drawn.level)}",
            *_module(drawn.level),
        )
    if drawn.kind in ("space", "tips", "trimming", "cutter fouling", "root sliding"):
        return _limit(drawn.kind, name, drawn.level, num)
    if drawn.kind == "contact":
        return (Symbol("ε", "α"), f" = {num(drawn.level)}")
    if drawn.kind == "interference":
        return (Symbol("ρ", f"p{name}"), " = ", Symbol("ρ", f"l{name}"))
    if drawn.kind == "fouling":
        return (Symbol("Δφ"), " = 0")
    if drawn.kind == "sliding":
        return (Symbol("λ", f"p{names[0]}"), " = ", Symbol("λ", f"p{names[1]}"))
    return (Symbol("a", "w"), " = const")


def _limit(kind: str, name: str, level: float, num: Num) -> Parts:
    """A limit of a ring, or of the specific sliding, whose level is 1/(1 + |λ|)."""
    if kind == "root sliding":
        return ("|", Symbol("λ", f"p{name}"), f"| = {num(1 / level - 1)}")
    own = {"space": ("e", "f"), "tips": ("d", "a"), "trimming": ("Δ", "ρ"), "cutter fouling": ("Δ", "φ0")}[
        kind
    ]
    rest: Parts = (" = ", Symbol("d", f"b{name}")) if kind == "tips" else (" = 0",)
    return (Symbol(own[0], own[1] + name), *rest)


def _module(level: float) -> Parts:
    return (Symbol("m"),) if level else ()


def _points(found: Contour, plane: Plane) -> tuple[Sequence[Item], Sequence[Tag]]:
    """The chosen point K; where that is not feasible, the nearest feasible L, and M at the same centre distance."""
    marks: list[Item] = []
    tags = []
    at = complex(plane.at(found.chosen))
    if not found.feasible:
        for name, point in (("L", found.nearest), ("M", found.same_distance)):
            if point is None:
                continue
            end = complex(plane.at(point))
            if abs(end - at) > 4:
                marks.append(Arrow(at, end, THIN, 2.2))
            marks.append(Circle(end, 0.8, THIN, "white"))
            tags.append(Tag((Symbol(name),), (end,), prefer=1 + 0j))
    marks.append(dot(at, 0.9, "red"))
    return marks, [Tag((Symbol("K"),), (at,), prefer=-1 + 0j, colour="red"), *tags]
