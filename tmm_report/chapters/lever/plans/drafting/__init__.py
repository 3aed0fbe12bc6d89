"""Drafting a plan of velocities or accelerations on paper, in mm, with the calculations written beside it.

The vector equation of a dyad is solved by crossing two lines of known direction, those of a group above class II
all together; a point of a link is found by the theorem of similarity; a length is read to the drawing's accuracy and
multiplied by the scale.
"""

from __future__ import annotations

from dataclasses import replace

from tmm_report.chapters.lever.plans.drafting import dyad, lead, system, wheels
from tmm_report.chapters.lever.plans.drafting.plan import (
    LegLine,
    Plan,
    Projections,
    Scales,
    Sense,
    Special,
    Step,
)
from tmm_report.chapters.lever.plans.drafting.sheet import Named, Sheet
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.vector_equations import Relation, System, relations
from tmm_report.quantity.paper import Pen

__all__ = [
    "LegLine",
    "Named",
    "Plan",
    "Projections",
    "Scales",
    "Sense",
    "Special",
    "Step",
    "acceleration_plan",
    "velocity_plan",
]


def velocity_plan(motion: Motion, position: int, scales: Scales, pen: Pen, named: Named) -> Plan:
    """Plan of velocities; `motion` at that one position, only its places are used; `named`: the rates of the note."""
    return _drafted(Sheet(motion, position, scales, pen, named, None))


def acceleration_plan(
    motion: Motion, position: int, scales: Scales, pen: Pen, named: Named, velocity: Plan
) -> Plan:
    """Plan of accelerations; normal and Coriolis parts come from the plan of velocities."""
    return _drafted(Sheet(motion, position, scales, pen, named, velocity))


def _drafted(sheet: Sheet) -> Plan:
    first = (*lead.formulas(sheet), *wheels.moved(sheet, sheet.linkage.structure.wheels))
    steps = tuple(_step(sheet, r) for r in relations(sheet.linkage))
    sheet.copy_rates()
    turns = {link: image.turn for link, image in sheet.images.items()}
    return Plan(
        sheet.kind, sheet.worked.position, sheet.scale, sheet.pole, sheet.vertices, tuple(sheet.strokes),
        sheet.segments, sheet.ends, sheet.laid, sheet.values, sheet.per_mm, first, steps, turns, sheet.worked,
        tuple(sheet.senses),
    )  # fmt: skip


def _step(sheet: Sheet, r: Relation | System) -> Step:
    made = dyad.step(sheet, r) if isinstance(r, Relation) else system.step(sheet, r)
    moved = tuple(wheels.moved(sheet, made.group.wheels))
    return replace(made, points=(*made.points, *moved)) if moved else made
