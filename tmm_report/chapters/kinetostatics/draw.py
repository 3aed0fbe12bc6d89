"""Pictures of kinetostatics: diagram of the balancing moment, Zhukovsky's lever."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.kinetostatics import quantities as q
from tmm_report.chapters.kinetostatics.solve import Kinetostatics
from tmm_report.chapters.plans.solve import Plans
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.graphs import Curve, Graph
from tmm_report.figures.lettering import lettered
from tmm_report.figures.plans import PlanVector, Style, plan
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.quantity.model import Quantity
from tmm_report.report.diagrams import CycleGraphs, points

LEVER = 90.0  # mm: the longest vector of a lever


def balancing_diagram(found: Kinetostatics, graphs: CycleGraphs) -> Graph:
    size = float(np.nanmax(found.diagram.scale, initial=0.0))
    curve = Curve(found.diagram.balancing, extremes=points(found.extremes), scale=size)
    return graphs.graph([curve], [graphs.letter(q.M_BAL, q.BY_GROUPS.unit)])


def lever_picture(found: Kinetostatics, plans: Plans, position: int) -> Drawing | None:
    """Zhukovsky's lever: the plan of velocities turned by 90° with the loads on its points; None where no plan
    of velocities is drawn. It stands upright on the page; lengths of the forces only hint at their sizes."""
    drawn = next((d.velocity for d in plans.drawn if d.position == position), None)
    if drawn is None:
        return None
    frame = found.kinematics.linkage.mechanism.links[FRAME].points
    loads = [load for load in _loads_at(found, position) if abs(load[3]) > 0]
    largest = max((abs(force) for *_, force in loads), default=1.0)
    turn = 1j * min(1.0, LEVER / max(map(abs, drawn.vertices.values())))
    vectors = [PlanVector(turn * s.start, turn * s.end, of=s.key) for s in drawn.strokes]
    for of, style, point, force in loads:
        z = 0j if point in frame else turn * drawn.vector(f"v_{point}")
        arrow = force / abs(force) * (10 + 20 * abs(force) / largest)
        vectors.append(PlanVector(z, z + arrow, lettered(of.symbol), style, of.key))
    return plan(vectors, {name: turn * z for name, z in drawn.vertices.items()}, pole=drawn.pole)


def _loads_at(found: Kinetostatics, position: int) -> list[tuple[Quantity, Style, str, complex]]:
    """Forces at a table position: quantity, style, point, complex N; inertia forces among them."""
    load, stated = found.table.loading, found.given.forces
    links = found.kinematics.linkage.mechanism.links
    centre = {link: str(links[link].mass_centre) for link in load.gravity}
    rows: list[tuple[Quantity, Style, str, complex]] = []
    for link, force in load.gravity.items():
        rows.append((q.weight(link), "force", centre[link], complex(force[position])))
    for link, force in load.inertia.items():
        rows.append((q.inertia_force(link), "inertia", centre[link], complex(force[position])))
    for of, given, force in zip(q.forces(stated), stated, load.forces, strict=True):
        rows.append((of, "force", given.at, complex(force[position])))
    return rows
