"""What the ways of balancing make of the shaking moment, and what lowers it, as the note prints it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.kinematics import quantities as rates
from tmm_report.chapters.machine.balancing.given import COUPLES, INERTIA
from tmm_report.chapters.machine.balancing.solve.cases import Case
from tmm_report.chapters.machine.balancing.values import moment
from tmm_report.chapters.machine.balancing.view.rows import BalancingRows
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula
from tmm_report.report.paper.layout import Table, numeric, worded

CHANGED = 1e-6  # relative: less is rounding


class AgainstMoment(BalancingRows):
    def _by(self, name: str) -> Case | None:
        return next((case for case in self.found.cases if case.name == name), None)

    @property
    def geared(self) -> Case | None:
        """The way with wheels geared to the links."""
        return self._by(INERTIA)

    @property
    def coupled(self) -> Case | None:
        """The way with weights in antiphase."""
        return self._by(COUPLES)

    @property
    def first_against(self) -> Case | None:
        return next((case for case in self.found.cases if case.base is not None), None)

    @property
    def takes(self) -> bool:
        """Whether a wheel takes anything of the moment."""
        return self.geared is not None and any(one.inertia for one in self.geared.wheels)

    @property
    def weighs(self) -> bool:
        """Whether weights in antiphase take anything of the moment."""
        return self.coupled is not None and any(one.moment for one in self.coupled.couples)

    # ------------------------------------------------------------ what becomes of the moment

    def raised(self) -> Markup:
        """The ways that raise the greatest moment, each with what it makes of it; empty where none does."""
        return self.page.listed(self._told(n) for n in self._changed(1))

    def lowered(self) -> Markup:
        return self.page.listed(self._told(n) for n in self._changed(-1))

    def _changed(self, sense: int) -> list[int]:
        first = self.found.original.moment_max.value
        of = enumerate(self.found.every)
        return [n for n, case in of if sense * (case.moment_max.value - first) > CHANGED * first]

    def _told(self, number: int) -> Markup:
        table = self.table("balancing_cases")
        if not table["M_max"].number(0):
            return self.t(N_("way %(n)s to %(moment)s N·m"), n=number, moment=self.moment_max(number))
        text = N_("way %(n)s to %(moment)s N·m (%(percent)s %%)")
        percent = self.page.shown(table, "M_left", number, digits=4)
        return self.t(text, n=number, moment=self.moment_max(number), percent=percent)

    def moment_max(self, number: int) -> Markup:
        return self.page.shown(self.table("balancing_cases"), "M_max", number)

    # ------------------------------------------------------------ wheels

    def wheel_formula(self, case: Case) -> Formula:
        """The moment that wheels leave at one position."""
        k = self.position
        total: Expr = self._moment_before(case)
        for row, wheel in enumerate(case.wheels):
            if wheel.inertia:
                table = self.table("geared_inertia")
                rate = self._rates.var(rates.link_rate("e", wheel.link).key, k)
                total = total - table.var("J", row) * table.var("i", row) * rate
        return self.table("balanced_table").formula(moment(self._number(case)).key, k, total)

    def _moment_before(self, case: Case) -> Expr:
        assert case.base is not None
        number = self._number(case.base)
        if number:
            return self.table("balanced_table").var(moment(number).key, self.position)
        return self.table("shaking_table").var("M_shake", self.position)

    def _number(self, case: Case) -> int:
        return self.found.every.index(case)

    def wheels(self, caption: Any) -> Table:
        table, page = self.table("geared_inertia"), self.page
        heads = [
            self.t("Link"),
            *(page.head(table[key].quantity.sign, table[key].quantity.printed) for key in "iJ"),
        ]
        rows = [
            [
                page.word(str(link), table, "link", row),
                page.cell(table, "i", row),
                page.cell(table, "J", row),
            ]
            for row, link in enumerate(table["link"].values)
        ]
        return worded(caption, heads, rows, (3, 3, 4))

    # ------------------------------------------------------------ weights in antiphase

    def couple_formulas(self) -> Iterator[Formula]:
        """Static moment and mass of the weights of the order with the greatest moment."""
        table = self.table("antiphase_weights")
        row = max(range(len(table)), key=lambda k: table["M"].number(k))
        omega = self.given["omega"].var()
        turns = (table.var("order", row) * omega) ** 2
        yield table.formula("U", row, table.var("M", row) / (turns * table.var("d", row)))
        yield table.formula("m", row, table.var("U", row) / table.var("r", row))

    def couples(self, caption: Any) -> Table:
        return self._by_order(caption, "antiphase_weights", ("M", "U", "alpha", "d", "r", "m"))

    def moment_harmonics(self, caption: Any) -> Table:
        return self._by_order(caption, "moment_harmonics", ("M", "M_before", "M_after"))

    def _by_order(self, caption: Any, name: str, keys: tuple[str, ...]) -> Table:
        order = self.page.singles(self.table(name), "order", places=0)
        return numeric(caption, order, self.columns(name, keys))
