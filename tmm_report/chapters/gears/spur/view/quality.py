"""View of the quality of a pair over the division of its shifts and over its centre distance."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.gears.spur.words import CONDITIONS, COUNTED, SIDES
from tmm_report.figures.charts.graphs import Graph
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Quantity
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import Line, chart, letter
from tmm_report.report.paper.layout import Table, worded

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.view.pair import SpurView

STEEP = 10.0  # specific sliding beyond which its curve runs off the sheet
PRESSED = 5.0  # and specific pressure


class QualityView(ChapterView):
    """`of`: the view of the pair."""

    def __init__(self, of: SpurView):
        assert (
            of.found.quality is not None
            and of.stage.divided is not None
            and of.found.given.quality is not None
        )
        super().__init__(of.page, of.stage.divided, of.tables)
        self.of_pair, self.found, self.names = of, of.found.quality, of.names
        self.asked = of.found.given.quality

    # ------------------------------------------------------------ what is said

    def counted(self) -> Markup:
        """How specific sliding is counted."""
        return self.t(COUNTED[self.asked.sliding])

    def pressures(self) -> list[Formula]:
        """Of the chosen pair: in the pitch point, at the lower point and at the tip of wheel 1."""
        return self.formulas("gamma_w", "gamma_p", "gamma_a")

    def meant(self) -> list[dict[str, Any]]:
        told = [("gamma", "gamma_w"), ("gamma_p", "gamma_p"), ("gamma_a", "gamma_a")]
        return [
            self.page.explained(f"quality:{name}", self.value(key), "")
            for name, key in told
            if self.knows(key)
        ]

    @property
    def free(self) -> bool:
        """Whether there are shifts that every bound allows."""
        return self.knows("x_least")

    def bounds_table(self, caption: Any) -> Table:
        """Every end that a limit sets, by the wheel that it is of."""
        table, page = self.table("bounds"), self.page
        rows = [
            [
                page.word(self.t(CONDITIONS[kind], wheel=wheel), table, "limit", row),
                page.word(self.t(SIDES[side]), table, "side", row),
                page.cell(table, table.columns[-1].key, row, places=4),
            ]
            for row, (kind, wheel, side) in enumerate(
                zip(*(table[key].values for key in ("limit", "wheel", "side")), strict=True)
            )
        ]
        heads = [self.t("Condition"), self.t("Bound"), page.head(table.columns[-1].symbol(), "")]
        return worded(caption, heads, rows, (6, 3, 2))

    # ------------------------------------------------------------ tables and curves

    def first(self, name: str) -> str:
        """The key of the column that the rows are of."""
        return self.table(name).columns[0].key

    def lengths(self, caption: Any, name: str) -> Table:
        """Shifts, contact ratio, tips and what is in hand to the fillets."""
        keys = [one.key for one in self.table(name).columns if not one.key.startswith(("lambda", "gamma"))]
        return self.numeric(caption, name, keys, digits=4)

    def contacts(self, caption: Any, name: str) -> Table:
        """Specific sliding and specific pressure."""
        keys = [one.key for one in self.table(name).columns if one.key.startswith(("lambda", "gamma"))]
        return self.numeric(caption, name, [self.first(name), *keys], digits=4)

    def curves(self, name: str) -> Graph:
        """Contact ratio, tips, specific sliding, specific pressure, a panel each."""
        table, panels, lines = self.table(name), [], []
        for panel, (start, least, most) in enumerate(
            (
                ("eps", -99.0, 99.0),
                ("tip", -99.0, 99.0),
                ("lambda", -STEEP, STEEP),
                ("gamma", -PRESSED, PRESSED),
            )
        ):
            of = [one for one in table.columns if one.key.startswith(start)]
            panels.append(self._axis(of[0].quantity))
            lines += [
                Line(one, self._letter(one.quantity) if len(of) > 1 else "", panel, most=most, least=least)
                for one in of
            ]
        return chart(lines, table.columns[0], panels, self.page.tr)

    def _axis(self, quantity: Quantity) -> Quantity:
        """Without the index of a wheel."""
        sub = "a" if quantity.key.startswith("tip") else "alpha" if quantity.key == "eps" else ""
        return replace(quantity, symbol=replace(quantity.sign, sub=sub))

    def _letter(self, quantity: Quantity) -> Any:
        return letter(quantity.sign, self.page.tr)
