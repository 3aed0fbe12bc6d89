"""Flywheel: its moment of inertia for a wanted unevenness by several methods and exactly, the motion without it and
with it, its dimensions.

The wanted value is that of the exact solution; the methods of the textbooks stand beside it. (Artobolevsky, Theory of
mechanisms and machines, ch. 16, 19; Frolov (ed.), Theory of mechanisms, ch. 4; Khurmi, Gupta, Theory of machines,
ch. 16)
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.moving import Moving, friction_doubts
from tmm_report.chapters.machine.flywheel import sizes, steps
from tmm_report.chapters.machine.flywheel.given import Given
from tmm_report.chapters.machine.flywheel.loads import Sides, mean_speed, sides
from tmm_report.chapters.machine.flywheel.methods import compared
from tmm_report.chapters.machine.flywheel.values import Values
from tmm_report.mechanics.machine.flywheel.inertia import METHODS, Cycle, Method
from tmm_report.mechanics.machine.flywheel.motion import Integrated, Turning, integrated, turning
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.formula import Var
from tmm_report.quantity.model import Table
from tmm_report.quantity.text import amounts
from tmm_report.records import dataclass

__all__ = ["Found", "Given", "solve"]

Array = Any
LEAST = 1e-12  # of the work of the moments: an excess work below it is rounding


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`. `s`: the single numbers; `methods`: by name, where a flywheel is wanted; `before`: the motion
    without it, None where the machine would come to a stand; `after`: with it; `proof`: the same integrated step by
    step; `moving`: the lever mechanism, None of a machine that stands alone."""

    given: Given
    s: Values
    sides: Sides
    methods: dict[str, Method]
    before: Turning | None
    after: Turning
    proof: Integrated
    moving: Moving | None

    @property
    def lever(self) -> bool:
        """Whether the machine is a lever mechanism."""
        return self.moving is not None

    @property
    def cycle(self) -> Cycle:
        return self.sides.cycle

    @cached_property
    def compared(self) -> Table:
        """The table of the methods."""
        return compared(self.methods, self.cycle.own)

    def at(self, method: str, key: str) -> Var:
        """A number of a method, for an expression."""
        return self.compared.var(key, list(self.methods).index(method))

    @property
    def omega(self) -> float:
        """Mean speed of the main link, rad/s."""
        return self.s.number("omega_m")

    @property
    def needless(self) -> bool:
        """Whether the machine runs evenly enough without a flywheel."""
        return self.s.number("J_fl") == 0

    @property
    def diagram(self) -> bool:
        """Whether there is an energy–mass diagram: of a constant moment of inertia it is an upright line."""
        return bool(self.methods) and self.varies

    @property
    def varies(self) -> bool:
        """Whether the machine's moment of inertia varies with the angle."""
        return bool(np.any(self.cycle.varying))

    @property
    def bursts(self) -> bool:
        """Whether the rim is faster than its material commonly allows."""
        return self.s.number("D_out") > self.s.number("D_lim") * (1 + 1e-9)

    @property
    def doubts(self) -> Iterator[Problem]:
        return friction_doubts(self.sides.machine, "flywheel")

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        text = N_(
            "flywheel: J = %(J)s kg·m² for the unevenness %(delta)s; measured in the integrated motion: %(found)s"
        )
        if self.given.wheel:
            text = N_(
                "flywheel: with J = %(J)s kg·m² the unevenness is %(delta)s; measured in the motion: %(found)s"
            )
        if self.needless:
            text = N_(
                "flywheel: none is needed for the unevenness %(delta)s; measured in the motion: %(found)s"
            )
        numbers = {"J": "J_fl", "delta": "delta", "found": "delta_run"}
        yield Message(text, amounts({name: self.s.number(key) for name, key in numbers.items()}))


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism, where the variant has one. Raises ProblemError."""
    omega = abs(moving.kinematics.omega) if moving else mean_speed(given)
    of = sides(given, moving, omega)
    s = steps.machine(given, of, omega)
    steps.works(s, given, of)
    _strong(s, given, of)
    _swings(of)
    methods = {} if given.wheel else _wanted(s, given, of.cycle)
    if given.wheel:
        sizes.stated(s, given, given.wheel)
    before = turning(of.cycle, of.cycle.own, omega)
    after = turning(of.cycle, of.cycle.own + s.number("J_fl"), omega)
    if after is None:
        text = N_("with this flywheel the machine comes to a stand once a cycle: its energy is too small")
        raise ProblemError([mistake(text, ("flywheel", "wheel"), Message(N_("state a heavier wheel")))])
    if given.wheel:
        steps.unevenness(s, after.delta)
    start = math.sqrt(2 * after.start / (after.fixed + float(of.cycle.panels.ends(of.cycle.varying)[0, 0])))
    proof = integrated(of.cycle, after.fixed, start)
    found = Found(given, s, of, methods, before, after, proof, moving)
    steps.motion(s, found)
    if found.diagram:
        steps.energy_mass(s, found)
    if not (given.wheel or found.needless):
        sizes.dimensions(s, given)
    return found


def _wanted(s: Values, given: Given, cycle: Cycle) -> dict[str, Method]:
    """The methods for the wanted unevenness; the flywheel is that of the exact one."""
    steps.wanted(s, given)
    delta, omega = s.number("delta"), s.number("omega_m")
    found = {one.key: one for one in (method(cycle, delta, omega) for method in METHODS)}
    s.J_fl = max(found["exact"].inertia - cycle.own, 0.0)
    return found


def _swings(found: Sides) -> None:
    """Raises ProblemError for a machine without inertia of its own whose moments balance at every angle."""
    cycle = found.cycle
    moment = np.max(np.abs(cycle.moment if found.driving is None else found.driving))
    (low, _), (high, _) = cycle.swing
    if cycle.own + np.max(cycle.varying) == 0 and high - low <= LEAST * moment * cycle.panels.period:
        text = N_(
            "the excess moment is nothing all over the cycle: there is nothing for a flywheel to even out"
        )
        raise ProblemError([mistake(text, ("flywheel",), Message(N_("state a load that varies")))])


def _strong(s: Values, given: Given, found: Sides) -> None:
    """Raises ProblemError for a motor whose nominal power is less than the mean power of the cycle."""
    power = s.get("P_need")
    if given.motor is None or power is None:
        return  # nothing is said of the motor's own moment, or it is stated, or an engine drives
    if power > given.motor.power * (1 + 1e-3):
        text = N_(
            "the motor is too weak: the cycle takes %(needed)s kW on average, the motor gives %(power)s kW; a "
            "flywheel only lends energy within a cycle, it gives none"
        )
        values = {"needed": f"{power / 1e3:.4g}", "power": f"{given.motor.power / 1e3:.4g}"}
        if found.machine is not None and found.machine.rubs:
            text = N_(
                "the motor is too weak: the cycle takes %(needed)s kW on average, %(friction)s kW of it for the "
                "friction in the pairs, the motor gives %(power)s kW; a flywheel only lends energy within a "
                "cycle, it gives none"
            )
            values["friction"] = f"{found.machine.friction_power / given.motor.efficiency / 1e3:.4g}"
        right = Message(N_("state a motor of %(needed)s kW or more"), {"needed": f"{power / 1e3:.4g}"})
        raise ProblemError([mistake(text, ("flywheel", "motor", "power"), right, **values)])
