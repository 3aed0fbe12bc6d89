"""The numbers of the flywheel, each assigned the expression that the note prints; its dimensions are in `sizes`."""

from __future__ import annotations

import operator
from functools import reduce
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.moving import put_friction
from tmm_report.chapters.machine.flywheel.given import Given, Rim
from tmm_report.chapters.machine.flywheel.loads import Sides
from tmm_report.chapters.machine.flywheel.values import Values, sheet
from tmm_report.mechanics.machine.flywheel.inertia import Method
from tmm_report.quantity.formula import Expr
from tmm_report.quantity.functions import arctan
from tmm_report.quantity.paper import round_scale
from tmm_report.quantity.sheet import Reached

if TYPE_CHECKING:
    from tmm_report.chapters.machine.flywheel.solve import Found

SHEET = 110.0  # mm: the energy–mass diagram is drawn at round scales within it


def machine(given: Given, sides: Sides, omega: float) -> Values:
    """What is given: speed, motor, the constant part of the machine's own moment of inertia."""
    s = sheet(isinstance(given.shape, Rim) and not given.wheel, sides.balancing, bool(given.metal.name))
    s.delta_fine, s.delta_coarse = given.usual or (None, None)
    s.omega_m, s.Phi = omega, sides.cycle.panels.period
    s.J_0, s.J_c = given.fixed, sides.links
    if given.motor:
        s.P_nom, s.omega_nom = given.motor.power, given.motor.speed
        s.eta, s.J_r = given.motor.efficiency, given.motor.inertia
    s.J_own = _own(s) or sides.cycle.own
    return s


def _own(s: Values) -> Expr | None:
    """The machine's own constant part; None where it is not made of several."""
    parts: list[Expr] = [s.var(key) for key in ("J_0", "J_c") if s.number(key)]
    if s.get("J_r"):
        parts.append(s.J_r * (s.omega_nom / s.omega_m) ** 2)
    elif len(parts) < 2:
        return None
    return reduce(operator.add, parts)


def works(s: Values, given: Given, sides: Sides) -> None:
    """Of the moments over the cycle: the constant one that closes it, its power, that of the motor."""
    cycle = sides.cycle
    (low, at_low), (high, at_high) = cycle.swing
    s.A_max, s.A_min = Reached(high, at_high), Reached(low, at_low)
    s.A_ex = s.A_max - s.A_min
    s.J_mean = cycle.mean_inertia
    put_friction(s, sides.machine)
    if sides.driving is None:
        return
    s.W = float(cycle.panels.total(sides.driving))
    s.M_m = s.W / s.Phi
    s.P_m = s.M_m * s.omega_m
    s.C_E = 100 * s.A_ex / abs(s.W)
    s.left = 100 * abs(sides.spread / s.number("M_m"))
    if given.motor is not None and sides.balancing != "resisting":
        s.P_need = s.P_m / s.eta


def wanted(s: Values, given: Given) -> None:
    """The unevenness as it is stated, or between the stated speeds."""
    if given.speeds:
        least, greatest = given.speeds
        unevenness(s, 2 * (greatest - least) / (greatest + least))
    else:
        unevenness(s, given.delta)


def unevenness(s: Values, delta: float | None) -> None:
    s.delta = delta
    s.omega_max = s.omega_m * (1 + s.delta / 2)
    s.omega_min = s.omega_m * (1 - s.delta / 2)


def motion(s: Values, found: Found) -> None:
    """The estimate of the unevenness; the motion without the flywheel and with it."""
    inertia: Expr = s.J_fl
    for key in ("J_own", "J_mean"):
        inertia = inertia + s.var(key) if s.number(key) else inertia
    s.delta_est = s.A_ex / (inertia * s.omega_m**2)
    s.delta_0 = found.before.delta if found.before is not None else None
    s.delta_run, s.closure = found.proof.delta, found.proof.closure
    (low, at_low), (high, at_high) = found.cycle.panels.extremes(found.after.epsilon)
    s.eps_max, s.eps_min = Reached(high, at_high), Reached(low, at_low)


def energy_mass(s: Values, found: Found) -> None:
    """The energy–mass diagram: its scales, the angles of its tangents, the segment that they cut off."""
    s.mu_J, s.mu_T = _scales(found, found.methods["wittenbauer"])
    s.psi_1 = arctan(s.mu_J * s.omega_m**2 * (1 + s.delta) / (2 * s.mu_T))
    s.psi_2 = arctan(s.mu_J * s.omega_m**2 * (1 - s.delta) / (2 * s.mu_T))
    s.ab = (found.at("wittenbauer", "T_1") - found.at("wittenbauer", "T_2")) / s.mu_T


def _scales(found: Found, method: Method) -> tuple[float, float]:
    """kg m² and J for a millimetre, round."""
    cuts = (method.upper.cut, method.lower.cut)
    (low, _), (high, _) = found.cycle.swing
    tall = max(high, *cuts) - min(low, *cuts)
    widest = max(float(np.max(found.cycle.varying)), 1e-300)
    return round_scale(widest, SHEET), round_scale(tall, SHEET)
