"""Drafting the force plans of a position on paper, in mm, with the calculations written beside them.

Groups are taken off from the farthest, links that meshes move before the groups that move them; each loads what it
hangs on with its outer reactions, turned round. Loads are laid off link by link, then the reactions close the plan.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 13; Frolov (ed.), Theory of mechanisms, ch. 5.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from tmm_report.chapters.lever.force_plans.drafting import driver, dyad, system, thrust, wheel
from tmm_report.chapters.lever.force_plans.drafting.plan import Balance, ForceDrawn, ForcePlan
from tmm_report.chapters.lever.force_plans.drafting.sheet import Sheet
from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics
from tmm_report.chapters.lever.plans.given import Drawing
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.high_class.newton import HigherGroup
from tmm_report.mechanics.lever.wheels.coupled import Coupled

__all__ = ["Balance", "ForceDrawn", "ForcePlan", "draw"]


def draw(found: Kinetostatics, position: int, length_scale: float, drawing: Drawing) -> ForceDrawn:
    """Force plans of all groups, the farthest first, and of the driving link, at a table position.

    `length_scale`: m/mm of the scheme from which arms are read.
    """
    sheet = Sheet(found, position, length_scale, drawing)
    linkage = sheet.motion.linkage
    plans: list[ForcePlan] = []
    for group in reversed(linkage.groups):
        plans += _wheels(sheet, group.group.wheels)
        if not thrust.carries(sheet, group):
            plans.append(_group(sheet, group))
    plans += _wheels(sheet, linkage.structure.wheels)
    last, balancing = _drive(sheet)
    return ForceDrawn(
        position,
        tuple(sheet.inertia),
        (*plans, *last),
        tuple(sheet.reduced),
        tuple(sheet.worked),
        balancing,
        tuple(sheet.comparison),
        tuple(sheet.apart),
        tuple(sheet.loads),
        tuple(sheet.turning),
    )


def _group(sheet: Sheet, group: Dyad | HigherGroup) -> ForcePlan:
    sheet.begin()
    return dyad.plan(sheet, group) if isinstance(group, Dyad) else system.plan(sheet, group)


def _wheels(sheet: Sheet, wheels: Sequence[Coupled]) -> Iterator[ForcePlan]:
    for one in reversed(wheels):
        sheet.begin()
        yield wheel.plan(sheet, one)


def _drive(sheet: Sheet) -> tuple[list[ForcePlan], float]:
    """Of the driving link with the balancing moment, N m, or of what a stroke drives with the force along it, N."""
    if sheet.mechanism.driver.stroke is not None:
        return thrust.plans(sheet)
    sheet.begin()
    plan, moment = driver.plan(sheet)
    return [plan], moment
