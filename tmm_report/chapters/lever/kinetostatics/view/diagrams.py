"""Diagrams of kinetostatics over the cycle: the balancing moment, the loads, the reactions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmm_report.chapters.lever.kinematics.solve.points_and_links import along
from tmm_report.chapters.lever.kinetostatics.quantities import positions as q
from tmm_report.chapters.lever.kinetostatics.solve.drawn_cycle import Array, Sampled
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.figures.lettering import Parts
from tmm_report.i18n import Translator
from tmm_report.report.diagrams import CycleGraphs, points

NOTHING = 1e-9  # of the largest reaction: a projection of less is none


def graphs_of(found: Kinetostatics, at: Sampled, tr: Translator) -> CycleGraphs:
    return CycleGraphs(at.turned, found.kinematics.numbered, tr, along(found.kinematics.by_law).sign)


def balancing_diagram(found: Kinetostatics, at: Sampled, graphs: CycleGraphs) -> Graph:
    size = float(np.nanmax(found.diagram.scale, initial=0.0))
    values = at.of(found.over.balancing if found.over else None, found.diagram.balancing)
    curve = Curve(values, extremes=points(found.extremes), scale=size)
    return graphs.graph([curve], [graphs.axis(q.BALANCING_MOMENT)])


def load_diagrams(found: Kinetostatics, at: Sampled, graphs: CycleGraphs, tall: float) -> list[Graph]:
    """The loads that change over the cycle along their stated directions, on pages of a height, mm."""
    named = [*q.forces(found.given.forces), *q.moments(found.given.moments)]
    over = found.over.loading.stated if found.over else [None] * len(named)
    panels = [
        ([at.of(over[k], found.diagram.loading.stated[k])], graphs.axis(named[k])) for k in found.followed
    ]
    return sheets_of(panels, graphs, tall)


def sheets_of(
    panels: Sequence[tuple[Sequence[Array], Parts]], graphs: CycleGraphs, tall: float
) -> list[Graph]:
    """Panels of curves with the names of their axes, on pages of a height, mm."""
    return [*_sheets([([Curve(values) for values in own], label) for own, label in panels], graphs, tall)]


def reaction_diagrams(found: Kinetostatics, at: Sampled, graphs: CycleGraphs, tall: float) -> list[Graph]:
    """Of every pair a panel with the magnitude of its reaction and its projections, on pages of a height, mm."""
    largest = max(float(np.nanmax(np.abs(one.force))) for one in found.diagram.statics.reactions.values())
    panels = [
        (list(_parts_of(found, at, graphs, key, NOTHING * largest)), _label(found, key, graphs))
        for key in found.diagram.statics.reactions
    ]
    return [*_sheets(panels, graphs, tall)]


def _label(found: Kinetostatics, key: str, graphs: CycleGraphs) -> Parts:
    return graphs.axis(q.reaction(*found.diagram.statics.reactions[key].pair.links))


def reaction(found: Kinetostatics, at: Sampled, key: str) -> Array:
    """The reaction of a pair at the angles drawn, complex N, (Q,)."""
    diagram = np.broadcast_to(found.diagram.statics.reactions[key].force, found.diagram.motion.shape)
    return at.of(found.over.reactions[key] if found.over else None, diagram)


def _parts_of(
    found: Kinetostatics, at: Sampled, graphs: CycleGraphs, key: str, least: float
) -> Iterator[Curve]:
    """Magnitude and projections of a reaction; a projection that is nothing all round is left out."""
    force, of = reaction(found, at, key), q.reaction(*found.diagram.statics.reactions[key].pair.links)
    nothing = () if found.kinematics.limited else None  # towards a limit it grows without bound
    extremes = points([found.over.sizes[key][1]]) if found.over else nothing
    yield Curve(np.abs(force), graphs.letter(of.sign), extremes=extremes)
    for quantity, values in zip(of.components, (force.real, force.imag), strict=True):
        if np.nanmax(np.abs(values), initial=0.0) > least:
            yield Curve(values, graphs.letter(quantity.sign), extremes=())


def _sheets(
    panels: Sequence[tuple[Sequence[Curve], Parts]], graphs: CycleGraphs, tall: float
) -> Iterator[Graph]:
    """As many panels one above another as a page holds: what is left for the next one is small, and finds room."""
    start = 0
    while start < len(panels):
        end, page = start + 1, _sheet(panels[start : start + 1], graphs)
        while end < len(panels) and (more := _sheet(panels[start : end + 1], graphs)).size[1] <= tall:
            end, page = end + 1, more
        start = end
        yield page


def _sheet(panels: Sequence[tuple[Sequence[Curve], Parts]], graphs: CycleGraphs) -> Graph:
    """Panels one above another."""
    curves = [
        Curve(curve.values, curve.name, number, curve.extremes, curve.scale)
        for number, (own, _) in enumerate(panels)
        for curve in own
    ]
    return graphs.graph(curves, [label for _, label in panels], join=False)
