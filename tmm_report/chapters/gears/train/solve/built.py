"""The train that a variant states, as members and meshes; what its members are called."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from tmm_report.chapters.gears.train.given import GearTrain, Pair
from tmm_report.mechanics.gears.trains import Member, Mesh, Train
from tmm_report.records import dataclass

PRIMES = "'’"
SUBSTITUTE = 1e-3  # m: the module of a drawing whose wheels have none


@dataclass(frozen=True, eq=False)
class Built:
    """`train`: with the efficiencies of the meshes; `flat`: of each mesh, whether its axes are parallel."""

    given: GearTrain
    train: Train
    flat: tuple[bool, ...]

    @cached_property
    def carried(self) -> Mapping[str, str]:
        """Carrier of the axis of each satellite, by the wheel."""
        return carried(self.given)

    def module(self, wheel: str) -> float:
        return self.given.modules.get(wheel, self.given.module or SUBSTITUTE)

    @property
    def inputs(self) -> tuple[str, ...]:
        return self.given.input

    @property
    def outputs(self) -> tuple[str, ...]:
        return self.given.output

    @property
    def outer(self) -> tuple[str, ...]:
        """What is driven, held or taken from."""
        return (*self.inputs, *self.outputs, *self.given.fixed)

    def body(self, name: str) -> str:
        return self.train.by_name[name].body

    @property
    def bevel(self) -> frozenset[str]:
        """Wheels with bevel meshes."""
        return frozenset(
            name
            for mesh, flat in zip(self.train.meshes, self.flat, strict=True)
            for name in (mesh.i, mesh.j)
            if not flat
        )

    def tilted(self, name: str) -> bool:
        """Whether a satellite's axis lies across that of its carrier."""
        return name in self.carried and name in self.bevel


def carried(given: GearTrain) -> dict[str, str]:
    return {wheel: carrier for carrier, wheels in given.carriers.items() for wheel in wheels}


def shafts(given: GearTrain) -> dict[str, str]:
    """The shaft of each member by its name: of those that turn as one the driven, held or taken one, else a carrier."""
    members = [*given.wheels, *given.carriers]
    group = {name: {name} for name in members}
    for names in (*_primed(members), *given.joined):
        whole = set().union(*(group[name] for name in names if name in group))
        for name in whole:
            group[name] = whole
    first = [*given.input, *given.output, *given.fixed, *given.carriers, *given.wheels]
    return {name: min(group[name], key=first.index) for name in members}


def _primed(members: list[str]) -> Iterator[list[str]]:
    """Members whose names differ by primes alone."""
    for base in {name.rstrip(PRIMES) for name in members}:
        same = [name for name in members if name.rstrip(PRIMES) == base]
        if len(same) > 1:
            yield same


def build(given: GearTrain, teeth: Mapping[str, int]) -> Built:
    """`teeth`: of each wheel. The variant's parts agree with one another."""
    of, shaft = carried(given), shafts(given)
    rings = {mesh.j for mesh in given.meshes if mesh.kind == "internal"}
    members = [
        Member(
            name,
            "satellite" if name in of else "ring" if name in rings else "wheel",
            z,
            carried_by=of.get(name, ""),
            shaft=shaft[name],
        )
        for name, z in teeth.items()
    ]
    members += [Member(name, "carrier", shaft=shaft[name]) for name in given.carriers]
    meshes = tuple(_mesh(given, pair, k, of) for k, pair in enumerate(given.meshes))
    return Built(given, Train(tuple(members), meshes), tuple(pair.kind != "bevel" for pair in given.meshes))


def _mesh(given: GearTrain, pair: Pair, k: int, of: Mapping[str, str]) -> Mesh:
    carrier = of.get(pair.i) or of.get(pair.j) or ""
    losses, eta = given.efficiency, 1.0
    if losses is not None:
        by_kind = {"external": losses.external, "internal": losses.internal, "bevel": losses.bevel}
        eta = losses.meshes.get(pair.name, by_kind[pair.kind])
    return Mesh(pair.i, pair.j, carrier, _alike(given, pair, k, carrier), eta)


def _alike(given: GearTrain, pair: Pair, k: int, carrier: str) -> bool:
    """Whether both wheels turn in one sense about the stopped carrier. Of bevel wheels that is a matter of counting: on
    fixed axes every wheel's own sense is positive; of two central wheels of a satellite one turns against the other."""
    if pair.kind != "bevel":
        return pair.kind == "internal"
    if pair.sense is not None:
        return pair.sense > 0
    shaft = shafts(given)
    ends = {shaft[pair.i], shaft[pair.j]}
    before = (one for one in given.meshes[:k] if one.kind == "bevel" and ends & {shaft[one.i], shaft[one.j]})
    of = carried(given)
    return not carrier or any((of.get(one.i) or of.get(one.j)) == carrier for one in before)
