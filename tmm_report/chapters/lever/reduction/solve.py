"""Reduced moment of inertia and reduced moment of the forces, on the driving link over the cycle.

The energy of the links is that of one disc on the driving link, and the power of the forces that of one moment on it:
I ω₁²/2 = Σ (m v_S² + J ω²)/2,  M ω₁ = Σ F v cos α + Σ M ω. (Artobolevsky, Theory of mechanisms and machines, ch. 15)
The ratios of the velocities depend on the place of the driving link alone, by whatever law it moves, and where it
stands still, too: they are taken with it at 1 rad/s. In the equation of motion, I ε₁ + ω₁² I'/2 = M + M_bal, the law
has its ω₁ and ε₁.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.analogues import in_unit_motion
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved
from tmm_report.chapters.lever.moving import Load, inertia_parts, inertia_slope, powers
from tmm_report.chapters.lever.plans.solve import Plans
from tmm_report.mechanics.lever.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Reduced:
    """At some positions: `inertia`: link -> its part, kg m²; `slope`: of the whole by the driver's angle, kg m²/rad;
    `moments`: each load with its part, N m. Arrays (P,)."""

    turned: Array
    inertia: Mapping[str, Array]
    slope: Array
    moments: tuple[Load, ...]

    @cached_property
    def whole_inertia(self) -> Array:
        return np.sum(list(self.inertia.values()), axis=0)

    @cached_property
    def whole_moment(self) -> Array:
        return np.sum([part for _, part in self.moments], axis=0) + np.zeros_like(self.turned)


@dataclass(frozen=True, eq=False)
class ByPlan:
    """At a position with a velocity plan. `centres`: mass centre -> its velocity by that of the driving link, m;
    `links`: link -> its angular velocity by that; `graph`: reduced moment of inertia by these ratios, `exact`: by the
    analytical ones, kg m². The plan may be drawn for any speed: it leaves the ratios as they are."""

    position: int
    centres: Mapping[str, float]
    links: Mapping[str, float]
    graph: float
    exact: float

    @property
    def delta(self) -> float:
        """200 (g − a)/(g + a), %; of no moment of inertia at all none."""
        sum_ = self.graph + self.exact
        return 200.0 * (self.graph - self.exact) / sum_ if sum_ else 0.0


@dataclass(frozen=True, eq=False)
class Reduction:
    """Found by `solve`, at the table positions 0..N and at the diagram positions. `forces`: None without loads;
    `plans`: at the positions with a velocity plan."""

    kinematics: Kinematics
    forces: Kinetostatics | None
    table: Reduced
    diagram: Reduced
    plans: tuple[ByPlan, ...] = ()

    @cached_property
    def extremes(self) -> tuple[Extreme, Extreme]:
        """Least and greatest reduced moment of inertia over the diagram positions, kg m²; nan where the mechanism
        comes to a limit, towards which it grows without bound."""
        if self.kinematics.limited:
            return Extreme(np.nan, np.nan), Extreme(np.nan, np.nan)
        return least_and_greatest(self.diagram.whole_inertia, self.diagram.turned)

    @cached_property
    def disagreement(self) -> float | None:
        """Worst relative difference of the balancing moment of the force analysis from I ε₁ + ω₁² I'/2 − M; None
        without forces."""
        if self.forces is None:
            return None
        link, miss = self.kinematics.linkage.mechanism.driver.link, []
        for ours, theirs in ((self.table, self.forces.table), (self.diagram, self.forces.diagram)):
            omega, epsilon = (
                of(link) for of in (theirs.motion.angular_velocity, theirs.motion.angular_acceleration)
            )
            balancing = omega**2 * ours.slope / 2 - ours.whole_moment
            if self.kinematics.by_law:
                balancing = balancing + ours.whole_inertia * epsilon
            miss.append(np.nanmax(theirs.disagreement(balancing)))
        return float(max(miss))


def solve(kinematics: Kinematics, found: Kinetostatics | None, drawn: Plans) -> Reduction:
    """The moment of the forces is reduced where there are loads. Raises ProblemError where no mass moves."""
    table = _shares(found, found.table) if found else ()
    diagram = _shares(found, found.diagram) if found else ()
    reduced = _reduced(kinematics.table, kinematics.turned, table)
    if not np.any(reduced.whole_inertia):
        right = Message(N_("give the links their mass, mass_centre and inertia"))
        wrong = N_("there is nothing to reduce: no mass of the links moves")
        raise ProblemError([mistake(wrong, ("reduction",), right)])
    return Reduction(
        kinematics,
        found,
        reduced,
        _reduced(kinematics.diagram, kinematics.diagram_turned, diagram),
        tuple(_by_plans(kinematics, drawn, reduced.whole_inertia)),
    )


def _by_plans(kinematics: Kinematics, drawn: Plans, exact: Array) -> Iterator[ByPlan]:
    """Ratios read off the velocity plans, and the reduced moment of inertia by them."""
    mechanism = kinematics.linkage.mechanism
    heavy = [link for link in mechanism.links.values() if link.name != FRAME]
    for plan in (one.velocity for one in drawn.drawn):
        omega = abs(float(kinematics.table.angular_velocity(mechanism.driver.link)[plan.position]))
        centres = {
            link.mass_centre: plan.values.get(f"v_{link.mass_centre}", 0.0) / omega
            for link in heavy
            if link.mass_centre is not None and link.mass
        }
        links = {
            link.name: 1.0
            if link.name == mechanism.driver.link
            else plan.values.get(f"w_{link.name}", 0.0) / omega
            for link in heavy
            if link.inertia
        }
        graph = sum(link.mass * centres.get(str(link.mass_centre), 0.0) ** 2 for link in heavy)
        graph += sum(link.inertia * links.get(link.name, 0.0) ** 2 for link in heavy)
        yield ByPlan(plan.position, centres, links, float(graph), float(exact[plan.position]))


def _reduced(motion: Motion, turned: Array, shares: tuple[Load, ...]) -> Reduced:
    motion = _by_place(motion)
    return Reduced(turned, dict(inertia_parts(motion)), inertia_slope(motion), shares)


def _by_place(motion: Motion) -> Motion:
    """The motion in which what depends on the place is reduced: of a law that with 1 rad/s at every place."""
    return motion if motion.phase is None else in_unit_motion(motion)


def _shares(found: Kinetostatics, solved: Solved) -> tuple[Load, ...]:
    """The power of every load by the driver's angular velocity."""
    motion = _by_place(solved.motion)
    return tuple((of, power / motion.omega) for of, power in powers(found.given, motion, solved.loading))
