"""How many positions the table of this mechanism needs: tables of 12 … 100 against what is exact."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.solve.positions import Loading, loading
from tmm_report.chapters.lever.moving import Moving, inertia_parts, inertia_slope, machine, powers
from tmm_report.mechanics.calculus.panels import Panels, panels
from tmm_report.mechanics.lever.cams.kinks import breaks as cam_breaks
from tmm_report.mechanics.lever.extremes import refined
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals import counts
from tmm_report.mechanics.rivals.counts import Counted, Wanted, counted
from tmm_report.records import dataclass

Array = Any
CUTS = 2  # how often panels are cut at most


@dataclass(frozen=True, eq=False)
class Tables:
    """The mechanism at equal steps of the cycle, each count solved once; the friction of `moving` is in the machine."""

    moving: Moving

    @cached_property
    def _known(self) -> dict[int, tuple[Motion, Loading | None]]:
        return {}

    def at(self, count: int) -> tuple[Motion, Loading | None]:
        if count not in self._known:
            kinematics, forces = self.moving.kinematics, self.moving.forces
            motion = kinematics.cycle.motion(kinematics.cycle.once(count))
            turned = np.arange(count + 1) * (kinematics.cycle.period / count)
            load = loading(forces.given, kinematics, motion, turned) if forces else None
            self._known[count] = motion, load
        return self._known[count]

    def velocities(self, count: int) -> Array:
        return _of_points(self.at(count)[0])[0]

    def accelerations(self, count: int) -> Array:
        return _of_points(self.at(count)[0])[1]

    def inertia(self, count: int) -> Array:
        """Of the mechanism reduced to its driving link, kg m², (P,)."""
        motion, _ = self.at(count)
        return sum((part for _, part in inertia_parts(motion)), np.zeros(motion.shape))

    def moment(self, count: int) -> Array:
        """Of all weights and stated loads, reduced to the driving link in the sense of rotation, N m, (P,)."""
        motion, load = self.at(count)
        assert self.moving.forces and load
        parts = (power for _, power in powers(self.moving.forces.given, motion, load))
        return sum(parts, np.zeros(motion.shape)) / abs(motion.omega)

    def rubbing(self, count: int) -> Array:
        """Of the friction of the pairs, below zero, as the flywheel has it, N m, (P,); nothing where it is left out."""
        turned = np.arange(count + 1) * (self.moving.kinematics.cycle.period / count)
        found = self.moving.friction.reduced if self.moving.friction else None
        return np.zeros(count + 1) if found is None else -found.panels.at(found.moment, turned)

    def balancing(self, count: int) -> Array:
        """By the balance of powers, in the sense of the axes, N m, (P,): M = ω₁²/2 dI/dφ₁ − M_loads."""
        motion, _ = self.at(count)
        return inertia_slope(motion) * motion.omega**2 / 2 - self.moment(count) * np.sign(motion.omega)

    def reduced(self, count: int) -> Array:
        return np.array([self.moment(count) + self.rubbing(count), self.inertia(count)])


def counting(moving: Moving, accuracy: float | None = None) -> Counted | None:
    """The errors of a table by what is taken from it, and how many positions are enough for `accuracy`, or for what a
    course is content with. None where some position of the cycle does not exist."""
    if moving.kinematics.gaps:
        return None
    with np.errstate(invalid="ignore", divide="ignore"):
        return counted(tuple(wanted(moving)), accuracy)


def _of_points(motion: Motion) -> tuple[Array, Array]:
    """Velocities and accelerations of the mechanism's own points, (F, P): without those that replace a cam pair."""
    rows = [motion.point_index[point] for point in motion.linkage.mechanism.real.point_names]
    return motion.velocities[rows], motion.accelerations[rows]


def wanted(moving: Moving) -> Iterator[Wanted]:
    """What is taken from a table of the mechanism, of a whole cycle without missing positions."""
    tables, cycle = Tables(moving), moving.kinematics.cycle
    over, rates = _resolved(moving)
    yield counts.greatest("velocity", over, rates[0], tables.velocities, cycle.closed)
    yield counts.greatest("acceleration", over, rates[1], tables.accelerations, cycle.closed)
    if moving.forces and moving.forces.over:
        yield counts.extremes_of("moment", moving.forces.over.moment, tables.balancing)
    if cycle.closed:
        yield from _of_machine(moving, tables)


def _of_machine(moving: Moving, tables: Tables) -> Iterator[Wanted]:
    found = machine(moving, friction=True)
    over, inertia, moment = found.panels, found.whole_inertia, found.whole_moment
    if moving.forces:
        yield counts.total("work", over, moment, tables.moment)
    yield counts.mean("inertia_mean", over, inertia, tables.inertia)
    yield counts.extremes("inertia", over, inertia, tables.inertia)
    if moving.forces:
        excess = moment + found.rubbing
        yield counts.unevenness("unevenness", over, (excess, inertia), tables.reduced, found.omega)


def _resolved(moving: Moving) -> tuple[Panels, Array]:
    """Panels on which the rates of all points are polynomials, and velocities and accelerations, (2, F, K, n)."""
    cycle = moving.kinematics.cycle
    laws = np.mod(cycle.sense * (cam_breaks(cycle.linkage.mechanism) - cycle.zero), 2 * np.pi)
    over = panels(cycle.period, cycle.repeated(laws))
    for cut in range(CUTS + 1):
        rates = np.array(_of_points(cycle.motion(over.x.ravel()))).reshape(2, -1, *over.shape)
        sizes = np.broadcast_to(np.abs(rates).max(axis=(1, 2, 3))[:, None], rates.shape[:2])
        finer = refined(over, rates.reshape(-1, *over.shape), sizes.ravel())
        if finer is over or cut == CUTS:
            break
        over = finer
    return over, rates
