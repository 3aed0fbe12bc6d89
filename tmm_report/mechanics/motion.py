"""Motion of a whole mechanism: the driving link, then its dyads in the order of assembly.

Arrays are (..., P): variants, then positions of the driving link.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.dyads import Dyad, State, move, place, singularity
from tmm_report.mechanics.mechanism import FRAME, Mechanism
from tmm_report.mechanics.structure import Structure

Array = Any


@dataclass(frozen=True, eq=False)
class Linkage:
    """A mechanism ready to be solved: its structure, and its dyads with their roots."""

    structure: Structure
    dyads: tuple[Dyad, ...]

    @property
    def mechanism(self) -> Mechanism:
        return self.structure.mechanism

    @cached_property
    def carriers(self) -> dict[str, str]:
        """Point -> the link whose motion gives the point's: of those that share it, the one found first."""
        order = [FRAME, self.mechanism.driver.link, *(link for d in self.dyads for link in (d.a, d.b))]
        links = self.mechanism.links
        return {p: next(n for n in order if p in links[n].points) for p in self.mechanism.point_names}


@dataclass(frozen=True, eq=False)
class Motion:
    """Positions, velocities and accelerations of every link (`state`) and named point at driver angles `phi`.

    `phi`: (..., P), rad, angle of the driving link's x axis. `sliding`: guide name -> sliding velocity and
    acceleration in that prismatic pair, of its second unknown. SI.
    """

    linkage: Linkage
    phi: Array
    omega: Array
    state: State
    shape: tuple[int, ...]

    @cached_property
    def point_index(self) -> dict[str, int]:
        return {point: k for k, point in enumerate(self.linkage.carriers)}

    @cached_property
    def _arms(self) -> tuple[Array, Array, Array]:
        """Arms of all named points about their links' reference points, world axes, and those links' indices."""
        s, links = self.state, self.linkage.mechanism.links
        names = list(s.r)
        index = np.array([names.index(link) for link in self.linkage.carriers.values()])
        arms = [links[link].points[point] - s.o[link] for point, link in self.linkage.carriers.items()]
        local = np.array(arms)
        if local.ndim == 1:
            local = local.reshape(-1, *(1,) * len(self.shape))
        return index, self.stack(s.u)[index] * local, names

    def stack(self, by_link: dict[str, Array]) -> Array:
        """Values of all links as one array, (L, ..., P), in the order in which links were found."""
        out = np.empty((len(by_link), *self.shape), dtype=complex)
        for k, value in enumerate(by_link.values()):
            out[k] = value
        return out

    @cached_property
    def places(self) -> Array:
        """World places of all named points, (N, ..., P), m; row `point_index[name]`."""
        index, arms, _ = self._arms
        return self.stack(self.state.r)[index] + arms

    @cached_property
    def velocities(self) -> Array:
        index, arms, _ = self._arms
        return self.stack(self.state.v)[index] + self.stack(self.state.iw)[index] * arms

    @cached_property
    def accelerations(self) -> Array:
        index, arms, _ = self._arms
        return self.stack(self.state.a)[index] + self.stack(self.state.ie)[index] * arms

    def place(self, point: str) -> Array:
        return self.places[self.point_index[point]]

    def velocity(self, point: str) -> Array:
        return self.velocities[self.point_index[point]]

    def acceleration(self, point: str) -> Array:
        return self.accelerations[self.point_index[point]]

    def turn(self, link: str) -> Array:
        """Direction of a link's x axis, unit complex, (..., P)."""
        return np.broadcast_to(self.state.u[link], self.shape)

    def angular_velocity(self, link: str) -> Array:
        return np.broadcast_to(self.state.w[link], self.shape)

    def angular_acceleration(self, link: str) -> Array:
        return np.broadcast_to(self.state.e[link], self.shape)

    @cached_property
    def closes(self) -> Array:
        """Where the mechanism can be assembled, (..., P) of bool."""
        return np.isfinite(sum(np.broadcast_to(u, self.shape) for u in self.state.u.values()))

    @cached_property
    def sines(self) -> dict[str, Array]:
        """Group label -> sine of the angle of its two unknown directions, (..., P): 0 is a singular position."""
        return {d.group.label: np.broadcast_to(singularity(self.state, d), self.shape) for d in self.linkage.dyads}


def drive(linkage: Linkage, phi: Array, omega: Array | None = None) -> State:
    """State of the frame and the driving link at angles `phi`, rad; `omega` in rad/s (default: the variant's)."""
    mechanism, pair = linkage.mechanism, linkage.structure.driver_pair
    link = mechanism.driver.link
    omega = mechanism.driver.omega if omega is None else omega
    s = State()
    for name, o, r, u in ((FRAME, 0.0, 0.0, 1.0), (link, pair.at[link], pair.at[FRAME], np.exp(1j * phi))):
        s.o[name], s.r[name], s.u[name] = o, r, u
        s.carry(name, 0.0, 0.0)
        s.turn(name, omega if name == link else 0.0, 0.0)
    return s


def positions(linkage: Linkage, phi: Array) -> State:
    """Poses only, no rates: what root finding and sketches need."""
    with np.errstate(invalid="ignore", divide="ignore"):
        s = drive(linkage, phi)
        for d in linkage.dyads:
            place(s, d)
    return s


def solve(linkage: Linkage, phi: Array, omega: Array | None = None) -> Motion:
    """Motion at driver angles `phi`, (P,) or (..., P), rad. What does not close is nan in its position only."""
    with np.errstate(invalid="ignore", divide="ignore"):
        s = drive(linkage, phi, omega)
        for d in linkage.dyads:
            place(s, d)
            move(s, d)
    shape = np.broadcast_shapes(*(np.shape(u) for u in s.u.values()))
    omega = linkage.mechanism.driver.omega if omega is None else omega
    return Motion(linkage, phi, omega, s, shape)


def linkage_of(structure: Structure, signs: Sequence[int]) -> Linkage:
    """A Linkage with the given roots, one a group."""
    from tmm_report.mechanics.dyads import dyad

    return Linkage(structure, tuple(dyad(structure.mechanism, g, s) for g, s in zip(structure.groups, signs, strict=True)))
