"""Conditions on the teeth of a compound train: coaxiality, assembly, neighbourhood, interference in internal meshes.

Teeth are numbers or arrays (...) by the names of the wheels, so that a set is judged as a million of them are. Lengths
are in the unit of the modules, which are 1 where none is stated. Source: Kudryavtsev, Planetary gearing, ch. 2; of the
assembly Müller, Epicyclic drive trains, ch. 5, for a chain of satellites of any length.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from itertools import combinations
from typing import Any

import numpy as np

from tmm_report.mechanics.gears.compound.rows import Link, Row, body_of, satellites, sign
from tmm_report.mechanics.gears.trains import Train
from tmm_report.records import dataclass

Array = Any
ALPHA = math.radians(20)  # of the standard rack, whose ha* is 1
TIP = 1.0


def axes(train: Train) -> dict[str, str]:
    """The axis of each member, by the name of a body on it: a shaft is one axis, and so are a carrier and all that its
    satellites mesh with that it does not carry."""
    carried = satellites(train)
    found = {member.body: member.body for member in train.members}

    def root(body: str) -> str:
        while found[body] != body:
            body = found[body]
        return body

    for mesh in train.meshes:
        if mesh.carrier:
            carrier = body_of(train, mesh.carrier)
            for name in (mesh.i, mesh.j):
                body = body_of(train, name)
                if carried.get(body) != carrier:
                    found[root(body)] = root(carrier)
    return {member.name: root(member.body) for member in train.members}


@dataclass(frozen=True)
class Coaxial:
    """Meshes, by their places, between the same two axes: their centre distances must be equal."""

    first: int
    other: int


def coaxial_pairs(train: Train, flat: Sequence[bool]) -> tuple[Coaxial, ...]:
    """Every mesh with the first one between the same axes. `flat`: of each mesh, whether its axes are parallel."""
    of = axes(train)
    seen: dict[frozenset[str], int] = {}
    found = []
    for k, mesh in enumerate(train.meshes):
        between = frozenset((of[mesh.i], of[mesh.j]))
        if flat[k] and len(between) == 2:
            first = seen.setdefault(between, k)
            found += [Coaxial(first, k)] if first != k else []
    return tuple(found)


def twice_distance(train: Train, k: int, teeth: Mapping[str, Array], module: float = 1.0) -> Array:
    """2 a_w of a mesh without shift: m (z_i + z_j), of an internal one the difference, (...)."""
    mesh = train.meshes[k]
    one, other = teeth[mesh.i], teeth[mesh.j]
    return module * (np.abs(other - one) if mesh.internal else one + other)


def groups_of(train: Train, rows: Sequence[Row]) -> Iterator[Row]:
    """Of the rows on carriers, those between every two central members: of three, also that between the last two."""
    moving = [row for row in rows if row.carrier]
    yield from moving
    for one, other in combinations(moving, 2):
        if (one.a, one.carrier) == (other.a, other.carrier):
            common = 0
            while one.links[common : common + 1] == other.links[common : common + 1]:
                common += 1
            back = Row(one.a, one.b, one.carrier, one.links[common:]).turned()
            yield Row(one.b, other.b, one.carrier, (*back.links, *other.links[common:]))


def assembly_number(train: Train, row: Row, teeth: Mapping[str, Array], k: Array) -> Array:
    """C, whole where k equal satellites, or chains of them, can be put in at equal angles, (...).

    With the carrier stopped wheel a turns by 1/k of a turn, b by r/k, r = ω_b/ω_a; every satellite may be put in turned
    by a pitch at each of its meshes. C = |Πz_j − s Πz_i|/(k D), D the greatest common divisor of what a pitch at each
    mesh turns wheel b by, in the same parts; of a chain of single crowns (z_a ± z_b)/k.
    """
    above, below = _products(row.links, teeth)
    count = len(row.links)
    pitches = [
        reduce(np.multiply, [*_j(row.links[:m], teeth), *_i(row.links[m + 1 :], teeth)], np.int64(1))
        for m in range(count)
    ]
    return np.abs(below - sign(train, row) * above) / (k * reduce(np.gcd, pitches))


def _i(links: Sequence[Link], teeth: Mapping[str, Array]) -> list[Array]:
    return [np.asarray(teeth[link.i], dtype=np.int64) for link in links]


def _j(links: Sequence[Link], teeth: Mapping[str, Array]) -> list[Array]:
    return [np.asarray(teeth[link.j], dtype=np.int64) for link in links]


def _products(links: Sequence[Link], teeth: Mapping[str, Array]) -> tuple[Array, Array]:
    return reduce(np.multiply, _i(links, teeth)), reduce(np.multiply, _j(links, teeth))


def assembles(train: Train, rows: Sequence[Row], teeth: Mapping[str, Array], k: Array) -> Array:
    """Whether every row on a carrier can be assembled, (...): pairwise is enough, for the turns at which a satellite
    fits a wheel are cosets of one cyclic group."""
    found: Array = np.bool_(True)
    for row in groups_of(train, rows):
        number = assembly_number(train, row, teeth, k)
        found = found & (np.abs(number - np.rint(number)) < 1e-9)
    return found


@dataclass(frozen=True)
class Crowd:
    """The satellites on one axis: `mesh` with a central wheel gives the distance; `crowns`: the wheels on the axis."""

    carrier: str
    mesh: int
    crowns: tuple[str, ...]


def crowds(train: Train, flat: Sequence[bool]) -> tuple[Crowd, ...]:
    """Of every axis of satellites that meshes with a central wheel, its axes parallel to the main one."""
    carried = satellites(train)
    of = axes(train)
    found = []
    for body, carrier in carried.items():
        crowns = tuple(m.name for m in train.members if m.body == body)
        for k, mesh in enumerate(train.meshes):
            ends = (mesh.i, mesh.j)
            central = [end for end in ends if body_of(train, end) not in carried]
            if flat[k] and set(ends) & set(crowns) and central and of[central[0]] == of[carrier]:
                found.append(Crowd(carrier, k, crowns))
                break
    return tuple(found)


def gap(
    train: Train, crowd: Crowd, teeth: Mapping[str, Array], module: Mapping[str, float], k: Array
) -> Array:
    """Free space between the tips of neighbours, (...): 2 a_w sin(π/k) − d_a of the largest crown, without shift; inf
    of one satellite, which has none."""
    own = module[train.meshes[crowd.mesh].i]
    tips = [module[name] * (teeth[name] + 2 * TIP) for name in crowd.crowns]
    free = twice_distance(train, crowd.mesh, teeth, own) * np.sin(np.pi / k) - reduce(np.maximum, tips)
    return np.where(np.equal(k, 1), np.inf, free)


def least_ring(z: Array) -> Array:
    """Least teeth of a ring that the tips of a satellite of z teeth do not meet beyond the line of action, both without
    shift, (...); inf where none is large enough: z_b (2 z sin²α − 4 ha*) ≥ z² sin²α − 4 ha*²."""
    z = np.asarray(z, dtype=float)
    square = math.sin(ALPHA) ** 2
    with np.errstate(divide="ignore", invalid="ignore"):
        least = (z**2 * square - 4 * TIP**2) / (2 * z * square - 4 * TIP)
    return np.where(2 * z * square > 4 * TIP, np.maximum(least, z + 1), np.inf)
