"""View of the wear of a pivot; what it shares with that of a guide."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.wear import draw, equations
from tmm_report.chapters.machine.wear.pivot import PivotFound
from tmm_report.chapters.machine.wear.quantities import MEMBER_WORDS, pivot_tables
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.written import Equation
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, Words, worded


class PairView(ChapterView):
    """Of one pair of several; a symbol of the wear is explained once for all of them."""

    @property
    def label(self) -> str:
        return self.prefix.rstrip("_").replace("_", ":")

    def where(self, *formulas: Formula | Equation) -> list[dict[str, Any]]:
        return [{**item, "id": ("wear", item["id"])} for item in super().where(*formulas)]

    def worn_by(self, text: str, name: str) -> Markup:
        depth = self.number("greatest")
        return self.t(text, name=name, depth=depth, cycles=self.number("cycles"))


class PivotView(PairView):
    def __init__(self, found: PivotFound, page: Page):
        super().__init__(page, found.s, pivot_tables(found))
        self.found, self.members = found, self.table("members")

    def conclusions(self) -> Sequence[Markup]:
        text = N_("Pivot %(name)s wears by up to %(depth)s µm after %(cycles)s cycles.")
        return [self.worn_by(text, self.found.given.pivot)]

    def given_values(self) -> Markup:
        return self.listed(("diameter", "width", "arc", "cycles", "sectors"))

    def sums(self) -> list[Definition]:
        return equations.sectors(self.found)

    def depths(self) -> list[Formula]:
        return equations.depths(self.found, self.members)

    def volumes(self) -> list[Formula]:
        return equations.pivot_volumes(self.found, self.members)

    def member_table(self, caption: Any) -> Table:
        table, page = self.members, self.page
        _, _, *columns = table.columns
        heads = [page.t("Element"), page.t("Link")]
        heads += [page.head(one.quantity.sign, one.quantity.printed) for one in columns]
        rows = [
            [
                Words(self.t(MEMBER_WORDS[table["member"].values[row]]), table.ref("member", row)),
                page.word(table["link"].values[row], table, "link", row),
                *(page.cell(table, one.key, row, digits=4) for one in columns),
            ]
            for row in range(len(table))
        ]
        return worded(caption, heads, rows, (3, 2, *(2 for _ in columns)))

    @cached_property
    def worn(self) -> Drawing:
        return draw.worn(self.found)

    def drawn_scale(self) -> Markup:
        """Micrometres of wear to a millimetre of paper."""
        return self.page.value(scale_of("mu_u", 1e6 * draw.drawn_scale(self.found), "µm/mm"))
