"""Chapter of a machine whose main link slides: its motion over the stroke under forces by place, time and speed.

    d(m v²/2)/dx = F;   m dv/dt + (v²/2) dm/dx = F

with the reduced mass m of all that moves and the force F of all that acts along the motion, x being the way.
(Artobolevsky, Theory of mechanisms and machines, ch. 15–16; Frolov, Theory of mechanisms and machines, ch. 9)
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.moving import Moving
from tmm_report.chapters.machine.travel import steps
from tmm_report.chapters.machine.travel.given import Given as Given
from tmm_report.chapters.machine.travel.plant import Whole, whole
from tmm_report.chapters.machine.travel.values import OF_MECHANISM, Values
from tmm_report.mechanics.machine.reduced import Plant
from tmm_report.mechanics.machine.run.law import run
from tmm_report.mechanics.machine.run.motion_law import Goal, NeverReached, Run
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.quantity.text import amounts, number
from tmm_report.records import dataclass

Array = Any
AT_ONCE = 1e-7  # of the stroke: what stops within it has not moved


@dataclass(frozen=True, eq=False)
class Found:
    """`motion`: of the shaft that stands for the main link (see `plant`); `stops`: whether it comes to rest before the
    end of its way. Arrays (P,) at the samples, along the motion."""

    given: Given
    whole: Whole
    motion: Run
    stops: bool
    s: Values

    @property
    def t(self) -> Array:
        return self.motion.t

    @cached_property
    def x(self) -> Array:
        """The way passed, m."""
        return self.motion.phi / self.whole.turn

    @property
    def place(self) -> Array:
        return self.whole.begin + self.whole.way * self.x

    @cached_property
    def v(self) -> Array:
        v = self.motion.omega / self.whole.turn
        return np.append(v[:-1], 0.0) if self.stops else v

    @property
    def a(self) -> Array:
        return self.motion.epsilon / self.whole.turn

    @cached_property
    def mass(self) -> Array:
        return self.motion.inertia * self.whole.turn**2

    @cached_property
    def slope(self) -> Array:
        return self.at(self.whole.slope)

    def at(self, values: Array) -> Array:
        """A function at the points of the panels at the samples."""
        return self.whole.panels.at(np.broadcast_to(values, self.whole.panels.shape), self.motion.phi)

    def force(self, kind: str) -> Array:
        """All that acts of a kind, along the motion, N."""
        acting = (self.motion.of(one) for of, one in self.whole.acting if of == kind)
        return sum(acting, np.zeros(len(self.t))) * self.whole.turn

    @cached_property
    def work(self) -> Array:
        """Of all forces from the beginning, J: by the kinetic energy."""
        energy = self.mass * self.v**2 / 2
        return energy - energy[0]

    @property
    def waits(self) -> bool:
        """Whether the main link stands still at first."""
        return bool(self.t[0] > 0)

    @property
    def constant_mass(self) -> bool:
        return bool(np.ptp(self.whole.mass) <= 1e-12 * self.whole.mass.max())

    def summary(self) -> Iterator[Message]:
        text = N_("motion of the main link: %(t)s s, at its end %(v)s m/s")
        if self.stops:
            text = N_("motion of the main link: %(t)s s, it stops after %(x)s m")
        values = {"t": self.s.number("t_end"), "v": self.s.number("v_end"), "x": self.s.number("way")}
        yield Message(text, amounts({key: one for key, one in values.items() if f"%({key})s" in text}))


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism, where the variant has one. Raises ProblemError."""
    machine = whole(given, moving)
    if not np.all(machine.mass > 0):
        right = Message(N_("mass: of what slides"))
        raise ProblemError([mistake(N_("nothing in the machine has a mass"), ("travel",), right)])
    motion, stops = _run(machine, given.speed)
    found = Found(given, machine, motion, stops, Values(OF_MECHANISM if moving else None))
    steps.numbers(found)
    return found


def _run(machine: Whole, speed: float) -> tuple[Run, bool]:
    """To the end of the way, or to the rest before it. Raises ProblemError."""
    plant, start = machine.plant, speed * machine.turn
    try:
        return run(plant, start, Goal(angle=machine.length * machine.turn)), False
    except NeverReached as never:
        stalled = never
    except ArithmeticError:  # it would turn back at the very beginning, which no step gets beyond
        stalled = NeverReached("stall", start)
    if stalled.why == "stall" and stalled.phi > AT_ONCE:
        try:
            return run(plant, start, Goal(speed=0.0)), True
        except NeverReached as creeping:
            stalled = NeverReached("long", creeping.omega, stalled.phi)
    raise _never(machine, stalled, plant)


def _never(machine: Whole, why: NeverReached, plant: Plant) -> ProblemError:
    """Of a motion that does not begin, or does not end."""
    if why.why == "stall":
        force = (
            float(plant.places(0.0)[2] + sum(float(one.at(0.0, 0.0)) for one in plant.laws)) * machine.turn
        )
        text = N_(
            "the main link does not move: at the beginning the forces along the motion are %(force)s N together"
        )
        right = Message(
            N_("greater driving forces, less resistance, a speed at the beginning, or the other way")
        )
        return ProblemError([mistake(text, ("travel",), right, force=_text(force))])
    text = N_(
        "the main link does not come to the end of its way, nor to rest: after %(x)s m it creeps at %(v)s m/s"
    )
    right = Message(N_("a shorter way, or a force that drives or stops the main link"))
    values = {"x": _text(why.phi / machine.turn), "v": _text(why.omega / machine.turn)}
    return ProblemError([mistake(text, ("travel",), right, **values)])


def _text(value: float) -> str:
    return number(value, 4, ".")
