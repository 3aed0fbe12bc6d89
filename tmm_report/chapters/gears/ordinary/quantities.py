"""The numbers of an ordinary stage that anyone can read."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.problems import N_
from tmm_report.quantity.model import Table, Value
from tmm_report.quantity.tabulated import tabulated

TITLES = {
    "belt open": N_("belt drive, open"),
    "belt crossed": N_("belt drive, crossed"),
    "belt V": N_("drive of V-belts"),
}


@tabulated
def values(found: Found, prefix: str) -> Iterator[Value]:
    """The single numbers, whose names begin with the label of the stage, which is `prefix`."""
    return found.s.values()


@tabulated
def tables(found: Found, prefix: str) -> Iterator[Table]:
    yield from ()
