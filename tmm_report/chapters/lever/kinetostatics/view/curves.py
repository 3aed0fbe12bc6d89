"""View of the reactions and loads as figures: diagrams over the cycle, hodographs, indicator diagrams."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from markupsafe import Markup

from tmm_report.chapters.lever.kinetostatics.quantities.strokes import WORDS
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import sampled
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.kinetostatics.view.diagrams import graphs_of, reaction_diagrams
from tmm_report.chapters.lever.kinetostatics.view.hodographs import (
    Hodograph,
    Indicated,
    hodographs,
    indicated,
    sheets,
)
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.problems import N_
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import scale_of
from tmm_report.report.page import Page

WAYS = {"forward": N_("on the way from the zero"), "back": N_("on the way back"), **WORDS}


class CurvesView:
    def __init__(self, found: Kinetostatics, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.at = page.once(sampled, found)
        self.graphs = graphs_of(found, self.at, page.tr)

    def conclusions(self) -> Sequence[Markup]:
        return []

    def reactions(self) -> list[Graph]:
        return reaction_diagrams(self.found, self.at, self.graphs, self.page.form.paper.page[1])

    @cached_property
    def hodographs(self) -> list[Hodograph]:
        return hodographs(self.found, self.at, self.graphs, self.page.num)

    def sheets(self) -> list[tuple[Drawing, list[Hodograph]]]:
        return sheets(self.hodographs)

    def scales(self, shown: Sequence[Hodograph]) -> Markup:
        """Of the hodographs of a sheet, each by its pivot."""
        text = N_("%(scale)s of %(reaction)s in pivot %(pair)s")
        return self.page.listed(
            self.t(text, pair=one.pair, reaction=self.page.sym(one.of.sign), scale=self.scale(one.scale))
            for one in shown
        )

    def scale(self, value: float) -> Markup:
        return self.page.value(scale_of("mu_R", value, "N/mm"))

    def indicated(self) -> list[Indicated]:
        return list(indicated(self.found, self.graphs, self.page.num, self._word))

    def _word(self, name: str) -> str:
        return self.page.tr.gettext(WAYS[name]) if name in WAYS else name

    def force_scale(self, one: Indicated) -> Markup:
        """Of a force, or of a moment."""
        name, unit = ("mu_P", "N/mm") if one.of.unit == "N" else ("mu_M", "N·m/mm")
        return self.page.value(scale_of(name, one.scale, unit))

    def symbol(self, one: Indicated | Hodograph) -> Symbol:
        return one.of.sign
