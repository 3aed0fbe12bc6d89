"""Drawings of the wear: how the slider is loaded in its guide, and the worn circumference of a pivot."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.wear.guide import GuideFound
from tmm_report.chapters.machine.wear.pivot import Member, PivotFound
from tmm_report.figures.dimensions import span
from tmm_report.figures.drawing import (
    AXIS,
    DASHED,
    NORMAL,
    THICK,
    THIN,
    Arrow,
    Circle,
    Drawing,
    Item,
    Pen,
    Text,
    hatching,
    line,
    polygon,
)
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.quantity.paper import round_scale

LONG, TALL = 130.0, 20.0  # mm: the guide, and the slider across it
FORCE = 15.0  # length of the arrow of the central reaction, mm


def loading(found: GuideFound) -> Drawing:
    """The slider in its guide where the couple is greatest: central reaction, and the couple with its triangular
    law."""
    at = int(np.argmax(found.couple))
    scale = LONG / found.length
    left, wide = float(found.travel[at]) * scale, found.given.length * scale
    middle = left + wide / 2
    items: list[Item] = [
        *_guide(),
        *_slider(left, wide),
        *_pressed(found, at, middle, wide),
        *_sizes(left, wide),
    ]
    return Drawing(
        (*items, line(complex(middle, -TALL), complex(middle, TALL), AXIS), *_words(left, wide, middle))
    )


def _guide() -> Iterator[Item]:
    for side in (-1, 1):
        start, end = complex(0, side * TALL / 2), complex(LONG, side * TALL / 2)
        yield hatching(start, end, 1j * side)
        yield line(start, end)


def _slider(left: float, wide: float) -> Iterator[Item]:
    low, high = -TALL / 2, TALL / 2
    corners = (complex(left, low), complex(left + wide, low), complex(left + wide, high), complex(left, high))
    yield polygon(corners, THICK, "white")


def _pressed(found: GuideFound, at: int, middle: float, wide: float) -> Iterator[Item]:
    """Arrows end on the face that they press."""
    force, moment = float(found.force[at]), float(found.moment[at])
    if force:
        side = -1 if force > 0 else 1
        tip = complex(middle, side * TALL / 2)
        yield Arrow(tip + FORCE * 1j * side, tip, Pen(0.6, "blue"))
        yield _text((Symbol("R"),), tip + 3 + (FORCE - 2) * 1j * side)
    if moment:
        for half in (1, -1):
            side = -1 if (moment > 0) == (half > 0) else 1
            yield from _triangle(middle, half * wide / 2, side)
            tip = complex(middle + half * wide / 3, side * TALL / 2)
            yield Arrow(tip + FORCE * 1j * side, tip, Pen(0.6, "red"))
            yield _text((Symbol("F", "M"),), tip + 4 + (FORCE - 2) * 1j * side)


def _triangle(middle: float, half: float, side: int) -> Iterator[Item]:
    """The pressure of a half: nothing in the middle, most at the end."""
    face = side * TALL / 2
    yield polygon(
        (complex(middle, face), complex(middle + half, face), complex(middle + half, face + 8 * side)),
        Pen(0.25, "red"),
        "pale",
        0.5,
    )


def _sizes(left: float, wide: float) -> Iterator[Item]:
    """L over all, S to the slider, l_s along it."""
    far, near = -TALL / 2 - 30, -TALL / 2 - 23
    for x in (0.0, LONG):
        yield line(complex(x, -TALL / 2), complex(x, far - 1), THIN)
    for x in (left, left + wide):
        yield line(complex(x, -TALL / 2), complex(x, near - 1), THIN)
    yield from span(complex(0, far), complex(LONG, far))
    yield from span(complex(left, near), complex(left + wide, near))
    if left > 4:
        yield from span(complex(0, near), complex(left, near))


def _words(left: float, wide: float, middle: float) -> Iterator[Item]:
    yield _text((Symbol("L"),), complex(LONG / 2, -TALL / 2 - 27.5))
    yield _text((Symbol("l", "s"),), complex(middle + 5, -TALL / 2 - 20.5))
    if left > 4:
        yield _text((Symbol("S"),), complex(left / 2, -TALL / 2 - 20.5))


def _text(parts: Parts, at: complex) -> Item:
    return Text(at, parts, align=0)


# --- a pivot

RADIUS, MOST, APART = 24.0, 9.0, 84.0  # mm: a circle, its greatest wear as drawn, the middles of the circles


def worn(found: PivotFound) -> Drawing:
    """Journal and bushing side by side, each in the axes of its link; the depths drawn to one scale."""
    scale = 1 / drawn_scale(found)
    journal, bushing = found.members
    items = (
        *_member(found, journal, 0.0, -scale, "1"),
        *_member(found, bushing, APART, scale, "2"),
    )
    return Drawing(items)


def drawn_scale(found: PivotFound) -> float:
    """Metres of wear to a millimetre of paper, round."""
    return round_scale(found.worst.greatest, MOST)


def _member(found: PivotFound, of: Member, x: float, scale: float, number: str) -> Iterator[Item]:
    """The journal wears inwards, the bushing outwards."""
    middle = complex(x, 0)
    outline = [
        middle + cmath.rect(RADIUS + scale * float(u), float(a))
        for u, a in zip(of.depth, found.centres, strict=True)
    ]
    if scale > 0:
        yield polygon(outline, Pen(0.35, "red"), "pale")
        yield Circle(middle, RADIUS, NORMAL, "white")
    else:
        yield Circle(middle, RADIUS, NORMAL, "pale")
        yield polygon(outline, Pen(0.35, "red"), "white")
    yield line(middle - RADIUS * 0.3, middle + RADIUS + MOST + 4, AXIS)
    yield line(middle - 0.3j * RADIUS, middle + 0.3j * RADIUS, AXIS)
    yield _text((Symbol("x", of.link),), middle + RADIUS + MOST + 6)
    if of.greatest:
        angle = float(found.centres[of.worst])
        yield line(middle, middle + cmath.rect(RADIUS - 1, angle), DASHED)
    yield _text((Symbol("u", number),), middle + cmath.rect(RADIUS * 0.45, math.pi * 0.75))
