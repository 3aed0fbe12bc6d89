"""The centrifugal brake: when it touches, what speed it holds, how it gets there."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor.given import Brakes
from tmm_report.chapters.machine.governor.solve import mistakes
from tmm_report.records import dataclass

Array = Any
POINTS = 13  # of the table
CURVE = 121  # of the diagram of the start
NEAR = 0.99  # part of the speed held, at which the start counts as over
WIDE = 1.25  # up to which part of the speed held the table goes


@dataclass(frozen=True, eq=False)
class BrakeFound:
    """`omega`: speeds of the table, rad/s, with the braking moments, N m; `t`: of the start, s, with the speeds; both
    empty without an inertia."""

    given: Brakes
    omega: Array
    moment: Array
    t: Array
    started: Array

    @property
    def held(self) -> float:
        """Speed that is held, rad/s."""
        return float(self.given.brake.held(self.given.moment))

    @property
    def power(self) -> float:
        """That the brake turns into heat, W."""
        return self.given.moment * self.held

    @property
    def pressing(self) -> float:
        """Force of a shoe on the drum at the speed held, N."""
        shoes = self.given.brake
        return shoes.mass * shoes.at_contact * (self.held**2 - shoes.contact**2)

    @property
    def spread(self) -> float:
        """By what part the held speed is above that of contact."""
        return self.held / self.given.brake.contact - 1

    @property
    def contact_time(self) -> float:
        """From rest to contact, s."""
        return self.given.brake.contact * (self.given.inertia or 0.0) / self.given.moment

    @property
    def settled(self) -> float:
        """From rest to the part `NEAR` of the speed held, s."""
        return self.given.brake.time_to(NEAR, self.given.moment, self.given.inertia or 0.0)


def solve(given: Brakes) -> BrakeFound:
    """Raises ProblemError where the shoes never leave the drum, or brake nothing."""
    shoes = given.brake
    if shoes.friction <= 0:
        raise mistakes.no_friction()
    if shoes.spring <= 0:
        raise mistakes.always_braking()
    if shoes.at_contact >= shoes.drum:
        raise mistakes.outside(shoes.at_contact, shoes.drum)
    held = float(shoes.held(given.moment))
    omega = np.linspace(0.0, WIDE * held, POINTS)
    t = started = np.empty(0)
    if given.inertia:
        t = np.linspace(0.0, 1.5 * shoes.time_to(NEAR, given.moment, given.inertia), CURVE)
        started = shoes.start(given.moment, given.inertia, t)
    return BrakeFound(given, omega, shoes.moment(omega), t, started)
