"""Diagrams of a machine whose main link slides: speed and forces over the place, place and speed over the time."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.machine.travel import quantities as q
from tmm_report.chapters.machine.travel.solve import Found
from tmm_report.chapters.machine.travel.values import Motion
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.charts.plane import Trace, framed, plane
from tmm_report.figures.drawing import Drawing
from tmm_report.quantity.model import Table
from tmm_report.report.diagrams import CycleGraphs, Line, chart
from tmm_report.report.page import Page


def _table(found: Found) -> Table:
    return next(table for table in q.tables(found) if table.name == "travel_motion_diagram")


def over_way(found: Found, page: Page) -> Graph:
    """Speed, forces and, where it varies, the reduced mass over the place: from the left whichever way it goes."""
    table = _table(found)
    order = slice(None, None, int(found.whole.way))
    graphs = CycleGraphs(np.zeros(2), 0, page.tr)
    panels = [[("v", "")], [(key, "letter") for key in ("F_dr", "F_red", "F_res") if key in table]]
    if "m_red" in table:
        panels.append([("m_red", "")])
    lines, of = [], []
    for panel, keys in enumerate(one for one in panels if one):
        of.append(Motion.F.quantity if panel == 1 and keys[0][1] else table[keys[0][0]].quantity)
        for key, lettered in keys:
            name = graphs.letter(table[key].symbol()) if lettered else ""
            column = table[key].quantity.column(np.asarray(table[key].values)[order])
            lines.append(Line(column, name, panel, None if not lettered else ()))
    along = table["s"].quantity.column(np.asarray(table["s"].values)[order])
    return chart(lines, along, of, page.tr)


def over_time(found: Found, page: Page) -> Graph:
    """Place, speed and acceleration over the time."""
    table = _table(found)
    keys = ("s", "v", "a")
    lines = [Line(table[key], panel=panel, extremes=None) for panel, key in enumerate(keys)]
    return chart(lines, table["t"], [table[key].quantity for key in keys], page.tr)


def glance(found: Found, page: Page) -> Drawing:
    """The speed over the place."""
    graph = over_way(found, page)
    curve = graph.x + 1j * np.asarray(graph.of(0)[0][0].values)
    return plane(framed([curve]), [Trace(curve)], graph.xlabel, graph.ylabels[0], page.num)
