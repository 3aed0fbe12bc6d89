"""The cam drawn to scale: profile, base circle, pitch curve, and the follower's end in its numbered positions, as they
stand to a cam at rest (the motion turned round), the cam being as it is in position 0."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import product

import numpy as np

from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.figures.drawing import (
    AXIS,
    DASHED,
    NORMAL,
    THICK,
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
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Symbol, symbol
from tmm_report.figures.schemes import marks
from tmm_report.quantity.paper import ROUND

ROOM = (140.0, 125.0)  # mm: what the drawing may fill
FINE = 721
PITCH = Pen(0.22, "blue", (5.0, 1.0, 0.6, 1.0))
GHOST = Pen(0.22, "grey")
SMALL = 2.5  # height of the numbers of positions, mm
FACE = 9.0  # half length of the faces drawn, mm


def scale(found: CamFound) -> float:
    """At which the drawing fits a page, m/mm."""
    return finest(2 * found.cam.base, partial(_items, found))


def finest(size: float, drawn: Callable[[float], Iterable[Item]], room: tuple[float, float] = ROOM) -> float:
    """The finest of the scales 1, 2, 2.5, 4, 5·10ⁿ m/mm at which what is `drawn` at it fits a page, or another `room`;
    `size`: about what is drawn, m: nothing is drawn many times as large as the room."""
    for power, digit in product(range(-6, 3), ROUND):
        mu = float(f"{digit * 10.0**power:.3g}")
        if size / mu >= 4 * room[0]:
            continue
        wide, high = Drawing(tuple(drawn(mu))).size
        if wide <= room[0] and high <= room[1]:
            return mu
    return 1.0


def drawing(found: CamFound, mu: float) -> Drawing:
    """At the scale of `mu` m/mm."""
    items = tuple(_items(found, mu))
    return Drawing(items, moves=moves(found, mu, items)).labelled(
        [*_letters(found, mu), *_numbers(found, mu)]
    )


def _turned(found: CamFound) -> complex:
    return cmath.rect(1.0, float(found.phi(0.0)))


def moves(found: CamFound, mu: float, still: tuple[Item, ...]) -> Moves:
    """In place of what is drawn of a cam at rest."""
    return Moves(tuple(_moving(found, mu)), still, bare=True)


def _moving(found: CamFound, mu: float) -> Iterator[Moving]:
    """The cam as it turns from its position 0, and the follower upon it, in the positions of the diagram."""
    phi = found.phi(found.diagram.turned)
    at = tuple(float(x) for x in found.diagram.turned)
    turns = np.real(phi - found.phi(0.0))
    yield Moving(tuple(_body(found, mu)), at=at, turns=tuple(map(float, turns)))
    _, b = found.cam.moved(phi)
    start = found.cam.moved(found.phi(0.0))[1]
    end, place = _end(found, mu), complex(start.z) / mu
    rest = [*marks.support(0j), *marks.joint(0j)]
    if found.slides:
        along = complex(getattr(found.cam.motion, "along", 1j))
        ways = np.asarray(b.z - start.z) / mu
        rod = line(place, place + 14 * along, THICK)
        yield Moving((rod, *end), at=at, ways=tuple(map(complex, ways)))
        foot = complex(getattr(found.cam.motion, "foot", 0j)) / mu
        rest.append(line(foot, place + 16 * along, AXIS))
    else:
        pivot = found.pivot / mu
        swung = np.unwrap(np.angle((b.z - found.pivot) / (start.z - found.pivot)))
        yield Moving((line(place, pivot, THICK), *end), pivot, at=at, turns=tuple(map(float, swung)))
        rest += [*marks.support(pivot), *marks.joint(pivot)]
    yield Moving(tuple(rest))


def _end(found: CamFound, mu: float) -> list[Item]:
    """The follower's end in position 0."""
    _, b = found.cam.moved(found.phi(0.0))
    at = complex(b.z) / mu
    if found.cam.flat:
        normal = complex(found.cam.touched(*found.cam.moved(found.phi(0.0))).normal)
        return [line(at - FACE * 1j * normal, at + FACE * 1j * normal, NORMAL)]
    return (
        [Circle(at, found.cam.roller / mu, NORMAL, "white"), dot(at, 0.5)]
        if found.cam.roller
        else [dot(at, 0.5)]
    )


def _body(found: CamFound, mu: float) -> Iterator[Item]:
    """The cam in position 0."""
    cam, back = found.cam, _turned(found)
    phi = np.linspace(0.0, 2 * np.pi, FINE)
    profile = [complex(z) for z in cam.profile(phi) * back / mu]
    yield polygon(profile, THICK, "pale", 0.6)
    yield Circle(0j, cam.base / mu, DASHED)
    if cam.roller:
        yield polyline([complex(z) for z in cam.pitch(phi) * back / mu], PITCH)


def _items(found: CamFound, mu: float) -> Iterator[Item]:
    yield from _body(found, mu)
    yield from _ends(found, mu)
    yield from _follower(found, mu)
    yield from marks.support(0j)
    yield from marks.joint(0j)
    yield from marks.turning(0j, 0.55 * found.cam.base / mu, 0.3, found.sense * 1.2)


def _places(found: CamFound) -> list[tuple[int, complex, complex]]:
    """Number, place of the follower's end (the contact of a flat face) and outward normal, to a cam at rest, m."""
    count = found.turn.distinct
    phi = found.phi(found.table.turned[:count])
    q, b = found.cam.moved(phi)
    touch = found.cam.touched(q, b)
    end = touch.at if found.cam.flat else b.z
    turn = np.exp(-1j * phi) * _turned(found)
    return [
        (k, complex(z), complex(n))
        for k, (z, n) in enumerate(zip(end * turn, touch.normal * turn, strict=True))
    ]


def _ends(found: CamFound, mu: float) -> Iterator[Item]:
    """Rollers, knife edges or flat faces in all numbered positions; the first one heavy."""
    for k, place, normal in _places(found):
        at, pen = place / mu, NORMAL if k == 0 else GHOST
        if found.cam.flat:
            yield line(at - FACE * 1j * normal, at + FACE * 1j * normal, NORMAL if k == 0 else THIN)
        elif found.cam.roller:
            yield Circle(at, found.cam.roller / mu, pen)
        yield dot(at, 0.5)


def _follower(found: CamFound, mu: float) -> Iterator[Item]:
    """The follower in position 0: its line of motion, or its lever to the pivot."""
    _, b = found.cam.moved(found.phi(0.0))
    at = complex(b.z) / mu
    if found.slides:
        along = complex(getattr(found.cam.motion, "along", 1j))
        foot = complex(getattr(found.cam.motion, "foot", 0j)) / mu
        yield line(foot, at + 16 * along, AXIS)
        yield line(at, at + 14 * along, THICK)
        if abs(foot) > 0.3:
            yield Circle(0j, abs(foot), THIN)
        return
    pivot = found.pivot / mu
    yield line(at, pivot, THICK)
    yield line(0j, pivot, AXIS)
    yield from marks.support(pivot)
    yield from marks.joint(pivot)


def _letters(found: CamFound, mu: float) -> list[Tag]:
    cam = found.cam
    _, b = cam.moved(found.phi(0.0))
    axis, pivot = found.letters
    tags = [Tag((symbol(axis),), (0j,), gap=2.0, prefer=1 - 1j)]
    radius = 0.55 * cam.base / mu
    tags.append(Tag((Symbol("ω", cam.cam),), (cmath.rect(radius, 0.3 + found.sense * 0.6),), gap=0.8))
    if not found.slides:
        tags.append(Tag((symbol(pivot),), (found.pivot / mu,), gap=2.0))
    tags.append(Tag((symbol(cam.point),), (complex(b.z) / mu,), gap=1.5))
    return tags


def _numbers(found: CamFound, mu: float) -> Iterator[Tag]:
    """Numbers of the positions outside the follower's ends."""
    out = (found.cam.roller or 0.0) / mu + 0.8
    for k, place, normal in _places(found):
        away = normal if abs(place) < 1e-12 else place / abs(place)
        tiers = tuple(place / mu + (out + 2.6 * tier) * away for tier in range(3))
        yield Tag((str(k),), tiers, 0.6, away, SMALL, "blue")
