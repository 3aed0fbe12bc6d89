"""Table of the power through meshes, which a drive and a compound train print alike."""

from __future__ import annotations

from typing import Any

from tmm_report.problems import N_
from tmm_report.quantity.model import Table
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table as Printed
from tmm_report.report.paper.layout import worded


def power_flow(page: Page, table: Table, caption: Any) -> Printed:
    """Of every mesh its carrier, the wheel that drives, its power, loss and efficiency. `table`: columns mesh, carrier,
    driving, N, N_fr, eta."""
    names = zip(*(table[key].values for key in ("mesh", "carrier", "driving")), strict=True)
    rows = [
        [
            page.word(mesh.replace("-", "–"), table, "mesh", row),
            page.word(carrier or "—", table, "carrier", row),
            page.word(driving or "—", table, "driving", row),
            page.cell(table, "N", row, size=True),
            page.cell(table, "N_fr", row, digits=4),
            page.cell(table, "eta", row, digits=4),
        ]
        for row, (mesh, carrier, driving) in enumerate(names)
    ]
    heads = [
        *(page.t(text) for text in (N_("Mesh"), N_("Carrier"), N_("Driving wheel"))),
        *(page.head(table[key].symbol(), table[key].unit) for key in ("N", "N_fr", "eta")),
    ]
    return worded(caption, heads, rows, [12, 14, 22, 18, 18, 16])
