"""Diagrams of the motion of the outputs over the angle of turn."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import motion_of
from tmm_report.chapters.lever.kinematics.solve.analogues import analogues_of, in_unit_motion
from tmm_report.chapters.lever.kinematics.solve.points_and_links import along
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, Travel
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.i18n import Translator
from tmm_report.quantity.formula import Var
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs, points

SCALES = {
    "slider": (("mu_S", "m/mm"), ("mu_V", "(m/s)/mm"), ("mu_a", "(m/s²)/mm")),
    "rocker": (("mu_psi", "°/mm"), ("mu_omega", "(rad/s)/mm"), ("mu_epsilon", "(rad/s²)/mm")),
}


ANALOGUES = {
    "slider": (("mu_S′", "m/mm"), ("mu_S′′", "m/mm")),
    "rocker": (("mu_psi′", "1/mm"), ("mu_psi′′", "1/mm")),
}


class Diagrams:
    def __init__(self, found: Kinematics, tr: Translator):
        self.found = found
        self.graphs = CycleGraphs(found.diagram_turned, found.numbered, tr, along(found.by_law).sign)
        self._made: dict[str, Graph] = {}

    def travel(self, travel: Travel) -> Graph:
        """Displacement, velocity and acceleration of an output."""
        if travel.output.name not in self._made:
            self._made[travel.output.name] = self._travel(travel)
        return self._made[travel.output.name]

    def _travel(self, travel: Travel) -> Graph:
        rocker = travel.output.kind == "rocker"
        factors = (np.degrees(1) if rocker else 1.0, 1.0, 1.0)
        values = (travel.diagram_S, travel.diagram_V, travel.diagram_a)
        peaks = ((travel.near, travel.far), travel.V_extremes, travel.a_extremes)
        sizes = np.abs(self.found.omega) ** np.arange(3) * (1.0 if rocker else self._reach)
        curves = [
            Curve(x * factor, panel=k, extremes=points(ends, factor), scale=size * factor)
            for k, (x, factor, ends, size) in enumerate(zip(values, factors, peaks, sizes, strict=True))
        ]
        return self.graphs.graph(curves, [self.graphs.label(one) for one in motion_of(travel.output)])

    def analogues(self, travel: Travel) -> Graph:
        """Analogues of the velocity and of the acceleration of an output."""
        name = f"{travel.output.name}′"
        if name not in self._made:
            self._made[name] = self._analogues(travel)
        return self._made[name]

    def _analogues(self, travel: Travel) -> Graph:
        size = 1.0 if travel.output.kind == "rocker" else self._reach
        curves = [
            Curve(x, panel=panel, extremes=ends, scale=size)
            for panel, (x, ends) in enumerate(self._by_angle(travel))
        ]
        named = (
            (quantity.sign.base.replace("psi", "ψ"), quantity.unit)
            for quantity in analogues_of(travel.output)
        )
        return self.graphs.graph(curves, [self.graphs.letter(Symbol(base), unit) for base, unit in named])

    def _by_angle(self, travel: Travel) -> Iterator[tuple[Any, Any]]:
        """Rates by the angle of the driving link at the diagram positions, and their extremes."""
        if self.found.by_law:  # where they are extreme is not sought: rates by the time are extreme elsewhere
            unit = in_unit_motion(self.found.diagram)
            yield travel.output.velocity(unit), ()
            yield travel.output.acceleration(unit), ()
            return
        omega = abs(self.found.omega)
        for n, (x, ends) in enumerate(
            ((travel.diagram_V, travel.V_extremes), (travel.diagram_a, travel.a_extremes)), 1
        ):
            yield x / omega**n, points(ends, omega**-n)

    @cached_property
    def _reach(self) -> float:
        """Speed of the fastest point over that of the driver's turning, m: the size of what moves."""
        motion = self.found.table
        names = self.found.linkage.mechanism.point_names
        speeds = [np.nanmax(np.abs(motion.velocity(point)), initial=0.0) for point in names]
        return float(max(speeds) / abs(self.found.omega))

    def scales(self, travel: Travel) -> list[Var]:
        return self.graphs.scales(self.travel(travel), SCALES[travel.output.kind])

    def analogue_scales(self, travel: Travel) -> list[Var]:
        return self.graphs.scales(self.analogues(travel), ANALOGUES[travel.output.kind])
