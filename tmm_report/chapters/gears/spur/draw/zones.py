"""Zones of the line of action with one pair of teeth in mesh and with more."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import pairwise

import numpy as np

from tmm_report.chapters.gears.spur.solve.mesh import Mesh
from tmm_report.figures.drawing import (
    NORMAL,
    THICK,
    THIN,
    Arrow,
    Drawing,
    Item,
    Path,
    Pen,
    Text,
    line,
    polygon,
)
from tmm_report.figures.lettering import Scale, Symbol, width
from tmm_report.quantity.paper import round_scale
from tmm_report.quantity.symbols import Symbol as Quantity

WIDE, TALL, APART = 110.0, 6.0, 4.0  # mm: the active part at most, height of a bar, room between two bars
UNDER = 6.0  # mm: from the bars to the dimensions under them, whose values stand between
BEYOND = 22.0  # mm: how much is seen of the pairs before and after
STEP = 1.6  # mm between the strokes of a hatching
NARROW, CLOSE = 15.0, 4.0  # mm: a zone in which no dimension has room, letters that would meet


def zones(mesh: Mesh, num: Callable[[float], str], words: Callable[[int], str], title: str = "") -> Drawing:
    """Bars for the pair that goes from A to B and for those before and after it, a base pitch apart.

    Where more pairs are in mesh than the fewest the bars are hatched. `words` names a number of pairs, `num` prints mm.
    """
    active = abs(mesh.places["B"] - mesh.places["A"])
    k = 1 / round_scale(active, WIDE)
    pitch, wide = k * float(mesh.pair.p_b), k * active
    x = _marks(mesh.places, wide)
    items: list[Item] = []
    beside = _beside(pitch, wide)
    for row, shift in enumerate(range(-beside, beside + 1)):
        items += _bar(shift * pitch, -row * (TALL + APART), pitch, wide)
    rows = 2 * beside + 1
    low = -(rows - 1) * (TALL + APART)
    for name, at in x.items():  # P bounds no zone: its line would cross out a dimension
        items.append(line(complex(at, low if name == "P" else low - UNDER), complex(at, TALL + 2), THIN))
    items += _letters(x)
    items += _intervals(pitch, low - UNDER, k, wide, num, words)
    return Drawing(tuple(items), title, scales=(Scale(Quantity("l"), 1 / k, "m"),))


def _marks(places: Mapping[str, float], wide: float) -> dict[str, float]:
    """The lettered points of AB, mm from A; below a contact ratio of 1 C and D lie outside, P may."""
    length = places["B"] - places["A"]
    found = {name: wide * (place - places["A"]) / length for name, place in places.items()}
    return {name: at for name, at in found.items() if -1e-6 <= at <= wide + 1e-6}


def _letters(marks: Mapping[str, float]) -> Iterator[Item]:
    """Over the points; of two that are close each stands on its side."""
    for name, at in marks.items():
        near = next((other for other in marks.values() if 0 < abs(other - at) < CLOSE), at)
        yield Text(complex(at, TALL + 4.5), (Symbol(name),), align=1 if at < near else -1 if at > near else 0)


def _beside(pitch: float, wide: float) -> int:
    """How many pairs before (and after) are in mesh at some time with the one from A to B."""
    return max(1, int(np.ceil(wide / pitch)) - 1)


def pairs_at(at: np.ndarray, pitch: float, length: float) -> np.ndarray:
    """Pairs in mesh when one of them is `at` (N,) from A, with the active part `length` long."""
    shifts = np.arange(-np.ceil(length / pitch), np.ceil(length / pitch) + 1) * pitch
    places = np.asarray(at)[:, None] - shifts
    return np.count_nonzero((places >= 0) & (places <= length), axis=1)


def _steps(pitch: float, wide: float) -> list[tuple[float, float, int]]:
    """(start, end, pairs in mesh) of each zone of AB."""
    marks = {0.0, wide}
    for n in range(1, _beside(pitch, wide) + 1):
        marks |= {at for at in (n * pitch, wide - n * pitch) if 0 < at < wide}
    ends = sorted(marks)
    counts = pairs_at(np.array([(a + b) / 2 for a, b in pairwise(ends)]), pitch, wide)
    return [(a, b, int(n)) for (a, b), n in zip(pairwise(ends), counts, strict=True)]


def _bar(start: float, low: float, pitch: float, wide: float) -> Iterator[Item]:
    """A bar cut off where it leaves the picture, hatched in the zones of AB with more pairs."""
    left, right = max(start, -BEYOND), min(start + wide, wide + BEYOND)
    if left >= right:
        return
    steps = _steps(pitch, wide)
    fewest = min(n for _, _, n in steps)
    for a, b, n in steps:
        if n > fewest and max(a, left) < min(b, right):
            yield _hatched(max(a, left), min(b, right), low)
    corners = [complex(left, low), complex(right, low), complex(right, low + TALL), complex(left, low + TALL)]
    if start == 0:
        yield polygon(corners, THICK)
        return
    # the side at which the bar is cut off stays open
    yield Path((tuple(corners if start < 0 else corners[2:] + corners[:2]),), NORMAL)


def _hatched(left: float, right: float, low: float) -> Path:
    """Strokes at 45° over a part of a bar."""
    strokes = []
    for foot in np.arange(left - TALL + STEP / 2, right, STEP):
        a, b = max(foot, left), min(foot + TALL, right)
        if b > a:
            strokes.append((complex(a, low + a - foot), complex(b, low + b - foot)))
    return Path(tuple(strokes), Pen(0.15))


def _intervals(
    pitch: float, low: float, k: float, wide: float, num: Callable[[float], str], words: Callable[[int], str]
) -> Iterator[Item]:
    """Under the bars: length of each zone and the number of pairs in it, where both have room; the base pitch and the
    whole active part."""
    for a, b, n in _steps(pitch, wide):
        if b - a < NARROW:
            continue
        yield from _span(a, b, low, num((b - a) / k * 1e3))
        if width((words(n),), 2.8) < b - a:
            yield Text(complex((a + b) / 2, low - 4.5), (words(n),), size=2.8, align=0)
    yield line(complex(0, low - 18), complex(0, low), THIN)
    yield line(complex(wide, low - 18), complex(wide, low), THIN)
    yield from _span(0, wide, low - 17, num(wide / k * 1e3))
    if pitch < wide:
        yield from _span(0, pitch, low - 10.5, num(pitch / k * 1e3), Symbol("p", "b"))
        yield line(complex(pitch, low - 11.5), complex(pitch, low), THIN)


def _span(a: float, b: float, y: float, value: str, name: Symbol | None = None) -> Iterator[Item]:
    """A dimension between two places, its value over the line."""
    middle = complex((a + b) / 2, y)
    yield Arrow(middle, complex(a, y), THIN, 2.2)
    yield Arrow(middle, complex(b, y), THIN, 2.2)
    yield Text(middle + 2.2j, (name, f" = {value}") if name else (value,), size=2.8, align=0)
