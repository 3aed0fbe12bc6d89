"""Plans of velocities, accelerations and forces as the script redraws them: where their vertices are in every position.

A plan is read as a graph: ends of its vectors that meet are one vertex, and a vector of the results leads from one to
the next. From the vertex in which the plan begins all that can be reached are known in every position. A vector that
is in no table of the positions (a tangential part of a reaction) is shown only where it was constructed.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing, Planned
from tmm_report.living.cycle import Cycle, places

Array = Any
MEET = 0.02  # mm: ends of vectors nearer than this are one vertex
AGREES = (
    0.05  # of its length, and 0.3 mm: by how much a constructed vector may differ from that of the results
)


class _Edge(NamedTuple):
    key: str
    start: int
    end: int
    vector: complex  # mm, as it is drawn


def polygons(pictures: Mapping[str, Drawing | Graph], cycle: Cycle) -> dict[str, Any]:
    found = {}
    for anchor, picture in pictures.items():
        plan = picture.plan if isinstance(picture, Drawing) else None
        if plan is not None and (one := _polygon(plan, cycle)) is not None:
            found[anchor] = one
    return found


def _polygon(plan: Planned, cycle: Cycle) -> dict[str, Any] | None:
    nodes, edges = _graph(plan)
    known = {e.key: cycle.vectors[e.key] / plan.scale for e in edges if e.key in cycle.vectors}
    if not known:
        return None
    position = _position(edges, known, cycle)
    edges_known = [(e, way) for e in edges if (way := _way(e, known, position)) is not None]
    reached: list[Array | None] = [None] * len(nodes)
    if not edges_known:
        return None
    first = edges[0].start
    reached[first] = np.full(len(cycle.turned), nodes[first])
    for _ in nodes:  # as many rounds as the longest way may have
        for edge, way in edges_known:
            start, end = reached[edge.start], reached[edge.end]
            if start is not None and end is None:
                reached[edge.end] = start + way
            elif end is not None and start is None:
                reached[edge.start] = end - way
    return {
        "position": int(position),
        "nodes": [None if one is None else [places(one.real, 3), places(one.imag, 3)] for one in reached],
        "at": [[round(z.real, 3) + 0.0, round(z.imag, 3) + 0.0] for z in nodes],
        "arrows": [[e.key, e.start, e.end] for e in edges],
    }


def _graph(plan: Planned) -> tuple[list[complex], list[_Edge]]:
    nodes: list[complex] = []

    def node(at: complex) -> int:
        near = next((k for k, one in enumerate(nodes) if abs(one - at) <= MEET), None)
        if near is None:
            nodes.append(at)
        return len(nodes) - 1 if near is None else near

    edges = [_Edge(of, node(start), node(end), end - start) for of, start, end in plan.vectors]
    return nodes, edges


def _position(edges: Sequence[_Edge], known: Mapping[str, Array], cycle: Cycle) -> int:
    """The position in which the plan was constructed: in which its vectors are best those of the results."""
    drawn = np.array([e.vector for e in edges if e.key in known])
    of = np.array([known[e.key][cycle.numbered] for e in edges if e.key in known])
    miss = np.minimum(np.abs(of - drawn[:, None]), np.abs(of + drawn[:, None])).sum(axis=0)
    return int(cycle.numbered[int(np.argmin(np.where(np.isfinite(miss), miss, np.inf)))])


def _way(edge: _Edge, known: Mapping[str, Array], position: int) -> Array | None:
    """The vector in all positions, in the sense in which it is drawn; None where it is another, or not known."""
    if edge.key not in known:
        return None
    vector = known[edge.key]
    allowed = AGREES * abs(edge.vector) + 0.3
    for sense in (1, -1):
        if abs(sense * vector[position] - edge.vector) <= allowed:
            return sense * vector
    return None
