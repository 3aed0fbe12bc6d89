"""What the chapter says in symbols, one position of the cycle written out, graphical integration of its diagrams."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.chapters.machine.flywheel.values import OverCycle, Values
from tmm_report.problems import N_, Message
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import PI, Expr, Formula, Number, Var
from tmm_report.quantity.functions import Integral
from tmm_report.quantity.model import Table
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.terms.cycle import PHI

ANGLE = Var(PHI.sign, 0.0, "deg")


def unevenness(s: Values) -> Definition:
    return Definition(s.delta.sign, (s.omega_max - s.omega_min) / s.omega_m)


def whole_work(found: Found) -> Definition:
    """W: of the side that is known, over the cycle."""
    stated = OverCycle.M_res if found.sides.balancing == "driving" else OverCycle.M_dr
    moment: Expr = Var(stated.quantity.sign, 0.0)
    whole = Integral(moment, ANGLE, Number(0), found.s.Phi)
    return Definition(found.s.W.sign, whole if stated is OverCycle.M_dr else -whole)


def running_work() -> Definition:
    """A = ∫ M dφ from the beginning of the cycle."""
    excess = Var(OverCycle.M_ex.quantity.sign, 0.0)
    return Definition(OverCycle.A.quantity.sign, Integral(excess, ANGLE, Number(0), ANGLE))


def sample(found: Found, table: Table, k: int) -> Iterator[Formula]:
    """The excess moment at a position."""
    if "M_dr" in table and not found.sides.spread:
        yield table.formula("M_ex", k, table.var("M_dr", k) + table.var("M_res", k))


def energies(found: Found, table: Table, k: int) -> Iterator[Formula]:
    """The change of the energy of the constant part at a position."""
    at, s = table.var, found.s
    if found.varies:
        yield table.formula("T_II", k, at("J_II", k) * s.omega_m**2 / 2)
        yield table.formula("dT_I", k, at("A", k) - at("T_II", k))


POLE = Message(N_("pole distance of the graphical integration"))


def pole(scales: Sequence[Var]) -> Formula:
    """H = μ_A/(μ_M μ_φ), mm, by the scales of the drawn diagrams: that of the angle is in degrees."""
    of = {str(one.symbol): one for one in scales}
    distance = 180 * of["mu_A"] / (PI * of["mu_M"] * of["mu_phi"])
    return Formula("H", distance, "mm", ref=Ref("H", table="picture"), meaning=POLE)
