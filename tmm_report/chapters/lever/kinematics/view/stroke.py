"""View of a driving slider or cylinder: its stroke, and how a link follows it by a triangle."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.initial_data.quantities import driving_stroke
from tmm_report.chapters.lever.kinematics import stroke as q
from tmm_report.chapters.lever.kinematics.solve.analogues import LAW_ANGLE, TIME
from tmm_report.chapters.lever.kinematics.solve.jumps import Of
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinematics.view.driving import DrivingView
from tmm_report.figures.charts.graphs import Graph
from tmm_report.quantity.formula import Expr, Formula, Var, arccos, cos, sin
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric


class StrokeView(DrivingView):
    def __init__(self, found: Kinematics, position: int, page: Page):
        super().__init__(found, position, page)
        stroke = found.stroke
        assert stroke is not None
        self.stroke = stroke
        self.pivot, self.pin, self.far = stroke.names

    @property
    def by(self) -> str:
        """The links that drive."""
        return ", ".join(self.stroke.by)

    @property
    def axes(self) -> bool:
        """Whether the link's axis is not its arm."""
        return self.knows(q.LAG.key)

    def _var(self, key: str) -> Var:
        return self.table("stroke_table").var(key, self.position)

    def law(self) -> list[Formula]:
        """The stroke, its speed and acceleration at the position; none of what is no one formula."""
        stated = {value.key: value for value in driving_stroke.values(self.stroke.law)}

        def var(key: str) -> Var:
            value = stated[key]
            return value.var("rad" if value.unit == "rad" else "")

        time = self.table("outputs_table").var(TIME.key, self.position)
        found = driving_stroke.motion(self.stroke.law, time, var)
        keys = (q.PLACE.key, q.SPEED.key, q.ACCELERATION.key)
        table = self.table("stroke_table")
        return [table.formula(key, self.position, one) for key, one in zip(keys, found or (), strict=False)]

    def triangle(self) -> Iterator[Formula]:
        """Of the position: the angle of the triangle, the angle of the arm and that of the link."""
        table, k = self.table("stroke_table"), self.position
        arm, base = self.value("stroke_arm").var(), self._var("stroke_base")
        other = self.value("stroke_rod").var() if self.stroke.slides else self._var("stroke")
        yield table.formula("stroke_beta", k, arccos((arm**2 + base**2 - other**2) / (2 * arm * base)), "deg")
        alpha, beta = self._var("stroke_alpha"), self._var("stroke_beta")
        yield table.formula("stroke_phi", k, alpha + beta if self.stroke.side > 0 else alpha - beta, "deg")
        if self.axes:
            phi = self._var("stroke_phi") - self.value("stroke_lag").var("deg")
            yield self.table("outputs_table").formula(LAW_ANGLE.key, k, phi, "deg")

    def rates_of(self) -> Iterator[Formula]:
        """Angular velocity and acceleration of the link at the position, by projections on the rod or cylinder."""
        rates, k = self.table("rates_table"), self.position
        arm, speed, acceleration = (
            self.value("stroke_arm").var(),
            self._var("stroke_v"),
            self._var("stroke_a"),
        )
        phi, psi, turning = self._var("stroke_phi"), self._var("stroke_psi"), self._var("stroke_omega")
        v: Expr = speed
        a: Expr = acceleration - self._var("stroke") * turning**2
        if self.stroke.slides:
            lean = cos(psi - self.value("stroke_gamma").var("deg"))
            v, a = speed * lean, acceleration * lean + self.value("stroke_rod").var() * turning**2
        under = arm * sin(psi - phi)
        omega, epsilon = self.rates
        yield rates.formula(omega, k, v / under)
        own = rates.var(omega, k)
        yield rates.formula(epsilon, k, (a + own**2 * arm * cos(psi - phi)) / under)

    def motion(self, caption: Any) -> Table:
        """Time, stroke with its rates, angle and rates of the link at the table positions."""
        columns = [
            self.column("outputs_table", TIME.key),
            *self.columns("stroke_table", (q.PLACE.key, q.SPEED.key, q.ACCELERATION.key)),
            self.column("outputs_table", LAW_ANGLE.key),
            *(self.column("rates_table", key) for key in self.rates),
        ]
        return numeric(caption, self.page.positions(self.table("outputs_table")), columns)

    def parts_of(self, caption: Any) -> Table:
        """The triangle at the table positions."""
        keys = ("stroke_base", "stroke_alpha", "stroke_beta", "stroke_phi", "stroke_psi")
        return self.by_positions(caption, "stroke_table", keys)

    def strokes(self) -> Graph:
        keys = (q.PLACE.key, q.SPEED.key, q.ACCELERATION.key)
        return self.both_sides("stroke_diagram", {key: self._of_law(n) for n, key in enumerate(keys)})

    def _of_law(self, order: int) -> Of:
        """The stroke or one of its derivatives by the time, of the motion."""
        return lambda motion: self.stroke.law.of_phase(motion.phase)[order]

    def conclusions(self) -> list[Markup]:
        return []
