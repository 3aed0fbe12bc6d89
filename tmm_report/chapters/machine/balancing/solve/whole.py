"""Chapter of the mechanism balanced on its foundation: shaking force and moment over the cycle, counterweights by
several methods and what each leaves, harmonics of the force, sliders with Lanchester's rotors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.machine.balancing import steps
from tmm_report.chapters.machine.balancing.given import FULL, Given
from tmm_report.chapters.machine.balancing.solve import moment
from tmm_report.chapters.machine.balancing.solve.cases import (
    CLOSED,
    MAX,
    ORIGINAL,
    RMS,
    Case,
    Ground,
    Rotor,
    Shaken,
    disagreement,
)
from tmm_report.chapters.machine.balancing.solve.counterweights import (
    cases,
    force_harmonics,
    pairs_of_rotors,
    turned_back,
)
from tmm_report.chapters.machine.balancing.solve.slider_cranks import Remaining, remaining
from tmm_report.chapters.machine.balancing.solve.substituted_masses import Substituted, substitute, unreached
from tmm_report.chapters.machine.balancing.values import Slider, Values
from tmm_report.mechanics.calculus import harmonics as fourier
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.masses.counterweights import shaking, smallest_circle
from tmm_report.mechanics.masses.slider_harmonics import SliderCrank, slider_cranks
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.text import Amount
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Case", "Found", "Given", "solve"]

Array = Any
UNSIZED = {1: 1.0, 2: 1.0}  # rotors of which no radius is stated
TURNS = Message(N_("a mechanism that turns all round, or take this block out"))
JUMPING = N_(
    "the acceleration of the cam's follower jumps within the turn: the harmonics of the shaking force fall too slowly"
)
SMOOTH = Message(N_("a law without shocks, sine or polynomial, or take this block out"))
BROKEN = N_(
    "the motion has a break within the turn: in some position the links can turn over, two motions meet there"
)


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `s`, `sliders`: the single numbers, of the whole and of every slider-crank; `turned`: of the
    cycle's positions, rad; `unreached`: links that keep the mechanism from being balanced fully; `harmonics`: of the
    force, −K … K; `seen`: the force in the axes of the driving link over ω², kg m."""

    given: Given
    kinematics: Kinematics
    s: Values
    sliders: tuple[Slider, ...]
    about: str
    turned: Array
    original: Case
    cases: tuple[Case, ...]
    substituted: Substituted
    unreached: tuple[str, ...]
    harmonics: Array
    rotors: tuple[Rotor, ...]
    seen: Array
    circle: tuple[complex, float]
    cranks: tuple[SliderCrank, ...]
    remains: tuple[Remaining, ...]
    cycle_remains: tuple[Remaining, ...]

    @property
    def every(self) -> tuple[Case, ...]:
        return (self.original, *self.cases)

    def complete(self, case: Case) -> bool:
        """Whether nothing but rounding is left of the force."""
        return case.force_max.value <= CLOSED * self.original.force_max.value

    def best(self) -> Case | None:
        """Of all the cases the one that leaves least of the force."""
        return min(self.cases, key=lambda case: case.force_max.value, default=None)

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        greatest = self.original.force_max.value
        if (best := self.best()) is not None and greatest:
            text = N_("greatest shaking force %(force)s N; %(percent)s %% of it is left at best")
            left = 0.0 if self.complete(best) else 100 * best.force_max.value / greatest
            yield Message(text, {"force": Amount(greatest, 5), "percent": Amount(left, 3)})


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism. Raises ProblemError where there is nothing to balance, the driving link
    makes no full turn, or counterweights are not stated."""
    if moving is None:
        raise ProblemError([_nothing(N_("there is no mechanism to balance"))])
    found = moving.kinematics
    ground, tail = _ground(given, found)
    missing = tuple(unreached(found.linkage))
    if missing and given.ways == (FULL,):
        raise ProblemError([_not_whole(missing)])
    substituted = substitute(found.linkage, given.part)
    cranks = tuple(slider_cranks(found.linkage, found.cycle, substituted.sliding))
    at_table, at_steps = (
        tuple(remaining(crank, ground.motions[k], ground.turned[k]) for crank in cranks) for k in (0, 2)
    )
    seen = turned_back(ground)
    between = fourier.fine(seen)
    circle = smallest_circle(between)[:2]
    targets = {RMS: complex(between.mean()), MAX: circle[0]}
    every = tuple(cases(ground, given, substituted, not missing, targets))
    every += tuple(moment.cases(ground, given, (ground.original, *every)))
    s = steps.whole(given, (ground.original, *every), tail, seen, circle)
    return Found(
        given,
        found,
        s,
        tuple(steps.slider(given, *of) for of in zip(cranks, at_steps, strict=True)),
        _point(given, found),
        ground.turned[2],
        ground.original,
        every,
        substituted,
        missing,
        force_harmonics(ground.original, found.cycle.sense, given.highest),
        tuple(pairs_of_rotors(ground, given.radii or UNSIZED)),
        seen,
        circle,
        cranks,
        at_table,
        at_steps,
    )


def _ground(given: Given, found: Kinematics) -> tuple[Ground, float]:
    """The motion at so many equal steps that the harmonics left out are rounding, and how the mechanism shakes."""
    cycle = found.cycle
    _must_turn(cycle, found.table)
    about = complex(found.linkage.mechanism.links[FRAME].points[_point(given, found)])
    motions: dict[int, Motion] = {}

    def force(count: int) -> Array:
        motions[count] = cycle.motion(np.arange(count) * (2 * np.pi / count))
        _must_turn(cycle, motions[count])
        return shaking(motions[count], about)[0]

    count, tail = fourier.enough(force)
    if tail > fourier.BROKEN:
        text, right = (JUMPING, SMOOTH) if found.linkage.mechanism.cams else (BROKEN, TURNS)
        raise ProblemError([mistake(text, ("balancing",), right)])
    own = (found.table, found.diagram, motions[count])
    turned = (found.turned, found.diagram_turned, np.arange(count) * (2 * np.pi / count))
    table, diagram, fine = (Shaken(*shaking(motion, about)) for motion in own)
    original = Case(ORIGINAL, (), (), table, diagram, fine)
    ground = Ground(found.linkage, cycle, about, own, turned, original)
    if not ground.size:
        raise ProblemError([_nothing(N_("there is nothing to balance: no link with a mass is accelerated"))])
    return _checked(ground), tail


def _checked(ground: Ground) -> Ground:
    """The mechanism as it is by the reactions of the frame, its moment without rounding."""
    of = ground.original
    check = disagreement(ground.motions[0], of.table, ground.about, ground.size)
    table, diagram, fine = (
        Shaken(shaken.force, ground.settled(shaken.moment, arm))
        for shaken, arm in zip(of.shaken, ground.arms, strict=True)
    )
    return replace(ground, original=Case(ORIGINAL, (), (), table, diagram, fine, check))


def _point(given: Given, found: Kinematics) -> str:
    return given.about or found.linkage.structure.driver_pair.name


def _must_turn(cycle: Cycle, motion: Motion) -> None:
    if not (cycle.closed and motion.closes.all()):
        text = N_("the driving link makes no full turn: shaking is judged over a full turn")
        raise ProblemError([mistake(text, ("balancing",), TURNS)])
    rates = sum(motion.angular_acceleration(link) for link in motion.linkage.mechanism.moving)
    if not np.all(np.isfinite(rates)):
        text = N_(
            "in a singular position the accelerations are not determined, and so the shaking over a turn"
        )
        raise ProblemError([mistake(text, ("balancing",), TURNS)])


def _nothing(text: str) -> Any:
    return mistake(text, ("balancing",), Message(N_("give the links their mass, mass_centre and inertia")))


def _not_whole(links: tuple[str, ...]) -> Any:
    text = N_(
        "the mechanism cannot be balanced fully: no path of pivots joins links %(links)s to the frame, only guides do"
    )
    right = Message(N_("the methods pivoted, substituted or optimum, which leave a part of the force"))
    return mistake(text, ("balancing", "methods"), right, links=", ".join(links))
