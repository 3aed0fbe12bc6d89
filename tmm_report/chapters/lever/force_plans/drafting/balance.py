"""Equilibrium of the links of a group above class II: written out with the arms read off the scheme, and solved.

Of a pivot both projections of the force of its first link on the second are unknown, of a guide the normal force
(positive along the guide turned by 90°) and the moment: 2 for each of the 3k/2 pairs of k links, as many as equations.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.force_plans.drafting.plan import Arm, Balance, Held
from tmm_report.chapters.lever.force_plans.drafting.sheet import Sheet, plus
from tmm_report.chapters.lever.force_plans.quantities import MU_L, moment_sum
from tmm_report.chapters.lever.force_plans.quantities import arm as arm_of
from tmm_report.chapters.lever.kinetostatics.quantities.positions import guide_moment, reaction, reaction_part
from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.quantity.formula import Expr, Formula, Number, Term, Var, VectorEquation
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.text import round_significant
from tmm_report.quantity.written import DIGITS, Equation, Unknown
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class _Column:
    """An unknown: a force of 1 N along `along` (of the pair's first link on the second), or a moment (0)."""

    pair: Pair
    quantity: Quantity
    along: complex


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Balances of the links, in their order; force of each pair's first link on the second, by pair key, complex N."""

    balances: tuple[Balance, ...]
    solution: tuple[Var, ...]
    forces: Mapping[str, complex]
    held: tuple[Held, ...]


@dataclass(eq=False)
class _System:
    columns: list[_Column]
    rows: list[list[float]] = field(default_factory=list)
    right: list[float] = field(default_factory=list)

    def add(self, row: list[float], right: float) -> None:
        self.rows.append(row)
        self.right.append(right)

    def solve(self) -> Array:
        """Rows are brought to one size: moments and projections of forces."""
        A, b = np.array(self.rows), np.array(self.right)
        size = np.abs(A).max(axis=1)
        return np.linalg.solve(A / size[:, None], b / size)


def equilibrium(sheet: Sheet, group: HigherGroup, arms: list[Arm]) -> Equilibrium:
    """Write the equations of every link and solve them. `arms`: those of the loads are added."""
    pairs = (*group.group.outer, *group.group.inner)
    system = _System([column for pair in pairs for column in _columns(sheet, pair)])
    balances = tuple(_balance(sheet, link, system, arms) for link in group.links)
    x = system.solve()
    forces = dict.fromkeys((pair.key for pair in pairs), 0j)
    for column, value in zip(system.columns, x, strict=True):
        forces[column.pair.key] += column.along * float(round_significant(value, DIGITS))
    solution = tuple(sheet.number(c.quantity, float(v)) for c, v in zip(system.columns, x, strict=True))
    solved = zip(system.columns, map(float, x), strict=True)
    held = tuple(one for column, value in solved for one in _held(sheet, group, column, value))
    return Equilibrium(balances, solution, forces, held)


def _held(sheet: Sheet, group: HigherGroup, column: _Column, value: float) -> Iterator[Held]:
    """An unknown that was found, on the links of the group that it acts on: a force, or the moment of a guide."""
    pair = column.pair
    for link in (link for link in pair.links if link in group.links):
        by = pair.other(link)
        parts = {1: reaction_part(by, link, "x"), 1j: reaction_part(by, link, "y")}
        of = parts[column.along] if pair.kind == "R" else reaction(by, link)
        of = of if column.along else guide_moment(by, link)
        vector = column.along * value * _sense(pair, link)
        couple = 0.0 if column.along else value * _sense(pair, link)
        yield Held(of, link, vector, sheet.joint(pair), "component", couple=couple)


def _columns(sheet: Sheet, pair: Pair) -> list[_Column]:
    if pair.kind == "R":
        x, y = (reaction_part(*pair.links, axis) for axis in ("x", "y"))
        return [_Column(pair, x, 1), _Column(pair, y, 1j)]
    normal = 1j * sheet.guide(pair)
    # read off the plan, the reaction comes out once more
    solved = replace(reaction(*pair.links), key=f"{reaction(*pair.links).key}_solved")
    return [_Column(pair, solved, normal), _Column(pair, guide_moment(*pair.links), 0)]


def _balance(sheet: Sheet, link: str, system: _System, arms: list[Arm]) -> Balance:
    """The three equations of a link: both projections of the forces, and the moments about its first joint."""
    about = min((c.pair for c in system.columns if link in c.pair.links), key=lambda pair: pair.kind == "P")
    place = sheet.joint(about)
    loads = sheet.hand(
        moment_sum(about.name, (link,), sheet.in_mm), sheet.moment_sum((link,), about.name, place, arms)
    )
    levers = [_lever(sheet, column, link, about.name, place, arms) for column in system.columns]
    force = sum((a.vector for a in sheet.acting[link]), 0j)
    for part in (np.real, np.imag):
        system.add([_sense(c.pair, link) * float(part(c.along)) for c in system.columns], -float(part(force)))
    system.add(levers, -loads.written)
    return Balance(
        link,
        about.name,
        _forces(sheet, link, system),
        loads,
        _moments(sheet, link, about.name, loads, levers, system),
    )


def _sense(pair: Pair, link: str) -> int:
    """1 where the pair's reaction acts on the link, −1 where the link exerts it, 0 where it is not its pair."""
    return 1 if link == pair.links[1] else -1 if link == pair.links[0] else 0


def _lever(sheet: Sheet, column: _Column, link: str, name: str, about: complex, arms: list[Arm]) -> float:
    """Moment of a unit of the unknown on the link about a place, m or mm of paper; its arm joins the others."""
    sense = _sense(column.pair, link)
    if sense == 0 or column.along == 0:
        return float(sense / sheet.mu_l if sheet.in_mm else sense)
    arm = cross(sheet.joint(column.pair) - about, column.along)
    mm = sheet.pen.read(arm / sheet.mu_l)
    if not mm:
        return 0.0
    metres = float(round_significant(mm * sheet.mu_l, DIGITS + 2))
    of, at = arm_of(column.quantity, f"{name}_{link}", sheet.in_mm), sheet.joint(column.pair)
    arms.append(Arm(column.quantity, name, mm, metres, of, link, about, at, column.along))
    return float(sense * np.copysign(mm if sheet.in_mm else metres, arm))


def _forces(sheet: Sheet, link: str, system: _System) -> VectorEquation:
    """Sum of the forces on a link."""
    pairs = dict.fromkeys(c.pair for c in system.columns if link in c.pair.links)
    reactions = [
        Term(reaction(*p.links).sign, int(p.kind == "P"), negative=link == p.links[0]) for p in pairs
    ]
    first, *others = sorted(reactions, key=lambda term: term.negative)
    return VectorEquation([[first, *sheet.terms(link), *others], []])


def _moments(
    sheet: Sheet, link: str, about: str, loads: Formula, levers: list[float], system: _System
) -> Equation:
    """Sum of the moments on a link with its numbers."""
    total: Expr | None = None
    if loads.written:
        total = sheet.number(moment_sum(about, (link,), sheet.in_mm), loads.written)
    for lever, column in zip(levers, system.columns, strict=True):
        if lever:
            of = column.quantity
            unknown = Unknown(of.sign, np.nan, of.unit, meaning=of.meaning)
            total = plus(total, _term(sheet, column, unknown, f"{about}_{link}", abs(lever)), lever)
    return Equation(total if total is not None else Number(0.0))


def _term(sheet: Sheet, column: _Column, unknown: Unknown, about: str, lever: float) -> Expr:
    """Moment of an unknown: a force times its arm, or a moment, as N mm of paper where arms stand in mm."""
    if column.along:
        return sheet.number(arm_of(column.quantity, about, sheet.in_mm), lever) * unknown
    return unknown / sheet.number(MU_L, sheet.mu_l) if sheet.in_mm else unknown
