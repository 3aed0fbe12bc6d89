"""The model of the machine on its isolators as it is drawn: springs and dampers, what shakes it, its base."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Literal

from tmm_report.chapters.machine.vibration.solve import Found
from tmm_report.figures.drawing import (
    NORMAL,
    THICK,
    THIN,
    Arc,
    Arrow,
    Drawing,
    Item,
    Text,
    hatching,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.figures.springs import zigzag

WIDE, TALL, GAP = 44.0, 16.0, 18.0  # mm: a mass, and the room of springs between two of them
COILS = 5
ABSORBER = 16.0  # width of the absorber, mm


def scheme(found: Found, base: str) -> Drawing:
    """Not to scale: what stands on what; `base`: the index of its letters."""
    return _turning(found, base) if found.given.turning else _linear(found, base)


def _linear(found: Found, base: str) -> Drawing:
    items: list[Item] = [*_ground(0.0)]
    tags: list[Item] = []
    foot = 0.0
    if found.stood is not None:
        items += [*_legs(foot, found.stood.base.damping > 0), *_mass(foot + GAP, WIDE + 12)]
        tags += [_tag(0j + 1j * (foot + GAP + TALL / 2), "m", base), *_letters(foot, base)]
        foot += GAP + TALL
    items += [*_legs(foot, found.body.damping > 0), *_mass(foot + GAP, WIDE)]
    tags += [_tag(1j * (foot + GAP + TALL / 2), "m"), *_letters(foot, "")]
    top = foot + GAP + TALL
    if found.absorbed is not None:
        items += [
            *zigzag(complex(-WIDE / 4, top), complex(-WIDE / 4, top + GAP), COILS, 2.6),
            *_box(complex(-WIDE / 4, top + GAP + TALL / 3), ABSORBER, 2 * TALL / 3),
        ]
        tags += [
            _tag(complex(-WIDE / 4, top + GAP + TALL / 3), "m", "a"),
            _tag(complex(-WIDE / 4 - 4, top + GAP / 2), "c", "a", 1),
        ]
    items += list(_shaken(found, top))
    return Drawing(
        (*items, *_axis(complex(WIDE / 2, foot + GAP + TALL / 2)), *tags, *_named(found, top, foot))
    )


def _text(parts: Parts, at: complex, align: Literal[-1, 0, 1] = 0) -> Item:
    return Text(at, parts, align=align)


def _tag(at: complex, base: str, sub: str = "", align: Literal[-1, 0, 1] = 0) -> Item:
    return _text((Symbol(base, sub),), at, align)


def _letters(foot: float, sub: str) -> list[Item]:
    return [
        _tag(complex(-WIDE / 4 - 4, foot + GAP / 2), "c", sub, 1),
        _tag(complex(WIDE / 4 + 5, foot + GAP / 2), "b", sub, -1),
    ]


def _shaken(found: Found, top: float) -> Iterator[Item]:
    """The force on the machine, or the motion of the base."""
    if found.given.free:
        return
    if found.given.base is None:
        yield Arrow(complex(WIDE / 4, top), complex(WIDE / 4, top + 14))
    else:
        yield Arrow(complex(-WIDE / 2 - 8, 0), complex(-WIDE / 2 - 8, 10))


def _named(found: Found, top: float, foot: float) -> list[Item]:
    force: Parts = (Symbol("F"), " sin ", Symbol("ω"), Symbol("t"))
    if found.shaking is not None:
        force = (Symbol("F"), "(", Symbol("t"), ")")
    named = [_text((Symbol("x"),), complex(WIDE / 2 + 9, foot + GAP + TALL / 2 + 8))]
    if found.given.free:
        return named
    if found.given.base is None:
        return [*named, _text(force, complex(WIDE / 4 + 2, top + 11), -1)]
    return [*named, _text((Symbol("z"),), complex(-WIDE / 2 - 11, 7))]


def _axis(at: complex) -> Iterator[Item]:
    """From the machine's side, upwards."""
    yield line(at, at + 10, THIN)
    yield Arrow(at + 7, at + 7 + 9j, THIN)


def _mass(foot: float, wide: float) -> Iterator[Item]:
    yield from _box(1j * (foot + TALL / 2), wide, TALL)


def _box(centre: complex, wide: float, tall: float) -> Iterator[Item]:
    half = complex(wide / 2, tall / 2)
    corners = (-half, half.conjugate(), half, -half.conjugate())
    yield polygon([centre + corner for corner in corners], THICK, "white")


def _legs(foot: float, damped: bool) -> Iterator[Item]:
    """A spring and, where there is damping, a damper beside it."""
    yield from zigzag(complex(-WIDE / 4, foot), complex(-WIDE / 4, foot + GAP), COILS, 2.6)
    if damped:
        yield from _damper(complex(WIDE / 4, foot), complex(WIDE / 4, foot + GAP))
    else:
        yield from zigzag(complex(WIDE / 4, foot), complex(WIDE / 4, foot + GAP), COILS, 2.6)


def _damper(start: complex, end: complex) -> Iterator[Item]:
    """A cup on the lower rod, a piston on the upper one."""
    along = end - start
    unit = along / abs(along)
    side = 1j * unit * 3.2
    cup, brim, piston = start + 0.3 * along, start + 0.62 * along, start + 0.46 * along
    yield line(start, cup)
    yield polyline([brim + side, cup + side, cup - side, brim - side], NORMAL)
    yield line(piston + 0.8 * side, piston - 0.8 * side, THICK)
    yield line(piston, end)


def _ground(level: float) -> Iterator[Item]:
    left, right = complex(-WIDE / 2 - 6, level), complex(WIDE / 2 + 6, level)
    yield hatching(left, right, -1j)
    yield line(left, right)


# --- a disc on a shaft

SHAFT, RADIUS, THICKNESS = 46.0, 18.0, 9.0  # mm


def _turning(found: Found, base: str) -> Drawing:
    """From the side: a wall, the shaft, the disc; with a second disc where the shaft ends in one."""
    items: list[Item] = [*_wall(0.0)]
    tags: list[Item] = []
    at = 0.0
    if found.stood is not None:
        items += [*_shaft(at), *_disc(at + SHAFT)]
        tags += [
            _tag(complex(at + SHAFT + THICKNESS / 2, RADIUS + 4), "J", base, 0),
            _tag(complex(at + SHAFT / 2, 5), "c", base),
        ]
        at += SHAFT + THICKNESS
    items += [*_shaft(at), *_disc(at + SHAFT)]
    tags += [
        _tag(complex(at + SHAFT + THICKNESS / 2, RADIUS + 4), "J"),
        _tag(complex(at + SHAFT / 2, 5), "c"),
    ]
    return Drawing((*items, *_swing(found, at), *tags, *_swung(found, at)))


def _wall(at: float) -> Iterator[Item]:
    foot, top = complex(at, -14), complex(at, 14)
    yield hatching(foot, top, -1 + 0j)
    yield line(foot, top)


def _shaft(at: float) -> Iterator[Item]:
    for side in (1.6j, -1.6j):
        yield line(at + side, at + SHAFT + side)


def _disc(at: float) -> Iterator[Item]:
    yield from _box(complex(at + THICKNESS / 2, 0), THICKNESS, 2 * RADIUS)


def _swing(found: Found, at: float) -> Iterator[Item]:
    """The moment, as an arc about the shaft seen aslant, before the disc or at the wall."""
    if found.given.free:
        return
    place = 8.0 if found.given.base is not None else at + SHAFT + THICKNESS + 8
    arc = Arc(complex(place, 0), 9.0, -math.pi / 3, math.pi / 3, NORMAL)
    tip, back = arc.at(math.pi / 3), arc.at(math.pi / 3 - 0.32)
    side = 0.17j * (tip - back)
    yield arc
    yield polygon((tip, back + side, back - side), None, "black")


def _swung(found: Found, at: float) -> list[Item]:
    if found.given.base is not None:
        return [_text((Symbol("z"),), complex(14, 12))]
    moment = (Symbol("M"), " sin ", Symbol("ω"), Symbol("t"))
    named = [_text((Symbol("θ"),), complex(at + SHAFT + THICKNESS + 18, -8))]
    if found.given.free:
        return named
    return [_text(moment, complex(at + SHAFT + THICKNESS + 18, 12)), *named]
