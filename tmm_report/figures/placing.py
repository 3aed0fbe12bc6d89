"""Labels that seek their place: each where it covers least of the lines and of the labels before it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from tmm_report.figures.lettering import Parts, width
from tmm_report.figures.primitives import NORMAL, TEXT, Box, Circle, Item, Path, Text, heights

CLEAR = 0.2  # free space sought round lettering, mm

Segment = tuple[float, float, float, float, float]  # x, y of the start, x, y of the end, weight

_SIDES = tuple(cmath.rect(1, math.pi * k / 4) for k in (1, 3, 7, 5, 0, 4, 2, 6))  # corners first
_RINGS = (1.0, 2.2)  # how many gaps away from the anchor


@dataclass(frozen=True)
class Tag:
    """A text that seeks its place beside one of its `anchors`, best on the side `prefer` (unit or 0)."""

    parts: Parts
    anchors: tuple[complex, ...]
    gap: float = 1.2  # clear distance from the anchor, mm
    prefer: complex = 0j
    size: float = TEXT
    colour: str = "black"


def placed(tags: Sequence[Tag], items: Sequence[Item]) -> list[Text]:
    segments = [segment for item in items for segment in _segments(item)]
    texts = [item for item in items if isinstance(item, Text)]
    taken = [text.box for text in texts]
    found = []
    for tag in tags:
        text = _best(tag, segments, taken)
        taken.append(text.box)
        found.append(text)
    return found


def _segments(item: Item) -> list[Segment]:
    """Lines that lettering should keep off: a thick one more than a thin one, the inside of a white block too."""
    if isinstance(item, Text):
        return []
    strokes: list[tuple[complex, ...]] = item.outline()
    weight = item.pen.width / NORMAL.width if item.pen else 1.0
    if isinstance(item, Circle) and item.radius < 2:
        reach = item.radius * (1 + 1j)
        strokes = [(item.centre - reach, item.centre + reach)]
    if isinstance(item, Path) and item.fill == "white":
        strokes += [pair for corners in item.strokes for pair in zip(corners, corners[2:], strict=False)]
    return [(a.real, a.imag, b.real, b.imag, weight) for stroke in strokes for a, b in pairwise(stroke)]


def _best(tag: Tag, segments: Sequence[Segment], taken: Sequence[Box]) -> Text:
    """The candidate that covers least; they come in the order of liking, so a clear one ends the search."""
    low, high = heights(tag.parts)
    half = complex(width(tag.parts, tag.size) / 2, tag.size * (low + high) / 2)
    around = _around(tag, half)
    near = _within(around, segments)
    rivals = [box for box in taken if _shared(_grown(around, 2 * CLEAR), box)]
    wide, tall = half.real + CLEAR, half.imag + CLEAR
    best_cost, best = math.inf, (0j, 0j)
    for dislike, centre, off in _candidates(tag, half):
        if dislike >= best_cost:
            break
        box = (centre.real - wide, centre.imag - tall, centre.real + wide, centre.imag + tall)
        cost = dislike + _covered(box, near) + 4 * sum([_shared(box, other) for other in rivals])
        if cost < best_cost:
            best_cost, best = cost, (centre, off)
    return _text_at(tag, *best, (high - low) / 2)


def _around(tag: Tag, half: complex) -> Box:
    """The box that holds all the candidates."""
    xs, ys = [a.real for a in tag.anchors], [a.imag for a in tag.anchors]
    wide, tall = 2 * half.real + _RINGS[-1] * tag.gap, 2 * half.imag + _RINGS[-1] * tag.gap
    return min(xs) - wide, min(ys) - tall, max(xs) + wide, max(ys) + tall


def _grown(box: Box, by: float) -> Box:
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by


def _within(box: Box, segments: Sequence[Segment]) -> list[Segment]:
    x0, y0, x1, y1 = box
    return [
        s
        for s in segments
        if (s[0] > x0 or s[2] > x0)
        and (s[0] < x1 or s[2] < x1)
        and (s[1] > y0 or s[3] > y0)
        and (s[1] < y1 or s[3] < y1)
    ]


def _candidates(tag: Tag, half: complex) -> list[tuple[float, complex, complex]]:
    """(dislike, centre of the box, from the nearest point of the box to its centre), the best liked first."""
    found = []
    for later, anchor in enumerate(tag.anchors):
        for rank, side in enumerate(_SIDES):
            off = complex(_sign(side.real) * half.real, _sign(side.imag) * half.imag)
            wrong = 0.5 * abs(side - tag.prefer) if tag.prefer else 0.0
            for ring in _RINGS:
                dislike = 0.05 * later + 0.01 * rank + wrong + 0.4 * (ring - 1)
                found.append((dislike, anchor + ring * tag.gap * side + off, off))
    return sorted(found, key=lambda candidate: candidate[0])


def _sign(value: float) -> float:
    return 0.0 if abs(value) < 1e-6 else math.copysign(1.0, value)


def _text_at(tag: Tag, centre: complex, off: complex, lift: float) -> Text:
    """A Text with the box around `centre`, aligned to its anchor's side: a narrower font keeps the gap."""
    align: Literal[-1, 0, 1] = -1 if off.real > 0 else 1 if off.real < 0 else 0
    at = complex(centre.real + abs(off.real) * align, centre.imag - tag.size * (lift - 0.35))
    return Text(at, tag.parts, tag.size, align, tag.colour)


def _covered(box: Box, segments: Sequence[Segment]) -> float:
    """Weighted length of the segments inside the box, mm, and a little for each of them."""
    total = 0.0
    for ax, ay, bx, by, weight in _within(box, segments):
        low, high = 0.0, 1.0
        for start, along, least, most in ((ax, bx - ax, box[0], box[2]), (ay, by - ay, box[1], box[3])):
            if abs(along) < 1e-9:
                if not least < start < most:
                    high = -1.0
                continue
            t1, t2 = (least - start) / along, (most - start) / along
            low, high = max(low, min(t1, t2)), min(high, max(t1, t2))
        if high > low:
            total += weight * (0.3 + (high - low) * math.hypot(bx - ax, by - ay))
    return total


def _shared(box: Box, other: Box) -> float:
    """Area two boxes share, mm²."""
    wide = min(box[2], other[2]) - max(box[0], other[0])
    tall = min(box[3], other[3]) - max(box[1], other[1])
    return wide * tall if wide > 0 and tall > 0 else 0.0
