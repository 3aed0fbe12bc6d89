"""Parts that the tables of several chapters share."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.plans.solve import Comparison
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import symbol_of, unit_of
from tmm_report.report.layout import Column, Table, worded
from tmm_report.report.page import Page
from tmm_report.report.words import Words

Array = Any


class Columns:
    """Columns and heads, from the results."""

    def __init__(self, results: Any, page: Page, words: Words):
        self.r, self.page, self.words = results, page, words
        self.t, self.sym, self.col = page.t, page.sym, page.col

    def _head(self, symbol: Symbol | str, unit: str = "") -> Markup:
        text = self.sym(symbol)
        return self.page.listed([text, self.page.unit(unit)]) if unit else text

    def _positions(self, count: int) -> Column:
        return self._first(self.t("Position"), [str(k) for k in range(count)])

    def _first(self, head: Markup, cells: Sequence[str]) -> Column:
        return Column(head, cells, least=len(head))

    def _signed(self, key: str, values: Array) -> Column:
        return Column(self._head(symbol_of(key), unit_of(key)), self.col(values))

    def comparison(self, caption: Any, comparisons: Sequence[Comparison]) -> Table:
        rows = [
            [
                self._head(symbol_of(c.key), unit_of(c.key)), self.page.num(c.graph), self.page.num(c.analytic),
                self.page.num(c.delta, places=2) if c.delta is not None else "≈ 0",
            ]
            for c in comparisons
        ]  # fmt: skip
        heads = [
            self.t("Quantity"),
            self.t("Graph-analytical method"),
            self.t("Analytical method"),
            self.t("Difference, %%"),
        ]
        return worded(caption, heads, rows, (3, 3, 3, 2))
