"""View of the kinetostatic analysis: loads, reactions, balancing moment and its checks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.kinetostatics.given import Carried
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.quantities.strokes import WORDS
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import sampled
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.kinetostatics.ties import apart
from tmm_report.chapters.lever.kinetostatics.view import cam_pressure as pressing_view
from tmm_report.chapters.lever.kinetostatics.view import checks as lever_view
from tmm_report.chapters.lever.kinetostatics.view import driving_gear as gear_view
from tmm_report.chapters.lever.kinetostatics.view import driving_stroke as stroke_view
from tmm_report.chapters.lever.kinetostatics.view import wheels as wheels_view
from tmm_report.chapters.lever.kinetostatics.view.curves import CurvesView
from tmm_report.chapters.lever.kinetostatics.view.cycle import CycleView
from tmm_report.chapters.lever.kinetostatics.view.diagrams import balancing_diagram, graphs_of, load_diagrams
from tmm_report.chapters.lever.kinetostatics.view.ties import TiesView
from tmm_report.chapters.lever.kinetostatics.view.twists import TwistsView
from tmm_report.chapters.lever.plans.solve import Plans
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Var
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Column, Table, numeric, packed, worded
from tmm_report.report.part import NEXT_CHAPTER, Part
from tmm_report.report.words import force_direction, sense

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

WEIGHT = Definition("G", Var("m", 0.0) * Var("g", 0.0))


def given_parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    """What the initial data say of the loads."""
    found = lever.kinetostatics
    if found is not None and (found.given.forces or found.given.moments):
        yield Part("lever/kinetostatics/given", _view(found, lever, page), concludes=False)


def parts(lever: LeverFound, page: Page) -> Iterator[Part | None]:
    if lever.kinetostatics is None:
        return
    view = _view(lever.kinetostatics, lever, page)
    yield Part("lever/kinetostatics/loads", view)
    if lever.force_plans is not None:
        yield NEXT_CHAPTER  # the force plans stand between the loads and the reactions
    yield Part("lever/kinetostatics", view)
    yield from pressing_view.parts(lever.kinetostatics, page)
    yield from wheels_view.parts(lever.kinetostatics, lever.sample, page)
    yield Part("lever/kinetostatics/curves", view.curves, concludes=False)
    yield Part("lever/kinetostatics/extremes", view.cycle, concludes=False)
    yield Part("lever/kinetostatics/balancing", view)
    yield from stroke_view.parts(lever.kinetostatics, lever.sample, page)
    yield from gear_view.parts(lever.kinetostatics, lever.sample, page)
    yield lever_view.part(lever.kinetostatics, lever.sample, view.after_lever, page)


UNBOUNDED = N_(
    "The balancing moment grows without bound towards the limit position, so that no extremes of it are given; "
    "at the positions that exist Zhukovsky's lever and the power balance confirm it, with a relative difference "
    "that does not exceed %(worst)s."
)
DISAGREE = N_(
    "The balancing moments of the force analysis, of Zhukovsky's lever and of the power balance disagree by a relative "
    "%(worst)s: the solution must not be used."
)


def _view(found: Kinetostatics, lever: LeverFound, page: Page) -> KinetostaticsView:
    drawn = bool(lever.force_plans and lever.force_plans.levers)
    return page.once(KinetostaticsView, found, lever.plans, lever.sample, drawn, page)


class KinetostaticsView(BookView):
    weight = WEIGHT

    def __init__(self, found: Kinetostatics, plans: Plans, position: int, lever: bool, page: Page):
        """`lever`: whether Zhukovsky's lever is drawn."""
        super().__init__(page, page.once(q.book, found))
        self.found, self.plans, self.position = found, plans, position
        self.after_lever = lever and page.note.stand("force_plans.lever") == "body"
        self.cycle, self.curves = CycleView(found, page), CurvesView(found, page)
        at = page.once(sampled, found)
        self.graphs = graphs_of(found, at, page.tr)
        self.diagram = balancing_diagram(found, at, self.graphs)
        self.followed = load_diagrams(found, at, self.graphs, page.form.paper.page[1])
        self.ties = TiesView(found, position, page)
        self.tied = self.ties.diagrams(at, self.graphs)
        self.twists = TwistsView(found, position, page)

    def conclusions(self) -> list[Markup]:
        found = self.found
        text = N_(
            "The balancing moment varies over the cycle from %(low)s N·m at the angle of rotation %(lowat)s to "
            "%(high)s N·m at %(highat)s; Zhukovsky's lever and the power balance confirm it, with a relative "
            "difference that does not exceed %(worst)s."
        )
        if not found.agrees:
            text = N_(
                "The balancing moments of the force analysis, of Zhukovsky's lever and of the power balance "
                "disagree by a relative %(worst)s: the solution must not be used. By the force analysis the "
                "moment varies from %(low)s N·m at the angle of rotation %(lowat)s to %(high)s N·m at %(highat)s."
            )
        worse = "lever" if found.worst_lever >= found.worst_power else "power"
        worst = self.bound(f"{worse}_disagreement")
        if not found.bounded:
            text = UNBOUNDED if found.agrees else DISAGREE
            return [self.t(text, worst=worst), *self.cycle.conclusions()]
        low, high = self.number("M_bal_min"), self.number("M_bal_max")
        lowat, highat = (self.cycle.moment_at(which) for which in ("least", "greatest"))
        return [
            self.t(text, low=low, high=high, lowat=lowat, highat=highat, worst=worst),
            *self.cycle.conclusions(),
        ]

    # ------------------------------------------------------------ what is given

    def stated(self, caption: Any) -> Table:
        """The stated loads: symbol, name, what they act on, direction."""
        given, table = self.found.given, self.table("loads_given")
        forces = apart(given.forces)[0]
        names = enumerate(table["link"].values)
        takes = [self.page.said(Cell(str(name), table.ref("link", row))) for row, name in names]
        on = [
            self.t("point %(point)s of link %(link)s", point=force.at, link=link)
            for force, link in zip(forces, takes, strict=False)
        ]
        on += [self.t("link %(link)s", link=link) for link in takes[len(on) :]]
        ways = [self._way(force.way) for force in forces]
        ways += [sense(moment.direction, self.page) for moment in given.moments]
        quantities = [*q.forces(forces), *q.moments(given.moments)]
        rows = [
            [
                self.page.sym(quantity.sign), self.page.word(table["name"].values[row], table, "name", row),
                on[row], self.page.word(ways[row], table, "direction", row),
            ]
            for row, quantity in enumerate(quantities)
        ]  # fmt: skip
        heads = [self.t("Symbol"), self.t("Load"), self.t("Applied to"), self.t("Direction")]
        return worded(caption, heads, rows, (2, 5, 4, 5))

    @property
    def led(self) -> str | None:
        """The link to which the balancing moment is reduced where a slider or a cylinder drives."""
        stroke = self.found.kinematics.linkage.mechanism.driver.stroke
        return None if stroke is None else stroke.link

    @property
    def stated_alone(self) -> bool:
        """Whether there are loads beside springs and dampers."""
        return self.has("loads_given")

    def _way(self, way: Any) -> Markup:
        if not isinstance(way, Carried):
            return force_direction(way, self.page)
        angle = self.page.num(math.degrees(way.angle), 4, scale=180.0)
        return self.t("turns with link %(link)s, at %(angle)s° to its x axis", link=way.link, angle=angle)

    def magnitudes(self, caption: Any) -> Table:
        """The stated loads along their directions at the table positions, those that repeat none before them."""
        table, count = self.table("stated_table"), self.found.positions
        columns = [self.page.singles(table, column.key, count) for column in table.columns[2:]]
        return numeric(caption, self.page.positions(table, count), columns)

    def strokes(self, caption: Any) -> Table:
        """When the strokes of the indicator diagrams begin and end."""
        table = self.table("strokes")
        signs = {quantity.key: quantity.sign for quantity in q.forces(self.found.given.forces)}
        rows = [
            [
                self.page.word(self.page.sym(signs[key]), table, "load", row),
                self.page.word(self._stroke(str(table["stroke"].values[row])), table, "stroke", row),
                *(self.page.cell(table, end, row, places=1) for end in ("begins", "ends")),
            ]
            for row, key in enumerate(table["load"].values)
        ]
        heads = [self.t("Load"), self.t("Stroke"), self.t("Begins at φ, °"), self.t("Ends at φ, °")]
        return worded(caption, heads, rows, (2, 4, 3, 3))

    def _stroke(self, name: str) -> str | Markup:
        """A stroke of an engine in the language of the note, another by its own name."""
        return self.t(WORDS[name]) if name in WORDS else name

    @property
    def reversed(self) -> bool:
        """Whether a load acts against its stated direction somewhere."""
        columns = self.table("stated_table").columns[2:]
        return any(bool(np.any(column.numbers() < 0)) for column in columns)

    # ------------------------------------------------------------ loads

    def weights(self) -> Markup:
        """G = mg of every link: the same at all positions."""
        table = self.table("loads_table")
        keys = [q.weight(link).key for link in self.found.table.loading.gravity]
        return self.page.values(table.var(key, 0, size=True) for key in keys)

    def inertia(self, caption: Any) -> Table:
        """Inertia forces, magnitudes, and couples at the table positions."""
        loading = self.found.table.loading
        keys = [q.inertia_force(link).key for link in loading.inertia]
        keys += [q.inertia_couple(link).key for link in loading.couples]
        return self.by_positions(caption, "loads_table", keys)

    def jumping(self) -> list[Markup]:
        """At which positions accelerations jump by the driving link's law, and which side the tables have."""
        motion = self.found.kinematics
        if not motion.by_law or not (positions := np.flatnonzero(motion.jumps.standing(motion.turned))).size:
            return []
        text = N_(
            "Positions at which the accelerations jump: %(positions)s; the tables of inertia forces, of reactions and "
            "of the balancing moment give there what is after the jump, their diagrams both sides."
        )
        return [self.t(text, positions=self.page.listed(map(str, positions)))]

    # ------------------------------------------------------------ reactions

    @property
    def beside(self) -> bool:
        """Whether the balancing moment stands beside the reactions: its table by three methods stands elsewhere."""
        return self.page.note.stand("kinetostatics.methods") != "body"

    def reactions(self, caption: Any) -> Table:
        keys = [q.reaction(*pair).key for pair in self._pairs()]
        if not self.beside:
            return self._of_pairs(caption, keys)
        keys += [] if self.central else self._guide_keys()
        return self._of_pairs(caption, keys, [self.column("balancing_table", q.BALANCING_MOMENT.key)])

    def instants(self, caption: Any) -> Table:
        """Balancing moment and reactions at the instants that are asked for."""
        balancing = [self.column("balancing_at", key) for key in ("phi", "t", q.BALANCING_MOMENT.key)]
        of_pairs = [self.column("reactions_at", q.reaction(*pair).key) for pair in self._pairs()]
        return packed(caption, balancing[0], balancing[1:], [[one] for one in of_pairs])

    def directions(self, caption: Any) -> Table:
        """Angles of the reactions with the x axis, degrees; none where there is no force."""
        return self._of_pairs(caption, [q.reaction_angle(*pair).key for pair in self._pairs()])

    def _pairs(self) -> list[tuple[str, str]]:
        return [reaction.pair.links for reaction in self.found.table.statics.reactions.values()]

    def _of_pairs(self, caption: Any, keys: list[str], more: Sequence[Column] = ()) -> Table:
        """What has no number at any position has no column. `more`: columns behind them."""
        name = "reactions_table"
        some = [key for key in keys if np.isfinite(self.of(name, key).numbers()).any()]
        return self.by_positions(caption, name, [*some, *more])

    @property
    def in_guides(self) -> list[tuple[str, str]]:
        """Links of the guides' reactions."""
        reactions = self.found.table.statics.reactions.values()
        return [reaction.pair.links for reaction in reactions if reaction.pair.kind == "P"]

    @property
    def central(self) -> bool:
        """Whether the reactions of all guides pass through the points of their sliders."""
        largest = float(np.nanmax(self.found.table.scale))
        table = self.table("reactions_table")
        moments = [np.asarray(table[q.guide_moment(*pair).key].values) for pair in self.in_guides]
        return all(np.nanmax(np.abs(moment)) <= 1e-9 * largest for moment in moments)

    def guide_points(self, caption: Any) -> Table:
        """Moments of the reactions in guides, and where along the guide the force alone would act."""
        return self._of_pairs(caption, self._guide_keys())

    def _guide_keys(self) -> list[str]:
        return [
            quantity.key
            for pair in self.in_guides
            for quantity in (q.guide_moment(*pair), q.guide_offset(*pair, ""))
        ]

    # ------------------------------------------------------------ balancing moment

    def balancing(self, caption: Any) -> Table:
        """The balancing moment by groups, by the lever and by power."""
        name = "balancing_table"
        heads = [
            self.t("from the force analysis"),
            self.t("from the lever"),
            self.t("from the power balance"),
        ]
        columns = []
        for key, head in zip(("M_bal", "M_lever", "M_power"), heads, strict=True):
            column = self.column(name, key)
            columns.append(column._replace(head=self.page.listed([column.head, head])))
        return self.by_positions(caption, name, columns)
