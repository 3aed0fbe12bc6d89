"""View of the mechanism balanced on its foundation."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.balancing.draw import fitted, hodographs, scale, seen
from tmm_report.chapters.machine.balancing.draw_moment import antiphase, geared
from tmm_report.chapters.machine.balancing.solve.cases import Case
from tmm_report.chapters.machine.balancing.solve.whole import Found
from tmm_report.chapters.machine.balancing.values import Shaking, Values
from tmm_report.chapters.machine.balancing.view.slider_crank import SliderView
from tmm_report.chapters.machine.balancing.view.tables import BalancingSheet
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts
from tmm_report.problems import N_
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs, scale_of
from tmm_report.report.page import Page
from tmm_report.report.part import Part

MOST = 5  # curves that are told apart in one drawing


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/balancing", BalancingView(found, page))
    for k, crank in enumerate(found.cranks):
        if crank.mass:
            yield Part("machine/balancing/slider", SliderView(found, k, page))


class BalancingView(BalancingSheet):
    @property
    def meshed(self) -> bool:
        """Whether links are in mesh."""
        return bool(self.found.kinematics.linkage.mechanism.meshes)

    def conclusions(self) -> list[Markup]:
        best = self.found.best()
        if best is None:
            return []
        number = self.found.every.index(best)
        text = N_(
            "The greatest shaking force of the mechanism is %(force)s N; the way “%(way)s” leaves %(left)s N of it."
        )
        if self.found.complete(best):
            text = N_(
                "The greatest shaking force of the mechanism is %(force)s N; the way “%(way)s” balances it fully."
            )
        of, left = self._peak(0), self._peak(number)
        told = [self.t(text, force=of, way=self.way(best), left=left)]
        return [*told, *self._of_moment()]

    def _of_moment(self) -> Iterator[Markup]:
        """What the last way against the moment leaves of it."""
        last = self.found.cases[-1]
        if (first := self.first_against) is None or first.base is None:
            return
        every = self.found.every
        before, after, left = (self.moment_max(every.index(one)) for one in (every[0], first.base, last))
        if first.base is self.found.original:
            text = N_(
                "The greatest shaking moment of the mechanism is %(before)s N·m; way %(n)s leaves %(left)s N·m."
            )
            yield self.t(text, before=before, n=every.index(last), left=left)
        else:
            text = N_(
                "The greatest shaking moment of the mechanism is %(before)s N·m; way %(m)s changes it to "
                "%(after)s N·m, and way %(n)s to %(left)s N·m."
            )
            numbers = {"m": every.index(first.base), "n": every.index(last)}
            yield self.t(text, before=before, after=after, left=left, **numbers)

    def _peak(self, number: int) -> Markup:
        table = self.table("balancing_cases")
        return self.page.shown(table, "F_max", number, scale=self.found.original.force_max.value)

    # ------------------------------------------------------------ words

    def number_of(self, case: Case) -> int:
        return self.found.every.index(case)

    def unreached(self) -> str:
        return ", ".join(self.found.unreached)

    def unmet(self) -> str:
        return ", ".join(self.found.substituted.unmet)

    @property
    def off_line(self) -> bool:
        """Whether a floating link has its mass centre beside the line of its joints."""
        return any(one.off for one in self.found.substituted.splits)

    @property
    def single(self) -> bool:
        """Whether an optimum counterweight on the driving link is among the ways."""
        return any(case.name.startswith("optimum") for case in self.found.cases)

    # ------------------------------------------------------------ drawings

    @cached_property
    def drawn(self) -> list[tuple[int, Case]]:
        """The ways whose hodographs can be told apart: without those that leave nothing, and without repetitions."""
        found: list[tuple[int, Case]] = [(0, self.found.original)]
        size = self.found.original.force_max.value
        for number, case in enumerate(self.found.cases, 1):
            fresh = all(np.abs(case.cycle.force - one.cycle.force).max() > 1e-3 * size for _, one in found)
            if fresh and not self.found.complete(case) and len(found) < MOST:
                found.append((number, case))
        return found

    @cached_property
    def shown_case(self) -> Case | None:
        """The first way with counterweights: the one that is drawn."""
        return next((case for case in self.found.cases if case.placed), None)

    @cached_property
    def scale(self) -> float:
        """m/mm: of the drawing with the counterweights."""
        return scale(self.found)

    @cached_property
    def fitted(self) -> Drawing | None:
        """The way that is drawn."""
        return fitted(self.found, self.shown_case, self.position, self.scale) if self.shown_case else None

    def fitted_scale(self) -> Markup | None:
        """Of that drawing; None where it is made smaller to fit the page."""
        if self.fitted is None or self.page.percent(self.fitted) != 100:
            return None
        return self.page.value(scale_of("mu_l", self.scale, "m/mm"))

    def geared_scheme(self, case: Case) -> Drawing:
        return geared(self.found, case, self.position, self.scale)

    def antiphase_scheme(self, case: Case) -> Drawing:
        return antiphase(self.found, case, self.position)

    @cached_property
    def hodographs(self) -> Drawing:
        labels = self._components(*Shaking.F_shake.quantity.components)
        return hodographs(self.found, self.drawn, labels, self.page.num)

    @cached_property
    def seen(self) -> Drawing:
        labels = self._components(Values.seen_x.quantity, Values.seen_y.quantity)
        return seen(self.found, labels, self.page.num)

    def _components(self, x: Quantity, y: Quantity) -> tuple[Parts, Parts]:
        """Letters and units of what both axes of a hodograph show."""
        along, across = (
            self._graphs.letter(Symbol(of.sign.base, sup=of.sign.sup), of.printed) for of in (x, y)
        )
        return along, across

    @cached_property
    def diagram(self) -> Graph:
        """Size of the force and the moment over the cycle, by the numbers of the ways."""
        curves = list(self._curves())
        labels = [self._graphs.label(of.quantity) for of in (Shaking.F_shake, Shaking.M_shake)]
        return self._graphs.graph(curves, labels, join=False)

    def _curves(self) -> Iterator[Curve]:
        size = self.found.original.force_max.value
        for number, case in self.drawn:
            yield Curve(np.abs(case.diagram.force), str(number), 0, (), size)
        moments = list(self._moment_curves())
        for numbers, case in moments:
            yield Curve(case.diagram.moment, ", ".join(map(str, numbers)), 1, ())

    def _moment_curves(self) -> Iterator[tuple[Sequence[int], Case]]:
        """Ways with the same moment are one curve."""
        found: list[tuple[list[int], Case]] = []
        size = max(case.moment_max.value for case in self.found.every)
        for number, case in enumerate(self.found.every):
            alike = (
                one for one in found if np.abs(one[1].cycle.moment - case.cycle.moment).max() <= 1e-9 * size
            )
            if (same := next(alike, None)) is not None:
                same[0].append(number)
            elif len(found) < MOST:
                found.append(([number], case))
        yield from found

    @cached_property
    def _graphs(self) -> CycleGraphs:
        kinematics = self.found.kinematics
        return CycleGraphs(kinematics.diagram_turned, kinematics.positions.table, self.page.tr)
