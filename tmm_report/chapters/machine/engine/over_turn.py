"""Tables, diagrams and hodographs of the forces of an engine over a turn."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.engine.values import KINDS, component
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.charts.plane import Trace, framed, plane
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import Parts
from tmm_report.problems import N_
from tmm_report.report.diagrams import CycleGraphs
from tmm_report.report.paper.layout import Table, worded

if TYPE_CHECKING:
    from tmm_report.chapters.machine.engine.view import EngineView

Array = Any
NAMES = {
    "before": N_("without counterweights"),
    "after": N_("exact"),
    "orders": N_("orders 1 and 2"),
}
REST = {"force": N_("force of order %(k)s"), "couple": N_("moment of order %(k)s")}
FLAT = 1e-3  # of the size: a hodograph so thin is a line, a curve so low is nothing


def greatest_table(view: EngineView) -> Table:
    """Exact without and with counterweights, by orders 1 and 2, what these leave."""
    page, table, found = view.page, view.table("greatest"), view.found
    keys = [*(["before"] if "m_cw" in found.s else []), "after", "orders", "left"]
    words = {
        "before": view.t("Exact, without counterweights"),
        "after": view.t("Exact"),
        "orders": view.t("Orders 1 and 2"),
        "left": view.t("What these leave"),
    }
    rows = [
        [
            page.listed([view.t(KINDS[of].meaning), page.unit(KINDS[of].unit)]),
            *(page.cell(table, key, row) for key in keys),
        ]
        for row, of in enumerate(("force", "couple"))
        if of == "force" or found.spread
    ]
    heads = [view.t("Quantity"), *(words[key] for key in keys)]
    return worded(view.t("Greatest values over a turn"), heads, rows, [4] + [2] * len(keys))


def remedies_table(view: EngineView) -> Table:
    """Weights that balance what is left, with their directions at angle 0 of the crankshaft."""
    page, table = view.page, view.table("remedies")
    keys = ("forward", "forward_angle", "backward", "backward_angle")
    rows = [
        [
            page.listed([view.t(REST[one.of], k=one.order), page.unit(table["unit"].values[row])]),
            *(page.cell(table, key, row) for key in keys),
        ]
        for row, one in enumerate(view.found.remedies)
        if one.kind != "none"
    ]
    heads = [page.head(table[key].symbol(), table[key].quantity.printed) for key in keys]
    caption = view.t("Weights that balance orders 1 and 2")
    return worded(caption, [view.t("What is balanced"), *heads], rows, [4] + [2] * len(keys))


def _seen(view: EngineView, of: str) -> dict[str, Array]:
    """Curves over a turn; that without counterweights where these change anything."""
    found = {name: getattr(course, of) for name, course in view.found.diagram.items()}
    before = found.pop("before")
    changed = np.max(np.abs(before - found["after"])) > FLAT * _scale(view, of)
    return found | ({"before": before} if changed else {})


def _scale(view: EngineView, of: str) -> float:
    return view.found.unit * (1.0 if of == "force" else view.found.spread)


def hodographs(view: EngineView) -> Iterator[tuple[str, Drawing]]:
    """Of force and moment, where it is more than a line."""
    for of in KINDS:
        curves, scale = _seen(view, of), _scale(view, of)
        extents = [max(np.ptp(part(v)) for v in curves.values()) for part in (np.real, np.imag)]
        if scale and min(extents) > FLAT * scale:
            yield of, _hodograph(view, of, curves)


def _hodograph(view: EngineView, of: str, curves: dict[str, Array]) -> Drawing:
    frame = framed(list(curves.values()), equal=True, field=(95.0, 95.0))
    traces = [Trace(values, (str(view.t(NAMES[name])),)) for name, values in curves.items()]
    graphs = CycleGraphs(view.found.diagram["after"].phi, 0, view.page.tr)
    x, y = (_axis(graphs, of, axis) for axis in "xy")
    return plane(frame, traces, x, y, view.page.num, title=str(view.t(KINDS[of].meaning)))


def _axis(graphs: CycleGraphs, of: str, axis: str) -> Parts:
    """Letter and unit of what is shown along it."""
    shown = component(of, axis)
    return graphs.letter(shown.sign, shown.printed)


def _marked(values: Array, scale: float) -> tuple[()] | None:
    """The extremes of a curve are marked where it is more than nothing beside the others."""
    return None if np.max(np.abs(values)) > FLAT * scale else ()


def diagrams(view: EngineView) -> Iterator[tuple[str, Graph]]:
    """Components of force and moment over a turn, those that are anything."""
    graphs = CycleGraphs(view.found.diagram["after"].phi, 0, view.page.tr)
    for of in KINDS:
        curves, scale = _seen(view, of), _scale(view, of)
        shown: list[Curve] = []
        labels: list[Parts] = []
        for axis, part in (("x", np.real), ("y", np.imag)):
            values = {name: part(vectors) for name, vectors in curves.items()}
            if scale and max(np.max(np.abs(v)) for v in values.values()) > FLAT * scale:
                named = [(v, str(view.t(NAMES[name]))) for name, v in values.items()]
                shown += [
                    Curve(v, name, len(labels), _marked(v, scale) if k == 0 else (), scale)
                    for k, (v, name) in enumerate(named)
                ]
                labels.append(_axis(graphs, of, axis))
        if shown:
            yield of, graphs.graph(shown, labels, join=False)
