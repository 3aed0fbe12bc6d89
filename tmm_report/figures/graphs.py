"""Graphs with axes over the driver's angle: panels one above another, laid out in mm, written as SVG and PDF.

The layout is made here (`axes`) and matplotlib is handed finished lines and letters (`sheet`): its own axes make some
fifty objects for the ticks of a panel, and were two thirds of the time of a note.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from hashlib import sha256
from itertools import cycle
from typing import NamedTuple

import numpy as np

from tmm_report.figures.axes import (
    WIDTH,
    Panel,
    figure,
    multiples,
    panels,
    round_ticks,
    sheet_height,
    value_range,
)
from tmm_report.figures.lettering import width
from tmm_report.figures.sheet import POINT, Sheet
from tmm_report.quantity.text import ZERO

LABEL = 3.0  # height of figures by the axes and of their names, mm
VALUE = 2.8  # of values at extremes, positions and the legend, mm
OFF, TALL = 5 * POINT, 9 * POINT  # how far a value stands off its extreme, how tall it is with its ground, mm
TICK, SHORT = 1.2, 0.7  # lengths of ticks, mm

Box = tuple[float, float, float, float]  # left, foot, width, height, mm


class Look(NamedTuple):
    """How a curve is told apart without colour too: by dashes (in widths of the line) and by a marker."""

    colour: str
    dash: tuple[float, ...]
    marker: str


LOOKS = (
    Look("#000000", (), "o"),
    Look("#1B4F9C", (6, 2), "s"),
    Look("#B3261E", (6, 2, 1, 2), "^"),
    Look("#1E6B3A", (1.5, 1.5), "D"),
    Look("#7F5A00", (8, 2, 1, 2, 1, 2), "v"),
)


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve: `values` (P,) in the unit of its panel's label; `name` goes into the legend where there is one.

    `extremes`: the points to mark as (x, value); None: the greatest and the least of `values`.
    `scale`: the natural size of the quantity, beside which a curve that is nothing but rounding is seen to be one.
    """

    values: np.ndarray
    name: str = ""
    panel: int = 0
    extremes: Sequence[tuple[float, float]] | None = None
    scale: float = 0.0

    def settled(self) -> Curve:
        """The curve without the noise of computation: what is noise is 0, a constant has no extremes."""
        noise = ZERO * max(self.scale, np.nanmax(np.abs(self.values), initial=0.0))
        values = np.where(np.abs(self.values) <= noise, 0.0, self.values)
        if not np.nanmax(values, initial=-np.inf) - np.nanmin(values, initial=np.inf) > noise:
            return replace(self, values=values, extremes=())
        ends = self.extremes and [(at, value if abs(value) > noise else 0.0) for at, value in self.extremes]
        return replace(self, values=values, extremes=ends)

    def marked(self, x: np.ndarray) -> list[tuple[float, float]]:
        """The points to mark: those given, or the greatest and the least."""
        if self.extremes is not None:
            return list(self.extremes)
        if not np.isfinite(self.values).any():
            return []
        picks = (int(np.nanargmax(self.values)), int(np.nanargmin(self.values)))
        return [(float(x[k]), float(self.values[k])) for k in picks]


@dataclass(frozen=True, eq=False)
class Graph:
    """A graph laid out on its sheet; the same data give the same bytes. Words as in `graph`."""

    curves: Sequence[Curve]
    x: np.ndarray
    xlabel: str
    ylabels: Sequence[str]
    panels: Sequence[Panel]
    step: float
    positions: int
    comma: bool
    join: bool
    title: str

    @property
    def size(self) -> tuple[float, float]:
        """Width and height, mm."""
        return WIDTH, sheet_height(len(self.panels))

    def of(self, number: int) -> list[tuple[Curve, Look]]:
        """The curves of a panel and how each is drawn."""
        curves = [curve for curve in self.curves if curve.panel == number]
        return list(zip(curves, cycle(LOOKS), strict=False))

    def svg(self) -> str:
        """One `svg` element to stand inside a page: its ids are its own, nothing is fetched."""
        return self._drawn().svg(self.salt, self.title)

    def pdf(self) -> bytes:
        return self._drawn().pdf(self.salt)

    @cached_property
    def salt(self) -> str:
        """Ids made with it are the graph's own, and the same for the same data."""
        words = (self.xlabel, *self.ylabels, self.title)
        digest = sha256(np.ascontiguousarray(self.x, float).tobytes() + "\0".join(words).encode())
        for curve in self.curves:
            digest.update(np.ascontiguousarray(curve.values, float).tobytes())
        return digest.hexdigest()[:16]

    def _drawn(self) -> Sheet:
        sheet = Sheet(*self.size)
        for number, panel in enumerate(self.panels):
            _panel(sheet, self, panel, number)
        _x_axis(sheet, self)
        return sheet


def graph(
    curves: Sequence[Curve],
    x: np.ndarray,
    xlabel: str,
    ylabels: Sequence[str],
    *,
    step: float = 30.0,
    positions: int = 0,
    comma: bool = False,
    join: bool = True,
    title: str = "",
) -> Graph:
    """Curves over `x` (P,), degrees, a panel for each of `ylabels`, sharing x.

    `step`: degrees between ticks; `positions`: how many positions the cycle is numbered with over the top, 0: none;
    `comma`: decimal comma; `join`: thin lines join the extremes of all panels; `title` is for who cannot see it.
    """
    curves = [curve.settled() for curve in curves]
    ranges = [
        value_range(np.concatenate([np.zeros(1), *(_heights(c, x) for c in curves if c.panel == number)]))
        for number in range(len(ylabels))
    ]
    laid = panels((float(x[0]), float(x[-1])), ranges)
    join = join and len(ylabels) > 1
    return Graph(curves, x, xlabel, ylabels, laid, step, positions, comma, join, title)


def _heights(curve: Curve, x: np.ndarray) -> np.ndarray:
    """All that is drawn of a curve: its values and the extremes given, which may lie between them."""
    return np.concatenate([curve.values, [value for _, value in curve.marked(x)]])


# --- what stands on it ---


def _panel(sheet: Sheet, graph: Graph, panel: Panel, number: int) -> None:
    _ruled(sheet, graph, panel)
    for curve, look in graph.of(number):
        _curve(sheet, panel.places(graph.x, curve.values), look)
    if graph.join:
        _joined(sheet, graph, panel)
    for curve, look in graph.of(number):
        _extremes(sheet, graph, panel, curve, look)
    middle = panel.bottom + panel.tall / 2
    sheet.letters((4.0, middle), graph.ylabels[number], LABEL, ha="right", va="center", rotation=90)
    if any(curve.name for curve, _ in graph.of(number)):
        _legend(sheet, graph, panel, graph.of(number))


def _ruled(sheet: Sheet, graph: Graph, panel: Panel) -> None:
    """Grid, line of zero, frame, ticks and their figures."""
    xs = [panel.across(x) for x in _x_ticks(graph)]
    ys = {value: panel.up(value) for value in round_ticks(*panel.y)}
    sheet.strokes([*_upright(panel, xs), *_level(panel, ys.values())], "#D0D0D0", 0.4)
    corners = [(panel.left, panel.bottom), (panel.right, panel.bottom)]
    corners += [(panel.right, panel.top), (panel.left, panel.top), (panel.left, panel.bottom)]
    ticks = [np.array([(panel.left - TICK, y), (panel.left, y)]) for y in ys.values()]
    ticks += [np.array([(x, panel.bottom - TICK), (x, panel.bottom)]) for x in xs]
    sheet.strokes([np.array(corners), *_level(panel, [panel.up(0.0)]), *ticks], "black", 0.6)
    for value, y in ys.items():
        place = (panel.left - 2 * TICK, y)
        sheet.letters(place, figure(value, graph.comma), LABEL, ha="right", va="center_baseline")


def _upright(panel: Panel, xs: Sequence[float]) -> list[np.ndarray]:
    return [np.array([(x, panel.bottom), (x, panel.top)]) for x in xs]


def _level(panel: Panel, ys: Iterable[float]) -> list[np.ndarray]:
    return [np.array([(panel.left, y), (panel.right, y)]) for y in ys]


def _x_ticks(graph: Graph) -> list[float]:
    return multiples(float(graph.x[0]), float(graph.x[-1]), graph.step)


def _curve(sheet: Sheet, places: np.ndarray, look: Look) -> None:
    """A line that breaks where a value is nan, with a marker at every twelfth of its way along x."""
    sheet.strokes(_unbroken(places), look.colour, 1.1, look.dash)
    twelfths = np.linspace(places[0, 0], places[-1, 0], 13)
    spots = places[np.unique(np.abs(places[:, 0] - twelfths[:, None]).argmin(axis=1))]
    sheet.markers(spots[np.isfinite(spots[:, 1])], look.marker, look.colour, 3.2)


def _unbroken(places: np.ndarray) -> list[np.ndarray]:
    """The stretches of a curve between its gaps."""
    gaps = np.flatnonzero(~np.isfinite(places[:, 1]))
    stretches = (stretch[np.isfinite(stretch[:, 1])] for stretch in np.split(places, gaps))
    return [stretch for stretch in stretches if len(stretch) > 1]


def _joined(sheet: Sheet, graph: Graph, panel: Panel) -> None:
    """Thin upright lines through all panels at the extremes: the zeros of the derivative below them."""
    at = {round(at, 6) for curve in graph.curves for at, _ in curve.marked(graph.x)}
    sheet.strokes(_upright(panel, [panel.across(x) for x in sorted(at)]), "#606060", 0.5, (4, 3))


def _extremes(sheet: Sheet, graph: Graph, panel: Panel, curve: Curve, look: Look) -> None:
    """Rings at the extremes; the value over a greatest and under a least."""
    points = curve.marked(graph.x)
    if points:
        sheet.markers(panel.places(*np.array(points).T), "o", look.colour, 5.0, hollow=True)
    for text, (left, foot, wide, tall) in _values(graph, panel, curve):
        sheet.block((left, foot), wide, tall)
        place = (left + wide / 2, foot + 0.25 * tall)
        sheet.letters(place, text, VALUE, ha="center", va="baseline", color=look.colour)


def _values(graph: Graph, panel: Panel, curve: Curve) -> list[tuple[str, Box]]:
    """The values at the extremes and where each is written."""
    points = curve.marked(graph.x)
    middle = float(np.nanmean(curve.values)) if points else 0.0
    texts = [figure(value, graph.comma) for _, value in points]
    return [
        (text, _value_box(panel, point, width((text,), VALUE), point[1] >= middle))
        for text, point in zip(texts, points, strict=True)
    ]


def _value_box(panel: Panel, point: tuple[float, float], wide: float, up: bool) -> Box:
    """Over a greatest, under a least; at an edge of the panel, inwards."""
    x, y = panel.across(point[0]), panel.up(point[1])
    inside = panel.left + 1 + wide / 2, panel.right - 1 - wide / 2
    off = _off(panel, point[1], up)
    return (
        min(max(x, inside[0]), inside[1]) - wide / 2,
        y + off - 0.3 if up else y - off - VALUE,
        wide,
        VALUE + 0.3,
    )


def _off(panel: Panel, value: float, up: bool) -> float:
    """How far from its extreme a value is written, mm: beyond the line of zero rather than across it."""
    zero = abs(value) / panel.y_scale
    return zero + 2 * POINT if up == (value < 0) and OFF - 2 * POINT < zero < OFF + TALL else OFF


def _x_axis(sheet: Sheet, graph: Graph) -> None:
    """Figures and the name of x under the lowest panel, numbers of the positions over the top one."""
    low, top = graph.panels[-1], graph.panels[0]
    for value in _x_ticks(graph):
        place = (low.across(value), low.bottom - 2 * TICK)
        sheet.letters(place, figure(value, graph.comma), LABEL, ha="center", va="top")
    middle = low.left + low.wide / 2
    sheet.letters((middle, low.bottom - 2 * TICK - 4.2), graph.xlabel, LABEL, ha="center", va="top")
    places = list(_positions(graph))
    ticks = [np.array([(x, top.top), (x, top.top + SHORT)]) for x, _ in places]
    sheet.strokes(ticks, "black", 0.6)
    for x, name in filter(lambda place: place[1], places):
        sheet.letters((x, top.top + 2 * SHORT + 0.4), name, VALUE, ha="center", va="baseline")


MOST = 24  # numbers of positions that stand in a row without touching


def _positions(graph: Graph) -> Iterator[tuple[float, str]]:
    """Place along x, mm, and number of each position, "" where there are too many to write all; a cycle of full turns
    ends where it began, at 0."""
    if graph.positions:
        start, end = graph.panels[0].x
        every, turns = -(-graph.positions // MOST), max(1, round((end - start) / 360))
        for k, turned in enumerate(multiples(0.0, end - start, 360 * turns / graph.positions)):
            number = k % graph.positions
            yield graph.panels[0].across(start + turned), "" if number % every else str(number)


# --- legend ---

SAMPLE, PAD, ROW = 10.0, 1.2, 4.2  # length of a sample of the line, free space round it, height of a row, mm


def _legend(sheet: Sheet, graph: Graph, panel: Panel, curves: Sequence[tuple[Curve, Look]]) -> None:
    """Names of the curves where the panel is emptiest."""
    wide = SAMPLE + 3 * PAD + max(width((curve.name,), VALUE) for curve, _ in curves)
    tall = ROW * len(curves) + PAD
    left, foot = _freest(panel, wide, tall, _drawn_points(graph, panel, [curve for curve, _ in curves]))
    sheet.block((left, foot), wide, tall, "#C0C0C0")
    for k, (curve, look) in enumerate(curves):
        y = foot + tall - PAD / 2 - ROW * (k + 0.5)
        line = np.array([(left + PAD, y), (left + PAD + SAMPLE, y)])
        sheet.strokes([line], look.colour, 1.1, look.dash)
        sheet.markers(line.mean(axis=0)[None], look.marker, look.colour, 3.2)
        sheet.letters((line[1, 0] + PAD, y), curve.name, VALUE, ha="left", va="center_baseline")


def _drawn_points(graph: Graph, panel: Panel, curves: Sequence[Curve]) -> np.ndarray:
    """(N, 2), mm: points of the curves, no farther apart than a legend is wide, and of the values
    written; of the line of zero."""
    x = np.linspace(graph.x[0], graph.x[-1], 200)
    lines = [panel.places(x, np.interp(x, graph.x, curve.values)) for curve in curves]
    boxes = [box for curve in curves for _, box in _values(graph, panel, curve)]
    lines.append(panel.places(x, np.zeros(len(x))))
    letters = [
        (left + wide * i / 8, foot + tall * k)
        for left, foot, wide, tall in boxes
        for i in range(9)
        for k in (0, 1)
    ]
    return np.concatenate([*lines, np.array(letters).reshape(-1, 2)])


def _freest(panel: Panel, wide: float, tall: float, points: np.ndarray) -> tuple[float, float]:
    """The lower left corner of a box where fewest of the points lie in it, a corner of the panel liked best."""
    half = np.array([wide, tall]) / 2
    lefts = np.linspace(panel.right - PAD - wide, panel.left + PAD, 3)
    feet = np.linspace(panel.top - PAD - tall, panel.bottom + PAD, 5)
    places = sorted((i % 2 + k % 4, i, k) for i in range(3) for k in range(5))
    corners = [(float(lefts[i]), float(feet[k])) for _, i, k in places]
    return min(corners, key=lambda corner: int((np.abs(points - corner - half) < half + 1).all(axis=1).sum()))
