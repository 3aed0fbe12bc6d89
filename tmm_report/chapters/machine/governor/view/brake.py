"""View of the centrifugal brake."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.governor.draw import brake
from tmm_report.chapters.machine.governor.formulas.brake import BrakeFormulas
from tmm_report.chapters.machine.governor.quantities import whole as q
from tmm_report.chapters.machine.governor.solve.brake import BrakeFound
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.model import Book
from tmm_report.report.diagrams import plot
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric

UNITS = {
    "n": "", "m": "", "rho": "mm", "gap": "mm", "R": "mm", "f": "", "c": "N/mm", "F_0": "", "M": "", "J": "",
}  # fmt: skip
ROW = 10  # of the table, whose moment is written out


class BrakeView:
    def __init__(self, found: BrakeFound, book: Book, page: Page):
        self.found, self.book, self.page, self.t = found, book, page, page.t
        self.formulas = BrakeFormulas(book)

    def given_values(self) -> Markup:
        return self.page.values(self.book[f"governor_brake_{key}"].var(UNITS[key]) for key in self._keys())

    def _keys(self) -> list[str]:
        known = [key for key in UNITS if f"governor_brake_{key}" in self.book.values]
        return [key for key in known if self.book[f"governor_brake_{key}"].value]

    def explained(self) -> list[dict[str, Any]]:
        of = {key: self.book[f"governor_brake_{key}"] for key in self._keys()}
        return [self.page.explained(f"brake:{key}", one, UNITS[key] or one.unit) for key, one in of.items()]

    def where(self) -> list[dict[str, Any]]:
        """Of what the formulas find: letters of the brake stand for other things than those of the governor."""
        keys = ("rho_contact", "F", "contact", "K", "held", "spread", "pressing", "power", "contact_time")
        known = [key for key in keys if f"governor_brake_{key}" in self.book.values]
        of = {key: self.book[f"governor_brake_{key}"] for key in known}
        return [self.page.explained(f"brake:{key}", one, one.unit) for key, one in of.items()]

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.book[f"governor_brake_{key}"], unit=unit, **form)

    def moment(self) -> Any:
        return self.formulas.moment(ROW)

    def speed_of_row(self) -> Markup:
        return self.page.shown(self.book.tables["governor_brake"], "omega", ROW)

    def moments(self, caption: Any) -> Table:
        table = self.book.tables["governor_brake"]
        first = self.page.column(table, "omega")
        return numeric(
            caption, first, [self.page.column(table, "omega", "rpm"), self.page.column(table, "M_b")]
        )

    @cached_property
    def drawing(self) -> Drawing:
        return brake.brake(self.found, str(self.t(N_("Scheme of the centrifugal brake"))))

    @cached_property
    def graph(self) -> Graph:
        """The braking moment over the speed, with the driving one."""
        speed = np.linspace(0.0, float(self.found.omega[-1]), 121)
        braking = self.found.given.brake.moment(speed)
        driving = np.full_like(speed, self.found.given.moment)
        held = (self.found.held, self.found.given.moment)
        curves = [
            Curve(braking, str(self.t(N_("braking"))), extremes=[held]),
            Curve(driving, str(self.t(N_("driving"))), extremes=()),
        ]
        return plot(curves, speed, q.SHAFT, [(q.BRAKING.sign, "N·m")], self.page.tr)

    @cached_property
    def start(self) -> Graph:
        curve = Curve(self.found.started, extremes=())
        return plot([curve], self.found.t, q.TIME, [(q.SHAFT.sign, "rad/s")], self.page.tr)

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The shoes of the centrifugal brake touch the drum at %(contact)s rpm; against the driving moment the "
            "brake holds %(held)s rpm."
        )
        return [self.t(text, contact=self.number("contact", "rpm"), held=self.number("held", "rpm"))]
