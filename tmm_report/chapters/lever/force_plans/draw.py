"""The force plans as pictures."""

from __future__ import annotations

from collections.abc import Callable

from tmm_report.chapters.lever.force_plans.drafting import ForcePlan
from tmm_report.chapters.lever.force_plans.drafting.plan import Kind
from tmm_report.figures.drawing import Drawing
from tmm_report.figures.lettering import lettered
from tmm_report.figures.plans import PlanVector, Style, plan

STYLES: dict[Kind, Style] = {
    "gravity": "force", "load": "force", "inertia": "inertia", "reaction": "reaction", "component": "component",
    "inner": "reaction",
}  # fmt: skip


def force_picture(drawn: ForcePlan, words: Callable[[str], str], scale: float | None = None) -> Drawing:
    """At its own scale or at another; `words`: how a word of an index is said."""
    by = drawn.scale / scale if scale else 1.0
    vectors = [
        PlanVector(by * s.start, by * s.end, lettered(s.quantity.symbol, words), STYLES[s.kind], s.key)
        for s in drawn.strokes
    ]
    return plan(vectors, {}, scale=scale or drawn.scale)
