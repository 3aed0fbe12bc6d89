"""Chapter of the eccentric epicyclic mechanism: teeth by the Diophantine equation, the family, one set assembled.

Sun 1 and ring 3 turn about parallel axes at the distance e; the satellites between them differ in size: 2 the largest,
4 and 4' the middle ones, 5 the smallest. The arithmetic and its sources are in mechanics/eccentric.py.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters import eccentric_mistakes as mistakes
from tmm_report.chapters.spur import STANDARD, Condition
from tmm_report.mechanics import eccentric as ecc
from tmm_report.mechanics import eccentric_teeth as toothed
from tmm_report.mechanics.spur import Rack
from tmm_report.mechanics.trains import Member, Mesh, Train, speeds
from tmm_report.problems import ProblemError
from tmm_report.problems import N_, Message

Array = Any

SUN, RING, CARRIER = "1", "3", "H"
WHEELS = dict(zip(ecc.KINDS, ("2", "4", "5", "4'"), strict=True))
COMMON_RING = 200  # teeth: larger rings are not looked at unless the ratio asks for them
LARGEST_RING = 2000  # teeth: none is looked for beyond
TURNS = np.array([1, 1, 1, -1])  # the second middle satellite stands below the axis


@dataclass(frozen=True, eq=False)
class Given:
    """What is stated; lengths in m, `speed` in rad/s.

    `ratio`: z3/z1, a magnitude; `teeth`: sun and ring, or sun, largest satellite and ring, in place of choosing them;
    `clearance`: δ between the tip circles of neighbours; `backlash`: normal, of every mesh; `t`: the set of the family,
    None: the most compact of those that hold most satellites; `satellites`: which of KINDS, None: as many as fit;
    `most_ring`: largest ring looked at; `speed`: of the input.
    """

    module: float
    ratio: Fraction | None = None
    eccentricity: float | None = None
    teeth: tuple[int, ...] | None = None
    rack: Rack = STANDARD
    clearance: float = 0.0
    backlash: float = 0.0
    t: int | None = None
    satellites: tuple[str, ...] | None = None
    most_ring: int | None = None
    speed: float | None = None
    name: str = ""

    @property
    def slack(self) -> float:
        """The residue of assembly that the backlash takes up, pitches: half a backlash in each of two meshes."""
        pitch = math.pi * self.module
        return self.backlash / math.cos(self.rack.alpha) / pitch + ecc.EXACT


@dataclass(frozen=True, eq=False)
class Judged:
    """The family with its conditions. In the order of KINDS (T, 4): `phi1`, `phi3` rad, `belt` and `residue` pitches,
    `root` and `tips` in hand against interference in the ring, m, `allowed`: each satellite by itself; `fit`: those
    that go together. `gap` (T, 4, 4): free between tip circles, m; `closed` (T,): by the closed form, m."""

    family: ecc.Family
    phi1: Array
    phi3: Array
    belt: Array
    residue: Array
    gap: Array
    closed: Array
    root: Array
    tips: Array
    allowed: Array
    fit: Array

    @property
    def held(self) -> Array:
        """How many satellites each set holds, (T,)."""
        return self.fit.sum(axis=-1)

    def row(self, t: int) -> int | None:
        """The place of a number t in the family."""
        found = np.flatnonzero(self.family.t == t)
        return int(found[0]) if len(found) else None

    @property
    def best(self) -> int:
        """The most compact of the sets that hold most satellites."""
        return int(np.flatnonzero(self.held == self.held.max())[-1])

    @property
    def full(self) -> int | None:
        """The most compact set that holds all four; None where there is none."""
        return self.best if self.held.max() == len(ecc.KINDS) else None


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
    judged = judge(given, u, E, _members(given, solution, u, E, _most_ring(given, u)))
    row = _chosen(given, judged, u, E, solution)
    return Found(given, u, E, equation, solution, judged, row, _satellites(given, judged, row, E))


def sizes(given: Given) -> tuple[Fraction, int]:
    """u = z3/z1 and E = 2e/m, from the teeth where they are given."""
    if given.teeth is None:
        assert given.ratio is not None  # mistakes.check
        return given.ratio, round(mistakes.halves(given))
    sun, *largest, ring = given.teeth
    E = 2 * largest[0] + sun - ring if largest else round(mistakes.halves(given))
    return Fraction(ring, sun), E


def _members(given: Given, solution: ecc.Solution, u: Fraction, E: int, most: int) -> ecc.Family:
    """The sets from the largest ring looked at down to the smallest sun without undercut, where there is room."""
    least = ecc.least_teeth(given.rack)
    if given.teeth is not None:
        least, most = min(least, given.teeth[0]), max(most, given.teeth[-1])
    found = ecc.family(solution, u, E, ecc.range_of(solution, u, least, most))
    room = found.satellites[:, ecc.KINDS.index("smallest")] >= mistakes.FEWEST
    return ecc.Family(*(part[room] for part in found))


def _most_ring(given: Given, u: Fraction) -> int:
    """The largest ring looked at."""
    return given.most_ring or max(COMMON_RING, math.ceil(2 * ecc.least_teeth(given.rack) * u))


def judge(given: Given, u: Fraction, E: int, family: ecc.Family) -> Judged:
    """Every set of the family against all the conditions, as arrays."""
    m, rack = given.module, given.rack
    sun, ring, z = family.sun[:, None], family.ring[:, None], family.satellites
    phi1, phi3 = ecc.angles(sun, ring, E, z)
    belt = ecc.belt(sun, ring, z[:, :1], z, phi1, phi3)
    residue = ecc.residue(belt)
    gap = ecc.gaps(family.sun, z, TURNS * phi1, m, rack.ha)
    root, tips = ecc.root_in_hand(ring, z, m, rack), ecc.tips_in_hand(ring, z, m, rack)
    allowed = (z == np.round(z)) & (z >= ecc.least_teeth(rack)) & (np.abs(residue) <= given.slack)
    allowed &= (root >= 0) & (tips >= 0)
    closed = ecc.closed_gap(family.sun, family.ring, E * m / 2, m, rack.ha)
    fit = ecc.subsets(gap, allowed, given.clearance)
    return Judged(family, phi1, phi3, belt, residue, gap, closed, root, tips, allowed, fit)


def _chosen(given: Given, judged: Judged, u: Fraction, E: int, solution: ecc.Solution) -> int:
    """The set asked for by its teeth or its t; else the best of the family."""
    if not len(judged.family.t) or (given.t is None and given.teeth is None and judged.held.max() < 2):
        raise _hopeless(given, judged, u, E)
    t = given.t
    if given.teeth is not None:
        t = (solution.first - given.teeth[0]) // solution.b1
    row = judged.best if t is None else judged.row(t)
    if row is None:
        raise mistakes.not_in_family(t or 0, judged.family.t)
    return row


def _hopeless(given: Given, judged: Judged, u: Fraction, E: int) -> ProblemError:
    """No set holds two satellites: what data near these would do is tried out."""
    both = judged.allowed[:, :, None] & judged.allowed[:, None, :] & ~np.eye(len(ecc.KINDS), dtype=bool)
    widest = float(np.max(judged.gap, initial=-np.inf, where=both))
    if 0 < widest <= given.clearance:
        return mistakes.too_wide(given, widest)
    most = _most_ring(given, u)
    smaller = next((n for n in range(E - 1, 0, -1) if len(_good_rings(given, u, n, most))), None)
    rings = _good_rings(given, u, E, LARGEST_RING)
    return mistakes.nothing_fits(given, E, most, smaller, int(rings[-1]) if len(rings) else None)


def _good_rings(given: Given, u: Fraction, E: int, most: int) -> Array:
    """The rings, descending, of the sets that hold two satellites."""
    solution = ecc.general_solution(ecc.equation(u, E))
    if solution is None:
        return np.array([])
    judged = judge(given, u, E, _members(given, solution, u, E, most))
    return judged.family.ring[judged.held >= 2]


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
    return tuple(_named(all_, picked, kinds, sun, ring, given.module))


def _allowed(given: Given, all_: ecc.Candidates, ring: int) -> Array:
    m, rack = given.module, given.rack
    fine = (all_.z >= ecc.least_teeth(rack)) & (np.abs(all_.residue) <= given.slack)
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
        yield Condition("undercut", wheel, z, ecc.least_teeth(rack))
    for s in found.satellites:
        yield Condition("root", s.wheel, float(ecc.root_in_hand(found.ring, s.teeth, m, rack)), 0.0, "mm")
        yield Condition("fouling", s.wheel, float(ecc.tips_in_hand(found.ring, s.teeth, m, rack)), 0.0, "mm")
