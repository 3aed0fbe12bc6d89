"""Chapter 3, graph-analytical method: force plans of the groups and of the driving link at the positions asked for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from tmm_report.chapters.force_plans.drafting import ForceDrawn, draw
from tmm_report.chapters.force_plans.lever import Lever, levers
from tmm_report.chapters.kinetostatics.solve import Kinetostatics
from tmm_report.chapters.plans.given import Drawing
from tmm_report.chapters.plans.solve import Plans


@dataclass(frozen=True, eq=False)
class ForcePlans:
    drawn: tuple[ForceDrawn, ...]
    singular: tuple[int, ...]
    levers: tuple[Lever, ...] = ()

    @property
    def worst(self) -> float:
        """Largest |delta| of all reactions and moments, %."""
        return max(
            (abs(c.delta) for d in self.drawn for c in d.comparison if c.delta is not None), default=0.0
        )


def solve(drawing: Drawing, positions: Sequence[int], found: Kinetostatics, plans: Plans) -> ForcePlans:
    lost = (*found.kinematics.singular, *found.kinematics.missing)
    regular = [k for k in positions if k not in lost]
    drawn = tuple(draw(found, k, plans.length_scale, drawing) for k in regular)
    singular = tuple(k for k in positions if k not in regular)
    return ForcePlans(drawn, singular, levers(found, drawn, plans))
