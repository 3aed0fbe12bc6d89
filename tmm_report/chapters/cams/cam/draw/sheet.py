"""The cam constructed by reversed motion, as the sheet of a course has it: the cam at rest, the follower in all its
numbered positions about it, the circles from which they are laid off, the profile that all of them touch."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from functools import partial

import numpy as np

from tmm_report.chapters.cams.cam.draw import profile
from tmm_report.chapters.cams.cam.draw.profile import FINE, PITCH, SMALL, finest
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.chapters.cams.cam.solve.making import Making
from tmm_report.figures.drawing import (
    AXIS,
    DASHED,
    NORMAL,
    THICK,
    THIN,
    Circle,
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
from tmm_report.figures.schemes import marks

ROOM = (375.0, 365.0)  # mm: a sheet A2 with its caption, or a smaller one
SHARED = profile.ROOM  # where text stands beside it
MOST = 36  # positions in which the follower is drawn
BEYOND = 9.0  # mm by which the axis of a follower goes past its end
FACE = 0.35  # of the base circle's radius: half a drawn face, at least
WALL = Pen(0.5, "black")
TOOL = Pen(0.22, "red", (3.0, 1.2))


def scale(made: Making, room: tuple[float, float] = ROOM) -> float:
    """At which the drawing fits its sheet, or another `room`, m/mm."""
    return finest(2 * made.found.cam.base, partial(_items, made), room)


def drawing(made: Making, mu: float) -> Drawing:
    """At the scale of `mu` m/mm."""
    items = tuple(_items(made, mu))
    moves = profile.moves(made.found, mu, items)
    return Drawing(items, moves=moves).labelled([*_letters(made.found, mu), *_numbers(made.found, mu)])


def shown(found: CamFound) -> list[int]:
    """Numbers of the positions that are drawn."""
    count = found.turn.distinct
    return list(range(0, count, -(-count // MOST)))


class Reversed:
    """The follower to the cam at rest, mm: its end `end`, `contact`, outward `normal`, direction `along` in which it is
    lifted, and `root`: the foot of the perpendicular on its line, or its pivot, (P,)."""

    def __init__(self, found: CamFound, mu: float):
        cam, numbers = found.cam, shown(found)
        phi = found.phi(found.table.turned[numbers])
        back = np.exp(-1j * phi) * cmath.exp(1j * float(found.phi(0.0)))
        q, b = cam.moved(phi)
        touch = cam.touched(q, b)
        root = complex(getattr(cam.motion, "foot", 0j)) if found.slides else found.pivot
        along = np.full(phi.shape, complex(getattr(cam.motion, "along", 1j)))
        self.numbers = numbers
        self.end, self.contact = b.z * back / mu, touch.at * back / mu
        self.normal, self.along, self.root = touch.normal * back, along * back, root * back / mu


def _items(made: Making, mu: float) -> Iterator[Item]:
    found, cam = made.found, made.found.cam
    back = cmath.exp(1j * float(found.phi(0.0)))
    curves = made.curves(np.linspace(0.0, 2 * np.pi, FINE))

    def laid(points: object) -> list[complex]:
        return [complex(z) for z in np.asarray(points) * back / mu]

    yield from _circles(found, mu)
    yield from _followers(found, mu)
    yield polygon(laid(curves.profile), THICK, "pale", 0.4)
    if curves.pitch is not None:
        yield polyline(laid(curves.pitch), PITCH)
    if curves.outer is not None:
        yield polyline(laid(curves.outer), WALL)
    for path in (curves.cut, curves.cut_outer):
        if path is not None:
            yield polyline(laid(path), TOOL)
    yield from marks.support(0j)
    yield from marks.joint(0j)
    yield from marks.turning(0j, 0.5 * cam.base / mu, 0.3, found.sense * 1.2)


def _circles(found: CamFound, mu: float) -> Iterator[Item]:
    """From which the follower's positions are laid off."""
    cam = found.cam
    yield Circle(0j, cam.base / mu, DASHED)
    if cam.roller:
        yield Circle(0j, found.pitch_base / mu, AXIS)
    away = abs(getattr(cam.motion, "foot", 0j)) if found.slides else abs(found.pivot)
    if away / mu > 0.3:
        yield Circle(0j, away / mu, AXIS)


def _followers(found: CamFound, mu: float) -> Iterator[Item]:
    at, cam = Reversed(found, mu), found.cam
    half = max(
        FACE * cam.base / mu, float(np.max(np.abs(at.contact - at.end))) + 3.0 if found.slides else 0.0
    )
    for k, (end, contact, normal, along, root) in enumerate(
        zip(at.end, at.contact, at.normal, at.along, at.root, strict=True)
    ):
        first = k == 0
        pen = NORMAL if first else THIN
        if found.slides:
            yield line(root, end + BEYOND * along, pen if first else AXIS)
        else:
            yield line(root, contact if cam.flat else end, pen)
            yield Circle(root, 0.8, pen)
        if cam.flat:
            turned = 1j * normal
            middle = end if found.slides else contact
            yield line(middle - half * turned, middle + half * turned, pen)
            yield dot(contact, 0.5)
        elif cam.roller:
            yield Circle(end, cam.roller / mu, pen)
            yield line(end, contact, THIN)
        yield dot(end if not cam.flat else contact, 0.5)
    if not found.slides:
        yield line(0j, at.root[0], AXIS)
        yield from marks.support(at.root[0])
        yield from marks.joint(at.root[0])


def _letters(found: CamFound, mu: float) -> Iterator[Tag]:
    axis, pivot = found.letters
    yield Tag((symbol(axis),), (0j,), gap=2.0, prefer=1 - 1j)
    radius = 0.5 * found.cam.base / mu
    turned = cmath.rect(radius, 0.3 + found.sense * 0.6)
    yield Tag((Symbol("ω", found.cam.cam),), (turned,), gap=0.8)
    if not found.slides:
        yield Tag((symbol(pivot),), (Reversed(found, mu).root[0],), gap=2.5, prefer=-1 - 1j)


def _numbers(found: CamFound, mu: float) -> Iterator[Tag]:
    """At the outer end of the axis of a sliding follower, at the pivot of one that swings."""
    at = Reversed(found, mu)
    for number, end, along, root in zip(at.numbers, at.end, at.along, at.root, strict=True):
        if found.slides:
            places = tuple(end + (BEYOND + 1.5 + 2.6 * tier) * along for tier in range(3))
            yield Tag((str(number),), places, 0.6, along, SMALL, "blue")
        else:
            away = root / abs(root)
            yield Tag(
                (str(number),), tuple(root + 2.6 * tier * away for tier in range(3)), 1.2, away, SMALL, "blue"
            )
