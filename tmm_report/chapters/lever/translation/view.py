"""View of the reduction of masses and forces to a link that slides."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.initial_data import quantities as initial
from tmm_report.chapters.lever.kinematics import quantities as rates
from tmm_report.chapters.lever.kinetostatics.quantities import driving_stroke
from tmm_report.chapters.lever.kinetostatics.quantities import positions as statics
from tmm_report.chapters.lever.reduction import quantities as reduction
from tmm_report.chapters.lever.reduction.solve import Reduction
from tmm_report.chapters.lever.translation import quantities as q
from tmm_report.chapters.lever.translation.solve import Found
from tmm_report.figures.charts.graphs import Graph
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.vector_equations import moving_points, turning_links
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.formula import Expr, Formula, Var
from tmm_report.quantity.model import Book
from tmm_report.quantity.written import Equation
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import Line, points
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table
from tmm_report.report.part import Part

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.translation is not None:
        yield Part(
            "lever/translation", TranslationView(lever.translation, lever.reduction, lever.sample, page)
        )


class TranslationView(BookView):
    """`turning`: the reduction to the driving link, None where a stroke drives."""

    def __init__(self, found: Found, turning: Reduction | None, position: int, page: Page):
        super().__init__(page, page.once(q.book, found))
        self.found, self.turning = found, turning
        self.mechanism = found.kinematics.linkage.mechanism
        self.position = self._moving(position)

    def _moving(self, position: int) -> int:
        """The sample position, or where the link stands still in it that of the greatest speed."""
        v, mass = np.abs(self.found.table.v), self.found.table.whole_mass
        fast = np.isfinite(mass) & (v > 0.05 * np.nanmax(v, initial=0.0))
        return position if fast[position] else int(np.nanargmax(np.where(np.isfinite(mass), v, np.nan)))

    @property
    def carried(self) -> bool:
        """Whether the guide moves."""
        return self.found.guide is not None and self.found.guide.link != FRAME

    @property
    def still(self) -> str:
        return ", ".join(str(k) for k in self.found.still)

    def conclusions(self) -> list[Markup]:
        if self.knows("m_red_max"):
            text = N_("The reduced mass varies from %(low)s kg to %(high)s kg over the stroke.")
            return [self.t(text, low=self.number("m_red_min"), high=self.number("m_red_max"))]
        text = N_(
            "The mass reduced to link %(link)s is not less than %(low)s kg; towards the positions in which the link "
            "stands still it grows without bound."
        )
        return [self.t(text, link=self.found.link, low=self.number("m_red_min"))]

    # ------------------------------------------------------------ the sample position

    def _at(self, table: str, key: str, size: bool = False) -> Var:
        return self.table(table).var(key, self.position, size=size)

    @property
    def _v(self) -> Var:
        return self._at("reduced_mass_table", "v", size=True)

    def mass(self) -> Formula:
        """The reduced mass, link by link."""
        first, *others = self._terms()
        return self.table("reduced_mass_table").formula("m_red", self.position, sum(others, first))

    def _terms(self) -> Iterator[Expr]:
        """m (v_S/v)² and J (ω/v)² of every link that moves so."""
        linkage = self.found.kinematics.linkage
        masses = Book.of(initial.given_tables(self.mechanism)).tables["masses"]
        turning, moving = turning_links(linkage), moving_points(linkage)
        for row, link in enumerate(initial.heavy_links(self.mechanism)):
            if link.mass and link.mass_centre in moving:
                speed = self._rate(rates.point_rate("v", str(link.mass_centre)).key)
                yield masses.var("m", row) * (speed / self._v) ** 2
            if link.inertia and link.name in turning:
                yield masses.var("J", row) * (self._turning(link.name) / self._v) ** 2

    def _rate(self, key: str) -> Var:
        table: model.Table = self.page.once(rates.book, self.found.kinematics).tables["rates_table"]
        return table.var(key, self.position, size=True)

    def _turning(self, link: str) -> Var:
        """Of a driving link that turns uniformly the speed that is given."""
        if link == self.mechanism.driver.link and not self.found.kinematics.by_law:
            return initial.speed(self.mechanism).var(size=True)
        return self._rate(rates.link_rate("w", link).key)

    def force(self) -> Formula | None:
        """The reduced force as the sum of its parts; None of one alone."""
        keys = [one.key for one in self.table("reduced_force_table").columns if one.key.startswith("F_red_")]
        if len(keys) < 2:
            return None
        first, *others = (self._at("reduced_force_table", key) for key in keys)
        return self.table("reduced_force_table").formula("F_red", self.position, sum(others, first))

    def needed(self) -> Formula:
        """The driving force by the equation of motion."""
        m, slope = self._at("reduced_mass_table", "m_red"), self._at("reduced_mass_table", "m_red_slope")
        v, a = self._at("reduced_mass_table", "v"), self._at("reduced_mass_table", "a")
        total = m * a + slope * v**2 / 2
        if self.loaded:
            total = total - self._at("reduced_force_table", "F_red")
        return self.table("reduced_force_table").formula("F_dr", self.position, total)

    @property
    def loaded(self) -> bool:
        return "F_red" in self.table("reduced_force_table")

    def by_moment(self) -> Formula | None:
        """The same force from the balancing moment of the force analysis, by powers; None where a stroke drives or
        there are no loads."""
        if self.found.forces is None or self.found.kinematics.by_law:
            return None
        moment = self.page.once(statics.book, self.found.forces).tables["balancing_table"]
        omega = initial.speed(self.mechanism).var()
        expression = moment.var("M_bal", self.position) * omega / self._at("reduced_mass_table", "v")
        return self.table("reduced_force_table").formula("F_dr", self.position, expression)

    def by_angle(self) -> Formula | None:
        """The balancing moment by the equation of motion in the angle of the driving link, which turns uniformly."""
        if self.found.forces is None or self.turning is None:
            return None
        tables = {one.name: one for one in reduction.tables(self.turning)}
        slope = tables["reduced_inertia_table"].var("I_red_slope", self.position)
        moment = tables["reduced_moment_table"].var("M_red", self.position)
        omega = initial.speed(self.mechanism).var()
        balancing = self.page.once(statics.book, self.found.forces).tables["balancing_table"]
        return balancing.formula("M_bal", self.position, slope * omega**2 / 2 - moment)

    @property
    def balancing(self) -> Markup:
        """The force along the stroke of the force analysis at the sample position."""
        assert self.found.forces is not None
        table = self.page.once(statics.book, self.found.forces).tables["drive_table"]
        return self.page.shown(table, driving_stroke.FORCE.key, self.position)

    # ------------------------------------------------------------ equations in symbols

    def _over(self, name: str, key: str) -> Var:
        column = self.of(name, key)
        return Var(column.symbol(), column.numbers())

    def equation(self) -> Equation:
        """m a + m′ v²/2 − F_dr − F_red = 0."""
        name = "reduced_mass_table"
        left = self._over(name, "m_red") * self._over(name, "a")
        left = left + self._over(name, "m_red_slope") * self._over(name, "v") ** 2 / 2
        left = left - self._over("reduced_force_table", "F_dr")
        return Equation(
            left - self._over("reduced_force_table", "F_red") if self.loaded else left, numbers=False
        )

    # ------------------------------------------------------------ tables and diagrams

    def masses(self, caption: Any) -> Table:
        return self.by_positions(caption, "reduced_mass_table")

    def forces(self, caption: Any) -> Table:
        return self.by_positions(caption, "reduced_force_table")

    @cached_property
    def diagram(self) -> Graph:
        name = "reduced_mass_diagram"
        force = "F_red" if self.loaded else "F_dr"
        low, high = points(self.found.extremes)
        cut = self.found.guide is not None  # what is greatest is where the diagram is cut off
        lines = [
            Line(self.of(name, "m_red"), extremes=[low] if cut else [low, high]),
            Line(self.of("reduced_force_diagram", force), panel=1, extremes=[] if cut else None),
        ]
        return self.over_cycle(name, lines, self.found.kinematics.numbered)

    # ------------------------------------------------------------ check

    def disagreement(self) -> Markup:
        return self.bound("translation_disagreement")
