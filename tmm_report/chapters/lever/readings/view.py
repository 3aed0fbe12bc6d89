"""View of the comparison with a student's own numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.plans.solve import Plans
from tmm_report.chapters.lever.readings import quantities as q
from tmm_report.chapters.lever.readings.solve import Reading, ReadingsFound
from tmm_report.judging.model import Rule
from tmm_report.problems import N_
from tmm_report.quantity.model import Book
from tmm_report.report.comparison import own_numbers_table
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Part

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.readings is not None:
        yield Part("lever/readings", ReadingsView(lever.readings, lever.plans, page))


class ReadingsView:
    def __init__(self, found: ReadingsFound, plans: Plans, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.tables = Book.of(q.tables(found)).tables
        # what the plans are compared in, in its order: its analytical values are not printed again
        self.compared = {drawn.position: [c.key for c in drawn.comparison] for drawn in plans.drawn}

    @property
    def positions(self) -> list[int]:
        return list(self.found.rows)

    def beside(self, position: int) -> list[int]:
        """Rows of a position's numbers whose analytical values stand in the comparison of its plans, in its order."""
        order = self.compared.get(position, [])
        rows = [row for row, one in enumerate(self.found.rows[position]) if one.key in order]
        return sorted(rows, key=lambda row: order.index(self.found.rows[position][row].key))

    def others(self, position: int) -> list[int]:
        """The other rows, in the order of the file."""
        beside = set(self.beside(position))
        return [row for row in range(len(self.found.rows[position])) if row not in beside]

    def table(self, caption: Any, position: int, rows: list[int], analytic: bool) -> Table:
        """The rows of a position. `analytic`: whether with the analytical values."""
        numbers = self.found.rows[position]
        named = {one.key: one.asked.quantity for one in numbers}
        said = [self._said(numbers[row]) for row in rows]
        of = self.tables[q.table_name(position)]
        return own_numbers_table(self.page, caption, of, named, position, said, rows, analytic)

    def _said(self, one: Reading) -> str:
        if one.rule is Rule.NOT_ASKED:
            return self.t("not defined at this position")
        if one.rule is Rule.ZERO:
            return self.t("right: nothing by the plan")
        if one.ok:
            return self.t("right in magnitude, no sense given") if one.unsigned else self.t("right")
        return self.t("wrong: the sign is opposite") if one.rule is Rule.SIGN else self.t("wrong")

    def causes(self) -> list[Markup | str]:
        """Likely mistakes, in sentences."""
        return [self.page.message(cause.what) for cause in self.found.causes]

    def conclusions(self) -> list[Markup]:
        wrong = len(self.found.wrong)
        if not wrong:
            return []
        total = sum(map(len, self.found.rows.values()))
        text = N_(
            "Of %(all)s numbers of the student's own %(wrong)s differ from the analytical ones by more than is allowed."
        )
        return [self.t(text, all=total, wrong=wrong)]
