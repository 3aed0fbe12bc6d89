"""Close views of an eccentric epicyclic mechanism: two meshes of a satellite, the narrowest place of neighbours."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.draw.common import CENTRES, FINE, MEASURE, Numbers, measured, plain
from tmm_report.chapters.gears.eccentric.solve.mechanism import RING, SUN, Found
from tmm_report.chapters.gears.eccentric.solve.paper import ROUND
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    TEXT,
    THIN,
    Circle,
    Drawing,
    Item,
    Path,
    Pen,
    Tag,
    Text,
    line,
)
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.mechanics.gears.eccentric.teeth import Body

Array = Any

SECOND = Pen(0.35, "blue")
BETWEEN = 4.0  # of close views, mm


def close(found: Found, num: Numbers = str, title: str = "") -> Drawing:
    """Two meshes of a satellite and the narrowest place between neighbours, each in a circle, its direction level."""
    mm = 1e3 * found.close_scale
    made = found.assembled(FINE / mm)
    bodies = {body.name: body for body in (made.sun, made.ring, *made.satellites)}
    items: list[Item] = []
    tags: list[Tag] = []
    for number, (one, other, at, turn) in enumerate(_views(found)):
        place = number * (2 * ROUND + BETWEEN)
        view = _View(at, cmath.rect(1, -turn) * mm, complex(place))
        items += _detail(view, found, bodies[one], bodies[other])
        tags += _names(view, bodies[one], bodies[other])
        caption = _caption(bodies[one], bodies[other], found, num)
        items.append(Text(view.middle - 1j * (ROUND + 4.5), caption, TEXT, 0))
    return Drawing(tuple(items), title).labelled(tags)


def _caption(one: Body, other: Body, found: Found, num: Numbers) -> Parts:
    names = plain(one.name) + "–" + plain(other.name)
    if _meshing(one, other):
        return (names,)
    gap = 1e3 * (abs(other.centre - one.centre) - one.wheel.tip - other.wheel.tip)
    return (names + ": ", Symbol("Δ"), " = " + num(round(gap, 3)))


def _views(found: Found) -> Iterator[tuple[str, str, complex, float]]:
    """Both wheels, the place, m, and the direction from one to the other that is laid level, rad."""
    m, s = found.given.module, found.satellites[0]
    along = cmath.rect(1, s.phi1)
    yield SUN, s.wheel, m / 2 * found.sun * along, s.phi1
    yield s.wheel, RING, complex(found.e) + cmath.rect(m / 2 * found.ring, s.phi3), s.phi3
    if (nearest := found.narrowest) is not None:
        one, other, gap = nearest.one, nearest.other, nearest.gap
        across = other.centre - one.centre
        tip = m * (one.teeth / 2 + found.given.rack.ha)
        yield one.wheel, other.wheel, one.centre + (tip + gap / 2) * across / abs(across), cmath.phase(across)


class _View:
    """A place of the mechanism laid in a circle of paper: z -> (z − at) turn + middle."""

    def __init__(self, at: complex, turn: complex, middle: complex):
        self.at, self.turn, self.middle = at, turn, middle

    def __call__(self, z: Any) -> Any:
        return (z - self.at) * self.turn + self.middle

    def inside(self, outline: Array) -> list[tuple[complex, ...]]:
        """The pieces of a closed outline, m, that lie in the circle."""
        points = self(outline)
        within = np.abs(points - self.middle) < ROUND
        if not within.any() or within.all():
            return [tuple(map(complex, points))] if within.any() else []
        first = int(np.argmin(within))  # begin outside, so that no piece is cut in two
        points, within = np.roll(points, -first), np.roll(within, -first)
        ends = np.flatnonzero(np.diff(within.astype(int)))
        return [tuple(map(complex, points[a + 1 : b + 1])) for a, b in _in_twos([*ends, len(points) - 1])]


def _in_twos(ends: Sequence[Any]) -> Iterator[tuple[int, int]]:
    return zip(ends[::2], ends[1::2], strict=False)


def _detail(view: _View, found: Found, one: Body, other: Body) -> Iterator[Item]:
    yield Circle(view.middle, ROUND, THIN)
    for body, pen in ((one, NORMAL), (other, SECOND)):
        yield from (Path((piece,), pen) for piece in view.inside(body.outline()))
        for radius, thin in _circles(body, found):
            circle = body.centre + radius * np.exp(2j * np.pi * np.arange(20000) / 20000)
            yield from (Path((piece[::8],), thin) for piece in view.inside(circle))
    yield from _line_of_action(view, found) if _meshing(one, other) else _free(view, one, other)


def _circles(body: Body, found: Found) -> Iterator[tuple[float, Pen]]:
    yield found.given.module / 2 * body.wheel.z, AXIS
    yield body.wheel.tip, MEASURE


def _meshing(one: Body, other: Body) -> bool:
    return SUN in (one.name, other.name) or RING in (one.name, other.name)


def _names(view: _View, one: Body, other: Body) -> list[Tag]:
    """The numbers of both wheels, each on its side of the circle where its teeth leave room."""
    tags = []
    for body, out in ((one, math.pi), (other, 0.0)):
        places = [
            view.middle + (ROUND - 5) * cmath.rect(1, out + lean) for lean in (0.0, 0.4, -0.4, 0.6, -0.6)
        ]
        tags.append(Tag((plain(body.name),), tuple(places), 0.3, size=4.5))
    return tags


def _line_of_action(view: _View, found: Found) -> Iterator[Item]:
    """The common normal of the flanks that touch, at the angle α to the common tangent, through the pitch point."""
    alpha = found.given.rack.alpha
    for lean in (math.pi / 2 + alpha, math.pi / 2 - alpha):
        way = 0.97 * ROUND * cmath.rect(1, lean)
        yield line(view.middle - way, view.middle + way, CENTRES)


def _free(view: _View, one: Body, other: Body) -> Iterator[Item]:
    """The free distance between the tip circles as a dimension."""
    along = (other.centre - one.centre) / abs(other.centre - one.centre)
    start, end = view(one.centre + one.wheel.tip * along), view(other.centre - other.wheel.tip * along)
    low = view.middle - 1j * (ROUND - 6)
    for x in (start, end):
        yield line(x, complex(x.real, low.imag - 1), MEASURE)
    ends = complex(start.real, low.imag), complex(end.real, low.imag)
    yield from measured(*ends, (Symbol("Δ"),), within=True)
