"""Views of the wear: what stands before the pairs, and each guide with its slider."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.wear import draw
from tmm_report.chapters.machine.wear.formulas import GuideFormulas
from tmm_report.chapters.machine.wear.guide import FACES, GuideFound
from tmm_report.chapters.machine.wear.pivot_view import PivotView
from tmm_report.chapters.machine.wear.quantities import face_word, guides, pivots, side_index
from tmm_report.chapters.machine.wear.solve import Found
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.formula import Formula
from tmm_report.quantity.model import Table as Numbers
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs, plot
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, Words, numeric, worded
from tmm_report.report.part import Part

ROWS = 21  # of a printed profile: the whole stands in the results
ANGLES = 13  # of the printed cycle
SIDE_WORDS = {"guide": N_("guide"), "slider": N_("slider")}
CAUSE_WORDS = {"force": N_("reaction"), "couple": N_("its moment")}


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/wear", WearView(found, page), concludes=False)
    for prefix, guide in guides(found):
        yield Part("machine/wear/guide", GuideView(guide, prefix, page))
    for prefix, pivot in pivots(found):
        yield Part("machine/wear/pivot", PivotView(pivot, prefix, page))


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


class GuideView(GuideFormulas):
    def __init__(self, found: GuideFound, prefix: str, page: Page):
        super().__init__(found, prefix)
        self.page, self.t = page, page.t

    def conclusions(self) -> Sequence[Markup]:
        text = N_("The guide %(name)s and its slider wear by up to %(depth)s µm after %(cycles)s cycles.")
        values = {"depth": self.number("greatest", "µm", digits=4), "cycles": self.number("cycles")}
        return [self.t(text, name=self.found.given.guide, **values)]

    # --- words

    @property
    def label(self) -> str:
        return self.prefix.replace("_", ":")

    def number(self, key: str, unit: str = "", **form: Any) -> Markup:
        return self.page.shown(self.of[key], unit=unit, **form)

    def sized(self, key: str, unit: str = "") -> Markup:
        return self.page.value(self.v(key, unit))

    def face(self, name: str) -> Markup:
        return self.t(face_word(self.found, name))

    def given_values(self) -> Markup:
        units = {"slider": "mm", "width": "mm", "cycles": "", "parts": "", "period": ""}
        return self.page.listed(self.sized(key, unit) for key, unit in units.items())

    def where(self, *formulas: Formula) -> list[dict[str, Any]]:
        """Symbols of the wear are its own."""
        return [{**item, "id": ("wear", item["id"])} for item in self.page.where(*formulas)]

    def at_angle(self) -> Markup:
        """Where the couple is greatest."""
        at = int(np.argmax(self.found.couple))
        return self.page.value(self.cycle.var("phi", at, "deg"))

    # --- tables

    def _picked(self, table: Numbers, key: str, rows: np.ndarray, unit: str = "", **form: Any) -> Column:
        column = self.page.column(table, key, unit, **form)
        return column._replace(cells=[column.cells[row] for row in rows])

    def surface_table(self, caption: Any) -> Table:
        table, page = self.surfaces, self.page
        units = {"pressure": "MPa", "k": "", "c": "", "rubbed": "", "depth": "µm", "volume": "mm³"}
        heads = [page.t("Face"), page.t("Cause")]
        heads += [page.head(table[key].quantity.sign, unit or table[key].unit) for key, unit in units.items()]
        rows = [self._surface(row, units) for row in range(len(table))]
        return worded(caption, heads, rows, (4, 3, 2, 3, 3, 2, 2, 2))

    def _surface(self, row: int, units: dict[str, str]) -> list[Any]:
        table = self.surfaces
        one = self.found.surface(table["side"].values[row], table["face"].values[row])
        words = {"side": self.t(SIDE_WORDS[one.side]), "face": self.face(one.face)}
        symbol = self.page.sym(Symbol("u", side_index(one)))
        name = self.t(N_("%(symbol)s: %(side)s, %(face)s"), symbol=symbol, **words)
        word = CAUSE_WORDS[table["cause"].values[row]]
        cause = Words(self.t(word), table.ref("cause", row))
        cells = [self.page.cell(table, key, row, unit, digits=4) for key, unit in units.items()]
        return [Words(name, table.ref("face", row)), cause, *cells]

    def guide_table(self, caption: Any) -> Table:
        rows = _every(len(self.profile), ROWS)
        first = self._picked(self.profile, "point", rows, digits=1)
        keys = ["x", *(f"u_{cause}_{face}" for face in FACES for cause in ("force", "couple"))]
        keys[3:3], keys[6:6] = ["u_lower"], ["u_upper"]
        columns = [self._picked(self.profile, key, rows, "mm" if key == "x" else "µm") for key in keys]
        columns.append(self._picked(self.profile, "resistance", rows))
        return numeric(caption, first, columns)

    def slider_table(self, caption: Any) -> Table:
        table = self.of.table("sole")
        rows = _every(len(table), ROWS)
        first = self._picked(table, "point", rows, digits=1)
        keys = [
            "xi",
            "u_force_lower",
            "u_couple_lower",
            "u_lower",
            "u_force_upper",
            "u_couple_upper",
            "u_upper",
        ]
        return numeric(
            caption, first, [self._picked(table, key, rows, "mm" if key == "xi" else "µm") for key in keys]
        )

    def cycle_table(self, caption: Any) -> Table:
        count = len(self.cycle)
        rows = np.unique(np.arange(ANGLES - 1) * count // (ANGLES - 1))
        units = {"S": "mm", "start": "", "q": "", "R": "", "M": "", "h": "mm", "shift": "µm", "tilt": "deg"}
        first = self._picked(self.cycle, "phi", rows, "deg", digits=4)
        columns = [
            self._picked(self.cycle, key, rows, unit, digits=1 if key == "start" else 5)
            for key, unit in units.items()
        ]
        return numeric(caption, first, columns)

    # --- figures

    @cached_property
    def loading(self) -> Drawing:
        return draw.loading(self.found)

    @cached_property
    def guide_graph(self) -> Graph:
        return self._worn(self.profile, "x", "guide")

    @cached_property
    def slider_graph(self) -> Graph:
        return self._worn(self.of.table("sole"), "xi", "slider")

    def _worn(self, table: Numbers, along: str, side: str) -> Graph:
        """Both faces: with and without skew."""
        names = {"u_": self.t("with skew"), "u_force_": self.t("without skew")}
        drawn = [
            Curve(table[start + face].numbers("µm"), str(name), panel, () if start != "u_" else None)
            for panel, face in enumerate(FACES)
            for start, name in names.items()
        ]
        of = [(Symbol("u", side_index(self.found.surface(side, face))), "µm") for face in FACES]
        x = table[along]
        place = type(x.quantity)(x.key, x.quantity.symbol, "mm", x.meaning)
        return plot(drawn, x.numbers("mm"), place, of, self.page.tr)

    @cached_property
    def settled_graph(self) -> Graph:
        """Displacement and tilt of the worn slider over the cycle."""
        turned = np.append(self.found.turned, self.found.turned[0] + len(self.found.turned) * self.found.step)
        graphs = CycleGraphs(turned, 0, self.page.tr)
        units = {"shift": "µm", "tilt": "deg"}
        drawn = [
            Curve(np.append(line := self.cycle[key].numbers(unit), line[0]), panel=k)
            for k, (key, unit) in enumerate(units.items())
        ]
        labels = [graphs.letter(self.cycle[key].symbol(), unit) for key, unit in units.items()]
        return graphs.graph(drawn, labels, join=False)

    @cached_property
    def stage_graph(self) -> Graph:
        table = self.of.table("stages")
        line = [Curve(table["u"].numbers("µm"), extremes=())]
        return plot(line, table["t"].numbers(), table["t"].quantity, [(Symbol("u"), "µm")], self.page.tr)
