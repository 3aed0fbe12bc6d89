"""View of the plans of velocities and accelerations."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.plans import quantities as q
from tmm_report.chapters.plans.drafting import Plan, Projections
from tmm_report.chapters.plans.draw import plan_picture
from tmm_report.chapters.plans.solve import LIMIT, Drawn, Plans
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Number, Var
from tmm_report.quantity.model import Book
from tmm_report.report.comparison import comparison_table
from tmm_report.report.layout import Column, Table, numeric, worded
from tmm_report.report.page import Page
from tmm_report.report.part import Part
from tmm_report.report.words import group_name

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

_GRAPH, _ANALYTIC = Var("x_gr", 0.0), Var("x_an", 0.0)
DIFFERENCE = Definition("delta", (_GRAPH - _ANALYTIC) / (Number(0.5) * (_GRAPH + _ANALYTIC)) * Number(100))


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    yield Part("plans", PlansView(lever.plans, page))


class PlansView:
    difference = DIFFERENCE
    group = staticmethod(group_name)

    def __init__(self, found: Plans, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.named = found.named
        self.book = Book.of(q.tables(found), q.values(found))
        self.picture = cache(self._picture)

    def conclusions(self) -> list[Markup]:
        if not self.found.drawn:
            return []
        within = N_(
            "The plans of velocities and accelerations differ from the analytical method by at most %(worst)s %%, "
            "which is within the allowed 5 %%."
        )
        beyond = N_(
            "The plans of velocities and accelerations differ from the analytical method by up to %(worst)s %%, which "
            "is more than the allowed 5 %%."
        )
        return [self.t(within if self.found.worst <= LIMIT else beyond, worst=self.worst())]

    def worst(self) -> Markup:
        return self.page.shown(self.book["delta_max"], digits=3)

    def accuracy(self) -> Markup:
        return self.page.shown(self.book["accuracy"])

    # ------------------------------------------------------------ scales

    def scale(self, key: str) -> Markup:
        """ "mu_v" or "mu_a" with its value."""
        return self.page.value(self.book[key].var())

    def symbols(self, projections: Projections) -> Markup:
        """The unknowns of a group's equations."""
        return self.page.listed(self.page.sym(self.named[key].sign) for key in projections.unknown)

    def _picture(self, plan: Plan) -> Drawing:
        return plan_picture(plan)

    # ------------------------------------------------------------ tables

    def segments(self, caption: Any, kind: str) -> Table:
        return self._of_plans(caption, f"segments_{kind}", digits=7, least=6)

    def values(self, caption: Any, kind: str) -> Table:
        """Values read off all plans of a kind, "v" or "a": one row a position."""
        return self._of_plans(caption, f"plan_values_{kind}", digits=5, least=9)

    def _of_plans(self, caption: Any, name: str, digits: int, least: int) -> Table:
        table = self.book.tables[name]
        columns = [
            Column(
                self.page.head(column.symbol(), column.unit),
                [self.page.cell(table, column.key, row, digits=digits) for row in range(len(table))],
                least,
            )
            for column in table.columns[1:]
        ]
        return numeric(caption, self.page.positions(table), columns)

    def projections(self, caption: Any, plan: Plan, number: int) -> Table:
        """Coefficients of a group's unknown rates, right sides, and the solution in the last row."""
        table = self.book.tables[q.equations_name(plan, number)]
        unknown = table.columns[1:-1]
        last = len(table) - 1
        rows = [
            [
                self.page.word(contour, table, "contour", row) if row < last else self.t("Solution"),
                *(self.page.cell(table, column.key, row) for column in unknown),
                self.page.cell(table, "right", row) if row < last else "",
            ]
            for row, contour in enumerate(table["contour"].values)
        ]
        heads = [self.page.head(column.symbol(), column.unit) for column in unknown]
        heads = [self.t("Contour, axis"), *heads, self.t("Right side")]
        return worded(caption, heads, rows, [1.0] * len(heads))

    def comparison(self, caption: Any, drawn: Drawn) -> Table:
        table = self.book.tables[f"comparison_{drawn.position}"]
        return comparison_table(self.page, caption, table, self.named, drawn.position)
