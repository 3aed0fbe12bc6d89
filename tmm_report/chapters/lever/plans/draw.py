"""The plans of velocities and accelerations as pictures."""

from __future__ import annotations

from tmm_report.chapters.lever.plans.drafting import Plan
from tmm_report.chapters.lever.plans.drafting.plan import Role, Stroke
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import lettered
from tmm_report.figures.plans import PlanVector, Style, plan

STYLES: dict[Role, Style] = {
    "absolute": "absolute", "relative": "relative", "bend": "component", "rate": "component",
    "line": "construction",
}  # fmt: skip


def plan_picture(drawn: Plan) -> Drawing:
    """A plan of velocities or accelerations, at its scale."""
    vectors = [PlanVector(s.start, s.end, lettered(s.symbol), _style(s), s.key) for s in drawn.strokes]
    return plan(vectors, drawn.vertices, pole=drawn.pole)


def _style(stroke: Stroke) -> Style:
    of = stroke.symbol
    return "coriolis" if of is not None and of.sup == "k" else STYLES[stroke.role]
