"""View of a synthesis."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.synthesis import equations
from tmm_report.chapters.lever.synthesis.draw import scale, scheme
from tmm_report.chapters.lever.synthesis.given import AnglePairs, Generator
from tmm_report.chapters.lever.synthesis.quantities import tables
from tmm_report.chapters.lever.synthesis.solve import Found
from tmm_report.chapters.lever.synthesis.values import LENGTHS
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import Equation
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import Line, chart, letter, scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, worded
from tmm_report.report.part import Failed, Part

STATED = (
    "stroke", "mean_speed", "working_speed", "speed", "K", "theta", "swing", "ratio", "offset_ratio", "offset",
    "rod_ratio", "crank", "rod", "rocker", "frame", "permitted", "mu_permitted", "crank_from", "crank_turn",
    "rocker_from", "rocker_turn", "point_x", "point_y",
    "psi_1", "psi_2", "phi_1", "phi_2", "x_1", "x_2",
)  # fmt: skip


FREE = ("ratio", "crank", "frame", "rocker", "offset")  # what may be left free


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("lever/synthesis", SynthesisView(found, page))


def picture(found: Found, page: Page) -> Drawing:
    """The linkage at a glance, for a list of many."""
    return scheme(found.design, "")


class SynthesisView(ChapterView):
    own = True

    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, tables(found))
        self.found, self.asked = found, found.given.asked
        self.kind = "pairs" if isinstance(self.asked, AnglePairs) else found.given.kind

    def given_values(self) -> Markup:
        """What is asked, as it is stated."""
        stated = [key for key in STATED if key in self.s and not self.s.has_formula(key)]
        free = {key for key in FREE if getattr(self.asked, key, None) is None}
        # in line there is no offset, and what was chosen was not asked
        nought = {"offset"} if not self.s.get("offset") else set()
        return self.listed(key for key in stated if key not in free | nought)

    def all_formulas(self) -> list[Formula]:
        """In the order in which they are computed."""
        return [self.formula(key) for key in self.s.computed()]

    def sign(self, key: str) -> Symbol:
        return self.s.named(key).sign

    # ------------------------------------------------------------ a function

    def wanted(self) -> Definition:
        assert isinstance(self.asked, Generator)
        return equations.function(self.asked.y, self.table("pairs")["x"].values)

    def freudenstein(self) -> Equation:
        return equations.freudenstein(self.found.s)

    @property
    def free(self) -> str:
        """What was left free, and is chosen."""
        for key in ("off_B", *FREE):
            left = key in self.s and getattr(self.asked, key, None) is None
            if self.has("family") and left and not self.s.has_formula(key):
                return key
        return ""

    # ------------------------------------------------------------ pictures

    @cached_property
    def scheme(self) -> Drawing:
        return scheme(self.found.design, str(self.t(N_("The linkage that is found"))))

    def scale(self) -> Markup:
        return self.page.value(scale_of("mu_l", scale(self.found.design), "m/mm"))

    def family(self) -> Graph:
        """The angle and the lengths over what is free."""
        first, angle, *lengths = self.table("family").columns
        lines = [Line(angle, panel=0)]
        lines += [Line(one, letter(one.quantity.sign, self.page.tr), 1) for one in lengths]
        return chart(lines, first, [angle.quantity, lengths[0].quantity], self.page.tr)

    def course(self) -> Graph:
        x, *others = self.table("course").columns
        lines = [Line(one, panel=k) for k, one in enumerate(others)]
        return chart(lines, x, [one.quantity for one in others], self.page.tr)

    # ------------------------------------------------------------ tables

    def pairs(self, caption: Any) -> Table:
        return self.numeric(caption, "pairs")

    def poses(self, caption: Any) -> Table:
        return self.numeric(caption, "poses")

    @property
    def two(self) -> bool:
        """Whether a body is led from one position to another."""
        return bool(self.found.design.solutions)

    @property
    def extreme(self) -> bool:
        """Whether the two positions of a rocker or a slider are its extreme ones."""
        return getattr(self.asked, "crank_angles", None) is None

    def made(self) -> Markup:
        """What kind of four-bar linkage the lengths make."""
        a, b, c, d = (self.s.number(key) for key in ("crank", "rod", "rocker", "frame"))
        sides = sorted((a, b, c, d))
        shortest = sides[0] + sides[3] <= sides[1] + sides[2]
        text = N_("The linkage is a double rocker: neither of its pivoted links turns round.")
        if shortest and sides[0] == a:
            text = N_("The linkage is a crank-rocker: its crank turns round.")
        elif shortest and sides[0] == d:
            text = N_("The linkage is a double crank: both of its pivoted links turn round.")
        elif shortest and sides[0] == c:
            text = N_("The linkage is a crank-rocker whose driven link turns round, the driving one swings.")
        return self.t(text)

    @property
    def misfits(self) -> bool:
        return "misfit" in self.s

    def solutions(self, caption: Any) -> Table:
        return self.numeric(caption, "solutions")

    def arc(self, caption: Any) -> Table:
        return self.numeric(caption, "arc")

    def lengths(self, caption: Any) -> Table:
        """As found and as taken."""
        table, page = self.table("lengths"), self.page
        keys = table["key"].values
        heads = [self.t(N_("Length")), self.t(N_("as it is found, mm")), self.t(N_("as it is taken, mm"))]
        rows = [
            [page.sym(self.sign(key)), *(page.cell(table, one, row, "mm") for one in ("found", "taken"))]
            for row, key in enumerate(keys)
        ]
        return worded(caption, heads, rows, (2, 3, 3))

    def _taken(self, keys: list[str]) -> Markup:
        """As the mechanism has them."""
        if not self.has("lengths"):
            return self.listed(keys)
        table = self.table("lengths")
        rows = [list(table["key"].values).index(key) for key in keys]
        return self.page.listed([self.page.value(table.var("taken", row, "mm")) for row in rows])

    def rounded(self) -> list[Markup]:
        """What the rounded lengths make of the demand, each beside what was found."""
        keys = ("stroke", "swing", "K", "pressure", "transmission", "error")
        text = N_("%(found)s becomes %(taken)s")
        lines = [
            self.t(text, found=self.sized(key), taken=self.sized(f"{key}_taken"))
            for key in keys
            if f"{key}_taken" in self.s and key in self.s
        ]
        return [self.page.listed(lines)] if lines else []

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        sizes = [key for key in LENGTHS if self.s.get(key)]
        lines = [self.t(N_("The synthesis gives the linkage %(lengths)s."), lengths=self._taken(sizes))]
        for key in ("stroke", "swing", "K", "pressure", "transmission"):
            if f"{key}_met" in self.s and key in self.s:
                text = N_("%(asked)s was asked, the analysed mechanism has %(met)s.")
                if key in ("pressure", "transmission"):
                    text = N_("%(asked)s follows from the lengths, the analysed mechanism has %(met)s.")
                lines.append(self.t(text, asked=self.sized(key), met=self.sized(f"{key}_met")))
        if "mu_permitted" in self.s:
            good = N_("The least transmission angle, %(least)s, is not less than the permitted %(most)s.")
            bad = N_("The least transmission angle, %(least)s, is less than the permitted %(most)s.")
            # one that is reached may fall short by rounding
            fails = self.s.number("transmission") < self.s.number("mu_permitted") * (1 - 1e-9)
            least, most = self.measured("transmission", digits=4), self.measured("mu_permitted")
            said = self.t(bad if fails else good, least=least, most=most)
            lines.append(Failed(said) if fails else said)
        return lines
