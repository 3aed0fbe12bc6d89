"""View of the motion of output links and driven links: tables, diagrams, analogues, extremes, conclusions."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from markupsafe import Markup

from tmm_report.chapters.lever.initial_data.quantities import speed
from tmm_report.chapters.lever.kinematics import quantities as q
from tmm_report.chapters.lever.kinematics.checks.open_cycle import Gap
from tmm_report.chapters.lever.kinematics.solve.analogues import LAW_ANGLE, analogues_of
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, Output, Travel
from tmm_report.chapters.lever.kinematics.solve.strokes import carried, translating
from tmm_report.chapters.lever.kinematics.solve.working_stroke import Working
from tmm_report.chapters.lever.kinematics.view.diagrams import Diagrams
from tmm_report.mechanics.lever.cycle import larger
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Quantity, Value
from tmm_report.quantity.text import ZERO
from tmm_report.report.chapter_view import BookView
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Cell, Table, packed, worded
from tmm_report.report.part import Failed
from tmm_report.report.words import force_direction

SIDES = {-1: N_("before the jump"), 1: N_("after the jump")}


class MotionView(BookView):
    """`position`: the one of which formulas are written out; `partial`: whether the mechanism closes over part of the
    cycle and is not meant so; `strokes`: working strokes by the names of the outputs."""

    def __init__(
        self, found: Kinematics, position: int, partial: bool, strokes: Mapping[str, Working], page: Page
    ):
        super().__init__(page, page.once(q.book, found))
        self.found, self.position, self.partial, self.strokes = found, position, partial, strokes
        self.diagrams = Diagrams(found, page.tr)

    # ------------------------------------------------------------ conclusions

    def conclusions(self) -> list[Markup]:
        """What failed, then the motion of every output."""
        failed = [self._failed(gap) for gap in self.found.gaps]
        return [*failed, *(self._conclusion(travel) for travel in self.found.travels)]

    def _failed(self, gap: Gap) -> Markup:
        text = N_("The mechanism closes over part of the cycle only: %(why)s.")
        if self.partial:
            text = N_(
                "The mechanism does not make a full cycle: %(why)s. The data of the assignment must be checked."
            )
        return Failed(self.t(text, why=self.page.sentence(gap.text)))

    def _conclusion(self, travel: Travel) -> Markup:
        return self.page.listed([*self.told(travel), *self._greatest(travel)], " ")

    def told(self, travel: Travel) -> Iterator[Markup]:
        """Sentences: the stroke, the working stroke, the ratio of the durations."""
        name = travel.output.name
        if travel.output.kind == "slider":
            yield self.t(
                "The stroke of point %(point)s is %(stroke)s.", point=name, stroke=self.stroke(travel)
            )
        else:
            text = N_("The full angle of swing of link %(link)s is %(stroke)s.")
            yield self.t(text, link=name, stroke=self.stroke(travel))
        yield from self.working(travel)
        if travel.time_ratio is not None:
            ratio = self.page.value(self.value(f"K_{name}").var(digits=4))
            yield self.t("The time ratio of its strokes is %(ratio)s.", ratio=ratio)

    def _greatest(self, travel: Travel) -> Iterator[Markup]:
        """The largest magnitudes of the velocity and of the acceleration, or that there are none."""
        kind, unbounded = travel.output.kind, _unbounded(travel)
        for order, ends in ((1, travel.V_extremes), (2, travel.a_extremes)):
            if order in unbounded:
                continue
            end = "min" if larger(ends) is ends[0] else "max"
            key = f"{'VA'[order - 1]}_{travel.output.name}_{end}"
            if not unbounded and self._nought(2, travel.a_extremes):
                yield self.t(UNIFORM[kind], x=self.number(key, size=True))
                return
            text = GREATEST[kind, order]
            yield self.t(text, x=self.number(key, size=True), at=self.turned(key))
        yield from self._unbounded(travel)

    def _unbounded(self, travel: Travel) -> Iterator[Markup]:
        """That rates grow without bound, those of one output in one sentence."""
        if orders := _unbounded(travel):
            yield self.t(UNBOUNDED[travel.output.kind, orders], name=travel.output.name)

    def _nought(self, order: int, ends: Sequence[Any]) -> bool:
        """Whether a rate is nothing but rounding beside that of the driving link."""
        scale = abs(speed(self.found.linkage.mechanism).value) ** order
        return max(abs(end.value) for end in ends) <= ZERO * max(1.0, scale)

    def sentences(self, travel: Travel) -> list[Markup]:
        """What is told of an output, and of its rates that grow without bound."""
        return [*self.told(travel), *self._unbounded(travel)]

    def unbounded_links(self) -> list[Markup]:
        """Sentences on the rates of the other links that grow without bound."""
        return [text for travel in self.found.links for text in self._unbounded(travel)]

    # ------------------------------------------------------------ outputs

    def has_output(self, kind: str) -> bool:
        return any(travel.output.kind == kind for travel in self.found.travels)

    def ways(self) -> Iterator[Markup]:
        """Which way each slider's displacement is positive."""
        names: dict[Any, list[str]] = {}
        for travel in self.found.travels:
            if travel.output.kind == "slider":
                way = force_direction(travel.output.direction, self.page)
                names.setdefault(way, []).append(travel.output.name)
        for way, those in names.items():
            yield self.page.count(
                "The displacement of point %(name)s is positive when directed %(way)s.",
                "The displacements of points %(name)s are positive when directed %(way)s.",
                len(those),
                name=self.page.listed(those),
                way=way,
            )

    def travels(self, caption: Any) -> Table:
        """φ, t, and S, V, a of the outputs at the table positions."""
        return self._packed(caption, "outputs_table", q.motion_of, self.found.travels, ["phi", "t"])

    def instants(self, caption: Any) -> Table:
        """Motion of the outputs and the driven links at the instants that are asked for."""
        name = "outputs_at"
        keys = [
            [one.key for one in q.motion_of(travel.output)]
            for travel in (*self.found.travels, *self.found.links)
        ]
        groups = [[self.column(name, key) for key in own if key in self.table(name)] for own in keys]
        lead = [self.column(name, key) for key in ("t", LAW_ANGLE) if key in self.table(name)]
        return packed(caption, self.column(name, "phi"), lead, groups)

    def _packed(
        self,
        caption: Any,
        name: str,
        of: Callable[[Output], Sequence[Quantity]],
        travels: Sequence[Travel],
        lead: Sequence[str] = (),
    ) -> Table:
        """A table by positions of what there is `of` every output, after the columns that `lead`."""
        groups = [[self.column(name, one.key) for one in of(travel.output)] for travel in travels]
        return packed(
            caption, self.page.positions(self.table(name)), [self.column(name, key) for key in lead], groups
        )

    def working(self, travel: Travel) -> Iterator[Markup]:
        """From which position to which the working stroke goes, and what says so; nothing without two strokes a
        turn."""
        stroke, name = self.strokes.get(travel.output.name), travel.output.name
        if stroke is None or not stroke.positions:
            return
        positions = list(stroke.positions)
        if self.found.cycle.turns > 1:
            yield self.t(WORKING_OF_SEVERAL[stroke.by], positions=self.page.runs(positions))
            return
        keys = [f"S_{name}_{end}" for end in stroke.ends]
        begin, end = (round(math.degrees(self.value(key).at or 0.0), 1) for key in keys)
        first, last = map(self.turned, keys)
        if end == 0:  # the stroke that ends with the cycle does so at its last angle and position
            last, end = Markup("360"), 360.0
            positions[-1] = positions[-1] or self.found.positions.table
        text = (WORKING if begin < end else WORKING_ROUND)[stroke.by]
        yield self.t(text, first=first, last=last, positions=self.page.runs(positions))

    def stroke(self, travel: Travel) -> Markup:
        return self.sized(f"H_{travel.output.name}")

    def extremes(self, caption: Any, travels: Sequence[Travel]) -> Table:
        rows = []
        for travel in travels:
            for order, quantity, (low, high) in zip(
                range(3), q.motion_of(travel.output), q.extremes(travel), strict=True
            ):
                if order and self._nought(order, (low, high)):
                    continue
                size = max(1.0, abs(low.value), abs(high.value))
                ends = [(self.page.cell(end, scale=size), self._at_side(end)) for end in (low, high)]
                rows.append([self.page.head(quantity.sign, quantity.printed), *ends[0], *ends[1]])
        heads = [
            self.t("Quantity"), self.t("Least value"), self.t("at the angle of rotation,\N{NO-BREAK SPACE}°"),
            self.t("Greatest value"), self.t("at the angle of rotation,\N{NO-BREAK SPACE}°"),
        ]  # fmt: skip
        return worded(caption, heads, rows, (2.2, 2, 2, 2, 2))

    def _at_side(self, value: Value) -> Cell | Markup:
        """The angle of turn at which a value holds, and in a corner the side on which it is reached."""
        at = self.page.turned(value, 2)
        if not value.side:
            return at
        said = SIDES[value.side]
        return self.page.listed([self.page.said(at), self.t(said)], " ")

    # ------------------------------------------------------------ analogues

    @property
    def moving(self) -> tuple[Travel, ...]:
        return (*self.found.travels, *self.found.links)

    def analogues(self, caption: Any) -> Table:
        return self._packed(caption, "analogues_table", analogues_of, self.moving)

    def from_analogues(self) -> list[Formula]:
        """V = S′ω₁ and a = S″ω₁² + S′ε₁ of the first output or link, at the position that is written out."""
        travel, k = self.moving[0], self.position
        rates, outputs = q.motion_of(travel.output)[1:], self.table("outputs_table")
        first, second = (self.table("analogues_table").var(x.key, k) for x in analogues_of(travel.output))
        if self.found.by_law:
            link, rates_table = self.found.linkage.mechanism.driver.link, self.table("rates_table")
            own, epsilon = rates_table.var(f"w_{link}", k), rates_table.var(f"e_{link}", k)
            return [
                outputs.formula(rates[0].key, k, first * own),
                outputs.formula(rates[1].key, k, second * own**2 + first * epsilon),
            ]
        omega = speed(self.found.linkage.mechanism).var(size=True)
        return [
            outputs.formula(rates[0].key, k, first * omega),
            outputs.formula(rates[1].key, k, second * omega**2),
        ]

    # ------------------------------------------------------------ links

    @property
    def links(self) -> tuple[Travel, ...]:
        """Driven links that turn, the rockers among the outputs first."""
        rockers = (travel for travel in self.found.travels if travel.output.kind == "rocker")
        return (*rockers, *self.found.links)

    @property
    def translating(self) -> list[str]:
        """Links that do not turn at any position."""
        return translating(self.found.diagram)

    @property
    def _turning(self) -> set[str]:
        return {travel.output.name for travel in self.links}

    @property
    def carried(self) -> dict[str, str]:
        """Links that turn with another driven link, and with which."""
        found, turning = carried(self.found.linkage), self._turning
        return {link: other for link, other in found.items() if link not in turning and other in turning}

    def angular(self, caption: Any) -> Table:
        """Angles, angular velocities and accelerations of the driven links at the table positions."""
        return self._packed(caption, "outputs_table", q.motion_of, self.links)


def _unbounded(travel: Travel) -> tuple[int, ...]:
    """Orders of the rates that grow without bound: 1 the velocity, 2 the acceleration."""
    rates = ((1, travel.V_extremes), (2, travel.a_extremes))
    return tuple(n for n, ends in rates if not all(math.isfinite(x.value) for x in ends))


GREATEST = {
    ("slider", 1): N_("Its greatest velocity is %(x)s m/s at the angle of rotation %(at)s°."),
    ("slider", 2): N_("Its greatest acceleration is %(x)s m/s² at the angle of rotation %(at)s°."),
    ("rocker", 1): N_("Its greatest angular velocity is %(x)s rad/s at the angle of rotation %(at)s°."),
    ("rocker", 2): N_("Its greatest angular acceleration is %(x)s rad/s² at the angle of rotation %(at)s°."),
}
UNIFORM = {
    "slider": N_("Its velocity is constant, %(x)s m/s."),
    "rocker": N_("Its angular velocity is constant, %(x)s rad/s."),
}
UNBOUNDED = {
    ("slider", (1,)): N_("Towards the limit position the velocity of point %(name)s grows without bound."),
    ("slider", (2,)): N_(
        "Towards the limit position the acceleration of point %(name)s grows without bound."
    ),
    ("slider", (1, 2)): N_(
        "Towards the limit position the velocity and the acceleration of point %(name)s grow without bound."
    ),
    ("rocker", (1,)): N_(
        "Towards the limit position the angular velocity of link %(name)s grows without bound."
    ),
    ("rocker", (2,)): N_(
        "Towards the limit position the angular acceleration of link %(name)s grows without bound."
    ),
    ("rocker", (1, 2)): N_(
        "Towards the limit position the angular velocity and acceleration of link %(name)s grow without bound."
    ),
}
WORKING = {
    "load": N_(
        "Its working stroke, in which the stated load does its work, lasts from the angle of rotation %(first)s° "
        "to %(last)s° (positions %(positions)s)."
    ),
    "longer": N_(
        "Its working stroke, the longer-lasting one, lasts from the angle of rotation %(first)s° to %(last)s° "
        "(positions %(positions)s)."
    ),
}
WORKING_ROUND = {
    "load": N_(
        "Its working stroke, in which the stated load does its work, lasts from the angle of rotation %(first)s° "
        "over the end of the cycle to %(last)s° (positions %(positions)s)."
    ),
    "longer": N_(
        "Its working stroke, the longer-lasting one, lasts from the angle of rotation %(first)s° over the end of "
        "the cycle to %(last)s° (positions %(positions)s)."
    ),
}
WORKING_OF_SEVERAL = {
    "load": N_(
        "Its working stroke, in which the stated load does its work, goes through positions %(positions)s."
    ),
    "longer": N_("Its working stroke, the longer-lasting one, goes through positions %(positions)s."),
}
