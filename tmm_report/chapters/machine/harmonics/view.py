"""View of harmonics of the motion of points and links."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.harmonics import quantities
from tmm_report.chapters.machine.harmonics.draw import field, turns
from tmm_report.chapters.machine.harmonics.equations import rod
from tmm_report.chapters.machine.harmonics.solve import Found, Signal, Wave
from tmm_report.chapters.machine.harmonics.values import Columns, Rod, check, wave_amplitude
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.calculus.harmonics import Series
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.report.chapter_view import ChapterView
from tmm_report.report.diagrams import CycleGraphs, Line, chart
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric, worded
from tmm_report.report.part import Part


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/harmonics", HarmonicsView(found, page))


class HarmonicsView(ChapterView):
    def __init__(self, found: Found, page: Page):
        super().__init__(page, found.s, quantities.tables(found), "")
        self.found = found

    def conclusions(self) -> list[Markup]:
        signals = self.found.signals
        if not signals:
            return []
        worst = int(np.argmax([signal.left for signal in signals]))
        text = N_(
            "Harmonics up to order %(order)s leave at most %(left)s %% of the motion of the outputs (%(motion)s)."
        )
        left = self.page.shown(self.table("harmonics_left"), "left", worst, places=2)
        motion = self.page.sym(signals[worst].of.sign)
        return [self.t(text, order=self.found.given.highest, left=left, motion=motion)]

    @property
    def exact(self) -> bool:
        """Whether the samples miss nothing but rounding."""
        return self.s.number("tail") <= 1e-12

    # ------------------------------------------------------------ outputs and points

    def harmonics(self, caption: Any, name: str, start: str = "", **first: Any) -> Table:
        """Amplitudes and phases, of the columns whose keys begin so."""
        table = self.table(name)
        own, *others = table.columns
        cells = [self.page.cell(table, own.key, row, **first) for row in range(len(table))]
        columns = [self._column(name, one.key) for one in others if one.key.startswith(start)]
        return numeric(caption, Column(self.page.sym(own.symbol()), cells), columns)

    def _column(self, name: str, key: str) -> Column:
        """Phases with two decimals."""
        if not key.startswith("alpha"):
            return self.column(name, key)
        table = self.table(name)
        cells = [self.page.cell(table, key, row, places=2) for row in range(len(table))]
        return Column(self.page.head(table[key].symbol(), table[key].quantity.printed), cells)

    def left(self, caption: Any) -> Table:
        table, page = self.table("harmonics_left"), self.page
        left = page.head(table["left"].symbol(), table["left"].quantity.printed)
        rows = [
            [page.sym(one.of.sign), page.cell(table, "main", row), page.cell(table, "left", row, places=3)]
            for row, one in enumerate(self.found.signals)
        ]
        heads = [self.t("Motion"), self.t("Order of the largest harmonic"), left]
        return worded(caption, heads, rows, (2, 3, 2))

    @cached_property
    def drawn(self) -> Signal | None:
        """The acceleration of the first output, the motion with the strongest harmonics; else the first of all."""
        rates = [signal for signal in self.found.signals if signal.kind == "a"]
        return next(iter((*rates, *self.found.signals)), None)

    def sums(self, signal: Signal) -> Graph:
        """A motion and the sums of its first harmonics."""
        found = self.found.kinematics
        count = round(found.positions.table * 2 * np.pi / found.cycle.sweep)  # of a turn
        graphs = CycleGraphs(np.append(self.found.turned, 2 * np.pi), count, self.page.tr)
        orders = sorted({1, min(2, self.found.given.highest), self.found.given.highest})
        curves = [Curve(np.append(signal.samples, signal.samples[0]), self.page.tr.gettext("exact"), 0, ())]
        for order in orders:
            upto = Series(signal.series.cosine[: order + 1], signal.series.sine[: order + 1])
            curves.append(Curve(upto.at(graphs.turned), f"k ≤ {order}", 0, ()))
        return graphs.graph(curves, [graphs.letter(signal.of.sign, signal.of.unit)])

    # ------------------------------------------------------------ waves

    def amplitudes(self, wave: Wave) -> Graph:
        """Amplitudes along the link, a panel for x and one for y."""
        table = self.table(f"wave_{wave.link}")
        lines = [
            Line(table[wave_amplitude(axis, k).key], str(k), panel)
            for panel, axis in enumerate("xy")
            for k in range(1, min(5, self.found.given.highest) + 1)
        ]
        return chart(lines, table["xi"], [wave_amplitude(axis, "") for axis in "xy"], self.page.tr)

    def rod(self, wave: Wave) -> list[Definition]:
        """Place of a point of the rod in the axes of the guide."""
        return rod(self.found, wave)

    def rod_letters(self) -> list[dict[str, Any]]:
        return [self.page.explained(f"rod {key}", of.column(()), of.unit) for key, of in Rod.DECLARED.items()]

    def worst(self, wave: Wave) -> Markup:
        """Of the amplitudes by these formulas."""
        assert wave.check is not None
        return self.page.bound(check(wave.link).value(wave.check))

    def turns(self, wave: Wave) -> bool:
        """Whether the motion differs along the link, so that it has a field."""
        return turns(wave)

    def field(self, wave: Wave, axis: str) -> Drawing:
        graphs = CycleGraphs(self.found.turned, 0, self.page.tr)
        along, place = (
            graphs.letter(of.sign, of.printed) for of in (Columns.phi.quantity, Columns.xi.quantity)
        )
        return field(wave, axis, (along, place), self.page.num)
