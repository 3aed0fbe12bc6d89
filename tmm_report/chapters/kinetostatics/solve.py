"""Chapter 3, kinetostatics: loads, reactions in every pair, the balancing moment and two independent checks of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, assert_never

import numpy as np

from tmm_report.chapters.kinematics.solve import Kinematics
from tmm_report.chapters.kinetostatics.breaks import (
    breaks as breaks,
)  # for chapters that integrate over the cycle
from tmm_report.chapters.kinetostatics.loads import (
    ByAngle,
    ByDisplacement,
    ByPosition,
    ByStrokes,
    Constant,
    Force,
    Law,
    Loads,
    Moment,
)
from tmm_report.chapters.kinetostatics.strokes import Strokes, by_displacement, by_strokes, strokes
from tmm_report.mechanics import statics
from tmm_report.mechanics.cycle import Cycle, Extreme, least_and_greatest
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import SINGULAR, Motion
from tmm_report.mechanics.motion import solve as solve_motion
from tmm_report.mechanics.planar import cross, dot
from tmm_report.mechanics.repeated import repeated
from tmm_report.mechanics.roots import DIFFERENCE
from tmm_report.mechanics.statics import Load, Statics

Array = Any

Stated = tuple[Sequence[tuple[Array, Array]], Sequence[tuple[Array, Array]]]
"""Of every stated force, then of every moment: the vector (..., P), and how much of it is along its direction."""

TOLERANCE = 1e-9  # relative disagreement of the checks above which something is wrong


@dataclass(frozen=True, eq=False)
class Loading:
    """All loads at some positions: vectors (..., P), N and N m.

    `gravity`, `inertia`: link -> force at its mass centre; `couples`: link -> inertia couple; `forces`: the stated
    forces by order; `moments`: the stated moments by order; `stated`: the forces, then the moments, along their stated
    directions, with the sign of their laws.
    """

    gravity: Mapping[str, Array]
    inertia: Mapping[str, Array]
    couples: Mapping[str, Array]
    forces: tuple[Array, ...]
    moments: tuple[Array, ...]
    stated: tuple[Array, ...]


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
    def worst_lever(self) -> float:
        return float(max(np.nanmax(s.disagreement(s.lever)) for s in (self.table, self.diagram)))

    @cached_property
    def worst_power(self) -> float:
        return float(max(np.nanmax(s.disagreement(s.power)) for s in (self.table, self.diagram)))

    @property
    def agrees(self) -> bool:
        return max(self.worst_lever, self.worst_power) <= TOLERANCE

    @cached_property
    def extremes(self) -> tuple[Extreme, Extreme]:
        """Least and greatest balancing moment over the diagram positions, N m."""
        return least_and_greatest(self.diagram.balancing, self.diagram.turned)

    @cached_property
    def strokes(self) -> dict[int, Strokes]:
        """Of every force whose diagram is stated stroke by stroke, by its order, when these strokes are."""
        cycle = self.kinematics.cycle
        return {
            k: strokes(force.law, cycle, force.at)
            for k, force in enumerate(self.given.forces)
            if isinstance(force.law, ByStrokes)
        }

    @property
    def followed(self) -> list[int]:
        """Forces that are drawn over the cycle, by their order: what is stated stroke by stroke, and of a cycle of
        several turns all that change."""
        several = self.kinematics.cycle.turns > 1
        return [
            k
            for k, force in enumerate(self.given.forces)
            if isinstance(force.law, ByStrokes) or (several and not isinstance(force.law, Constant))
        ]


def solve(given: Loads, kinematics: Kinematics) -> Kinetostatics:
    with np.errstate(invalid="ignore", divide="ignore"):  # singular positions are nan
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
    omega = motion.state.w[motion.linkage.mechanism.driver.link]
    power = (_kinetic_power(motion) - external_power(given, motion, load)) / omega
    lever = -np.sum(terms, axis=0) / omega
    # at a change point reactions are nothing, but the powers have a limit, and so has the moment
    balancing = np.where(np.isfinite(found.balancing), found.balancing, lever)
    scale = np.sum(np.abs(terms), axis=0) / abs(omega) + np.abs(balancing)
    # where all terms are next to nothing, rounding errors are judged by the rest of the cycle and by the energy
    # of the links, J = N m for a radian
    rest, energy = 1e-3 * _largest(scale), _largest(kinetic_energy(motion))
    scale = np.maximum(scale, np.where(energy > rest, energy, rest))
    return Solved(motion, turned, load, replace(found, balancing=balancing), terms, lever, power, scale)


def _largest(values: Array) -> Array:
    """The largest of all positions, (..., 1)."""
    return np.nanmax(values, axis=-1, keepdims=True)


def stated(given: Loads, kinematics: Kinematics, motion: Motion, turned: Array) -> Stated:
    """The stated forces and moments at the positions of `motion`, angles `turned` from position 0, rad."""
    return (
        [_force(force, kinematics, motion, turned) for force in given.forces],
        [_moment(moment, kinematics, motion, turned) for moment in given.moments],
    )


def loading(given: Loads, kinematics: Kinematics, motion: Motion, turned: Array) -> Loading:
    """Evaluate every load at the positions of `motion`, angles `turned` from position 0, rad."""
    return loaded(given, motion, stated(given, kinematics, motion, turned))


def loaded(given: Loads, motion: Motion, loads: Stated) -> Loading:
    """The stated loads with weights, inertia forces and couples."""
    links = [link for name, link in motion.linkage.mechanism.links.items() if name != FRAME]
    heavy = [link for link in links if link.mass_centre is not None and np.any(link.mass)]
    one = np.ones(motion.shape)
    forces, moments = loads
    return Loading(
        gravity={link.name: link.mass * given.gravity * one for link in heavy},
        inertia={link.name: -link.mass * motion.acceleration(str(link.mass_centre)) for link in heavy},
        couples={
            link.name: -link.inertia * motion.angular_acceleration(link.name)
            for link in links
            if np.any(link.inertia)
        },
        forces=tuple(vector for vector, _ in forces),
        moments=tuple(couple for couple, _ in moments),
        stated=tuple(along for _, along in (*forces, *moments)),
    )


def _force(force: Force, kinematics: Kinematics, motion: Motion, turned: Array) -> tuple[Array, Array]:
    """The vector, and how much of it lies along its stated direction: less than nothing where the law says so."""
    size = magnitude(force.law, kinematics, motion, turned, force.at)
    if not isinstance(force.direction, str):
        return size * force.direction, size
    velocity = motion.velocity(force.at)
    # standing still has no direction of motion: no force along it
    speed = np.abs(velocity)
    still = speed <= 1e-12 * np.nanmax(speed, initial=0.0)
    along = np.where(still, 0.0, velocity / np.where(still, 1.0, speed))
    return size * (along if force.direction == "along" else -along), np.where(still, 0.0, size)


def _moment(moment: Moment, kinematics: Kinematics, motion: Motion, turned: Array) -> tuple[Array, Array]:
    """The moment, + counter-clockwise, and how much of it is in its stated sense."""
    size = magnitude(moment.law, kinematics, motion, turned, None)
    if not isinstance(moment.direction, str):
        return size * moment.direction, size
    rate = motion.angular_velocity(moment.on)
    sense = np.where(np.abs(rate) <= 1e-12 * np.nanmax(np.abs(rate), initial=0.0), 0.0, np.sign(rate))
    return size * (sense if moment.direction == "along" else -sense), size * np.abs(sense)


def magnitude(law: Law, kinematics: Kinematics, motion: Motion, turned: Array, at: str | None) -> Array:
    """A law's magnitude at angles `turned`, (..., P)."""
    cycle = kinematics.cycle
    match law:
        case Constant(value):
            return np.full(motion.shape, value)
        case ByPosition(values):
            angles = np.arange(len(values)) * (cycle.period / kinematics.positions.table)
            return _interpolate(cycle, turned, angles, np.array(values))
        case ByAngle(angles, values):
            return _interpolate(cycle, turned, np.array(angles), np.array(values))
        case ByDisplacement() | ByStrokes():
            if at is None:
                raise TypeError("a moment has no displacement: its law is by angle or by position")
            if isinstance(law, ByDisplacement):
                return by_displacement(law, cycle, motion, at)
            return by_strokes(law, cycle, motion, turned, at)
        case _:
            assert_never(law)


def _interpolate(cycle: Cycle, turned: Array, angles: Array, values: Array) -> Array:
    """Straight lines between the points, periodic where the driving link goes round."""
    if not cycle.closed:
        return np.interp(turned, angles, values)
    return repeated(turned, angles, values, cycle.period)


def resultants(given: Loads, motion: Motion, load: Loading) -> dict[str, Load]:
    """All loads of each moving link, about its reference point."""
    s, mechanism = motion.state, motion.linkage.mechanism
    force: dict[str, Array] = {name: np.zeros(motion.shape, dtype=complex) for name in mechanism.moving}
    moment: dict[str, Array] = {name: np.zeros(motion.shape) for name in mechanism.moving}

    def add(link: str, vector: Array, point: str) -> None:
        force[link] = force[link] + vector
        moment[link] = moment[link] + cross(motion.place(point) - s.r[link], vector)

    for link, vector in load.inertia.items():
        add(link, vector + load.gravity[link], str(mechanism.links[link].mass_centre))
    for link, couple in load.couples.items():
        moment[link] = moment[link] + couple
    for stated, vector in zip(given.forces, load.forces, strict=True):
        add(loaded_link(motion, stated.at), vector, stated.at)
    for on, couple in zip(given.moments, load.moments, strict=True):
        moment[on.on] = moment[on.on] + couple
    return {name: Load(force[name], moment[name]) for name in mechanism.moving}


def loaded_link(motion: Motion, point: str) -> str:
    """The link on which a force at a shared point acts: a slider rather than a rod, else the link found first."""
    mechanism = motion.linkage.mechanism
    links = [name for name in mechanism.links_at(point) if name != FRAME]
    sliding = [slide.link for slide in mechanism.slides]
    return next((name for name in links if name in sliding), links[0])


def lever_terms(given: Loads, motion: Motion, load: Loading) -> Array:
    """Zhukovsky's lever: powers of all loads, inertia among them, one row a load, W.

    The velocity plan turned by 90° is a lever; the moment of a force about its pole is the force's power.
    """
    mechanism = motion.linkage.mechanism
    turned_plan = {point: 1j * motion.velocity(point) for point in motion.point_index}
    rows = []
    for link, vector in load.inertia.items():
        rows.append(-cross(turned_plan[str(mechanism.links[link].mass_centre)], vector + load.gravity[link]))
    rows += [-cross(turned_plan[f.at], vector) for f, vector in zip(given.forces, load.forces, strict=True)]
    rows += [couple * motion.angular_velocity(link) for link, couple in load.couples.items()]
    rows += [c * motion.angular_velocity(m.on) for m, c in zip(given.moments, load.moments, strict=True)]
    return np.array(rows) if rows else np.zeros((1, *motion.shape))


def external_power(given: Loads, motion: Motion, load: Loading) -> Array:
    """Power of gravity and of the stated forces and moments, W; no inertia."""
    mechanism = motion.linkage.mechanism
    power = np.zeros(motion.shape)
    for link, weight in load.gravity.items():
        power = power + dot(weight, motion.velocity(str(mechanism.links[link].mass_centre)))
    for stated, vector in zip(given.forces, load.forces, strict=True):
        power = power + dot(vector, motion.velocity(stated.at))
    for on, couple in zip(given.moments, load.moments, strict=True):
        power = power + couple * motion.angular_velocity(on.on)
    return power


def kinetic_energy(motion: Motion) -> Array:
    """Kinetic energy of all links, J, (..., P)."""
    energy = np.zeros(motion.shape)
    for name, link in motion.linkage.mechanism.links.items():
        if name != FRAME:
            if link.mass_centre is not None:
                v = motion.velocity(link.mass_centre)
                energy = energy + link.mass * dot(v, v) / 2
            energy = energy + link.inertia * motion.angular_velocity(name) ** 2 / 2
    return energy


def _kinetic_power(motion: Motion) -> Array:
    """dT/dt by a difference of the kinetic energy: from velocities alone, so it checks every acceleration.

    The step shrinks where the motion changes fast: towards a singular position, and where a link turns faster than
    the driving link.
    """
    omega = motion.state.w[motion.linkage.mechanism.driver.link]
    ratios = [np.abs(motion.angular_velocity(link) / omega) for link in motion.linkage.mechanism.moving]
    shrinks = np.ones(motion.shape)
    step = np.full(motion.shape, 0.007)
    for group in motion.linkage.groups:
        sine = np.maximum(motion.sines[group.group.label], SINGULAR)
        for (
            change
        ) in group.changes:  # there the motion is smooth, but near positions differ by rounding errors
            beside = np.abs(np.angle(np.exp(1j * (motion.phi - change)))) < 0.15
            step, sine = np.where(beside, 0.03, step), np.where(beside, 1.0, sine)
        shrinks = np.minimum(shrinks, sine)
    step = step * shrinks / np.maximum.reduce(ratios)
    k = np.arange(1, len(DIFFERENCE) + 1).reshape(-1, *(1,) * len(motion.shape))
    phi = np.stack([motion.phi + k * step, motion.phi - k * step])
    energy = kinetic_energy(solve_motion(motion.linkage, phi))
    return _summed(energy[0] - energy[1]) / step * omega


def _summed(rows: Array) -> Array:
    """The sum of rows (N, ..., P) of a difference: of many variants each by itself, as the order in which products are
    added depends on how many there are."""
    if rows.ndim == 2:
        return np.tensordot(np.array(DIFFERENCE), rows, axes=1)
    return np.array([_summed(np.ascontiguousarray(rows[:, v])) for v in range(rows.shape[1])])
