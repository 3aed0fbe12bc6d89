"""The machine of the chapter, reduced to the link that slides, as the integrators of a shaft take it.

The way x from the beginning to the end, L, is half a turn of a shaft: φ = k x with k = π/L, J = m/k², M = F/k, ω = k v,
so that energies and times are the same. The other half goes on as at the end: an integrator may look ahead.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.solve.lengths import is_tie, is_torsion, law_of, path_of, ties_of
from tmm_report.chapters.lever.kinetostatics.solve.positions import loading
from tmm_report.chapters.lever.moving import Load, Moving, by_stroke, inertia_parts, inertia_slope, powers
from tmm_report.chapters.machine.travel.given import Given
from tmm_report.mechanics.calculus.laws import NOTHING, RATE, STROKE
from tmm_report.mechanics.calculus.panels import Panels, panels
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.machine.characteristics import Geared
from tmm_report.mechanics.machine.reduced import Acting, Plant
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.text import number
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
    from tmm_report.chapters.lever.kinetostatics.given import Loads

Array = Any
WIDEST = math.pi / 48  # of a panel: a mechanism near a limit of its stroke goes steeply
DRIVING, REDUCED, RESISTING = "driving", "reduced", "resistance"
WEIGHT, SPRING = "weight", "spring"


@dataclass(frozen=True, eq=False)
class Whole:
    """`way`: +1 where the place grows; `mass` and `slope`: m, kg, and dm/dx, kg/m, at the points of the panels, (K, n);
    `acting`: all that acts, with its kind; `loads`: what the loads of the mechanism are."""

    begin: float
    end: float
    panels: Panels
    mass: Array
    slope: Array
    acting: tuple[tuple[str, Acting], ...]
    loads: tuple[Load, ...] = ()
    stroke: Stroke | None = None

    @property
    def way(self) -> float:
        return math.copysign(1.0, self.end - self.begin)

    @property
    def length(self) -> float:
        return abs(self.end - self.begin)

    @property
    def turn(self) -> float:
        """k, rad/m."""
        return math.pi / self.length

    @cached_property
    def plant(self) -> Plant:
        k = self.turn
        return Plant(self.panels, self.mass / k**2, self.slope / k**3, tuple(one for _, one in self.acting))

    @property
    def even(self) -> bool:
        """Whether mass and forces are the same all the way, and neither time nor speed matter."""
        return self.plant.even and not self.plant.laws


def whole(given: Given, moving: Moving | None) -> Whole:
    """Raises ProblemError."""
    stroke = moving.kinematics.stroke if moving else None
    begin, end = _range(given, stroke)
    way, k = math.copysign(1.0, end - begin), math.pi / abs(end - begin)
    breaks = [
        way * (one.at - begin) * k
        for force in given.forces
        if force.law.of == STROKE
        for one in force.law.breaks()
    ]
    inner = [x for x in breaks if 0 < x < math.pi]
    over = panels(2 * math.pi, [*inner, math.pi], WIDEST)
    s = begin + way * np.minimum(over.x / k, abs(end - begin))
    mass = np.full(over.shape, given.mass + sum(one.inertia / one.radius**2 for one in given.wheels))
    slope = np.zeros(over.shape)
    loads: tuple[Load, ...] = ()
    if moving is not None and stroke is not None:
        own, slope, loads = _of_mechanism(moving, stroke, s, way)
        mass = mass + own
    acting = [*_forces(given, s, k), *_own(given, s, way, k)]
    acting += [(REDUCED, Acting(load.key, values=values / k)) for load, values in loads]
    return Whole(begin, end, over, mass, slope, tuple(acting), loads, stroke)


def _range(given: Given, stroke: Stroke | None) -> tuple[float, float]:
    """Places at the beginning and at the end. Raises ProblemError."""
    if stroke is None:
        begin, end = given.begin or 0.0, given.end or 0.0
    else:
        first = float(stroke.law.at(np.zeros(1))[0][0])
        low, high = stroke.law.reach
        begin = first if given.begin is None else given.begin
        end = (high if high - begin > begin - low else low) if given.end is None else given.end
        slack = 1e-9 * (high - low)
        for key, place in (("from", begin), ("to", end)):
            if not low - slack <= place <= high + slack:
                text = N_("%(place)s m is beyond the stroke of the mechanism, from %(low)s m to %(high)s m")
                right = Message(N_("a place within it, or another stroke of the driver"))
                values = {"place": _text(place), "low": _text(low), "high": _text(high)}
                raise ProblemError([mistake(text, ("travel", key), right, **values)])
    if abs(end - begin) <= 1e-9:
        text = N_("the motion ends where it begins")
        raise ProblemError([mistake(text, ("travel", "to"), Message(N_("another place at the end")))])
    return begin, end


def _text(value: float) -> str:
    return number(value, 4, ".")


# ---------------------------------------------------------------- the mechanism


def _of_mechanism(
    moving: Moving, stroke: Stroke, s: Array, way: float
) -> tuple[Array, Array, tuple[Load, ...]]:
    """Reduced mass, its derivative by the way, the parts of the loads in the reduced force along the motion."""
    given = moving.forces.given if moving.forces else None
    if given is not None:
        _steady(given, moving.kinematics)
    motion = by_stroke(moving.kinematics.table, stroke, s.ravel(), way)  # at 1 m/s along the motion
    omega = motion.omega
    mass = sum((part * omega**2 for _, part in inertia_parts(motion)), np.zeros(motion.shape))
    slope = inertia_slope(motion) * omega**3
    loads: tuple[Load, ...] = ()
    if given is not None:
        acts = loading(given, moving.kinematics, motion, np.zeros(motion.shape))
        loads = tuple((of, power.reshape(s.shape)) for of, power in powers(given, motion, acts))
    return mass.reshape(s.shape), slope.reshape(s.shape), loads


def _steady(given: Loads, kinematics: Kinematics) -> None:
    """Raises ProblemError for loads whose laws are read along the stated motion, which is not this one."""
    wrong = []
    for end in ties_of(given):
        if law_of(end.tie, kinematics).of == RATE:
            text = N_("a damper among the loads acts by the stated motion, and travel looks for another")
            right = Message(N_("state it in travel: resistance: [{viscous: …}]"))
            wrong.append(mistake(text, path_of(given, end), right))
    for key, many in (("forces", given.forces), ("moments", given.moments)):
        for k, one in enumerate(many):
            if not is_tie(one) and not is_torsion(one) and one.law.of != NOTHING:
                text = N_("this load changes along the stated motion, and travel looks for another")
                right = Message(N_("a constant load, or a force in travel: {by_place: …}"))
                wrong.append(mistake(text, ("loads", key, k), right))
    if wrong:
        raise ProblemError(wrong)


# ---------------------------------------------------------------- what is stated along the guide


def _forces(given: Given, s: Array, k: float) -> Iterator[tuple[str, Acting]]:
    for n, force in enumerate(given.forces, 1):
        kind = DRIVING if force.drives else RESISTING
        if force.law.of in (NOTHING, STROKE):
            values = force.sign * force.law.at(0.0, s) + np.zeros(s.shape)
            yield kind, Acting(f"force{n}", values=values / k)
        else:
            yield kind, Acting(f"force{n}", law=Geared(force.law, 1 / k), sign=force.sign)


def _own(given: Given, s: Array, way: float, k: float) -> Iterator[tuple[str, Acting]]:
    """The weight of what slides, and springs along the guide."""
    if given.rise and given.mass:
        pull = -given.mass * given.gravity * math.sin(given.rise)
        yield REDUCED, Acting(WEIGHT, values=np.full(s.shape, pull / k))
    for n, one in enumerate(given.springs, 1):
        yield REDUCED, Acting(f"{SPRING}{n}", values=-way * one.stiffness * (s - one.free) / k)
