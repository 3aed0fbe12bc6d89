"""Pictures of kinetostatics: diagram of the balancing moment, Zhukovsky's lever."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmm_report.chapters.kinetostatics import quantities as q
from tmm_report.chapters.kinetostatics.breaks import breaks
from tmm_report.chapters.kinetostatics.loads import ByAngle
from tmm_report.chapters.kinetostatics.solve import Kinetostatics, magnitude
from tmm_report.chapters.plans.solve import Plans
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.graphs import Curve, Graph
from tmm_report.figures.lettering import lettered
from tmm_report.figures.plans import PlanVector, Style, plan
from tmm_report.i18n import Translator
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.quantity.model import Quantity
from tmm_report.report.diagrams import CycleGraphs, points

LEVER = 90.0  # mm: the longest vector of a lever
PANELS = 4  # on a sheet of diagrams
JUMP = 3e-3  # rad: the line of a jump is drawn from so little before it


def balancing_diagram(found: Kinetostatics, graphs: CycleGraphs) -> Graph:
    size = float(np.nanmax(found.diagram.scale, initial=0.0))
    curve = Curve(found.diagram.balancing, extremes=points(found.extremes), scale=size)
    return graphs.graph([curve], [graphs.letter(q.M_BAL, q.BY_GROUPS.unit)])


def force_diagrams(found: Kinetostatics, tr: Translator) -> list[Graph]:
    """The forces that are followed over the cycle, `PANELS` of them on a sheet."""
    forces, own = q.forces(found.given.forces), found.followed
    sheets = [own[start : start + PANELS] for start in range(0, len(own), PANELS)]
    return [_force_diagram(found, sheet, forces, tr) for sheet in sheets]


def _force_diagram(
    found: Kinetostatics, own: Sequence[int], forces: Sequence[Quantity], tr: Translator
) -> Graph:
    """At all positions, at the kinks of the forces and on both sides of their jumps."""
    kinematics, given = found.kinematics, [found.given.forces[k] for k in own]
    kinks = breaks(replace(found.given, forces=tuple(given), moments=()), kinematics)
    jumps = [found.strokes[k].begins for k in own if k in found.strokes]
    jumps += [np.array(force.law.angles) for force in given if isinstance(force.law, ByAngle)]
    before = [at - JUMP for at in jumps]
    turned = np.concatenate([kinematics.turned, kinematics.diagram_turned, kinks, *before])
    turned = np.unique(np.round(turned[(turned >= 0) & (turned <= kinematics.turned[-1])], 9))
    motion = kinematics.cycle.motion(np.mod(turned, kinematics.cycle.sweep))
    curves = [
        Curve(magnitude(force.law, kinematics, motion, turned, force.at), panel=panel)
        for panel, force in enumerate(given)
    ]
    graphs = CycleGraphs(turned, kinematics.positions.table, tr)
    return graphs.graph(curves, [graphs.letter(forces[k].sign, forces[k].unit) for k in own], join=False)


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
