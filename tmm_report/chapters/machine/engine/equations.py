"""The inertia force of a cylinder by its series, and formulas of rows of the tables."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.machine.engine.drawn import Star
from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.chapters.machine.engine.values import KINDS, Cylinders, Turn, graph
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Number, Var, cos
from tmm_report.quantity.model import Table
from tmm_report.quantity.symbols import Symbol


def of_one(found: Found) -> Definition:
    """The inertia forces of the cylinders along their axes over a turn, (P, N), N."""
    s = found.s
    theta = Var(Cylinders.theta.quantity.sign, turned(found).expression.value, "deg")
    series = cos(theta) + s.lam * cos(2 * theta) - s.lam**3 / 4 * cos(4 * theta)
    return Definition(Symbol("F", "i"), s.m * s.r * s.omega**2 * series)


def turned(found: Found) -> Definition:
    """The angles of the cranks from their cylinders' axes, (P, N), rad."""
    psi, beta = (Cylinders.psi.quantity.sign.base, Cylinders.beta.quantity.sign.base)
    phi = Var(Turn.phi.quantity.sign, found.diagram["after"].phi[:, None], "deg")
    angle = phi + Var(Symbol(psi, "i"), found.angles, "deg") - Var(Symbol(beta, "i"), found.banks, "deg")
    return Definition(Cylinders.theta.quantity.sign, angle)


def by_polygon(found: Found, table: Table, row: int, star: Star) -> Formula:
    """(d + d')/2 μ ω² c; of cylinders of one direction d μ ω² c."""
    s, quantity = found.s, graph(star.of, star.order)
    direct, reverse = (table.var(key, row) for key in ("d_direct", "d_reverse"))
    length: Expr = direct if found.in_line else (direct + reverse) / Number(2)
    size = length * (s.mu_F if star.of == "force" else s.mu_M) * s.omega**2
    if star.order == 2:
        size = size * s.lam
    ref = table.by_key(quantity.key, "graph")
    return Formula(quantity.sign, size, quantity.unit, ref=ref, meaning=quantity.meaning)


def remedy(found: Found, table: Table, source: Table, row: int) -> Iterator[Formula]:
    """Product of the weight that turns forward and, where it differs, of that which turns back; `source`: force and
    moment of the order, of order 1 with all that turns."""
    one, letter = found.remedies[row], KINDS[found.remedies[row].of].letter
    at = len(source) - 1 if one.order == 1 else 1
    rate: Expr = found.s.omega if one.order == 1 else 2 * found.s.omega
    senses = {"forward": ["forward"], "backward": ["backward"], "pair": ["forward"], "none": []}
    for sense in senses.get(one.kind, ["forward", "backward"]):
        yield table.formula(sense, row, source.var(f"{letter}_{sense}", at) / rate**2)
