"""View of the reduction of masses and forces to the driving link."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.initial_data import quantities as initial
from tmm_report.chapters.lever.kinematics import quantities as rates
from tmm_report.chapters.lever.kinematics.solve.positions import stands
from tmm_report.chapters.lever.kinetostatics.quantities import positions as statics
from tmm_report.chapters.lever.reduction import quantities as q
from tmm_report.chapters.lever.reduction.solve import Reduction
from tmm_report.figures.charts.graphs import Graph
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.formula import Expr, Formula
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import Line, points
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Part

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.reduction is not None:
        yield Part("lever/reduction", ReductionView(lever.reduction, lever.sample, page))


def _moving(found: Reduction, position: int) -> int:
    """The position, or of a law by which the driving link stands still there the first in which it does not."""
    if not found.kinematics.by_law:
        return position
    still = stands(found.kinematics.table)
    return int(np.argmin(still)) if still[position] else position


class ReductionView(BookView):
    kinds_once = True

    def __init__(self, found: Reduction, position: int, page: Page):
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found, self.position = found, _moving(found, position)
        self.mechanism = found.kinematics.linkage.mechanism

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The reduced moment of inertia varies from %(low)s kg·m² to %(high)s kg·m² over the cycle of the mechanism."
        )
        if self.found.kinematics.limited:
            text = N_(
                "The reduced moment of inertia grows without bound towards the limit position, so that no extremes of "
                "it are given."
            )
            return [self.t(text)]
        return [self.t(text, low=self.number("I_red_min"), high=self.number("I_red_max"))]

    @property
    def driver(self) -> str:
        return self.mechanism.driver.link

    # ------------------------------------------------------------ the sample position

    def inertia(self) -> Formula:
        """The reduced moment of inertia, link by link."""
        total, *others = self._terms()
        for term in others:
            total = total + term
        return self.table("reduced_inertia_table").formula("I_red", self.position, total)

    def _terms(self) -> Iterator[Expr]:
        masses = self._given.tables["masses"]
        return rates.kinetic(
            self.found.kinematics, self.mechanism.links, masses, self._rates, self._omega, self.position
        )

    @cached_property
    def _given(self) -> Book:
        return Book.of(initial.given_tables(self.mechanism), [initial.speed(self.mechanism)])

    @property
    def _rates(self) -> model.Table:
        return self.page.once(rates.book, self.found.kinematics).tables["rates_table"]

    @property
    def _omega(self) -> Expr:
        if self.by_law:
            return self._rates.var(rates.link_rate("w", self.driver).key, self.position, size=True)
        return self._given["omega"].var(size=True)

    @property
    def by_law(self) -> bool:
        return self.found.kinematics.by_law

    def motion(self) -> Formula:
        """Of a law the balancing moment by the equation of motion, I ε + ω² I'/2 − M."""
        k, inertias, forces = self.position, self.table("reduced_inertia_table"), self.found.forces
        assert forces is not None
        omega, epsilon = (self._rates.var(rates.link_rate(letter, self.driver).key, k) for letter in "we")
        moved = inertias.var("I_red", k) * epsilon + omega**2 * inertias.var("I_red_slope", k) / 2
        table = self.page.once(statics.book, forces).tables["balancing_table"]
        return table.formula("M_bal", k, moved - self.table("reduced_moment_table").var("M_red", k))

    # ------------------------------------------------------------ tables and diagrams

    def inertias(self, caption: Any) -> Table:
        return self.by_positions(caption, "reduced_inertia_table")

    def moments(self, caption: Any) -> Table:
        return self.by_positions(caption, "reduced_moment_table")

    def by_plans(self, caption: Any) -> Table:
        name = "reduction_plans"
        keys = [
            one.key for one in self.table(name).columns if one.key not in ("position", "phi", q.DELTA.key)
        ]
        return self.by_positions(
            caption, name, [*keys, self.page.singles(self.table(name), q.DELTA.key, places=2)]
        )

    @cached_property
    def diagram(self) -> Graph:
        name = "reduced_inertia_diagram"
        lines = [Line(self.of(name, "I_red"), extremes=points(self.found.extremes))]
        if self.found.forces is not None:
            lines.append(Line(self.of("reduced_moment_diagram", "M_red"), panel=1, extremes=None))
        return self.over_cycle(name, lines, self.found.kinematics.numbered)

    # ------------------------------------------------------------ check

    def disagreement(self) -> Markup:
        return self.bound("reduction_disagreement")
