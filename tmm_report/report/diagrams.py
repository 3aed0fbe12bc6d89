"""Diagrams over the cycle of a lever mechanism, and over any other quantity: what all chapters that draw them share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.figures.axes import round_ticks
from tmm_report.figures.graphs import Curve, Graph, graph
from tmm_report.i18n import Translator
from tmm_report.mechanics.cycle import Extreme
from tmm_report.quantity.formula import Var
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import GREEK, Symbol
from tmm_report.quantity.text import unit_text

Array = Any


class CycleGraphs:
    """`turned`: angles of the diagram positions, rad; `positions`: how many are numbered on the axis."""

    def __init__(self, turned: Array, positions: int, tr: Translator):
        self.turned, self.positions, self.tr = turned, positions, tr

    def graph(self, curves: Sequence[Curve], labels: Sequence[str], join: bool = True) -> Graph:
        degrees = np.degrees(self.turned)
        turns = max(1, round(float(degrees[-1] - degrees[0]) / 360))
        return graph(
            curves, degrees, f"φ, {unit_text('deg', self.tr.language)}", labels,
            step=30.0 * turns, positions=self.positions, comma=self.tr.decimal == ",", join=join,
        )  # fmt: skip

    def label(self, quantity: Quantity, unit: str = "") -> str:
        """The letter of a quantity and its unit, for an axis: the figure's caption says of what."""
        return self.letter(Symbol(quantity.sign.base), unit or quantity.unit)

    def letter(self, symbol: Symbol, unit: str) -> str:
        """A symbol as plain text and its unit."""
        text = GREEK.get(symbol.base, symbol.base) + self.tr.pgettext("index", symbol.sub)
        return f"{text}, {unit_text(unit, self.tr.language)}" if unit else text

    def scales(self, drawn: Graph, names: Sequence[tuple[str, str]]) -> list[Var]:
        """What 1 mm along the axis of the angle and along the axis of each panel stands for."""
        found = [scale_of("mu_phi", drawn.panels[0].x_scale, "°/mm")]
        for (name, unit), panel in zip(names, drawn.panels, strict=True):
            found.append(scale_of(name, panel.y_scale, unit))
        return found


def plot(
    curves: Sequence[Curve], x: Array, along: Quantity, of: Sequence[tuple[Symbol, str]], tr: Translator
) -> Graph:
    """Curves over any ascending quantity `along`, (P,) in its unit: the time, the speed, a frequency. `of`: symbol and
    unit of each panel, from the top."""
    letters = CycleGraphs(x, 0, tr)
    ticks = round_ticks(float(x[0]), float(x[-1]), 10)
    return graph(
        curves, np.asarray(x, float), letters.letter(along.sign, along.unit),
        [letters.letter(symbol, unit) for symbol, unit in of],
        step=ticks[1] - ticks[0], comma=tr.decimal == ",", join=False,
    )  # fmt: skip


def scale_of(name: str, value: float, unit: str) -> Var:
    """The scale of a picture: it stands in no results but on the picture itself."""
    return Var(name, float(value), unit, digits=4, ref=Ref(name, table="picture"))


def points(extremes: Sequence[Extreme], factor: float = 1.0) -> list[tuple[float, float]]:
    """Extremes as points of a graph: angle of turn, degrees, and value."""
    return [(math.degrees(extreme.turned), float(extreme.value * factor)) for extreme in extremes]
