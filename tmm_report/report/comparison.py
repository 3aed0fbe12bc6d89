"""The table that compares the graph-analytical method with the analytical one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmm_report.quantity import model
from tmm_report.quantity.model import Quantity
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded


def comparison_table(
    page: Page, caption: Any, table: model.Table, named: Mapping[str, Quantity], position: int
) -> Table:
    """`table`: of the results, a row a quantity, with "graph", "analytic" and "delta"; `named`: its quantities."""
    rows = _compared(page, table, named, position, "≈ 0", range(len(table)))
    heads = [
        page.t("Quantity"), page.t("Graph-analytical method"), page.t("Analytical method"),
        page.t("Difference, %%"),
    ]  # fmt: skip
    return worded(caption, heads, rows, (3, 3, 3, 2))


def own_numbers_table(
    page: Page,
    caption: Any,
    table: model.Table,
    named: Mapping[str, Quantity],
    position: int,
    said: Sequence[Any],
    chosen: Sequence[int],
    analytic: bool,
) -> Table:
    """The same of a student's own numbers, of the `chosen` rows, with what is `said` of each in the last column.

    `analytic`: whether the analytical values stand beside them; not where another table has them."""
    rows = _compared(page, table, named, position, "—", chosen)
    heads = [
        page.t("Quantity"), page.t("Own value"), page.t("Analytical method"), page.t("Difference, %%"),
        page.t("Result"),
    ]  # fmt: skip
    kept = [0, 1, 2, 3, 4] if analytic else [0, 1, 3, 4]
    lines = [[*row, one] for row, one in zip(rows, said, strict=True)]
    shares = (3, 3, 3, 2, 4)
    return worded(
        caption,
        [heads[i] for i in kept],
        [[line[i] for i in kept] for line in lines],
        [shares[i] for i in kept],
    )


def _compared(
    page: Page,
    table: model.Table,
    named: Mapping[str, Quantity],
    position: int,
    without: str,
    chosen: Sequence[int],
) -> list[list[Any]]:
    """Quantity, both values and the difference; `without`: what is printed where there is none."""
    return [
        [
            page.head(named[key].sign, named[key].unit),
            *(Cell(page.num(table[by].values[row]), table.by_key(key, by, position)) for by in ("graph", "analytic")),
            Cell(_delta(page, table["delta"].values[row], without), table.by_key(key, "delta", position)),
        ]
        for row, key in ((row, table["key"].values[row]) for row in chosen)
    ]  # fmt: skip


def _delta(page: Page, delta: float, without: str) -> str:
    """Without one, nan, both are zero within the reading, or their signs are opposite."""
    return page.num(delta, places=2) if delta == delta else without
