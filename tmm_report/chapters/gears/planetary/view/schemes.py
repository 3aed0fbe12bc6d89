"""How the note prints the schemes that were judged side by side."""

from __future__ import annotations

from typing import Any

from markupsafe import Markup

from tmm_report.chapters.gears.planetary.solve.schemes import Choice, Judged
from tmm_report.problems import N_
from tmm_report.quantity.model import Table
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, worded
from tmm_report.report.paper.layout import Table as Layout

SCHEMES = {
    "sun-ring": N_("single-row, external and internal mesh"),
    "external-external": N_("double-row, two external meshes"),
    "external-internal": N_("double-row, external and internal mesh"),
    "internal-internal": N_("double-row, two internal meshes"),
}


class SchemesView:
    """The comparison as the note prints it. `table`: `schemes_table` of the stage."""

    def __init__(self, choice: Choice, page: Page, table: Table):
        self.choice, self.page, self.table, self.t = choice, page, table, page.t

    def comparison(self, caption: Any) -> Layout:
        table, page, t = self.table, self.page, self.t
        rows = [self._row(one, row) for row, one in enumerate(self.choice.judged)]
        heads = [
            t("Scheme"), t("Solutions"), t("Best teeth"), page.head("k"), page.head("u"),
            page.head(table["D"].symbol(), "mm"), page.head(table["eta"].symbol()), t("Remark"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (4, 1.6, 2.6, 0.7, 1.5, 1.5, 1.5, 2.2))

    def _row(self, one: Judged, row: int) -> list[Any]:
        table, page = self.table, self.page
        name = page.word(page.tr.gettext(SCHEMES[one.scheme.name]), table, "scheme", row)
        count = Cell(str(one.solutions), table.ref("solutions", row))
        if one.teeth is None:
            return [name, count, "—", "—", "—", "—", "—", self.t("no solution")]
        locks = page.word(page.tr.gettext(N_("locks")), table, "eta", row)
        return [
            name,
            count,
            page.word(table["teeth"].values[row], table, "teeth", row),
            page.cell(table, "k", row),
            page.cell(table, "u", row),
            page.cell(table, "D", row, "mm"),
            page.cell(table, "eta", row, places=4) if one.works else locks,
            page.word(page.tr.gettext(N_("taken")), table, "taken", row) if row == self.choice.chosen else "",
        ]

    def said(self) -> Markup:
        """Why the scheme is taken."""
        choice, row = self.choice, self.choice.chosen
        name = self.page.tr.gettext(SCHEMES[choice.taken.scheme.name])
        values = {
            "name": name,
            "eta": self.page.shown(self.table, "eta", row),
            "size": self.page.shown(self.table, "D", row, "mm"),
        }
        works = sum(one.works for one in choice.judged)
        if works == 1:
            return self.t(
                "Only one scheme gives the ratio and can be driven, and it is taken: %(name)s.", **values
            )
        if len(choice.close) == 1:
            text = N_(
                "The scheme with the best efficiency is taken, as no other comes within one per cent of it: %(name)s, "
                "%(eta)s."
            )
            return self.t(text, **values)
        text = N_(
            "Of the schemes whose efficiency is within one per cent of the best the most compact is taken: %(name)s, "
            "with the efficiency %(eta)s, filling a diameter of %(size)s mm."
        )
        return self.t(text, **values)
