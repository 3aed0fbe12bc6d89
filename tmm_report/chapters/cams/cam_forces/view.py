"""View of the forces of a cam that stands alone: what the follower needs, normal force, drive, spring, contact."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.cams.cam.quantities import displacement, first, named, pressure, second
from tmm_report.chapters.cams.cam.quantities import tables as cam_tables
from tmm_report.chapters.cams.cam.quantities.names import speed
from tmm_report.chapters.cams.cam.solve.found import Cams
from tmm_report.chapters.cams.cam_forces import quantities as q
from tmm_report.chapters.cams.cam_forces.draw import loop
from tmm_report.chapters.cams.cam_forces.solve import JAMS, LEFT, PRESSED, Found
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Expr, Formula, Var, cos, sin
from tmm_report.quantity.functions import arctan
from tmm_report.quantity.model import Book
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.page import ROUNDING, Page
from tmm_report.report.paper.layout import Table, numeric, worded
from tmm_report.report.part import Failed, Part

STATES = {
    PRESSED: N_("At %(angles)s the cam presses the follower."),
    LEFT: N_("At %(angles)s the follower has left the cam."),
    JAMS: N_("At %(angles)s the follower jams."),
}


def parts(found: Found, page: Page, label: str = "") -> Iterator[Part]:
    yield Part("cams/cam_forces", ForcesView(found, page))


class ForcesView(BookView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, Book.of(q.tables(found), q.values(found)))
        self.found, self.rows = found, self.table("cam_forces_table")
        motion = {table.name: table for table in cam_tables(Cams((found.cam,)))}
        self.motion = motion[named(found.cam, "cam_motion", "table")]

    # ------------------------------------------------------------ what is said

    @cached_property
    def position(self) -> int:
        """Of which the forces are written out: the first in which the follower moves and the cam presses it."""
        at = self.found.table
        moves = np.abs(at.moved[1]) > 1e-9 * np.max(np.abs(at.moved[1]))
        for good in (moves & (at.pressed.N > 0), moves):
            if good[:-1].any():
                return int(np.flatnonzero(good[:-1])[0])
        return 0

    def conclusions(self) -> list[Markup]:
        held = N_("The follower is held on the cam by a spring with %(sizes)s.")
        said = [self.t(held, sizes=self.listed(("cam_F0", "cam_c")))] if self.found.springs else []
        return [*self._failures(), *said, *([self.turning()] if not self.found.jams else [])]

    def needed_sign(self) -> Markup:
        return self.page.sym(q.needed(self.found).sign)

    @property
    def exact(self) -> bool:
        """Whether two ways to the moment of the drive differ by rounding alone."""
        return self.value("cam_disagreement").value < ROUNDING

    def chosen_spring(self) -> Markup:
        """Preload and rate."""
        return self.t(N_("It has %(sizes)s."), sizes=self.listed(("cam_F0", "cam_c")))

    def rubbing(self) -> Markup:
        """How friction turns the forces, of what rubs in this mechanism."""
        rubs, flat = self.found.loaded.rubs, self.found.cam.cam.flat
        said = []
        if rubs.guide is not None and rubs.guide.friction:
            said.append(
                N_(
                    "In the guide it acts at both ends, each pressed according to the inclination and the "
                    "overhang of the cam's force."
                )
            )
        if rubs.pin:
            said.append(
                N_(
                    "In the roller's pin it turns the force of the cam so that this touches the friction circle."
                )
            )
        if rubs.face:
            said.append(
                N_("On the flat face it turns the force of the cam from the normal by the angle of friction.")
                if flat
                else N_("On the edge it turns the force of the cam from the normal by the angle of friction.")
            )
        if rubs.pivot is not None and rubs.pivot.friction:
            said.append(N_("In the follower's pivot it takes a moment by the radius of its friction circle."))
        return self.page.listed(map(self.t, said), " ")

    def drawn(self) -> Markup:
        """The caption of the diagram."""
        pressed = self.found.contact is not None
        if self.found.slides:
            text = (
                N_(
                    "Force that the follower needs and normal force, moment of the drive and pressure in the "
                    "contact over a turn of the cam"
                )
                if pressed
                else N_(
                    "Force that the follower needs and normal force, moment of the drive over a turn of the cam"
                )
            )
        else:
            text = (
                N_(
                    "Moment that the follower needs, normal force, moment of the drive and pressure in the "
                    "contact over a turn of the cam"
                )
                if pressed
                else N_(
                    "Moment that the follower needs, normal force and moment of the drive over a turn of the cam"
                )
            )
        return self.t(text)

    def turning(self) -> Markup:
        """The moment of the drive over the turn."""
        text = N_(
            "The moment of the drive of the cam varies from %(low)s N·m at the angle of rotation %(low_at)s° to "
            "%(high)s N·m at %(high_at)s°; its mean is %(mean)s N·m, its work in a turn %(work)s J."
        )
        return self.t(
            text, low=self.number("cam_T_min"), low_at=self.turned("cam_T_min"), high=self.number("cam_T_max"),
            high_at=self.turned("cam_T_max"), mean=self.number("cam_T_mean"), work=self.number("cam_work"),
        )  # fmt: skip

    def _failures(self) -> Iterator[Markup]:
        if self.found.leaves:
            yield Failed(self.left())
        if self.found.jams:
            yield Failed(self.jammed())
        if self.knows("cam_sigma_perm") and self.found.contact is not None and not self._bears:
            yield Failed(self.t(N_("The pressure in the contact is greater than is permitted.")))

    @property
    def _bears(self) -> bool:
        found, permitted = self.found.contact, self.found.given.permitted
        return found is None or permitted is None or found.value <= permitted

    def left(self) -> Markup:
        """Where the follower has left the cam."""
        text = N_(
            "The follower leaves the cam: at the angles of rotation %(zones)s° the force that it needs is below "
            "zero, and the cam can only push. The forces and moments found there are those of a follower held by "
            "something else."
        )
        return self.t(text, zones=self._zones())

    def _zones(self) -> Markup:
        table = self.table("cam_leaves")
        ends = [
            [self.page.said(self.page.cell(table, key, row, places=1)) for key in ("from", "to")]
            for row in range(len(table))
        ]
        return self.page.listed([self.page.listed(two, "–") for two in ends], "°; ")

    def jammed(self) -> Markup:
        text = N_(
            "The follower jams: at the angle of rotation %(at)s° friction takes more than the cam can give, of "
            "whose force it would leave %(share)s times what there is without friction."
        )
        return self.t(text, at=self.turned("cam_share"), share=self.number("cam_share", digits=3))

    def bears(self) -> Markup:
        """The greatest pressure in the contact against the permitted one."""
        text = N_("The greatest pressure in the contact is %(sigma)s MPa, at the angle of rotation %(at)s°.")
        said = self.t(text, sigma=self.number("cam_sigma_max", digits=4), at=self.turned("cam_sigma_max"))
        if not self.knows("cam_sigma_perm"):
            return said
        more = N_("%(permitted)s MPa is permitted.")
        return self.page.listed([said, self.t(more, permitted=self.number("cam_sigma_perm"))], " ")

    # ------------------------------------------------------------ formulas

    def _var(self, key: str) -> Var:
        return self.rows.var(key, self.position)

    def _moved(self, make: Any) -> Var:
        return self.motion.var(make(self.found.cam).key, self.position)

    def needs(self) -> list[Formula]:
        """Spring, inertia and their sum with load and weight, at the position."""
        k, own = self.position, self.rows
        found, made = self.found, list[Formula]()
        keys = [key for key in ("cam_load", "cam_weight", "cam_spring", "cam_inertia") if key in own]
        if "cam_spring" in own:
            force = self.var("cam_F0") + self.var("cam_c") * self._moved(displacement)
            made.append(own.formula("cam_spring", k, force))
        if "cam_inertia" in own:
            omega = speed(found.cam).value(found.loaded.omega).var()
            made.append(own.formula("cam_inertia", k, self.var("cam_mass") * omega**2 * self._moved(second)))
        if len(keys) > 1:
            whole: Expr = self._var(keys[0])
            for key in keys[1:]:
                whole = whole + self._var(key)
            made.append(own.formula("cam_needed", k, whole))
        return made

    def pressing(self) -> Formula | None:
        """The normal force of a follower that slides, where nothing but its guide rubs at most."""
        rubs, k = self.found.loaded.rubs, self.position
        if not self.found.slides or rubs.pin or rubs.face or self._off:
            return None
        alpha, Q = self.motion.var(pressure(self.found.cam).key, k), self._var("cam_needed")
        guide = rubs.guide
        if guide is None or not guide.friction:
            return self.rows.formula("cam_N", k, Q / cos(alpha))
        if guide.lowest or self.found.cam.cam.flat:
            return None
        way = 1 if self.found.table.moved[1][k] * self.found.table.pressed.N[k] > 0 else -1
        lever = self.var("cam_guide_f") * (1 + 2 * self.var("cam_overhang") / self.var("cam_guide"))
        taken = lever * abs(sin(alpha))
        return self.rows.formula("cam_N", k, Q / (cos(alpha) - taken if way > 0 else cos(alpha) + taken))

    @property
    def _off(self) -> bool:
        """Whether at the position written out the follower is no more on the cam, or jams."""
        return bool(
            self.found.table.pressed.left[self.position] or self.found.table.pressed.jams[self.position]
        )

    def torques(self) -> list[Formula]:
        """The moment of the drive without friction, and with it by the powers."""
        k = self.position
        made = [self.rows.formula("cam_T0", k, self._var("cam_needed") * self._moved(first))]
        if "cam_T_fr" in self.rows and not self.found.table.pressed.jams[k]:
            parts = [key for key in (f"cam_T_{name}" for name in q.LOST) if key in self.rows]
            if len(parts) > 1:
                whole: Expr = self._var(parts[0])
                for key in parts[1:]:
                    whole = whole + self._var(key)
                made.append(self.rows.formula("cam_T_fr", k, whole))
            made.append(self.rows.formula("cam_T", k, self._var("cam_T0") + self._var("cam_T_fr")))
        return made

    def jam_angle(self) -> Formula | None:
        """From which pressure angle on the guide jams."""
        guide = self.found.loaded.rubs.guide
        if guide is None or guide.lowest or not guide.friction:
            return None
        c, b, f = self.var("cam_guide"), self.var("cam_overhang"), self.var("cam_guide_f")
        return self.value("cam_alpha_jam").formula(arctan(c / (f * (c + 2 * b))))

    # ------------------------------------------------------------ tables

    @property
    def apart(self) -> bool:
        """Whether the parts of the forces stand in a table of their own, or are left out."""
        return self.page.note.stand("cam_forces.parts") != "body" and bool(self._parts)

    @property
    def _parts(self) -> list[str]:
        own = (
            "cam_load",
            "cam_weight",
            "cam_spring",
            "cam_inertia",
            *(f"cam_T_{name}" for name in q.LOST),
            "cam_T_fr",
        )
        return [key for key in own if key in self.rows]

    def forces(self, caption: Any) -> Table:
        """What the follower needs, normal force, moment of the drive; their parts where they are not `apart`."""
        left = {"position", "phi", *(self._parts if self.apart else ())}
        keys = [one.key for one in self.rows.columns if one.key not in left]
        return self.by_positions(caption, "cam_forces_table", keys, joined=True)

    def forces_in_parts(self, caption: Any) -> Table:
        return self.by_positions(caption, "cam_forces_table", self._parts, joined=True)

    def asked(self, caption: Any) -> Table:
        """Numbers at the angles that are asked."""
        table = self.table("cam_asked")
        keys = [one.key for one in table.columns if one.key not in ("phi", "state")]
        return numeric(
            caption, self.column("cam_asked", "phi"), [self.column("cam_asked", key) for key in keys]
        )

    def states(self) -> Markup:
        """What the follower does at the angles asked, all that are alike together."""
        table, page = self.table("cam_asked"), self.page
        at = defaultdict[str, list[Markup]](list)
        for row, state in enumerate(table["state"].values):
            angle = page.listed([page.said(page.cell(table, "phi", row)), "°"], "")
            at[str(state)].append(angle)
        return page.listed(
            [self.t(STATES[state], angles=page.listed(angles)) for state, angles in at.items()], " "
        )

    def ends(self, caption: Any) -> Table:
        """Least and greatest of the phases."""
        table, page = self.table("cam_force_ends"), self.page
        keys = [one.key for one in table.columns if one.key not in ("number", "phase")]
        rows = [
            [
                page.cell(table, "number", row), page.word(self.t(table["phase"].values[row]), table, "phase", row),
                *(page.cell(table, key, row, places=1 if key.endswith("_at") else None) for key in keys),
            ]
            for row in range(len(table))
        ]  # fmt: skip
        heads = [page.head(table[key].symbol(), table[key].unit) for key in keys]
        return worded(caption, [self.t("No."), self.t("Phase"), *heads], rows, (1, 2, *([2] * len(keys))))

    def springs(self, caption: Any) -> Table:
        table, page = self.table("cam_springs"), self.page
        keys = ("cam_F0", "cam_c", "cam_F_max")
        rows = [
            [
                page.word(self.t(table["kind"].values[row]), table, "kind", row),
                *(page.cell(table, key, row) for key in keys),
            ]
            for row in range(len(table))
        ]
        heads = [page.head(table[key].symbol(), table[key].unit) for key in keys]
        return worded(caption, [self.t("Spring"), *heads], rows, (4, 2, 2, 2))

    # ------------------------------------------------------------ diagrams

    def diagram(self) -> Graph:
        """What the follower needs and the normal force; the moment of the drive; the pressure in the contact."""
        table, at = self.table("cam_forces_diagram"), self.found.drawn
        graphs = CycleGraphs(at.turned, self.found.given.table, self.page.tr)
        shown = [("cam_needed", at.parts.whole), ("cam_N", at.pressed.N)]
        rubs = "cam_T" in table
        shown += [("cam_T", at.pressed.torque)] if rubs else []
        shown.append(("cam_T0", at.pressed.smooth))
        if at.pressure is not None:
            shown.append(("cam_sigma", at.pressure / q.MEGA))
        panels = {"cam_N": "cam_needed"} if self.found.slides else {}
        panels |= {"cam_T0": "cam_T"} if rubs else {}
        heads = [key for key, _ in shown if key not in panels]
        keys = {key for key, _ in shown}
        shared = {one for pair in panels.items() if keys.issuperset(pair) for one in pair}
        curves = [
            Curve(
                numbers,
                graphs.letter(table[key].symbol()) if key in shared else "",
                heads.index(panels.get(key, key)),
                (),
            )
            for key, numbers in shown
        ]
        return graphs.graph(curves, [graphs.axis(table[key].quantity) for key in heads], join=False)

    @property
    def sprung(self) -> bool:
        return q.springs(self.found) and bool(self.found.loaded.inertia)

    def loop(self) -> Drawing:
        return loop(self.found, self.page)
