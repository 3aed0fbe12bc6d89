"""View of a driving link turned by a gear: the balancing force on the line of action in place of a moment."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.kinetostatics.quantities import driving_gear as gear
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.kinetostatics.solve.whole_cycle import ROUNDING
from tmm_report.chapters.lever.kinetostatics.view.cycle import CycleView
from tmm_report.quantity.formula import Expr, Formula, cos
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Part


def parts(found: Kinetostatics, position: int, page: Page) -> Iterator[Part]:
    if gear.gear_of(found) is not None:
        yield Part("lever/kinetostatics/gear", GearView(found, position, page), concludes=False)


class GearView(BookView):
    def __init__(self, found: Kinetostatics, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.position = found, position

    def conclusions(self) -> Sequence[Markup]:
        return []

    @property
    def one_flank(self) -> bool:
        drive = gear.gear_of(self.found)
        return drive is not None and drive.one_flank

    @property
    def parting(self) -> list[int]:
        """Positions at which the wheel would have to pull."""
        forces = np.asarray(self.of("gear_table", "F_bal").values)[: self.found.positions]
        rounding = ROUNDING * np.nanmax(self.found.table.scale) / self.value("r_b_gear").value
        return [int(k) for k in np.flatnonzero(forces < -rounding) if self.one_flank]

    def base(self) -> Formula:
        radius, angle = self.value("r_w_gear").var(), self.value("alpha_w_gear").var()
        return self.value("r_b_gear").formula(radius * cos(angle))

    def force(self) -> Formula:
        """At the sample position."""
        moment: Expr = self.table("balancing_table").var("M_bal", self.position)
        if self.one_flank and float(self.found.kinematics.omega) < 0:
            moment = -moment
        arm = self.value("r_b_gear").var()
        return self.table("gear_table").formula("F_bal", self.position, moment / arm)

    def forces(self, caption: Any) -> Table:
        """The force, its direction and the reaction of the frame."""
        pair = self.found.kinematics.linkage.structure.driver_pair
        keys = (q.reaction(*pair.links).key, q.reaction_angle(*pair.links).key)
        reactions = self.columns("reactions_table", keys)
        return self.by_positions(caption, "gear_table", ["F_bal", "alpha_F_bal", *reactions])

    def extreme(self, end: str) -> Markup:
        """ "min" or "max"."""
        return self.number(f"F_bal_{end}")

    def extreme_at(self, end: str) -> Markup:
        """The angle of turn of an extreme, and the side of a jump: those of the moment's extreme."""
        backwards = self.one_flank and float(self.found.kinematics.omega) < 0
        return CycleView(self.found, self.page).moment_at(
            "least" if (end == "min") != backwards else "greatest"
        )
