"""View of the centrifugal brake."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.governor.draw import brake
from tmm_report.chapters.machine.governor.quantities import of_brake
from tmm_report.chapters.machine.governor.solve.brake import BrakeFound
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import Line, chart, plot
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric

GIVEN = ("n", "m", "rho", "gap", "R", "f", "c", "F_0", "M", "J")
FOUND = ("rho_contact", "F", "contact", "K", "held", "spread", "pressing", "power", "contact_time")
ROW = 10  # of the table, whose moment is written out


class BrakeView(ChapterView):
    def __init__(self, found: BrakeFound, page: Page):
        super().__init__(page, found.s, of_brake(found))
        self.found = found
        self.places = next(iter(of_brake(found)))

    def given_values(self) -> Markup:
        return self.listed(self._given())

    def _given(self) -> list[str]:
        return [key for key in GIVEN if self.s.get(key)]

    def explained_given(self) -> list[dict[str, Any]]:
        return self.explained(*self._given())

    def explained_found(self) -> list[dict[str, Any]]:
        """Of what the formulas find: letters of the brake stand for other things than those of the governor."""
        return self.explained(*FOUND)

    def moment(self) -> Formula:
        """At one of the speeds of the table."""
        over = self.places.var("omega", ROW) ** 2 - self.var("contact") ** 2
        return self.places.formula("M_b", ROW, self.var("K") * over)

    def speed_of_row(self) -> Markup:
        return self.page.shown(self.places, "omega", ROW)

    def moments(self, caption: Any) -> Table:
        first, *others = (
            self.page.column(self.places, *one) for one in (("omega",), ("omega", "rpm"), ("M_b",))
        )
        return numeric(caption, first, others)

    @cached_property
    def drawing(self) -> Drawing:
        return brake.brake(self.found, str(self.t(N_("Scheme of the centrifugal brake"))))

    @cached_property
    def graph(self) -> Graph:
        """The braking moment over the speed, with the driving one."""
        speed = np.linspace(0.0, float(self.found.omega[-1]), 121)
        moment = self.s.number("M")
        curves = [
            Curve(
                self.found.shoes.moment(speed),
                str(self.t(N_("braking"))),
                extremes=[(self.s.number("held"), moment)],
            ),
            Curve(np.full_like(speed, moment), str(self.t(N_("driving"))), extremes=()),
        ]
        along, of = self.places["omega"].quantity, self.places["M_b"].quantity
        return plot(curves, speed, along, [(of.sign, of.printed)], self.page.tr)

    @cached_property
    def start(self) -> Graph:
        speed = self.of("start", "omega")
        return chart([Line(speed)], self.of("start", "t"), [speed.quantity], self.page.tr)

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The shoes of the centrifugal brake touch the drum at %(contact)s rpm; against the driving moment the "
            "brake holds %(held)s rpm."
        )
        return [self.t(text, contact=self.number("contact", "rpm"), held=self.number("held", "rpm"))]
