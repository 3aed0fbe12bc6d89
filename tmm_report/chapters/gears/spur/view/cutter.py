"""View of cutting by a pinion cutter: its formulas for the wheels that it cuts, and what it leaves of a ring."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmm_report.quantity.formula import Expr, Formula, cos, sin, sqrt, tan
from tmm_report.quantity.terms.gear_terms import involute
from tmm_report.report.paper.layout import Table, padded, worded

if TYPE_CHECKING:
    from tmm_report.chapters.gears.spur.view.pair import SpurView

MM = {"m": "mm"}
MEANT = ("z0", "x0", "alpha_w0", "a_w0", "d_a0", "d_b0", "rho_l0")
SHOWN = ("z0", "x0", "a_w0", "alpha_w0", "d_a0", "d_f0", "rho_l0", "clearance0")


class CutterView:
    """What the template prints of the cutter of a pair; `of`: the view of the pair."""

    def __init__(self, of: SpurView):
        self.of, self.page, self.found = of, of.page, of.found
        self.table = of.part.table("cutter")

    @property
    def stated(self) -> bool:
        return self.found.given.cutter is not None

    def z0(self) -> Any:
        return self.page.shown(self.table, "z0", 0)

    def nominal(self) -> Any:
        """The pitch diameter of the usual cutter, mm."""
        return self.page.shown(self.table, "d_0", 0, unit="mm", digits=4)

    def formulas(self) -> Iterator[Formula]:
        """Of every wheel that a stated cutter cuts: the last pass, root circle and end of the involute."""
        for row, cut in enumerate(self.found.cutters):
            yield from self._wheel(row, cut.wheel)

    def _wheel(self, row: int, i: int) -> Iterator[Formula]:
        of, ring = self.of, self.of._ring(i)

        def tool(key: str) -> Any:
            return self.table.var(key, row, MM.get(self.table[key].unit, ""))

        def result(key: str, expression: Expr) -> Formula:
            return self.table.formula(key, row, expression, MM.get(self.table[key].unit, ""))

        z, x = of.z(i), of.x(i)
        teeth, shifts = (z - tool("z0"), x - tool("x0")) if ring else (z + tool("z0"), x + tool("x0"))
        own = involute(of.alpha_t)
        yield result("inv_alpha_w0", own + 2 * shifts * tan(of.alpha) / teeth)
        yield result("a_w0", of.m_t * teeth * cos(of.alpha_t) / (2 * cos(tool("alpha_w0"))))
        yield result("d_a0", of.m_t * tool("z0") + 2 * of.m * (of.ha + of.c + tool("x0")))
        yield result("d_b0", of.m_t * tool("z0") * cos(of.alpha_t))
        curvature = sqrt(tool("d_a0") ** 2 - tool("d_b0") ** 2) / 2
        reach = tool("a_w0") * sin(tool("alpha_w0"))
        if ring or self.found.pair.rho_l[i] >= 0:
            yield result("rho_l0", reach + curvature if ring else reach - curvature)

    def meant(self) -> list[dict[str, Any]]:
        """What the symbols of the formulas mean; the wheels' own are explained with theirs."""
        told = [(f"cutter:{key}", self.table[key]) for key in MEANT]
        return [self.page.explained(name, column, MM.get(column.unit, "")) for name, column in told]

    def _unit(self, key: str) -> str:
        return MM.get(self.table[key].unit, self.table[key].unit)

    def sizes(self, caption: Any) -> Table:
        """The cutter and what it leaves, a column for each wheel."""
        cuts = self.found.cutters
        rows = [
            [
                self.page.message(self.table[key].meaning),
                self.page.head(self.table[key].symbol(), self._unit(key)),
                *padded([self.page.cell(self.table, key, row, self._unit(key)) for row in range(len(cuts))]),
            ]
            for key in SHOWN
        ]
        wheels = [self.of.t("wheel %(name)s", name=self.of.names[cut.wheel]) for cut in cuts]
        heads = [self.of.t("Dimension"), self.of.t("Symbol"), *wheels]
        return worded(caption, heads, rows, (4, 2, *[2] * len(wheels)))
