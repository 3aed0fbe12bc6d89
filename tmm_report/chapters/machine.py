"""The solved mechanism as chapters of the machine in motion take it, and reduced to its driving link over the cycle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.kinematics.solve import Kinematics
from tmm_report.chapters.kinetostatics.quantities import forces, moments, weight
from tmm_report.chapters.kinetostatics.solve import Kinetostatics, Loading, breaks, loading
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import Motion
from tmm_report.mechanics.panels import Panels, panels
from tmm_report.mechanics.planar import dot
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.model import Quantity
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.kinetostatics.loads import Loads

Array = Any
Load = tuple[Quantity, Array]


@dataclass(frozen=True, eq=False)
class Moving:
    """The solved lever mechanism as the chapters of the machine in motion take it. `forces`: None without loads."""

    kinematics: Kinematics
    forces: Kinetostatics | None


@dataclass(frozen=True, eq=False)
class Machine:
    """The mechanism reduced to its driving link over the cycle, at the points `panels.x` (K, n): angles turned from
    position 0 in the sense of rotation, rad, so that all signs are by that sense: a moment above zero drives.

    `inertia`: link -> its part, kg m²; `slope`: of the whole by the angle turned, kg m²/rad; `moments`: each weight and
    stated load with its part, N m; `omega`: angular velocity of the driving link as stated, its size, rad/s; `motion`:
    at all the points in a row.
    """

    panels: Panels
    motion: Motion
    inertia: Mapping[str, Array]
    slope: Array
    moments: tuple[Load, ...]
    omega: float

    @cached_property
    def whole_inertia(self) -> Array:
        return np.sum(list(self.inertia.values()), axis=0) + np.zeros(self.panels.shape)

    @cached_property
    def whole_moment(self) -> Array:
        return np.sum([part for _, part in self.moments], axis=0) + np.zeros(self.panels.shape)


def machine(moving: Moving) -> Machine:
    """Reduced over the cycle, for exact integrals. Raises ProblemError where the driving link makes no full turn."""
    cycle = moving.kinematics.cycle
    given = moving.forces.given if moving.forces else None
    over = panels(cycle.period, breaks(given, moving.kinematics) if given else ())
    turned = over.x.ravel()
    motion = cycle.motion(turned)
    if not cycle.closed or not motion.closes.all():
        text = N_("the driving link makes no full turn: the machine has no steady motion")
        raise ProblemError(
            [mistake(text, ("mechanism", "driver"), Message(N_("a mechanism that turns all round")))]
        )
    load = loading(given, moving.kinematics, motion, turned) if given else None
    taken = powers(given, motion, load) if given and load else ()
    return Machine(
        over,
        motion,
        {link: part.reshape(over.shape) for link, part in inertia_parts(motion)},
        cycle.sense * inertia_slope(motion).reshape(over.shape),
        tuple((of, power.reshape(over.shape) / abs(motion.omega)) for of, power in taken),
        abs(float(motion.omega)),
    )


# ---------------------------------------------------------------- what the energy and the powers are made of


def inertia_parts(motion: Motion) -> Iterator[tuple[str, Array]]:
    """Twice a link's kinetic energy by the square of the driver's angular velocity."""
    for name, link in motion.linkage.mechanism.links.items():
        if name == FRAME or not (link.mass or link.inertia):
            continue
        part = link.inertia * (motion.angular_velocity(name) / motion.omega) ** 2 * np.ones(motion.shape)
        if link.mass_centre is not None:
            part = part + link.mass * np.abs(motion.velocity(link.mass_centre) / motion.omega) ** 2
        yield name, part


def inertia_slope(motion: Motion) -> Array:
    """By the accelerations: dI/dφ = 2 Σ (m v·a + J ω ε)/ω₁³."""
    total = np.zeros(motion.shape)
    for name, link in motion.linkage.mechanism.links.items():
        if name != FRAME:
            total = total + link.inertia * motion.angular_velocity(name) * motion.angular_acceleration(name)
            if link.mass_centre is not None:
                point = link.mass_centre
                total = total + link.mass * dot(motion.velocity(point), motion.acceleration(point))
    return 2 * total / motion.omega**3


def powers(given: Loads, motion: Motion, load: Loading) -> Iterator[Load]:
    """Power of every weight and stated load, W."""
    links = motion.linkage.mechanism.links
    for link, force in load.gravity.items():
        yield weight(link), dot(force, motion.velocity(str(links[link].mass_centre)))
    for of, stated, force in zip(forces(given.forces), given.forces, load.forces, strict=True):
        yield of, dot(force, motion.velocity(stated.at))
    for of, on, couple in zip(moments(given.moments), given.moments, load.moments, strict=True):
        yield of, couple * motion.angular_velocity(on.on)
