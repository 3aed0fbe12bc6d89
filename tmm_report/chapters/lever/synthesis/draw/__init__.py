"""The found linkage as it is drawn, to scale: the extreme positions of the links, or those that were asked for."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.synthesis.draw.places import Picture, picture
from tmm_report.chapters.lever.synthesis.solve import Design
from tmm_report.figures.dimensions import span
from tmm_report.figures.drawing import (
    AXIS,
    DASHED,
    NORMAL,
    THICK,
    THIN,
    Arc,
    Circle,
    Drawing,
    Item,
    Tag,
    line,
    polyline,
)
from tmm_report.figures.lettering import Symbol as Letter
from tmm_report.figures.schemes.marks import joint, support
from tmm_report.quantity.paper import fitting_scale

WIDE, TALL = 120.0, 85.0  # mm


def scale(found: Design) -> float:
    """m/mm, round."""
    shown = picture(found)
    places = [at for position in shown.chains for chain in position for at in chain] + list(shown.pivots)
    places += [end for one in shown.lines for end in one]
    reach = max(map(abs, places))
    for centre, radius in shown.circles:
        if radius < reach:
            places += [centre + radius * turn for turn in (1, -1, 1j, -1j)]
    x, y = ([part(z) for z in places] for part in (_real, _imag))
    return fitting_scale(max(x) - min(x), max(y) - min(y), (WIDE, TALL))


def _real(z: complex) -> float:
    return z.real


def _imag(z: complex) -> float:
    return z.imag


def scheme(found: Design, title: str) -> Drawing:
    shown, mu = picture(found), scale(found)
    drawn = Drawing(tuple(_items(shown, mu)), title)
    tags = [Tag((name,), (at / mu,)) for name, at in shown.names]
    tags += [
        Tag((Letter(found.s.named(key).sign.base),), ((one + other) / 2 / mu + _aside(one, other),))
        for key, one, other in shown.spans
    ]
    return drawn.labelled(tags)


def _items(shown: Picture, mu: float) -> Iterator[Item]:
    for at in shown.pivots:
        yield from support(at / mu)
    for centre, radius in shown.circles:
        yield Circle(centre / mu, radius / mu, AXIS, "")
    for centre, radius, low, high in shown.arcs:
        yield Arc(centre / mu, radius / mu, low, high, AXIS)
    for one, other in shown.lines:
        yield line(one / mu, other / mu, AXIS)
    for k, position in enumerate(shown.chains):
        for chain in position:
            yield polyline([at / mu for at in chain], THICK if k == 0 else NORMAL if k == 1 else DASHED)
    for position in shown.chains:
        for at in dict.fromkeys(at for chain in position for at in chain):
            yield from joint(at / mu)
    for at in shown.pivots:
        yield from joint(at / mu)
    for _, one, other in shown.spans:
        off = _aside(one, other)
        for end in (one, other):
            yield line(end / mu, end / mu + 1.1 * off, THIN)
        yield from span(one / mu + off, other / mu + off)


def _aside(one: complex, other: complex) -> complex:
    """How far a dimension stands from what it measures, mm."""
    return -9j * (other - one) / abs(other - one)
