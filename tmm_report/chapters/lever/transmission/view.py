"""View of the transmission angles."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.transmission.quantities import angle, arms, span, tables, values
from tmm_report.chapters.lever.transmission.solve import Found
from tmm_report.figures.charts.graphs import Graph
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, arccos
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Failed, Part

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.transmission is not None:
        yield Part("lever/transmission", TransmissionView(lever.transmission, lever.sample, page))


class TransmissionView(BookView):
    def __init__(self, found: Found, position: int, page: Page):
        super().__init__(page, Book.of(tables(found), values(found)))
        self.found, self.position = found, position

    def formula(self, of: Dyad) -> Formula:
        """By the law of cosines, or by the distance from the guide."""
        table, lengths = self.table("transmission_table"), [self.var(one.key) for one in arms(of)]
        a, b, apart = lengths[0], lengths[-1], table.var(span(of).key, self.position)
        cosine = apart / a if of.kind == 2 else abs(a**2 + b**2 - apart**2) / (2 * a * b)
        return table.formula(angle(of).key, self.position, arccos(cosine), "deg")

    def angles(self, caption: Any) -> Table:
        return self.by_positions(caption, "transmission_table")

    def diagram(self) -> Graph:
        return self.over_cycle("transmission_diagram", [angle(one).key for one in self.found.couplers])

    def conclusions(self) -> list[Markup]:
        good = N_(
            "The least transmission angle is %(least)s at joint %(joint)s, not less than the permitted %(most)s."
        )
        bad = N_(
            "The least transmission angle is %(least)s at joint %(joint)s, less than the permitted %(most)s."
        )
        if not (joints := [one.inner.name for one in self.found.couplers]):
            return []
        worst = min(joints, key=lambda joint: self.value(f"mu_{joint}_min").value)
        fails = self.value(f"mu_{worst}_min").value < self.found.permitted
        least, most = self.measured(f"mu_{worst}_min", digits=4), self.measured("transmission")
        said = self.t(bad if fails else good, joint=worst, least=least, most=most)
        return [Failed(said) if fails else said]
