"""View of the efficiency of machines joined in a tree."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.efficiency.draw import scheme
from tmm_report.chapters.machine.efficiency.given import Joined
from tmm_report.chapters.machine.efficiency.solve import Found, Part
from tmm_report.chapters.machine.efficiency.steps import joined
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper import layout
from tmm_report.report.part import Part as Printed


def parts(found: Found, page: Page) -> Iterator[Printed]:
    yield Printed("machine/efficiency", EfficiencyView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The block scheme at a glance, for a list of many."""
    return scheme(found, page.num)


class EfficiencyView(ChapterView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, [found.table])
        self.found, self.parts = found, found.table

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The efficiency of the connected machines is %(eta)s, their loss coefficient %(psi)s; the module to "
            "improve first is %(first)s."
        )
        eta, psi = (self.number(key, digits=4) for key in ("eta_whole", "psi_whole"))
        return [self.t(text, eta=eta, psi=psi, first=self.named(self.found.first))]

    # ------------------------------------------------------------ words

    def named(self, part: Part) -> Markup:
        """Number and name of a part."""
        number = self.page.said(layout.Cell(part.index, self.parts.ref("index", part.row)))
        return self.t(N_("%(number)s (%(name)s)"), number=number, name=part.name) if part.name else number

    def eta(self, part: Part) -> Markup:
        """symbol = value."""
        return self.page.value(self.parts.var("eta", part.row), digits=4)

    @property
    def series(self) -> bool:
        """Whether the outermost parts stand in series, more than one of them."""
        node = self.found.whole.node
        return isinstance(node, Joined) and node.kind == "series" and len(node.parts) > 1

    @property
    def worst_part(self) -> Part:
        return min(self.found.whole.parts, key=lambda part: part.efficiency)

    @property
    def best_part(self) -> Part:
        return max(self.found.whole.parts, key=lambda part: part.efficiency)

    # ------------------------------------------------------------ formulas

    def formula(self, key: str, **form: Any) -> Formula:
        return super().formula(key, **{"digits": 4, **form})

    def groups(self) -> list[Formula]:
        """Efficiency of every group from those of its parts, the innermost first, the whole last."""
        *inner, _ = self.found.groups
        rows = [self.parts.formula("eta", part.row, joined(part, self.parts), digits=4) for part in inner]
        return [*rows, self.formula("eta_whole")]

    def power(self) -> list[Formula]:
        """The power that is not stated."""
        return self.formulas("P_in_whole", "P_out_whole")

    def slope(self) -> Formula | None:
        """Of a module that stands in series with all the rest: the product of the others."""
        part = self.found.first
        if not self.series or part not in self.found.whole.parts:
            return None
        ratio = self.s.var("eta_whole") / self.parts.var("eta", part.row)
        return self.parts.formula("kappa", part.row, ratio, digits=4)

    def symbols(self) -> list[dict[str, Any]]:
        """The symbols of the table, without the index of a part."""
        keys = ["eta", "psi", "share", "P_in", "P_out", "P_lost", "kappa"]
        if any(part.node.by == "output" for part in self.found.groups if isinstance(part.node, Joined)):
            keys.insert(3, "output_share")
        columns = [self.parts[key] for key in keys]
        return [self.page.explained(f"efficiency_{one.key}", one, one.quantity.printed) for one in columns]

    # ------------------------------------------------------------ table and scheme

    def modules(self, caption: Any) -> layout.Table:
        """Modules and groups: efficiency, loss, share, power, derivative of the whole."""
        keys = ("eta", "psi", "share", "P_in", "P_out", "P_lost", "kappa")
        columns = [self.parts[key] for key in keys]
        heads = [self.t("No."), self.t("Part")]
        heads += [self.page.head(one.quantity.sign, one.quantity.printed) for one in columns]
        _, *parts = self.found.whole.within()
        rows = [self._module(part, keys) for part in parts]
        return layout.worded(caption, heads, rows, (1, 6, 2, 2, 2, 2, 2, 2, 2))

    def _module(self, part: Part, keys: Sequence[str]) -> list[Any]:
        page, table, row = self.page, self.parts, part.row
        kind = part.node.kind if isinstance(part.node, Joined) else ""
        kinds = {"series": N_("parts in series"), "parallel": N_("parallel parts")}
        name: Any = page.word(part.name, table, "name", row)
        if not part.name:
            name = page.word(self.t(kinds[kind]), table, "kind", row) if kind else "—"
        numbers = (page.cell(table, key, row, digits=4) for key in keys)
        return [layout.Cell(part.index, table.ref("index", row)), name, *numbers]

    def scheme(self) -> Drawing:
        return scheme(self.found, self.page.num, str(self.t(N_("Block scheme of the machines joined"))))
