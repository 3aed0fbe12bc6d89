"""Conditions of a compound train: coaxiality of the meshes between two axes, assembly, neighbourhood of satellites."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmm_report.chapters.gears.train.solve.built import Built
from tmm_report.mechanics.gears.compound import conditions as c
from tmm_report.mechanics.gears.compound.rows import Row
from tmm_report.records import dataclass

USUAL = (2, 3, 4, 5, 6)  # satellites that are tried where their number is not stated
WITHIN = 1e-9
SHIFTS = 3.0  # teeth: what profile shift may make up


@dataclass(frozen=True)
class Distances:
    """Centre distances, m, of two meshes between the same axes, by their places; `gap`: teeth between them."""

    pair: c.Coaxial
    one: float
    other: float
    gap: float

    @property
    def met(self) -> bool:
        return abs(self.gap) < WITHIN

    @property
    def shiftable(self) -> bool:
        """Whether profile shift makes it up."""
        return abs(self.gap) <= SHIFTS


@dataclass(frozen=True)
class Assembly:
    """C of a row for k satellites."""

    row: Row
    k: int
    number: float

    @property
    def met(self) -> bool:
        return abs(self.number - round(self.number)) < WITHIN


@dataclass(frozen=True)
class Neighbours:
    """Free space between neighbouring satellites, m."""

    crowd: c.Crowd
    k: int
    gap: float

    @property
    def met(self) -> bool:
        return self.gap > 0


@dataclass(frozen=True, eq=False)
class Conditions:
    """`stated`: whether the number of satellites is, or was found; else several are looked at, none being asked for."""

    coaxial: tuple[Distances, ...]
    assembly: tuple[Assembly, ...]
    neighbours: tuple[Neighbours, ...]
    stated: bool

    @property
    def met(self) -> bool:
        """Whether all that the variant states hold: distances that shift makes up do."""
        of_satellites = not self.stated or all(one.met for one in self._of_satellites)
        return all(one.shiftable for one in self.coaxial) and of_satellites

    @property
    def _of_satellites(self) -> tuple[Assembly | Neighbours, ...]:
        return (*self.assembly, *self.neighbours)

    @property
    def k(self) -> int:
        """The number of satellites, 0 where it is open."""
        return self._of_satellites[0].k if self.stated and self._of_satellites else 0

    def possible(self) -> Iterator[int]:
        """Numbers of satellites for which both conditions hold."""
        for k in sorted({one.k for one in self._of_satellites}):
            if all(one.met for one in self._of_satellites if one.k == k):
                yield k


def judged(built: Built, rows: Sequence[Row], satellites: Sequence[int]) -> Conditions:
    train, flat = built.train, built.flat
    teeth = {member.name: member.teeth for member in train.members if member.teeth}
    module = {name: built.module(name) for name in teeth}
    numbers = tuple(satellites) or USUAL
    return Conditions(
        tuple(_distances(built, pair, teeth, module) for pair in c.coaxial_pairs(train, flat)),
        tuple(
            Assembly(row, k, float(c.assembly_number(train, row, teeth, k)))
            for row in c.groups_of(train, rows)
            for k in numbers
        ),
        tuple(
            Neighbours(crowd, k, float(c.gap(train, crowd, teeth, module, k)))
            for crowd in c.crowds(train, flat)
            for k in numbers
            if k > 1
        ),
        len(satellites) == 1,
    )


def _distances(built: Built, pair: c.Coaxial, teeth: dict[str, int], module: dict[str, float]) -> Distances:
    meshes = built.train.meshes
    first, other = (module[meshes[k].i] for k in (pair.first, pair.other))
    one = float(c.twice_distance(built.train, pair.first, teeth, first))
    two = float(c.twice_distance(built.train, pair.other, teeth, other))
    return Distances(pair, one / 2, two / 2, (two - one) / min(first, other))
