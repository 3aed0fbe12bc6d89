"""The tables of the balancing as the note prints them."""

from __future__ import annotations

from typing import Any

from markupsafe import Markup

from tmm_report.chapters.machine.balancing.formulas import BalancingFormulas
from tmm_report.chapters.machine.balancing.quantities import weights
from tmm_report.chapters.machine.balancing.quantities import whole as q
from tmm_report.chapters.machine.balancing.solve.cases import Case
from tmm_report.problems import N_
from tmm_report.report.paper.layout import Table, numeric, worded

WAYS = {
    "original": N_("as it is"),
    "stated": N_("the counterweights that are there"),
    "full": N_("all mass centres moved to the frame"),
    "pivoted": N_("counterweights on all links with fixed pivots"),
    "substituted": N_("masses substituted into the joints"),
    "optimum_rms": N_("one counterweight on the driving link, least mean square"),
    "optimum_max": N_("one counterweight on the driving link, least maximum"),
    "rotors_1": N_("counter-rotating weights of the first order"),
    "rotors_2": N_("counter-rotating weights of the first and second order"),
}
_WEIGHT_UNITS = {"U": "kg·m", "beta": "°", "rho": "mm", "m_c": "kg"}


class BalancingSheet(BalancingFormulas):
    def way(self, case: Case) -> Markup:
        return self.t(WAYS[case.name])

    def shaking(self, caption: Any) -> Table:
        table = self.book.tables["shaking_table"]
        keys = [*(part.key for part in q.FORCE.components), q.FORCE.key, q.MOMENT.key]
        columns = [self.page.column(table, key) for key in keys]
        return numeric(caption, self.page.positions(table), columns)

    def left(self, caption: Any) -> Table:
        """Shaking force and moment at the positions, by the numbers of the ways."""
        table = self.book.tables["balanced_table"]
        numbers = range(1, len(self.found.every))
        keys = [of(n).key for of in (q.force, q.moment) for n in numbers]
        return numeric(caption, self.page.positions(table), [self.page.column(table, key) for key in keys])

    def cases(self, caption: Any) -> Table:
        table, page = self.book.tables["balancing_cases"], self.page
        size = self.found.original.force_max.value
        units = {
            "F_max": "N",
            "F_max_at": "°",
            "left": "%",
            "F_rms": "N",
            "M_max": "N·m",
            "M_rms": "N·m",
            "m_total": "kg",
        }
        heads = [self.t("No."), self.t("Way of balancing")]
        heads += [page.head(table[key].symbol(), unit) for key, unit in units.items()]
        rows = []
        for row, case in enumerate(self.found.every):
            numbers: list[Any] = [
                page.cell(table, "F_max", row, scale=size),
                page.cell(table, "F_max_at", row, places=1),
                page.cell(table, "left", row, "%", places=2),
                page.cell(table, "F_rms", row, scale=size),
                *(page.cell(table, key, row) for key in ("M_max", "M_rms", "m_total")),
            ]
            if not self.found.every[row].force_max.value > 1e-9 * size:
                numbers[1] = "—"
            rows.append([str(row), self.way(case), *numbers])
        return worded(caption, heads, rows, (1, 8, 3, 2, 2, 3, 3, 3, 3))

    def counterweights(self, caption: Any) -> Table:
        table, page = self.book.tables["counterweights"], self.page
        heads = [self.t("Way of balancing"), self.t("Link")]
        heads += [page.head(table[key].quantity.sign, unit) for key, unit in _WEIGHT_UNITS.items()]
        rows = [
            [
                self.way(case),
                page.word(one.link, table, "link", row),
                page.cell(table, "U", row),
                page.cell(table, "beta", row, places=2),
                page.cell(table, "rho", row, "mm"),
                page.cell(table, "m_c", row),
            ]
            for row, (case, one) in enumerate(weights.placed(self.found.cases))
        ]
        return worded(caption, heads, rows, (8, 2, 3, 3, 3, 3))

    def masses(self, caption: Any, case: Case) -> Table:
        """The masses that the counterweights of a way meet."""
        table, page = self.book.tables["counterweight_masses"], self.page
        heads = [self.t("Link"), self.t("Point")]
        heads += [
            page.head(table[key].quantity.sign, unit) for key, unit in (("m", "kg"), ("x", "mm"), ("y", "mm"))
        ]
        rows = [
            [
                page.word(str(table["link"].values[row]), table, "link", row),
                page.word(str(table["point"].values[row]), table, "point", row),
                page.cell(table, "m", row),
                page.cell(table, "x", row, "mm"),
                page.cell(table, "y", row, "mm"),
            ]
            for row, name in enumerate(table["method"].values)
            if name == case.name
        ]
        return worded(caption, heads, rows, (2, 2, 3, 3, 3))

    def substituted(self, caption: Any) -> Table:
        table, page = self.book.tables["substituted_masses"], self.page
        units = {"m_A": "kg", "m_B": "kg", "J_rest": "kg·m²", "m_A3": "kg", "m_B3": "kg", "m_S3": "kg"}
        heads = [self.t("Link"), self.t("Joints")]
        heads += [page.head(table[key].quantity.sign, unit) for key, unit in units.items()]
        rows = [
            [
                page.word(one.link, table, "link", row),
                ", ".join(one.joints),
                *(page.cell(table, key, row) for key in units),
            ]
            for row, one in enumerate(self.found.substituted.splits)
        ]
        return worded(caption, heads, rows, (3, 4, 4, 4, 5, 4, 4, 4))

    def harmonics(self, caption: Any) -> Table:
        table, page = self.book.tables["shaking_harmonics"], self.page
        keys = ("order", "F_with", "alpha_with", "F_against", "alpha_against")
        heads = [
            page.head(table[key].quantity.sign, "°" if table[key].unit == "deg" else table[key].unit)
            for key in keys
        ]
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
        return worded(caption, heads, rows, (1, 3, 3, 3, 3))

    def rotors(self, caption: Any) -> Table:
        table, page = self.book.tables["lanchester_rotors"], self.page
        units = {"mr": "kg·m", "alpha": "°", "r": "mm", "m": "kg"}
        units = units if self.found.given.radii else {key: units[key] for key in ("mr", "alpha")}
        heads = [self.t("Speed of the rotor, in those of the driving link")]
        heads += [page.head(table[key].quantity.sign, unit) for key, unit in units.items()]
        size = max(one.moment for one in self.found.rotors)
        rows = [
            [
                page.cell(table, "order", row),
                page.cell(table, "mr", row, scale=size),
                page.cell(table, "alpha", row, places=2),
                *(page.cell(table, key, row, "mm" if key == "r" else "") for key in list(units)[2:]),
            ]
            for row in range(len(table))
        ]
        return worded(caption, heads, rows, (6, 3, 3, 3, 3)[: len(heads)])
