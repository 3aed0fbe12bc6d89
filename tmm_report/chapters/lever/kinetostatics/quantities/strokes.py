"""The numbers of indicator diagrams stated stroke by stroke: when each stroke begins and ends."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
    from tmm_report.mechanics.calculus.laws import ByStrokes

Array = Any

STROKES = Message(N_("strokes of the indicator diagrams over the cycle"))
BEGINS = Quantity(
    "begins",
    Symbol("phi"),
    "deg",
    Message(N_("angle of rotation from position 0 at which the stroke begins")),
)
ENDS = Quantity("ends", Symbol("phi"), "deg", Message(N_("angle of rotation at which it ends")))

WORDS = {
    "intake": N_("intake stroke"),
    "compression": N_("compression stroke"),
    "power": N_("power stroke"),
    "exhaust": N_("exhaust stroke"),
}
"""Strokes of an engine by the names that a variant may state them by."""


def strokes_table(found: Kinetostatics, keys: list[str]) -> Iterator[Table]:
    """One row a stroke, load by load; `keys`: of the stated forces. Nothing where no diagram is stated so."""
    rows = [row for k, key in enumerate(keys) if k in found.strokes for row in _rows(found, k, key)]
    if rows:
        load, name, begins, ends = zip(*rows, strict=True)
        yield Table(
            "strokes",
            STROKES,
            (
                text_column("load", Message(N_("load")), list(load)),
                text_column("stroke", Message(N_("stroke")), list(name)),
                BEGINS.column(np.array(begins)),
                ENDS.column(np.array(ends)),
            ),
        )


def _rows(found: Kinetostatics, k: int, key: str) -> Iterator[tuple[str, str, float, float]]:
    """In the order in which they begin; one that goes on into the next cycle ends early in it."""
    law: ByStrokes = found.given.forces[k].law  # type: ignore[assignment]
    own = found.strokes[k]
    ends = np.where(own.ends > own.period + 1e-9, own.ends - own.period, own.ends)
    for begin, end, stated in zip(np.degrees(own.begins), np.degrees(ends), own.stated, strict=True):
        yield key, law.names[stated], float(begin), float(end)
