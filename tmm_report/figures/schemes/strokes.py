"""Working strokes on a scheme: arcs round the driver's circle, with words."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

from tmm_report.figures.drawing import Item, Pen, Tag, line
from tmm_report.figures.lettering import Parts
from tmm_report.figures.schemes import marks
from tmm_report.figures.schemes.view import View
from tmm_report.records import dataclass

BAND = Pen(0.4, "red")
OUTSIDE = 6.5  # of the driver's circle, mm: the numbers of its positions stand between
CLEAR = 2.5  # of the ring about a detail, mm
NEXT = 4.0  # from one stroke to the next, mm
TICK = 1.2  # half length of the line at which a stroke begins, mm


@dataclass(frozen=True)
class Stroke:
    """From the angle turned `first` to `last`, rad from position 0 in the sense of the rotation."""

    first: float
    last: float
    words: Parts


def stroke_bands(view: View, strokes: Sequence[Stroke], outside: float = OUTSIDE) -> list[Item]:
    """An arc a stroke, its arrowhead at the end; outside one another, the first `outside` the driver's circle."""
    items: list[Item] = []
    for k, stroke in enumerate(strokes):
        radius, start, sweep = _arc(view, outside + k * NEXT, stroke)
        foot = view.pivot + cmath.rect(radius, start)
        tick = cmath.rect(TICK, start)
        items += [
            line(foot - tick, foot + tick, BAND),
            *marks.turning(view.pivot, radius, start, sweep, BAND),
        ]
    return items


def stroke_tags(view: View, strokes: Sequence[Stroke], outside: float = OUTSIDE) -> list[Tag]:
    """The words outside of each arc."""
    return [_tag(view, outside + k * NEXT, stroke) for k, stroke in enumerate(strokes)]


def _tag(view: View, outside: float, stroke: Stroke) -> Tag:
    radius, start, sweep = _arc(view, outside, stroke)
    units = [cmath.rect(1.0, start + share * sweep) for share in (0.5, 0.35, 0.65, 0.2, 0.8)]
    return Tag(
        stroke.words, tuple(view.pivot + radius * u for u in units), prefer=units[0], colour="red", gap=0.8
    )


def _arc(view: View, outside: float, stroke: Stroke) -> tuple[float, float, float]:
    """Radius, mm, start and signed sweep, rad."""
    length, sense = view.crank
    sweep = sense * min(stroke.last - stroke.first, 2 * cmath.pi - 1e-3)
    return length + outside, view.start + sense * stroke.first, sweep
