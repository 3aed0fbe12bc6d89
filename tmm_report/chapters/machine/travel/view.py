"""View of a machine whose main link slides."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.travel import draw
from tmm_report.chapters.machine.travel import quantities as q
from tmm_report.chapters.machine.travel.plant import SPRING, WEIGHT
from tmm_report.chapters.machine.travel.solve import Found
from tmm_report.chapters.machine.travel.values import Motion, Values
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Expr, Formula, Var, sqrt
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded
from tmm_report.report.part import Part

WAYS = {
    "angle": N_(
        "All forces depend on the place alone, so the speed follows from the energy integral, and the time from "
        "the integral of its reciprocal, taken by Gaussian quadrature."
    ),
    "speed": N_(
        "The mass is constant and the forces depend on the speed alone, so the variables part and the time and "
        "the way are integrals over the speed, taken by Gaussian quadrature."
    ),
    "time": N_(
        "The forces depend on the place and on the speed, or on the time, so the equation is integrated numerically by "
        "the method LSODA with the relative tolerance 10⁻⁹."
    ),
}
LAWS = {
    "constant": N_("constant"),
    "by_place": N_("by the place, straight lines between points"),
    "by_time": N_("by the time, straight lines between points"),
    "by_speed": N_("by the speed, straight lines between points"),
    "viscous": N_("in proportion to the speed"),
    "square": N_("in proportion to the square of the speed"),
}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/travel", TravelView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The speed over the way."""
    return draw.glance(found, page)


class TravelView(ChapterView):
    own = True
    s: Values

    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, q.tables(found))
        self.found = found
        self.row = len(self.table("motion")) // 2

    # ------------------------------------------------------------ words

    @property
    def way(self) -> Markup:
        return self.t(WAYS[self.found.motion.way])

    @property
    def waited(self) -> Markup:
        """When the main link begins to move, s."""
        return self.page.shown(self.table("motion"), "t", 0)

    @property
    def laws(self) -> list[Markup]:
        """The forces along the guide in words."""
        driving, resisting = N_("%(name)s – a driving force, %(law)s"), N_("%(name)s – a resistance, %(law)s")
        return [
            self.t(
                driving if one.drives else resisting,
                name=self.acting(f"force{k}"),
                law=self.t(LAWS[one.kind]),
            )
            for k, one in enumerate(self.found.given.forces, 1)
        ]

    def acting(self, key: str) -> Markup:
        """What acts, in words."""
        given = self.found.given
        for load, _ in self.found.whole.loads:
            if load.key == key:
                return self.page.message(load.meaning)
        fixed = {
            WEIGHT: N_("weight of the main link"),
            "sum": N_("sum"),
            "gained": N_("change of the kinetic energy"),
        }
        if key in fixed:
            return self.t(fixed[key])
        index = int(key.lstrip("abcdefghijklmnopqrstuvwxyz"))
        if key.startswith(SPRING):
            name = given.springs[index - 1].name
            return (
                self.t(N_("spring: %(name)s"), name=name)
                if name
                else self.t(N_("spring %(number)s"), number=index)
            )
        name = given.forces[index - 1].name
        return self.page.text(name) if name else self.t(N_("force %(number)s"), number=index)

    # ------------------------------------------------------------ the equation of motion

    def _over(self, key: str) -> Var:
        """A quantity over the motion; a constant mass as the single number."""
        table = self.table("motion_diagram")
        declared = Motion.DECLARED[key].quantity
        if key in table:
            return Var(declared.sign, table[key].numbers())
        return Var(declared.sign, self.s.number("m_red"))

    def _acting(self, of: Any) -> Expr:
        """F_dr + F_red − F_res of what there is."""
        table = self.table("motion")
        there = [of(key) for key in ("F_dr", "F_red") if key in table]
        if not there:
            return -of("F_res")
        total: Expr = there[0] if len(there) < 2 else there[0] + there[1]
        return total - of("F_res") if "F_res" in table else total

    @property
    def forced(self) -> bool:
        """Whether any force acts."""
        return any(key in self.table("motion") for key in ("F_dr", "F_red", "F_res"))

    def equation(self) -> Equation:
        """m a + m′ v²/2 − F = 0."""
        left: Expr = self._over("m_red") * self._over("a")
        if not self.found.constant_mass:
            left = left + self._over("m_red_slope") * self._over("v") ** 2 / 2
        return Equation(left - self._over("F"), numbers=False)

    def rotational(self) -> Equation:
        """I ε + I′ ω²/2 − M = 0, of the link that follows the stroke."""
        link = [
            Var(Symbol(base, sub), np.nan) for base, sub in (("I", "red"), ("epsilon", ""), ("I'", "red"))
        ]
        omega, moment = Var(Symbol("omega"), np.nan), Var(Symbol("M", "red"), np.nan)
        return Equation(link[0] * link[1] + link[2] * omega**2 / 2 - moment, numbers=False)

    def energy(self) -> Definition:
        """T = T0 + A."""
        return Definition("T", Var("T_0", np.nan) + self._over("A"))

    # ------------------------------------------------------------ the middle row of the table

    def _at(self, key: str) -> Expr:
        table = self.table("motion")
        return table.var(key, self.row) if key in table else self.s.m_red

    def sample(self) -> list[Formula]:
        """The sum of the forces, the speed by the energy, the acceleration by the equation of motion."""
        table, k = self.table("motion"), self.row
        found = [table.formula("F", k, self._acting(self._at))] if self.forced else []
        energy = 2 * self._at("A")
        if self.s.number("v_begin"):
            energy = (
                self.s.m_red if self.found.constant_mass else self.s.m_begin
            ) * self.s.v_begin**2 + energy
        found.append(table.formula("v", k, sqrt(energy / self._at("m_red"))))
        force = self._at("F")
        if not self.found.constant_mass:
            force = force - self._at("m_red_slope") * self._at("v") ** 2 / 2
        found.append(table.formula("a", k, force / self._at("m_red")))
        return found

    def reduced(self) -> list[Formula]:
        """Of the link that follows the stroke its moment of inertia, which has the same energy."""
        table, k = self.table("motion"), self.row
        return [table.formula("I_red", k, table.var("m_red", k) * (self._at("v") / self._at("omega")) ** 2)]

    # ------------------------------------------------------------ tables and diagrams

    def wheels(self, caption: Any) -> Table:
        return self._named(caption, "wheels", "wheel", self.t("Wheel"))

    def springs(self, caption: Any) -> Table:
        return self._named(caption, "springs", "spring", self.t("Spring"))

    def _named(self, caption: Any, name: str, first: str, head: Any) -> Table:
        table, page = self.table(name), self.page
        keys = [column.key for column in table.columns if column.key != first]
        heads = [head, *(page.head(table[key].symbol(), table[key].unit) for key in keys)]
        rows = [
            [page.word(text or str(k + 1), table, first, k), *(page.cell(table, key, k) for key in keys)]
            for k, text in enumerate(table[first].values)
        ]
        return worded(caption, heads, rows, (6, *(2 for _ in keys)))

    def motion(self, caption: Any) -> Table:
        return self.numeric(caption, "motion")

    def works(self, caption: Any) -> Table:
        table, page = self.table("works"), self.page
        largest = max(abs(one) for one in table["A"].values) or 1.0
        rows: list[list[Markup | Cell]] = [
            [page.word(self.acting(key), table, "acting", k), page.cell(table, "A", k, scale=largest)]
            for k, key in enumerate(table["acting"].values)
        ]
        return worded(caption, [self.t("What acts"), page.head(table["A"].symbol(), "J")], rows, (5, 2))

    def over_way(self) -> Graph:
        return draw.over_way(self.found, self.page)

    def over_time(self) -> Graph:
        return draw.over_time(self.found, self.page)

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        text = N_("The main link covers its path in %(t)s s and has the speed %(v)s m/s at its end.")
        if self.found.stops:
            text = N_("The main link stops after %(x)s m, in %(t)s s; its greatest speed is %(most)s m/s.")
        names = {"t": "t_end", "v": "v_end", "x": "way", "most": "v_max"}
        values = {name: self.number(key) for name, key in names.items() if f"%({name})s" in text}
        return [self.t(text, **values)]
