"""View of the centrifugal brake."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.governor.draw import brake
from tmm_report.chapters.machine.governor.given import ShoeArm
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

GIVEN = ("n", "m", "rho", "gap", "R", "f", "a", "psi", "psi_m", "l_F", "c", "F_0", "M", "J", "wanted")
FOUND = (
    "l_C", "l_N", "l_T", "theta", "rho_contact", "F", "contact", "K", "held", "spread", "pressing", "power",
    "contact_time",
)  # fmt: skip
ROW = 10  # of the table, whose moment is written out


class BrakeView(ChapterView):
    def __init__(self, found: BrakeFound, page: Page):
        super().__init__(page, found.s, of_brake(found))
        self.found = found
        self.places = next(iter(of_brake(found)))

    def given_values(self) -> Markup:
        return self.listed(self._given())

    def _given(self) -> list[str]:
        return [key for key in GIVEN if self.s.get(key) and not self.s.has_formula(key)]

    def explained_given(self) -> list[dict[str, Any]]:
        return self.explained(*self._given())

    def explained_found(self) -> list[dict[str, Any]]:
        """Of what the formulas find: letters of the brake stand for other things than those of the governor."""
        chosen = [key for key in ("m", "F_0") if self.s.has_formula(key)]
        return self.explained(*chosen, *FOUND)

    @property
    def arm(self) -> ShoeArm | None:
        return self.found.given.arm

    def touching(self) -> list[Formula]:
        """Up to contact; what of the mass and the spring is chosen, among them."""
        return self.formulas(
            "l_C", "l_N", "l_T", "theta", "rho_contact", *(("F", "m") if self.s.has_formula("m") else ())
        )

    def at_contact(self) -> list[Formula]:
        """From the spring to the speed of contact, in the order in which they are found."""
        if self.s.has_formula("F_0"):
            return self.formulas("K", "F", "F_0", "contact")
        return self.formulas("contact") if self.s.has_formula("m") else self.formulas("F", "contact")

    def chosen(self) -> Markup | None:
        """What is found for the speed that is to be held; None where all is stated."""
        if self.found.given.choose is None:
            return None
        text = N_("The force of the spring at rest is found so that the brake holds %(speed)s rpm.")
        if self.s.has_formula("m"):
            text = N_("The mass of a shoe is found so that the brake holds %(speed)s rpm.")
        return self.t(text, speed=self.number("wanted", "rpm"))

    def sense(self) -> Markup:
        """What the sense of rotation does to shoes on arms, and what they would do when it turns the other way."""
        if self.arm is not None and self.arm.ahead == "shoe":
            return self.t(
                N_(
                    "The shoe goes before its pivot: the friction draws it on to the drum, so that the brake is "
                    "stronger. It would lock itself from this coefficient of friction on:"
                )
            )
        return self.t(
            N_(
                "The pivot goes before its shoe: the friction pushes the shoe off the drum, so that the brake is "
                "weaker and cannot lock itself. Turned the other way, it would lock itself from this coefficient of "
                "friction on:"
            )
        )

    def other_way(self) -> Markup:
        if "back" not in self.s:
            return self.t(
                N_("That of its shoes is not below it: the brake is for this sense of rotation alone.")
            )
        return self.t(N_("Turned the other way, the same brake holds the speed:"))

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
        return brake.brake(
            self.found, str(self.t(N_("Scheme of the centrifugal brake"))), self.page.tr.in_index
        )

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
