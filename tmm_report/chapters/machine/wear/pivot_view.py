"""View of the wear of a pivot."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.wear import draw
from tmm_report.chapters.machine.wear.formulas import PivotFormulas
from tmm_report.chapters.machine.wear.pivot import PivotFound
from tmm_report.chapters.machine.wear.quantities import MEMBER_WORDS
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, Words, worded


class PivotView(PivotFormulas):
    def __init__(self, found: PivotFound, prefix: str, page: Page):
        super().__init__(found, prefix)
        self.page, self.t = page, page.t

    def conclusions(self) -> Sequence[Markup]:
        text = N_("The pivot %(name)s wears by up to %(depth)s µm after %(cycles)s cycles.")
        values = {"depth": self.number("greatest", "µm", digits=4), "cycles": self.number("cycles")}
        return [self.t(text, name=self.found.given.pivot, **values)]

    @property
    def label(self) -> str:
        return self.prefix.replace("_", ":")

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.of[key], unit=unit, **form)

    def sized(self, key: str, unit: str = "") -> Markup:
        return self.page.value(self.v(key, unit))

    def given_values(self) -> Markup:
        units = {"diameter": "mm", "width": "mm", "arc": "deg", "cycles": "", "sectors": ""}
        return self.page.listed(self.sized(key, unit) for key, unit in units.items())

    def where(self, *formulas: Formula) -> list[dict[str, Any]]:
        return [{**item, "id": ("wear", item["id"])} for item in self.page.where(*formulas)]

    def member_table(self, caption: Any) -> Table:
        table, page = self.members, self.page
        units = {"k": "", "path": "", "depth": "µm", "angle": "deg", "volume": "mm³"}
        if "mass" in table:
            units["mass"] = "g"
        heads = [page.t("Element"), page.t("Link")]
        heads += [page.head(table[key].quantity.sign, unit or table[key].unit) for key, unit in units.items()]
        rows = [
            [
                Words(self.t(MEMBER_WORDS[table["member"].values[row]]), table.ref("member", row)),
                page.word(table["link"].values[row], table, "link", row),
                *(page.cell(table, key, row, unit, digits=4) for key, unit in units.items()),
            ]
            for row in range(len(table))
        ]
        return worded(caption, heads, rows, (3, 2, *(2 for _ in units)))

    @cached_property
    def worn(self) -> Drawing:
        return draw.worn(self.found)

    def drawn_scale(self) -> Markup:
        """Micrometres of wear to a millimetre of paper."""
        return self.page.value(scale_of("mu_u", 1e6 * draw.drawn_scale(self.found), "µm/mm"))
