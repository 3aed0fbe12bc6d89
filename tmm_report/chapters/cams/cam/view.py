"""View of the cam pairs: sizes, phases and laws, diagrams, pressure angle, profile."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.cams.cam import arcs_written, formulas
from tmm_report.chapters.cams.cam import quantities as q
from tmm_report.chapters.cams.cam.draw import centres, face, profile, zone
from tmm_report.chapters.cams.cam.formulas import Written
from tmm_report.chapters.cams.cam.made_view import MadeView
from tmm_report.chapters.cams.cam.sizing import Rules, Sizing, sizing
from tmm_report.chapters.cams.cam.solve.alone import Found
from tmm_report.chapters.cams.cam.solve.found import CamFound, Cams, Divided, Sampled
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.cams.shapes import TABLED
from tmm_report.mechanics.cams.shapes import Graph as ByPieces
from tmm_report.mechanics.cams.sizes.least_face import Face
from tmm_report.mechanics.cams.sizes.least_size import Lever, Zone
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula, Var
from tmm_report.quantity.model import Book, Value
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.chapter_view import BookView
from tmm_report.report.diagrams import CycleGraphs, points, scale_of
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric, worded
from tmm_report.report.part import Failed, Part

PIECED = ("cam_nose", "cam_flank", "cam_distance", "cam_half_angle", "cam_flank_angle")
SIZES = ("cam_base", "cam_roller", "cam_lift", "cam_offset", "cam_arm", "cam_apart")


def parts(found: Found | Sampled, page: Page, label: str = "") -> Iterator[Part]:
    """`found`: a cam that stands alone, or the pairs of a lever mechanism."""
    match found:
        case Sampled(cams, sample):
            yield Part("lever/cams", CamsView(cams, sample, page))
        case _:
            yield Part("cams/cam", CamsView(found, found.sample, page))


def picture(found: Found, page: Page) -> Drawing:
    """The cam with its follower, for a list of many."""
    (one,) = found.cams
    return profile.drawing(one, profile.scale(one))


ALIKE = 1e-9  # of the cam: what differs by less is one
BY_POLES = ("cam_gamma", "cam_gamma_pitch", "cam_x_pitch", "cam_y_pitch")  # left to the results


class CamsView:
    """`position`: of which the pressure angle is written out."""

    def __init__(self, found: Cams, position: int, page: Page):
        self.book = Book.of(q.tables(found), q.values(found))
        self.cams = [CamView(one, self.book, position, page) for one in found.cams]
        self.made = [MadeView(one, self.book, page) for one in found.made]
        self.driven = bool(getattr(found, "driven", False))

    def conclusions(self) -> list[Markup]:
        return [text for cam in self.cams for text in cam.conclusions()]


class CamView(BookView):
    """A key is followed by the name of the cam pair."""

    def __init__(self, found: CamFound, book: Book, position: int, page: Page):
        super().__init__(page, book)
        self.found, self.position = found, position
        self.cam, self.name = found.cam, found.cam.name

    def value(self, key: str) -> Value:
        return super().value(q.named(self.found, key))

    def knows(self, key: str) -> bool:
        return super().knows(q.named(self.found, key))

    def conclusions(self) -> list[Markup]:
        text = N_(
            "Cam %(cam)s has the dimensions %(sizes)s; its greatest pressure angle in the rise is %(alpha)s°, "
            "with %(limit)s° allowed, and the least radius of curvature of its profile is %(rho)s mm."
        )
        alpha, limit = self.number("cam_alpha_rise", places=2), self.number("cam_alpha_limit", places=2)
        sizes = self.listed(SIZES)
        if self.straight:
            text = N_(
                "Cam %(cam)s has the dimensions %(sizes)s; the least radius of curvature of its profile is %(rho)s mm."
            )
        found = self.t(
            text, cam=self.cam.cam, sizes=sizes, alpha=alpha, limit=limit, rho=self.number("cam_rho")
        )
        return [*self._failures(), found]

    def _failures(self) -> Iterator[Markup]:
        names = {"cam": self.cam.cam, "follower": self.cam.follower}
        if self.found.exceeds:
            yield Failed(self.t(N_("The pressure angle of cam %(cam)s is greater than is allowed."), **names))
        if self.found.exceeds_back:
            text = N_("The pressure angle of the return of cam %(cam)s is greater than is allowed.")
            yield Failed(self.t(text, **names))
        if self.hard:
            text = N_(
                "The law of follower %(follower)s has hard shocks: there its acceleration and the forces of cam "
                "%(cam)s are unbounded, and the forces found are not valid."
            )
            yield Failed(self.t(text, **names))

    # ------------------------------------------------------------ sizes and law

    @property
    def _sizes(self) -> tuple[str, ...]:
        """A base circle that is found comes later."""
        return SIZES if self.sizing is None else SIZES[1:]

    def sizes(self) -> Markup:
        """What is stated of the pair."""
        return self.listed(self._sizes)

    def sizes_explained(self) -> list[dict[str, Any]]:
        """The same in words."""
        values = [self.value(key) for key in self._sizes if self.knows(key)]
        return [self.page.explained(one.key, one, one.quantity.printed) for one in values]

    def of_base(self) -> list[Formula]:
        """The pitch circle, where it does not come first, and the follower's lowest position."""
        pitch = formulas.pitch_base(self.found, self.book) if self.sizing is None else None
        return [one for one in (pitch, formulas.start(self.found, self.book)) if one is not None]

    # ------------------------------------------------------------ base circle, flanks and nose

    @cached_property
    def pieced(self) -> arcs_written.Written | None:
        """Its formulas; None where the textbook's do not hold."""
        law = self.found.pieced
        return (
            arcs_written.Written(self.found, law, self.book)
            if law and arcs_written.central(self.found)
            else None
        )

    def pieced_sizes(self) -> Markup:
        return self.listed(PIECED)

    def pieced_explained(self) -> list[dict[str, Any]]:
        values = [self.value(key) for key in PIECED if self.knows(key)]
        return [self.page.explained(one.key, one, one.quantity.printed) for one in values]

    def changes(self, caption: Any) -> Table:
        """The follower on both sides of the changes."""
        table, page = self.table(q.named(self.found, "cam_changes")), self.page
        own = [column.quantity for column in table.columns[1:]]
        rows = [
            [page.word(self.t(word), table, "place", k), *(page.cell(table, one.key, k) for one in own)]
            for k, word in enumerate(table["place"].values)
        ]
        heads = [page.head(table[one.key].symbol(), table[one.key].unit) for one in own]
        return worded(caption, [self.t("Where"), *heads], rows, (4, *(2 for _ in own)))

    # ------------------------------------------------------------ the least cam

    @cached_property
    def sizing(self) -> Sizing | None:
        return sizing(self.found, self.book)

    def signs(self) -> dict[str, Markup]:
        """Letters of what bounds the size, for a sentence."""
        own = {"s": q.displacement, "slope": q.first, "bend": q.second, "alpha": q.pressure, "base": q.base}
        named = {name: make(self.found).sign for name, make in own.items()}
        pair = self.cam.name
        named |= {"e": Symbol("e", pair), "s0": q.lowest_sign(self.found), "b": Symbol("b", pair)}
        return {name: self.page.sym(sign) for name, sign in (named | {"rho": Symbol("rho", pair)}).items()}

    def laid_off(self) -> Markup:
        """What is laid off along the arm of a follower that swings."""
        return self.page.listed(
            [self.page.sym(self.value("cam_arm").symbol), self.page.sym(q.first(self.found).sign)], "·"
        )

    @cached_property
    def freed(self) -> bool:
        """Whether the offset, or the distance of the pivots, is that of the smallest cam."""
        match self.cam.sized:
            case Zone() as zone:
                return abs(self.found.offset - zone.best.e) < ALIKE * self.cam.size
            case Lever() as lever:
                return abs(abs(self._pivot) - abs(lever.centres.best.p)) < ALIKE * self.cam.size
        return False

    @property
    def _pivot(self) -> complex:
        return complex(getattr(self.cam.motion, "pivot", 0j))

    @property
    def _zone(self) -> Zone:
        assert isinstance(self.cam.sized, Zone)
        return self.cam.sized

    @cached_property
    def _zone_mu(self) -> float:
        return zone.scale(self.found, self._zone)

    def zone_scale(self) -> Var:
        return scale_of("mu_l", self._zone_mu, "m/mm")

    def zone(self) -> Drawing:
        return zone.drawing(self.found, self._zone, self._zone_mu)

    @property
    def _under(self) -> Face:
        assert isinstance(self.cam.sized, Face)
        return self.cam.sized

    @cached_property
    def _face_mu(self) -> float:
        return face.scale(self.found, self._under)

    def face_scale(self) -> Var:
        return scale_of("mu_l", self._face_mu, "m/mm")

    def face(self) -> Drawing:
        return face.drawing(self.found, self._under, self._face_mu)

    @cached_property
    def rules(self) -> Rules:
        return Rules(self.found, self.book)

    @property
    def fits(self) -> bool:
        """Whether the roller keeps the rules."""
        limits = self.found.roller_limits
        return limits is not None and (self.cam.roller or 0.0) <= limits.most * (1 + 1e-9)

    @property
    def about_shaft(self) -> bool:
        """Whether the cam is large enough for its shaft."""
        return self.found.pitch_base >= self.value("cam_r0_shaft").value * (1 - 1e-9)

    @property
    def _lever(self) -> Lever:
        assert isinstance(self.cam.sized, Lever)
        return self.cam.sized

    @cached_property
    def _centres_mu(self) -> float:
        return centres.scale(self.found, self._lever)

    def centres_scale(self) -> Var:
        return scale_of("mu_l", self._centres_mu, "m/mm")

    def centres(self) -> Drawing:
        return centres.drawing(self.found, self._lever, self._centres_mu)

    def asks_once(self, name: str = "cam_least") -> bool:
        """Whether one place alone asks most of the size: a sentence says it."""
        return len(self.table(q.named(self.found, name))) == 1

    def asking(self, name: str = "cam_least") -> Markup:
        """The phase in which that place is."""
        return self.t(str(self.table(q.named(self.found, name))["phase"].values[0]))

    def asked_at(self, name: str = "cam_least") -> Markup:
        """The place: angle, displacement, derivative."""
        table = self.table(q.named(self.found, name))
        own = [column.quantity for column in table.columns[1:]]
        units = [(one.key, "mm" if one.unit == "m" else one.shown or one.unit) for one in own]
        return self.page.values(table.var(key, 0, unit) for key, unit in units)

    def asked(self, caption: Any, name: str = "cam_least") -> Table:
        """What rise and return ask."""
        table, page = self.table(q.named(self.found, name)), self.page
        own = [column.quantity for column in table.columns[1:]]
        units = {one.key: "mm" if one.unit == "m" else one.shown for one in own}
        rows = [
            [
                page.word(self.t(word), table, "phase", k),
                *(page.cell(table, key, k, unit) if unit else page.cell(table, key, k) for key, unit in units.items()),
            ]
            for k, word in enumerate(table["phase"].values)
        ]  # fmt: skip
        heads = [page.head(table[key].symbol(), unit or table[key].unit) for key, unit in units.items()]
        return worded(caption, [self.t("Phase"), *heads], rows, (2, 2, 2, 2))

    def phases(self, caption: Any) -> Table:
        table, page = self.table(q.named(self.found, "cam_phases")), self.page
        rows = [
            [
                page.cell(table, "number", k), page.word(self.t(q.KINDS[phase.kind]), table, "phase", k),
                page.word(self.t(q.law_word(phase)), table, "law", k), page.cell(table, "start", k),
                page.cell(table, "angle", k),
            ]
            for k, phase in enumerate(self.found.phases)
        ]  # fmt: skip
        heads = [
            self.t("No."), self.t("Phase"), self.t("Law of motion"), page.head(q.START.sign, q.START.unit),
            page.head(q.ANGLE.sign, q.ANGLE.unit),
        ]  # fmt: skip
        return worded(caption, heads, rows, (1, 3, 4, 2, 2))

    def stated_by(self, displacement: bool) -> bool:
        """Whether a law that goes piece by piece is stated by displacements, or whether one is by something else."""
        laws = (phase.law for phase in self.found.phases)
        return any(isinstance(law, ByPieces) and (law.name == TABLED) == displacement for law in laws)

    def pieces(self, caption: Any) -> Table:
        """The graphs of acceleration, piece by piece."""
        table, page = self.table(q.named(self.found, "cam_pieces")), self.page
        keys = [one.key for one in (q.BEGINS, q.WIDTH, q.REACHED, q.SLOPE, q.BEND, q.NEXT)]
        rows = [
            [
                page.cell(table, "number", k), page.word(self.t(q.FORMS[one.laid.form]), table, "form", k),
                *(page.cell(table, key, k) for key in keys),
            ]
            for k, one in enumerate(self.found.pieces)
        ]  # fmt: skip
        heads = [self.t("Phase"), self.t("Form"), *(page.head(table[key].symbol(), "") for key in keys)]
        return worded(caption, heads, rows, (1, 3, 2, 2, 2, 2, 2, 2))

    def laws(self) -> list[Written]:
        return formulas.laws(self.found, self.book)

    def law_words(self, row: int) -> dict[str, Markup]:
        """What a law is written out of, for a sentence. `row`: its number among them."""
        phase = self.found.samples[row].phase
        return {
            "k": self.page.shown(self.table(q.named(self.found, "cam_law")), "at", row),
            "phase": self.t(q.KINDS[phase.kind]),
            "law": self.t(q.law_word(phase)),
        }

    def shocks(self, caption: Any) -> Table:
        """Where the law has shocks, and of which kind."""
        table, page = self.table(q.named(self.found, "cam_shocks")), self.page
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

    @property
    def cut(self) -> bool:
        """Whether the profile that the law asks for cuts itself; that under an edge has corners alone."""
        return self.hard and self.cam.roller != 0

    @cached_property
    def straight(self) -> bool:
        """Whether the cam presses along the motion of the follower, as under a flat face across it."""
        return bool(np.max(np.abs(self.found.drawn.alpha), initial=0.0) < ALIKE)

    def motion(self, caption: Any) -> Table:
        name = q.named(self.found, "cam_motion", "table")
        left = {"position", "phi", *([q.pressure(self.found).key] if self.straight else [])}
        keys = [one.key for one in self.table(name).columns if one.key not in left]
        return self.by_positions(caption, name, keys, joined=True)

    @property
    def apart(self) -> bool:
        """Whether the coordinates of the profile have a table of their own."""
        return self.page.note.stand("cam.coordinates") != "omit"

    def together(self, caption: Any) -> Table:
        """Motion and polar coordinates of the profile in one table, without what follows from the speed."""
        motion, curve = q.named(self.found, "cam_motion", "table"), q.named(self.found, "cam_profile")
        shown = (q.displacement, q.first, q.second, *([] if self.straight else [q.pressure]))
        keys = [make(self.found).key for make in shown]
        return self.by_positions(
            caption, motion, [*keys, *(self.column(curve, key) for key in self._of_profile)]
        )

    def profile_table(self, caption: Any) -> Table:
        return self.by_positions(caption, q.named(self.found, "cam_profile"), self._of_profile)

    def profile_explained(self) -> list[dict[str, Any]]:
        return self.columns_explained(q.named(self.found, "cam_profile"), *self._of_profile)

    @property
    def _of_profile(self) -> list[str]:
        """Columns of the profile that the note prints."""
        if not self.apart:
            return [q.named(self.found, key) for key in ("cam_R", "cam_delta")]
        left = ("position", "phi", *(BY_POLES if self.found.alone else ()))
        table = self.table(q.named(self.found, "cam_profile"))
        return [one.key for one in table.columns if one.key not in left]

    @property
    def limited_back(self) -> bool:
        """Whether the pressure angle of the return is limited."""
        return self.cam.back is not None

    @property
    def dwells_curved(self) -> bool:
        """Whether the profile of a cam alone is curved most where the follower stands still."""
        moving = self.found.moving if self.knows("cam_rho_moving") else None
        return moving is not None and moving.value > self.found.least.value * (1 + ALIKE)

    # ------------------------------------------------------------ of a cam alone

    @property
    def parts(self) -> list[int]:
        """Numbers of the phases that are divided into equal parts."""
        return [part.phase + 1 for part in self.found.divided]

    def divisions(self, part: Divided) -> Table:
        """Motion and centre profile, or profile, at the ends of the equal parts of a phase."""
        table, page = self.table(q.named(self.found, "cam_divisions", str(part.phase + 1))), self.page
        curve = ("cam_R_pitch", "cam_delta_pitch") if self.cam.roller else ("cam_R", "cam_delta")
        motion = [one.key for make in q.MOTION_OF if (one := make(self.found)).key in table]
        numbers = [page.cell(table, "part", row, places=0) for row in range(len(table))]
        kind = self.t(q.KINDS[self.found.phases[part.phase].kind])
        caption = self.t(N_("Phase %(number)s, %(kind)s, by equal parts"), number=part.phase + 1, kind=kind)
        columns = [page.column(table, key) for key in ("phi", *motion, *curve)]
        return numeric(caption, Column(self.t("Part"), numbers), columns)

    def leans(self, kind: str) -> bool:
        """Whether the pressure angles of a rise or of a return are told with their signs."""
        return not self.cam.flat and self.knows(f"cam_alpha_{kind}_min")

    # ------------------------------------------------------------ diagrams

    @cached_property
    def diagram(self) -> Graph:
        """Displacement, its derivatives and, where there is one, the pressure angle between its limits over the angle
        turned."""
        drawn = self.found.drawn
        curves = [
            Curve(x, panel=panel, extremes=points(ends))
            for panel, (x, ends) in enumerate(
                zip((drawn.S, drawn.first, drawn.second), self.found.ends, strict=True)
            )
        ]
        named = [make(self.found) for make in (q.displacement, q.first, q.second)]
        if not self.straight:
            limit = np.degrees(self.cam.limit)
            curves.append(Curve(np.degrees(drawn.alpha), panel=3, extremes=self._greatest_angles))
            curves += [
                Curve(np.full_like(drawn.alpha, sign * limit), panel=3, extremes=()) for sign in (1, -1)
            ]
            named.append(q.pressure(self.found))
        graphs = CycleGraphs(drawn.turned, self.found.turn.numbered, self.page.tr)
        return graphs.graph(curves, [graphs.axis(one) for one in named])

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
        return profile.scale(self.found)

    def drawing(self) -> Drawing:
        return profile.drawing(self.found, self._scale)
