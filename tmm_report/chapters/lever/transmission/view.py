"""View of the transmission angles."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.transmission.quantities import angle, arms, span, tables, values
from tmm_report.chapters.lever.transmission.solve import Coupler, Found
from tmm_report.figures.charts.graphs import Graph
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, arccos
from tmm_report.quantity.model import Book
from tmm_report.report.diagrams import cycle_chart
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric
from tmm_report.report.part import Failed, Part

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.transmission is not None and lever.transmission.couplers:
        yield Part("lever/transmission", TransmissionView(lever.transmission, lever.sample, page))


class TransmissionView:
    def __init__(self, found: Found, position: int, page: Page):
        self.found, self.position, self.page = found, position, page
        self.book = Book.of(tables(found), values(found))

    def formula(self, of: Coupler) -> Formula:
        """By the law of cosines, or by the distance from the guide."""
        table, lengths = (
            self.book.tables["transmission_table"],
            [self.book[one.key].var() for one in arms(of)],
        )
        a, b, apart = lengths[0], lengths[-1], table.var(span(of).key, self.position)
        cosine = apart / a if of.dyad.kind == 2 else abs(a**2 + b**2 - apart**2) / (2 * a * b)
        return table.formula(angle(of).key, self.position, arccos(cosine), "deg")

    def angles(self, caption: Any) -> Table:
        table = self.book.tables["transmission_table"]
        columns = [self.page.column(table, column.key) for column in table.columns[2:]]
        return numeric(caption, self.page.positions(table), columns)

    def diagram(self) -> Graph:
        keys = [angle(one).key for one in self.found.couplers]
        return cycle_chart(self.book.tables["transmission_diagram"], keys, self.page.tr)

    def conclusions(self) -> list[Markup]:
        good = N_(
            "The least transmission angle is %(least)s at joint %(joint)s, not less than the permitted %(most)s."
        )
        bad = N_(
            "The least transmission angle is %(least)s at joint %(joint)s, less than the permitted %(most)s."
        )
        worst = min(self.found.couplers, key=lambda one: one.least().value)
        least, most = self.book[f"{angle(worst).key}_min"], self.book["transmission"]
        fails, shown = least.value < most.value, self.page.measured
        said = self.page.t(
            bad if fails else good,
            least=shown(least, digits=4),
            joint=worst.dyad.inner.name,
            most=shown(most),
        )
        return [Failed(said) if fails else said]
