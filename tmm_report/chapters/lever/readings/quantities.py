"""The numbers of the comparison with a student's own: one table a position."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Table, Value, plain
from tmm_report.quantity.tabulated import tabulated

if TYPE_CHECKING:
    from tmm_report.chapters.lever.readings.solve import ReadingsFound

ALLOWED = Message(N_("1: within what is allowed, 0: not"))


@tabulated
def tables(found: ReadingsFound) -> Iterator[Table]:
    for position, rows in found.rows.items():
        table = found.compared(position)
        right = plain("right", "", ALLOWED, [int(one.ok) for one in rows])
        yield Table(table.name, table.meaning, (*table.columns, right))


@tabulated
def values(found: ReadingsFound) -> Iterator[Value]:
    yield from ()
