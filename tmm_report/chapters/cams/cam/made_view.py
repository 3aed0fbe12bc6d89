"""View of how a cam is made, and of the proof of its profile."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from tmm_report.chapters.cams.cam.draw import sheet
from tmm_report.chapters.cams.cam.solve.making import Making
from tmm_report.figures.drawing import Drawing
from tmm_report.quantity.formula import Var
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table

ALIKE = 1e-9  # of the lift: what differs by less is one


class MadeView(BookView):
    """How a cam that stands alone is made, and the proof of its profile."""

    def __init__(self, made: Making, book: Book, page: Page):
        super().__init__(page, book)
        self.made = made

    def walls(self, caption: Any) -> Table:
        return self.by_positions(caption, "cam_walls")

    @property
    def exact(self) -> bool:
        """Whether the profile gives its law back but for rounding."""
        lift = self.made.found.lift
        return self.made.proof.value < ALIKE * lift

    def sheet(self) -> Drawing:
        return sheet.drawing(self.made, self._mu)

    @cached_property
    def _mu(self) -> float:
        return sheet.scale(self.made)

    def scale_var(self) -> Var:
        return scale_of("mu_l", self._mu, "m/mm")

    def reduced(self) -> Drawing:
        """The same where it shares a page."""
        return sheet.drawing(self.made, self._reduced_mu)

    @cached_property
    def _reduced_mu(self) -> float:
        return sheet.scale(self.made, sheet.SHARED)

    def reduced_scale(self) -> Var:
        return scale_of("mu_l", self._reduced_mu, "m/mm")
