"""The eccentric epicyclic mechanism assembled, with true involute teeth."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.draw.common import CENTRES, FINE, MEASURE, Numbers, measured, plain
from tmm_report.chapters.gears.eccentric.solve.mechanism import CARRIER, RING, SUN, Found, Satellite
from tmm_report.chapters.gears.eccentric.solve.paper import outside
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Arc,
    Circle,
    Drawing,
    Item,
    Moves,
    Moving,
    Path,
    Pen,
    Tag,
    line,
    polyline,
)
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.schemes.marks import turning
from tmm_report.mechanics.gears.eccentric.teeth import Body

Array = Any

TOOTH = Pen(0.25)
TURN = Pen(0.25, "blue")
SPOKE = 3.0  # mm: what shows how a wheel has turned


def assembled(found: Found, num: Numbers = str, title: str = "") -> Drawing:
    """Every wheel with its teeth, pitch circles, the ellipse of the centres, the angles of a satellite and e."""
    mm = 1e3 * found.scale  # mm of paper to 1 m
    made = found.assembled(FINE / mm)
    wheels = [(made.ring, _ring(made.ring, found, mm)), (made.sun, _wheel(made.sun, mm, "pale"))]
    wheels += [(body, _wheel(body, mm)) for body in made.satellites]
    items = [item for _, drawn in wheels for item in drawn]
    items += [*_pitch_circles(found, mm), *_centres(found, mm), *_turns(found, mm)]
    items += [*_angles(found, mm), *_eccentricity(found, mm, num)]
    return Drawing(tuple(items), title, moves=_rolling(found, wheels, mm)).labelled(_tags(found, mm))


def _rolling(found: Found, wheels: Sequence[tuple[Body, list[Item]]], mm: float) -> Moves:
    """Each wheel about its axis, the axes stopped, with a spoke that shows it."""
    stopped = next(motion for motion in found.motions if motion.stopped == CARRIER)
    parts = []
    for body, drawn in wheels:
        centre, radii = body.centre * mm, np.abs(body.outline() - body.centre) * mm
        edge, depth = float(radii.min()), -SPOKE
        if body is wheels[0][0]:
            edge, depth = float(radii.max()), SPOKE
        spoke = line(centre + edge, centre + edge + depth, THICK)
        parts.append(Moving((*drawn, spoke), centre, body.name))
    still = tuple(item for _, drawn in wheels for item in drawn)
    return Moves(tuple(parts), still, speed=stopped.speed)


def _ring(body: Body, found: Found, mm: float) -> list[Item]:
    rim = body.centre + outside(found.given, found.ring) * np.exp(-2j * np.pi * np.arange(180) / 180)
    # two turns against each other: between them is the metal
    metal = Path((_points(rim, mm), _points(body.outline(), mm)), None, "pale", True, 0.6)
    return [
        metal,
        Circle(body.centre * mm, outside(found.given, found.ring) * mm, NORMAL),
        Path((_points(body.outline(), mm),), TOOTH, closed=True),
    ]


def _wheel(body: Body, mm: float, fill: str = "") -> list[Item]:
    return [Path((_points(body.outline(), mm),), TOOTH, fill, True, 0.6)]


def _points(outline: Array, mm: float) -> tuple[complex, ...]:
    return tuple(complex(z) for z in outline * mm)


def _pitch_circles(found: Found, mm: float) -> Iterator[Item]:
    half = found.given.module / 2 * mm
    yield Circle(0j, half * found.sun, AXIS)
    yield Circle(complex(found.e * mm), half * found.ring, AXIS)
    for s in found.satellites:
        yield Circle(s.centre * mm, half * s.teeth, AXIS)
    for centre in (0j, complex(found.e * mm), *(s.centre * mm for s in found.satellites)):
        yield from (line(centre - arm, centre + arm, THIN) for arm in (2.0, 2j))


def _centres(found: Found, mm: float) -> Iterator[Item]:
    """The ellipse with the foci O1 and O3 on which all the centres lie."""
    long = found.given.module * (found.sun + found.ring) / 4
    short = math.sqrt(long**2 - found.e**2 / 4)
    turn = np.linspace(0, 2 * np.pi, 121)
    yield polyline(_points(found.e / 2 + long * np.cos(turn) + 1j * short * np.sin(turn), mm), CENTRES)


def _turns(found: Found, mm: float) -> Iterator[Item]:
    """The sense of rotation with the axes stopped: the sun counter-clockwise, all others the other way."""
    half = found.given.module / 2 * mm
    yield from turning(0j, 0.62 * half * found.sun, math.radians(-150), math.radians(90), TURN)
    for s in found.satellites:
        start = _outwards(s) + math.radians(35)
        yield from turning(s.centre * mm, 0.6 * half * s.teeth, start, math.radians(-70), TURN)
    yield from turning(
        complex(found.e * mm),
        outside(found.given, found.ring) * mm + 3,
        math.radians(55),
        math.radians(-16),
        TURN,
    )


def _outwards(s: Satellite) -> float:
    """Direction from the mechanism's middle to a satellite, rad."""
    return cmath.phase(s.centre)


def _shown(found: Found) -> Satellite | None:
    """The satellite whose angles are drawn: the first above the axis."""
    return next((s for s in found.satellites if 0 < s.phi1 < math.pi - 1e-9), None)


def _angles(found: Found, mm: float) -> Iterator[Item]:
    shown = _shown(found)
    if shown is None:
        return
    first, third, at = 0j, complex(found.e * mm), shown.centre * mm
    yield from (line(centre, at, MEASURE) for centre in (first, third))
    yield line(first - 4, third + _reach(found, mm) * 1.6, MEASURE)
    yield Arc(first, _reach(found, mm), 0.0, shown.phi1, THIN)
    yield Arc(third, 1.3 * _reach(found, mm), 0.0, shown.phi3, THIN)


def _reach(found: Found, mm: float) -> float:
    """Radius of the arc of φ1, mm of paper."""
    return max(4.0, 0.3 * found.given.module / 2 * found.sun * mm)


def _eccentricity(found: Found, mm: float, num: Numbers) -> Iterator[Item]:
    """e as a dimension under the mechanism, its lines led down from O1 and O3."""
    end, low = found.e * mm, -(outside(found.given, found.ring) * mm + 6)
    for x in (0.0, end):
        yield line(complex(x, -2.5), complex(x, low - 1.5), MEASURE)
    text = (Symbol("e"), " = " + num(1e3 * found.e))
    yield from measured(complex(0, low), complex(end, low), text)


def _tags(found: Found, mm: float) -> list[Tag]:
    half, sun_reach = found.given.module / 2 * mm, _reach(found, mm)
    tags = [
        Tag((Symbol("O", "1"),), (0j,), prefer=cmath.rect(1, math.radians(225))),
        Tag((Symbol("O", "3"),), (complex(found.e * mm),), prefer=cmath.rect(1, math.radians(-45))),
        Tag((SUN,), (-0.6 * half * found.sun + 0j,), 0.4, -1 + 0j, size=4.5),
        Tag((RING,), (_rim(found, 63, mm),), 1.5, cmath.rect(1, math.radians(63)), size=4.5),
    ]
    for s in found.satellites:
        tags.append(
            Tag((Symbol("P", plain(s.wheel)),), (s.centre * mm,), prefer=cmath.rect(1, math.radians(-135)))
        )
        aside = s.centre * mm + 0.6 * half * s.teeth * cmath.rect(1, _outwards(s) - math.radians(50))
        tags.append(Tag((plain(s.wheel),), (aside,), 0.6, size=4.5))
    shown = _shown(found)
    if shown is not None:
        at1 = cmath.rect(sun_reach, shown.phi1 * 0.6)
        at3 = found.e * mm + cmath.rect(1.3 * sun_reach, shown.phi3 * 0.45)
        tags.append(Tag((Symbol("φ", "1"),), (at1,), 0.6, -1 - 1j))
        tags.append(Tag((Symbol("φ", "3"),), (at3,), 0.6, 1 + 1j))
    return tags


def _rim(found: Found, degrees: float, mm: float) -> complex:
    return complex(found.e * mm) + cmath.rect(outside(found.given, found.ring) * mm, math.radians(degrees))
