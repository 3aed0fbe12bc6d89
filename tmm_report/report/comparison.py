"""The table that compares the graph-analytical method with the analytical one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tmm_report.quantity import model
from tmm_report.quantity.model import Quantity
from tmm_report.report.layout import Cell, Table, worded
from tmm_report.report.page import Page


def comparison_table(
    page: Page, caption: Any, table: model.Table, named: Mapping[str, Quantity], position: int
) -> Table:
    """`table`: of the results, a row a quantity, with "graph", "analytic" and "delta"; `named`: its quantities."""
    rows = [
        [
            page.head(named[key].sign, named[key].unit),
            *(Cell(page.num(table[by].values[row]), table.by_key(key, by, position)) for by in ("graph", "analytic")),
            Cell(_delta(page, table["delta"].values[row]), table.by_key(key, "delta", position)),
        ]
        for row, key in enumerate(table["key"].values)
    ]  # fmt: skip
    heads = [
        page.t("Quantity"), page.t("Graph-analytical method"), page.t("Analytical method"),
        page.t("Difference, %%"),
    ]  # fmt: skip
    return worded(caption, heads, rows, (3, 3, 3, 2))


def _delta(page: Page, delta: float) -> str:
    """nan: both are zero within the reading."""
    return page.num(delta, places=2) if delta == delta else "≈ 0"
