"""Chapter 3, kinetostatics: loads, reactions in every pair, the balancing moment and two independent checks of it."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import (
    PRINTED,
    TOLERANCE,
    Kinematics,
    rounding,
    stands,
)
from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import Loading as Loading
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import Stated as Stated
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded, stated
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loaded_link as loaded_link
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import loading as loading
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import resultants as resultants
from tmm_report.chapters.lever.kinetostatics.solve.acting_forces import still as still
from tmm_report.chapters.lever.kinetostatics.solve.cam_pressure import Pressing, pressings
from tmm_report.chapters.lever.kinetostatics.solve.coordinates import coordinate
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import Strokes, strokes
from tmm_report.chapters.lever.kinetostatics.solve.kinetic_energy import kinetic_energy, kinetic_power
from tmm_report.chapters.lever.kinetostatics.solve.lengths import odd, refuse
from tmm_report.chapters.lever.kinetostatics.solve.load_breaks import breaks as breaks
from tmm_report.chapters.lever.kinetostatics.solve.powers import external_power as external_power
from tmm_report.chapters.lever.kinetostatics.solve.powers import lever_terms as lever_terms
from tmm_report.chapters.lever.kinetostatics.solve.powers import powers_of as powers_of
from tmm_report.chapters.lever.kinetostatics.solve.whole_cycle import Over as Over
from tmm_report.chapters.lever.kinetostatics.solve.whole_cycle import cut_at as cut_at
from tmm_report.chapters.lever.kinetostatics.solve.whole_cycle import over
from tmm_report.chapters.lever.kinetostatics.solve.works import Works, works
from tmm_report.chapters.lever.kinetostatics.ties import Between, End, apart
from tmm_report.mechanics.calculus.laws import ByStrokes, Constant
from tmm_report.mechanics.lever.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.lever.forces import reactions as statics
from tmm_report.mechanics.lever.forces.reactions import Statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import Problem
from tmm_report.records import dataclass

Array = Any

NO_EXTREME = Extreme(np.nan, np.nan)
STRAIN = 10.0  # times the rounding that is left of a balancing moment: what two ways to it may differ by


@dataclass(frozen=True, eq=False)
class Solved:
    """Forces at one set of positions. `powers`: of the loads, (rows, P), W (see `lever_terms`); `lever`: balancing
    moment by Zhukovsky's lever; `power`: by power balance; `scale`: sum of the magnitudes of their terms, N m, by which
    disagreements are judged."""

    motion: Motion
    turned: Array
    loading: Loading
    statics: Statics
    powers: Array
    lever: Array
    power: Array
    scale: Array

    @property
    def balancing(self) -> Array:
        return self.statics.balancing

    @cached_property
    def explained(self) -> Array:
        """Where both checks hold, or miss by no more than near a singular position rounding does, (P,) of bool."""
        worst = np.fmax(self.disagreement(self.lever), self.disagreement(self.power))
        left = rounding(self.motion)
        with np.errstate(invalid="ignore"):
            return ~(worst > TOLERANCE) | ((worst <= STRAIN * left) & (left < 10.0**-PRINTED))

    def disagreement(self, other: Array) -> Array:
        """Relative difference of another value of the balancing moment from that of the groups, (..., P)."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.where(
                self.scale > 0, np.abs(other - self.balancing) / self.scale, np.abs(other - self.balancing)
            )


@dataclass(frozen=True, eq=False)
class Kinetostatics:
    """Found by `solve`: forces at the table positions 0..N and at the diagram positions."""

    given: Loads
    kinematics: Kinematics
    table: Solved
    diagram: Solved

    @cached_property
    def asked(self) -> Solved | None:
        """Forces at the instants that the variant asks for; None without any."""
        motion, turned = self.kinematics.asked, self.kinematics.instants
        if motion is None:
            return None
        with np.errstate(invalid="ignore", divide="ignore"):
            return at(self.given, motion, turned, stated(self.given, self.kinematics, motion, turned))

    @property
    def positions(self) -> int:
        """How many table positions have loads of their own: position N of a closed cycle repeats position 0."""
        return self.kinematics.positions.table + (not self.kinematics.cycle.closed)

    @cached_property
    def worst_lever(self) -> float:
        return float(max(np.nanmax(s.disagreement(s.lever)) for s in (self.table, self.diagram)))

    @cached_property
    def worst_power(self) -> float:
        return float(max(np.nanmax(s.disagreement(s.power)) for s in (self.table, self.diagram)))

    @property
    def agrees(self) -> bool:
        """Whether both checks hold: but for what rounding leaves near singular positions, where enough digits remain of
        what is printed."""
        return max(self.worst_lever, self.worst_power) <= self.kinematics.tolerance or bool(
            self.table.explained.all() and self.diagram.explained.all()
        )

    @property
    def strained(self) -> bool:
        """Whether the checks hold only by what rounding leaves near singular positions."""
        return self.agrees and max(self.worst_lever, self.worst_power) > self.kinematics.tolerance

    @cached_property
    def over(self) -> Over | None:
        """Forces over the whole cycle between the diagram positions too; None where there are none at some position:
        reactions then grow without bound beside it."""
        return over(self.given, self.kinematics)

    @property
    def extremes(self) -> tuple[Extreme, Extreme]:
        """Least and greatest balancing moment, N m: over the whole cycle, both sides of a jump among it; where some
        position has no forces, of the diagram positions; nan where it grows without bound towards a limit."""
        if self.over is not None:
            return self.over.moment
        return (NO_EXTREME, NO_EXTREME) if self.kinematics.limited else self._of_diagram

    @property
    def bounded(self) -> bool:
        """Whether the balancing moment has extremes."""
        return all(np.isfinite(end.value) for end in self.extremes)

    @cached_property
    def _of_diagram(self) -> tuple[Extreme, Extreme]:
        return least_and_greatest(self.diagram.balancing, self.diagram.turned)

    @property
    def tied(self) -> tuple[Between, ...]:
        """The springs and dampers."""
        forces = self.given.forces
        found = []
        for own in apart(forces)[1]:
            ends = [one for k in own if isinstance(one := forces[k], End)]
            links = tuple(loaded_link(self.table.motion, end) for end in ends)
            of = ends[0].of
            found.append(Between(of[0], int(of[1:]), ends[0].tie.between, links))
        return tuple(found)

    @cached_property
    def works(self) -> Works | None:
        """What the loads do over the cycle; None where it does not end where it begins."""
        return works(self)

    @cached_property
    def pressings(self) -> tuple[Pressing, ...]:
        """How hard each cam presses its follower."""
        return pressings(self)

    @cached_property
    def strokes(self) -> dict[int, Strokes]:
        """Of every force whose diagram is stated stroke by stroke, by its order, when these strokes are."""
        cycle = self.kinematics.cycle
        return {
            k: strokes(force.law, cycle, coordinate(force, cycle))
            for k, force in enumerate(self.given.forces)
            if isinstance(force.law, ByStrokes)
        }

    @property
    def doubts(self) -> tuple[Problem, ...]:
        """Loads along or against a motion that there is not; what is odd of springs and dampers."""
        return (*still(self.given, self.diagram.motion), *odd(self.given, self.kinematics))

    @property
    def followed(self) -> list[int]:
        """Forces, then moments, that are drawn over the cycle, by their order: all that change by laws of their own."""
        loads = (*self.given.forces, *self.given.moments)
        return [
            k
            for k, load in enumerate(loads)
            if not isinstance(load, End) and not isinstance(load.law, Constant)
        ]


def solve(given: Loads, kinematics: Kinematics) -> Kinetostatics:
    with np.errstate(invalid="ignore", divide="ignore"):  # singular positions are nan
        refuse(given, kinematics)
        sets = (
            (kinematics.table, kinematics.turned),
            (kinematics.diagram, kinematics.diagram_turned),
        )
        table, diagram = (
            at(given, motion, turned, stated(given, kinematics, motion, turned)) for motion, turned in sets
        )
    return Kinetostatics(given, kinematics, table, diagram)


def at(given: Loads, motion: Motion, turned: Array, loads: Stated) -> Solved:
    """Forces at the positions of `motion`, angles `turned` from position 0, rad, under the stated loads there."""
    load = loaded(given, motion, loads)
    found = statics.solve(motion, resultants(given, motion, load))
    terms = lever_terms(given, motion, load)
    omega = _turning(motion)
    power = (kinetic_power(motion) - external_power(given, motion, load)) / omega
    lever = -np.sum(terms, axis=0) / omega
    # at a change point reactions are nothing, but the powers have a limit, and so has the moment
    balancing = np.where(np.isfinite(found.balancing), found.balancing, lever)
    scale = np.where(np.isnan(omega), 0.0, np.sum(np.abs(terms), axis=0) / abs(omega)) + np.abs(balancing)
    # where all terms are next to nothing, rounding errors are judged by the rest of the cycle and by the energy
    # of the links, J = N m for a radian
    rest, energy = 1e-3 * _largest(scale), _largest(kinetic_energy(motion))
    scale = np.maximum(scale, np.where(energy > rest, energy, rest))
    return Solved(motion, turned, load, replace(found, balancing=balancing), terms, lever, power, scale)


def _turning(motion: Motion) -> Array:
    """Angular velocity of the driving link, by which powers become moments; nan where it stands still, as there they
    say nothing of the moment."""
    omega = motion.state.w[motion.linkage.mechanism.driver.link]
    return omega if motion.phase is None else np.where(stands(motion), np.nan, omega)


def _largest(values: Array) -> Array:
    """The largest of all positions, (..., 1)."""
    return np.nanmax(values, axis=-1, keepdims=True)
