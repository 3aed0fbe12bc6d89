"""View of cutting by a pinion cutter: its formulas for the wheels that it cuts, and what it leaves of a ring."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tmm_report.quantity.formula import Formula
from tmm_report.report.paper.layout import Table, padded, worded

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.view.pair import SpurView

FOUND = ("inv_alpha_w0", "a_w0", "d_a0", "d_b0", "rho_l0")
MEANT = ("z0", "x0", "alpha_w0", "a_w0", "d_a0", "d_b0", "rho_l0")
SHOWN = ("z0", "x0", "a_w0", "alpha_w0", "d_a0", "d_f0", "rho_l0", "clearance0")


class CutterView:
    """What the template prints of the cutter of a pair; `of`: the view of the pair."""

    def __init__(self, of: SpurView):
        self.of, self.page, self.found = of, of.page, of.found
        self.table, self.tools = of.table("cutter"), of.stage.tools

    @property
    def stated(self) -> bool:
        return self.found.given.cutter is not None

    def z0(self) -> Any:
        return self.page.shown(self.table, "z0", 0)

    def nominal(self) -> Any:
        """The pitch diameter of the usual cutter, mm."""
        return self.page.shown(self.table, "d_0", 0, digits=4)

    def formulas(self) -> list[Formula]:
        """Of every wheel that a stated cutter cuts: the last pass, root circle and end of the involute."""
        return [tool.formula(key) for tool in self.tools for key in FOUND if tool.has_formula(key)]

    def meant(self) -> list[dict[str, Any]]:
        """What the symbols of the formulas mean; the wheels' own are explained with theirs."""
        told = [(f"cutter:{key}", self.table[key]) for key in MEANT]
        return [self.page.explained(name, column, column.quantity.shown) for name, column in told]

    def sizes(self, caption: Any) -> Table:
        """The cutter and what it leaves, a column for each wheel."""
        cuts = self.found.cutters
        rows = [
            [
                self.page.message(self.table[key].meaning),
                self.page.head(self.table[key].symbol(), self.table[key].quantity.printed),
                *padded([self.page.cell(self.table, key, row) for row in range(len(cuts))]),
            ]
            for key in SHOWN
        ]
        wheels = [self.of.t("wheel %(name)s", name=self.of.names[cut.wheel]) for cut in cuts]
        heads = [self.of.t("Dimension"), self.of.t("Symbol"), *wheels]
        return worded(caption, heads, rows, (4, 2, *[2] * len(wheels)))
