"""The table that compares the graph-analytical method with the analytical one, and a student's own numbers too."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from tmm_report.quantity import model
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.text import short_and_full
from tmm_report.quantity.written import DIGITS, PLACES, decimals
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import DASH, Cell, Table, worded

NOTHING = "≈ 0"  # where both are zero within the reading
PER_CENT = 2  # decimals of a difference


def comparison_table(
    page: Page,
    caption: Any,
    table: model.Table,
    named: Mapping[str, Quantity],
    position: int,
    segments: Mapping[str, Cell] | None = None,
    own: model.Table | None = None,
    leave: Collection[str] = (),
) -> Table:
    """`table`: of the results, a row a quantity, with "graph", "analytic" and "delta"; `named`: its quantities.

    `segments`: what was measured, mm, by the keys of the quantities, where it is told here; `own`: the same table of a
    student's own numbers, which stand in the rows of their quantities; `leave`: keys without a row, but for own ones.
    """
    if own is not None:
        leave = set(leave).difference(map(str, own["key"].values))
    heads = [
        page.t("Quantity"), page.t("Graphical"), page.t("Analytical"), page.t("Difference, %%"),
    ]  # fmt: skip
    rows = _rows(page, table, named, position, segments, leave)
    shares = [3, 3, 3, 2]
    if segments is not None:
        heads.insert(1, page.t("Segment, mm"))
        shares.insert(1, 3)
    if own is not None:
        heads += [page.t("Own value"), page.t("its δ, %%")]
        shares += [3, 2]
        for key, row in rows.items():
            row += _own(page, own, key, position)
    return worded(caption, heads, rows.values(), shares)


def side_by_side(
    page: Page,
    caption: Any,
    tables: Mapping[int, model.Table],
    named: Mapping[str, Quantity],
    segments: Mapping[int, Mapping[str, Cell]],
    leave: Collection[str] = (),
) -> Table:
    """The same of two positions or more, by these: of each beside the quantities its columns, under the letters of the
    formula of the difference."""
    every = [_rows(page, table, named, k, segments[k], leave) for k, table in tables.items()]
    first, *others = every
    rows = [[*row, *(cell for other in others for cell in other[key][1:])] for key, row in first.items()]
    letters = page.sym("x_gr"), page.sym("x_an"), page.listed([page.sym("delta"), "%"])
    heads = [page.t("Quantity"), *(page.t("Segment, mm"), *letters) * len(every)]
    return worded(caption, heads, rows, (4, *(3, 3, 3, 2) * len(every)))


def _rows(
    page: Page,
    table: model.Table,
    named: Mapping[str, Quantity],
    position: int,
    segments: Mapping[str, Cell] | None,
    leave: Collection[str],
) -> dict[str, list[Any]]:
    """By the keys of the quantities; segments stand behind these."""
    rows = {
        str(key): _compared(page, table, named, position, row)
        for row, key in enumerate(table["key"].values)
        if key not in leave
    }
    if segments is not None:
        for key, row in rows.items():
            row.insert(1, segments.get(key, DASH))
    return rows


def _own(page: Page, own: model.Table, key: str, position: int) -> tuple[Any, Any]:
    """A student's number of a quantity, the first of its name, and its difference; dashes where there is none."""
    keys = list(own["key"].values)
    if key not in keys:
        return DASH, DASH
    row = keys.index(key)
    return _number(page, own, key, position, row, "graph"), _delta(page, own, key, position, row, DASH)


def own_numbers_table(
    page: Page,
    caption: Any,
    table: model.Table,
    named: Mapping[str, Quantity],
    position: int,
    chosen: Sequence[int],
) -> Table:
    """A student's own numbers against the analytical ones: of the `chosen` rows."""
    heads = [
        page.t("Quantity"), page.t("Own value"), page.t("Analytical"), page.t("Difference, %%"),
    ]  # fmt: skip
    rows = [_compared(page, table, named, position, row, DASH) for row in chosen]
    return worded(caption, heads, rows, (3, 3, 3, 2))


def _compared(
    page: Page,
    table: model.Table,
    named: Mapping[str, Quantity],
    position: int,
    row: int,
    without: str = NOTHING,
) -> list[Any]:
    """Quantity, both values and the difference; `without`: what is printed where there is none."""
    key = table["key"].values[row]
    return [
        page.head(named[key].sign, named[key].unit),
        *(_number(page, table, key, position, row, by) for by in ("graph", "analytic")),
        _delta(page, table, key, position, row, without),
    ]


def _number(page: Page, table: model.Table, key: str, position: int, row: int, by: str) -> Cell:
    """What was worked by hand has three decimals or the digits that it needs, the analytical value its five digits."""
    x = float(table[by].values[row])
    short, full = short_and_full(x, DIGITS, page.tr.decimal)
    if by == "graph" and x:
        places = min(PLACES, max(0, decimals(abs(x))))
        few = short_and_full(x, DIGITS, page.tr.decimal, places)[1]
        full = few if len(few) > len(short) else short
    return Cell(full if x else short, table.by_key(key, by, position))


def _delta(page: Page, table: model.Table, key: str, position: int, row: int, without: str) -> Cell:
    """Without one, nan, both are zero within the reading, or their signs are opposite."""
    delta = table["delta"].values[row]
    text = without if delta != delta else short_and_full(float(delta), 5, page.tr.decimal, PER_CENT)[1]
    return Cell(text, table.by_key(key, "delta", position))
