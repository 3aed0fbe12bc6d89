"""View of harmonics of the motion of points and links."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from markupsafe import Markup

from tmm_report.chapters.machine.harmonics import quantities as q
from tmm_report.chapters.machine.harmonics.draw import field, turns
from tmm_report.chapters.machine.harmonics.solve import Found, Signal, Wave
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.drawing import Drawing
from tmm_report.mechanics.calculus.harmonics import Series
from tmm_report.problems import N_
from tmm_report.quantity.definition import Definition
from tmm_report.quantity.formula import Var, cos, sin, sqrt
from tmm_report.quantity.model import Book
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs, plot
from tmm_report.report.page import Page
from tmm_report.report.paper.layout import Column, Table, numeric, worded
from tmm_report.report.part import Part


def parts(found: Found, page: Page) -> Iterator[Part]:
    yield Part("machine/harmonics", HarmonicsView(found, page))


class HarmonicsView:
    def __init__(self, found: Found, page: Page):
        self.found, self.page, self.t = found, page, page.t
        self.book = Book.of(q.tables(found), q.values(found))

    def conclusions(self) -> list[Markup]:
        if not self.found.signals:
            return []
        worst = int(np.argmax([signal.left for signal in self.found.signals]))
        text = N_(
            "Harmonics up to order %(order)s leave at most %(left)s %% of the motion of the outputs (%(motion)s)."
        )
        table = self.book.tables["harmonics_left"]
        left = self.page.shown(table, "left", worst, "%", places=2)
        return [
            self.t(
                text, order=self.found.given.highest, left=left, motion=self.motion(self.found.signals[worst])
            )
        ]

    def motion(self, signal: Signal) -> Markup:
        """The symbol of a motion."""
        return self.page.sym(Symbol(q.LETTERS[signal.kind][signal.rocker], signal.name))

    def value(self, key: str, **form: Any) -> Markup:
        return self.page.shown(self.book[key], **form)

    @property
    def exact(self) -> bool:
        """Whether the samples miss nothing but rounding."""
        return self.found.tail <= 1e-12

    # ------------------------------------------------------------ outputs and points

    def content(self, caption: Any) -> Table:
        table, page = self.book.tables["harmonic_content"], self.page
        orders = [page.cell(table, "order", row) for row in range(len(table))]
        columns = [self._column(table, column.key) for column in table.columns[1:]]
        return numeric(caption, Column(page.sym("k"), orders), columns)

    def _column(self, table: Any, key: str) -> Column:
        unit = "mm" if table[key].unit == "m" else "deg" if table[key].unit == "rad" else ""
        if not key.startswith("alpha"):
            return self.page.column(table, key, unit)
        head = self.page.head(table[key].symbol(), "°")
        cells = [self.page.cell(table, key, row, places=2) for row in range(len(table))]
        return Column(head, cells)

    def left(self, caption: Any) -> Table:
        table, page = self.book.tables["harmonics_left"], self.page
        heads = [
            self.t("Motion"),
            self.t("Order of the largest harmonic"),
            page.head(table["left"].symbol(), "%"),
        ]
        rows = [
            [
                self.motion(signal),
                page.cell(table, "main", row),
                page.cell(table, "left", row, "%", places=3),
            ]
            for row, signal in enumerate(self.found.signals)
        ]
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
        theta = graphs.turned
        orders = sorted({1, min(2, self.found.given.highest), self.found.given.highest})
        curves = [Curve(np.append(signal.samples, signal.samples[0]), self.page.tr.gettext("exact"), 0, ())]
        for order in orders:
            upto = Series(signal.series.cosine[: order + 1], signal.series.sine[: order + 1])
            curves.append(Curve(upto.at(theta), f"k ≤ {order}", 0, ()))
        unit = q.UNITS[signal.kind][signal.rocker]
        return graphs.graph(
            curves, [graphs.letter(Symbol(q.LETTERS[signal.kind][signal.rocker], signal.name), unit)]
        )

    # ------------------------------------------------------------ waves

    def wave_amplitudes(self, caption: Any, wave: Wave) -> Table:
        return self._wave(caption, wave, "A_")

    def wave_phases(self, caption: Any, wave: Wave) -> Table:
        return self._wave(caption, wave, "alpha_")

    def _wave(self, caption: Any, wave: Wave, prefix: str) -> Table:
        table, page = self.book.tables[f"wave_{wave.link}"], self.page
        xi = [page.cell(table, "xi", row, places=3) for row in range(len(table))]
        keys = [column.key for column in table.columns if column.key.startswith(prefix)]
        columns = [self._column(table, key) for key in keys]
        return numeric(caption, Column(page.sym("xi"), xi), columns)

    def amplitudes(self, wave: Wave) -> Graph:
        """Amplitudes along the link, a panel for x and one for y."""
        curves = [
            Curve(1e3 * part.amplitude[:, k], str(k), panel, ())
            for panel, part in enumerate((wave.x, wave.y))
            for k in range(1, min(5, self.found.given.highest) + 1)
        ]
        panels: Sequence[tuple[Symbol, str]] = ((Symbol("A", "x"), "mm"), (Symbol("A", "y"), "mm"))
        return plot(curves, wave.xi, q.XI, panels, self.page.tr)

    def rod(self, wave: Wave) -> list[Definition]:
        """Place of a point of the rod in the axes of the guide."""
        r, length, e, phi, xi = (Var(name, 0.0) for name in ("r", "l", "e", "phi", "xi"))
        central = wave.crank is not None and wave.crank.central
        across = r * sin(phi) if central else r * sin(phi) - e
        y = (1 - xi) * r * sin(phi)
        x = r * cos(phi) + xi * sqrt(length**2 - across**2)
        return [Definition("x", x), Definition("y", y if central else y + xi * e)]

    def turns(self, wave: Wave) -> bool:
        """Whether the motion differs along the link, so that it has a field."""
        return turns(wave)

    def field(self, wave: Wave, axis: str) -> Drawing:
        return field(wave, axis, self.page.num)
