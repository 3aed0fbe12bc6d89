"""A graph on paper: grid, frames, curves, extremes, figures and names, as a drawing in mm.

The names of an axis and of the curves stand over their panel, where no curve comes.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmm_report.figures.charts.axes import (
    RIGHT,
    TICK,
    Hand,
    Panel,
    figure,
    multiples,
    position_marks,
    value_ticks,
)
from tmm_report.figures.charts.peaks import Crowd, placed
from tmm_report.figures.drawing import Circle, Drawing, Item, Path, Pen, Text, dot, line, polygon
from tmm_report.figures.lettering import Parts
from tmm_report.quantity.text import roman

if TYPE_CHECKING:
    from tmm_report.figures.charts.graphs import Curve, Graph

CURVE, FRAME, GRID = 0.39, 0.22, 0.13  # widths of lines, mm
JOINED = Pen(0.16, "grey", (1.4, 1.0))
RING, MARK = 0.85, 0.6  # radii of a ring at an extreme and of a marker, mm
SAMPLE, SPACE = 10.0, 4.0  # length of a sample of a line, space before the next, mm


TWELFTHS = 12  # of its way along x, at which a curve has markers
DISC = 12  # corners of a marker that is drawn round


class Look(NamedTuple):
    """How a curve is told apart without colour too: by its dashes and by its marker, of so many corners at a turn."""

    pen: Pen
    corners: int
    turn: float = 0.0


LOOKS = (
    Look(Pen(CURVE), DISC),
    Look(Pen(CURVE, "blue", (2.4, 0.9)), 4, math.pi / 4),
    Look(Pen(CURVE, "red", (2.4, 0.8, 0.5, 0.8)), 3, math.pi / 2),
    Look(Pen(CURVE, "green", (0.7, 0.6)), 4),
    Look(Pen(CURVE, "grey", (3.2, 0.8, 0.5, 0.8, 0.5, 0.8)), 3, -math.pi / 2),
)


def drawn(graph: Graph) -> Drawing:
    """All of it; zero is the lower left corner of the sheet."""
    items: list[Item] = []
    for number, panel in enumerate(graph.panels):
        items += _panel(graph, panel, number)
    items += _x_axis(graph)
    items += _numbers(graph)
    items += _regimes(graph)
    return Drawing(tuple(items), graph.title)


def _panel(graph: Graph, panel: Panel, number: int) -> Iterator[Item]:
    own = graph.of(number)
    yield from _ruled(graph, panel)
    for curve, look in own:
        yield from _curve(panel.places(graph.x, curve.values), look, graph.positions)
    crowd = Crowd(panel, [panel.places(graph.x, curve.values) for curve, _ in own], graph.hand.figure)
    extremes = list(_extremes(graph, crowd, own))
    if graph.join:
        at = {round(at, 6) for curve in graph.curves for at, _ in curve.marked(graph.x)}
        yield from _joined(crowd, sorted(at))
    yield from _joined(crowd, graph.bounds[1:-1])
    yield from extremes
    yield from _names(graph, panel, number)


def _ruled(graph: Graph, panel: Panel) -> Iterator[Item]:
    """Grid, line of zero, frame, ticks and the figures of the values."""
    xs = [panel.across(x) for x in _x_ticks(graph)]
    ys = {value: panel.up(value) for value in value_ticks(panel)}
    yield Path((*_upright(panel, xs), *_level(panel, ys.values())), Pen(GRID, "pale"))
    ticks = [(complex(panel.left - TICK, y), complex(panel.left, y)) for y in ys.values()]
    ticks += [(complex(x, panel.bottom - TICK), complex(x, panel.bottom)) for x in xs]
    corners = complex(panel.left, panel.bottom), complex(panel.right, panel.top)
    box = (corners[0], complex(panel.right, panel.bottom), corners[1], complex(panel.left, panel.top))
    yield polygon(box, Pen(FRAME))
    yield Path((*_level(panel, [panel.up(0.0)]), *ticks), Pen(FRAME))
    for value, y in ys.items():
        yield Text(complex(panel.left - TICK - 0.6, y), (figure(value, graph.comma),), graph.hand.figure, 1)


def _upright(panel: Panel, xs: Iterable[float]) -> list[tuple[complex, ...]]:
    return [(complex(x, panel.bottom), complex(x, panel.top)) for x in xs]


def _level(panel: Panel, ys: Iterable[float]) -> list[tuple[complex, ...]]:
    return [(complex(panel.left, y), complex(panel.right, y)) for y in ys]


def _x_ticks(graph: Graph) -> list[float]:
    return multiples(float(graph.x[0]), float(graph.x[-1]), graph.step)


def _curve(places: np.ndarray, look: Look, positions: int) -> Iterator[Item]:
    """A line that breaks where a value is nan, with a marker at every twelfth of its way along x. It goes through its
    `positions`, or, where these are not known, through all its points."""
    marked = _at(places, TWELFTHS)
    strokes = _unbroken(places)
    if strokes:
        held = frozenset(marked + _at(places, positions) if positions else places.tolist())
        yield Path(tuple(tuple(stroke.tolist()) for stroke in strokes), look.pen, held=held)
    yield from _markers(marked, look)


def _at(places: np.ndarray, parts: int) -> list[complex]:
    """The points nearest to so many equal parts of the way along x, and to its end."""
    evenly = np.linspace(places[0].real, places[-1].real, parts + 1)
    spots = places[np.unique(np.abs(places.real - evenly[:, None]).argmin(axis=1))]
    return spots[np.isfinite(spots.imag)].tolist()


def _unbroken(places: np.ndarray) -> list[np.ndarray]:
    """The stretches of a curve between its gaps."""
    gaps = np.flatnonzero(~np.isfinite(places.imag))
    stretches = (stretch[np.isfinite(stretch.imag)] for stretch in np.split(places, gaps))
    return [stretch for stretch in stretches if len(stretch) > 1]


def _markers(spots: Sequence[complex], look: Look) -> Iterator[Item]:
    radius = MARK * (1 + 1.4 / look.corners)  # a triangle looks smaller than a disc
    if look.corners == DISC:
        yield from (dot(spot, radius, look.pen.colour) for spot in spots)
    elif spots:
        shape = [cmath.rect(radius, look.turn + math.tau * k / look.corners) for k in range(look.corners)]
        places = np.array(spots)[:, None] + np.array(shape)
        yield Path(tuple(map(tuple, places.tolist())), None, look.pen.colour, True)


def _joined(crowd: Crowd, at: Sequence[float]) -> Iterator[Item]:
    """Thin upright lines through all panels, broken at values: at the extremes, the zeros of the derivative below them,
    and between regimes."""
    panel = crowd.panel
    for x in [panel.across(x) for x in at]:
        foot = panel.bottom
        for _, low, _, high in sorted(crowd.over(x), key=lambda box: box[1]):
            yield line(complex(x, foot), complex(x, max(low, foot)), JOINED)
            foot = max(foot, high)
        yield line(complex(x, foot), complex(x, panel.top), JOINED)


def _extremes(graph: Graph, crowd: Crowd, own: Sequence[tuple[Curve, Look]]) -> Iterator[Item]:
    """Rings at the extremes, and beside each its value where it covers least."""
    panel, size = crowd.panel, graph.hand.figure
    for curve, look in own:
        points = curve.marked(graph.x)
        middle = float(np.nanmean(curve.values)) if points else 0.0
        for at, value in points:
            place = complex(panel.across(at), panel.up(value))
            yield Circle(place, RING, Pen(0.2, look.pen.colour), "white")
            text = (figure(value, graph.comma),)
            left, foot, right, top = placed(crowd, place, graph.hand.wide(text, size), value >= middle)
            yield Text(complex((left + right) / 2, (foot + top) / 2), text, size, 0, look.pen.colour)


# --- names ---


def rows(panel: Panel, label: Parts, own: Sequence[tuple[Curve, Look]], hand: Hand) -> int:
    """How many rows the names of an axis and of its curves take over their panel."""
    return 1 + max((row for row, *_ in _samples(panel, label, own, hand)), default=0)


def _samples(
    panel: Panel, label: Parts, own: Sequence[tuple[Curve, Look]], hand: Hand
) -> list[tuple[int, float, Parts, Look]]:
    """Of each named curve the row, from the lowest up, the place of its sample along x, mm, its name and look."""
    named = [((curve.name,) if isinstance(curve.name, str) else curve.name, look) for curve, look in own]
    row, x, found = 0, panel.left + hand.wide(label, hand.name) + 2 * SPACE, []
    for name, look in named:
        if not any(name):
            continue
        wide = SAMPLE + 1.2 + hand.wide(name, hand.figure)
        if x + wide > panel.right and x > panel.left:
            row, x = row + 1, panel.left
        found.append((row, x, name, look))
        x += wide + SPACE
    return [(row - of, x, name, look) for of, x, name, look in found]


def _names(graph: Graph, panel: Panel, number: int) -> Iterator[Item]:
    """The name of an axis and those of its curves, with a sample of each line."""
    own, hand = graph.of(number), graph.hand
    samples = _samples(panel, graph.ylabels[number], own, hand)
    foot = panel.top + hand.row / 2 + 0.3 + (graph.over if number == 0 else 0.0)
    top = foot + hand.row * max((row for row, *_ in samples), default=0)
    yield Text(complex(panel.left, top), graph.ylabels[number], hand.name)
    for row, x, name, look in samples:
        start = complex(x, foot + hand.row * row)
        yield line(start, start + SAMPLE, look.pen)
        yield from _markers([start + SAMPLE / 2], look)
        yield Text(start + SAMPLE + 1.2, name, hand.figure)


def _x_axis(graph: Graph) -> Iterator[Item]:
    """Figures and the name of x under the lowest panel."""
    low, hand = graph.panels[-1], graph.hand
    foot = low.bottom - TICK - 0.6 - hand.figure / 2
    for value in _x_ticks(graph):
        yield Text(complex(low.across(value), foot), (figure(value, graph.comma),), hand.figure, 0)
    yield Text(complex(low.right, foot - hand.figure / 2 - hand.name / 2 - 1.0), graph.xlabel, hand.name, 1)


def _numbers(graph: Graph) -> Iterator[Item]:
    """Numbers of the positions over the top panel, a tick at each."""
    top, size = graph.panels[0], graph.hand.figure
    marks = list(position_marks(top, graph.positions))
    if marks:
        yield Path(tuple((complex(x, top.top), complex(x, top.top + TICK)) for x, _ in marks), Pen(FRAME))
    for x, name in marks:
        if name:
            yield Text(complex(x, top.top + TICK + 0.5 + size / 2), (name,), size, 0)


def _regimes(graph: Graph) -> Iterator[Item]:
    """The x of the bounds between regimes over the top panel, and over these the number of each."""
    if not len(graph.bounds):
        return
    top, hand = graph.panels[0], graph.hand
    size = hand.figure
    foot = top.top + (hand.numbers if graph.positions else 0.0)
    places = [top.across(x) for x in graph.bounds]
    texts = [(figure(x, graph.comma),) for x in graph.bounds[1:]]
    widths = [hand.wide(text, size) for text in texts]
    within = [*places[1:-1], min(places[-1], top.right + RIGHT - 1.0 - widths[-1] / 2)]  # of the paper
    for x, at, text in zip(places[1:], _apart(within, widths), texts, strict=True):
        yield line(complex(x, foot), complex(at, foot + 1.6), Pen(FRAME))
        yield Text(complex(at, foot + 2.0 + size / 2), text, size, 0)
    names = [(roman(k),) for k in range(1, len(places))]
    middles = [(a + b) / 2 for a, b in pairwise(places)]
    for at, name in zip(_apart(middles, [hand.wide(name, size) for name in names]), names, strict=True):
        yield Text(complex(at, foot + hand.regimes - 1.4 - size / 2), name, size, 0)


def _apart(places: Sequence[float], widths: Sequence[float]) -> list[float]:
    """Middles of texts beside one another, each as near to its place as the next ones let it, mm."""
    found = list(places)
    for k in range(len(found) - 2, -1, -1):  # from the last, which stays, to the left
        found[k] = min(found[k], found[k + 1] - (widths[k] + widths[k + 1]) / 2 - 1.5)
    return found
