"""View of the comparison with a student's own numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.plans.solve import Plans
from tmm_report.chapters.lever.readings.solve import ReadingsFound
from tmm_report.problems import N_
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
    """What the plans give too stands in their comparison: here are the numbers of other quantities."""

    def __init__(self, found: ReadingsFound, plans: Plans, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.compared = {drawn.position: {c.key for c in drawn.comparison} for drawn in plans.drawn}

    @property
    def positions(self) -> list[int]:
        """Those that have numbers beside the plans' own."""
        return [position for position in self.found.rows if self.others(position)]

    def others(self, position: int) -> list[int]:
        """Rows of a position's numbers that the plans do not give, in the order of the file."""
        known = self.compared.get(position, set())
        return [row for row, one in enumerate(self.found.rows[position]) if one.key not in known]

    def table(self, caption: Any, position: int) -> Table:
        named = {one.key: one.asked.quantity for one in self.found.rows[position]}
        of = self.found.compared(position)
        return own_numbers_table(self.page, caption, of, named, position, self.others(position))

    def conclusions(self) -> list[Markup]:
        wrong = len(self.found.wrong)
        if not wrong:
            return []
        total = sum(map(len, self.found.rows.values()))
        text = N_(
            "Of %(all)s numbers of the student's own %(wrong)s differ from the analytical ones by more than is allowed."
        )
        return [self.t(text, all=total, wrong=wrong)]
