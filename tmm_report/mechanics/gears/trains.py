"""Gear trains: speeds of all members from Willis' equations, torques and powers with the losses in the meshes.

A train is members and meshes: ordinary (belts, chains and friction wheels are meshes whose ratio is stated),
planetary, closed, a differential with any number of inputs. Members that
name one `shaft` turn as one body (the two rows of a satellite, the output of a stage and the input of the next).

    stage = Train(
        (Member("1", "wheel", 20, 0.05), Member("2", "satellite", 46, 0.115, 0.165, "H"),
         Member("3", "ring", 112, 0.28), Member("H", "carrier", radius=0.165)),
        (Mesh("1", "2", "H", efficiency=0.99), Mesh("2", "3", "H", internal=True, efficiency=0.99)))
    speed = speeds(stage, {"1": 314.16, "3": 0.0})          # speed["H"] = 47.6, speed["2"] = −68.3
    load = loads(stage, speed, {"1": 10.0}, ("3", "H"))     # load.torque["H"], load.efficiency

Sources: Artobolevsky, Theory of mechanisms and machines, ch. VII (Willis) and ch. XIV (efficiency of planetary
trains by the power in the inverted train); Kudryavtsev, Planetary gearing, ch. 3. Speeds are rad/s, positive
counter-clockwise, torques N·m, powers W; the bearings are taken without loss.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import product
from typing import Any, Literal

import numpy as np

from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
Kind = Literal["wheel", "ring", "satellite", "carrier"]

FRAME = ""  # carries the axes that stand still
SINGULAR = 1e-10  # singular values below it count as zero; the rows of the equations are of size 1


@dataclass(frozen=True)
class Member:
    """A wheel or a carrier.

    `radius`: of the rolling (working pitch) circle, m; of a carrier, its arm. `distance`: of the member's axis from
    the main axis of its stage, m. `carried_by`: the carrier of its axis, "" the frame. `shaft`: members that name
    the same one turn together; "" its own.
    """

    name: str
    kind: Kind
    teeth: int = 0
    radius: float = 0.0
    distance: float = 0.0
    carried_by: str = FRAME
    shaft: str = ""

    @property
    def body(self) -> str:
        return self.shaft or self.name


@dataclass(frozen=True)
class Mesh:
    """Wheels `i` and `j` in mesh, both on axes of `carrier`; `efficiency` with the carrier stopped, 0..1.

    `internal`: both turn in the same sense, the carrier stopped, as a ring and a pinion or the pulleys of an open belt
    do. `size`: |ω_i/ω_j|, the carrier stopped, of wheels without teeth, any slip in it; 0: that of the teeth.
    `apart`: the wheels do not touch, a belt or a chain carries the velocity over. `crosses`: their axes are not
    parallel, so that `internal` is no more than a convention.
    """

    i: str
    j: str
    carrier: str = FRAME
    internal: bool = False
    efficiency: float = 1.0
    size: float = 0.0
    apart: bool = False
    crosses: bool = False


@dataclass(frozen=True, eq=False)
class Train:
    """Members and meshes. Raises ValueError where a mesh names no member, or wheels whose ratio nothing says."""

    members: tuple[Member, ...]
    meshes: tuple[Mesh, ...]

    def __post_init__(self) -> None:
        teeth = {member.name: member.teeth for member in self.members}
        for mesh in self.meshes:
            least = min(teeth.get(mesh.i, -1), teeth.get(mesh.j, -1))
            if least < (0 if mesh.size else 1) or mesh.carrier not in {FRAME, *teeth}:
                raise ValueError(
                    f"the mesh {mesh.i}-{mesh.j} needs two wheels with teeth, or a ratio, and a known carrier"
                )
        if len(teeth) < len(self.members):
            raise ValueError("two members of a train have one name")

    @cached_property
    def by_name(self) -> dict[str, Member]:
        return {member.name: member for member in self.members}

    @cached_property
    def bodies(self) -> tuple[str, ...]:
        """What turns on its own, in the order of the members."""
        return tuple(dict.fromkeys(member.body for member in self.members))

    def body(self, name: str) -> int:
        """The index of a member's body."""
        return self.bodies.index(self.by_name[name].body)

    def ratio(self, mesh: Mesh) -> float:
        """Ratio of the mesh with its carrier stopped, ω_i/ω_j: −z_j/z_i external, +z_j/z_i internal."""
        size = mesh.size or self.by_name[mesh.j].teeth / self.by_name[mesh.i].teeth
        return size if mesh.internal else -size

    @cached_property
    def willis(self) -> Array:
        """z_i (ω_i − ω_c) ± z_j (ω_j − ω_c) = 0 of each mesh over all bodies, (meshes, bodies), rows of size 1."""
        rows = np.zeros((len(self.meshes), len(self.bodies)))
        for row, mesh in zip(rows, self.meshes, strict=True):
            u = self.ratio(mesh)
            scale = 1 + abs(u)
            row[self.body(mesh.i)] += 1 / scale
            row[self.body(mesh.j)] -= u / scale
            if mesh.carrier:
                row[self.body(mesh.carrier)] -= (1 - u) / scale
        return rows

    @property
    def freedom(self) -> int:
        """Degrees of freedom: how many speeds determine all the others."""
        return len(self.bodies) - int(np.linalg.matrix_rank(self.willis, tol=SINGULAR))


# --- speeds


def speeds(train: Train, given: Mapping[str, Array], path: tuple[str | int, ...] = ()) -> dict[str, Array]:
    """Angular velocities of all members, (...), rad/s, from those given (of a fixed member 0), by name.

    Raises ProblemError, at `path` of the variant, where the given speeds leave some undetermined or
    contradict one another.
    """
    known = np.array(np.broadcast_arrays(*(np.asarray(given[name], dtype=float) for name in given)))
    bodies = [train.body(name) for name in given]
    columns = list(dict.fromkeys(bodies))
    values = np.array([known[bodies.index(body)] for body in columns])
    found = np.zeros((len(train.bodies), *known.shape[1:]))
    found[columns] = values
    free = [b for b in range(len(train.bodies)) if b not in columns]
    found[free] = _rest(train, columns, free, values, path)
    _consistent(train, found, found[bodies] - known, len(given), path)
    return {member.name: found[train.body(member.name)] for member in train.members}


def _rest(
    train: Train, columns: list[int], free: list[int], values: Array, path: tuple[str | int, ...]
) -> Array:
    """Speeds of the bodies `free` by least squares, (free, ...); the train must determine each of them."""
    matrix, right = train.willis[:, free], -np.tensordot(train.willis[:, columns], values, 1)
    _, sizes, turns = np.linalg.svd(matrix)
    rank = int(np.sum(sizes > SINGULAR))
    if rank < len(free):
        loose = np.abs(turns[rank:]).max(axis=0) > 1e-8
        names = [train.bodies[body] for body, moves in zip(free, loose, strict=True) if moves]
        wrong = N_("the speeds of the members %(names)s are not determined")
        text = N_("give as many speeds (of a fixed member, 0) as the train has degrees of freedom: %(count)s")
        raise ProblemError(
            [mistake(wrong, path, Message(text, {"count": train.freedom}), names=", ".join(names))]
        )
    flat = np.linalg.lstsq(matrix, right.reshape(len(matrix), -1), rcond=None)[0]
    return flat.reshape(len(free), *values.shape[1:])


def _consistent(train: Train, found: Array, clash: Array, count: int, path: tuple[str | int, ...]) -> None:
    """The speeds satisfy every mesh, and members of one shaft were given one speed."""
    noise = 1e-9 * np.max(np.abs(found), initial=1e-300)
    miss = np.tensordot(train.willis, found, 1)
    if np.any(np.abs(miss) > noise) or np.any(np.abs(clash) > noise):
        wrong = N_("%(count)s given speeds contradict one another")
        text = N_("give as many speeds (of a fixed member, 0) as the train has degrees of freedom: %(count)s")
        raise ProblemError([mistake(wrong, path, Message(text, {"count": train.freedom}), count=count)])


# --- torques and powers


@dataclass(frozen=True, eq=False)
class Loads:
    """Torques and powers of a train in steady motion, all (...).

    `torque`: external, on a member from outside, N·m; `power`: of these torques, W, positive where a member is
    driven from outside. By mesh: `mesh_torque` on wheel i, N·m; `mesh_power`: what i gives to j in the frame of the
    carrier, W, negative where j drives; `loss`, W. `settled`: False where no direction of the power agrees
    with itself.
    """

    torque: dict[str, Array]
    power: dict[str, Array]
    mesh_torque: tuple[Array, ...]
    mesh_power: tuple[Array, ...]
    loss: tuple[Array, ...]
    settled: Array

    @property
    def supplied(self) -> Array:
        """Power that comes in from outside, W."""
        return np.sum([np.maximum(power, 0.0) for power in self.power.values()], axis=0)

    @property
    def efficiency(self) -> Array:
        """Power taken out to power supplied, 0..1; 0 where the train locks itself, nan where nothing moves."""
        taken = np.sum([np.maximum(-power, 0.0) for power in self.power.values()], axis=0)
        with np.errstate(invalid="ignore", divide="ignore"):
            return taken / self.supplied

    def locks(self, output: str) -> Array:
        """Whether the output takes power instead of giving it: the train does not run with this output."""
        return self.power[output] > 0

    @property
    def imbalance(self) -> Array:
        """Powers from outside less the losses, W: rounding only."""
        return np.sum(list(self.power.values()), axis=0) - np.sum(self.loss, axis=0)


def loads(
    train: Train,
    speed: Mapping[str, Array],
    known: Mapping[str, Array],
    sought: Sequence[str],
    path: tuple[str | int, ...] = (),
) -> Loads:
    """Torques with losses: `known` external ones by member, N·m, (...), those of the members `sought` found.

    Equilibrium of every body; in each mesh the driven wheel receives the efficiency's part of the power, both in the
    frame of the carrier. Which wheel drives is found by iteration from the train without losses, and where that
    does not come to rest, by trial of all directions. Raises ProblemError where the torques are not determined.
    """
    solved = _Equilibrium(train, speed, known, tuple(sought), path)
    way = np.zeros((*solved.shape, len(train.meshes)))
    for _ in range(2 * len(train.meshes) + 2):
        unknown, next_way = solved.at(way)
        if np.array_equal(next_way, way):
            break
        way = next_way
    else:
        way, unknown = solved.by_trial(way, unknown)
    return solved.result(way, unknown)


class _Equilibrium:
    """Equations of the bodies for one `way` (..., M) of the power: +1 where wheel i drives, −1 where j does."""

    def __init__(
        self,
        train: Train,
        speed: Mapping[str, Array],
        known: Mapping[str, Array],
        sought: tuple[str, ...],
        path: tuple[str | int, ...],
    ):
        self.train, self.speed, self.known, self.sought = train, speed, known, sought
        parts = np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in (*speed.values(), *known.values())))
        self.shape = parts[0].shape
        self.ratio = np.array([train.ratio(mesh) for mesh in train.meshes])
        self.efficiency = np.array([mesh.efficiency for mesh in train.meshes])
        self.slip = np.stack([self._relative(mesh.i, mesh.carrier) for mesh in train.meshes], axis=-1)
        count = len(train.meshes) + len(sought)
        if (
            count != len(train.bodies)
            or np.linalg.matrix_rank(self._matrix(np.zeros(len(self.ratio)))) < count
        ):
            wrong = N_("the torques of the train are not determined by equilibrium")
            right = N_("remove the meshes that repeat a connection, and let every free member be loaded")
            raise ProblemError([mistake(wrong, path, Message(right))])

    def _relative(self, wheel: str, carrier: str) -> Array:
        """ω_i − ω_c, (...)."""
        carried = self.speed[carrier] if carrier else 0.0
        return np.broadcast_to(np.asarray(self.speed[wheel] - carried, dtype=float), self.shape)

    def _share(self, way: Array) -> Array:
        """T_j/T_i of each mesh, (..., M): the transfer of power −T_i ω_i = T_j ω_j/η, in the carrier's frame."""
        return -self.ratio * self.efficiency**way

    def _matrix(self, way: Array) -> Array:
        """Sum of torques on each body over the torques on wheels i and the torques sought, (..., B, B)."""
        train, share = self.train, self._share(way)
        matrix = np.zeros((*way.shape[:-1], len(train.bodies), len(train.meshes) + len(self.sought)))
        for k, mesh in enumerate(train.meshes):
            matrix[..., train.body(mesh.i), k] += 1
            matrix[..., train.body(mesh.j), k] += share[..., k]
            if mesh.carrier:
                matrix[..., train.body(mesh.carrier), k] -= 1 + share[..., k]
        for k, name in enumerate(self.sought, len(train.meshes)):
            matrix[..., train.body(name), k] += 1
        return matrix

    def at(self, way: Array) -> tuple[Array, Array]:
        """The unknown torques for the way, (..., B), and the way that they imply."""
        right = np.zeros((*self.shape, len(self.train.bodies)))
        for name, torque in self.known.items():
            right[..., self.train.body(name)] -= torque
        unknown = np.linalg.solve(self._matrix(way), right[..., None])[..., 0]
        power = -unknown[..., : len(self.ratio)] * self.slip
        noise = 1e-12 * np.max(np.abs(power), axis=-1, keepdims=True, initial=0.0)
        return unknown, np.where(np.abs(power) > noise, np.sign(power), 0.0)

    def by_trial(self, way: Array, unknown: Array) -> tuple[Array, Array]:
        """Of all ways, the first that agrees with itself; the given one where none does."""
        best, torques = way.copy(), unknown.copy()
        todo = np.any(self.at(way)[1] != way, axis=-1)
        for trial in product((1.0, -1.0, 0.0), repeat=len(self.ratio)):
            candidate = np.broadcast_to(np.array(trial), way.shape)
            found, implied = self.at(candidate)
            fits = todo & np.all(implied == candidate, axis=-1)
            best[fits], torques[fits] = candidate[fits], found[fits]
            todo = todo & ~fits
            if not np.any(todo):
                break
        return best, torques

    def result(self, way: Array, unknown: Array) -> Loads:
        meshes = len(self.ratio)
        on_i, mesh_power = unknown[..., :meshes], -unknown[..., :meshes] * self.slip
        # wheel j turns in the carrier's frame at slip / ratio, so its power is T_j·slip/u
        loss = mesh_power - self._share(way) * on_i * self.slip / self.ratio
        torque = {name: np.broadcast_to(value, self.shape) for name, value in self.known.items()}
        torque |= {name: unknown[..., meshes + k] for k, name in enumerate(self.sought)}
        power = {name: value * self.speed[name] for name, value in torque.items()}
        by_mesh = [tuple(np.moveaxis(part, -1, 0)) for part in (on_i, mesh_power, loss)]
        settled = np.all(self.at(way)[1] == way, axis=-1)
        return Loads(torque, power, by_mesh[0], by_mesh[1], by_mesh[2], settled)
