"""The machine of the chapter: what is stated and the solved mechanism, reduced to the main shaft."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.quantities.positions import moments
from tmm_report.chapters.lever.kinetostatics.solve.lengths import (
    Twist,
    energy,
    is_torsion,
    ties_of,
    torsions_of,
    turned,
    twist_energy,
    twists,
    wound_up,
)
from tmm_report.chapters.lever.moving import Machine, Moving, machine
from tmm_report.chapters.machine.dynamics import refusals
from tmm_report.chapters.machine.dynamics.given import Given, Part, Spring, Supply
from tmm_report.mechanics.calculus.laws import ANGLE, NOTHING
from tmm_report.mechanics.calculus.panels import Panels, panels
from tmm_report.mechanics.calculus.vectors import dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.machine import reduced_train
from tmm_report.mechanics.machine.characteristics import Characteristic, reversed_
from tmm_report.mechanics.machine.passing import Passing
from tmm_report.mechanics.machine.reduced import Acting, Plant
from tmm_report.mechanics.machine.run.steady import NotSteady, closing
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.friction.solve import Reduced

Array = Any
MOTOR, BRAKE = "motor", "brake"
PAIRS = "pairs"  # friction of the mechanism's pairs
BESIDE = 1e-3  # rad: a bend so near to an edge costs no digits, a panel so narrow does
WORK, WEIGHT, RUBBING = "work", "weight", "friction"  # kinds of what acts beside the motor


@dataclass(frozen=True)
class ReducedPart:
    """`inertia`, kg m², and `moment`, N m, on the main shaft: the moment above zero where it resists. `weight`: the
    part of the mass's weight in it; `hanging`: what the weight alone is, without the working resistances."""

    part: Part
    inertia: float
    moment: float
    weight: float
    hanging: float


@dataclass(frozen=True, eq=False)
class Whole:
    """`acting`: all that acts without the motor, with its kind; `unloaded` (K, n): moment of the friction of the pairs
    where the stated loads do not act, None where it is not asked for; `potential` (K, n): energy of weights and springs
    that depends on the angle alone, J; `lifted`: moment of the weights that are lifted with the shaft, N m."""

    given: Given
    machine: Machine | None
    panels: Panels
    parts: tuple[ReducedPart, ...]
    inertia: Array
    slope: Array
    acting: tuple[tuple[str, Acting], ...]
    potential: Array
    balanced: float | None = None
    unloaded: Array = None

    @cached_property
    def added(self) -> float:
        """Moment of inertia of the parts on the main shaft, kg m²."""
        return sum(one.inertia for one in self.parts)

    @property
    def lifted(self) -> float:
        return sum(one.weight for one in self.parts)

    @cached_property
    def conservative(self) -> tuple[Acting, ...]:
        """What has a potential."""
        return tuple(one for kind, one in self.acting if kind == WEIGHT)

    def plant(self, supply: Supply = "on", brake: float = 0.0, load: bool = True) -> Plant:
        acting = [one for kind, one in self.acting if load or kind != WORK]
        if not load:
            acting = [self._unloaded(one) for one in acting]
        if brake:
            acting.append(Acting(BRAKE, values=np.full(self.panels.shape, -brake)))
        acting = [*self._motor(supply), *acting]
        return Plant(self.panels, self.inertia, self.slope, tuple(acting), self._passing(load))

    def _unloaded(self, one: Acting) -> Acting:
        """A weight that is lifted passes the gears alone; friction is that of the reactions without loads."""
        if one.key == PAIRS and self.unloaded is not None:
            return replace(one, values=self.unloaded)
        for k, part in enumerate(self.parts, 1):
            if one.key == f"weight{k}" and part.weight:
                return Acting(one.key, values=np.full(self.panels.shape, -part.hanging))
        return one

    def _passing(self, load: bool) -> Passing | None:
        parts = [one for one in self.parts if one.inertia and one.part.efficiency < 1]
        if not (self.given.passing and parts):
            return None
        moments = [taking(one.part, self.given.gravity, load) for one in parts]
        of = [[one.inertia for one in parts], moments, [one.part.efficiency for one in parts]]
        return Passing(*(np.array(row) for row in of))

    def _motor(self, supply: Supply) -> Iterator[Acting]:
        if supply == "off":
            return
        if self.given.motor is not None:
            yield _acting(MOTOR, self.given.motor.law, 1.0, self.panels, supply == "reversed")
        elif self.balanced is not None:
            yield Acting(MOTOR, values=np.full(self.panels.shape, self.balanced))


def whole(given: Given, moving: Moving | None, bends: Sequence[float] = ()) -> Whole:
    """`bends`: angles at which a moment is bent in the motion, edges of the panels too."""
    of = machine(moving, given.friction) if moving else None
    idle = _unloaded(given, moving, of)
    over = _panels(given, of, idle, bends)
    parts = tuple(_part(one, given) for one in given.parts)
    inertia, slope = _varying(given, of, over)
    added = sum(one.inertia for one in parts)
    if not np.all(inertia + added > 0):
        text = N_("nothing in the machine has a moment of inertia or a mass")
        raise ProblemError([mistake(text, ("dynamics",), Message(N_("state inertia or mass of the parts")))])
    acting = [*_loads(of, over, _turning(moving)), *_of_parts(parts, over, given.gravity)]
    acting += [*_springs(given, of, over), *_torsions(given, moving, of, over), *_laws(given, over)]
    pull = moving.forces.given.gravity if moving and moving.forces else 0j
    potential = _of_links(of, over, pull) + _potential(given, of, over) + _tied(given, moving, of, over)
    unloaded = None if idle is None else -idle.panels.at(idle.moment, over.x)
    found = Whole(given, of, over, parts, inertia + added, slope, tuple(acting), potential, unloaded=unloaded)
    if of is None or given.motor is not None:
        return found
    free = found.plant("off")
    closes = "speed" in free.of and free.mean_moment > 0
    if closes:  # an engine whose load depends on the speed
        return found
    mean = given.speed or of.omega
    return replace(found, balanced=-float(free.net(mean)) if "speed" in free.of else _closing(free, mean))


def _unloaded(given: Given, moving: Moving | None, of: Machine | None) -> Reduced | None:
    """Friction of the pairs of a machine that runs down without its loads: of the reactions without them."""
    if of is None or of.friction is None or of.friction.moment is None or moving is None:
        return None
    idle = given.coast is not None and not given.coast.load
    return moving.friction.unloaded if idle and moving.friction else None


def _closing(free: Plant, mean: float) -> float:
    try:
        return closing(free, mean)
    except NotSteady as stops:
        raise refusals.not_steady(stops.phi) from None


def _panels(given: Given, of: Machine | None, idle: Reduced | None, bends: Sequence[float]) -> Panels:
    """Those of the mechanism, or of the period, cut at the points of what is stated by angle too."""
    laws = [one.law for one in given.resistances] + ([given.motor.own] if given.motor else [])
    laws += [given.varying] if given.varying else []
    breaks = [one.at for law in laws if law.of == ANGLE for one in law.breaks()]
    if of is None:
        found = panels(given.period, breaks)
    else:
        breaks += idle.panels.edges.tolist() if idle is not None else []
        found = panels(of.panels.period, np.concatenate([of.panels.edges, breaks])) if breaks else of.panels
    apart = [x for x in bends if np.abs(found.edges - x).min() > BESIDE]
    return panels(found.period, np.concatenate([found.edges, apart])) if apart else found


def _moved(of: Machine, over: Panels, values: Array) -> Array:
    """A function of the mechanism at the points of the panels."""
    return values if over is of.panels else of.panels.at(values, over.x)


def _varying(given: Given, of: Machine | None, over: Panels) -> tuple[Array, Array]:
    """Moment of inertia without the parts, and its slope."""
    if of is not None:
        return _moved(of, over, of.whole_inertia), _moved(of, over, of.slope)
    if not given.varying:
        return np.zeros(over.shape), np.zeros(over.shape)
    return given.varying.value(over.x), given.varying.slope(over.x)


# ---------------------------------------------------------------- what acts


def _acting(key: str, law: Characteristic, sign: float, over: Panels, reverse: bool = False) -> Acting:
    """What depends on the angle alone as values at the points."""
    law = reversed_(law) if reverse else law
    if law.of in (NOTHING, ANGLE):
        return Acting(key, values=sign * law.at(0.0, over.x) + np.zeros(over.shape))
    return Acting(key, law=law, sign=sign)


def _turning(moving: Moving | None) -> set[str]:
    """The moments of torsion springs, by their keys."""
    given = moving.forces.given.moments if moving and moving.forces else ()
    return {of.key for of, one in zip(moments(given), given, strict=True) if is_torsion(one)}


def _loads(of: Machine | None, over: Panels, springs: set[str]) -> Iterator[tuple[str, Acting]]:
    """`springs`: keys of the moments that have a potential."""
    for load, values in of.moments if of else ():
        # springs between points are F_c1, F_c2, …
        kind = WEIGHT if load.key.startswith(("G_", "F_")) or load.key in springs else WORK
        yield kind, Acting(load.key, values=_moved(of, over, values))  # type: ignore[arg-type]
    if of is not None and of.friction is not None and of.friction.moment is not None:
        yield RUBBING, Acting(PAIRS, values=_moved(of, over, of.rubbing))


def _part(one: Part, given: Given) -> ReducedPart:
    inertia = reduced_train.inertia(one.ratio, one.inertia) + reduced_train.travelling(one.mass, one.arm)
    whole, own = taking(one, given.gravity), taking(one, given.gravity, load=False)
    share, alone = (float(reduced_train.side(of, one.efficiency)) for of in (whole, own))
    return ReducedPart(one, float(inertia), whole * share, own * share, own * alone)


def taking(one: Part, gravity: float, load: bool = True) -> float:
    """Moment that a part takes from the main shaft without losses, N m, all that acts on it together, as one power
    passes its gears; not `load`: by its weight alone."""
    weight = one.moves * one.mass * gravity * one.arm
    return weight + one.force * one.arm + one.moment * one.ratio if load else weight


def _of_parts(parts: tuple[ReducedPart, ...], over: Panels, gravity: float) -> Iterator[tuple[str, Acting]]:
    for k, one in enumerate(parts, 1):
        if one.weight:
            yield WEIGHT, Acting(f"weight{k}", values=np.full(over.shape, -one.weight))
        if one.moment != one.weight:
            yield WORK, Acting(f"part{k}", values=np.full(over.shape, one.weight - one.moment))
        if one.part.offset:
            lean = np.cos(over.x + one.part.angle)
            yield WEIGHT, Acting(f"weight{k}", values=-one.part.mass * gravity * one.part.offset * lean)


def _laws(given: Given, over: Panels) -> Iterator[tuple[str, Acting]]:
    for k, one in enumerate(given.resistances, 1):
        yield RUBBING, _acting(f"res{k}", one.law, -1.0, over)


def _springs(given: Given, of: Machine | None, over: Panels) -> Iterator[tuple[str, Acting]]:
    for k, one in enumerate(given.springs, 1):
        length, rate = _stretch(one, of, over)
        yield WEIGHT, Acting(f"spring{k}", values=-one.stiffness * (length - one.length) * rate)


def _torsions(
    given: Given, moving: Moving | None, of: Machine | None, over: Panels
) -> Iterator[tuple[str, Acting]]:
    """Moments of torsion springs by the power that they have: both of their links turn."""
    if moving is None or of is None:
        return
    for k, one in enumerate(_twists(given, moving), 1):
        pull = one.law.stiffness * (one.law.free - turned(one, moving.kinematics, of.motion))
        rates = [0.0 if link == FRAME else of.motion.angular_velocity(link) for link in (one.on, one.other)]
        values = (pull * (rates[0] - rates[1]) / of.omega).reshape(of.panels.shape)
        yield WEIGHT, Acting(f"torsion{k}", values=_moved(of, over, values))


def _twists(given: Given, moving: Moving) -> list[Twist]:
    """The first ends of the machine's own torsion springs. Raises ProblemError where one would be wound up."""
    found = [next(twists([one], FRAME)) for one in given.torsion_springs]
    paths = [("dynamics", "torsion_springs", k) for k in range(len(found))]
    if wrong := list(wound_up(zip(found, paths, strict=True), moving.kinematics)):
        raise ProblemError(wrong)
    return found


def _stretch(spring: Spring, of: Machine | None, over: Panels) -> tuple[Array, Array]:
    """Length of a spring, m, and its derivative by the angle turned."""
    if spring.at is None or spring.to is None or of is None:
        lean, r, a = over.x + spring.angle, spring.radius or 0.0, spring.apart or 0.0
        length = np.sqrt(r**2 + a**2 - 2 * r * a * np.cos(lean))
        return length, r * a * np.sin(lean) / length
    away = of.motion.place(spring.at) - complex(*spring.to)
    rate = dot(away, of.motion.velocity(spring.at)) / np.abs(away) / of.omega
    length = np.abs(away).reshape(of.panels.shape)
    return _moved(of, over, length), _moved(of, over, rate.reshape(of.panels.shape))


def _of_links(of: Machine | None, over: Panels, pull: complex) -> Array:
    """Potential of the links, by the heights of their mass centres against the gravity `pull`, m/s²."""
    total = np.zeros(over.shape)
    for name, link in of.motion.linkage.mechanism.links.items() if of else ():
        if of is not None and link.mass and link.mass_centre is not None and name != FRAME:
            height = -dot(of.motion.place(link.mass_centre), pull) * np.ones(of.motion.shape)
            total = total + link.mass * _moved(of, over, height.reshape(of.panels.shape))
    return total


def _tied(given: Given, moving: Moving | None, of: Machine | None, over: Panels) -> Array:
    """Potential of torsion springs, and of the springs among the loads of the mechanism, by angles and lengths."""
    if moving is None or of is None:
        return np.zeros(over.shape)
    turning, found = _twists(given, moving), list[Array]()
    if moving.forces is not None:
        loads = moving.forces.given
        found += [energy(end, moving.kinematics, of.motion) for end in ties_of(loads)]
        turning += torsions_of(loads)
    found += [twist_energy(one, moving.kinematics, of.motion) for one in turning]
    return sum((_moved(of, over, one.reshape(of.panels.shape)) for one in found), np.zeros(over.shape))


def _potential(given: Given, of: Machine | None, over: Panels) -> Array:
    """Of offset masses by their heights and of springs by their lengths, not by the work of the moments."""
    total = np.zeros(over.shape)
    for part in given.parts:
        if part.offset:
            total = total + part.mass * given.gravity * part.offset * np.sin(over.x + part.angle)
    for spring in given.springs:
        length, _ = _stretch(spring, of, over)
        total = total + spring.stiffness * (length - spring.length) ** 2 / 2
    return total
