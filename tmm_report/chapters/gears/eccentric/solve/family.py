"""The family of sets of an eccentric epicyclic mechanism: all of them judged, one chosen, or why none can be."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.given import Given
from tmm_report.chapters.gears.eccentric.solve import mistakes
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.pair_sizes import least_teeth
from tmm_report.problems import ProblemError
from tmm_report.records import dataclass

Array = Any

COMMON_RING = 200  # teeth: larger rings are not looked at unless the ratio asks for them
LARGEST_RING = 2000  # teeth: none is looked for beyond
TURNS = np.array([1, 1, 1, -1])  # the second middle satellite stands below the axis


@dataclass(frozen=True, eq=False)
class Judged:
    """The family with its conditions. In the order of KINDS (T, 4): `phi1`, `phi3` rad, `belt` and `residue` pitches,
    `root` and `tips` in hand against interference in the ring, m, `allowed`: each satellite by itself; `fit`: those
    that go together. `gap` (T, 4, 4): free between tip circles, m; `closed` (T,): by the closed form, m. `by_middle`
    (T,): the middle satellites are assembled with one another, and the residues are those over one of them."""

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
    by_middle: Array

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

    def sound(self, least_sun: int) -> int | None:
        """The most compact of the sets that hold most satellites round a sun of enough teeth; None: none holds any."""
        held = np.where(self.family.sun >= least_sun, self.held, 0)
        return int(np.flatnonzero(held == held.max())[-1]) if held.max() else None

    def loose(self, slack: float) -> Array:
        """Places of the sets whose middle satellites are whole but leave a residue over `slack`, pitches."""
        middle = ecc.KINDS.index("middle")
        whole = self.family.satellites[:, middle] % 1 == 0  # of half a tooth there is none to assemble
        return np.flatnonzero(whole & (np.abs(self.residue[:, middle]) > slack))

    def replaced(self, clearance: float) -> Array:
        """Places of the sets in which the smallest satellite must stand in place of the largest."""
        middle, smallest = ecc.KINDS.index("middle"), ecc.KINDS.index("smallest")
        crowded = self.allowed[:, middle] & (self.closed <= clearance)
        return np.flatnonzero(crowded & self.fit[:, middle] & self.fit[:, smallest])

    @property
    def full(self) -> int | None:
        """The most compact set that holds all four; None where there is none."""
        return self.best if self.held.max() == len(ecc.KINDS) else None


def sizes(given: Given) -> tuple[Fraction, int]:
    """u = z3/z1 and E = 2e/m, from the teeth where they are given."""
    if given.teeth is None:
        assert given.ratio is not None  # mistakes.check
        return given.ratio, round(mistakes.halves(given))
    sun, *largest, ring = given.teeth
    E = 2 * largest[0] + sun - ring if largest else round(mistakes.halves(given))
    return Fraction(ring, sun), E


def halved(given: Given, u: Fraction, E: int) -> bool:
    """Whether the largest and the smallest satellites have half a tooth, and the family is that of the middle ones."""
    if given.teeth is not None:
        return (given.teeth[-1] - given.teeth[0] + E) % 2 == 1
    return ecc.general_solution(ecc.equation(u, E)) is None


def impossible(given: Given, u: Fraction, E: int) -> bool:
    """Whether no set has a whole largest satellite, and the middle ones alone are not asked for."""
    return given.teeth is None and set(given.satellites or ()) != {"middle"} and halved(given, u, E)


def teeth_equation(given: Given, u: Fraction, E: int) -> tuple[ecc.Equation, ecc.Solution]:
    """Of the largest satellite, or of the middle one where the largest has half a tooth, with its solution."""
    equation = ecc.middle_equation(u) if halved(given, u, E) else ecc.equation(u, E)
    solution = ecc.general_solution(equation)
    assert solution is not None  # that of the middle satellite always has one
    return equation, solution


def members(given: Given, solution: ecc.Solution, u: Fraction, E: int, most: int) -> ecc.Family:
    """The sets from the largest ring looked at down to the smallest sun without undercut, where there is room."""
    least = least_teeth(given.rack)
    if given.teeth is not None:
        least, most = min(least, given.teeth[0]), max(most, given.teeth[-1])
    found = ecc.family(solution, u, E, ecc.range_of(solution, u, least, most), halved(given, u, E))
    room = found.satellites[:, ecc.KINDS.index("smallest")] >= mistakes.FEWEST
    return ecc.Family(*(part[room] for part in found))


def most_ring(given: Given, u: Fraction) -> int:
    """The largest ring looked at."""
    return given.ring_up_to or max(COMMON_RING, math.ceil(2 * least_teeth(given.rack) * u))


def judge(given: Given, u: Fraction, E: int, family: ecc.Family) -> Judged:
    """Every set of the family against all the conditions, as arrays."""
    m, rack = given.module, given.rack
    sun, ring, z = family.sun[:, None], family.ring[:, None], family.satellites
    phi1, phi3 = ecc.angles(sun, ring, E, z)
    whole = z[:, :1] == np.round(z[:, :1])
    over = [ecc.belt(sun, ring, first, z, phi1, phi3) for first in (z[:, :1], -ring)]
    gap = ecc.gaps(family.sun, z, TURNS * phi1, m, rack.ha)
    root, tips = ecc.root_in_hand(ring, z, m, rack), ecc.tips_in_hand(ring, z, m, rack)
    sound = (z == np.round(z)) & (z >= least_teeth(rack)) & (root >= 0) & (tips >= 0)
    close = [sound & (np.abs(ecc.residue(belt)) <= given.slack) for belt in over]
    fits = [ecc.subsets(gap, allowed, given.clearance) for allowed in close]
    more = fits[1].sum(axis=-1, keepdims=True) > fits[0].sum(axis=-1, keepdims=True)
    by_middle = ~whole | more
    belt, allowed, fit = (np.where(by_middle, two, one) for one, two in (over, close, fits))
    closed = ecc.closed_gap(family.sun, family.ring, E * m / 2, m, rack.ha)
    residue = ecc.residue(belt)
    return Judged(family, phi1, phi3, belt, residue, gap, closed, root, tips, allowed, fit, by_middle[:, 0])


def chosen(given: Given, judged: Judged, u: Fraction, E: int, solution: ecc.Solution) -> int:
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
    most = most_ring(given, u)
    # an eccentricity of E halves of a module needs a ring over E teeth
    nearest = range(min(E, most) - 1, 0, -1)
    smaller = next((n for n in nearest if len(_good_rings(given, u, n, most))), None)
    rings = _good_rings(given, u, E, LARGEST_RING)
    return mistakes.nothing_fits(given, E, most, smaller, int(rings[-1]) if len(rings) else None)


def _good_rings(given: Given, u: Fraction, E: int, most: int) -> Array:
    """The rings, descending, of the sets that hold two satellites."""
    if impossible(given, u, E):
        return np.array([])
    _, solution = teeth_equation(given, u, E)
    judged = judge(given, u, E, members(given, solution, u, E, most))
    return judged.family.ring[judged.held >= 2]
