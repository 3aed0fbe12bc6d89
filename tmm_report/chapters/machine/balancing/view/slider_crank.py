"""View of a slider-crank within the mechanism: its harmonics and Lanchester's rotors."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.initial_data import quantities as initial
from tmm_report.chapters.machine.balancing.quantities.whole import tables
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.chapters.machine.balancing.values import Remains, Series, inertia
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric, worded


class SliderView(ChapterView):
    def __init__(self, found: Found, number: int, page: Page):
        super().__init__(page, found.sliders[number], tables(found), "")
        self.found, self.crank = found, found.cranks[number]
        self.cycle_remains = found.cycle_remains[number]

    def conclusions(self) -> list[Markup]:
        return []

    @property
    def _harmonics(self) -> Any:
        return self.table(f"slider_harmonics_{self.crank.slider}")

    def forces(self) -> list[Formula]:
        """Amplitudes of the first two orders."""
        omega = initial.speed(self.found.kinematics.linkage.mechanism).var()
        size = self.s.var("m_B") * self.s.var("r") * omega**2
        table, first, second = self._harmonics, *(self.crank.orders.index(k) for k in (1, 2))
        higher = abs(table.var("A", second)) * size
        return [table.formula("F", first, size), table.formula("F", second, higher)]

    # ------------------------------------------------------------ tables and diagram

    def harmonics(self, caption: Any) -> Table:
        table, page = self._harmonics, self.page
        keys = [column.key for column in table.columns if column.key != "order"]
        of = [table[key].quantity for key in keys]
        heads = [page.sym(Series.order.quantity.sign), *(page.head(one.sign, one.printed) for one in of)]
        rows = [
            [page.cell(table, "order", row), *(self._cell(key, row) for key in keys)]
            for row in range(len(table))
        ]
        return worded(caption, heads, rows, (1, *(3 for _ in keys)))

    def _cell(self, key: str, row: int) -> Any:
        table = self._harmonics
        if key.startswith("miss"):
            return self.page.cell(table, key, row, places=3)
        scale = self.crank.force(float(self.found.kinematics.omega), 1) if key == "F" else 1.0
        return self.page.cell(table, key, row, scale=scale)

    def left(self, caption: Any) -> Table:
        name = f"slider_forces_{self.crank.slider}"
        columns = self.columns(name, Remains.DECLARED)
        return numeric(caption, self.page.positions(self.table(name)), columns)

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
        return graphs.graph(curves, [graphs.label(inertia(self.crank.joint))])
