"""Reduced moment of inertia and reduced moment of the forces, on the driving link over the cycle.

The energy of the links is that of one disc on the driving link, and the power of the forces that of one moment on it:
I ω₁²/2 = Σ (m v_S² + J ω²)/2,  M ω₁ = Σ F v cos α + Σ M ω. (Artobolevsky, Theory of mechanisms and machines, ch. 15)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.kinematics.solve import Kinematics
from tmm_report.chapters.kinetostatics.quantities import forces, moments, weight
from tmm_report.chapters.kinetostatics.solve import Kinetostatics, Solved
from tmm_report.mechanics.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import Motion
from tmm_report.mechanics.planar import dot
from tmm_report.quantity.model import Quantity

Array = Any
Load = tuple[Quantity, Array]


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
class Reduction:
    """Found by `solve`, at the table positions 0..N and at the diagram positions. `forces`: None without loads."""

    kinematics: Kinematics
    forces: Kinetostatics | None
    table: Reduced
    diagram: Reduced

    @cached_property
    def extremes(self) -> tuple[Extreme, Extreme]:
        """Least and greatest reduced moment of inertia over the diagram positions, kg m²."""
        return least_and_greatest(self.diagram.whole_inertia, self.diagram.turned)

    @cached_property
    def disagreement(self) -> float | None:
        """Worst relative difference of the balancing moment of the force analysis from ω₁² I'/2 − M; None without
        forces."""
        if self.forces is None:
            return None
        omega, miss = self.kinematics.omega, []
        for ours, theirs in ((self.table, self.forces.table), (self.diagram, self.forces.diagram)):
            balancing = omega**2 * ours.slope / 2 - ours.whole_moment
            miss.append(np.nanmax(theirs.disagreement(balancing)))
        return float(max(miss))


def solve(kinematics: Kinematics, found: Kinetostatics | None) -> Reduction:
    """The moment of the forces is reduced where there are loads."""
    table = _shares(found, found.table) if found else ()
    diagram = _shares(found, found.diagram) if found else ()
    return Reduction(
        kinematics,
        found,
        _reduced(kinematics.table, kinematics.turned, table),
        _reduced(kinematics.diagram, kinematics.diagram_turned, diagram),
    )


def _reduced(motion: Motion, turned: Array, shares: tuple[Load, ...]) -> Reduced:
    return Reduced(turned, dict(_inertia(motion)), _slope(motion), shares)


def _shares(found: Kinetostatics, solved: Solved) -> tuple[Load, ...]:
    """The power of every load by the driver's angular velocity."""
    return tuple((of, power / solved.motion.omega) for of, power in _powers(found, solved))


def _inertia(motion: Motion) -> Iterator[tuple[str, Array]]:
    """Twice a link's kinetic energy by the square of the driver's angular velocity."""
    for name, link in motion.linkage.mechanism.links.items():
        if name == FRAME or not (link.mass or link.inertia):
            continue
        part = link.inertia * (motion.angular_velocity(name) / motion.omega) ** 2 * np.ones(motion.shape)
        if link.mass_centre is not None:
            part = part + link.mass * np.abs(motion.velocity(link.mass_centre) / motion.omega) ** 2
        yield name, part


def _slope(motion: Motion) -> Array:
    """By the accelerations: dI/dφ = 2 Σ (m v·a + J ω ε)/ω₁³."""
    total = np.zeros(motion.shape)
    for name, link in motion.linkage.mechanism.links.items():
        if name != FRAME:
            total = total + link.inertia * motion.angular_velocity(name) * motion.angular_acceleration(name)
            if link.mass_centre is not None:
                point = link.mass_centre
                total = total + link.mass * dot(motion.velocity(point), motion.acceleration(point))
    return 2 * total / motion.omega**3


def _powers(found: Kinetostatics, solved: Solved) -> Iterator[Load]:
    """Power of every weight and stated load, W."""
    load, given, motion = solved.loading, found.given, solved.motion
    links = motion.linkage.mechanism.links
    for link, force in load.gravity.items():
        yield weight(link), dot(force, motion.velocity(str(links[link].mass_centre)))
    for of, stated, force in zip(forces(given.forces), given.forces, load.forces, strict=True):
        yield of, dot(force, motion.velocity(stated.at))
    for of, on, couple in zip(moments(given.moments), given.moments, load.moments, strict=True):
        yield of, couple * motion.angular_velocity(on.on)
