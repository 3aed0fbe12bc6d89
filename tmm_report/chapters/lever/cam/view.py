"""View of the cam pairs: sizes, phases and laws, diagrams, pressure angle, profile."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.lever.cam import draw, formulas
from tmm_report.chapters.lever.cam import quantities as q
from tmm_report.chapters.lever.cam.formulas import Written
from tmm_report.chapters.lever.cam.solve import CamFound, Cams
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.model import Book
from tmm_report.quantity.ref import Ref
from tmm_report.report.diagrams import CycleGraphs, points, scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, numeric, worded
from tmm_report.report.part import Failed, Part

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def parts(lever: LeverFound, page: Page) -> Iterator[Part]:
    if lever.cam is not None:
        yield Part("lever/cam", CamsView(lever.cam, lever.sample, page))


class CamsView:
    """`position`: of which the pressure angle is written out."""

    def __init__(self, found: Cams, position: int, page: Page):
        self.book = Book.of(q.tables(found), q.values(found))
        self.cams = [CamView(one, self.book, position, page) for one in found.cams]

    def conclusions(self) -> list[Markup]:
        return [text for cam in self.cams for text in cam.conclusions()]


class CamView:
    def __init__(self, found: CamFound, book: Book, position: int, page: Page):
        self.found, self.book, self.page, self.t = found, book, page, page.t
        self.position = position
        self.cam, self.name = found.cam, found.cam.name

    def conclusions(self) -> list[Markup]:
        text = N_(
            "The greatest pressure angle of cam %(cam)s in the rise is %(alpha)s°, the allowed one is %(limit)s°; the "
            "least radius of curvature of its profile is %(rho)s mm."
        )
        alpha, limit = self.number("cam_alpha_rise", places=1), self.number("cam_alpha_limit", places=1)
        found = self.t(
            text, cam=self.cam.cam, alpha=alpha, limit=limit, rho=self.number("cam_rho", unit="mm")
        )
        return [*self._failures(), found]

    def _failures(self) -> Iterator[Markup]:
        names = {"cam": self.cam.cam, "follower": self.cam.follower}
        if self.found.exceeds:
            yield Failed(self.t(N_("The pressure angle of cam %(cam)s is greater than is allowed."), **names))
        if self.hard:
            text = N_(
                "The law of follower %(follower)s has hard shocks: there its acceleration and the forces of cam "
                "%(cam)s are without bound, and the forces found do not hold."
            )
            yield Failed(self.t(text, **names))

    def number(self, key: str, **form: Any) -> Markup:
        """A value of this cam in running text."""
        return self.page.shown(self.book[f"{key}_{self.name}"], **form)

    def least(self) -> Markup:
        """The least displacement with its unit."""
        shown = self.number("cam_least", unit="mm" if self.found.slides else "deg")
        return self.page.listed(
            [shown, self.page.unit("mm" if self.found.slides else "deg")], " " if self.found.slides else ""
        )

    def turned(self, key: str) -> Markup:
        """The angle of turn at which a value is reached, degrees."""
        value = self.book[f"{key}_{self.name}"]
        assert value.at is not None
        cell = Cell(self.page.num(np.degrees(value.at), places=1), Ref(value.key, by="at_deg"))
        return self.page.said(cell)

    # ------------------------------------------------------------ sizes and law

    def sizes(self) -> list[Var]:
        """What is stated of the pair."""
        return [self._sized(key) for key in self._sizes]

    @property
    def _sizes(self) -> list[str]:
        keys = ("cam_base", "cam_roller", "cam_lift", "cam_offset", "cam_arm", "cam_apart")
        own = [f"{key}_{self.name}" for key in keys]
        return [key for key in own if key in self.book.values]

    def _sized(self, key: str) -> Var:
        value = self.book[key]
        return value.var("deg") if value.unit == "rad" else value.var()

    def explained(self) -> list[dict[str, Any]]:
        """The same in words."""
        values = (self.book[key] for key in self._sizes)
        return [self.page.explained(v.key, v, "deg" if v.unit == "rad" else v.unit) for v in values]

    def of_base(self) -> list[Formula]:
        """The pitch circle and the follower's lowest position."""
        found = (formulas.pitch_base(self.found, self.book), formulas.start(self.found, self.book))
        return [one for one in found if one is not None]

    def phases(self, caption: Any) -> Table:
        table, page = self.book.tables[f"cam_phases_{self.name}"], self.page
        rows = [
            [
                page.cell(table, "number", k), page.word(self.t(q.KINDS[phase.kind]), table, "phase", k),
                page.word(self.t(q.LAWS[phase.law]), table, "law", k), page.cell(table, "start", k),
                page.cell(table, "angle", k),
            ]
            for k, phase in enumerate(self.found.phases)
        ]  # fmt: skip
        heads = [
            self.t("No."), self.t("Phase"), self.t("Law of motion"), page.head(q.START.sign, "deg"),
            page.head(q.ANGLE.sign, "deg"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (1, 3, 4, 2, 2))

    def laws(self) -> list[Written]:
        return formulas.laws(self.found, self.book)

    def law_words(self, row: int) -> dict[str, Markup]:
        """What a law is written out of, for a sentence. `row`: its number among them."""
        phase = self.found.samples[row].phase
        return {
            "k": self.page.shown(self.book.tables[f"cam_law_{self.name}"], "at", row),
            "phase": self.t(q.KINDS[phase.kind]),
            "law": self.t(q.LAWS[phase.law]),
        }

    def shocks(self, caption: Any) -> Table:
        """Where the law has shocks, and of which kind."""
        table, page = self.book.tables[f"cam_shocks_{self.name}"], self.page
        rows = [
            [
                page.cell(table, "phi", k, places=1), *(page.cell(table, key, k) for key in ("first", "second")),
                page.word(self.t(q.SHOCKS[shock.hard]), table, "shock", k),
            ]
            for k, shock in enumerate(self.found.shocks)
        ]  # fmt: skip
        signs = [self.page.head(table[key].symbol(), table[key].unit) for key in ("phi", "first", "second")]
        return worded(caption, [*signs, self.t("Shock")], rows, (2, 3, 3, 3))

    @property
    def hard(self) -> bool:
        """Whether the law has a hard shock."""
        return any(shock.hard for shock in self.found.shocks)

    def motion(self, caption: Any) -> Table:
        return self._table(caption, f"cam_motion_{self.name}_table")

    def profile_table(self, caption: Any) -> Table:
        return self._table(caption, f"cam_profile_{self.name}")

    def _table(self, caption: Any, name: str) -> Table:
        table = self.book.tables[name]
        columns = [self.page.column(table, column.key) for column in table.columns[2:]]
        return numeric(caption, self.page.positions(table), columns)

    # ------------------------------------------------------------ diagrams

    @cached_property
    def _graphs(self) -> CycleGraphs:
        kinematics = self.found.kinematics
        closed = kinematics.positions.table if kinematics.cycle.closed else 0
        return CycleGraphs(self.found.drawn.turned, closed, self.page.tr)

    @cached_property
    def diagram(self) -> Graph:
        """Displacement, its derivatives and the pressure angle between its limits over the angle turned."""
        drawn = self.found.drawn
        curves = [
            Curve(x, panel=panel, extremes=points(ends))
            for panel, (x, ends) in enumerate(
                zip((drawn.S, drawn.first, drawn.second), self.found.ends, strict=True)
            )
        ]
        limit = np.degrees(self.cam.limit)
        curves.append(Curve(np.degrees(drawn.alpha), panel=3, extremes=self._greatest_angles))
        curves += [Curve(np.full_like(drawn.alpha, sign * limit), panel=3, extremes=()) for sign in (1, -1)]
        named = [make(self.found) for make in (q.displacement, q.first, q.second, q.pressure)]
        return self._graphs.graph(curves, [self._graphs.letter(one.sign, one.unit) for one in named])

    @property
    def _greatest_angles(self) -> list[tuple[float, float]]:
        """The greatest pressure angles of rise and return with their signs: angle turned and value, degrees."""
        turned = [end.turned for end in (self.found.rise, self.found.back)]
        alpha = np.degrees(self.found.at(np.array(turned)).alpha)
        return [(float(np.degrees(x)), float(y)) for x, y in zip(turned, alpha, strict=True)]

    def pressure(self) -> Formula | None:
        return formulas.pressure(self.found, self.book, self.position)

    # ------------------------------------------------------------ the profile

    def scale_var(self) -> Var:
        return scale_of("mu_l", self._scale, "m/mm")

    @cached_property
    def _scale(self) -> float:
        return draw.scale(self.found)

    def drawing(self) -> Drawing:
        return draw.drawing(self.found, self._scale)
