"""The satellites of the chosen set, as they are assembled, and how they stand beside each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.given import Given
from tmm_report.chapters.gears.eccentric.solve import mistakes
from tmm_report.chapters.gears.eccentric.solve.family import Judged
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.pair_sizes import least_teeth
from tmm_report.records import dataclass

Array = Any

WHEELS = dict(zip(ecc.KINDS, ("2", "4", "5", "4'"), strict=True))


@dataclass(frozen=True)
class Satellite:
    """An assembled satellite: `wheel` its number in the drawings, `kind` of KINDS or "" for any other. `arm`: from the
    axis of the sun, m; `curvature`: of its flank where the tip of a ring of full height touches it, m."""

    wheel: str
    kind: str
    teeth: int
    phi1: float
    phi3: float
    belt: float
    residue: float
    centre: complex
    curvature: float

    @property
    def arm(self) -> float:
        return abs(self.centre)

    @property
    def below(self) -> bool:
        """Whether it mirrors another above the axis."""
        return self.wheel.endswith("'")


@dataclass(frozen=True)
class Neighbours:
    """Two satellites side by side: `distance` of their axes and `gap` between their tip circles, m."""

    one: Satellite
    other: Satellite
    distance: float
    gap: float

    @property
    def wheels(self) -> str:
        return f"{self.one.wheel}–{self.other.wheel}"


def satellites(given: Given, judged: Judged, row: int, E: int) -> tuple[Satellite, ...]:
    """Those asked for, or the largest set of all that touch both wheels.

    The line of assembly goes over the largest satellite; over a middle one where neither the largest nor the smallest
    is mounted, for then only the others have to agree with one another.
    """
    sun, ring = int(judged.family.sun[row]), int(judged.family.ring[row])
    ways = [by_middle for by_middle in (False, True) if by_middle or (ring - sun + E) % 2 == 0]
    ways = [way for way in ways if not way or (ring - sun) % 2 == 0]
    found = [_picked(given, sun, ring, E, by_middle) for by_middle in ways]
    if not any(picked for _, picked in found):
        kinds = set(_kinds(found[0][0], sun, ring, E))
        raise mistakes.no_satellite(given, judged.family, judged.sound(least_teeth(given.rack)), kinds)
    best = max(range(len(ways)), key=lambda k: (len(found[k][1]), -k))
    return tuple(_named(*found[best], ways[best], sun, ring, E, given))


def _picked(given: Given, sun: int, ring: int, E: int, by_middle: bool) -> tuple[ecc.Candidates, list[int]]:
    """All that touch both wheels, and which of them are taken."""
    all_ = ecc.candidates(sun, ring, E, by_middle)
    if given.satellites is not None:
        axial = {"largest", "smallest"} & set(given.satellites)
        if bool(axial) == by_middle:  # the line goes over what is mounted
            return all_, []
        wanted = {*given.satellites, *(["middle'"] if "middle" in given.satellites else [])}
        return all_, [i for i, kind in enumerate(_kinds(all_, sun, ring, E)) if kind in wanted]
    allowed = _allowed(given, all_, ring)
    if by_middle:
        allowed &= ~np.isin(2 * all_.z, (ring - sun + E, ring - sun - E))
    alone = np.flatnonzero(allowed)
    gap = ecc.gaps(np.array(sun), all_.z[alone], all_.phi1[alone], given.module, given.rack.ha)
    return all_, [int(alone[i]) for i in ecc.largest_set(gap, given.clearance)]


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
    all_: ecc.Candidates, picked: list[int], by_middle: bool, sun: int, ring: int, E: int, given: Given
) -> Iterator[Satellite]:
    kinds = _kinds(all_, sun, ring, E)
    numbers = _numbers([(int(all_.z[i]), kinds[i], all_.phi1[i] <= np.pi) for i in picked])
    first = -ring if by_middle else int(all_.z[0])
    for i, wheel in zip(picked, numbers, strict=True):
        z, phi1, phi3 = int(all_.z[i]), float(all_.phi1[i]), float(all_.phi3[i])
        belt = float(ecc.belt(sun, ring, first, z, phi1, phi3))
        centre = complex(ecc.centres(sun, z, phi1, given.module))
        curvature = float(ecc.root_in_hand(ring, z, given.module, given.rack))
        yield Satellite(wheel, kinds[i], z, phi1, phi3, belt, float(all_.residue[i]), centre, curvature)


def _numbers(wheels: list[tuple[int, str, bool]]) -> list[str]:
    """2, 4, 5 for the known kinds, then 6, 7, … by the teeth; a stroke for the one below the axis."""
    others = sorted({z for z, kind, _ in wheels if not kind}, reverse=True)
    return [WHEELS.get(kind) or f"{6 + others.index(z)}{'' if up else chr(39)}" for z, kind, up in wheels]


def neighbours(given: Given, sun: int, all_: tuple[Satellite, ...]) -> tuple[Neighbours, ...]:
    """Every two satellites that stand side by side."""
    pairs = list(zip(all_, (*all_[1:], all_[0]), strict=True)) if len(all_) > 2 else [all_] * (len(all_) - 1)
    return tuple(_beside(given, sun, one, other) for one, other in pairs)


def _beside(given: Given, sun: int, one: Satellite, other: Satellite) -> Neighbours:
    z, phi = np.array([one.teeth, other.teeth]), np.array([one.phi1, other.phi1])
    gap = ecc.gaps(np.array(sun), z, phi, given.module, given.rack.ha)[0, 1]
    distance = ecc.distance(np.array(sun), z[0], z[1], phi[0] - phi[1], given.module)
    return Neighbours(one, other, float(distance), float(gap))


def unmirrored(pairs: tuple[Neighbours, ...]) -> tuple[Neighbours, ...]:
    """Without the pairs that mirror another; the first of each is that of the smaller angle."""
    seen: dict[frozenset[str], Neighbours] = {}
    for pair in pairs:
        seen.setdefault(frozenset(s.wheel.rstrip("'") for s in (pair.one, pair.other)), pair)
    return tuple(
        pair if pair.one.phi1 < pair.other.phi1 else Neighbours(pair.other, pair.one, pair.distance, pair.gap)
        for pair in seen.values()
    )
