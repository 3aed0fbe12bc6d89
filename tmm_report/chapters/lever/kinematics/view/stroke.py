"""View of a driving slider or cylinder: its stroke, and how a link follows it by a triangle, or as the position
function of the mechanism reversed."""

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
from tmm_report.mechanics.lever.driving.reversed import Reversed
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.quantity.formula import Expr, Formula, Var, arccos, cos, sin, sqrt
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric


class StrokeView(DrivingView):
    def __init__(self, found: Kinematics, position: int, page: Page):
        super().__init__(found, position, page)
        stroke = found.stroke
        assert stroke is not None
        self.stroke = stroke

    @property
    def by(self) -> str:
        """The links that drive."""
        return ", ".join(self.stroke.by)

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

    def motion(self, caption: Any) -> Table:
        """Time, stroke with its rates, angle and rates of the link at the table positions."""
        columns = [
            self.column("outputs_table", TIME.key),
            *self.columns("stroke_table", (q.PLACE.key, q.SPEED.key, q.ACCELERATION.key)),
            self.column("outputs_table", LAW_ANGLE),
            *(self.column("rates_table", key) for key in self.rates),
        ]
        return numeric(caption, self.page.positions(self.table("outputs_table")), columns)

    def strokes(self) -> Graph:
        keys = (q.PLACE.key, q.SPEED.key, q.ACCELERATION.key)
        return self.both_sides("stroke_diagram", {key: self._of_law(n) for n, key in enumerate(keys)})

    def _of_law(self, order: int) -> Of:
        """The stroke or one of its derivatives by the time, of the motion."""
        return lambda motion: self.stroke.law.of_phase(motion.phase)[order]

    def conclusions(self) -> list[Markup]:
        return []


class TriangleView(StrokeView):
    def __init__(self, found: Kinematics, position: int, page: Page):
        super().__init__(found, position, page)
        assert isinstance(self.stroke, Triangle)
        self.side = self.stroke.side
        self.pivot, self.pin, self.far = self.stroke.names

    @property
    def axes(self) -> bool:
        """Whether the link's axis is not its arm."""
        return self.knows(q.LAG.key)

    def triangle(self) -> Iterator[Formula]:
        """Of the position: the angle of the triangle, the angle of the arm and that of the link."""
        table, k = self.table("stroke_table"), self.position
        arm, base = self.value("stroke_arm").var(), self._var("stroke_base")
        other = self.value("stroke_rod").var() if self.stroke.slides else self._var("stroke")
        yield table.formula("stroke_beta", k, arccos((arm**2 + base**2 - other**2) / (2 * arm * base)), "deg")
        alpha, beta = self._var("stroke_alpha"), self._var("stroke_beta")
        yield table.formula("stroke_phi", k, alpha + beta if self.side > 0 else alpha - beta, "deg")
        if self.axes:
            phi = self._var("stroke_phi") - self.value("stroke_lag").var("deg")
            yield self.table("outputs_table").formula(LAW_ANGLE, k, phi, "deg")

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

    def parts_of(self, caption: Any) -> Table:
        """The triangle at the table positions."""
        keys = ("stroke_base", "stroke_alpha", "stroke_beta", "stroke_phi", "stroke_psi")
        return self.by_positions(caption, "stroke_table", keys)


class ReversedView(StrokeView):
    def __init__(self, found: Kinematics, position: int, page: Page):
        super().__init__(found, position, page)
        assert isinstance(self.stroke, Reversed)
        self.start, self.end = self.stroke.ends[0], self.stroke.ends[-1]
        self.vector = [quantity.key for quantity in q.vector(self.stroke)]

    def root(self) -> Markup:
        """φ of the link at the position."""
        var = self.table("outputs_table").var(LAW_ANGLE, self.position)
        return self.page.value(var)

    def reached(self) -> Formula:
        """The stroke at the position by the places, which the reversed function has met."""
        return self._of_stroke(q.PLACE.key, self._along(0) if self.stroke.slides else self._length())

    def slopes(self) -> list[Formula]:
        """s′ and s″ at the position."""
        if self.stroke.slides:
            return [
                self._of_stroke("stroke_s1", self._along(1)),
                self._of_stroke("stroke_s2", self._along(2)),
            ]
        s, first = self._var(q.PLACE.key), self._var("stroke_s1")
        x, y, dx, dy, ddx, ddy = (self._var(key) for key in self.vector)
        return [
            self._of_stroke("stroke_s1", (x * dx + y * dy) / s),
            self._of_stroke("stroke_s2", (dx**2 + dy**2 + x * ddx + y * ddy - first**2) / s),
        ]

    def rates_of(self) -> list[Formula]:
        """Angular velocity and acceleration of the link at the position."""
        rates, k = self.table("rates_table"), self.position
        omega, epsilon = self.rates
        first, second = self._var("stroke_s1"), self._var("stroke_s2")
        v, a = self._var(q.SPEED.key), self._var(q.ACCELERATION.key)
        return [
            rates.formula(omega, k, v / first),
            rates.formula(epsilon, k, (a - second * rates.var(omega, k) ** 2) / first),
        ]

    def _of_stroke(self, key: str, body: Expr) -> Formula:
        return self.table("stroke_table").formula(key, self.position, body)

    def _length(self) -> Expr:
        x, y = (self._var(key) for key in self.vector[:2])
        return sqrt(x**2 + y**2)

    def _along(self, order: int) -> Expr:
        """The part of d, or of a derivative of it, along the guide."""
        x, y = (self._var(key) for key in self.vector[2 * order : 2 * order + 2])
        gamma = self.value("stroke_gamma").var("deg")
        return x * cos(gamma) + y * sin(gamma)

    def parts_of(self, caption: Any) -> Table:
        """The vector of the stroke and its derivatives at the table positions."""
        return self.by_positions(caption, "stroke_table", (*self.vector, "stroke_s1", "stroke_s2"))
