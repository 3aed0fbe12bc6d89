"""The centrifugal brake: when it touches, what speed it holds, how it gets there."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor import steps
from tmm_report.chapters.machine.governor.given import Brake
from tmm_report.chapters.machine.governor.solve import mistakes
from tmm_report.chapters.machine.governor.values import Brake as Values
from tmm_report.mechanics.machine.governor.brake import Brake as Shoes
from tmm_report.mechanics.machine.governor.brake import Lever
from tmm_report.records import dataclass

Array = Any
POINTS = 13  # of the table
CURVE = 121  # of the diagram of the start
NEAR = 0.99  # part of the speed held, at which the start counts as over
SWING = 0.2  # rad, up to which the swing of an arm is a small one
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
    """Raises ProblemError where the shoes never leave the drum, brake nothing, or lock themselves."""
    shoes = given.shoes
    if shoes.friction <= 0:
        raise mistakes.no_friction()
    if shoes.at_contact >= shoes.drum:
        raise mistakes.outside(shoes.at_contact, shoes.drum)
    if shoes.lever is not None:
        _swings(shoes, shoes.lever)
    shoes = _chosen(given, shoes)
    if shoes.spring <= 0:
        raise mistakes.always_braking()
    s = steps.brake(given)
    omega = np.linspace(0.0, WIDE * s.number("held"), POINTS)
    t = started = np.empty(0)
    if given.inertia:
        s.settled = shoes.time_to(NEAR, given.moment, given.inertia)
        t = np.linspace(0.0, 1.5 * s.number("settled"), CURVE)
        started = shoes.start(given.moment, given.inertia, t)
    return BrakeFound(given, s, shoes, omega, shoes.moment(omega), t, started)


def _swings(shoes: Shoes, lever: Lever) -> None:
    """Raises ProblemError where an arm is not within its drum, or is locked by the friction of its shoe."""
    if lever.pivot >= shoes.drum:
        raise mistakes.pivot_outside(lever.pivot, shoes.drum)
    if shoes.swing > SWING:
        raise mistakes.swings_far(shoes.swing, SWING * lever.normal)
    if shoes.locks:
        raise mistakes.locks(lever.normal / lever.tangential(shoes.drum))


def _chosen(given: Brake, shoes: Shoes) -> Shoes:
    """With the mass or the spring that holds the speed asked for."""
    choose = given.choose
    if choose is None:
        return shoes
    if choose.mass is not None:
        return replace(shoes, mass=shoes.mass_for(given.moment, choose.mass))
    speed = float(choose.spring or 0.0)
    force = shoes.spring_for(given.moment, speed)
    at_rest = force - shoes.stiffness * shoes.drawn
    if force <= 0:
        raise mistakes.light_shoes(speed, given.moment / (shoes.per_mass * speed**2))
    if at_rest < 0:
        raise mistakes.slack_spring(force, shoes.drawn)
    return replace(shoes, preload=at_rest)
