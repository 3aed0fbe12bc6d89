"""View of Zhukovsky's lever: arms read off the turned plan of velocities, the balancing force, the ways compared."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, partial
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.force_plans.lever import Lever
from tmm_report.chapters.lever.force_plans.lever_draw import lever_picture
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded
from tmm_report.report.part import Part

WAYS = {
    "force_plan": N_("by the force polygon of the driving link"),
    "power": N_("by the power balance"),
    "analytic": N_("by the analytical force analysis"),
}
PLANS = N_("by the force polygons")


def part(levers: tuple[Lever, ...], first: int, book: Book, page: Page) -> Part:
    """`first`: the position that is worked out in full."""
    return Part("lever/force_plans/lever", LeverView(levers, first, book, page), concludes=False)


class LeverView(BookView):
    kinds_once = True

    def __init__(self, levers: tuple[Lever, ...], first: int, book: Book, page: Page):
        super().__init__(page, book)
        self.levers, self.first = levers, first
        self.picture = cache(self._picture)

    def conclusions(self) -> Sequence[Markup]:
        return []

    def _picture(self, lever: Lever) -> Drawing:
        return lever_picture(lever, partial(self.page.tr.pgettext, "index"))

    def arms(self, caption: Any, lever: Lever) -> Table:
        """One row a force that has an arm, the balancing one last."""
        table = self.table(f"lever_arms_{lever.position}")
        rows = [
            [
                self.page.sym(arm.quantity.sign), self.page.word(str(table["point"].values[row]), table, "point", row),
                self.page.cell(table, "size", row), self.page.cell(table, "arm_mm", row, digits=7),
                Cell(self.page.cell(table, "moment", row), table.ref("moment", row)),  # of forces of any size
            ]
            for row, arm in enumerate([*lever.arms, lever.driving])
        ]  # fmt: skip
        heads = [
            self.t("Force"), self.t("Point"), self.page.head(table["size"].symbol(), "N"),
            self.page.head(table["arm_mm"].symbol(), "mm"),
            self.page.listed([self.t("Moment"), self.page.unit("N·mm")]),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2, 2, 3, 3, 3))

    def compared(self, lever: Lever) -> Markup:
        """What the other ways give, with the difference of the lever from it."""
        table, key = self.table(f"lever_compared_{lever.position}"), "force" if lever.thrust else "moment"
        unit = self.page.unit(table[key].unit)
        said = []
        for row, one in enumerate(lever.compared):
            way = self.page.word(self._way(one.key, lever.thrust), table, "way", row)
            value = self.page.shown(table, key, row)
            text = (
                N_("%(way)s %(value)s %(unit)s")
                if one.delta is None
                else N_("%(way)s %(value)s %(unit)s (%(delta)s %%)")
            )
            delta = {} if one.delta is None else {"delta": self.page.shown(table, "delta", row, places=3)}
            said.append(self.t(text, way=way, value=value, unit=unit, **delta))
        return self.page.listed(said, "; ")

    def _way(self, key: str, thrust: bool) -> Markup:
        text = PLANS if thrust and key == "force_plan" else WAYS[key]
        return self.t(text)
