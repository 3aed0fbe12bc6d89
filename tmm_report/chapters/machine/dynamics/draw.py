"""Diagrams of the machine in motion: characteristics over the speed, the steady motion, start-up and run-down."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from tmm_report.chapters.machine.dynamics import quantities as q
from tmm_report.chapters.machine.dynamics.solve import Found
from tmm_report.chapters.machine.dynamics.values import Motion
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.charts.plane import Trace, framed, plane
from tmm_report.figures.drawing import NORMAL, THICK, Drawing, line, polygon
from tmm_report.mechanics.machine.run.steady import Steady
from tmm_report.quantity.model import Table
from tmm_report.report.diagrams import CycleGraphs, Line, chart
from tmm_report.report.page import Page


def drawings(found: Found, page: Page) -> Iterator[Graph]:
    """All of them, the most telling first."""
    for name, _ in found.runs:
        yield run(found, name, page)
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


def _moments(table: Table, panel: int, page: Page) -> list[Line]:
    """The driving and the resisting moment in one panel."""
    graphs = CycleGraphs(np.zeros(2), 0, page.tr)
    return [Line(table[key], graphs.letter(table[key].symbol()), panel) for key in ("M_dr", "M_res")]


def _table(found: Found, name: str) -> Table:
    return next(table for table in q.tables(found) if table.name == f"dynamics_{name}")


def characteristics(found: Found, page: Page) -> Graph:
    table = _table(found, "characteristics")
    return chart(_moments(table, 0, page), table["omega"], [Motion.M.quantity], page.tr)


def cycle(found: Found, page: Page) -> Graph:
    """Moments, deviation of the angular velocity from its mean, and acceleration over the cycle."""
    assert found.steady is not None  # asked for only where there is one
    table = _table(found, "cycle_diagram")
    curves = [
        *(Curve(line.column.numbers(), line.name, 0, extremes=()) for line in _moments(table, 0, page)),
        Curve(table["domega"].numbers(), panel=1, extremes=_extremes(found.steady), scale=found.steady.mean),
        Curve(table["epsilon"].numbers(), panel=2),
    ]
    graphs = CycleGraphs(found.diagram_turned, len(found.turned) - 1, page.tr)
    of = [Motion.M.quantity, table["domega"].quantity, table["epsilon"].quantity]
    return graphs.graph(curves, [graphs.letter(one.sign, one.printed) for one in of], join=False)


def _extremes(steady: Steady) -> list[tuple[float, float]]:
    """The greatest and the least deviation, exact between the positions: degrees, rad/s."""
    return [(math.degrees(at), value - steady.mean) for value, at in reversed(steady.extremes)]


def run(found: Found, name: str, page: Page) -> Graph:
    """Angular velocity and moments over the time."""
    table = _table(found, f"{name}_diagram")
    lines = [Line(table["omega"], extremes=None), *_moments(table, 1, page)]
    return chart(lines, table["t"], [table["omega"].quantity, Motion.M.quantity], page.tr)


def joined(found: Found, page: Page) -> Graph:
    """The angular velocity through all regimes, with the times at which they end."""
    table, regimes = _table(found, "joined"), _table(found, "regimes")
    bounds = [0.0, *(float(x) for x in regimes["t_end"].numbers()[:-1])]
    times, speeds = table["t"].numbers(), table["omega"].numbers()
    ends = [(x, float(speeds[np.searchsorted(times, x)])) for x in bounds[1:-1]]
    return chart(
        [Line(table["omega"], extremes=ends)], table["t"], [table["omega"].quantity], page.tr, bounds
    )
