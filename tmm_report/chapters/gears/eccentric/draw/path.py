"""The path of a point of the output wheel over a turn of the axes, with the positions of the table."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.gears.eccentric.draw.common import CENTRES
from tmm_report.chapters.gears.eccentric.paths import Traced
from tmm_report.chapters.gears.eccentric.solve.mechanism import CARRIER, RING, SUN, Found
from tmm_report.chapters.gears.eccentric.solve.paper import path_scale
from tmm_report.figures.drawing import (
    AXIS,
    THIN,
    Circle,
    Drawing,
    Item,
    Moves,
    Moving,
    Pen,
    Tag,
    dot,
    line,
    polyline,
)
from tmm_report.figures.lettering import Symbol

PATH = Pen(0.6, "blue")
START = Pen(0.25, "black", (2.0, 1.0))


def path_drawing(found: Found, path: Traced, title: str = "") -> Drawing:
    """From the axis of the wheel that stands still: the path, the circle of the other axis, the pitch circles
    that are no larger than the path."""
    mm = 1e3 * path_scale(path)
    half = found.given.module / 2 * mm
    teeth = {SUN: found.sun, RING: found.ring}
    moving, still = path.point.members
    axis, start = complex(path.arm * mm), complex(path.at(np.array(0.0)) * mm)
    reach = abs(axis) + path.point.radius * mm
    wheels = [(0j, half * teeth[still]), (axis, half * teeth[moving])]
    fixed, carried = (
        [*_circle(centre, radius, reach), *(line(centre - arm, centre + arm, THIN) for arm in (2.0, 2j))]
        for centre, radius in wheels
    )
    carried.append(line(axis, start, START))
    items: list[Item] = [*fixed, *carried, Circle(0j, abs(axis), CENTRES)]
    items.append(polyline(map(complex, path.curve() * mm), PATH))
    places = [complex(z) * mm for z in path.places]
    items += [dot(z, 0.7) for z in places]
    tags = [
        Tag((Symbol("O", still),), (0j,), prefer=-1 - 1j),
        Tag((Symbol("O", moving),), (axis,), prefer=1 + 1j),
        Tag((Symbol(path.name, "0"),), (start,), prefer=_outwards(start)),
    ]
    tags += [Tag((str(k),), (z,), prefer=_outwards(z), size=2.8) for k, z in enumerate(places)][1:]
    motion = next(one for one in found.motions if one.stopped == still)
    part = Moving((*carried, dot(start, 1.1)), axis, moving, about=CARRIER)
    moves = Moves((part,), tuple(carried), speed=motion.speed, once=CARRIER)
    return Drawing(tuple(items), title, moves=moves).labelled(tags)


def _circle(centre: complex, radius: float, reach: float) -> Iterator[Item]:
    """The pitch circle of a wheel, where it is no larger than the path."""
    if abs(centre) + radius <= reach:
        yield Circle(centre, radius, AXIS)


def _outwards(z: complex) -> complex:
    return z / abs(z) if abs(z) > 1e-9 else 1 + 0j
