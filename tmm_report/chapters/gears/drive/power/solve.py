"""The shafts of a drive with solved stages: power, speed and torque of each; what the motor allows the machine.

Source: Dunaev, Lelikov, Design of units and machine parts, ch. 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Protocol

import numpy as np

from tmm_report.chapters.gears.drive.power.given import Given, Motor
from tmm_report.chapters.gears.drive.power.plan import Plan
from tmm_report.mechanics.machine import power_chain
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.quantity.text import amounts
from tmm_report.records import dataclass

Array = Any


class Turned(Protocol):
    """What the shafts ask of a solved stage."""

    @property
    def ratio(self) -> float: ...


@dataclass(frozen=True, eq=False)
class Found:
    """Of every shaft (S,), the motor's first: `power`, W, `omega`, rad/s, `torque`, N·m, as the table of the shafts has
    them; `links`, `bearings`: efficiencies; `ratios`: sizes, of each shaft to the one before. `rated`: whether the
    powers begin with the motor's own. `base`: the power of the motor with which they begin, W."""

    plan: Plan
    links: Array
    bearings: Array
    ratios: Array
    base: float
    rated: bool
    power: Array
    omega: Array
    torque: Array

    @property
    def given(self) -> Given:
        return self.plan.given

    @property
    def motor(self) -> Motor | None:
        return None if self.plan.chosen is None else self.given.motors[self.plan.chosen]

    @property
    def deviation(self) -> float | None:
        """Of the machine's speed from the wanted one, relative, signed."""
        need = self.plan.need
        return None if need.omega is None or not need.wanted else float(self.omega[-1]) / need.omega - 1

    @property
    def load(self) -> float | None:
        """The needed power by the motor's own."""
        motor, required = self.motor, self.plan.required
        return None if motor is None or required is None else required / motor.power

    @property
    def allowed(self) -> float | None:
        """The useful power that the motor's own gives, W."""
        return None if self.motor is None else self.motor.power * self.plan.eta

    @property
    def overloaded(self) -> bool:
        """Whether the motor has less power than is needed, by more than the permitted overload."""
        return self.load is not None and self.load > (1 + self.given.overload) * (1 + 1e-9)

    def handed_on(self) -> Array:
        """Torque that each shaft gives to the next, behind its own bearings, N·m, (S,), by the factor of the table."""
        powers = power_chain.shaft_powers(self.base, self.links, self.bearings)
        return power_chain.torque(powers, self.omega, self.given.shafts.torque == 9550)

    def driving(self) -> list[float]:
        """Torque on the driving wheel of every stage, N·m."""
        torques = self.handed_on()
        return [float(torques[shaft]) for shaft, link in enumerate(self.plan.links) if link.kind == "stage"]

    def summary(self) -> list[Message]:
        """What the motor is, and what is needed of it."""
        if self.motor is None or self.plan.required is None:
            return []
        text = N_("motor %(name)s: %(power)s kW, %(needed)s kW are needed")
        numbers = {"power": self.motor.power / 1000, "needed": self.plan.required / 1000}
        return [Message(text, {"name": self.motor.name, **amounts(numbers)})]

    def doubts(self) -> Iterator[Problem]:
        """A motor that is stated and too weak."""
        if self.overloaded and self.motor is not None and self.load is not None:
            wrong = N_(
                "the motor has %(own)s kW, and %(power)s kW are needed: it is overloaded by %(over)s %%"
            )
            right = Message(
                N_("a stronger motor, or overload: %(over)s %%"), {"over": f"{100 * (self.load - 1):.3g}"}
            )
            values = {
                "own": f"{self.motor.power / 1000:.4g}",
                "power": f"{(self.plan.required or 0.0) / 1000:.4g}",
                "over": f"{100 * (self.load - 1):.3g}",
            }
            yield doubt(wrong, ("drive", "motors"), right, **values)


def solve(plan: Plan, stages: Sequence[Turned]) -> Found:
    """`stages`: all of them solved."""
    motor = None if plan.chosen is None else plan.given.motors[plan.chosen]
    links = np.array([1.0, *(link.efficiency for link in plan.links)])
    bearings = np.array(plan.bearings)
    ratios = np.array(
        [1.0, *(abs(stages[link.stage].ratio) if link.kind == "stage" else 1.0 for link in plan.links)]
    )
    rated = motor is not None and (plan.given.shafts.by == "rated" or plan.required is None)
    base = motor.power if rated and motor is not None else plan.required
    assert base is not None  # the block asks for one of both
    received = plan.given.shafts.at == "before bearings"
    power = power_chain.shaft_powers(base, links, bearings, received)
    omega = power_chain.shaft_speeds(plan.speed, ratios)
    torque = power_chain.torque(power, omega, plan.given.shafts.torque == 9550)
    return Found(plan, links, bearings, ratios, base, rated, power, omega, torque)
