"""View of a press."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.press import quantities as q
from tmm_report.chapters.lever.press.solve import Found
from tmm_report.figures.charts.graphs import Graph
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import CycleGraphs, Line, chart
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric
from tmm_report.report.part import Part

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

HIGH = 3.0  # times the rated force, or the least permitted one, above which the curve is not drawn


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.press is not None:
        yield Part("lever/press", PressView(lever.press, page))


class PressView(ChapterView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, q.tables(found))
        self.found = found

    @property
    def rated(self) -> bool:
        return "rated" in self.s

    # ------------------------------------------------------------ of a row

    @property
    def row(self) -> int:
        """Of the table, the one written out: at 30°, or in the middle of a shorter stroke."""
        return min(6, len(self.table("table")) // 2)

    @property
    def at(self) -> Markup:
        return self.page.shown(self.table("table"), "alpha", self.row)

    def written(self) -> list[Formula]:
        table, row = self.table("table"), self.row
        found = [table.formula("v", row, table.var("h", row) * self.found.s.omega)]
        if "F_lim" in table:
            found.append(table.formula("F_lim", row, self.found.s.torque / table.var("h", row)))
        return found

    # ------------------------------------------------------------ tables and charts

    def stroke(self, caption: Any) -> Table:
        table, keys = self.table("table"), ("s", "h", "v", *(("F_lim",) if self._allows else ()))
        angles = [self.page.cell(table, "alpha", row, places=0) for row in range(len(table))]
        own = Column(self.page.head(table["alpha"].symbol(), table["alpha"].quantity.printed), angles)
        return numeric(caption, own, self.columns("table", keys))

    @property
    def _allows(self) -> bool:
        return "torque" in self.s

    def diagram(self) -> Graph:
        """The permitted force with the rated one, and the velocity, over the path left."""
        table = self.table("diagram")
        speed = Line(table["v"], panel=int(self._allows), extremes=())
        panels = [table["v"].quantity]
        lines = [speed]
        if self._allows:
            letters = CycleGraphs(np.zeros(2), 0, self.page.tr)
            least = self.s.number("rated" if self.rated else "F_least")
            most = HIGH * max(least, self.s.number("F_least")) / 1e3
            ring = (
                [(self.s.number("s_nom") * 1e3, least / 1e3)] if self.rated and not self.found.always else []
            )
            forces = [Line(table["F_lim"], letters.letter(table["F_lim"].symbol()), 0, ring, most)]
            if self.rated:
                forces.append(Line(table["F_nom"], letters.letter(table["F_nom"].symbol()), 0, ()))
            panels, lines = [table["F_lim"].quantity, *panels], [*forces, speed]
        return chart(lines, table["s"], panels, self.page.tr)

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        lines = []
        if self.found.always:
            text = N_(
                "The rated force of the press, %(F)s kN, is permitted over the whole stroke of its slider."
            )
            lines.append(self.t(text, F=self.number("rated")))
        elif self.rated:
            text = N_(
                "The rated force of the press, %(F)s kN, is permitted from %(alpha)s before the dead point on, where "
                "%(s)s mm are left."
            )
            angle = self.measured("alpha_nom")
            lines.append(self.t(text, F=self.number("rated"), alpha=angle, s=self.number("s_nom")))
        if "dwell" in self.s:
            text = N_("Within %(within)s mm of its dead point the slider dwells over %(angle)s, %(t)s s.")
            angle = self.measured("dwell")
            t = self.number("t_dwell")
            lines.append(self.t(text, within=self.number("within"), angle=angle, t=t))
        if "peak" in self.s:
            text = N_("Over the working stroke the greatest velocity of the slider is %(k)s of the mean one.")
            lines.append(self.t(text, k=self.number("peak")))
        return lines
