"""View of the initial data: the scheme, the driving link, dimensions, fixed points, guides and masses."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.initial_data import quantities as q
from tmm_report.chapters.lever.schemes import schemes_of
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.schemes.scheme import Drawn
from tmm_report.mechanics.calculus.motion_laws import Harmonic, Polynomial
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.mechanism import FRAME, Guide, Link, Mechanism, ZeroAngle, ZeroExtreme
from tmm_report.problems import N_
from tmm_report.quantity.formula import PI, Formula, Var
from tmm_report.quantity.model import Book, variable
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import DASH, Cell, Table, worded
from tmm_report.report.part import Part
from tmm_report.report.schemes import Schemes
from tmm_report.report.words import sense

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

LAWS = {
    "Harmonic": N_("its angle is that of a uniform rotation and a harmonic about it"),
    "Polynomial": N_("its angle is a polynomial of the time"),
    "Tabulated": N_("its angle is stated by a table and follows the cubic spline through its points"),
    "Phased": N_("its angle goes through phases of rise, dwell and return, as a cam's follower does"),
}

STROKES = {
    "Harmonic": N_("it goes harmonically about a middle"),
    "Polynomial": N_("it is a polynomial of the time"),
    "Tabulated": N_("it is stated by a table and follows the cubic spline through its points"),
    "Phased": N_("it goes through phases of rise, dwell and return, as a cam's follower does"),
    "Pieces": N_("it moves with constant accelerations one after another"),
    "RunUp": N_(
        "it moves at a constant speed, which it gains from rest, or loses to rest, at a constant acceleration"
    ),
}
UNIFORM = N_("it changes at a constant speed")

SWINGS = N_("it oscillates harmonically about a middle position")

EXTREMES = {1: N_("rightmost"), -1: N_("leftmost"), 1j: N_("topmost"), -1j: N_("lowest")}


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    yield Part(
        "lever/initial_data", InitialData(lever.given.mechanism, schemes_of(lever, page), lever.sample, page)
    )


def picture(lever: LeverFound, page: Page) -> Drawing:
    """The mechanism at a glance, for a list of many."""
    return schemes_of(lever, page).one(lever.sample)


class InitialData(BookView):
    def __init__(self, mechanism: Mechanism, schemes: Schemes, position: int, page: Page):
        super().__init__(page, Book.of(q.given_tables(mechanism), q.given_values(mechanism, schemes.scale)))
        self.mechanism, self.schemes, self.position = mechanism, schemes, position

    def conclusions(self) -> list[Markup]:
        return []

    # ------------------------------------------------------------ the driving link

    def cylinder(self) -> dict[str, Any]:
        """The points of a driving cylinder and links that they belong to; whether the first one is fixed."""
        stroke, links_at = self.stroke, self.mechanism.links_at
        assert stroke is not None
        one, other = stroke.ends
        first, second = (
            next(
                (
                    link
                    for link in (stroke.link, *links_at(point))
                    if link in links_at(point) and link not in stroke.by
                ),
                "",
            )
            for point in stroke.ends
        )
        return {"one": one, "other": other, "first": first, "link": second, "fixed": FRAME in links_at(one)}

    @property
    def pivot(self) -> str:
        """The fixed point about which the driving link turns."""
        return q.driving_pivot(self.mechanism)

    @property
    def by_law(self) -> bool:
        """Whether the driving link moves by a law of the time."""
        return self.mechanism.driver.law is not None

    def law(self) -> Markup:
        """What kind of law it is."""
        law = self.mechanism.driver.law
        swings = isinstance(law, Harmonic) and not law.speed
        return self.t(SWINGS if swings else LAWS[type(law).__name__])

    @property
    def stroke(self) -> Stroke | None:
        """Of a driving slider or cylinder."""
        return self.mechanism.driver.stroke

    def stroke_law(self) -> Markup:
        """What kind of law the stroke has."""
        law = self.stroke.law if self.stroke else None
        if isinstance(law, Polynomial) and len(law.coefficients) == 2:
            return self.t(UNIFORM)
        return self.t(STROKES[type(law).__name__])

    def law_given(self) -> Markup:
        """The numbers of the law."""
        keys = [key for key in self.book.values if key.startswith("law_")]
        return self.t("Given: %(numbers)s.", numbers=self.listed(keys))

    def turns(self) -> Markup:
        """In which sense the driving link turns."""
        speed = self.value("omega")
        return self.page.said(Cell(str(sense(speed.value, self.page)), speed.ref()))

    def omega(self) -> Markup:
        return self.page.value(self.value("omega").var(size=True))

    def from_period(self) -> Formula | None:
        """The angular velocity from the time of a turn; None where the speed itself is stated."""
        if not self.knows("T_turn"):
            return None
        return self.value("omega").formula(2 * PI / self.var("T_turn"), size=True)

    def speed(self) -> Formula:
        """Revolutions a minute from the angular velocity."""
        return self.value("n_1").formula(30 * self.value("omega").var(size=True) / PI)

    @property
    def begins_extreme(self) -> bool:
        """Whether position 0 is stated by an extreme position."""
        return isinstance(self.mechanism.driver.zero, ZeroExtreme)

    def zero(self) -> Markup:
        """Which position counts as position 0."""
        t, zero = self.t, self.mechanism.driver.zero
        if isinstance(zero, ZeroAngle):
            angle = self.page.num(np.degrees(zero.angle), 5)
            text = N_("the position in which link %(link)s makes an angle of %(angle)s° with the x axis")
            return t(text, link=self.mechanism.driver.link, angle=angle)
        if zero.point is None:
            way = sense(1 if np.real(zero.direction) > 0 else -1, self.page)
            return t("the extreme %(sense)s position of link %(link)s", sense=way, link=zero.link)
        word = next((w for unit, w in EXTREMES.items() if abs(zero.direction - unit) < 1e-9), N_("extreme"))
        return t("the %(which)s position of point %(point)s", which=t(word), point=zero.point)

    def cycle(self) -> Markup | None:
        """That a cycle takes several turns; None of one turn."""
        if self.mechanism.driver.turns == 1:
            return None
        text = N_(
            "The cycle takes %(turns)s turns of the driving link, %(angle)s° in %(time)s s: the motion repeats with "
            "every turn, the loads with every cycle."
        )
        turns, angle = (self.number(key, places=0) for key in ("turns", "phi_cycle"))
        return self.t(text, turns=turns, angle=angle, time=self.number("T_cycle"))

    @cached_property
    def scheme(self) -> Drawn:
        return self.schemes.in_text(self.position, small=not self.page.note.every)

    def scheme_scale(self) -> Var:
        """mu_l with the scale at which the scheme is drawn."""
        return scale_of("mu_l", self.scheme.mu, "m/mm")

    # ------------------------------------------------------------ tables

    def links(self, caption: Any) -> Table:
        """Of every link its points, their distances from its first point, mass, mass centre and moment of inertia."""
        sized = {link.name: link for link in q.sized_links(self.mechanism.real)}
        heavy = list(self.table("masses")["link"].values) if self.heavy else []
        rows = [
            [name, *self._measures(sized.get(name)), *(self._mass(heavy, name) if heavy else ())]
            for name in self.mechanism.real.moving
            if name in sized or name in heavy
        ]
        heads = [self.t("Link"), self.t("Points"), self.t("Dimensions")]
        shares = [1.0, 2.0, 7.0]
        if heavy:
            masses = self.table("masses")
            mass, inertia = (
                self.page.head(masses[key].symbol(), masses[key].quantity.printed) for key in ("m", "J")
            )
            heads += [mass, self.t("Mass centre"), inertia]
            shares += [1.5, 1.5, 2.0]
        return worded(caption, heads, rows, shares)

    def _measures(self, link: Link | None) -> tuple[Any, Any]:
        return (self.page.listed(link.points), self._sizes(link)) if link else (DASH, DASH)

    def _mass(self, heavy: Sequence[Any], name: str) -> tuple[Any, ...]:
        """Mass, mass centre and moment of inertia of a link; dashes where it has none."""
        if name not in heavy:
            return DASH, DASH, DASH
        table, row = self.table("masses"), heavy.index(name)
        centre = self.page.named(table, "mass_centre", row)
        return self.page.cell(table, "m", row), centre, self.page.cell(table, "J", row)

    def _sizes(self, link: Link) -> Markup:
        table = self.table("dimensions")
        told = [
            self.page.value(variable(quantity, size, ref=table.by_key(quantity.key, "length")))
            for quantity, size in q.sizes(link.points)
        ]
        text = N_("%(name)s at the place of %(other)s")
        told += [self.t(text, name=name, other=other) for name, other in q.together(link.points)]
        return self.page.listed(told)

    @property
    def many_fixed(self) -> bool:
        return len(self.mechanism.links[FRAME].points) > 1

    def fixed_points(self) -> Markup:
        """The fixed points with their coordinates."""
        table = self.table("fixed_points")
        rows = range(len(table))
        return self.page.listed(
            (self.page.values(table.var(key, row) for key in ("x", "y")) for row in rows), "; "
        )

    @property
    def heavy(self) -> bool:
        """Whether a link has a mass."""
        return self.has("masses")

    @property
    def inert(self) -> bool:
        """Whether a link has a moment of inertia."""
        return any(link.inertia for link in q.heavy_links(self.mechanism))

    def said(self) -> list[Formula]:
        """Masses and moments of inertia that the assignment states by lengths and other masses."""
        if not self.has("masses"):
            return []
        masses = self.table("masses")
        found = q.said(self.mechanism.real, masses, self._lengths())
        return [
            replace(masses.formula(key, row, expression), meaning=of.meaning)
            for key, row, of, expression in found
        ]

    def _lengths(self) -> list[Any]:
        return [self.table(name) for name in ("dimensions", "stated_lengths") if self.has(name)]

    def lengths_said(self) -> list[Formula]:
        """Lengths that the assignment states by other lengths."""
        return [*q.lengths_said(self.mechanism.real, self._lengths())]

    def coordinates_said(self) -> list[Formula]:
        """Coordinates of fixed points that follow from the synthesis."""
        return [*q.coordinates_said(self.mechanism.real, self.table("fixed_points"))]

    def middles(self) -> Markup:
        """The mass centres that are taken in the middle, each with the joints it lies between."""
        text = N_("%(centre)s between %(first)s and %(second)s")
        told = []
        for link in q.heavy_links(self.mechanism):
            if link.said is not None and link.said.middle is not None:
                first, second = link.said.middle
                told.append(self.t(text, centre=link.mass_centre, first=first, second=second))
        return self.page.listed(told)

    def steiner(self) -> list[Formula]:
        """J_S = J − m l² of every link whose moment of inertia is stated about another point."""
        heavy = q.heavy_links(self.mechanism)
        return [self._steiner(row) for row, link in enumerate(heavy) if link.stated]

    def _steiner(self, row: int) -> Formula:
        table = self.table("masses")
        away = table.var("m", row) * table.var("l_about", row) ** 2
        return table.formula("J", row, table.var("J_about", row) - away)

    # ------------------------------------------------------------ guides

    def guides(self) -> list[Markup]:
        """Sentences that describe the guides."""
        return [self._guide(guide) for guide in self.mechanism.guides.values()]

    def _guide(self, guide: Guide) -> Markup:
        angle = self.page.num(math.degrees(np.angle(guide.direction)), 5, scale=180.0)
        x, y = (self.page.num(part) for part in (guide.through.real, guide.through.imag))
        if guide.link == FRAME:
            text = N_(
                "Guide %(name)s is fixed; it passes through the point "
                "(%(x)s;\N{NO-BREAK SPACE}%(y)s)\N{NO-BREAK SPACE}m at an angle of %(angle)s° to the x axis."
            )
        else:
            text = N_(
                "Guide %(name)s belongs to link %(link)s, in whose own axes it passes through the point "
                "(%(x)s;\N{NO-BREAK SPACE}%(y)s)\N{NO-BREAK SPACE}m at an angle of %(angle)s°."
            )
        return self.t(text, name=guide.name, link=guide.link, x=x, y=y, angle=angle)
