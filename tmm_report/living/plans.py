"""Plans of velocities, accelerations and forces as the script redraws them: where their vertices are in every position.

A plan is read as a graph: ends of its vectors that meet are one vertex, and a vector of the results leads from one to
the next. From the vertex in which the plan begins all that can be reached are known in every position. A tangential
and a normal part of a reaction are those of the reaction of the position; a vector that is of no position but that in
which it was constructed is shown there alone.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from tmm_report.chapters.lever.kinetostatics.quantities.positions import reaction, reaction_part
from tmm_report.figures.charts.graphs import Graph
from tmm_report.figures.drawing import Drawing, Planned
from tmm_report.living.cycle import Cycle
from tmm_report.mechanics.lever.assur_groups import Pair
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.motion import Motion

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


def polygons(
    pictures: Mapping[str, Drawing | Graph], cycle: Cycle, vectors: Mapping[str, Array], sent: Container[str]
) -> tuple[dict[str, Any], dict[str, Array]]:
    """The plans, and the vectors that they need beside those that are `sent` anyway. `vectors`: all that are known in
    every position, SI."""
    found, vectors = {}, {**vectors, **dict(_components(cycle))}
    for anchor, picture in pictures.items():
        plan = picture.plan if isinstance(picture, Drawing) else None
        if plan is not None and (one := _polygon(plan, cycle, vectors, sent)) is not None:
            found[anchor] = one
    keys = {key for one in found.values() for _, _, key, _ in one["ways"]}
    return found, {key: vectors[key] for key in sorted(keys) if key not in sent}


def _polygon(
    plan: Planned, cycle: Cycle, vectors: Mapping[str, Array], sent: Container[str]
) -> dict[str, Any] | None:
    """`ways`: from the vertex in which the plan begins on, a vertex, that from which it is reached, by which vector,
    and whether along it or against it."""
    nodes, edges = _graph(plan)
    known = {e.key: vectors[e.key] / plan.scale for e in edges if e.key in vectors}
    if not known:
        return None
    position = _position(edges, known, cycle)
    alike = [e for e in edges if e.key in known and _agrees(e, known[e.key][position])]
    if not alike:
        return None
    alike.sort(key=lambda one: one.key not in sent)
    ways: list[tuple[int, int, str, int]] = []
    reached = {edges[0].start}
    for _ in nodes:  # as many rounds as the longest way may have
        for edge in alike:
            if edge.start in reached and edge.end not in reached:
                ways.append((edge.end, edge.start, edge.key, 1))
            elif edge.end in reached and edge.start not in reached:
                ways.append((edge.start, edge.end, edge.key, -1))
            reached |= {n for n, *_ in ways}
    return {
        "position": int(position),
        "scale": plan.scale,
        "begin": edges[0].start,
        "ways": ways,
        "at": [[round(z.real, 3) + 0.0, round(z.imag, 3) + 0.0] for z in nodes],
        "arrows": [[e.key, e.start, e.end] for e in edges],
    }


def _components(cycle: Cycle) -> Iterator[tuple[str, Array]]:
    """Of the reactions that are found by moments about a joint, the parts across the arm to it and along it."""
    for by, on, arm in _arms(cycle):
        if (force := cycle.vectors.get(reaction(by, on).key)) is None:  # the variant states no loads
            continue
        normal = (force * arm.conj()).real * arm / np.abs(arm) ** 2
        yield reaction_part(by, on, "n").key, normal
        yield reaction_part(by, on, "t").key, force - normal


def _arms(cycle: Cycle) -> Iterator[tuple[str, str, Array]]:
    """Links between which such a reaction acts, and the arm to its joint from that of the moments, m."""
    linkage, stroke = cycle.kinematics.linkage, cycle.kinematics.linkage.mechanism.driver.stroke
    for group in linkage.groups:
        if stroke is not None and set(stroke.by) & set(group.links):
            if isinstance(stroke, Triangle):
                _, pin, far = stroke.names
                end = next(p.other(stroke.link) for p in group.group.outer if stroke.link in p.links)
                yield end, stroke.link, cycle.both(Motion.place, pin) - cycle.both(Motion.place, far)
        elif isinstance(group, Dyad):
            for pair, link, about in _about(group):
                yield pair.other(link), link, cycle.both(_joint, pair) - cycle.both(_joint, about)


def _about(dyad: Dyad) -> Iterator[tuple[Pair, str, Pair]]:
    """Outer joints of a dyad with the link in each and the joint about which the moments are taken."""
    if dyad.kind in (1, 2, 3):
        yield dyad.outer_a, dyad.a, dyad.outer_b if dyad.kind == 3 else dyad.inner
    if dyad.kind == 1:
        yield dyad.outer_b, dyad.b, dyad.inner


def _joint(motion: Motion, pair: Pair) -> Array:
    link = pair.slider or pair.links[1]
    return motion.state.world(link, pair.at[link])


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
    miss = np.abs(of - drawn[:, None]).sum(axis=0)
    return int(cycle.numbered[int(np.argmin(np.where(np.isfinite(miss), miss, np.inf)))])


def _agrees(edge: _Edge, vector: complex) -> bool:
    """Whether the vector of the results is the one that is drawn."""
    return bool(abs(vector - edge.vector) <= AGREES * abs(edge.vector) + 0.3)
