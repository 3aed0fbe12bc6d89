"""View of torsion springs between links: what is stated of them, their angles, their moments at the sample position."""

from __future__ import annotations

from typing import Any

from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.quantities import twists as own
from tmm_report.chapters.lever.kinetostatics.solve.lengths import torsions_of
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.kinetostatics.ties import Twist
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, worded


class TwistsView(BookView):
    def __init__(self, found: Kinetostatics, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.springs, self.position = found, torsions_of(found.given), position

    def given(self, caption: Any) -> Table:
        """The stated springs: name, links, stiffness, moment at position 0, angle without a moment."""
        table, page = self.table("torsion_springs"), self.page
        loaded = "M_0" in table
        rows = [
            [
                page.sym(table["c"].symbol(row)), page.word(table["name"].values[row], table, "name", row),
                *(page.word(str(table[key].values[row]), table, key, row) for key in ("one", "other")),
                *(page.cell(table, key, row) for key in (("c", "M_0") if loaded else ("c",))),
                page.cell(table, "alpha_0", row),
            ]
            for row in range(len(table))
        ]  # fmt: skip
        heads = [
            self.t("Symbol"), self.t("Name"), self.t("Moment on link"), self.t("Opposite on"),
            self.t("Stiffness, N·m/rad"), *([self.t("Moment at position 0, N·m")] if loaded else []),
            page.head(own.FREE.sign, "rad"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2, 4, 3, 3, 3, 3, 3)[: len(heads)])

    def formulas(self) -> list[Formula]:
        """Of every spring the angle without a moment, where its preload is stated, and its moment on the first link."""
        return [formula for row, one in enumerate(self.springs) for formula in self._formulas(row, one)]

    def _formulas(self, row: int, one: Twist) -> list[Formula]:
        springs, k = self.table("torsion_springs"), self.position
        stiffness, free = springs.var("c", row), springs.var("alpha_0", row)
        place = next(i for i, load in enumerate(self.found.given.moments) if load is one)
        moment = q.moments(self.found.given.moments)[place].key
        out = free - self.table("twists_table").var(own.angle_of(one).key, k)
        found = [self.table("stated_table").formula(moment, k, stiffness * out)]
        if one.tie.preload is None or not one.first:
            return found
        return [springs.formula("alpha_0", row, springs.var("M_0", row) / stiffness), *found]

    def angles(self, caption: Any) -> Table:
        return self.by_positions(caption, "twists_table", [own.angle_of(one).key for one in self.springs])
