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


def plan_picture(drawn: Plan, scale: float | None = None) -> Drawing:
    """A plan of velocities or accelerations, at its own scale or at another."""
    by = drawn.scale / scale if scale else 1.0
    vectors = [
        PlanVector(by * s.start, by * s.end, lettered(s.symbol), _style(s), s.key) for s in drawn.strokes
    ]
    vertices = {name: by * place for name, place in drawn.vertices.items()}
    return plan(vectors, vertices, pole=drawn.pole, scale=scale or drawn.scale)


def _style(stroke: Stroke) -> Style:
    of = stroke.symbol
    return "coriolis" if of is not None and of.sup == "k" else STYLES[stroke.role]
