"""What is read off the drawing of a mesh, against what was computed."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator

from tmm_report.chapters.gears.spur.solve.mesh import Mesh
from tmm_report.quantity.paper import rounded
from tmm_report.records import dataclass

Read = Callable[[complex], complex]  # a place on paper as it is read, mm
SEGMENTS = (("A", "B"), ("A", "C"), ("C", "D"), ("D", "B"))


@dataclass(frozen=True)
class Reading:
    """A value read off the drawing against the computed one; lengths m, angles rad, ratios pure.

    `key`: N1N2, AB, AC, CD, DB, angle (of contact), pitch (angle of a tooth), ratio (of the two). `wheel` 0, 1 or None.
    """

    key: str
    wheel: int | None
    drawn: float
    computed: float

    @property
    def error(self) -> float:
        """Relative difference by the course's formula 2 (a − b)/(a + b), as a share of the mean; its size."""
        return 2 * abs(self.computed - self.drawn) / (abs(self.computed) + abs(self.drawn))


def read_off(mesh: Mesh, accuracy: float) -> tuple[Reading, ...]:
    """All that is read off a mesh; places are read to `accuracy`, m of paper."""

    def read(place: complex) -> complex:
        return complex(rounded(place, accuracy * 1e3))

    rows = [*_segments(mesh, read), *(row for i in (0, 1) for row in _angles(mesh, i, read))]
    return tuple(row for row in rows if abs(row.computed) > 1e-9)


def _segments(mesh: Mesh, read: Read) -> Iterator[Reading]:
    """Segments of the line of action."""
    at = {name: read(place) for name, place in mesh.points.items()}
    if mesh.seen("N1") and mesh.seen("N2"):
        yield Reading("N1N2", None, abs(at["N1"] - at["N2"]) / mesh.mm, float(mesh.pair.line))
    for start, end in SEGMENTS:
        drawn = abs(at[start] - at[end]) / mesh.mm
        yield Reading(start + end, None, drawn, abs(mesh.places[end] - mesh.places[start]))


def _angles(mesh: Mesh, i: int, read: Read) -> Iterator[Reading]:
    """Angle of contact and of a tooth of a wheel, and their ratio."""

    def angle(start: complex, end: complex) -> float:
        one, other = (read(place) - read(mesh.centre(i)) for place in (start, end))
        return abs(cmath.phase(other / one))

    crossing = mesh.on_working_circle
    contact = angle(crossing(i, mesh.place("A")), crossing(i, mesh.place("B")))
    pitch = angle(crossing(i), crossing(i, tooth=1))
    exact, ratio = 2 * math.pi / mesh.wheels[i].z, float(mesh.pair.eps)
    yield Reading("angle", i, contact, exact * ratio)
    yield Reading("pitch", i, pitch, exact)
    yield Reading("ratio", i, contact / pitch, ratio)
