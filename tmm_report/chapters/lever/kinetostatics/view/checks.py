"""View of the checks of the balancing moment: Zhukovsky's lever and the power balance."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, worded
from tmm_report.report.part import Part

POWER_BALANCE = Definition("M_bal", (Var("dT", 0.0) / Var("dt", 0.0) - Var("N", 0.0)) / Var("omega_1", 0.0))


def part(found: Kinetostatics, position: int, drawn: bool, page: Page) -> Part:
    """`drawn`: whether the lever was drawn."""
    return Part("lever/kinetostatics/lever", LeverView(found, position, drawn, page), concludes=False)


class LeverView(BookView):
    power_balance = POWER_BALANCE

    def __init__(self, found: Kinetostatics, position: int, drawn: bool, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.position = found, position
        self.drawn = drawn

    def conclusions(self) -> Sequence[Markup]:
        return []

    def powers(self, caption: Any) -> Table:
        """Powers of all loads at the sample position, and their sum."""
        table, k = self.table("powers_table"), self.position
        rows = []
        for loads in q.loads_of_powers(self.found):
            key = q.power(loads).key
            size = abs(float(table[key].values[k]))
            symbols = self.page.listed(self.page.sym(load.sign) for load in loads)
            rows.append([symbols, self.page.cell(table, key, k, scale=max(1.0, size))])
        rows.append([self.t("Sum"), self.page.cell(table, "N_sum", k)])
        heads = [self.t("Loads"), self.page.listed([self.t("Power"), self.page.unit("W")])]
        return worded(caption, heads, rows, (1, 1))

    def lever_formula(self) -> Formula:
        """The balancing moment from the sum of powers, at the sample position."""
        total = self.table("powers_table").var("N_sum", self.position)
        kinematics = self.found.kinematics
        link = kinematics.linkage.mechanism.driver.link
        if kinematics.by_law:
            omega = float(kinematics.table.angular_velocity(link)[self.position])
            ref = Ref(f"w_{link}", self.position, "rates_table")
        else:
            omega, ref = kinematics.omega, Ref("omega")
        speed = Var(Symbol("omega", link), omega, "rad/s", ref=ref)
        return self.table("balancing_table").formula("M_lever", self.position, -total / speed)

    def disagreement(self, of: str) -> Markup:
        """The worst of the "lever" or of the "power" balance."""
        return self.bound(f"{of}_disagreement")
