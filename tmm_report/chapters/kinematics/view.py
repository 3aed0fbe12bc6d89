"""View of the kinematic analysis: positions, singular positions, motion of the outputs, angular rates."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.initial_data.quantities import MU_L, driving_arm, given_tables, length, scale
from tmm_report.chapters.kinematics import quantities as q
from tmm_report.chapters.kinematics.draw import Diagrams
from tmm_report.chapters.kinematics.limits import Closest
from tmm_report.chapters.kinematics.solve import Kinematics, Travel
from tmm_report.chapters.schemes import schemes_of
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.cycle import larger
from tmm_report.mechanics.dyads import Dyad
from tmm_report.mechanics.higher import HigherGroup
from tmm_report.mechanics.relations import turning_links
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Book, Value, variable
from tmm_report.quantity.ref import Ref
from tmm_report.report.layout import Cell, Table, numeric, worded
from tmm_report.report.page import Page
from tmm_report.report.part import Part
from tmm_report.report.schemes import Schemes
from tmm_report.report.words import group_label, group_name

if TYPE_CHECKING:
    from tmm_report.course import LeverFound

# Dyad kind -> how its position is found.
CLOSURES = {
    1: N_(
        "group %(group)s: point %(inner)s lies at the intersection of two circles, the one about %(a)s "
        "described by link %(one)s and the one about %(b)s described by link %(other)s"
    ),
    2: N_(
        "group %(group)s: point %(inner)s lies at the intersection of the circle about %(a)s described "
        "by link %(one)s with the line of guide %(b)s"
    ),
    3: N_(
        "group %(group)s: the direction of guide %(inner)s is found from the triangle with the vertices "
        "%(a)s and %(b)s, in which the distance of the guide from the joints is known"
    ),
    4: N_("group %(group)s: point %(inner)s lies at the intersection of the lines of guides %(a)s and %(b)s"),
    5: N_(
        "group %(group)s: the position of link %(other)s on guide %(b)s is found from the condition that"
        " guide %(inner)s passes at a known distance from point %(a)s"
    ),
}
# The same of a group above class II.
HIGHER_CLOSURE = N_(
    "group %(group)s: the equations of its closed vector contours, %(n)s in projections on the axes, are solved "
    "together by Newton's method; the group is followed from the assembly of the sketch by steps so short that by the "
    "Newton–Kantorovich condition only one solution lies near, so it cannot pass into another assembly"
)


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    view = KinematicsView(lever.kinematics, schemes_of(lever, page), lever.sample, lever.partial, page)
    yield Part("kinematics", view)


class KinematicsView:
    def __init__(self, found: Kinematics, schemes: Schemes, position: int, partial: bool, page: Page):
        self.found, self.schemes, self.position, self.page = found, schemes, position, page
        self.partial, self.t = partial, page.t
        self.book = page.once(q.book, found)
        self.diagrams = Diagrams(found, page.tr)

    def conclusions(self) -> list[Markup]:
        return [self._conclusion(travel) for travel in self.found.travels]

    def _conclusion(self, travel: Travel) -> Markup:
        name, largest = travel.output.name, {}
        for letter, ends in (("v", travel.V_extremes), ("a", travel.a_extremes)):
            end = "min" if larger(ends) is ends[0] else "max"
            value = self.book[f"{letter.upper()}_{name}_{end}"]
            largest[letter] = self.page.shown(value, size=True)
            largest[f"{letter}at"] = self._turned(value)
        if travel.output.kind == "slider":
            text = N_(
                "The stroke of point %(point)s is %(stroke)s m; its greatest velocity is %(v)s m/s at the angle of "
                "turn %(vat)s°, its greatest acceleration is %(a)s m/s² at %(aat)s°."
            )
            stroke = self.page.shown(self.book[f"H_{name}"])
            return self.t(text, point=name, stroke=stroke, **largest)
        text = N_(
            "The angle of swing of link %(link)s is %(stroke)s°; its greatest angular velocity is %(v)s rad/s at the "
            "angle of turn %(vat)s°, its greatest angular acceleration is %(a)s rad/s² at %(aat)s°."
        )
        stroke = self.page.shown(self.book[f"H_{name}"], unit="deg", places=1)
        return self.t(text, link=name, stroke=stroke, **largest)

    def _turned(self, value: Value, places: int = 1) -> Markup:
        """The angle of turn at which a value holds, degrees."""
        return self.page.said(self._at(value, places))

    def _at(self, value: Value, places: int) -> Cell:
        assert value.at is not None
        return Cell(self.page.num(np.degrees(value.at), places=places), Ref(value.key, by="at_deg"))

    # ------------------------------------------------------------ positions

    @property
    def turns(self) -> int:
        """How many turns the cycle takes."""
        return self.found.cycle.turns

    @property
    def count(self) -> int:
        """Positions of the scheme."""
        return self.found.positions.table // self.turns

    def scheme(self) -> Drawing:
        return self.schemes.all(self.position)

    def length_scale(self) -> Formula | None:
        """mu_l from the driving link's arm as drawn; None where it has no arm."""
        mechanism = self.found.linkage.mechanism
        given = Book.of((), scale(mechanism, self.schemes.length_scale))
        arm = driving_arm(mechanism)
        if arm is None:
            return None
        ends, metres = arm
        drawn = Book.of(given_tables(mechanism)).tables["dimensions"]
        size = variable(length(ends), metres, ref=drawn.by_key(length(ends).key, "length"))
        return given["mu_l"].formula(size / given[f"drawn_{ends}"].var())

    def plain_scale(self) -> Markup:
        """mu_l with its value."""
        return self.page.value(MU_L.value(self.schemes.length_scale).var())

    def closures(self) -> list[Markup]:
        """How the position of each group is found, in the order of assembly."""
        return [self._closure(d) for d in self.found.linkage.groups]

    @property
    def has_assemblies(self) -> bool:
        """Whether a group has several assemblies: not where guides alone fix it."""
        return any(isinstance(d, HigherGroup) or d.kind <= 3 for d in self.found.linkage.groups)

    def _closure(self, d: Dyad | HigherGroup) -> Markup:
        if isinstance(d, HigherGroup):
            return self.t(HIGHER_CLOSURE, group=group_name(d.group), n=len(d.links))
        a, b, inner = d.outer_a.name, d.outer_b.name, d.inner.name
        return self.t(CLOSURES[d.kind], group=group_name(d.group), a=a, b=b, inner=inner, one=d.a, other=d.b)

    # ------------------------------------------------------------ singular positions

    def closeness(self, caption: Any) -> Table:
        """Of every group the least closeness over the cycle, where it is reached and what it costs."""
        table = self.book.tables["special"]
        kinds = list(table["kind"].values)
        where = [row for row, kind in enumerate(kinds) if kind == "closest"]
        rows = [
            [
                self.page.word(group_label(c.group), table, "of", row),
                self.t("sine of the transmission angle")
                if c.is_dyad
                else self.t("least singular value of the scaled Jacobian"),
                self.page.cell(table, "closeness", row, digits=4),
                self.page.cell(table, "phi", row, places=1),
                self.page.cell(table, "digits", row),
            ]
            for row, c in zip(where, self.found.closest, strict=True)
        ]
        heads = [
            self.t("Group"), self.t("Measure"), self.t("Least value"), self.t("At the angle of turn, °"),
            self.t("Digits that remain"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (3, 6, 2, 2, 2))

    @property
    def has_dead(self) -> bool:
        return any(dead.turned for dead in self.found.dead)

    def dead(self, caption: Any) -> Table:
        """Dead points of the output links."""
        table = self.book.tables["special"]
        where = iter([row for row, kind in enumerate(table["kind"].values) if kind == "dead"])
        rows = []
        for dead in self.found.dead:
            for pair in dead.in_line:
                row = next(where)
                text = N_("links %(one)s and %(other)s in one line")
                words = self.t(text, one=pair[0], other=pair[1]) if pair else "—"
                angle = self.page.cell(table, "phi", row, places=3)
                rows.append([self.page.word(dead.output, table, "of", row), angle, words])
        heads = [self.t("Output link"), self.t("Angle of turn, °"), self.t("Position of the links")]
        return worded(caption, heads, rows, (2, 2, 6))

    def sentences(self) -> list[Markup]:
        """What is to be said of limits, change points and parallel guides."""
        found = [self.page.sentence(gap.text) for gap in self.found.gaps]
        return found + [text for c in self.found.closest for text in self._singular(c)]

    def _singular(self, c: Closest) -> Iterator[Markup]:
        passed = tuple(x for x in c.changes if x not in c.corners)
        for angles, text in (
            (passed, PASSED), (c.corners, CORNER), (c.parallel, PARALLEL), (c.limits, LIMIT),
        ):  # fmt: skip
            if angles:
                group, links = group_label(c.group), ", ".join(c.links)
                yield self.t(text, group=group, links=links, angles=self._angles(angles))

    def _angles(self, turned: tuple[float, ...]) -> str:
        """Angles found by root finding, rad, in degrees to a thousandth."""
        return ", ".join(f"{self.page.num(np.degrees(x), places=3)}°" for x in turned)

    # ------------------------------------------------------------ motion of the outputs

    def has_output(self, kind: str) -> bool:
        return any(travel.output.kind == kind for travel in self.found.travels)

    def travels(self, caption: Any) -> Table:
        """S, V, a of the outputs at the table positions."""
        table = self.book.tables["outputs_table"]
        columns = [
            self.page.column(table, quantity.key, "deg" if quantity.unit == "rad" else "")
            for travel in self.found.travels
            for quantity in q.motion_of(travel.output)
        ]
        return numeric(caption, self.page.positions(table), columns)

    def stroke(self, travel: Travel) -> Markup:
        value = self.book[f"H_{travel.output.name}"]
        return self.page.value(value.var("deg" if value.unit == "rad" else ""))

    def time_ratio(self, travel: Travel) -> Markup:
        return self.page.value(self.book[f"K_{travel.output.name}"].var(digits=4))

    def extremes(self, caption: Any, travel: Travel) -> Table:
        rows = []
        for quantity, (low, high) in zip(q.motion_of(travel.output), q.extremes(travel), strict=True):
            unit = "deg" if quantity.unit == "rad" else ""
            size = max(abs(low.value), abs(high.value))
            ends = [
                (self.page.cell(end, unit=unit, scale=max(1.0, size)), self._at(end, 2))
                for end in (low, high)
            ]
            rows.append([self.page.head(quantity.sign, unit or quantity.unit), *ends[0], *ends[1]])
        heads = [
            self.t("Quantity"), self.t("Least value"), self.t("at the angle of turn,\N{NO-BREAK SPACE}°"),
            self.t("Greatest value"), self.t("at the angle of turn,\N{NO-BREAK SPACE}°"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2.2, 2, 2, 2, 2))

    # ------------------------------------------------------------ angular rates

    @property
    def driven(self) -> list[str]:
        """Links that turn, without the driving link."""
        linkage = self.found.linkage
        return [link for link in turning_links(linkage) if link != linkage.mechanism.driver.link]

    def angular(self, caption: Any) -> Table:
        """Angular velocities and accelerations of the driven links at the table positions."""
        table = self.book.tables["rates_table"]
        keys = [q.link_rate(letter, link).key for link in self.driven for letter in "we"]
        return numeric(caption, self.page.positions(table), [self.page.column(table, key) for key in keys])


PASSED = N_(
    "at the angle of turn φ = %(angles)s group %(group)s (links %(links)s) passes a change point: "
    "its two assemblies meet and two continuations exist; the stated assembly is kept and the motion "
    "goes on smoothly. Velocities and accelerations there are the limits of those beside it; reactions "
    "grow without bound and are left out"
)
CORNER = N_(
    "at the angle of turn φ = %(angles)s group %(group)s (links %(links)s) is in a change point in which "
    "its two assemblies meet, and is kept in the stated one: gone through smoothly, it would begin the "
    "next turn in the other. Velocities there have no limit"
)
PARALLEL = N_(
    "at the angle of turn φ = %(angles)s the guides of group %(group)s (links %(links)s) are parallel "
    "and its links run away"
)
LIMIT = N_(
    "at the angle of turn φ = %(angles)s group %(group)s (links %(links)s) is at the limit of its "
    "assembly; velocities there are not bounded"
)
