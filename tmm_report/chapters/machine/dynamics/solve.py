"""Chapter of the machine in motion: reduced to one shaft, its start-up, steady motion and run-down.

    d(J ω²/2)/dφ = M;   J dω/dt + J′ ω²/2 = M;   d/dt ∂L/∂ω − ∂L/∂φ = Q, L = J ω²/2 − V

(Artobolevsky, Theory of mechanisms and machines, ch. 15–16; Frolov, Theory of mechanisms and machines, ch. 9)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.moving import Moving, friction_doubts
from tmm_report.chapters.machine.dynamics import refusals, steps
from tmm_report.chapters.machine.dynamics.given import Given
from tmm_report.chapters.machine.dynamics.inverted import turned_round
from tmm_report.chapters.machine.dynamics.joined import Joined, joined
from tmm_report.chapters.machine.dynamics.parts import parts_table
from tmm_report.chapters.machine.dynamics.plant import MOTOR, RUBBING, WEIGHT, WORK, Whole, whole
from tmm_report.chapters.machine.dynamics.regimes import (
    is_open,
    run_down,
    start_up,
    starts,
    stated_top,
    steady_motion,
)
from tmm_report.chapters.machine.dynamics.values import Values, sheet
from tmm_report.mechanics.machine.reduced import Acting, Plant
from tmm_report.mechanics.machine.run.by_angle import running_at
from tmm_report.mechanics.machine.run.motion_law import Run
from tmm_report.mechanics.machine.run.steady import Steady
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt
from tmm_report.quantity.model import Table
from tmm_report.quantity.text import Amount, amounts
from tmm_report.records import dataclass

__all__ = ["Found", "Given", "solve"]

Array = Any
POSITIONS = 12  # of the table of a machine without a mechanism
CURVE = 72  # intervals between the speeds of the characteristics


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `s`: the single numbers; `turned`: angles of the table, rad; `diagram_turned`: of the diagrams;
    `steady`: None where the motion does not become steady; `start`, `coast`: None where they are not asked for;
    `joined`: the regimes one after another, None where no two follow each other."""

    given: Given
    whole: Whole
    moving: Moving | None
    turned: Array
    diagram_turned: Array
    steady: Steady | None
    start: Run | None
    coast: Run | None
    joined: Joined | None
    s: Values

    @cached_property
    def parts(self) -> Table | None:
        """The table of the parts, where there are any."""
        return parts_table(self.whole.parts, self.given.gravity) if self.given.parts else None

    @property
    def runs(self) -> Iterator[tuple[str, Run]]:
        yield from (
            (name, found)
            for name, found in (("start", self.start), ("coast", self.coast))
            if found is not None
        )

    @property
    def moves(self) -> bool:
        """Whether a regime is found; else there is the machine reduced to its shaft alone."""
        return self.steady is not None or any(True for _ in self.runs)

    @property
    def uniformly(self) -> bool:
        """Whether, without a regime, what is reduced says the acceleration: all is constant."""
        return not self.moves and self.even and not self.supplied.of

    @property
    def ends_near(self) -> bool:
        """Whether the start-up ends near the steady motion."""
        return self.given.start is not None and is_open(self.given.start)

    @property
    def even(self) -> bool:
        """Whether the steady speed does not vary over the cycle."""
        return self.supplied.even

    @property
    def constant_inertia(self) -> bool:
        """Whether the moment of inertia does not vary over the cycle."""
        return not self.whole.slope.any()

    def at(self, values: Array, turned: Array) -> Array:
        """A function over the cycle at any angles."""
        return self.whole.panels.at(values, turned)

    @cached_property
    def supplied(self) -> Plant:
        """The machine with its motor, as in the start-up."""
        return self.whole.plant(self.given.start.motor if self.given.start else "on")

    @property
    def by_speed(self) -> bool:
        return "speed" in self.supplied.of

    @cached_property
    def speeds(self) -> Array:
        """Speeds of the table of characteristics, rad/s; None where nothing depends on the speed."""
        if not self.by_speed:
            return None
        tops = [self.steady.extremes[1][0]] if self.steady is not None else []
        tops += [float(run.omega.max()) for _, run in self.runs]
        return np.linspace(0.0, 1.05 * max(tops or [stated_top(self.given)]), CURVE + 1)

    def moments(self, omega: Array) -> tuple[Array, Array, Array]:
        """At speeds at the points of the panels (K, n): driving moment; moment of loads, weights and springs, along
        the rotation; that of the resistances, against it."""
        plant, zero = self.supplied, np.zeros(self.whole.panels.shape)
        kinds = {one.key: kind for kind, one in self.whole.acting}
        parts = {MOTOR: zero, RUBBING: zero, WEIGHT: zero, WORK: zero}
        for one in plant.acting:
            kind = kinds.get(one.key, MOTOR)
            parts[kind] = parts[kind] + (one.values if one.by_angle else one.at(omega))
        return parts[MOTOR], parts[WEIGHT] + parts[WORK], -parts[RUBBING]

    # ------------------------------------------------------------ of the steady motion, at any angles

    def work(self, turned: Array) -> Array:
        """Of all that acts from position 0, J."""
        steady = self._moving_on()
        return self._running(steady.moment, turned)

    def omega(self, turned: Array) -> Array:
        """rad/s."""
        return self.at(self._moving_on().omega, turned)

    def time(self, turned: Array) -> Array:
        """From position 0, s."""
        return self._running(1 / self._moving_on().omega, turned)

    def _moving_on(self) -> Steady:
        assert self.steady is not None
        return self.steady

    def _running(self, values: Array, turned: Array) -> Array:
        panels = self.whole.panels
        turns = np.floor(turned / panels.period + 1e-12)
        inside = np.maximum(turned - turns * panels.period, 0.0)
        return turns * panels.total(values) + running_at(panels, values, inside)

    @property
    def placed_weights(self) -> list[Acting]:
        """Weights and springs whose potential depends on the angle alone: not the masses that are lifted on and on."""
        return [
            one for one in self.whole.conservative if np.ptp(one.values) or not one.key.startswith("weight")
        ]

    @property
    def has_potential(self) -> bool:
        return bool(self.placed_weights)

    @cached_property
    def conservative(self) -> float:
        """Worst relative difference of −dV/dφ from the moment of weights and springs; nan where there is none."""
        if not self.has_potential:
            return float("nan")
        moment = np.sum([one.values for one in self.placed_weights], axis=0)
        slope = self.whole.panels.slope(self.whole.potential)
        return float(np.abs(moment + slope).max() / (np.abs(moment).max() or 1.0))

    @property
    def doubts(self) -> Iterator[Problem]:
        yield from friction_doubts(self.whole.machine, "dynamics")
        if self.given.cycles is not None and not (self.joined and self.joined.cycles):
            text = N_(
                "no steady motion is joined with a start-up or a run-down, so no cycles of it are shown"
            )
            right = Message(N_("state a start-up that leads to it, a run-down from it, or leave the key out"))
            yield doubt(text, ("dynamics", "cycles"), right)

    def _said(self, **keys: str) -> dict[str, Amount]:
        return amounts({name: self.s.number(key) for name, key in keys.items()})

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        if self.steady is not None and self.even:
            text = N_("machine in motion: steady speed %(omega)s rad/s")
            yield Message(text, self._said(omega="omega_m"))
        elif self.steady is not None:
            text = N_(
                "machine in motion: mean speed %(omega)s rad/s, coefficient of speed fluctuation %(delta)s"
            )
            yield Message(text, self._said(omega="omega_m", delta="delta"))
        if self.uniformly:
            text = N_("machine in motion: angular acceleration %(epsilon)s rad/s²")
            yield Message(text, self._said(epsilon="epsilon"))
        if self.start is not None:
            text = N_("start-up: %(t)s s, %(turns)s turns")
            yield Message(text, self._said(t="t_start", turns="turns_start"))
        if self.coast is not None:
            text = N_("run-down: %(t)s s, %(turns)s turns")
            yield Message(text, self._said(t="t_coast", turns="turns_coast"))


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism, where the variant has one. Raises ProblemError."""
    start = given.start
    try:
        machine, plant, steady = _moved(given, moving, ())
    except ProblemError as error:
        raise _with_a_ratio_turned_round(error, given, moving) from None
    if steady is not None and steady.bends.size:
        machine, plant, steady = _moved(given, moving, steady.bends)
    turned, diagram = _angles(machine, moving)
    started = start_up(plant, start, steady) if start is not None else None
    coasted = run_down(machine, given.coast, steady) if given.coast is not None else None
    found = Found(
        given, machine, moving, turned, diagram, steady, started, coasted,
        joined(given, machine, plant, steady, started, coasted), sheet(given),
    )  # fmt: skip
    steps.numbers(found)
    return found


def _moved(given: Given, moving: Moving | None, bends: Sequence[float]) -> tuple[Whole, Plant, Steady | None]:
    """The machine as it starts, and its steady motion; `bends`: of that motion. Raises ProblemError."""
    start, machine = given.start, whole(given, moving, bends)
    plant = machine.plant(start.motor if start else "on")
    if start is not None and start.begin == 0:
        starts(plant, start)
    return machine, plant, steady_motion(given, machine, plant, start)


def _with_a_ratio_turned_round(error: ProblemError, given: Given, moving: Moving | None) -> ProblemError:
    """What is wrong; of a machine that its motor does not move the ratio with whose reciprocal it would, first."""
    if [one.path for one in error.problems] != [("dynamics", "motor")]:
        return error
    for path, ratio, other in turned_round(given):
        try:
            _moved(other, moving, ())
        except ProblemError:
            continue
        return refusals.inverted(error.problems[0], path, ratio)
    return error


def _angles(machine: Whole, moving: Moving | None) -> tuple[Array, Array]:
    if moving is not None:
        return moving.kinematics.turned, moving.kinematics.diagram_turned
    period = machine.panels.period
    return np.linspace(0, period, POSITIONS + 1), np.linspace(0, period, 6 * POSITIONS + 1)
