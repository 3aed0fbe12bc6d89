"""The planetary stage from the front, in mm of paper: circles of all wheels, every satellite in its place, the carrier.

The first satellite is at the top. Of each wheel the working circle is drawn thin with dots, the tip circle in full,
of a ring also its rim; the held member is hatched.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from tmm_report.chapters.gears.planetary.solve.paper import RIM, reach
from tmm_report.chapters.gears.planetary.solve.stage import Found
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Arrow,
    Circle,
    Drawing,
    Item,
    Moves,
    Moving,
    Path,
    Tag,
    dot,
    line,
)
from tmm_report.figures.lettering import Symbol
from tmm_report.mechanics.gears.planetary.stage import INTERNAL

OUTSIDE = 8.0  # mm: arrows of a small dimension, from outside
HUB = 1.4  # radius of a shaft, mm of paper


def front(found: Found, title: str) -> Drawing:
    """The stage from the front at its scale."""
    view = _Front(found)
    items = tuple(view.items())
    moves = Moves(tuple(view.moving()), items, bare=True)
    return Drawing(items, title, moves=moves).labelled(tuple(view.tags()))


class _Front:
    def __init__(self, found: Found):
        self.found, self.mm = found, 1 / found.scale
        self.arm = float(found.sizes.centre_distance) * self.mm
        turns = [2 * math.pi * j / found.satellites for j in range(found.satellites)]
        self.centres = [cmath.rect(self.arm, math.pi / 2 + turn) for turn in turns]
        self.crowns = (1,) if found.scheme.single else (1, 2)
        self.rows = [
            (wheel, found.scheme.rows[row] == INTERNAL, tuple(self._central(row, wheel)))
            for row, wheel in ((0, 0), (1, 3))
        ]
        self.satellites = [
            [(crown, tuple(self._wheel(centre, crown))) for crown in self.crowns] for centre in self.centres
        ]
        self.axes, self.carrier = tuple(self._axes()), tuple(self._carrier())

    def radius(self, values: str, wheel: int) -> float:
        """Half of a diameter, mm of paper."""
        return float(getattr(self.found.sizes, values)[wheel]) / 2 * self.mm

    def items(self) -> Iterator[Item]:
        for _, _, drawn in self.rows:
            yield from drawn
        for satellite in self.satellites:
            for _, drawn in satellite:
                yield from drawn
        yield from (*self.axes, *self.carrier, *self._gap())

    def _central(self, row: int, wheel: int) -> Iterator[Item]:
        ring = self.found.scheme.rows[row] == INTERNAL
        return self._ring(row, wheel) if ring else self._wheel(0j, wheel)

    def _wheel(self, centre: complex, wheel: int) -> Iterator[Item]:
        yield Circle(centre, self.radius("trimmed", wheel), NORMAL)
        yield Circle(centre, self.radius("working", wheel), AXIS)

    def _ring(self, row: int, wheel: int) -> Iterator[Item]:
        rim = self.radius("root", wheel) + RIM * self.found.given.task.modules[row] * self.mm
        yield Circle(0j, rim, THICK)
        yield Circle(0j, self.radius("trimmed", wheel), NORMAL)
        yield Circle(0j, self.radius("working", wheel), AXIS)
        if self._held(wheel):
            yield _hatched(rim)

    def moving(self) -> Iterator[Moving]:
        """The members as they turn, each wheel with a spoke that shows it."""
        names, crowns = self.found.given.names, self.found.given.crowns
        carrier = names[-1]
        yield Moving(self.axes)
        for (wheel, ring, drawn), name in zip(self.rows, (names[0], names[-2]), strict=True):
            edge = self.radius("root" if ring else "working", wheel)
            spoke = Path(((complex(0, 0.86 * edge), complex(0, edge)),), THICK)
            yield Moving((*drawn, spoke), of=name)
        for centre, satellite in zip(self.centres, self.satellites, strict=True):
            for (crown, drawn), name in zip(satellite, crowns, strict=False):
                out = centre + self.radius("working", crown)
                spoke = Path(((centre, out),), THIN)
                yield Moving((*drawn, spoke), centre, name, about=carrier)
        yield Moving(self.carrier, of=carrier)

    def _held(self, wheel: int) -> bool:
        names = {0: self.found.given.names[0], 3: self.found.given.names[-2]}
        return names[wheel] in self.found.fixed

    def _axes(self) -> Iterator[Item]:
        edge = reach(self.found.given.task, self.found.sizes) * self.mm + 3
        yield line(complex(-edge, 0), complex(edge, 0), AXIS)
        yield line(complex(0, -edge), complex(0, edge), AXIS)

    def _carrier(self) -> Iterator[Item]:
        for centre in self.centres:
            yield line(0j, centre, THICK)
            yield Circle(centre, HUB, NORMAL, "white")
        yield Circle(0j, 1.4 * HUB, NORMAL, "white")
        yield dot(0j)

    def _gap(self) -> Iterator[Item]:
        """The gap between the first two satellites; of two satellites it lies across the central wheels."""
        if self.found.satellites == 2:
            return
        one, other = self.centres[:2]
        along = (other - one) / abs(other - one)
        tip = max(self.radius("tip", crown) for crown in self.crowns)
        start, end = one + tip * along, other - tip * along
        yield line(start, end, THIN)
        yield Arrow(start - OUTSIDE * along, start, THIN, 2.0)
        yield Arrow(end + OUTSIDE * along, end, THIN, 2.0)

    def tags(self) -> Iterator[Tag]:
        given, found = self.found.given, self.found
        for name, wheel in ((given.names[0], 0), (given.names[-2], 3)):
            edge = self.radius("trimmed", wheel)
            yield Tag((name,), tuple(cmath.rect(edge, math.radians(a)) for a in (20, 160, 200, 340)))
        for name, crown in zip(given.crowns, self.crowns, strict=False):
            edge, centre = self.radius("tip", crown), self.centres[0]
            yield Tag((name,), tuple(centre + cmath.rect(edge, math.radians(a)) for a in (30, 150, 50, 130)))
        last = self.centres[-1]
        yield Tag((given.names[-1],), (0.5 * last, 0.65 * last, 0.35 * last))
        yield Tag((Symbol("a", "w"),), (0.5 * self.centres[0], 0.65 * self.centres[0]))
        if found.satellites > 2:
            middle = (self.centres[0] + self.centres[1]) / 2
            yield Tag((Symbol("Δ"),), (middle,))


def _hatched(radius: float) -> Path:
    """Strokes outside a circle that stands still."""
    count = max(24, round(2 * math.pi * radius / 4))
    feet = [cmath.rect(radius, 2 * math.pi * j / count) for j in range(count)]
    return Path(tuple((foot, foot + 2.0 * foot / radius * cmath.rect(1, 0.7)) for foot in feet), THIN)
