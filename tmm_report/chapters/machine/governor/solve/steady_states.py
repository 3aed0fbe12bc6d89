"""Steady states of the machine with its governor."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.machine.governor.given import Plant
from tmm_report.chapters.machine.governor.solve import mistakes
from tmm_report.chapters.machine.governor.solve.by_itself import DirectFound
from tmm_report.mechanics.calculus.roots import first_root
from tmm_report.mechanics.machine.governor.response import Machine
from tmm_report.records import dataclass

Array = Any
SEARCH = 257  # places among which an equilibrium is looked for


@dataclass(frozen=True)
class Steady:
    """A steady state: load and full moment there, N m; speed of the machine, rad/s; lift, m; supply."""

    load: float
    full: float
    omega: float
    z: float
    s: float


def direct(key: str, load: float, machine: Machine, plant: Plant, governor: DirectFound) -> Steady:
    """The lift at which the drive, throttled by it, balances the load at the speed of equilibrium there."""

    def states(z: Array) -> tuple[Array, Array, Array]:
        omega = governor.at(z).omega / plant.ratio
        return omega, machine.drive(omega), 1 - (1 - plant.throttle.least) * z / governor.lift

    def excess(z: Array) -> Array:
        omega, full, s = states(z)
        return full * s - load - plant.load.slope * (omega - machine.omega)

    ends = np.array([0.0, governor.lift])
    most, least = excess(ends) + load
    if not min(least, most) <= load <= max(least, most):
        raise mistakes.no_steady_state(key, load, least, most)
    z = first_root(excess, np.linspace(0.0, governor.lift, SEARCH))
    if z is None:  # the load of an end, but for rounding
        z = float(ends[np.argmin(np.abs(excess(ends)))])
    omega, full, s = (float(one[0]) for one in states(np.array([z])))
    return Steady(full * s, full, omega, z, s)


def indirect(key: str, load: float, machine: Machine, plant: Plant, governor: DirectFound) -> Steady:
    """The sleeve is back where the valve is closed, at the middle of its lift, whatever the load."""
    z = governor.lift / 2
    omega = float(governor.at(np.array([z])).omega[0]) / plant.ratio
    full = float(machine.drive(omega))
    resistance = load + plant.load.slope * (omega - machine.omega)
    s = resistance / full
    if not plant.throttle.least <= s <= 1:
        raise mistakes.no_supply(key, load, plant.throttle.least * full, full)
    return Steady(resistance, full, omega, z, s)
