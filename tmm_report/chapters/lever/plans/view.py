"""View of the plans of velocities and accelerations."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.initial_data.quantities import MU_L
from tmm_report.chapters.lever.kinematics.solve.strokes import translating
from tmm_report.chapters.lever.plans import quantities as q
from tmm_report.chapters.lever.plans.drafting import LegLine, Plan, Projections, Sense, Special
from tmm_report.chapters.lever.plans.draw import plan_picture
from tmm_report.chapters.lever.plans.scales import Choice
from tmm_report.chapters.lever.plans.solve import LIMIT, Drawn
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.schemes.scheme import reduced
from tmm_report.mechanics.lever.motion import Linkage
from tmm_report.mechanics.lever.vector_equations import relations
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula, Number, Var
from tmm_report.quantity.model import Book
from tmm_report.quantity.paper import read_places
from tmm_report.quantity.symbols import Symbol, segment
from tmm_report.quantity.terms.kinds import Kinds
from tmm_report.quantity.text import short_and_full
from tmm_report.quantity.written import DIGITS
from tmm_report.report.chapter_view import BookView
from tmm_report.report.comparison import comparison_table, side_by_side
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded
from tmm_report.report.part import Part
from tmm_report.report.words import group_name

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

_GRAPH, _ANALYTIC = Var("x_gr", 0.0), Var("x_an", 0.0)
DIFFERENCE = Definition("delta", (_GRAPH - _ANALYTIC) / (Number(0.5) * (_GRAPH + _ANALYTIC)) * Number(100))

SHARED = (80.0, 80.0)  # mm: of two plans side by side
SENSE = {1: N_("counter-clockwise ↺"), -1: N_("clockwise ↻"), 0: N_("the vector is zero")}


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    yield Part("lever/plans", PlansView(lever, page))


class PlansView(BookView):
    difference = DIFFERENCE
    group = staticmethod(group_name)

    def __init__(self, lever: LeverFound, page: Page):
        found, sample = lever.plans, lever.sample
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found, self.named, self.readings = found, found.named, lever.readings
        self.still = translating(lever.kinematics.diagram)
        self.nought = set(_rates_of(self.still, lever.kinematics.linkage))
        drawn = [one.position for one in found.drawn]
        self.first = sample if sample in drawn else next(iter(drawn), 0)  # the one that is explained in full
        ranked = sorted(drawn, key=lambda k: k != self.first)
        self.worked = ranked[: page.note.plans or 1]  # positions whose plans always stand in the text
        self.kinds_once, self.kinds = not page.note.every, Kinds(page.note.every, page.leaves_out)
        self.scale, self.picture = cache(self._scale), cache(self._picture)

    def conclusions(self) -> list[Markup]:
        if not self.found.drawn:
            return []
        within = N_(
            "The velocity and acceleration polygons differ from the analytical method by at most %(worst)s %%, "
            "which is within the allowed 5 %%."
        )
        beyond = N_(
            "The velocity and acceleration polygons differ from the analytical method by up to %(worst)s %%, "
            "which is more than the allowed 5 %%."
        )
        return [self.t(within if self.found.worst <= LIMIT else beyond, worst=self.worst())]

    @property
    def by_law(self) -> bool:
        """Whether the driving link moves by a law of the time."""
        return self.found.by_law

    def translating(self) -> list[str]:
        """Links that turn at no position of the cycle, of those whose turning the plans show."""
        return [
            link for link in self.still if any(f"w_{link}" in one.velocity.values for one in self.found.drawn)
        ]

    def in_parts(self, plan: Plan) -> bool:
        """Whether the driving link's own acceleration is drawn by its normal and tangential parts."""
        return bool(plan.strokes) and plan.strokes[0].role == "bend"

    def worst(self) -> Markup:
        return self.number("delta_max", digits=3)

    def accuracy(self) -> Markup:
        return self.number("accuracy")

    # ------------------------------------------------------------ scales

    def chosen(self) -> list[Formula]:
        """The scales that follow from segments chosen."""
        return [self._chosen(choice) for choice in self.found.choices]

    def _chosen(self, choice: Choice) -> Formula:
        value, drawn = q.chosen(choice, self.named)
        kind = choice.segment.kind
        of = (
            MU_L.value(choice.scale)
            if kind == "length"
            else self.value("mu_v" if kind == "velocity" else "mu_a")
        )
        return of.formula(value.var() / drawn.var())

    def symbols(self, projections: Projections) -> Markup:
        """The unknowns of a group's equations."""
        return self.page.listed(self.page.sym(self.named[key].sign) for key in projections.unknown)

    def leg_line(self, line: LegLine) -> Markup:
        """The line of a leg, in which the special point lies."""
        if line.ends:
            return self.t("the line %(ends)s", ends=self.page.sym(segment(line.ends)))
        return self.t(
            "the perpendicular to the guide %(guide)s at point %(point)s", guide=line.guide, point=line.at
        )

    def place(self, special: Special) -> Markup:
        """Where a special point lies in the scheme."""
        return self.page.values(special.place)

    def solved(self, plan: Plan) -> bool:
        """Whether a plan is drawn from the solution of equations, for want of a construction."""
        return any(step.projections for step in plan.steps)

    @property
    def shares(self) -> bool:
        """Whether plans are as small as two must be to stand side by side."""
        return self.page.note.stand("plans.sheets") == "omit"

    @property
    def smaller(self) -> bool:
        """Whether a plan is drawn smaller in the note than it is constructed."""
        plans = [plan for one in self.found.drawn for plan in (one.velocity, one.acceleration)]
        return any(self.scale(plan) > plan.scale for plan in plans)

    def _scale(self, plan: Plan) -> float:
        """At which it stands in the note: its own, or a coarser one where two plans are to share the page."""
        if not self.shares:
            return plan.scale
        return reduced(plan.scale, lambda mu: [plan_picture(plan, mu)], SHARED)

    def _picture(self, plan: Plan) -> Drawing:
        return plan_picture(plan, self.scale(plan))

    def picture_scale(self, plan: Plan) -> Markup:
        """mu_v or mu_a with the scale at which a plan stands in the note."""
        own = self.var(f"mu_{plan.kind}")
        mu = self.scale(plan)
        return self.page.value(own if mu == plan.scale else scale_of(f"mu_{plan.kind}", mu, own.unit))

    # ------------------------------------------------------------ tables

    def projections(self, caption: Any, plan: Plan, number: int) -> Table:
        """Coefficients of a group's unknown rates, right sides, and the solution in the last row."""
        table = self.table(q.equations_name(plan, number))
        unknown = table.columns[1:-1]
        last = len(table) - 1
        rows = [
            [
                self.page.word(contour, table, "contour", row) if row < last else self.t("Solution"),
                *(self.page.cell(table, column.key, row) for column in unknown),
                self.page.cell(table, "right", row) if row < last else "",
            ]
            for row, contour in enumerate(table["contour"].values)
        ]
        heads = [self.page.head(column.symbol(), column.unit) for column in unknown]
        heads = [self.t("Loop, axis"), *heads, self.t("Right side")]
        return worded(caption, heads, rows, [1.0] * len(heads))

    def plans_with_senses(self, drawn: Drawn) -> list[Plan]:
        return [plan for plan in (drawn.velocity, drawn.acceleration) if plan.senses]

    def senses(self, caption: Any, *plans: Plan) -> Table:
        """How the senses of the plans' angular velocities or accelerations are found, a row a link; of several plans
        the rates are named."""
        rows = []
        for plan in plans:
            table, letter = self.table(q.senses_name(plan)), "omega" if plan.kind == "v" else "epsilon"
            for row, one in enumerate(plan.senses):
                link = self.page.word(one.link, table, "link", row)
                named = [self.page.sym(Symbol(letter, one.link))] if len(plans) > 1 else []
                sense = self.page.word(self.t(SENSE[one.sense]), table, "sense", row)
                rows.append([link, *named, *self._shown_by(one, table, row), sense])
        heads = [self.t("Link"), self.t("Vector"), self.t("Moved to the point"), self.t("Turns the link")]
        if len(plans) > 1:
            heads.insert(1, self.t("Quantity"))
        return worded(caption, heads, rows, (1, *([1] if len(plans) > 1 else []), 2, 2, 4))

    def _shown_by(self, one: Sense, table: model.Table, row: int) -> list[Any]:
        if one.like:
            return [self.page.word(self.t("as link %(link)s", link=one.like), table, "like", row), ""]
        return [
            self.page.word(self.page.sym(segment(one.ends)), table, "vector", row),
            self.page.word(self.page.sym(one.to), table, "to", row),
        ]

    def comparison(self, caption: Any, drawn: Drawn, *beside: Drawn) -> Table:
        """What was measured in both plans of a position, or of several, and its values by all methods."""
        table = self.table(f"comparison_{drawn.position}")
        if beside:
            every = (drawn, *beside)
            tables = {one.position: self.table(f"comparison_{one.position}") for one in every}
            segments = {one.position: self._segments(one) for one in every}
            return side_by_side(self.page, caption, tables, self.named, segments, self.nought)
        own = self.readings.compared(drawn.position) if self.readings and self.has_own(drawn) else None
        one, measured = drawn.position, self._segments(drawn)
        return comparison_table(self.page, caption, table, self.named, one, measured, own, self.nought)

    def _segments(self, drawn: Drawn) -> dict[str, Cell]:
        """The lengths measured or laid off, mm, by the values that they give; what is worked from others has none."""
        row, found = self.found.drawn.index(drawn), dict[str, Cell]()
        places = read_places(self.found.accuracy)
        for plan in (drawn.velocity, drawn.acceleration):
            read, worked = self.table(f"segments_{plan.kind}"), self.table(plan.worked.table)
            for key, ends in plan.ends.items():
                found[key] = self.page.cell(read, ends, row, digits=7, places=places)
            for key, ends in plan.laid.items():
                laid = f"laid_{ends}"
                number = plan.worked.rows[laid][1]
                full = short_and_full(number, DIGITS, self.page.tr.decimal, 2)[1]
                found[key] = Cell(full, worked.by_key(laid, "value", plan.position))
        return {key: Cell(cell.full, cell.ref) for key, cell in found.items()}

    def compared(self, worked: bool) -> list[list[Drawn]]:
        """The positions whose plans always stand in the text, or the others: those of a table. A shorter note that
        compares all has two of them in one, without telling worked ones from others."""
        if self.page.note.every or self.page.note.stand("plans.compared") != "body" or self.owned():
            return [[one] for one in self.found.drawn if (one.position in self.worked) == worked]
        drawn, tables = [*self.found.drawn] if worked else [], []
        while drawn:
            tables.append([drawn.pop(0)])
            if drawn and self._keys(drawn[0]) == self._keys(tables[-1][0]):
                tables[-1].append(drawn.pop(0))
        return tables

    def _keys(self, drawn: Drawn) -> set[str]:
        return {one.key for one in drawn.comparison}

    def has_own(self, drawn: Drawn) -> bool:
        """Whether a student read values off the plans of a position."""
        rows = self.readings.rows.get(drawn.position, ()) if self.readings else ()
        return not {one.key for one in rows}.isdisjoint(c.key for c in drawn.comparison)

    def owned(self) -> bool:
        """Whether there are a student's own values beside those of the plans."""
        return any(map(self.has_own, self.found.drawn))


def _rates_of(links: list[str], linkage: Linkage) -> Iterator[str]:
    """Keys of what is nought at every position where `links` only translate."""
    for link in links:
        yield from (f"w_{link}", f"e_{link}")
    for of in relations(linkage):
        for branch in of.branches:
            if branch.turns and branch.link in links:
                yield from (branch.v_key, branch.a_key("n"), branch.a_key("t"))
