"""The parts of the machine: their table, and what they add to the main shaft."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.machine.dynamics.plant import ReducedPart
from tmm_report.chapters.machine.dynamics.values import Parts
from tmm_report.problems import N_, Message
from tmm_report.quantity.formula import Expr, Var
from tmm_report.quantity.model import Column, Table, text_column
from tmm_report.quantity.sheet import Q
from tmm_report.quantity.symbols import Symbol
from tmm_report.records import dataclass

PARTS = Message(N_("parts of the machine reduced to the main shaft"))


def parts_table(parts: Sequence[ReducedPart], gravity: float) -> Table:
    """Numbers that a part has not are none."""
    nan, of = math.nan, [one.part for one in parts]
    forces = [one.moves * one.mass * gravity + one.force if one.arm else nan for one in of]
    columns = (
        text_column("part", Message(N_("part of the machine")), [one.name for one in of]),
        _numbered(Parts.i, [one.ratio if one.turns or not one.arm else nan for one in of]),
        _numbered(Parts.eta, [one.efficiency for one in of]),
        _numbered(Parts.J, [one.inertia if one.turns else nan for one in of]),
        _numbered(Parts.M, [one.moment if one.turns else nan for one in of]),
        _numbered(Parts.m, [one.mass if one.arm else nan for one in of]),
        _numbered(Parts.r, [one.arm or nan for one in of]),
        _numbered(Parts.F, forces),
        _numbered(Parts.J_red, [one.inertia for one in parts]),
        _numbered(Parts.M_red, [one.moment for one in parts]),
    )
    return Table("dynamics_parts", PARTS, columns)


def _numbered(of: Q, numbers: list[float]) -> Column:
    sign = of.quantity.sign
    indices = [",".join(filter(None, (sign.sub, str(k)))) for k in range(1, len(numbers) + 1)]
    return Column(of.quantity, np.array(numbers, float), [Symbol(sign.base, index) for index in indices])


def total(terms: Sequence[Expr]) -> Expr:
    first, *others = terms
    return sum(others, first)


@dataclass(frozen=True, eq=False)
class Taken:
    """What the parts take from the main shaft."""

    table: Table
    parts: tuple[ReducedPart, ...]

    def inertia(self) -> Expr | None:
        """Their moment of inertia on the main shaft; None where nothing has any."""
        terms = [term for row in range(len(self.parts)) for term in self._inertias(row)]
        return total(terms) if terms else None

    def _inertias(self, row: int) -> Iterator[Expr]:
        part, var = self.parts[row].part, self.table.var
        if part.inertia:
            yield var("J", row) if part.ratio == 1 else var("J", row) * var("i", row) ** 2
        if part.mass and part.arm:
            yield var("m", row) * var("r", row) ** 2

    def moment(self) -> Expr | None:
        """Their moment on the main shaft, the losses in it; None where nothing resists or drives."""
        if not any(one.moment for one in self.parts):
            return None
        rows = [(row, self._without_losses(row)) for row in range(len(self.parts))]
        return total(
            [self._passed(total(terms), row, self.parts[row].moment) for row, terms in rows if terms]
        )

    def _without_losses(self, row: int) -> list[Expr]:
        var, plain = self.table.var, self.parts[row].part.ratio == 1
        sizes = {key: self.table[key].number(row) for key in ("M", "F")}
        return [
            var(key, row) if key == "M" and plain else var(key, row) * var(arm, row)
            for key, arm in (("M", "i"), ("F", "r"))
            if sizes[key] and not math.isnan(sizes[key])
        ]

    def _passed(self, taken: Expr, row: int, sign: float) -> Expr:
        """With the losses of the gears, on the side to which the power goes."""
        if self.parts[row].part.efficiency == 1:
            return taken
        eta = self.table.var("eta", row)
        return taken * eta if sign < 0 else taken / eta

    def lost(self, epsilon: Var) -> Iterator[Expr]:
        """What the gears of each part lose by an acceleration; where its power turns round the whole moment, less what
        is counted without acceleration."""
        for row, one in enumerate(self.parts):
            if not one.inertia or one.part.efficiency == 1:
                continue
            still = float(one.moment)
            gained, eta = self.table.var("J_red", row) * epsilon, self.table.var("eta", row)
            whole = still * (one.part.efficiency if still > 0 else 1 / one.part.efficiency) + gained.value
            if still == 0 or still * whole > 0:
                yield gained * (eta - 1) if whole < 0 else gained * (1 / eta - 1)
            else:
                taken = self._passed(total([gained, *self._without_losses(row)]), row, whole)
                yield taken - gained - self.table.var("M_red", row)
