"""Views of the wear: what stands before the pairs, and each guide with its slider."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.wear import draw, equations
from tmm_report.chapters.machine.wear.guide import CAUSES, FACES, GuideFound
from tmm_report.chapters.machine.wear.pivot_view import PairView, PivotView
from tmm_report.chapters.machine.wear.quantities import guide_tables
from tmm_report.chapters.machine.wear.solve import Found
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Formula
from tmm_report.report.diagrams import CycleGraphs, Line, chart
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, Words, numeric, worded
from tmm_report.report.part import Part

ROWS = 21  # of a printed profile: the whole stands in the results
ANGLES = 13  # of the printed cycle
CYCLE = ("S", "start", "q", "R", "M", "h", "shift", "tilt")  # its printed columns
SIDE_WORDS = {"guide": N_("guide"), "slider": N_("slider")}
CAUSE_WORDS = {"force": N_("reaction"), "couple": N_("its moment")}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/wear", WearView(found, page), concludes=False)
    for guide in found.guides:
        yield Part("machine/wear/guide", GuideView(guide, page))
    for pivot in found.pivots:
        yield Part("machine/wear/pivot", PivotView(pivot, page))


def picture(found: Found, page: Page) -> Drawing:
    """A slider as it is loaded, or a worn pivot."""
    return draw.loading(found.guides[0]) if found.guides else draw.worn(found.pivots[0])


class WearView:
    """What is said before the pairs."""

    def __init__(self, found: Found, page: Page):
        self.found, self.page, self.t = found, page, page.t

    def conclusions(self) -> Sequence[Markup]:
        return ()


def _every(count: int, rows: int) -> np.ndarray:
    """Numbers of rows evenly among `count`, the first and the last among them."""
    return np.unique(np.rint(np.linspace(0, count - 1, min(rows, count))).astype(int))


class GuideView(PairView):
    def __init__(self, found: GuideFound, page: Page):
        super().__init__(page, found.s, guide_tables(found))
        self.found = found

    def conclusions(self) -> Sequence[Markup]:
        text = N_("Guide %(name)s and its slider wear by up to %(depth)s µm after %(cycles)s cycles.")
        return [self.worn_by(text, self.found.given.guide)]

    # --- words

    def face(self, name: str) -> Markup:
        return self.t(self.found.word(name))

    def given_values(self) -> Markup:
        return self.listed(("slider", "width", "cycles", "parts", "period"))

    def at_angle(self) -> Markup:
        """Where the couple is greatest."""
        return self.page.value(self.table("cycle").var("phi", self.found.skewest, "deg"))

    def cycle_symbols(self) -> list[dict[str, Any]]:
        """What the table of the cycle shows."""
        columns = [self.of("cycle", key) for key in CYCLE]
        return [self.page.explained(f"{self.label}{one.key}", one, one.quantity.printed) for one in columns]

    # --- formulas

    def places(self) -> list[Definition]:
        return equations.places(self.found)

    def pressures(self) -> list[Definition]:
        return equations.pressures(self.found)

    def couple(self) -> Formula:
        return equations.couple(self.found, self.table("cycle"))

    def shares(self) -> list[Definition]:
        return equations.shares(self.found)

    def sums(self) -> list[Definition]:
        return equations.sums(self.found)

    def coefficients(self) -> list[Formula]:
        return equations.coefficients(self.found, self.table("surfaces"))

    def deepest(self) -> Formula:
        return equations.deepest(self.found, self.table("surfaces"), self.table("profile"))

    def volumes(self) -> list[Formula]:
        return equations.volumes(self.found, self.table("surfaces"))

    def stages(self) -> Definition:
        return equations.stages(self.found, self.table("stages"))

    # --- tables

    def _picked(self, name: str, key: str, rows: np.ndarray, **form: Any) -> Column:
        column = self.column(name, key, **form)
        return column._replace(cells=[column.cells[row] for row in rows])

    def surface_table(self, caption: Any) -> Table:
        table, page = self.table("surfaces"), self.page
        columns = [table[key] for key in ("pressure", "k", "c", "rubbed", "depth", "volume")]
        heads = [page.t("Face"), page.t("Cause")]
        heads += [page.head(one.quantity.sign, one.quantity.printed) for one in columns]
        rows = [
            [*self._surface(row), *(page.cell(table, one.key, row, digits=4) for one in columns)]
            for row in range(len(table))
        ]
        return worded(caption, heads, rows, (4, 3, 2, 3, 3, 2, 2, 2))

    def _surface(self, row: int) -> list[Words]:
        table = self.table("surfaces")
        one = self.found.surface(table["side"].values[row], table["face"].values[row])
        words = {"side": self.t(SIDE_WORDS[one.side]), "face": self.face(one.face)}
        name = self.t(N_("%(symbol)s: %(side)s, %(face)s"), symbol=self.page.sym(one.symbol), **words)
        word = CAUSE_WORDS[table["cause"].values[row]]
        return [Words(name, table.ref("face", row)), Words(self.t(word), table.ref("cause", row))]

    def guide_table(self, caption: Any) -> Table:
        return self._points(caption, "profile", "x", "resistance")

    def slider_table(self, caption: Any) -> Table:
        return self._points(caption, "sole", "xi")

    def _points(self, caption: Any, name: str, place: str, *more: str) -> Table:
        """Wear of some points: by each cause and in all, face by face."""
        rows = _every(len(self.table(name)), ROWS)
        depths = [f"u_{cause}{face}" for face in FACES for cause in (*(f"{one}_" for one in CAUSES), "")]
        columns = [self._picked(name, key, rows) for key in (place, *depths, *more)]
        return numeric(caption, self._picked(name, "point", rows, digits=1), columns)

    def cycle_table(self, caption: Any) -> Table:
        count = len(self.table("cycle"))
        rows = np.unique(np.arange(ANGLES - 1) * count // (ANGLES - 1))
        first = self._picked("cycle", "phi", rows, digits=4)
        columns = [self._picked("cycle", key, rows, digits=1 if key == "start" else 5) for key in CYCLE]
        return numeric(caption, first, columns)

    # --- figures

    @cached_property
    def loading(self) -> Drawing:
        return draw.loading(self.found)

    @cached_property
    def guide_graph(self) -> Graph:
        return self._worn("profile", "x")

    @cached_property
    def slider_graph(self) -> Graph:
        return self._worn("sole", "xi")

    def _worn(self, name: str, along: str) -> Graph:
        """Both faces: with and without skew."""
        names = {"u_": self.t("with skew"), "u_force_": self.t("without skew")}
        lines = [
            Line(self.of(name, start + face), str(word), panel, () if start != "u_" else None)
            for panel, face in enumerate(FACES)
            for start, word in names.items()
        ]
        of = [self.of(name, f"u_{face}").quantity for face in FACES]
        return chart(lines, self.of(name, along), of, self.page.tr)

    @cached_property
    def settled_graph(self) -> Graph:
        """Displacement and tilt of the worn slider over the cycle, which begins again at its end."""
        turned = self.found.turned
        graphs = CycleGraphs(np.append(turned, turned[0] + len(turned) * self.found.step), 0, self.page.tr)
        of = [self.of("cycle", key) for key in ("shift", "tilt")]
        lines = [one.numbers(one.quantity.printed) for one in of]
        drawn = [Curve(np.append(line, line[0]), panel=k) for k, line in enumerate(lines)]
        labels = [graphs.letter(one.symbol(), one.quantity.printed) for one in of]
        return graphs.graph(drawn, labels, join=False)

    @cached_property
    def stage_graph(self) -> Graph:
        depth = self.of("stages", "u")
        return chart([Line(depth)], self.of("stages", "t"), [depth.quantity], self.page.tr)
