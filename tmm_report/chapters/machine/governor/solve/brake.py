"""The centrifugal brake: when it touches, what speed it holds, how it gets there."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor import steps
from tmm_report.chapters.machine.governor.given import Brake
from tmm_report.chapters.machine.governor.solve import mistakes
from tmm_report.chapters.machine.governor.values import Brake as Values
from tmm_report.mechanics.machine.governor.brake import Brake as Shoes
from tmm_report.records import dataclass

Array = Any
POINTS = 13  # of the table
CURVE = 121  # of the diagram of the start
NEAR = 0.99  # part of the speed held, at which the start counts as over
WIDE = 1.25  # up to which part of the speed held the table goes


@dataclass(frozen=True, eq=False)
class BrakeFound:
    """`s`: the single numbers; `shoes`: the brake as mechanics has it; `omega`: speeds of the table, rad/s, with the
    braking moments, N m; `t`: of the start, s, with the speeds; both empty without an inertia."""

    given: Brake
    s: Values
    shoes: Shoes
    omega: Array
    moment: Array
    t: Array
    started: Array


def solve(given: Brake) -> BrakeFound:
    """Raises ProblemError where the shoes never leave the drum, or brake nothing."""
    shoes = given.shoes
    if shoes.friction <= 0:
        raise mistakes.no_friction()
    if shoes.spring <= 0:
        raise mistakes.always_braking()
    if shoes.at_contact >= shoes.drum:
        raise mistakes.outside(shoes.at_contact, shoes.drum)
    s = steps.brake(given)
    omega = np.linspace(0.0, WIDE * s.number("held"), POINTS)
    t = started = np.empty(0)
    if given.inertia:
        s.settled = shoes.time_to(NEAR, given.moment, given.inertia)
        t = np.linspace(0.0, 1.5 * s.number("settled"), CURVE)
        started = shoes.start(given.moment, given.inertia, t)
    return BrakeFound(given, s, shoes, omega, shoes.moment(omega), t, started)
