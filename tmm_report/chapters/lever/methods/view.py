"""View of the choice of method."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.methods import quantities as q
from tmm_report.chapters.lever.methods.draw import by_counts, chart
from tmm_report.chapters.lever.methods.solve import Family, Found
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts
from tmm_report.mechanics.rivals.model import Method
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import letter
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded
from tmm_report.report.part import Part
from tmm_report.report.words import method_name

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

LOSES = N_("finds no motion at some positions")
BROKE = N_("breaks down")


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.methods is not None:
        view = MethodsView(lever.methods, page)
        yield Part("lever/methods", view)
        if lever.methods.counted is not None:
            yield Part("lever/methods/counts", view)


class MethodsView(BookView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found = found

    def conclusions(self) -> list[Markup]:
        text = N_(
            "Of the methods of the motion that hold the relative error %(accuracy)s the cheapest is: %(method)s."
        )
        family = self.found.families["motion"]
        if family.best is None:
            return []
        return [self.t(text, accuracy=self.accuracy, method=self.taken(family))]

    @property
    def accuracy(self) -> Markup:
        return self.number("methods_accuracy", digits=2, scale=0)

    @property
    def floor(self) -> Markup:
        return self.number("methods_floor", digits=1, scale=0)

    @property
    def stated(self) -> bool:
        return self.found.given.accuracy is not None

    @property
    def families(self) -> list[Family]:
        return list(self.found.families.values())

    def name(self, method: Method[Any, Any]) -> str:
        return method_name(method, self.page.tr)

    def tried(self, family: Family, caption: Any) -> Table:
        """Every method at every number of positions."""
        table, page = self.table(f"methods_{family.key}"), self.page
        heads = [
            self.t("Method"),
            *(page.head(table[key].symbol()) for key in ("count", "cost", *family.kinds)),
            self.t("Remark"),
        ]
        rows, before = [], ""
        for row, one in enumerate(family.rows):
            name = self.name(one.method)
            rows.append(
                [
                    page.word(name, table, "method", row) if name != before else "",
                    page.cell(table, "count", row),
                    page.cell(table, "cost", row, digits=3),
                    *(page.cell(table, kind, row, digits=1, scale=0) for kind in family.kinds),
                    self._remark(family, row),
                ]
            )
            before = name
        return worded(caption, heads, rows, (6, 1, 1, *(2 for _ in family.kinds), 4))

    def _remark(self, family: Family, row: int) -> Markup | str:
        one, table = family.rows[row], self.table(f"methods_{family.key}")
        if one.broken is not None:
            return self.t(BROKE)
        if any(error != error for error in one.errors.values()):
            return self.t(LOSES)
        if row in family.front:
            return self.page.word(self.t("nothing is both cheaper and more accurate"), table, "front", row)
        return ""

    def where_tried(self, family: Family) -> list[dict[str, Any]]:
        table, page = self.table(f"methods_{family.key}"), self.page
        return [page.explained(key, table[key]) for key in ("count", "cost", *family.kinds)]

    def refused(self, family: Family) -> list[Markup]:
        """The methods that cannot be used, and why."""
        text = N_("%(method)s: %(why)s")
        return [
            self.t(text, method=self.name(method), why=self.page.message(why))
            for method, why in family.refused
        ]

    def chart(self, family: Family) -> Drawing:
        admitted: Parts = letter(q.ACCURACY.sign, self.page.tr)
        return chart(
            family,
            admitted,
            letter(q.COST.sign, self.page.tr),
            letter(q.WORST.sign, self.page.tr),
            lambda one: self.name(one.method),
        )

    # ------------------------------------------------------------ what follows

    def taken(self, family: Family) -> Markup | Cell:
        """The cheapest that holds the accuracy, in words."""
        table, row = self.table("methods_chosen"), self._row(family)
        assert family.best is not None
        return self.page.said(Cell(self.name(family.best.method), table.ref("method", row)))

    def chosen(self, family: Family, key: str, **form: Any) -> Markup:
        return self.page.shown(self.table("methods_chosen"), key, self._row(family), **form)

    def _row(self, family: Family) -> int:
        return list(self.table("methods_chosen")["of"].values).index(family.key)

    def together(self, family: Family) -> tuple[str, str]:
        """The positions asked in all, and what they are the sum of."""
        return str(sum(family.asked)), " + ".join(map(str, family.asked))

    # ------------------------------------------------------------ how many positions

    @property
    def admitted(self) -> Markup:
        return self.number("counts_accuracy", digits=2, scale=0)

    def counts(self, caption: Any) -> Table:
        """Errors by the number of positions."""
        table, page = self.table("methods_counts"), self.page
        heads = [page.head(column.symbol()) for column in table.columns]
        rows = [
            [page.cell(table, column.key, row, digits=1, scale=0) if k else page.cell(table, "count", row)
             for k, column in enumerate(table.columns)]
            for row in range(len(table))
        ]  # fmt: skip
        return worded(caption, heads, rows, (1, *(2 for _ in heads[1:])))

    def where_counts(self) -> list[dict[str, Any]]:
        columns = self.table("methods_counts").columns[1:]
        return [self.page.explained(f"counts {column.key}", column) for column in columns]

    def counts_chart(self) -> Drawing:
        assert self.found.counted is not None
        words = self.page.tr
        return by_counts(
            self.found.counted,
            letter(q.ADMITTED.sign, words),
            letter(q.COUNT.sign, words),
            letter("epsilon", words),
            lambda key: letter(q.TAKEN_FROM[key].sign, words),
        )

    def enough(self) -> list[Markup]:
        """Of what is taken from the table, how many positions are enough."""
        table = self.table("methods_enough")
        return [self._enough(table, row, key) for row, key in enumerate(table["of"].values)]

    def _enough(self, table: model.Table, row: int, key: str) -> Markup:
        what = self.page.message(q.TAKEN_FROM[key].meaning)
        if table["count"].values[row] != table["count"].values[row]:
            return self.t(N_("%(what)s: none of these numbers is enough"), what=what)
        text = N_("%(what)s: from %(count)s positions on")
        return self.t(text, what=what, count=self.page.shown(table, "count", row))

    @property
    def recommended(self) -> Markup | None:
        """The number of positions from which on all errors are admitted; None where none of those tried is enough."""
        return self.number("counts_recommended") if self.knows("counts_recommended") else None
