"""What looks odd in the initial data and was solved all the same, as the note says it."""

from __future__ import annotations

from collections.abc import Sequence

from markupsafe import Markup

from tmm_report.problems import Problem
from tmm_report.report.page import Page


class Doubts:
    """The lines under the initial data."""

    def __init__(self, doubts: Sequence[Problem], page: Page):
        self.doubts, self.page = doubts, page

    def lines(self) -> list[Markup]:
        """A line a doubt: the key, what is odd, what may be meant."""
        return [self._line(problem) for problem in self.doubts]

    def conclusions(self) -> list[Markup]:
        return []

    def _line(self, problem: Problem) -> Markup:
        place = [self.page.text(problem.key + ": ")] if problem.key else []
        return Markup("").join([*place, self.page.message(problem.said)])
