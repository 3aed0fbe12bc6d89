"""Places by integration of the constraint equations, q' = −Φ_q⁻¹Φ_φ, from position 0: none is solved for.

What a step errs stays, and the joints drift apart; `corrected` closes them again at every position by Newton's method
at the same driver angle (projection), and what it cannot close is nan. Before that nothing tells how far they are
apart: beyond a limit of the assembly the rates carry on with a mechanism that does not exist.
Source: Haug, Computer aided kinematics and dynamics of mechanical systems, ch. 7; Hairer, Wanner, Solving ordinary
differential equations I, II.1, and II, VII.2 (drift and projection).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import count as counted
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.ode import integrate
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.motion.coordinates import Coordinates
from tmm_report.mechanics.rivals.motion.newton import followed, polished
from tmm_report.problems import N_

Array = Any
STEPS = 4  # of the integration between two positions
DRIFT = 0.02  # rad, and of lengths over the size: what a correction may mend
LEAST = 1e-5  # of a group's determinant in position 0: below it drift alone may lead into another assembly
RELATIVE, ABSOLUTE = 1e-10, 1e-12  # tolerances of DOP853
MOST = 20_000  # evaluations of the rates: towards guides that become parallel the steps would be millions


def runge_kutta(cycle: Cycle, count: int, steps: int = STEPS) -> Motion:
    """Motion by the classical method of fourth order, `steps` of equal length between two positions; what comes after a
    singular position is nan. Raises ArithmeticError where position 0 cannot be assembled."""
    return followed(cycle, count, partial(_by_steps, steps=steps, project=False), check=False)


def corrected(cycle: Cycle, count: int, steps: int = STEPS) -> Motion:
    """The same with the joints closed again at every position, and with the checks of `newton`: nan from the first that
    cannot be closed nearby (`DRIFT`), from a singular position on, or where a group's determinant has changed its sign.
    """
    return followed(cycle, count, partial(_by_steps, steps=steps, project=True), check=True)


def dormand_prince(cycle: Cycle, count: int) -> Motion:
    """Motion by the method of eighth order that chooses its steps (DOP853). Raises ArithmeticError also where no step
    is short enough, or too many would be: at a limit of the assembly."""
    return followed(cycle, count, _by_library, check=False)


def tangent(c: Coordinates, q: Array, least: Array | None = None) -> Array:
    """q' (3n,) by the driver's angle; nan in a singular position, and where a group's determinant is below `least`."""
    _, J = c.equations(q[None], np.zeros(1))
    if least is not None and not (np.abs(c.sines(J)[0]) > least).all():
        return np.full(c.count, np.nan)
    right = np.zeros(c.count)
    right[-1] = 1.0
    try:
        return np.linalg.solve(J[0], right)
    except np.linalg.LinAlgError:
        return np.full(c.count, np.nan)


def _by_steps(c: Coordinates, start: Array, phi: Sequence[float], steps: int, project: bool) -> Array:
    found = np.full((len(phi), c.count), np.nan)
    q = start
    least = LEAST * np.abs(c.sines(c.equations(q[None], np.zeros(1))[1])[0]) if project else None
    for k, angle in enumerate(phi):
        h = (angle - phi[max(k - 1, 0)]) / steps
        for _ in range(steps if h else 0):
            q = _step(c, q, h, least)
        if project:
            q = polished(c, q[None], np.array([angle]), DRIFT)[0]
        if not np.isfinite(q).all():
            break
        found[k] = q
    return found


def _step(c: Coordinates, q: Array, h: float, least: Array | None) -> Array:
    """One step of the classical Runge–Kutta method."""
    first = tangent(c, q, least)
    second = tangent(c, q + h / 2 * first, least)
    third = tangent(c, q + h / 2 * second, least)
    last = tangent(c, q + h * third, least)
    return q + h / 6 * (first + 2 * second + 2 * third + last)


def _by_library(c: Coordinates, start: Array, phi: Sequence[float]) -> Array:
    if len(phi) < 2:
        return start[None]
    span, calls = (phi[0], phi[-1]), counted()

    def rate(_: float, q: Array) -> Array:
        if next(calls) > MOST:
            raise ArithmeticError("too many steps")
        return tangent(c, q)

    try:
        run = integrate(rate, start, span, method="DOP853", relative=RELATIVE, absolute=ABSOLUTE)
    except ArithmeticError as error:
        raise ArithmeticError(N_("the rates grow beyond every bound: the assembly ends")) from error
    return run.at(np.array(phi)).T
