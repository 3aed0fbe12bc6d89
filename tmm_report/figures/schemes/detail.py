"""A detail of a scheme drawn larger beside it, where the crank is too short to be read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Literal

from tmm_report.figures.drawing import THIN, Circle, Drawing, Item, Path, Tag, Text
from tmm_report.figures.placing import SHEET, clear_of
from tmm_report.figures.schemes.view import View

SHORT = 12.0  # a crank shorter than this on paper is drawn larger beside the scheme, mm
LONG = 15.0  # to this length at least
AROUND = 12.0  # what the detail shows beyond the crank, mm
GAP = 6.0  # between the scheme and its detail, mm
NAME = "I"

Place = Literal["alone", "beside", "detail"]  # a scheme without a detail, one beside its detail, and that
Draw = Callable[[View, Place], tuple[Sequence[Item], Sequence[Tag]]]

TIMES = (2, 2.5, 4, 5, 10, 20, 40, 50, 100)  # the standard scales of enlargement


def times(view: View) -> float:
    """How many times larger the detail is; 1: the crank is long enough, there is none."""
    length, _ = view.crank
    return 1.0 if length >= SHORT else next((k for k in TIMES if k * length >= LONG), TIMES[-1])


def ring_reach(view: View) -> float:
    """Radius of the circle on a scheme about what its detail shows, mm."""
    return view.crank[0] + AROUND / times(view)


def with_detail(
    view_at: Callable[[float], View], mu: float, draw: Draw, title: str, detailed: bool = True
) -> Drawing:
    """A scheme at the scale `mu`, m/mm, beside it the detail if there is one. `view_at`: its view at a scale."""
    view = view_at(mu)
    if (k := times(view)) == 1 or not detailed:
        items, tags = draw(view, "alone")
        return Drawing(tuple(items), title).labelled(tags)
    near = view_at(mu / k)
    inner = detail(near, *draw(near, "detail"), k)
    circle, name = ring(view, ring_reach(view))
    items, tags = draw(view, "beside")
    return beside(Drawing((*items, circle), title).labelled([name, *tags]), inner)


def detail(view: View, items: Sequence[Item], tags: Sequence[Tag], k: float) -> Drawing:
    """What lies about the driver's pivot, within a circle, under its name and scale."""
    reach = view.crank[0] + AROUND
    shown = (*clipped(items, view.pivot, reach), Circle(view.pivot, reach, THIN))
    drawing = Drawing(shown).labelled(_within(tags, view.pivot, reach))
    top = drawing.box[3]
    return Drawing(
        (*drawing.items, Text(complex(view.pivot.real, top + 2.5), (f"{NAME} ({k:g}:1)",), align=0))
    )


def ring(view: View, reach: float) -> tuple[Circle, Tag]:
    """The circle about what a detail shows, and its name."""
    sides = [1 + 1j, 1 - 1j, -1 - 1j, -1 + 1j, 1, -1j, -1, 1j]
    places = tuple(view.pivot + reach * side / abs(side) for side in sides)
    return Circle(view.pivot, reach, THIN), Tag((NAME,), places, gap=0.6)


def beside(drawing: Drawing, other: Drawing) -> Drawing:
    """A drawing with another in an empty corner of it; else to the right, or below where the sheet is too narrow."""
    left, bottom, right, top = drawing.box
    wide, tall = other.size
    corners = [(right - wide, top - tall), (left, top - tall), (right - wide, bottom), (left, bottom)]
    clear = clear_of(drawing.items, [(x, y, x + wide, y + tall) for x, y in corners])
    free = [corner for corner, is_clear in zip(corners, clear, strict=True) if is_clear]
    aside = right - left + GAP + wide <= SHEET[0]
    x, y = (right + GAP, (bottom + top - tall) / 2) if aside else (left, bottom - GAP - tall)
    if free and wide < right - left and tall < top - bottom:
        x, y = free[0]
    return replace(
        drawing, items=(*drawing.items, *other.moved(complex(x, y) - complex(*other.box[:2])).items)
    )


def _within(tags: Sequence[Tag], centre: complex, reach: float) -> list[Tag]:
    """The tags with those of their anchors that lie within the circle."""
    inside = [
        replace(tag, anchors=tuple(z for z in tag.anchors if abs(z - centre) < reach - 2.0)) for tag in tags
    ]
    return [tag for tag in inside if tag.anchors]


def clipped(items: Sequence[Item], centre: complex, reach: float) -> list[Item]:
    """What lies within a circle; of an item that leaves it the lines, without its fill."""
    found: list[Item] = []
    for item in items:
        strokes = item.outline()
        if all(abs(z - centre) <= reach for stroke in strokes for z in stroke):
            found.append(item)
        elif item_pen := getattr(item, "pen", None):
            pieces = [
                piece
                for stroke in strokes
                for pair in pairwise(stroke)
                for piece in _cut(*pair, centre, reach)
            ]
            found += [Path(tuple(pieces), item_pen)] if pieces else []
    return found


def _cut(a: complex, b: complex, centre: complex, reach: float) -> list[tuple[complex, complex]]:
    """The part of a segment within a circle."""
    along, start = b - a, a - centre
    size = abs(along) ** 2
    if size == 0:
        return []
    middle = -(along.conjugate() * start).real / size
    square = middle**2 - (abs(start) ** 2 - reach**2) / size
    if square <= 0:
        return []
    low, high = max(0.0, middle - square**0.5), min(1.0, middle + square**0.5)
    return [(a + low * along, a + high * along)] if low < high else []
