"""Diagrams over the cycle of a lever mechanism, and over any other quantity: what all chapters that draw them share."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from tmm_report.figures.charts.axes import round_axis, round_ticks
from tmm_report.figures.charts.graphs import Curve, Graph, Letters, graph
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Label, Parts, lettered
from tmm_report.i18n import Translator
from tmm_report.mechanics.cams.extremes import Extreme
from tmm_report.quantity.formula import Var
from tmm_report.quantity.model import Column, Quantity, Table
from tmm_report.quantity.ref import Ref
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.text import unit_text

Array = Any

STEPS = (1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0)  # degrees between ticks
APART = 9.0  # mm between ticks at least


def _step(least: float) -> float:
    """The smallest round step that is not smaller, degrees: whole turns, times a power of ten, of many turns."""
    turns = (360.0 * n * 10.0**power for power in range(16) for n in (1, 2, 5))
    return next(step for step in (*STEPS, *turns) if step >= least * (1 - 1e-12))


class CycleGraphs:
    """`turned`: angles of the diagram positions, rad; `positions`: how many are numbered on the axis; `along`: the
    symbol of the angle."""

    def __init__(self, turned: Array, positions: int, tr: Translator, along: Symbol = Symbol("phi")):
        self.turned, self.positions, self.tr, self.along = turned, positions, tr, along

    def graph(self, curves: Sequence[Curve], labels: Sequence[Parts], join: bool = True) -> Graph:
        """The axis of the angle is at a round scale, 2.5° to a millimetre of a turn; ticks at 30°, or farther apart."""
        degrees = np.degrees(self.turned)
        extent = float(degrees[-1] - degrees[0])
        angle = self.letter(self.along, "deg")
        return graph(
            curves, degrees, angle, labels,
            wide=partial(round_axis, extent), step=lambda wide: _step(APART * extent / wide),
            positions=self.positions, comma=self.tr.decimal == ",", join=join,
        )  # fmt: skip

    def label(self, quantity: Quantity) -> Parts:
        """The letter of a quantity and its unit, for an axis: the figure's caption says of what."""
        return self.letter(Symbol(quantity.sign.base), quantity.printed)

    def axis(self, quantity: Quantity) -> Parts:
        """The symbol of a quantity and its unit of print."""
        return self.letter(quantity.sign, quantity.printed)

    def letter(self, symbol: Symbol, unit: str = "") -> Label:
        """A symbol as it is drawn, and its unit."""
        return named(symbol, unit, self.tr)


def named(symbol: Symbol, unit: str, tr: Translator) -> Label:
    """A symbol with its unit, for an axis."""
    parts = (*letter(symbol, tr), *((f", {unit_text(unit, tr.language)}",) if unit else ()))
    return Label.made(parts, symbol, unit)


def scales(drawn: Graph | Drawing) -> list[Var]:
    """What 1 mm along each axis of a picture stands for: axes of one letter and one scale are told once, those of one
    letter and several scales by the indices of what they show."""
    of_letter: dict[str, set[tuple[float, str]]] = {}
    for one in drawn.scales:
        of_letter.setdefault(one.of.base, set()).add((one.value, one.unit))
    found = [
        (one.of.base if len(of_letter[one.of.base]) == 1 else _whole(one.of), one.value, per_mm(one.unit))
        for one in drawn.scales
    ]
    return [scale_of(f"mu_{name}", value, unit) for name, value, unit in dict.fromkeys(found)]


def _whole(symbol: Symbol) -> str:
    return f"{symbol.base}{symbol.sub}{symbol.sup}"


def per_mm(unit: str) -> str:
    """The unit of a scale: m/mm, (m/s)/mm, °/mm."""
    unit = unit.replace("deg", "°") or "1"
    fraction = "/" in unit or unit == "rpm"  # which other languages write as one
    return f"({unit})/mm" if fraction else f"{unit}/mm"


def letter(symbol: Symbol | str, tr: Translator) -> Parts:
    """A symbol, or a base alone, as it is drawn, words of its indices translated; the change of a quantity as Δ and
    its own letter."""
    symbol = Symbol(symbol) if isinstance(symbol, str) else symbol
    base = symbol.base.removeprefix("Delta").removeprefix("Δ")
    drawn = lettered(replace(symbol, base=base or symbol.base), tr.in_index)
    assert drawn is not None
    return ("Δ", drawn) if base not in ("", symbol.base) else (drawn,)


class Line(NamedTuple):
    """A curve of a chart: a column of the results; `name`: over its panel, where several run in it; `extremes`: as a
    `Curve` has them; what is above `most` or below `least`, in the unit of print, runs off the sheet."""

    column: Column
    name: Letters = ""
    panel: int = 0
    extremes: Sequence[tuple[float, float]] | None = ()
    most: float = math.inf
    least: float = -math.inf


def chart(
    lines: Iterable[Line], along: Column, of: Sequence[Quantity], tr: Translator, bounds: Sequence[float] = ()
) -> Graph:
    """Columns over an ascending one. `of`: what each panel shows, from the top: its letter and unit are on the axis,
    and the curves are drawn in that unit; `bounds`: as `graph` has them."""
    drawn = [
        Curve(_within(line, of[line.panel].printed), line.name, line.panel, line.extremes) for line in lines
    ]
    panels = [(quantity.sign, quantity.printed) for quantity in of]
    unit = along.quantity.printed
    return plot(drawn, along.numbers(unit), replace(along.quantity, unit=unit), panels, tr, bounds)


def cycle_chart(table: Table, keys: Sequence[str], tr: Translator) -> Graph:
    """Columns over the angle turned, each in a panel of its own with its letter and unit."""
    lines = [Line(table[key], panel=k, extremes=None) for k, key in enumerate(keys)]
    return cycle_lines(lines, table["phi"], tr)


def cycle_lines(
    lines: Sequence[Line], turned: Column, tr: Translator, positions: int = 0, join: bool = True
) -> Graph:
    """Lines over the angle turned; each panel has letter and unit of the first in it. `positions`: how many are
    numbered on the axis."""
    graphs = CycleGraphs(turned.numbers("rad"), positions, tr, turned.quantity.sign)
    of = {line.panel: line.column.quantity for line in reversed(lines)}
    drawn = [
        Curve(_within(line, of[line.panel].printed), line.name, line.panel, line.extremes) for line in lines
    ]
    return graphs.graph(drawn, [graphs.axis(of[panel]) for panel in sorted(of)], join)


def _within(line: Line, unit: str) -> Array:
    numbers = line.column.numbers(unit)
    return np.where((line.least <= numbers) & (numbers <= line.most), numbers, np.nan)


def plot(
    curves: Sequence[Curve],
    x: Array,
    along: Quantity,
    of: Sequence[tuple[Symbol, str]],
    tr: Translator,
    bounds: Sequence[float] = (),
) -> Graph:
    """Curves over any ascending quantity `along`, (P,) in its unit: the time, the speed, a frequency. `of`: symbol and
    unit of each panel, from the top."""
    letters = CycleGraphs(x, 0, tr)
    ticks = round_ticks(float(x[0]), float(x[-1]), 10)
    return graph(
        curves, np.asarray(x, float), letters.letter(along.sign, along.unit),
        [letters.letter(symbol, unit) for symbol, unit in of],
        wide=partial(round_axis, float(x[-1] - x[0])),
        step=ticks[1] - ticks[0], comma=tr.decimal == ",", join=False, bounds=bounds,
    )  # fmt: skip


def scale_of(name: str, value: float, unit: str) -> Var:
    """The scale of a picture: it stands in no results but on the picture itself."""
    return Var(name, float(value), unit, digits=4, ref=Ref(name, table="picture"))


def points(extremes: Sequence[Extreme], factor: float = 1.0) -> list[tuple[float, float]]:
    """Extremes as points of a graph: angle of turn, degrees, and value; without those that there are none of."""
    there = [extreme for extreme in extremes if math.isfinite(extreme.value)]
    return [(math.degrees(extreme.turned), float(extreme.value * factor)) for extreme in there]
