"""Chapter of the eccentric epicyclic mechanism: teeth by the Diophantine equation, the family, one set assembled.

Sun 1 and ring 3 turn about parallel axes at the distance e; the satellites between them differ in size: 2 the largest,
4 and 4' the middle ones, 5 the smallest. The arithmetic and its sources are in mechanics/eccentric.py.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.eccentric import mistakes
from tmm_report.chapters.eccentric.family import Given, Judged, chosen, judge, members, most_ring, sizes
from tmm_report.mechanics import eccentric as ecc
from tmm_report.mechanics import eccentric_teeth as toothed
from tmm_report.mechanics.conditions import Condition
from tmm_report.mechanics.trains import Member, Mesh, Train, speeds
from tmm_report.mechanics.wheels import least_teeth
from tmm_report.problems import N_, Message

Array = Any

SUN, RING, CARRIER = "1", "3", "H"
WHEELS = dict(zip(ecc.KINDS, ("2", "4", "5", "4'"), strict=True))


@dataclass(frozen=True)
class Satellite:
    """An assembled satellite: `wheel` its number in the drawings, `kind` of KINDS or "" for any other."""

    wheel: str
    kind: str
    teeth: int
    phi1: float
    phi3: float
    belt: float
    residue: float
    centre: complex


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `E` = 2e/m; `row`: the chosen set in `judged`; `satellites`: as assembled, by ascending φ1."""

    given: Given
    ratio_of_teeth: Fraction
    E: int
    equation: ecc.Equation
    solution: ecc.Solution
    judged: Judged
    row: int
    satellites: tuple[Satellite, ...]

    @property
    def e(self) -> float:
        """The eccentricity, m."""
        return self.E * self.given.module / 2

    @property
    def t(self) -> int:
        return int(self.judged.family.t[self.row])

    @property
    def sun(self) -> int:
        return int(self.judged.family.sun[self.row])

    @property
    def ring(self) -> int:
        return int(self.judged.family.ring[self.row])

    @property
    def largest(self) -> int:
        """Teeth of the largest satellite of the set, assembled or not."""
        return int(self.judged.family.satellites[self.row, 0])

    @property
    def ratio(self) -> float:
        """ω1/ω3 with the axes stopped: the wheels turn in opposite senses."""
        return -float(self.ratio_of_teeth)

    @cached_property
    def neighbours(self) -> tuple[tuple[Satellite, Satellite, float], ...]:
        """Every two satellites that stand side by side and the free distance between their tip circles, m."""
        all_ = self.satellites
        pairs = (
            list(zip(all_, (*all_[1:], all_[0]), strict=True)) if len(all_) > 2 else [all_] * (len(all_) - 1)
        )
        return tuple((a, b, self.gap(a, b)) for a, b in pairs)

    def gap(self, one: Satellite, other: Satellite) -> float:
        """Free distance between the tip circles of two satellites, m."""
        z, phi = np.array([one.teeth, other.teeth]), np.array([one.phi1, other.phi1])
        return float(ecc.gaps(np.array(self.sun), z, phi, self.given.module, self.given.rack.ha)[0, 1])

    @cached_property
    def conditions(self) -> tuple[Condition, ...]:
        return tuple(_conditions(self))

    @property
    def failed(self) -> tuple[Condition, ...]:
        return tuple(condition for condition in self.conditions if not condition.met)

    def summary(self) -> list[Message]:
        """The main numbers in a sentence."""
        text = N_(
            "eccentric epicyclic mechanism: sun %(sun)s, largest satellite %(largest)s, ring %(ring)s teeth; "
            "satellites mounted: %(count)s; conditions not met: %(failed)s"
        )
        values = {"sun": self.sun, "largest": self.largest, "ring": self.ring}
        return [Message(text, values | {"count": len(self.satellites), "failed": len(self.failed)})]

    def assembled(self, tolerance: float | None = None) -> toothed.Assembly:
        """The wheels with their teeth, turned so that they mesh; `tolerance` of the outlines, m."""
        given = self.given
        places = [
            toothed.Place(s.wheel, s.teeth, s.centre, s.phi1, s.phi3, s.residue) for s in self.satellites
        ]
        cut = toothed.Cut(given.module, given.rack, given.backlash, tolerance)
        return toothed.assemble(self.sun, self.ring, self.e, places, cut)

    @cached_property
    def proof(self) -> toothed.Proof:
        """Overlaps and clearances of the polygons of teeth over a full pitch."""
        return toothed.proof(self.assembled())

    @cached_property
    def train(self) -> Train:
        """Sun, ring, satellites of the four kinds and the body H that carries all the axes."""
        m = self.given.module / 2
        bodies = [
            Member(s.wheel, "satellite", s.teeth, m * s.teeth, carried_by=CARRIER) for s in self.satellites
        ]
        members = (
            Member(SUN, "wheel", self.sun, m * self.sun),
            Member(RING, "ring", self.ring, m * self.ring),
            *bodies,
            Member(CARRIER, "carrier"),
        )
        meshes = [Mesh(SUN, body.name, CARRIER) for body in bodies]
        meshes += [Mesh(body.name, RING, CARRIER, internal=True) for body in bodies]
        return Train(members, tuple(meshes))

    def speeds(self, stopped: str, driven: str) -> dict[str, float]:
        """Speeds of all members, rad/s, with one stopped and `driven` turning at the given speed."""
        known = {stopped: 0.0, driven: self.given.speed or 1.0}
        return {name: float(value) for name, value in speeds(self.train, known).items()}


def solve(given: Given) -> Found:
    """Raises ProblemError with the mistakes of the data and what would work."""
    mistakes.check(given)
    u, E = sizes(given)
    equation = ecc.equation(u, E)
    solution = ecc.general_solution(equation)
    if solution is None:
        raise mistakes.no_solution(u, E, given.module)
    judged = judge(given, u, E, members(given, solution, u, E, most_ring(given, u)))
    row = chosen(given, judged, u, E, solution)
    return Found(given, u, E, equation, solution, judged, row, _satellites(given, judged, row, E))


# ---------------------------------------------------------------- the satellites of the chosen set


def _satellites(given: Given, judged: Judged, row: int, E: int) -> tuple[Satellite, ...]:
    """Those asked for, or the largest set of all that touch both wheels."""
    sun, ring = int(judged.family.sun[row]), int(judged.family.ring[row])
    all_ = ecc.candidates(sun, ring, E)
    kinds = _kinds(all_, sun, ring, E)
    if given.satellites is not None:
        wanted = {*given.satellites, *(["middle'"] if "middle" in given.satellites else [])}
        picked = [i for i, kind in enumerate(kinds) if kind in wanted]
    else:
        alone = np.flatnonzero(_allowed(given, all_, ring))
        gap = ecc.gaps(np.array(sun), all_.z[alone], all_.phi1[alone], given.module, given.rack.ha)
        picked = [int(alone[i]) for i in ecc.largest_set(gap, given.clearance)]
    if not picked:
        raise mistakes.no_satellite(given, judged.family, judged.sound(least_teeth(given.rack)), set(kinds))
    return tuple(_named(all_, picked, kinds, sun, ring, given.module))


def _allowed(given: Given, all_: ecc.Candidates, ring: int) -> Array:
    m, rack = given.module, given.rack
    fine = (all_.z >= least_teeth(rack)) & (np.abs(all_.residue) <= given.slack)
    return (
        fine & (ecc.root_in_hand(ring, all_.z, m, rack) >= 0) & (ecc.tips_in_hand(ring, all_.z, m, rack) >= 0)
    )


def _kinds(all_: ecc.Candidates, sun: int, ring: int, E: int) -> list[str]:
    """Which of KINDS each candidate is; "" for the others."""
    above = all_.phi1 <= np.pi
    names = {ring - sun + E: "largest", ring - sun - E: "smallest", ring - sun: "middle"}
    return [
        names.get(2 * int(z), "") + ("" if up or 2 * z != ring - sun else "'")
        for z, up in zip(all_.z, above, strict=True)
    ]


def _named(
    all_: ecc.Candidates, picked: list[int], kinds: list[str], sun: int, ring: int, m: float
) -> Iterator[Satellite]:
    numbers = _numbers([(int(all_.z[i]), kinds[i], all_.phi1[i] <= np.pi) for i in picked])
    largest = int(all_.z[0])
    for i, wheel in zip(picked, numbers, strict=True):
        z, phi1, phi3 = int(all_.z[i]), float(all_.phi1[i]), float(all_.phi3[i])
        belt = float(ecc.belt(sun, ring, largest, z, phi1, phi3))
        centre = complex(ecc.centres(sun, z, phi1, m))
        yield Satellite(wheel, kinds[i], z, phi1, phi3, belt, float(all_.residue[i]), centre)


def _numbers(wheels: list[tuple[int, str, bool]]) -> list[str]:
    """2, 4, 5 for the known kinds, then 6, 7, … by the teeth; a stroke for the one below the axis."""
    others = sorted({z for z, kind, _ in wheels if not kind}, reverse=True)
    return [WHEELS.get(kind) or f"{6 + others.index(z)}{'' if up else chr(39)}" for z, kind, up in wheels]


# ---------------------------------------------------------------- conditions of the chosen set


def _conditions(found: Found) -> Iterator[Condition]:
    given, m, rack = found.given, found.given.module, found.given.rack
    for s in found.satellites:
        yield Condition("assembly", s.wheel, abs(s.residue), given.slack - ecc.EXACT, least=False)
    for one, other, free in found.neighbours:
        yield Condition("neighbourhood", f"{one.wheel}–{other.wheel}", free, given.clearance, "mm")
    apart = float(ecc.tips_apart(found.sun, found.ring, found.e, m, rack.ha))
    yield Condition("tips", f"{SUN}–{RING}", apart, 0.0, "mm")
    for wheel, z in {SUN: found.sun, **{s.wheel: s.teeth for s in found.satellites}}.items():
        yield Condition("undercut", wheel, z, least_teeth(rack))
    for s in found.satellites:
        yield Condition("root", s.wheel, float(ecc.root_in_hand(found.ring, s.teeth, m, rack)), 0.0, "mm")
        yield Condition("fouling", s.wheel, float(ecc.tips_in_hand(found.ring, s.teeth, m, rack)), 0.0, "mm")
