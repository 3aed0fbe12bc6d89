"""The equation of motion and its solution, in symbols."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.machine.vibration.solve import Found
from tmm_report.chapters.machine.vibration.steps import exp
from tmm_report.i18n import NP_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Function, Var, cos, sin
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation


def _turned(found: Found) -> Expr:
    return Var("omega", found.omega) * _time(found)


def _time(found: Found) -> Var:
    return Var("t", found.times)


def equation(found: Found) -> Equation:
    """Of the motion: primes are derivatives by the time."""
    letter = found.s.declared("x").quantity.sign.base
    x, m, b, c = (Var(sign, 0.0) for sign in (letter, found.s.inertia.sign, "b", "c"))
    once, twice = (Var(Symbol(letter + primes), 0.0) for primes in ("'", "''"))
    if found.given.base is not None:
        z, speed = Var("z", 0.0), Var(Symbol("z'"), 0.0)
        return Equation(m * twice + b * (once - speed) + c * (x - z), numbers=False)
    if found.given.free:
        return Equation(m * twice + b * once + c * x, numbers=False)
    force: Expr = Var(found.s.declared("force").quantity.sign, 0.0) * sin(_turned(found))
    if found.shaking is not None:
        force = Var(Symbol("F(t)"), 0.0)
    return Equation(m * twice + b * once + c * x - force, numbers=False)


def solution(found: Found) -> Definition:
    """The motion from the start: its value over `times` is the drawn one."""
    s, t = found.s, _time(found)
    free = _shape(found)
    if found.zeta > 0:
        free = exp(-(s.decay * t)) * free
    letter = found.s.declared("x").quantity.sign
    if found.given.free:
        return Definition(letter, free)
    return Definition(letter, free + s.amplitude * sin(_turned(found) - s.lag))


def _shape(found: Found) -> Expr:
    """How the free motion goes but for its dying away: it swings or creeps."""
    s, t = found.s, _time(found)
    if found.kind == "under":
        return s.C1 * cos(s.damped * t) + s.C2 * sin(s.damped * t)
    if found.kind == "critical":
        return s.C1 + s.C2 * t
    cosh = Function(NP_("function", "cosh"), s.root * t, np.cosh)
    return s.C1 * cosh + s.C2 * Function(NP_("function", "sinh"), s.root * t, np.sinh)
