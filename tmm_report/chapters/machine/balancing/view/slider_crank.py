"""View of a slider-crank within the mechanism: its harmonics and Lanchester's rotors."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.balancing.formulas import BalancingFormulas
from tmm_report.chapters.machine.balancing.quantities import slider_cranks as q
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric, worded


class SliderView(BalancingFormulas):
    def __init__(self, found: Found, number: int, page: Page):
        super().__init__(found, page)
        self.crank, self.remains = found.cranks[number], found.remains[number]
        self.cycle_remains = found.cycle_remains[number]

    def conclusions(self) -> list[Markup]:
        return []

    # ------------------------------------------------------------ single numbers

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.book[f"slider_{key}_{self.crank.slider}"], unit=unit, **form)

    def shown(self, key: str, unit: str = "") -> Markup:
        """symbol = value."""
        return self.page.value(self._var(key, unit))

    def _var(self, key: str, unit: str = "") -> Any:
        return self.book[f"slider_{key}_{self.crank.slider}"].var(unit)

    def ratios(self) -> list[Formula]:
        """λ = r/l of this note, and l/r, which other lectures call λ."""
        r, rod = self._var("r"), self._var("l")
        return [self._formula("lambda", r / rod), self._formula("lambda_L", rod / r)]

    def _formula(self, key: str, expression: Any) -> Formula:
        return self.book[f"slider_{key}_{self.crank.slider}"].formula(expression)

    @property
    def _harmonics(self) -> Any:
        return self.book.tables[f"slider_harmonics_{self.crank.slider}"]

    def _row(self, order: int) -> int:
        return self.crank.orders.index(order)

    def forces(self) -> list[Formula]:
        """Amplitudes of the first two orders."""
        omega = self.given["omega"].var()
        size = self._var("m_B") * self._var("r") * omega**2
        table = self._harmonics
        first = table.formula("F", self._row(1), size)
        second = table.formula("F", self._row(2), abs(table.var("A", self._row(2))) * size)
        return [first, second]

    def balancer(self) -> list[Formula]:
        """m_I r_I = m_B r/2 and m_II r_II = A₂ m_B r/8, with the masses where the radii are stated."""
        table = self._harmonics
        whole = self._var("m_B") * self._var("r")
        second = abs(table.var("A", self._row(2)))
        found = [self._formula("U_I", whole / 2), self._formula("U_II", second * whole / 8)]
        if self.found.given.radii is not None:
            for roman in ("I", "II"):
                found.append(self._formula(f"m_{roman}", self._var(f"U_{roman}") / self._var(f"r_{roman}")))
        return found

    # ------------------------------------------------------------ tables and diagram

    def harmonics(self, caption: Any) -> Table:
        table, page = self._harmonics, self.page
        keys = [column.key for column in table.columns if column.key != "order"]
        heads = [page.sym(q.ORDER.sign)]
        heads += [page.head(table[key].quantity.sign, _unit(key)) for key in keys]
        rows = [
            [page.cell(table, "order", row), *(self._cell(key, row) for key in keys)]
            for row in range(len(table))
        ]
        return worded(caption, heads, rows, (1, *(3 for _ in keys)))

    def _cell(self, key: str, row: int) -> Any:
        table = self._harmonics
        if key.startswith("miss"):
            return self.page.cell(table, key, row, "%", places=3)
        scale = self.crank.force(float(self.found.kinematics.omega), 1) if key == "F" else 1.0
        return self.page.cell(table, key, row, scale=scale)

    def left(self, caption: Any) -> Table:
        table = self.book.tables[f"slider_forces_{self.crank.slider}"]
        keys = (q.inertia(self.crank).key, q.AFTER_FIRST.key, q.AFTER_SECOND.key)
        return numeric(caption, self.page.positions(table), [self.page.column(table, key) for key in keys])

    @cached_property
    def diagram(self) -> Graph:
        """The inertia force along the guide, and what is left of it, over the turn."""
        found = self.found.kinematics
        count = round(found.positions.table * 2 * np.pi / found.cycle.sweep)  # of a turn
        remains = self.cycle_remains
        graphs = CycleGraphs(np.append(self.found.turned, 2 * np.pi), count, self.page.tr)
        names = (self.page.tr.gettext("without rotors"), "I", "I, II")
        size = float(np.abs(remains.exact).max())
        forces = (remains.exact, remains.first, remains.second)
        curves = [
            Curve(np.append(force, force[0]), name, 0, (), size)
            for force, name in zip(forces, names, strict=True)
        ]
        return graphs.graph(curves, [graphs.letter(Symbol("F"), "N")])


def _unit(key: str) -> str:
    return "%" if key.startswith("miss") else "N" if key == "F" else ""
