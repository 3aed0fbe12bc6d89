"""Diagrams of the machine in motion: characteristics over the speed, the steady motion, start-up and run-down."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.dynamics import quantities as q
from tmm_report.chapters.machine.dynamics import terms
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.charts.plane import Trace, framed, plane
from tmm_report.figures.drawing import NORMAL, THICK, Drawing, line, polygon
from tmm_report.figures.lettering import Parts
from tmm_report.i18n import NP_
from tmm_report.mechanics.machine.run.motion_law import Run
from tmm_report.mechanics.machine.run.steady import Steady
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs, plot
from tmm_report.report.page import Page

_ = NP_


def drawings(found: Found, page: Page) -> Iterator[Graph]:
    """All of them, the most telling first."""
    for _, one in found.runs:
        yield run(one, page)
    if found.steady is not None and not found.even:
        yield cycle(found, page)


def glance(found: Found, page: Page) -> Drawing:
    """The first curve of the most telling diagram; of a machine whose motion is not asked for its shaft and parts."""
    shown = next(drawings(found, page), None)
    if shown is None:
        return shaft(len(found.given.parts))
    curve = shown.x + 1j * np.asarray(shown.of(0)[0][0].values)
    return plane(framed([curve]), [Trace(curve)], shown.xlabel, shown.ylabels[0], page.num)


def shaft(parts: int) -> Drawing:
    """A shaft with a disc for each of the parts."""
    places = [12.0 * (k + 1) for k in range(max(1, parts))]
    discs = [polygon((x - 2 - 9j, x + 2 - 9j, x + 2 + 9j, x - 2 + 9j), NORMAL, "pale") for x in places]
    return Drawing((line(0, complex(places[-1] + 12), THICK), *discs))


def _named(symbol: Symbol, page: Page) -> Parts:
    return CycleGraphs(np.zeros(2), 0, page.tr).letter(symbol, "")


def characteristics(found: Found, page: Page) -> Graph:
    table = {table.name: table for table in q.tables(found)}["dynamics_characteristics"]
    curves = [
        Curve(table[key].numbers(), _named(quantity.sign, page), extremes=())
        for key, quantity in (("M_dr", terms.DRIVING), ("M_res", terms.RESISTING))
    ]
    return plot(curves, table["omega"].numbers(), terms.SPEED, [(Symbol("M"), "N·m")], page.tr)


def cycle(found: Found, page: Page) -> Graph:
    """Moments, deviation of the angular velocity from its mean, and acceleration over the cycle."""
    assert found.steady is not None  # asked for only where there is one
    table = {table.name: table for table in q.tables(found)}["dynamics_cycle_diagram"]
    curves = [
        Curve(table["M_dr"].numbers(), _named(terms.DRIVING.sign, page), 0, extremes=()),
        Curve(table["M_res"].numbers(), _named(terms.RESISTING.sign, page), 0, extremes=()),
        Curve(table["domega"].numbers(), panel=1, extremes=_extremes(found.steady), scale=found.steady.mean),
        Curve(table["epsilon"].numbers(), panel=2),
    ]
    closed = len(found.turned) - 1
    graphs = CycleGraphs(found.diagram_turned, closed, page.tr)
    symbols = ((Symbol("M"), "N·m"), (terms.DEVIATION.sign, "rad/s"), (terms.ACCELERATION.sign, "rad/s²"))
    return graphs.graph(curves, [graphs.letter(symbol, unit) for symbol, unit in symbols], join=False)


def _extremes(steady: Steady) -> list[tuple[float, float]]:
    """The greatest and the least deviation, exact between the positions: degrees, rad/s."""
    return [(math.degrees(at), value - steady.mean) for value, at in reversed(steady.extremes)]


def run(found: Run, page: Page) -> Graph:
    """Angular velocity and moments over the time."""
    driving = sum((found.of(one) for one in found.plant.acting if one.key == "motor"), np.zeros(len(found.t)))
    curves = [
        Curve(found.omega, panel=0),
        Curve(driving, _named(terms.DRIVING.sign, page), 1, extremes=()),
        Curve(driving - found.moment, _named(terms.RESISTING.sign, page), 1, extremes=()),
    ]
    of = [(terms.SPEED.sign, "rad/s"), (Symbol("M"), "N·m")]
    return plot(curves, found.t, terms.TIME, of, page.tr)
