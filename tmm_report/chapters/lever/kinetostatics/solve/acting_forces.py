"""What acts on a mechanism at its positions: weights, inertia forces and couples, stated forces and moments."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Carried, Force, Loads, Moment
from tmm_report.chapters.lever.kinetostatics.solve.law_arguments import reading
from tmm_report.chapters.lever.kinetostatics.solve.lengths import pulled
from tmm_report.chapters.lever.kinetostatics.ties import End
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.forces.reactions import Load
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any

STATED_WAY = Message(N_("state its direction by a word or an angle"))

Stated = tuple[Sequence[tuple[Array, Array]], Sequence[tuple[Array, Array]]]
"""Of every stated force, then of every moment: the vector (..., P), and how much of it is along its direction."""


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
    if isinstance(force, End):
        return pulled(force, kinematics, motion)
    size = reading(force, kinematics, motion, turned).value
    if isinstance(force.way, Carried):
        return size * np.exp(1j * force.way.angle) * motion.turn(force.way.link), size
    if not isinstance(force.way, str):
        return size * force.way, size
    velocity = motion.velocity(force.at)
    # standing still has no direction of motion: no force along it
    speed = np.abs(velocity)
    still = speed <= 1e-12 * np.nanmax(speed, initial=0.0)
    along = np.where(still, 0.0, velocity / np.where(still, 1.0, speed))
    return size * (along if force.way == "along" else -along), np.where(still, 0.0, size)


def _moment(moment: Moment, kinematics: Kinematics, motion: Motion, turned: Array) -> tuple[Array, Array]:
    """The moment, + counter-clockwise, and how much of it is in its stated sense."""
    size = reading(moment, kinematics, motion, turned).value
    if not isinstance(moment.direction, str):
        return size * moment.direction, size
    rate = motion.angular_velocity(moment.on)
    sense = np.where(np.abs(rate) <= 1e-12 * np.nanmax(np.abs(rate), initial=0.0), 0.0, np.sign(rate))
    return size * (sense if moment.direction == "along" else -sense), size * np.abs(sense)


def still(given: Loads, motion: Motion) -> Iterator[Problem]:
    """Loads that follow the motion of a point or link that stands still: they are nothing in every position."""
    rates = abs(motion.state.w[motion.linkage.mechanism.driver.link])
    for index, force in enumerate(given.forces):
        if isinstance(force.way, str) and not np.any(np.abs(motion.velocity(force.at)) > 0):
            text = N_("point %(point)s does not move: a force along or against its motion is nothing")
            yield doubt(text, ("loads", "forces", index, "direction"), STATED_WAY, point=force.at)
    for index, moment in enumerate(given.moments):
        turning = np.abs(motion.angular_velocity(moment.on))
        if isinstance(moment.direction, str) and not np.any(turning > 1e-12 * rates):
            text = N_("link %(link)s does not turn: a moment along or against its rotation is nothing")
            yield doubt(text, ("loads", "moments", index, "direction"), STATED_WAY, link=moment.on)


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
        add(loaded_link(motion, stated), vector, stated.at)
    for on, couple in zip(given.moments, load.moments, strict=True):
        moment[on.on] = moment[on.on] + couple
    return {name: Load(force[name], moment[name]) for name in mechanism.moving}


def loaded_link(motion: Motion, force: Force) -> str:
    """The link that takes a force: the one stated; of several at its point a slider rather than a rod, else the link
    described first."""
    if force.on is not None:
        return force.on
    mechanism = motion.linkage.mechanism
    links = [name for name in mechanism.links_at(force.at) if name != FRAME]
    sliding = [slide.link for slide in mechanism.slides]
    return next((name for name in links if name in sliding), links[0])
