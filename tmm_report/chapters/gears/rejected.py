"""Why sets of teeth were rejected, which a planetary stage and a compound train say alike."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import TypeVar

from markupsafe import Markup

from tmm_report.quantity.model import Table
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell

R = TypeVar("R", bound=Enum)


def rejected(page: Page, table: Table, count: str, words: Mapping[R, str]) -> Markup:
    """How many fail by each condition, the first that fails. `table`: columns reason and `count`; `words`: what is said
    of a reason, message ids."""
    named = {one.name.lower(): text for one, text in words.items()}
    said = [
        page.t(
            "%(reason)s (%(count)s)",
            reason=page.said(Cell(page.tr.gettext(named[name]), table.ref("reason", row))),
            count=page.said(Cell(str(int(table[count].values[row])), table.ref(count, row))),
        )
        for row, name in enumerate(table["reason"].values)
    ]
    return page.listed(said, "; ")
