"""View of the force plans: one plan a group, the driving link's last."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from tmm_report.chapters.lever.force_plans import lever_view
from tmm_report.chapters.lever.force_plans import quantities as q
from tmm_report.chapters.lever.force_plans.drafting import ForceDrawn, ForcePlan
from tmm_report.chapters.lever.force_plans.draw import force_picture
from tmm_report.chapters.lever.force_plans.loading_draw import Loaded, loading_schemes
from tmm_report.chapters.lever.force_plans.solve import ForcePlans
from tmm_report.chapters.lever.schemes import ties_of
from tmm_report.chapters.lever.structure.quantities import index_of
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.schemes.scheme import reduced
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.wheels.coupled import Coupled
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.model import Book, Quantity
from tmm_report.quantity.paper import read_places
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.terms.kinds import parted
from tmm_report.quantity.text import short_and_full
from tmm_report.report.chapter_view import BookView
from tmm_report.report.comparison import comparison_table
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, worded
from tmm_report.report.part import Part
from tmm_report.report.words import group_label

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

DRIVING = ("driver", "led", "line", "thrust")  # stages of what drives
MOVED = ("wheel", "rolling", "rack")
WIDE, BESIDE = (
    (165.0, 70.0),
    (80.0, 70.0),
)  # mm: one of several schemes or plans on a page, one beside another
REDUCED_ARM = Definition("h", abs(Var("M_I", 0.0)) / Var("F_I", 0.0))


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.force_plans is not None:
        view = ForcePlansView(lever, lever.force_plans, page)
        yield Part("lever/force_plans", view)
        yield lever_view.part(lever.force_plans.levers, view.first, view.book, page)


class ForcePlansView(BookView):
    kinds_once = True
    driving = DRIVING
    reduced_arm = REDUCED_ARM
    label = staticmethod(group_label)

    def __init__(self, lever: LeverFound, found: ForcePlans, page: Page):
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found, self.pairs = found, lever.structure.pairs
        self.kinematics, self.length_scale = lever.kinematics, lever.plans.length_scale
        self.places = read_places(lever.plans.accuracy)
        drawn = [one.position for one in found.drawn]
        self.first = (
            lever.sample if lever.sample in drawn else next(iter(drawn), 0)
        )  # that is worked out in full
        self.picture, self.parted = cache(self._picture), cache(self._parted)
        self.scheme_scale, self.plan_scale = cache(self._scheme_scale), cache(self._plan_scale)
        self.words = partial(page.tr.pgettext, "index")
        forces, self.ties = lever.kinetostatics, tuple(ties_of(lever))
        self.couples = forces is not None and bool(forces.table.loading.couples)

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The reactions and the balancing moment found by the force polygons differ from the analytical ones "
            "by at most %(worst)s %%."
        )
        if self.stroke is not None:
            text = N_(
                "The reactions and the balancing force found by the force polygons differ from the analytical "
                "ones by at most %(worst)s %%."
            )
        return [self.t(text, worst=self.number("delta_F_max", digits=3))] if self.found.drawn else []

    @property
    def pivot(self) -> str:
        """The fixed point about which the driving link turns."""
        return self.pairs[0].name

    def guided(self, links: Sequence[str]) -> bool:
        """Whether a guide joins one of the links."""
        return any(pair.kind == "P" and set(pair.links) & set(links) for pair in self.pairs)

    def scale(self, drawn: ForceDrawn, plan: ForcePlan) -> Markup:
        """mu_F of a plan with its value."""
        return self.page.value(drawn.worked[1 + drawn.plans.index(plan)].number(q.MU_F, plan.scale))

    # ------------------------------------------------------------ formulas

    def leading(self, drawn: ForceDrawn, formulas: Sequence[Formula]) -> list[Formula]:
        """Of the inertia forces or readings of a position those that stand for their kind."""
        first, _ = self.parted(drawn)
        return [one for one in formulas if one in first]

    def following(self, drawn: ForceDrawn, formulas: Sequence[Formula]) -> list[Formula]:
        """The others."""
        _, others = self.parted(drawn)
        return [one for one in formulas if one in others]

    def _parted(self, drawn: ForceDrawn) -> tuple[list[Formula], list[Formula]]:
        return parted((*drawn.inertia, *(one for plan in drawn.plans for one in plan.readings)))

    def solution(self, plan: ForcePlan) -> Markup:
        return self.page.listed(self.page.value(var, digits=5) for var in plan.solution)

    def _picture(self, plan: ForcePlan) -> Drawing:
        return force_picture(plan, self.words, self.plan_scale(plan))

    # ------------------------------------------------------------ scales in the note

    @property
    def shares(self) -> bool:
        """Whether schemes and plans are as small as several must be to share a page."""
        return self.page.note.stand("force_plans.sheets") == "omit"

    def smaller(self, drawn: ForceDrawn) -> bool:
        """Whether a scheme or a plan is drawn smaller in the note than arms and lengths are read off it."""
        return any(
            self.scheme_scale(drawn, plan) > self.length_scale or self.plan_scale(plan) > plan.scale
            for plan in drawn.plans
        )

    def _scheme_scale(self, drawn: ForceDrawn, plan: ForcePlan) -> float:
        """m/mm."""
        if not self.shares:
            return self.length_scale
        return reduced(
            self.length_scale,
            lambda mu: [one.drawing for one in self._loading(drawn, plan, mu)],
            _room(plan),
        )

    def _plan_scale(self, plan: ForcePlan) -> float:
        """N/mm."""
        if not self.shares:
            return plan.scale
        return reduced(plan.scale, lambda mu: [force_picture(plan, self.words, mu)], _room(plan))

    def picture_scale(self, drawn: ForceDrawn, plan: ForcePlan) -> Markup:
        """mu_F with the scale at which a plan stands in the note."""
        mu = self.plan_scale(plan)
        return self.scale(drawn, plan) if mu == plan.scale else self.page.value(scale_of("mu_F", mu, "N/mm"))

    # ------------------------------------------------------------ loading schemes

    def loading(self, drawn: ForceDrawn, plan: ForcePlan) -> list[Loaded]:
        return self._loading(drawn, plan, self.scheme_scale(drawn, plan))

    def _loading(self, drawn: ForceDrawn, plan: ForcePlan, scale: float) -> list[Loaded]:
        return loading_schemes(self.kinematics, scale, drawn, plan, self.words, self.ties)

    def loading_caption(self, drawn: ForceDrawn, plan: ForcePlan, links: Sequence[str]) -> Markup:
        """Of the scheme of some links of a plan."""
        scale = scale_of("mu_l", self.scheme_scale(drawn, plan), "m/mm")
        told = {"k": drawn.position, "scale": self.page.value(scale)}
        if plan.stage == "driver":
            return self.t("Loading of the driving link, position %(k)s, %(scale)s", **told)
        if plan.stage != "group":
            text = N_("Loading of link %(links)s, position %(k)s, %(scale)s")
            several = N_("Loading of links %(links)s, position %(k)s, %(scale)s")
            return self.t(text if len(links) == 1 else several, links=self.page.listed(links), **told)
        told["group"] = self.label(plan.label)
        if len(links) == 1:
            text = N_("Loading of link %(link)s of the group %(group)s, position %(k)s, %(scale)s")
            return self.t(text, link=links[0], **told)
        return self.t("Loading of the group %(group)s, position %(k)s, %(scale)s", **told)

    def plan_caption(self, drawn: ForceDrawn, plan: ForcePlan) -> Markup:
        told = {"k": drawn.position, "scale": self.picture_scale(drawn, plan)}
        if plan.stage == "driver":
            return self.t("Force polygon of the driving link, position %(k)s, %(scale)s", **told)
        if plan.stage == "group":
            text = N_("Force polygon of the group %(group)s, position %(k)s, %(scale)s")
            return self.t(text, group=self.label(plan.label), **told)
        text = N_("Force polygon of link %(links)s, position %(k)s, %(scale)s")
        several = N_("Force polygon of links %(links)s, position %(k)s, %(scale)s")
        return self.t(text if len(plan.links) == 1 else several, links=self.page.listed(plan.links), **told)

    # ------------------------------------------------------------ wheels, strokes

    def wheel(self, plan: ForcePlan) -> Coupled | None:
        """The link that a mesh moves, where the plan is of one."""
        coupled = self.kinematics.linkage.structure.coupled if plan.stage in MOVED else ()
        return next((one for one in coupled if one.link == plan.links[0]), None)

    def pole(self, wheel: Coupled) -> Symbol:
        """Its pitch point."""
        return Symbol("P", index_of(wheel.mesh))

    @property
    def stroke(self) -> Stroke | None:
        return self.kinematics.stroke

    def bodies(self, drawn: ForceDrawn) -> tuple[str, ...]:
        """The rod, or the links of the cylinder, between the link that follows the stroke and its far point."""
        return next((plan.links for plan in drawn.plans if plan.stage == "line"), ())

    def symbols(self, of: Sequence[Quantity]) -> Markup:
        return self.page.listed(self.page.sym(one.sign) for one in of)

    # ------------------------------------------------------------ tables

    def armed(self, drawn: ForceDrawn) -> bool:
        """Whether any force has an arm."""
        return any(plan.arms for plan in drawn.plans)

    def arms(self, caption: Any, drawn: ForceDrawn) -> Table:
        table = self.table(f"arms_{drawn.position}")
        arms = [arm for plan in drawn.plans for arm in plan.arms]
        rows = [
            [
                self.page.sym(arm.force.sign), self.page.word(arm.about, table, "about", row),
                self.page.cell(table, "arm_mm", row, digits=7), self.page.cell(table, "arm", row),
            ]
            for row, arm in enumerate(arms)
        ]  # fmt: skip
        heads = [self.t("Force"), self.t("About point"), self.t("Arm on the scheme, mm"), self.t("Arm, m")]
        return worded(caption, heads, rows, (2, 2, 3, 3))

    def reduced(self, caption: Any, drawn: ForceDrawn) -> Table:
        table = self.table(f"reduced_{drawn.position}")
        rows = [
            [
                self.page.word(link, table, "link", row),
                *(self.page.cell(table, key, row) for key in ("F_I", "M_I", "h")),
                self._centre(table, row),
            ]
            for row, link in enumerate(table["link"].values)
        ]
        centre = self.t("Centre of percussion %(letter)s: x; y", letter=drawn.reduced[0].letter)
        heads = [
            self.t("Link"), *(self.page.head(table[key].symbol(), table[key].unit) for key in ("F_I", "M_I", "h")),
            self.page.listed([centre, self.page.unit("m")]),
        ]  # fmt: skip
        return worded(caption, heads, rows, (1, 2, 2, 2, 3))

    def _centre(self, table: Any, row: int) -> Markup:
        x, y = (self.page.shown(table, key, row, digits=4) for key in ("x_K", "y_K"))
        return self.page.listed([x, y], "; ")

    def comparison(self, caption: Any, drawn: ForceDrawn) -> Table:
        table = self.table(f"force_comparison_{drawn.position}")
        named = {quantity.key: quantity for quantity in q.compared(drawn)}
        return comparison_table(self.page, caption, table, named, drawn.position, self._segments(drawn))

    def _segments(self, drawn: ForceDrawn) -> dict[str, Cell]:
        """Lengths of the vectors read off the plans, mm, by the forces that they give."""
        found = {}
        for worked in drawn.worked:
            for of in q.compared(drawn):
                if (key := q.drawn_length(of).key) in worked.rows:
                    size = short_and_full(worked.rows[key][1], 7, self.page.tr.decimal, self.places)[1]
                    found[of.key] = Cell(size, worked.ref(key))
        return found


def _room(plan: ForcePlan) -> tuple[float, float]:
    """What its scheme, and its plan, may fill where several share a page: of one link each beside another."""
    return BESIDE if len(plan.links) == 1 else WIDE
