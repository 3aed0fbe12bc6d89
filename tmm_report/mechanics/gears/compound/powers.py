"""Powers of a compound train: what every member carries, its branches, what circulates, efficiency in both directions.

`Loads` of `trains` hold the equilibrium; here it is read member by member: the torque on a wheel or a carrier from its
meshes, times its speed. A shaft of several members is a node where branches of the power meet. Source: Kudryavtsev,
Planetary gearing, ch. 3; Artobolevsky, Theory of mechanisms and machines, ch. XIV.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from tmm_report.mechanics.gears.compound.rows import Row
from tmm_report.mechanics.gears.trains import Loads, Train, loads
from tmm_report.records import dataclass

NOISE = 1e-12  # of the largest power: less is none


@dataclass(frozen=True, eq=False)
class Flow:
    """Torques and powers. `member`: torque on each wheel and carrier from its meshes, N·m; `way`: of each mesh, +1
    where its wheel i drives about the carrier, −1 where j does, 0 where nothing moves there."""

    train: Train
    speed: Mapping[str, float]
    loads: Loads
    member: Mapping[str, float]
    way: tuple[int, ...]

    def power(self, name: str) -> float:
        """What the meshes give to a member, W."""
        return self.member[name] * self.speed[name]

    @property
    def supplied(self) -> float:
        return float(self.loads.supplied)

    @property
    def lost(self) -> float:
        return float(sum(self.loads.loss))

    def imbalance(self, body: str) -> float:
        """Torques on a body, of its meshes and from outside, added: rounding only, N·m."""
        names = [member.name for member in self.train.members if member.body == body]
        outside = sum(float(torque) for name, torque in self.loads.torque.items() if name in names)
        return sum(self.member[name] for name in names) + outside

    def branches(self, body: str) -> dict[str, float]:
        """Powers, W, that the members of a body take from their meshes; of one member alone no branches."""
        names = [m.name for m in self.train.members if m.body == body and self.meets(m.name)]
        return {name: self.power(name) for name in names} if len(names) > 1 else {}

    def meets(self, name: str) -> bool:
        """Whether a mesh acts on the member."""
        return any(name in (mesh.i, mesh.j, mesh.carrier) for mesh in self.train.meshes)

    def circulating(self, body: str) -> float:
        """The power that goes round in a loop closed by the body, W: what branches bring back against the others."""
        powers = list(self.branches(body).values())
        forth, back = sum(p for p in powers if p > 0), -sum(p for p in powers if p < 0)
        found = min(forth, back)
        return found if found > NOISE * self.supplied else 0.0


def flow(
    train: Train,
    speed: Mapping[str, float],
    known: Mapping[str, float],
    sought: Sequence[str],
    path: tuple[str | int, ...] = (),
) -> Flow:
    """The powers for external torques `known`, N·m; those of `sought` follow. Raises ProblemError, at `path`."""
    found = loads(train, speed, known, sought, path)
    power = [float(one) for one in found.mesh_power]
    least = NOISE * max((abs(one) for one in power), default=0.0)
    way = tuple(0 if abs(one) <= least else 1 if one > 0 else -1 for one in power)
    member = dict.fromkeys(train.by_name, 0.0)
    for mesh, on_i, x in zip(train.meshes, found.mesh_torque, way, strict=True):
        on_j = -train.ratio(mesh) * mesh.efficiency**x * float(on_i)
        member[mesh.i] += float(on_i)
        member[mesh.j] += on_j
        if mesh.carrier:
            member[mesh.carrier] -= float(on_i) + on_j
    return Flow(train, speed, found, member, way)


def without_losses(train: Train) -> Train:
    return Train(train.members, tuple(replace(mesh, efficiency=1.0) for mesh in train.meshes))


def locked(train: Train, row: Row, factor: float) -> Train:
    """The train whose row between two outputs has a locking factor: the torque of the slower to that of the faster one
    is as many times what it is without friction. The row's meshes share it equally, with its carrier stopped."""
    inside = {link.mesh for link in row.links}
    each = factor ** (-1 / len(inside))
    meshes = tuple(
        replace(mesh, efficiency=each) if k in inside else mesh for k, mesh in enumerate(train.meshes)
    )
    return Train(train.members, meshes)


def backwards(train: Train, speed: Mapping[str, float], output: str, sought: Sequence[str]) -> float:
    """Efficiency with the power going in at the output, ≤ 0 where the train locks itself so. `sought`: the members that
    are held, and the input last."""
    driven = speed[output]
    if not driven or not speed[sought[-1]]:
        return 0.0
    found = loads(train, speed, {output: 1.0 if driven > 0 else -1.0}, sought)
    return float(-found.power[sought[-1]] / found.power[output])
