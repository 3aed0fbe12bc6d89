"""A cam that stands alone over its turn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from tmm_report.chapters.cams.cam.given import Given
from tmm_report.chapters.cams.cam.solve.found import Cams, pair
from tmm_report.chapters.cams.cam.solve.making import making
from tmm_report.chapters.cams.cam.solve.turn import whole_turn
from tmm_report.problems import N_, Message
from tmm_report.quantity.text import amounts
from tmm_report.records import dataclass

LETTERS = ("O", "C")


@dataclass(frozen=True, eq=False)
class Found(Cams):
    """Found by `solve`; `sample`: the table position of which formulas are written out; `driven`: whether the drive's
    output shaft turns it."""

    sample: int = 0
    driven: bool = False

    @property
    def sound(self) -> bool:
        """Whether the pressure angles are within the permitted ones."""
        return not any(one.exceeds or one.exceeds_back for one in self.cams)

    def summary(self) -> Iterator[Message]:
        """The main numbers in a sentence."""
        text = N_(
            "cam: base circle %(base)s mm; greatest pressure angles %(rise)s° in the rise, %(back)s° in the return; "
            "least radius of curvature %(rho)s mm"
        )
        for one in self.cams:
            rise, back = (float(np.degrees(end.value)) for end in (one.rise, one.back))
            sizes = {"base": 1e3 * one.cam.base, "rho": 1e3 * one.least.value}
            yield Message(text, amounts({"rise": rise, "back": back, **sizes}))


def solve(given: Given) -> Found:
    turn = whole_turn(given.cam, given.sense, given.table, given.diagram, given.omega)
    found = replace(pair(given.cam, turn, LETTERS), shaft=given.shaft, groove=given.groove)
    moving = np.flatnonzero(np.abs(found.table.first[: turn.distinct]) > 1e-9 * max(abs(found.lift), 1e-9))
    sample = int(moving[0]) if moving.size else 0
    return Found((found,), (making(given, found),), sample, given.driven)
