"""The eccentric epicyclic mechanism assembled, with true involute teeth, and a close view of two neighbours."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.eccentric.solve import RING, SUN, Found, Satellite
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    TEXT,
    THIN,
    Arc,
    Arrow,
    Circle,
    Drawing,
    Item,
    Path,
    Pen,
    Tag,
    Text,
    line,
    polyline,
)
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.figures.marks import turning
from tmm_report.mechanics.eccentric_teeth import Body

Array = Any
Numbers = Callable[[float], str]  # a number as the note writes it

STEPS = (1, 2, 2.5, 4, 5, 10)  # of the standard scales
WIDTH = 158.0  # mm of paper that the assembled mechanism may take
RIM = 3.0  # modules outside the roots of the ring
FINE = 0.01  # mm of paper that a drawn tooth may leave the true curve
TOOTH = Pen(0.25)
CENTRES = Pen(0.18, "red", (3.0, 0.8, 0.5, 0.8))
SECOND = Pen(0.35, "blue")
MEASURE = Pen(0.13)
TURN = Pen(0.25, "blue")
ROUND = 25.0  # radius of a close view, mm of paper
BETWEEN = 4.0  # of close views, mm
MODULE = 8.0  # mm of paper that a module should take in a close view


def standard(ratio: float) -> float:
    """The largest standard scale (mm of paper to mm) not over `ratio`."""
    scales = [step * 10.0**power for power in range(-6, 4) for step in STEPS]
    inverse = [1 / scale for scale in scales]
    return max(scale for scale in (*scales, *inverse) if scale <= ratio * (1 + 1e-9) and _known(scale))


def _known(scale: float) -> bool:
    """1, 2, 2.5, 4, 5, 10 to one or one to these."""
    size = scale if scale >= 1 else 1 / scale
    return any(math.isclose(size / 10 ** math.floor(math.log10(size) + 1e-9), step) for step in STEPS)


def assembled(found: Found, num: Numbers = str, title: str = "") -> Drawing:
    """Every wheel with its teeth, pitch circles, the ellipse of the centres, the angles of a satellite and e."""
    scale = scale_of(found)
    mm = 1e3 * scale  # mm of paper to 1 m
    made = found.assembled(FINE / mm)
    items = [*_ring(made.ring, found, mm), *_wheel(made.sun, mm, "pale")]
    for body in made.satellites:
        items += _wheel(body, mm)
    items += [*_pitch_circles(found, mm), *_centres(found, mm), *_turns(found, mm)]
    items += [*_angles(found, mm), *_eccentricity(found, mm, num)]
    return Drawing(tuple(items), title).labelled(_tags(found, mm))


def scale_of(found: Found) -> float:
    """Scale of the assembled mechanism, mm of paper to mm."""
    return standard(WIDTH / (2e3 * _outside(found)))


def _outside(found: Found) -> float:
    """Radius of the ring's rim, m."""
    rack = found.given.rack
    return found.given.module * (found.ring / 2 + rack.ha + rack.c + RIM)


def _ring(body: Body, found: Found, mm: float) -> list[Item]:
    rim = body.centre + _outside(found) * np.exp(-2j * np.pi * np.arange(180) / 180)
    # two turns against each other: between them is the metal
    metal = Path((_points(rim, mm), _points(body.outline(), mm)), None, "pale", True, 0.6)
    return [
        metal,
        Circle(body.centre * mm, _outside(found) * mm, NORMAL),
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
        complex(found.e * mm), _outside(found) * mm + 3, math.radians(55), math.radians(-16), TURN
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
    end, low = found.e * mm, -(_outside(found) * mm + 6)
    for x in (0.0, end):
        yield line(complex(x, -2.5), complex(x, low - 1.5), MEASURE)
    text = (Symbol("e"), " = " + num(1e3 * found.e))
    yield from measured(complex(0, low), complex(end, low), text)


def measured(start: complex, end: complex, text: Parts) -> Iterator[Item]:
    """A dimension line with arrows, from outside where it is short; the text beyond its right end."""
    along = (end - start) / abs(end - start)
    short = abs(end - start) < 9
    if not short:
        yield Arrow(start, end, MEASURE, 2.2)
        yield Arrow(end, start, MEASURE, 2.2)
    else:
        yield line(start, end, MEASURE)
        yield Arrow(start - 9 * along, start, MEASURE, 2.2)
        yield Arrow(end + 9 * along, end, MEASURE, 2.2)
    yield Text(end + (2.5 + 2.2j if short else 2), text)


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
            Tag((Symbol("P", _plain(s.wheel)),), (s.centre * mm,), prefer=cmath.rect(1, math.radians(-135)))
        )
        aside = s.centre * mm + 0.6 * half * s.teeth * cmath.rect(1, _outwards(s) - math.radians(50))
        tags.append(Tag((_plain(s.wheel),), (aside,), 0.6, size=4.5))
    shown = _shown(found)
    if shown is not None:
        at1 = cmath.rect(sun_reach, shown.phi1 * 0.6)
        at3 = found.e * mm + cmath.rect(1.3 * sun_reach, shown.phi3 * 0.45)
        tags.append(Tag((Symbol("φ", "1"),), (at1,), 0.6, -1 - 1j))
        tags.append(Tag((Symbol("φ", "3"),), (at3,), 0.6, 1 + 1j))
    return tags


def _rim(found: Found, degrees: float, mm: float) -> complex:
    return complex(found.e * mm) + cmath.rect(_outside(found) * mm, math.radians(degrees))


# --- close views


def close(found: Found, num: Numbers = str, title: str = "") -> Drawing:
    """Two meshes of a satellite and the narrowest place between neighbours, each in a circle, its direction level."""
    scale = close_scale(found)
    mm = 1e3 * scale
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
    names = _plain(one.name) + "–" + _plain(other.name)
    if _meshing(one, other):
        return (names,)
    gap = 1e3 * (abs(other.centre - one.centre) - one.wheel.tip - other.wheel.tip)
    return (names + ": ", Symbol("Δ"), " = " + num(round(gap, 3)))


def _plain(wheel: str) -> str:
    return wheel.replace("'", "′")


def close_scale(found: Found) -> float:
    """Scale of the close views, mm of paper to mm."""
    return standard(MODULE / (1e3 * found.given.module))


def _views(found: Found) -> Iterator[tuple[str, str, complex, float]]:
    """Both wheels, the place, m, and the direction from one to the other that is laid level, rad."""
    m, s = found.given.module, found.satellites[0]
    along = cmath.rect(1, s.phi1)
    yield SUN, s.wheel, m / 2 * found.sun * along, s.phi1
    yield s.wheel, RING, complex(found.e) + cmath.rect(m / 2 * found.ring, s.phi3), s.phi3
    if (nearest := narrowest(found)) is not None:
        one, other, gap = nearest
        across = other.centre - one.centre
        tip = m * (one.teeth / 2 + found.given.rack.ha)
        yield one.wheel, other.wheel, one.centre + (tip + gap / 2) * across / abs(across), cmath.phase(across)


def narrowest(found: Found) -> tuple[Satellite, Satellite, float] | None:
    """The nearest neighbours and the gap between their tips, m; None: so far apart that neither would be in view."""
    nearest = min(found.neighbours, key=lambda pair: pair[2], default=None)
    return nearest if nearest is not None and 1e3 * nearest[2] * close_scale(found) < ROUND else None


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
        tags.append(Tag((_plain(body.name),), tuple(places), 0.3, size=4.5))
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
    yield from measured(complex(start.real, low.imag), complex(end.real, low.imag), (Symbol("Δ"),))
