"""The solved mechanism as chapters of the machine in motion take it, and reduced to its driving link over the cycle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinetostatics.quantities.positions import stated_loads, weight
from tmm_report.chapters.lever.kinetostatics.solve.positions import (
    Kinetostatics,
    Loading,
    breaks,
    loading,
    powers_of,
)
from tmm_report.mechanics.calculus.panels import Panels, panels
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.motion import solve as moved
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.sheet import Q, Sheet
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.friction.solve import FrictionFound, Reduced
    from tmm_report.chapters.lever.kinetostatics.given import Loads

Array = Any
Load = tuple[Quantity, Array]


@dataclass(frozen=True, eq=False)
class Moving:
    """The solved lever mechanism as the chapters of the machine in motion take it. `forces`: None without loads;
    `friction`: None where no friction is stated."""

    kinematics: Kinematics
    forces: Kinetostatics | None
    friction: FrictionFound | None = None


@dataclass(frozen=True, eq=False)
class PairFriction:
    """Friction of the mechanism's pairs, reduced to the driving link, as it is at the stated speed: its `mean` over the
    cycle, N m, nan where reactions grow without bound somewhere; `moment` (K, n), N m, at the points of the machine's
    panels, against the rotation, None where it is left out; `asked`: whether it is to be in; `corrected`: by the
    reactions with friction."""

    mean: float
    moment: Array | None
    asked: bool
    corrected: bool

    @property
    def bounded(self) -> bool:
        return not math.isnan(self.mean)


@dataclass(frozen=True, eq=False)
class Machine:
    """The mechanism reduced to its driving link over the cycle, at the points `panels.x` (K, n): angles turned from
    position 0 in the sense of rotation, rad, so that all signs are by that sense: a moment above zero drives.

    `inertia`: link -> its part, kg m²; `slope`: of the whole by the angle turned, kg m²/rad; `moments`: each weight and
    stated load with its part, N m; `omega`: angular velocity of the driving link as stated, its size, rad/s; `motion`:
    at all the points in a row; `friction`: of the pairs, None where none is stated, not among the `moments`.
    """

    panels: Panels
    motion: Motion
    inertia: Mapping[str, Array]
    slope: Array
    moments: tuple[Load, ...]
    omega: float
    friction: PairFriction | None = None

    @cached_property
    def whole_inertia(self) -> Array:
        return np.sum(list(self.inertia.values()), axis=0) + np.zeros(self.panels.shape)

    @cached_property
    def whole_moment(self) -> Array:
        return np.sum([part for _, part in self.moments], axis=0) + np.zeros(self.panels.shape)

    @cached_property
    def rubbing(self) -> Array:
        """Moment of friction, (K, n), N m, below zero; nothing where it is left out."""
        kept = self.friction.moment if self.friction else None
        return np.zeros(self.panels.shape) if kept is None else -kept

    @property
    def rubs(self) -> bool:
        """Whether the friction of the pairs is in the motion."""
        return self.friction is not None and self.friction.moment is not None

    @property
    def friction_power(self) -> float:
        """Mean power of friction at the stated speed, W, whether it is in or left out."""
        return self.friction.mean * self.omega if self.friction else 0.0

    @property
    def friction_share(self) -> float:
        """Of the mean power that drives: of what the loads give, or of what loads and friction take together; %."""
        lost = self.friction.mean if self.friction else 0.0
        loads = float(self.panels.mean(self.whole_moment))
        driving = max(loads, lost, lost - loads)
        return 100 * lost / driving if driving else 0.0


def machine(moving: Moving, friction: bool = False) -> Machine:
    """Reduced over the cycle, for exact integrals; `friction`: with that of the pairs, where it is stated. Raises
    ProblemError where the driving link makes no full turn."""
    cycle = moving.kinematics.cycle
    given = moving.forces.given if moving.forces else None
    reduced = moving.friction.reduced if moving.friction else None
    if friction and reduced is not None:
        edges = reduced.panels.edges  # the kinks of the friction among them
    else:
        edges = breaks(given, moving.kinematics) if given else cycle.repeated(cycle.corners)
    over = panels(cycle.period, edges)
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
        _friction(reduced, over, friction) if moving.friction else None,
    )


def _friction(reduced: Reduced | None, over: Panels, asked: bool) -> PairFriction:
    if reduced is None:
        return PairFriction(math.nan, None, asked, False)
    moment = reduced.panels.at(reduced.moment, over.x) if asked else None
    return PairFriction(float(reduced.panels.mean(reduced.moment)), moment, asked, reduced.corrected)


FRICTION_POWER = Q("P_fr", "W", N_("mean power of friction in the pairs at the stated speed"))
FRICTION_SHARE = Q(
    None, "%", N_("part of the mean power that drives the mechanism which friction in the pairs takes")
)


def put_friction(s: Sheet, found: Machine | None) -> None:
    """What the friction of the pairs takes, `P_fr` and `P_fr_share`; nothing where it is not known."""
    if found is not None and found.friction is not None and found.friction.bounded:
        s.put("P_fr", found.friction_power)
        s.put("P_fr_share", found.friction_share)


def friction_told(found: Machine | None) -> str:
    """The sentence on the friction of the pairs, with %(power)s and %(share)s; "" where none is stated."""
    if found is None or found.friction is None:
        return ""
    if not found.friction.bounded:
        return N_(
            "The friction of the kinematic pairs is left out: beside some position of the cycle the reactions grow "
            "without bound, and it has no mean."
        )
    if not found.friction.asked:
        return N_(
            "The friction of the kinematic pairs is left out of the resistances, as the variant states; at the "
            "stated speed it takes %(power)s W on average, %(share)s %% of the power that drives the mechanism."
        )
    if found.friction.corrected:
        return N_(
            "The friction of the kinematic pairs is among the resistances. Its moment reduced to the driving link is "
            "taken over the cycle as at the stated speed, by the reactions corrected for friction, and acts against "
            "the rotation at any speed; its mean power at the stated speed is %(power)s W, %(share)s %% of the power "
            "that drives the mechanism."
        )
    return N_(
        "The friction of the kinematic pairs is among the resistances. Its moment reduced to the driving link is taken "
        "over the cycle as at the stated speed, by the reactions without friction, and acts against the rotation at "
        "any speed; its mean power at the stated speed is %(power)s W, %(share)s %% of the power that drives the "
        "mechanism."
    )


def friction_doubts(found: Machine | None, block: str) -> Iterator[Problem]:
    """The friction of the pairs is asked for in a block, and cannot be had."""
    if found is not None and found.friction and found.friction.asked and not found.friction.bounded:
        text = N_(
            "the friction of the pairs is left out: beside some position of the cycle the reactions grow without bound"
        )
        right = Message(N_("friction: false in this block says that it is meant so"))
        yield doubt(text, (block,), right)


# ---------------------------------------------------------------- what the energy and the powers are made of


def by_stroke(motion: Motion, stroke: Stroke, s: Array, speed: float = 1.0) -> Motion:
    """The mechanism at strokes s, m, with the stroke growing uniformly by a speed, m/s."""
    return moved(motion.linkage, *stroke.rates(s, speed, 0.0))


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
    yield from zip(stated_loads(given), powers_of(given, motion, load), strict=True)
