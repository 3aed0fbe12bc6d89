"""The tables of the balancing as the note prints them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.balancing.quantities import weights
from tmm_report.chapters.machine.balancing.solve.cases import Case
from tmm_report.chapters.machine.balancing.values import force, moment
from tmm_report.chapters.machine.balancing.view.moment import AgainstMoment
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.report.paper.layout import Table, numeric, worded

WAYS = {
    "original": N_("as it is"),
    "stated": N_("the counterweights that are there"),
    "full": N_("all mass centres moved to the frame"),
    "pivoted": N_("counterweights on all links with fixed pivots"),
    "substituted": N_("masses concentrated at the joints"),
    "optimum_rms": N_("one counterweight on the driving link, least mean square"),
    "optimum_max": N_("one counterweight on the driving link, least maximum"),
}
ROTATING = {
    (1,): N_("counter-rotating weights of the first order"),
    (1, 2): N_("counter-rotating weights of the first and second order"),
}
MORE = {
    "inertia": N_("as way %(n)s, and wheels geared to the links"),
    "couples": N_("as way %(n)s, and weights in antiphase"),
}


class BalancingSheet(AgainstMoment):
    compared = ("F_max", "F_max_at", "left", "F_rms", "M_max", "M_rms", "m_total")  # columns of the ways

    def way(self, case: Case) -> Markup:
        if case.base is not None:
            return self.t(MORE[case.name], n=self.found.every.index(case.base))
        if case.rotors:
            return self.rotating(tuple(one.order for one in case.rotors if one.order > 0))
        return self.t(WAYS[case.name])

    def rotating(self, orders: tuple[int, ...]) -> Markup:
        """Counter-rotating weights by their orders."""
        if orders in ROTATING:
            return self.t(ROTATING[orders])
        if len(orders) == 1:
            return self.t(N_("counter-rotating weights of order %(order)s"), order=orders[0])
        return self.t(N_("counter-rotating weights of orders %(orders)s"), orders=", ".join(map(str, orders)))

    def shaking(self, caption: Any) -> Table:
        columns = self.columns("shaking_table", ("F_shake_x", "F_shake_y", "F_shake", "M_shake"))
        return numeric(caption, self.page.positions(self.table("shaking_table")), columns)

    def left(self, caption: Any) -> Table:
        """Shaking force and moment at the positions, by the numbers of the ways."""
        numbers = range(1, len(self.found.every))
        keys = [of(n).key for of in (force, moment) for n in numbers]
        columns = self.columns("balanced_table", keys)
        return numeric(caption, self.page.positions(self.table("balanced_table")), columns)

    def heads(self, table: model.Table, keys: Iterable[str]) -> list[Markup]:
        """Letter and unit of columns."""
        of = [table[key].quantity for key in keys]
        return [self.page.head(one.sign, one.printed) for one in of]

    def cases(self, caption: Any) -> Table:
        table, page = self.table("balancing_cases"), self.page
        size = self.found.original.force_max.value
        heads = [self.t("No."), self.t("Way of balancing"), *self.heads(table, self.compared)]
        rows = []
        for row, case in enumerate(self.found.every):
            numbers: list[Any] = [
                page.cell(table, "F_max", row, scale=size),
                page.cell(table, "F_max_at", row, places=1),
                page.cell(table, "left", row, places=2),
                page.cell(table, "F_rms", row, scale=size),
                *(page.cell(table, key, row) for key in ("M_max", "M_rms", "m_total")),
            ]
            if not self.found.every[row].force_max.value > 1e-9 * size:
                numbers[1] = "—"
            rows.append([str(row), self.way(case), *numbers])
        return worded(caption, heads, rows, (1, 8, 3, 2, 2, 3, 3, 3, 3))

    def counterweights(self, caption: Any) -> Table:
        table, page = self.table("counterweights"), self.page
        heads = [self.t("Way"), self.t("Link")]
        heads += self.heads(table, ("U", "beta", "rho", "m_c"))
        rows = [
            [
                page.word(str(self.found.every.index(case)), table, "method", row),
                page.word(one.link, table, "link", row),
                page.cell(table, "U", row),
                page.cell(table, "beta", row, places=2),
                page.cell(table, "rho", row),
                page.cell(table, "m_c", row),
            ]
            for row, (case, one) in enumerate(weights.placed(self.found.cases))
        ]
        return worded(caption, heads, rows, (2, 2, 3, 3, 3, 3))

    def masses(self, caption: Any, case: Case) -> Table:
        """The masses that the counterweights of a way meet."""
        table, page = self.table("counterweight_masses"), self.page
        heads = [self.t("Link"), self.t("Point"), *self.heads(table, "mxy")]
        rows = [
            [
                page.word(str(table["link"].values[row]), table, "link", row),
                page.word(str(table["point"].values[row]), table, "point", row),
                *(page.cell(table, key, row) for key in "mxy"),
            ]
            for row, name in enumerate(table["method"].values)
            if name == case.name
        ]
        return worded(caption, heads, rows, (2, 2, 3, 3, 3))

    def substituted(self, caption: Any) -> Table:
        table, page = self.table("substituted_masses"), self.page
        keys = ("m_A", "m_B", "J_rest", "m_A3", "m_B3", "m_S3")
        heads = [self.t("Link"), self.t("Joints"), *self.heads(table, keys)]
        rows = [
            [
                page.word(one.link, table, "link", row),
                ", ".join(one.joints),
                *(page.cell(table, key, row) for key in keys),
            ]
            for row, one in enumerate(self.found.substituted.splits)
        ]
        return worded(caption, heads, rows, (3, 4, 4, 4, 5, 4, 4, 4))

    def harmonics(self, caption: Any) -> Table:
        table, page = self.table("shaking_harmonics"), self.page
        keys = ("order", "F_with", "alpha_with", "F_against", "alpha_against")
        size = self.found.original.force_max.value
        rows = [
            [
                page.cell(table, "order", row),
                *(
                    page.cell(table, key, row, places=2)
                    if key.startswith("alpha")
                    else page.cell(table, key, row, scale=size)
                    for key in keys[1:]
                ),
            ]
            for row in range(len(table))
        ]
        return worded(caption, self.heads(table, keys), rows, (1, 3, 3, 3, 3))

    def rotors(self, caption: Any) -> Table:
        table, page = self.table("lanchester_rotors"), self.page
        sizes = ("r", "m") if self.found.given.radii else ()
        heads = [self.t("Speed of the rotor by that of the driving link")]
        heads += self.heads(table, ("mr", "alpha", *sizes))
        size = max(one.moment for one in self.found.rotors)
        rows = [
            [
                page.cell(table, "order", row),
                page.cell(table, "mr", row, scale=size),
                page.cell(table, "alpha", row, places=2),
                *(page.cell(table, key, row) for key in sizes),
            ]
            for row in range(len(table))
        ]
        return worded(caption, heads, rows, (6, 3, 3, 3, 3)[: len(heads)])
