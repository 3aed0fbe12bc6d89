"""The numbers of a machine whose main link slides, each assigned the expression that the note prints."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from tmm_report.quantity.formula import Expr, sin, sqrt
from tmm_report.quantity.sheet import Computed, Reached

if TYPE_CHECKING:
    from tmm_report.chapters.machine.travel.solve import Found


def numbers(found: Found) -> None:
    """All of them."""
    s, given, machine = found.s, found.given, found.whole
    s.mass = given.mass or None
    s.wheels = sum(one.inertia / one.radius**2 for one in given.wheels) or None
    if found.constant_mass:
        _mass(found)
    else:
        s.m_begin = float(found.mass[0])
    if given.rise is not None and given.mass:
        s.rise, s.g = given.rise, given.gravity
        s.weight = Computed(-s.mass * s.g * sin(s.rise), scale=given.mass * given.gravity)
    s.begin, s.end = machine.begin, machine.end
    s.length = abs(s.end - s.begin)
    s.v_begin = given.speed
    s.way = float(found.x[-1])
    if machine.even:
        _uniform(found)
    else:
        s.v_end, s.t_end = float(found.v[-1]), float(found.t[-1])
    fastest = int(np.argmax(found.v))
    s.v_max = Reached(float(found.v[fastest]), float(found.motion.phi[fastest]))
    s.gained = found.motion.gained
    s.balance_error = found.motion.error
    s.residual = found.motion.residual if found.motion.rates is not None else None


def _mass(found: Found) -> None:
    """The reduced mass, where it does not vary."""
    s, terms = found.s, [key for key in ("mass", "wheels") if key in found.s]
    if found.whole.stroke is None and len(terms) > 1:
        s.m_red = s.mass + s.wheels
    else:
        s.m_red = float(found.mass[0])


def _uniform(found: Found) -> None:
    """Under constant forces, of a constant mass: in closed form."""
    s = found.s
    s.force = float(sum(one.values.flat[0] for _, one in found.whole.acting)) * found.whole.turn
    s.a = s.force / s.m_red
    energy: Expr = s.v_begin**2 + 2 * s.a * s.way
    s.v_end = Computed(sqrt(energy), float(found.v[-1])) if not found.stops else 0.0
    change = s.v_end - s.v_begin
    s.t_end = Computed(change / s.a if s.number("force") else s.way / s.v_begin, float(found.t[-1]))
