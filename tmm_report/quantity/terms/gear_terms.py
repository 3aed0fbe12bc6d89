"""Symbols and functions of the gear formulas."""

from __future__ import annotations

from tmm_report.mechanics.gears.involute import inv
from tmm_report.quantity.formula import Expr, Function
from tmm_report.quantity.symbols import Symbol

HA, C = Symbol("h", "a", "*"), Symbol("c", "", "*")  # of the rack: height of the teeth, clearance


def involute(angle: Expr) -> Expr:
    return Function("inv", angle, inv)
