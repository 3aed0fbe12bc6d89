"""Equations of a synthesis, in symbols."""

from __future__ import annotations

from typing import Any

from tmm_report.chapters.lever.synthesis.values import Values
from tmm_report.i18n import NP_
from tmm_report.mechanics.lever.synthesis import FUNCTIONS, Wanted
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Function, Number, Power, Var, cos, sqrt
from tmm_report.quantity.functions import exp
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation

NAMES = {"log10": NP_("function", "lg"), "ln": NP_("function", "ln")}


def function(of: Wanted, x: Any) -> Definition:
    """y of x, over the points of accuracy."""
    variable = Var("x", x)
    return Definition(Symbol("y"), _expression(of, variable))


def _expression(of: Wanted, x: Var) -> Expr:
    match of.name:
        case "sqrt":
            return sqrt(x)
        case "exp":
            return exp(x)
        case "":
            whole = of.power == int(of.power)
            if whole and of.power < 0:
                return Number(1.0) / (x if of.power == -1 else Power(x, int(-of.power)))
            return x if of.power == 1 else Power(x, int(of.power) if whole else of.power)
        case name:
            return Function(NAMES.get(name, name), x, FUNCTIONS[name])


def freudenstein(s: Values) -> Equation:
    phi, psi = Var("phi", 0.0), Var("psi", 0.0)
    return Equation(s.k1 + s.k2 * cos(psi) - s.k3 * cos(phi) - cos(phi - psi), numbers=False)
