"""View of the motion of a driving link that does not turn uniformly: its law with numbers, table and diagram."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.initial_data.quantities import driving_law
from tmm_report.chapters.lever.kinematics import quantities as q
from tmm_report.chapters.lever.kinematics.solve.analogues import LAW_ANGLE, TIME
from tmm_report.chapters.lever.kinematics.solve.jumps import Of, drawn
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.figures.charts.graphs import Graph
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, Var
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import Line, cycle_lines
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, numeric


class DrivingView(BookView):
    """`position`: the one of which formulas are written out."""

    def __init__(self, found: Kinematics, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.position = found, position
        self.link = found.linkage.mechanism.driver.link
        self.rates = f"w_{self.link}", f"e_{self.link}"

    def formulas(self) -> Iterator[Formula]:
        """Angle, angular velocity and acceleration at the position, by the law; none of a table or of phases."""
        driver, k = self.found.linkage.mechanism.driver, self.position
        if driver.law is None:
            return
        stated = {value.key: value for value in driving_law.values(driver)}

        def var(key: str) -> Var:
            value = stated[key]
            return value.var("rad" if value.unit == "rad" else "")

        time = self.table("outputs_table").var(TIME.key, k)
        motion = driving_law.motion(driver.law, time, var)
        if motion is None:
            return
        yield self.table("outputs_table").formula(LAW_ANGLE, k, motion.angle, "rad")
        for key, body in zip(self.rates, motion[1:], strict=True):
            yield self.table("rates_table").formula(key, k, body)

    def motion(self, caption: Any) -> Table:
        """Time, angle, angular velocity and acceleration at the table positions."""
        columns = [
            self.column("outputs_table", TIME.key),
            self.column("outputs_table", LAW_ANGLE),
            *(self.column("rates_table", key) for key in self.rates),
        ]
        return numeric(caption, self.page.positions(self.table("outputs_table")), columns)

    def diagram(self) -> Graph:
        rates = (
            lambda motion: motion.angular_velocity(self.link),
            lambda motion: motion.angular_acceleration(self.link),
        )
        return self.both_sides("rates_diagram", dict(zip(self.rates, rates, strict=True)))

    def both_sides(self, name: str, of: Mapping[str, Of]) -> Graph:
        """Columns of a table over the cycle with both sides of every jump; `of`: by their keys what they are of the
        motion, in SI."""
        at, table = drawn(self.found, self.found.jumps), self.table(name)
        lines = [
            Line(replace(table[key], values=at.of(table[key].values, one)), panel=panel, extremes=None)
            for panel, (key, one) in enumerate(of.items())
        ]
        turned = replace(table["phi"], values=np.degrees(at.turned))
        return cycle_lines(lines, turned, self.page.tr, self.found.numbered)

    def jumps(self) -> list[Markup]:
        """Where the accelerations jump, and which side of it the positions there have."""
        found, at = self.found, self.found.jumps
        if not at.turned.size:
            return []
        angles = self.page.listed(f"{self.page.num(np.degrees(x), places=1)}°" for x in at.turned)
        text = N_(
            "The accelerations jump at θ = %(angles)s; the diagrams show both sides of a jump, one above the other."
        )
        told = [self.t(text, angles=angles)]
        positions = np.flatnonzero(at.standing(found.turned))
        if positions.size:
            text = N_(
                "Positions that stand at a jump: %(positions)s; the tables give there what is after it."
            )
            told.append(self.t(text, positions=self.page.listed(map(str, positions))))
        return told

    def conclusions(self) -> list[Markup]:
        return []
