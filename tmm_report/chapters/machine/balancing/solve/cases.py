"""The mechanism as it is and with the counterweights of each method: how each shakes the foundation over the cycle."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.machine.balancing.solve.substituted_masses import Unbalanced
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.lever.cycle import Cycle, Extreme
from tmm_report.mechanics.lever.motion import Linkage, Motion
from tmm_report.mechanics.masses.counterweights import Weight, added, on_frame, weighted
from tmm_report.mechanics.masses.shaking_moment import Couple, Wheel, geared, moment_of
from tmm_report.records import dataclass

Array = Any
ORIGINAL = "original"
RMS, MAX = "rms", "max"
CLOSED = 1e-9  # of the greatest shaking force: what is left of it is rounding
NOISE = 1e-12  # of force by arm: a shaking moment that is rounding


@dataclass(frozen=True, eq=False)
class Placed:
    """A counterweight that a method puts on a link. `moment`: m_c ρ_c, complex kg m in the link's line (see
    `Unbalanced`), where the counterweight lies; `carried`: what it meets, by masses."""

    link: str
    about: complex
    axis: complex
    moment: complex
    mass: float
    distance: float
    carried: Unbalanced | None = None

    @property
    def weight(self) -> Weight:
        arm = self.distance * self.moment / abs(self.moment)
        return Weight(self.link, self.mass, self.about + self.axis * arm)


@dataclass(frozen=True)
class Rotor:
    """A pair of an unbalanced rotor: turns `order` times a turn of the driving link, in its sense if above zero; its
    `moment` m r, kg m, stands at `angle`, rad, from the x axis at position 0."""

    order: int
    moment: float
    angle: float
    radius: float

    @property
    def mass(self) -> float:
        return self.moment / self.radius


@dataclass(frozen=True, eq=False)
class Shaken:
    """Shaking force, complex N, and moment, N m, at some positions, (P,)."""

    force: Array
    moment: Array


@dataclass(frozen=True, eq=False)
class Case:
    """One state of the mechanism. `table`, `diagram`: at those positions; `cycle`: at equal steps of a turn, from
    position 0; `check`: worst relative disagreement with the reactions of the frame, None where weights turn beside the
    links. `base`: the case to which `wheels` and `couples` are added."""

    name: str
    placed: tuple[Placed, ...]
    rotors: tuple[Rotor, ...]
    table: Shaken
    diagram: Shaken
    cycle: Shaken
    check: float | None = None
    base: Case | None = None
    wheels: tuple[Wheel, ...] = ()
    couples: tuple[Couple, ...] = ()

    @cached_property
    def force_max(self) -> Extreme:
        return Extreme(*fourier.greatest(self.cycle.force))

    @cached_property
    def moment_max(self) -> Extreme:
        return Extreme(*fourier.greatest(self.cycle.moment))

    @property
    def force_rms(self) -> float:
        return float(fourier.mean_square(self.cycle.force))

    @property
    def moment_rms(self) -> float:
        return float(fourier.mean_square(self.cycle.moment))

    @property
    def mass(self) -> float:
        """Of all counterweights and rotors, kg; wheels have moments of inertia alone."""
        own = sum(one.mass for one in self.placed) + sum(one.mass for one in self.rotors)
        return own + sum(2 * one.mass for one in self.couples) + (self.base.mass if self.base else 0.0)

    @property
    def weights(self) -> list[Weight]:
        """All that is fixed to the links."""
        return [*(self.base.weights if self.base else ()), *(one.weight for one in self.placed)]

    @property
    def geared(self) -> tuple[Wheel, ...]:
        """All wheels, those of the case before too."""
        return (*(self.base.geared if self.base else ()), *self.wheels)

    @property
    def shaken(self) -> tuple[Shaken, Shaken, Shaken]:
        """At the positions of each motion of `Ground`."""
        return self.table, self.diagram, self.cycle


@dataclass(frozen=True, eq=False)
class Ground:
    """What all methods start from: the motion at the table and diagram positions and at equal steps of a turn, and the
    shaking of the mechanism as it is."""

    linkage: Linkage
    cycle: Cycle
    about: complex
    motions: tuple[Motion, Motion, Motion]
    turned: tuple[Array, Array, Array]
    original: Case

    @property
    def omega(self) -> float:
        return float(self.linkage.mechanism.driver.omega)

    @property
    def size(self) -> float:
        """The greatest shaking force, N."""
        return self.original.force_max.value

    def case(self, name: str, placed: tuple[Placed, ...], rotors: tuple[Rotor, ...] = ()) -> Case:
        """The mechanism with counterweights and rotors, which stand at the point of the moments."""
        weights = [one.weight for one in placed]
        shaken = []
        for motion, turned, before, arm in zip(
            self.motions, self.turned, self.original.shaken, self.arms, strict=True
        ):
            force, moment = added(motion, weights, self.about)
            force = force + rotating(rotors, turned, self.cycle.sense, self.omega)
            shaken.append(Shaken(before.force + force, self.settled(before.moment + moment, arm)))
        table, diagram, fine = shaken
        found = Case(name, placed, rotors, table, diagram, fine)
        return found if rotors else replace(found, check=self.checked(weights, shaken[0]))

    def with_moment(
        self, name: str, base: Case, wheels: tuple[Wheel, ...] = (), couples: tuple[Couple, ...] = ()
    ) -> Case:
        """A case with wheels geared to its links, or with weights in antiphase: both leave its force as it is."""
        shaken = []
        for motion, turned, before, arm in zip(
            self.motions, self.turned, base.shaken, self.arms, strict=True
        ):
            moment = geared(motion, wheels) + moment_of(couples, self.cycle.sense * turned, self.omega)
            shaken.append(Shaken(before.force, self.settled(before.moment + moment, arm)))
        table, diagram, fine = shaken
        found = Case(name, (), (), table, diagram, fine, None, base, wheels, couples)
        if couples or base.check is None:
            return found
        return replace(found, check=self.checked(base.weights, table, found.geared))

    def checked(self, weights: list[Weight], shaken: Shaken, wheels: tuple[Wheel, ...] = ()) -> float:
        """The forces found again with the counterweights as parts of the links, which move as before, and with wheels
        as what they add to the moments of inertia: the reactions of the frame added up."""
        motion = self.motions[0]
        fitted = weighted(self.linkage, weights, {one.link: one.inertia * one.ratio for one in wheels})
        again = Motion(fitted, motion.phi, motion.omega, motion.state, motion.shape)
        return disagreement(again, shaken, self.about, self.size)

    @cached_property
    def arms(self) -> tuple[float, float, float]:
        """Of each of the motions how far from the point of the moments the farthest point of a link comes, m."""
        table, diagram, fine = (reach(motion, self.about) for motion in self.motions)
        return table, diagram, fine

    def settled(self, moment: Array, arm: float) -> Array:
        """Nothing where a moment is the rounding of its terms, by the greatest force at an arm."""
        return np.where(np.nanmax(np.abs(moment)) <= NOISE * self.size * arm, 0.0, moment)


def reach(motion: Motion, about: complex) -> float:
    """How far from a point the farthest point of a link comes, m."""
    return float(np.nanmax(np.abs(motion.places - about)))


def disagreement(motion: Motion, shaken: Shaken, about: complex, size: float) -> float:
    """Worst difference of the shaking from the reactions of the frame, by the greatest force, and by that at the arm of
    the farthest point."""
    force, moment = on_frame(motion, about)
    misses = (
        np.abs(force - shaken.force) / size,
        np.abs(moment - shaken.moment) / (size * reach(motion, about)),
    )
    return float(np.nanmax(misses, initial=0.0))


def rotating(rotors: tuple[Rotor, ...], turned: Array, sense: int, omega: float) -> Array:
    """Centrifugal force of rotors at angles turned by the driving link, complex N."""
    total = np.zeros(np.shape(turned), dtype=complex)
    for rotor in rotors:
        size = rotor.moment * (rotor.order * omega) ** 2
        total = total + size * np.exp(1j * (rotor.angle + rotor.order * sense * turned))
    return total
