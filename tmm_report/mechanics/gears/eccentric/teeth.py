"""The assembled eccentric mechanism with its teeth: each wheel turned so that it meshes, and the proof that it does.

    made = assemble(34, 136, 0.018, places, Cut(0.002, Rack()))
    proof(made).overlap                      # (meshes, positions), m²

The turns are computed, never fitted: a tooth of the sun lies on +x, each satellite's space faces the sun's tooth on the
line to its centre, and the ring's phase follows from the rolling of one satellite. A satellite whose belt of pitches is
not whole (`residue`) misses its ring by that part of a pitch and is set in the middle of its play.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.polygons import clearance, overlap
from tmm_report.mechanics.gears.eccentric.mechanism import ring_tip
from tmm_report.mechanics.gears.meshing import Rack
from tmm_report.mechanics.gears.tooth_outlines import Wheel, external, mating_turn, ring
from tmm_report.records import dataclass

Array = Any

COUNT = 12  # positions over a pitch


class Place(NamedTuple):
    """Where a satellite stands: `centre` from O1, m; angles rad; `residue` of its belt, pitches."""

    name: str
    teeth: int
    centre: complex
    phi1: float
    phi3: float
    residue: float


@dataclass(frozen=True, eq=False)
class Body:
    """A wheel in its place: `turn`: rad, where the sun's is 0; `rate`: rad turned for one of the sun."""

    name: str
    wheel: Wheel
    centre: complex
    turn: float
    rate: float

    def outline(self, sun_turn: Array = 0.0) -> Array:
        """The outline where the sun has turned by `sun_turn` with the axes stopped; (..., N), m."""
        return self.wheel.placed(self.centre, self.turn + self.rate * np.asarray(sun_turn))


@dataclass(frozen=True, eq=False)
class Assembly:
    sun: Body
    ring: Body
    satellites: tuple[Body, ...]


class Proof(NamedTuple):
    """Polygons of teeth over a full pitch: `meshes` (names of both wheels), `turn` of the sun (P,), rad; `overlap`
    (meshes, P), m², and `clearance` (meshes, P), m, nan where they overlap."""

    meshes: tuple[tuple[str, str], ...]
    turn: Array
    overlap: Array
    clearance: Array


@dataclass(frozen=True)
class Cut:
    """How the teeth are cut: module, normal backlash of a mesh, `tolerance` of the outlines (None: fine), m."""

    m: float
    rack: Rack
    backlash: float = 0.0
    tolerance: float | None = None

    @property
    def thinning(self) -> float:
        """The shift, modules, that takes half of the backlash off the thickness of a tooth."""
        return self.backlash / math.cos(self.rack.alpha) / (4 * self.m * math.tan(self.rack.alpha))

    def external(self, z: int) -> Wheel:
        tip = self.m * (z / 2 + self.rack.ha)
        return external(z, self.m, -self.thinning, self.rack, tip=tip, tolerance=self.tolerance)

    def ring(self, z: int, satellites: Sequence[int]) -> Wheel:
        """The ring, its tips cut down where they would touch the fillets of the satellites."""
        tip = ring_tip(z, np.array(satellites), self.m, self.rack)
        root = self.m * (z / 2 + self.rack.ha + self.rack.c)
        return ring(z, self.m, self.thinning, self.rack, tip=tip, root=root, tolerance=self.tolerance)


def assemble(sun: int, ring_teeth: int, e: float, places: Sequence[Place], cut: Cut) -> Assembly:
    """Sun "1" in 0, ring "3" in (e, 0), `e` in m, satellites in their places."""
    first, outer = cut.external(sun), cut.ring(ring_teeth, [place.teeth for place in places])
    wheels = {place.teeth: cut.external(place.teeth) for place in places}
    bodies = []
    for place in places:
        wheel = wheels[place.teeth]
        # half of the residue is left to the sun, half to the ring
        turn = float(mating_turn(first, wheel, 0.0, place.phi1)) - place.residue / 2 * wheel.pitch_angle
        bodies.append(Body(place.name, wheel, place.centre, turn, -sun / place.teeth))
    ring_turn = _ring_turn(first, outer, places[0], wheels[places[0].teeth])
    return Assembly(
        Body("1", first, 0j, 0.0, 1.0),
        Body("3", outer, complex(e), ring_turn, -sun / ring_teeth),
        tuple(bodies),
    )


def _ring_turn(sun: Wheel, outer: Wheel, place: Place, wheel: Wheel) -> float:
    """The ring's phase: by the satellite in full mesh with the sun, less the residue of that satellite."""
    meshing = float(mating_turn(sun, wheel, 0.0, place.phi1))
    turn = float(mating_turn(wheel, outer, meshing, place.phi3))
    return (turn - place.residue * outer.pitch_angle) % outer.pitch_angle


# --- the proof


def proof(made: Assembly, count: int = COUNT) -> Proof:
    """Every mesh, and every two satellites whose tip circles meet, at `count` positions over a pitch of the sun."""
    turns = made.sun.wheel.pitch_angle * np.arange(count) / count
    outlines = {body.name: body.outline(turns) for body in (made.sun, made.ring, *made.satellites)}
    names = [
        pair for body in made.satellites for pair in ((made.sun.name, body.name), (body.name, made.ring.name))
    ]
    names += _crowded(made.satellites)
    pairs = [
        list(zip(outlines[one], outlines[other], [other == made.ring.name] * count, strict=True))
        for one, other in names
    ]
    shared = np.array([[overlap(*pair) for pair in row] for row in pairs])
    # teeth that overlap have no clearance, and the depth of thousands of crossings takes long
    free = [
        [clearance(*pair) if area == 0 else np.nan for pair, area in zip(row, areas, strict=True)]
        for row, areas in zip(pairs, shared, strict=True)
    ]
    return Proof(tuple(names), turns, shared, np.array(free))


def _crowded(bodies: Sequence[Body]) -> list[tuple[str, str]]:
    return [
        (one.name, other.name)
        for i, one in enumerate(bodies)
        for other in bodies[i + 1 :]
        if abs(one.centre - other.centre) <= one.wheel.tip + other.wheel.tip
    ]
