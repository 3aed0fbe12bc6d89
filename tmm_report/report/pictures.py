"""Pictures of the note: the results handed to `figures` as it draws them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property, wraps
from typing import Any

import numpy as np

from tmm_report.chapters.force_plans.drafting import ForcePlan
from tmm_report.chapters.kinematics.solve import Travel
from tmm_report.chapters.plans.drafting import Plan
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.graphs import Curve, Graph, graph
from tmm_report.figures.lettering import symbol
from tmm_report.figures.plans import PlanVector, Style, plan
from tmm_report.figures.scheme import Arrays, groups_apart, positions_scheme, scheme, standard_scale
from tmm_report.i18n import Translator
from tmm_report.mechanics.cycle import Extreme
from tmm_report.mechanics.mechanism import FRAME
from tmm_report.mechanics.motion import Motion
from tmm_report.quantity.text import unit_text
from tmm_report.quantity.written import load_keys
from tmm_report.report.formats import percent

STYLES: dict[str, Style] = {
    "absolute": "absolute", "relative": "relative", "bend": "component", "rate": "component",
    "gravity": "force", "load": "force", "inertia": "inertia", "reaction": "reaction", "component": "component",
}  # fmt: skip


LEVER = 90.0  # mm: the longest vector of a lever

Scale = tuple[str, float, str]  # symbol, value of 1 mm, its unit


def once(draw: Callable[..., Any]) -> Callable[..., Any]:
    """A picture is drawn once, however often a template asks for it or for its scales."""

    @wraps(draw)
    def drawn(self: Pictures, *args: Any) -> Any:
        key = (draw.__name__, *args)
        if key not in self.drawn:
            self.drawn[key] = draw(self, *args)
        return self.drawn[key]

    return drawn


class Pictures:
    def __init__(self, results: Any, tr: Translator):
        self.r, self.tr = results, tr
        self.mechanism = results.variant.mechanism
        self.drawn: dict[Any, Any] = {}

    # ------------------------------------------------------------ schemes

    @once
    def one_position(self, position: int) -> Drawing:
        places, turns = self._whole
        return scheme(self.mechanism, places, turns, self.scheme_scale, position, self._zero)

    @once
    def all_positions(self, position: int) -> Drawing:
        places, turns = self._distinct
        return positions_scheme(
            self.mechanism, places, turns, self.scheme_scale, position % self._count, self._paths
        )

    @once
    def groups(self, position: int) -> Drawing:
        places, turns = self._whole
        linkage = self.r.structure.linkage.structure
        driver = self.mechanism.driver.link
        groups = [
            (f"I(0,{driver})", (FRAME, driver)),
            *((group.label, group.links) for group in linkage.groups),
        ]
        return groups_apart(self.mechanism, places, turns, groups, position)

    @cached_property
    def scheme_scale(self) -> float:
        """m/mm: the scale of the plans' construction where the scheme of all positions fits a page at it."""
        places, turns = self._distinct
        stated = self.r.plans.length_scale
        drawn = positions_scheme(self.mechanism, places, turns, stated, 0, self._paths)
        return stated if percent(drawn) == 100 else standard_scale(self.mechanism, places, turns)

    @cached_property
    def _whole(self) -> tuple[Arrays, Arrays]:
        return self._seen(self.r.kinematics.table)

    @cached_property
    def _distinct(self) -> tuple[Arrays, Arrays]:
        """Without the last position of a full turn, which is the first."""
        places, turns = ({k: x[: self._count] for k, x in arrays.items()} for arrays in self._whole)
        return places, turns

    @property
    def _count(self) -> int:
        kinematics = self.r.kinematics
        return len(kinematics.turned) - (1 if kinematics.cycle.closed else 0)

    @cached_property
    def _paths(self) -> Arrays:
        return self._seen(self.r.kinematics.diagram)[0]

    def _seen(self, motion: Motion) -> tuple[Arrays, Arrays]:
        places = {point: motion.place(point) for point in self.mechanism.point_names}
        turns = {link: motion.turn(link) for link in self.mechanism.moving}
        places, turns = ({k: np.broadcast_to(x, motion.shape) for k, x in a.items()} for a in (places, turns))
        return places, turns

    @property
    def _zero(self) -> complex:
        return complex(self.r.kinematics.table.turn(self.mechanism.driver.link)[0])

    # ------------------------------------------------------------ plans

    @once
    def plan(self, drawn: Plan) -> Drawing:
        """A plan of velocities or accelerations, at its scale."""
        vectors = [
            PlanVector(s.start, s.end, symbol(s.key), "coriolis" if s.key.endswith("_k") else STYLES[s.role])
            for s in drawn.strokes
        ]
        return plan(vectors, drawn.vertices, pole=drawn.pole)

    @once
    def force_plan(self, drawn: ForcePlan) -> Drawing:
        vectors = [PlanVector(s.start, s.end, symbol(s.key), STYLES[s.kind]) for s in drawn.strokes]
        return plan(vectors, {})

    @once
    def lever(self, position: int) -> Drawing | None:
        """Zhukovsky's lever: the plan of velocities turned by 90° with the loads on its points; None where no plan
        of velocities is drawn. It stands upright on the page; lengths of the forces only hint at their sizes."""
        drawn = next((d.velocity for d in self.r.plans.drawn if d.position == position), None)
        if drawn is None:
            return None
        loads = [load for load in self._loads_at(position) if abs(load[2]) > 0]
        largest = max((abs(force) for _, _, force in loads), default=1.0)
        turn = 1j * min(1.0, LEVER / max(map(abs, drawn.vertices.values())))
        vectors = [PlanVector(turn * s.start, turn * s.end) for s in drawn.strokes]
        for key, point, force in loads:
            fixed = point in self.mechanism.links[FRAME].points
            z = 0j if fixed else turn * drawn.vector(f"v_{point}")
            arrow = force / abs(force) * (10 + 20 * abs(force) / largest)
            style: Style = "inertia" if key.startswith("F_I") else "force"
            vectors.append(PlanVector(z, z + arrow, symbol(key), style))
        return plan(vectors, {name: turn * z for name, z in drawn.vertices.items()}, pole=drawn.pole)

    def _loads_at(self, position: int) -> list[tuple[str, str, complex]]:
        """Forces at a table position: symbol, point, complex N; inertia forces among them."""
        found = self.r.kinetostatics
        load, stated = found.table.loading, found.given.forces
        centre = {link: str(self.mechanism.links[link].mass_centre) for link in load.gravity}
        rows = [(f"G_{link}", centre[link], force) for link, force in load.gravity.items()]
        rows += [(f"F_I{link}", centre[link], force) for link, force in load.inertia.items()]
        keys = load_keys([force.at for force in stated])
        rows += [(key, f.at, force) for key, f, force in zip(keys, stated, load.forces, strict=True)]
        return [(key, point, complex(force[position])) for key, point, force in rows]

    # ------------------------------------------------------------ graphs

    @once
    def travel(self, travel: Travel) -> Graph:
        """Displacement, velocity and acceleration of an output over the angle of turn."""
        rocker = travel.output.kind == "rocker"
        names = (
            (("ψ", "deg"), ("ω", "rad/s"), ("ε", "rad/s²"))
            if rocker
            else (("S", "m"), ("V", "m/s"), ("a", "m/s²"))
        )
        factors = (np.degrees(1) if rocker else 1.0, 1.0, 1.0)
        values = (travel.diagram_S, travel.diagram_V, travel.diagram_a)
        peaks = ((travel.near, travel.far), travel.V_extremes, travel.a_extremes)
        sizes = np.abs(self.r.kinematics.omega) ** np.arange(3) * (1.0 if rocker else self._reach)
        curves = [
            Curve(x * factor, panel=k, extremes=_points(ends, factor), scale=size * factor)
            for k, (x, factor, ends, size) in enumerate(zip(values, factors, peaks, sizes, strict=True))
        ]
        return self._graph(curves, [self._label(*name) for name in names])

    @cached_property
    def _reach(self) -> float:
        """Speed of the fastest point over that of the driver's turning, m: the size of what moves."""
        motion = self.r.kinematics.table
        speeds = [np.nanmax(np.abs(motion.velocity(p)), initial=0.0) for p in self.mechanism.point_names]
        return float(max(speeds) / abs(self.r.kinematics.omega))

    def travel_scales(self, travel: Travel) -> list[Scale]:
        if travel.output.kind == "rocker":
            axes = (("mu_psi", "°/mm"), ("mu_omega", "(rad/s)/mm"), ("mu_epsilon", "(rad/s²)/mm"))
        else:
            axes = (("mu_S", "m/mm"), ("mu_V", "(m/s)/mm"), ("mu_a", "(m/s²)/mm"))
        return self._scales(self.travel(travel), axes)

    def balancing_scales(self) -> list[Scale]:
        return self._scales(self.balancing(), [("mu_M", "N·m/mm")])

    def _scales(self, drawn: Graph, names: Sequence[tuple[str, str]]) -> list[Scale]:
        """What 1 mm along the axis of the angle and along the axis of each panel stands for."""
        scales = [("mu_phi", drawn.panels[0].x_scale, "°/mm")]
        for (name, unit), panel in zip(names, drawn.panels, strict=True):
            scales.append((name, panel.y_scale, unit))
        return scales

    @once
    def balancing(self) -> Graph:
        found = self.r.kinetostatics
        label = self._label("M" + self.tr.pgettext("index", "bal"), "N·m")
        size = float(np.nanmax(found.diagram.scale, initial=0.0))
        curve = Curve(found.diagram.balancing, extremes=_points(found.extremes), scale=size)
        return self._graph([curve], [label])

    @once
    def losses(self) -> Graph:
        losses = self.r.friction.diagram
        curves = [Curve(losses.total, panel=0), Curve(losses.efficiency, panel=1)]
        return self._graph(curves, [self._label("P" + self.tr.pgettext("index", "fr"), "W"), "η"], join=False)

    def _label(self, name: str, unit: str) -> str:
        return f"{name}, {unit_text(unit, self.tr.language)}"

    def _graph(self, curves: Sequence[Curve], labels: Sequence[str], join: bool = True) -> Graph:
        kinematics = self.r.kinematics
        return graph(
            curves,
            np.degrees(kinematics.diagram_turned),
            self._label("φ", "deg"),
            labels,
            positions=kinematics.positions.table if kinematics.cycle.closed else 0,
            comma=self.tr.decimal == ",",
            join=join,
        )


def _points(extremes: Sequence[Extreme], factor: float = 1.0) -> list[tuple[float, float]]:
    """Extremes as points of a graph: angle of turn, degrees, and value."""
    return [(math.degrees(extreme.turned), float(extreme.value * factor)) for extreme in extremes]
