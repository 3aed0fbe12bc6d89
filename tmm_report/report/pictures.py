"""Pictures of the note: the results handed to `figures` as it draws them."""

from __future__ import annotations

from typing import Any

from tmm_report.chapters.drafting import Plan
from tmm_report.chapters.force_plans import ForcePlan
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import symbol
from tmm_report.figures.plans import PlanVector, Style, plan
from tmm_report.report.page import Page

STYLES: dict[str, Style] = {
    "absolute": "absolute", "relative": "relative", "bend": "component", "rate": "component",
    "gravity": "force", "load": "force", "inertia": "inertia", "reaction": "reaction", "component": "component",
}  # fmt: skip


class Pictures:
    def __init__(self, results: Any, page: Page):
        self.r, self.page = results, page

    def plan(self, drawn: Plan) -> Drawing:
        """A plan of velocities or accelerations, at its scale."""
        vectors = [
            PlanVector(s.start, s.end, symbol(s.key), "coriolis" if s.key.endswith("_k") else STYLES[s.role])
            for s in drawn.strokes
        ]
        return plan(vectors, drawn.vertices, pole=drawn.pole)

    def force_plan(self, drawn: ForcePlan) -> Drawing:
        vectors = [PlanVector(s.start, s.end, symbol(s.key), STYLES[s.kind]) for s in drawn.strokes]
        return plan(vectors, {})

    def one_position(self): return self.plan(self.r.plans.drawn[0].velocity)
    groups=scheme=balancing=losses=one_position
    def travel(self,t): return self.one_position()
    def travel_scales(self,t): return 'x'
