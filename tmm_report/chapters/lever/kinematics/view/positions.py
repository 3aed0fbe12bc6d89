"""View of the kinematic analysis: positions and drawing lengths of the links, singular positions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.initial_data.quantities import MU_L, driving_arm, given_tables, length, scale
from tmm_report.chapters.lever.kinematics import quantities as q
from tmm_report.chapters.lever.kinematics.checks.digits_left import PRINTED, Near
from tmm_report.chapters.lever.kinematics.checks.singular import Closest
from tmm_report.chapters.lever.kinematics.contours.view import ContoursView
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics
from tmm_report.chapters.lever.kinematics.solve.working_stroke import Working, working_of
from tmm_report.chapters.lever.kinematics.view.motion import MotionView
from tmm_report.chapters.lever.schemes import schemes_of
from tmm_report.figures.lettering import symbol
from tmm_report.figures.schemes.scheme import Drawn
from tmm_report.figures.schemes.strokes import Stroke
from tmm_report.mechanics.lever.cams.replacing_dyad import CamDyad
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.problems import N_
from tmm_report.quantity import model
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.model import Book, variable
from tmm_report.quantity.symbols import segment
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Table, worded
from tmm_report.report.part import Failed, Part
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
    "group %(group)s: the equations of its closed vector loops, %(n)s in projections on the axes, are solved "
    "together by Newton's method; the group is followed from the assembly of the sketch by steps so short that "
    "by the Newton–Kantorovich condition only one solution lies near, so it cannot pass into another assembly"
)

# Of a follower with the link that replaces its cam pair.
CAM_CLOSURE = N_(
    "group %(group)s: follower %(follower)s is placed by cam %(cam)s, as the chapter of the cam pair shows; its "
    "velocity and acceleration are the derivatives of the displacement times the angular velocity and its square, and "
    "link %(link)s, which replaces the pair, lies along the common normal"
)


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    found, k = lever.kinematics, lever.sample
    working = working_of(lever)
    view = KinematicsView(found, schemes_of(lever, page), k, lever.partial, working, page)
    yield Part("lever/kinematics", view)
    if (stroke := found.stroke) is not None:
        from tmm_report.chapters.lever.kinematics.view.stroke import ReversedView, TriangleView
        from tmm_report.mechanics.lever.driving.triangle import Triangle

        if isinstance(stroke, Triangle):
            yield Part("lever/kinematics/stroke", TriangleView(found, k, page))
        else:
            yield Part("lever/kinematics/reversed", ReversedView(found, k, page))
    elif found.cycle.law is not None:
        from tmm_report.chapters.lever.kinematics.view.driving import DrivingView

        yield Part("lever/kinematics/driving", DrivingView(found, k, page))
    yield Part("lever/kinematics/contours", ContoursView(found, k, page))
    yield Part("lever/kinematics/singular", view)
    yield Part("lever/kinematics/motion", MotionView(found, k, lever.partial, working, page))


class KinematicsView(BookView):
    def __init__(
        self,
        found: Kinematics,
        schemes: Schemes,
        position: int,
        partial: bool,
        working: Mapping[str, Working],
        page: Page,
    ):
        super().__init__(page, page.once(q.book, found))
        self.found, self.schemes, self.position = found, schemes, position
        self.partial, self.working = partial, working

    def conclusions(self) -> list[Markup]:
        """A method that misses its accuracy; near which singular positions few digits remain: first, if fewer than are
        printed."""
        missed = []
        if self.found.missed is not None:
            from tmm_report.chapters.lever.kinematics.view.method import failed

            missed = [failed(self.found, self.table("method"), self.page)]
        return [*missed, *(self._near(near) for near in self.found.near)]

    def _near(self, near: Near) -> Markup:
        line = self.t(N_("Near a singular position: %(what)s."), what=self.page.sentence(near.text))
        return Failed(line) if near.digits < PRINTED else line

    # ------------------------------------------------------------ positions

    @property
    def turns(self) -> int:
        """How many turns the cycle takes."""
        return self.found.cycle.turns

    @property
    def count(self) -> int:
        """Positions of the scheme."""
        return self.found.positions.table // self.turns

    @cached_property
    def scheme(self) -> Drawn:
        """All positions: at the scale of the construction, in a shorter note at one that the text holds."""
        strokes = self._strokes()
        if self.page.note.every:
            return Drawn(self.schemes.scale, self.schemes.all(self.position, strokes))
        return self.schemes.all_in_text(self.position, strokes)

    def scheme_scale(self) -> Var:
        """mu_l with the scale at which the positions are drawn."""
        return scale_of("mu_l", self.scheme.mu, "m/mm")

    def reduced(self) -> bool:
        """Whether the positions are drawn smaller than they are constructed."""
        return self.scheme.mu > self.schemes.scale

    def _strokes(self) -> list[Stroke]:
        before, _, after = self.page.tr.gettext("working stroke %(output)s").partition("%(output)s")
        driver = self.found.linkage.mechanism.driver
        if driver.law is not None and not driver.goes_round:  # it goes over the same places there and back
            return []
        return [Stroke(w.first, w.last, (before, symbol(w.output), after)) for w in self.working.values()]

    def length_scale(self) -> Formula | None:
        """mu_l from the driving link's arm as drawn; None where it has no arm."""
        mechanism = self.found.linkage.mechanism
        given = Book.of((), scale(mechanism, self.schemes.scale))
        arm = driving_arm(mechanism)
        if arm is None:
            return None
        ends, metres = arm
        drawn = Book.of(given_tables(mechanism)).tables["dimensions"]
        size = variable(length(ends), metres, ref=drawn.by_key(length(ends).key, "length"))
        return given["mu_l"].formula(size / given[f"drawn_{ends}"].var())

    def drawn_lengths(self, caption: Any) -> Table:
        """Of every segment of the links its length and the length at which it is drawn."""
        mechanism = self.found.linkage.mechanism
        lengths = Book.of(given_tables(mechanism), scale(mechanism, self.schemes.scale))
        table = lengths.tables["dimensions"]
        keys = [str(key).removeprefix("l_") for key in table["key"].values]
        rows = [
            [
                self.page.listed([self.t("Length"), self.page.unit("m")]),
                *(self.page.cell(table, "length", row) for row in range(len(keys))),
            ],
            [
                self.page.listed([self.t("On the drawing"), self.page.unit("mm")]),
                *(self.page.cell(lengths[f"drawn_{key}"]) for key in keys),
            ],
        ]
        heads = [self.t("Segment"), *(self.page.sym(segment(key)) for key in keys)]
        return worded(caption, heads, rows, (3, *(1 for _ in keys)))

    def plain_scale(self) -> Markup:
        """mu_l with its value."""
        return self.page.value(MU_L.value(self.schemes.scale).var())

    def closures(self) -> list[Markup]:
        """How the position of each group is found, in the order of assembly."""
        return [self._closure(d) for d in self.found.linkage.groups]

    def method(self) -> list[Markup]:
        """By what method the numbers were found, where the variant states one."""
        if self.found.choice is None:
            return []
        from tmm_report.chapters.lever.kinematics.view.method import said

        return said(self.found, self.table("method"), self.page)

    @property
    def has_assemblies(self) -> bool:
        """Whether a group has several assemblies: not where guides alone fix it."""
        groups = [d for d in self.found.linkage.groups if not isinstance(d, CamDyad)]
        return any(isinstance(d, HigherGroup) or d.kind <= 3 for d in groups)

    def _closure(self, d: Dyad | HigherGroup) -> Markup:
        if isinstance(d, HigherGroup):
            return self.t(HIGHER_CLOSURE, group=group_name(d.group), n=len(d.links))
        if isinstance(d, CamDyad):
            cam = d.cam
            return self.t(
                CAM_CLOSURE, group=group_name(d.group), cam=cam.cam, follower=cam.follower, link=cam.name
            )
        a, b, inner = d.outer_a.name, d.outer_b.name, d.inner.name
        return self.t(CLOSURES[d.kind], group=group_name(d.group), a=a, b=b, inner=inner, one=d.a, other=d.b)

    # ------------------------------------------------------------ singular positions

    def closeness(self, caption: Any) -> Table:
        """Of every group the least closeness over the cycle, where it is reached and what it costs."""
        table = self.table("special")
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
            self.t("Group"), self.t("Measure"), self.t("Least value"),
            self.t("At the angle of rotation,\N{NO-BREAK SPACE}°"), self.t("Digits that remain"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (3, 6, 2, 2, 2))

    @property
    def dwells(self) -> bool:
        """Whether cams may let an output link stand over a part of the cycle."""
        return bool(self.found.linkage.mechanism.cams)

    @property
    def has_dead(self) -> bool:
        return any(dead.turned for dead in self.found.dead)

    def dead(self) -> Markup:
        """The dead points of the output links, each with the links that are in line there."""
        table = self.table("special")
        where = iter([row for row, kind in enumerate(table["kind"].values) if kind == "dead"])
        points = {travel.output.name for travel in self.found.travels if travel.output.kind == "slider"}
        told = []
        for dead in self.found.dead:
            rows: dict[Any, list[int]] = {}
            for pair, row in zip(dead.in_line, where, strict=False):
                rows.setdefault(pair, []).append(row)
            if rows:
                of = OF_POINT if dead.output in points else OF_LINK
                name = self.page.said(self.page.named(table, "of", next(iter(rows.values()))[0]))
                angles = self.page.listed(self._dead(table, rows[pair], pair) for pair in rows)
                told.append(self.t(of, name=name, angles=angles))
        return self.page.listed(told, "; ")

    def _dead(self, table: model.Table, rows: Sequence[int], pair: Any) -> Markup:
        """The angles of turn at which the same two links are in line."""
        angles = self.page.listed(
            self.page.listed([self.page.shown(table, "phi", row, places=2), "°"], "") for row in rows
        )
        text = N_("%(angles)s (links %(one)s and %(other)s in one line)")
        return self.t(text, angles=angles, one=pair[0], other=pair[1]) if pair else angles

    def sentences(self) -> list[Markup]:
        """What is to be said of gaps, parallel guides among them, of limits and change points."""
        texts = [*(gap.text for gap in self.found.gaps), *(near.text for near in self.found.near)]
        found = [self.page.sentence(text) for text in texts]
        return found + [text for c in self.found.closest for text in self._singular(c)]

    def _singular(self, c: Closest) -> Iterator[Markup]:
        passed = tuple(x for x in c.changes if x not in c.corners)
        corners = () if any(gap.group == c.group for gap in self.found.gaps) else c.corners  # told already
        for angles, text in (
            (passed, PASSED), (corners, CORNER), (c.limits, LIMIT),
        ):  # fmt: skip
            if angles:
                group, links = group_label(c.group), ", ".join(c.links)
                yield self.t(text, group=group, links=links, angles=self._angles(angles))

    def _angles(self, turned: tuple[float, ...]) -> str:
        """Angles found by root finding, rad, in degrees as tables of extremes have them."""
        return ", ".join(f"{self.page.num(np.degrees(x), places=2)}°" for x in turned)


OF_POINT, OF_LINK = N_("for point %(name)s at %(angles)s"), N_("for link %(name)s at %(angles)s")
PASSED = N_(
    "at the angle of rotation φ = %(angles)s group %(group)s (links %(links)s) passes a change point: its two "
    "assemblies meet and two continuations exist; the stated assembly is kept and the motion goes on smoothly. "
    "Velocities and accelerations there are the limits of those beside it; reactions grow without bound and are "
    "left out"
)
CORNER = N_(
    "at the angle of rotation φ = %(angles)s group %(group)s (links %(links)s) is in a change point in which its "
    "two assemblies meet, and is kept in the stated one: gone through smoothly, it would begin the next turn in "
    "the other. Velocities jump there, and extremes are sought on both sides of it"
)
LIMIT = N_(
    "at the angle of rotation φ = %(angles)s group %(group)s (links %(links)s) is at the limit of its assembly; "
    "velocities there are not bounded"
)
