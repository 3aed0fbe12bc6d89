"""The diagram of displacements over their derivatives with the tangents at the permitted pressure angles: where the
axis of the cam may stand, below all of them; both axes to one scale."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import tan

import numpy as np

from tmm_report.chapters.cams.cam.draw.profile import finest
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.chapters.cams.cam.solve.turn import BEFORE
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Drawing,
    Item,
    Pen,
    Tag,
    dot,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Symbol, symbol
from tmm_report.figures.primitives import Arrow
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.sizes.least_size import Place, Zone

ROOM = (140.0, 95.0)  # mm: what the diagram may fill
BELOW = 1.25  # of the lowest place of the axis: how far the zone is drawn
FINE = 241
TANGENT = Pen(0.22, "blue")


def scale(found: CamFound, zone: Zone) -> float:
    """At which the diagram fits a page, m/mm."""
    return finest(found.lift + BELOW * _lowest(found, zone), partial(_items, found, zone), ROOM)


def drawing(found: CamFound, zone: Zone, mu: float) -> Drawing:
    """At the scale of `mu` m/mm, along both axes."""
    return Drawing(tuple(_items(found, zone, mu))).labelled([*_letters(found, zone, mu)])


def _lowest(found: CamFound, zone: Zone) -> float:
    return max(found.start, zone.best.s0)


def _curve(zone: Zone) -> list[complex]:
    """S' + iS over the turn; a jump of S' is drawn."""
    edges = np.array([*zone.law.breaks, FULL_TURN])
    theta = np.unique(np.concatenate([np.linspace(0.0, FULL_TURN, 1441), edges, edges - BEFORE]))
    S, slope, _ = zone.law.of(theta[(theta >= 0) & (theta < FULL_TURN)])
    return [complex(x, y) for x, y in zip(slope, S, strict=True)]


def _bounds(found: CamFound, zone: Zone) -> Iterator[tuple[complex, complex]]:
    """The tangents from their points down, and the line of the dwells."""
    bottom = -BELOW * _lowest(found, zone)
    for demand, way, limit in ((zone.of_rise, 1, zone.rise), (zone.of_return, -1, zone.back)):
        if demand is not None and limit is not None:
            yield complex(demand.slope, demand.S), complex(way * (bottom + demand.b) * tan(limit), bottom)
    yield 0j, complex(-bottom * tan(zone.rise), bottom)


def _items(found: CamFound, zone: Zone, mu: float) -> Iterator[Item]:
    curve, bottom = [z / mu for z in _curve(zone)], -BELOW * _lowest(found, zone) / mu
    yield polygon([z / mu for z in _permitted(zone, -bottom * mu)], None, "pale", 0.6)
    wide = max(abs(z.real) for z in curve)
    for start, end in ((-wide - 8 + 0j, wide + 10 + 0j), (1j * bottom, 1j * (found.lift / mu + 10))):
        yield line(start, end, THIN)
        yield Arrow(end - 3 * (end - start) / abs(end - start), end, THIN)
    yield polyline(curve, THICK)
    for start, end in _bounds(found, zone):
        yield line(start / mu, end / mu, TANGENT)
        if start:
            yield dot(start / mu)
    for place in (_axis(found), zone.best):
        at = complex(place.e, -place.s0) / mu
        yield line(at.real + 0j, at, AXIS)
        yield dot(at, 1.0)
    at = complex(_axis(found).e, -_axis(found).s0) / mu
    yield line(0j, at, NORMAL)


def _permitted(zone: Zone, depth: float) -> list[complex]:
    """Outline of the zone down to `depth`, m."""
    sides = [(depth - b) / k for _, b, k in zone.lines]
    low = max((x for x, (_, _, k) in zip(sides, zone.lines, strict=True) if k < 0), default=-depth)
    high = min((x for x, (_, _, k) in zip(sides, zone.lines, strict=True) if k > 0), default=depth)
    e = np.linspace(low, high, FINE)
    return [complex(x, -zone.at(float(x)).s0) for x in e]


def _axis(found: CamFound) -> Place:
    """Of the cam as it is made."""
    return Place(found.offset, found.start, ())


def _letters(found: CamFound, zone: Zone, mu: float) -> Iterator[Tag]:
    name = symbol(found.letters[0])
    made, best = (complex(place.e, -place.s0) / mu for place in (_axis(found), zone.best))
    yield Tag((name,), (made,), gap=2.0, prefer=-1 - 1j)
    yield Tag((Symbol(name.base, name.sub, "*"),), (best,), gap=2.0, prefer=1 - 1j)
    wide = max(abs(z.real) for z in _curve(zone)) / mu
    yield Tag((Symbol("s", "", "′"),), (wide + 10 + 0j,), gap=1.5)
    yield Tag((Symbol("s"),), (1j * (found.lift / mu + 10),), gap=1.5)
