"""Diagrams of the motion of the outputs over the angle of turn."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import motion_of
from tmm_report.chapters.lever.kinematics.solve.analogues import analogues_of, in_unit_motion
from tmm_report.chapters.lever.kinematics.solve.jumps import Of, drawn
from tmm_report.chapters.lever.kinematics.solve.points_and_links import along
from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics, Travel
from tmm_report.figures.charts.graphs import Curve, Graph
from tmm_report.i18n import Translator
from tmm_report.mechanics.lever.cycle_search import FULL_TURN
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.quantity.symbols import Symbol
from tmm_report.report.diagrams import CycleGraphs, points

Array = Any


class Diagrams:
    def __init__(self, found: Kinematics, tr: Translator):
        self.found = found
        self.at = drawn(found, found.jumps)
        self.graphs = CycleGraphs(self.at.turned, found.numbered, tr, along(found.by_law).sign)
        self._made: dict[str, Graph] = {}

    def travel(self, travel: Travel) -> Graph:
        """Displacement, velocity and acceleration of an output."""
        if travel.output.name not in self._made:
            self._made[travel.output.name] = self._travel(travel)
        return self._made[travel.output.name]

    def _travel(self, travel: Travel) -> Graph:
        rocker = travel.output.kind == "rocker"
        factors = (np.degrees(1) if rocker else 1.0, 1.0, 1.0)
        output = travel.output
        values = (
            self.at.of(travel.diagram_S, lambda motion: self._displaced(travel, motion)),
            self.at.of(travel.diagram_V, output.velocity),
            self.at.of(travel.diagram_a, output.acceleration),
        )
        peaks = ((travel.near, travel.far), travel.V_extremes, travel.a_extremes)
        sizes = np.abs(self.found.omega) ** np.arange(3) * (1.0 if rocker else self._reach)
        curves = [
            Curve(x * factor, panel=k, extremes=points(ends, factor), scale=size * factor)
            for k, (x, factor, ends, size) in enumerate(zip(values, factors, peaks, sizes, strict=True))
        ]
        return self.graphs.graph(curves, [self.graphs.label(one) for one in motion_of(travel.output)])

    def _displaced(self, travel: Travel, motion: Motion) -> Array:
        """The displacement of an output: of a rocker by so many turns as bring it to its diagram."""
        known = np.isfinite(travel.diagram_S)
        fine = travel.output.coordinate(self.found.diagram)[known]
        start = fine[0] - travel.diagram_S[known][0] if fine.size else np.nan
        moved = travel.output.coordinate(motion) - start
        if travel.output.kind == "slider" or not fine.size:
            return moved
        near = np.interp(self._places(motion), self.found.diagram_turned[known], travel.diagram_S[known])
        return moved + FULL_TURN * np.round((near - moved) / FULL_TURN)

    def _places(self, motion: Motion) -> Array:
        return next(one.turned for one in self.at.sides if one.motion is motion)

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
            for of in (travel.output.velocity, travel.output.acceleration):
                yield self.at.of(of(unit), _in_unit_motion(of)), ()
            return
        omega = abs(self.found.omega)
        output = travel.output
        every = (
            (travel.diagram_V, travel.V_extremes, output.velocity),
            (travel.diagram_a, travel.a_extremes, output.acceleration),
        )
        for n, (x, ends, of) in enumerate(every, 1):
            yield self.at.of(x, of) / omega**n, points(ends, omega**-n)

    @cached_property
    def _reach(self) -> float:
        """Speed of the fastest point over that of the driver's turning, m: the size of what moves."""
        motion = self.found.table
        names = self.found.linkage.mechanism.point_names
        speeds = [np.nanmax(np.abs(motion.velocity(point)), initial=0.0) for point in names]
        return float(max(speeds) / abs(self.found.omega))


def _in_unit_motion(of: Of) -> Of:
    return lambda motion: of(in_unit_motion(motion))
