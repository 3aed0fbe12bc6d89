"""What defines the coefficient of non-uniformity, and one position of the cycle written out."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.chapters.machine.flywheel.values import Values
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Table


def unevenness(s: Values) -> Definition:
    return Definition(s.delta.sign, (s.omega_max - s.omega_min) / s.omega_m)


def sample(found: Found, table: Table, k: int) -> Iterator[Formula]:
    """The excess moment and the change of the energy of the constant part at a position."""
    at, s = table.var, found.s
    if "M_dr" in table and not found.sides.spread:
        yield table.formula("M_ex", k, at("M_dr", k) + at("M_res", k))
    if "dT_I" in table:
        yield table.formula("T_II", k, at("J_II", k) * s.omega_m**2 / 2)
        yield table.formula("dT_I", k, at("A", k) - at("T_II", k))
