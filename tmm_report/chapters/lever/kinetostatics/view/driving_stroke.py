"""View of a driving slider or cylinder: the balancing force along the stroke in place of a moment."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.kinematics import quantities as motion
from tmm_report.chapters.lever.kinetostatics.quantities import driving_stroke as force
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import sampled
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.figures.charts.graphs import Graph
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, cos, sin
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import Line, cycle_lines
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Part


def parts(found: Kinetostatics, position: int, page: Page) -> Iterator[Part]:
    if found.kinematics.stroke is not None:
        yield Part("lever/kinetostatics/stroke", StrokeForceView(found, position, page))


class StrokeForceView(BookView):
    def __init__(self, found: Kinetostatics, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.position = found, position
        self.motion = BookView(page, page.once(motion.book, found.kinematics))
        stroke = found.kinematics.stroke
        assert stroke is not None
        self.stroke = stroke

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The balancing force along the stroke varies from %(low)s N to %(high)s N; above zero it acts in the "
            "direction in which the stroke grows."
        )
        return [self.t(text, low=self.number("F_stroke_min"), high=self.number("F_stroke_max"))]

    @property
    def triangle(self) -> bool:
        """Whether the link follows the stroke by a triangle."""
        return isinstance(self.stroke, Triangle)

    def both(self) -> str:
        """The links on which both its ends act; none where one of them is fixed."""
        return ", ".join(one.link for one in self.stroke.takes) if len(self.stroke.takes) > 1 else ""

    def formulas(self) -> list[Formula]:
        """The analogue of the link's angular velocity by the stroke, and the force, at the sample position."""
        table, k = self.motion.table("stroke_table"), self.position
        moment = self.table("balancing_table").var("M_bal", k)
        return [
            table.formula(
                "stroke_transfer", k, self._by_triangle() if self.triangle else 1 / table.var("stroke_s1", k)
            ),
            self.table("drive_table").formula("F_stroke", k, moment * table.var("stroke_transfer", k)),
        ]

    def _by_triangle(self) -> Expr:
        table, k = self.motion.table("stroke_table"), self.position
        phi, psi = table.var("stroke_phi", k), table.var("stroke_psi", k)
        over: Expr | int = 1
        if self.stroke.slides:
            over = cos(psi - self.motion.value("stroke_gamma").var("deg"))
        return over / (self.motion.value("stroke_arm").var() * sin(psi - phi))

    def forces(self, caption: Any) -> Table:
        """The force by three ways."""
        heads = {
            force.FORCE.key: self.t("from the force analysis"),
            force.BY_LEVER.key: self.t("from the lever"),
            force.BY_POWER.key: self.t("from the power balance"),
        }
        columns = []
        for key, head in heads.items():
            column = self.column("drive_table", key)
            columns.append(column._replace(head=self.page.listed([column.head, head])))
        return self.by_positions(caption, "drive_table", columns)

    def diagram(self) -> Graph:
        found, table = self.found, self.table("drive_diagram")
        at = self.page.once(sampled, found)
        driving = None if found.over is None else found.over.statics.driving
        column = replace(table[force.FORCE.key], values=at.of(driving, found.diagram.statics.driving))
        turned = replace(table["phi"], values=np.degrees(at.turned))
        lines = [Line(column, extremes=None)]
        return cycle_lines(lines, turned, self.page.tr, found.kinematics.numbered)

    @property
    def asked(self) -> bool:
        return self.has("drive_at")

    def instants(self, caption: Any) -> Table:
        """At the instants that are asked for."""
        keys = ("t", force.FORCE.key, force.BY_LEVER.key, force.BY_POWER.key)
        return self.numeric(caption, "drive_at", keys)
