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
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric
from tmm_report.report.part import Part


def parts(found: Kinetostatics, position: int, page: Page) -> Iterator[Part]:
    if gear.gear_of(found) is not None:
        yield Part("lever/kinetostatics/gear", GearView(found, position, page), concludes=False)


class GearView:
    def __init__(self, found: Kinetostatics, position: int, page: Page):
        self.found, self.position, self.page, self.t = found, position, page, page.t
        self.book = page.once(q.book, found)

    def conclusions(self) -> Sequence[Markup]:
        return []

    @property
    def one_flank(self) -> bool:
        drive = gear.gear_of(self.found)
        return drive is not None and drive.one_flank

    @property
    def parting(self) -> list[int]:
        """Positions at which the wheel would have to pull."""
        forces = np.asarray(self.book.tables["gear_table"]["F_bal"].values)[: self.found.positions]
        rounding = ROUNDING * np.nanmax(self.found.table.scale) / self.book["r_b_gear"].value
        return [int(k) for k in np.flatnonzero(forces < -rounding) if self.one_flank]

    def base(self) -> Formula:
        radius, angle = self.book["r_w_gear"].var(), self.book["alpha_w_gear"].var()
        return self.book["r_b_gear"].formula(radius * cos(angle))

    def force(self) -> Formula:
        """At the sample position."""
        moment: Expr = self.book.tables["balancing_table"].var("M_bal", self.position)
        if self.one_flank and float(self.found.kinematics.omega) < 0:
            moment = -moment
        arm = self.book["r_b_gear"].var()
        return self.book.tables["gear_table"].formula("F_bal", self.position, moment / arm)

    def forces(self, caption: Any) -> Table:
        """The force, its direction and the reaction of the frame."""
        table, reactions = self.book.tables["gear_table"], self.book.tables["reactions_table"]
        pair = self.found.kinematics.linkage.structure.driver_pair
        keys = [q.reaction(*pair.links).key, q.reaction_angle(*pair.links).key]
        columns = [self.page.column(table, key) for key in ("F_bal", "alpha_F_bal")]
        columns += [self.page.column(reactions, key) for key in keys]
        return numeric(caption, self.page.positions(table), columns)

    def extreme(self, end: str) -> Markup:
        """ "min" or "max"."""
        return self.page.shown(self.book[f"F_bal_{end}"])

    def turned(self, end: str) -> Markup:
        """The angle of turn of an extreme, and the side of a jump: those of the moment's extreme."""
        backwards = self.one_flank and float(self.found.kinematics.omega) < 0
        return CycleView(self.found, self.page).moment_at(
            "least" if (end == "min") != backwards else "greatest"
        )
