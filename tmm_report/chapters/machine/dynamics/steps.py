"""The numbers of the machine in motion, each assigned the expression that the note prints."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.moving import put_friction
from tmm_report.chapters.machine.dynamics.given import Given
from tmm_report.chapters.machine.dynamics.parts import Taken
from tmm_report.chapters.machine.dynamics.plant import MOTOR
from tmm_report.chapters.machine.dynamics.values import Values
from tmm_report.mechanics.calculus.laws import Constant
from tmm_report.mechanics.machine.characteristics import Kloss, Linear, Power, Series
from tmm_report.mechanics.machine.run.motion_law import Run
from tmm_report.mechanics.machine.run.steady import Steady
from tmm_report.quantity.formula import PI
from tmm_report.quantity.sheet import Computed, Reached

if TYPE_CHECKING:
    from tmm_report.chapters.machine.dynamics.solve import Found


def numbers(found: Found) -> None:
    """All of them."""
    s, given = found.s, found.given
    _reduced(s, found)
    _motor(s, given)
    _resistances(s, given)
    put_friction(s, found.whole.machine)
    if found.supplied.even:
        s.J = float(found.supplied.inertia.flat[0])
    if found.steady is not None:
        _steady(s, found, found.steady)
    if found.uniformly:
        _uniform(s, found)
    if found.start is not None:
        _started(s, found, found.start)
    if found.coast is not None:
        run = found.coast
        s.t_coast, s.phi_coast = float(run.t[-1]), float(run.phi[-1] - run.phi[0])
        s.turns_coast = s.phi_coast / (2 * PI)
        s.omega_coast = float(run.omega[-1])
    if found.joined is not None:
        s.cycles = found.joined.cycles or None
    _checks(s, found)


def _reduced(s: Values, found: Found) -> None:
    """Of a part that has nothing of the kind there is no formula."""
    s.omega_given = found.given.speed
    s.M_closing = found.whole.balanced if found.given.motor is None else None
    if found.parts is None:
        return
    taken = Taken(found.parts, found.whole.parts)
    inertia, moment = taken.inertia(), taken.moment()
    s.J_parts = found.whole.added if inertia is None else inertia
    s.M_parts = sum(one.moment for one in found.whole.parts) if moment is None else moment


def _motor(s: Values, given: Given) -> None:
    motor = given.motor
    if motor is None:
        return
    if motor.geared:
        s.i_motor, s.eta_motor = motor.ratio, motor.efficiency
    match motor.own:
        case Constant(moment):
            s.M_motor = moment
        case Linear(stall, no_load):
            s.M_stall, s.omega_0 = stall, no_load
        case Series(a, b):
            s.a, s.b = a, b
        case Kloss(synchronous, greatest, critical, stator):
            s.omega_0, s.M_max, s.s_cr = synchronous, greatest, critical
            s.a = stator or None


def _resistances(s: Values, given: Given) -> None:
    for k, one in enumerate(given.resistances, 1):
        if isinstance(one.law, Constant):
            s.put(f"M_res{k}", one.law.amount)
        elif isinstance(one.law, Power) and one.law.exponent == 1:
            s.put(f"c_res{k}", one.law.moment / one.law.speed)
        elif isinstance(one.law, Power):
            s.put(f"M_res{k}", one.law.moment)
            s.put(f"omega_res{k}", one.law.speed)
    if given.coast is not None and given.coast.brake:
        s.M_brake = given.coast.brake


def _steady(s: Values, found: Found, steady: Steady) -> None:
    driving = steady.works.get(MOTOR)
    s.P = None if driving is None else driving / steady.cycle
    s.multiplier = steady.multiplier if found.by_speed else None
    if found.even:
        s.omega_m = steady.mean
        resisting = -sum(work for key, work in steady.works.items() if key != MOTOR)
        s.M_steady = resisting / steady.plant.panels.period
        s.T_steady = s.J * s.omega_m**2 / 2
        return
    (low, at_low), (high, at_high) = steady.extremes
    s.omega_min, s.omega_max = Reached(low, at_low), Reached(high, at_high)
    s.omega_m = Computed((s.omega_max + s.omega_min) / 2, steady.mean)
    s.delta = Computed((s.omega_max - s.omega_min) / s.omega_m, steady.delta)
    s.T_cycle = steady.cycle
    driven = steady.given_by(MOTOR)
    if driven is not None and driven[0][0] < driven[1][0]:
        (weak, at_weak), (strong, at_strong) = driven
        s.M_dr_min, s.M_dr_max = Reached(weak, at_weak), Reached(strong, at_strong)
    zero = np.zeros(1)
    s.T_0 = float(found.at(steady.plant.inertia, zero)[0] * found.omega(zero)[0] ** 2 / 2)


def _uniform(s: Values, found: Found) -> None:
    """The angular acceleration under constant moments, of a constant moment of inertia."""
    motor, acting = found.given.motor, found.supplied.acting
    driving = sum((float(one.values.flat[0]) for one in acting if one.key == MOTOR), 0.0)
    geared = motor is not None and motor.geared and isinstance(motor.own, Constant)
    s.M_dr = Computed(s.i_motor * s.eta_motor * s.M_motor, driving) if geared else driving
    s.M_res = driving - found.supplied.mean_moment
    s.epsilon = (s.M_dr - s.M_res) / s.J


def _started(s: Values, found: Found, run: Run) -> None:
    s.t_start, s.phi_start = float(run.t[-1]), float(run.phi[-1] - run.phi[0])
    s.turns_start = s.phi_start / (2 * PI)
    s.omega_begin, s.omega_start = float(run.omega[0]), float(run.omega[-1])
    if found.given.start is not None and found.steady is not None:
        s.within = found.given.start.within or None


def _checks(s: Values, found: Found) -> None:
    errors = [run.error for _, run in found.runs]
    residuals = [run.residual for _, run in found.runs if run.rates is not None]
    if found.steady is not None:
        works = found.steady.works.values()
        errors.append(abs(sum(works)) / (max(map(abs, works), default=0.0) or 1.0))
        if not found.even:
            residuals.append(found.steady.residual)
    s.balance_error = max(errors) if errors else None
    s.residual = max(residuals) if residuals else None
    s.potential_error = None if math.isnan(found.conservative) else found.conservative
