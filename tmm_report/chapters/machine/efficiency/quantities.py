"""The numbers of machines joined in a tree: efficiency, loss and power of every part, derivative of the whole by it."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.machine.efficiency.solve import Found
from tmm_report.quantity.model import Table, Value
from tmm_report.quantity.tabulated import tabulated

HEADLINE = ("eta_whole", "P_in_whole", "P_out_whole")  # what is looked for first


@tabulated
def tables(found: Found) -> Iterator[Table]:
    yield found.table


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()
