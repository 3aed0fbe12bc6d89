"""View of the efficiency of machines joined in a tree."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from operator import add, mul
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.efficiency import quantities as q
from tmm_report.chapters.machine.efficiency.draw import scheme
from tmm_report.chapters.machine.efficiency.given import Joined
from tmm_report.chapters.machine.efficiency.solve import Found, Part
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book
from tmm_report.report.page import Page
from tmm_report.report.paper import layout
from tmm_report.report.part import Part as Printed


def parts(found: Found, page: Page) -> Iterator[Printed]:
    yield Printed("machine/efficiency", EfficiencyView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The block scheme at a glance, for a list of many."""
    return scheme(found, page.num)


class EfficiencyView:
    def __init__(self, found: Found, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.book = Book.of(q.tables(found), q.values(found))
        self.table = self.book.tables["efficiency_parts"]
        self.rows = q.parts(found)

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The efficiency of the machines joined is %(eta)s, their loss coefficient %(psi)s; the module to improve "
            "first is %(first)s."
        )
        eta, psi = (self.page.shown(self.book[key], digits=4) for key in ("eta_whole", "psi_whole"))
        return [self.t(text, eta=eta, psi=psi, first=self.named(self.found.first))]

    # ------------------------------------------------------------ words

    def named(self, part: Part) -> Markup:
        """Number and name of a part."""
        number = self.page.said(layout.Cell(part.index, self.table.ref("index", self._row(part))))
        return self.t(N_("%(number)s (%(name)s)"), number=number, name=part.name) if part.name else number

    def number(self, part: Part, key: str, **form: Any) -> Markup:
        return self.page.shown(self.table, key, self._row(part), **form)

    def eta(self, part: Part) -> Markup:
        """symbol = value."""
        return self.page.value(self.table.var("eta", self._row(part)), digits=4)

    def _row(self, part: Part) -> int:
        return self.rows.index(part)

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

    def groups(self) -> list[Formula]:
        """Efficiency of every group from those of its parts, the innermost first, the whole last."""
        return [self._group(part) for part in self.found.groups]

    def _group(self, part: Part) -> Formula:
        row = self._row(part)
        etas: list[Expr] = [self._of("eta", inner) for inner in part.parts]
        node = part.node
        assert isinstance(node, Joined)
        if node.kind == "series":
            return self._whole_or_group(row, reduce(mul, etas))
        key = "share" if node.by == "input" else "output_share"
        shares = [self._of(key, inner) for inner in part.parts]
        if node.by == "input":
            return self._whole_or_group(row, reduce(add, map(mul, shares, etas)))
        return self._whole_or_group(
            row, 1 / reduce(add, (s / eta for s, eta in zip(shares, etas, strict=True)))
        )

    def _whole_or_group(self, row: int, expression: Expr) -> Formula:
        if row == 0:
            return self.book["eta_whole"].formula(expression, digits=4)
        return self.table.formula("eta", row, expression, digits=4)

    def _of(self, key: str, part: Part) -> Var:
        return self.table.var(key, self._row(part), digits=4)

    def loss(self) -> Formula:
        return self.book["psi_whole"].formula(1 - self.book["eta_whole"].var(digits=4), digits=4)

    def power(self) -> Formula:
        """The power that is not stated."""
        eta = self.book["eta_whole"].var(digits=4)
        one, other = self.book["P_in_whole"], self.book["P_out_whole"]
        if self.found.given.output is not None:
            return one.formula(other.var("kW") / eta, "kW", digits=4)
        return other.formula(one.var("kW") * eta, "kW", digits=4)

    def slope(self) -> Formula | None:
        """Of a module that stands in series with all the rest: the product of the others."""
        part = self.found.first
        if not self.series or part not in self.found.whole.parts:
            return None
        ratio = self.book["eta_whole"].var(digits=4) / self._of("eta", part)
        return self.table.formula("kappa", self._row(part), ratio, digits=4)

    # ------------------------------------------------------------ table and scheme

    def modules(self, caption: Any) -> layout.Table:
        """Modules and groups: efficiency, loss, share, power, derivative of the whole."""
        page, power = self.page, ("P_in", "P_out", "P_lost")
        unit = "kW" if self.found.stated else ""
        keys = ["eta", "psi", "share"]
        heads = [self.t("No."), self.t("Part"), *(page.head(self.table[key].symbol()) for key in keys)]
        heads += [page.head(self.table[key].symbol(), unit) for key in power]
        heads.append(page.head(self.table["kappa"].symbol()))
        rows = [self._module(row, keys, power, unit) for row in range(1, len(self.rows))]
        return layout.worded(caption, heads, rows, (1, 6, 2, 2, 2, 2, 2, 2, 2))

    def _module(self, row: int, keys: list[str], power: tuple[str, ...], unit: str) -> list[Any]:
        page, part = self.page, self.rows[row]
        kind = part.node.kind if isinstance(part.node, Joined) else ""
        kinds = {"series": N_("parts in series"), "parallel": N_("parallel parts")}
        name: Any = page.word(part.name, self.table, "name", row)
        if not part.name:
            name = page.word(self.t(kinds[kind]), self.table, "kind", row) if kind else "—"
        return [
            layout.Cell(part.index, self.table.ref("index", row)), name,
            *(page.cell(self.table, key, row, digits=4) for key in keys),
            *(page.cell(self.table, key, row, unit, digits=4) for key in power),
            page.cell(self.table, "kappa", row, digits=4),
        ]  # fmt: skip

    def where(self) -> list[dict[str, Any]]:
        """The symbols of the table, without the index of a part."""
        columns = [self.table[key] for key in ("eta", "psi", "share", "P_in", "P_out", "P_lost", "kappa")]
        if any(part.node.by == "output" for part in self.found.groups if isinstance(part.node, Joined)):
            columns.insert(3, self.table["output_share"])
        units = {"W": "kW"}  # as in the formulas and in the table
        return [
            self.page.explained(f"efficiency_{one.key}", one, units.get(one.unit, one.unit))
            for one in columns
        ]

    def scheme(self) -> Drawing:
        return scheme(self.found, self.page.num, str(self.t(N_("Block scheme of the machines joined"))))
