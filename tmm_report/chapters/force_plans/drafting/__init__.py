"""Drafting the force plans of a position on paper, in mm, with the calculations written beside them.

Groups are taken off from the farthest; each loads what it hangs on with its outer reactions, turned round. Loads are
laid off link by link, then the reactions close the plan.
Source: Artobolevsky, Theory of mechanisms and machines, ch. 13; Frolov (ed.), Theory of mechanisms, ch. 5.
"""

from __future__ import annotations

from typing import Any

from tmm_report.chapters.force_plans.drafting import driver, dyad, system
from tmm_report.chapters.force_plans.drafting.plan import Balance, ForceDrawn, ForcePlan
from tmm_report.chapters.force_plans.drafting.sheet import Sheet
from tmm_report.chapters.kinetostatics.solve import Kinetostatics
from tmm_report.mechanics.dyads import Dyad
from tmm_report.mechanics.higher import HigherGroup
from tmm_report.quantity.paper import Pen

__all__ = ["Balance", "ForceDrawn", "ForcePlan", "draw"]


def draw(found: Kinetostatics, position: int, length_scale: float, force_scale: Any, pen: Pen) -> ForceDrawn:
    """Force plans of all groups, the farthest first, and of the driving link, at a table position.

    `length_scale`: m/mm of the scheme from which arms are read; `force_scale`: N/mm, one or by group, or None.
    """
    sheet = Sheet(found, position, length_scale, force_scale, pen)
    plans = [_group(sheet, group) for group in reversed(sheet.motion.linkage.groups)]
    sheet.begin()
    plan, moment = driver.plan(sheet)
    return ForceDrawn(
        position,
        tuple(sheet.inertia),
        (*plans, plan),
        tuple(sheet.reduced),
        tuple(sheet.worked),
        moment,
        tuple(sheet.comparison),
    )


def _group(sheet: Sheet, group: Dyad | HigherGroup) -> ForcePlan:
    sheet.begin()
    return dyad.plan(sheet, group) if isinstance(group, Dyad) else system.plan(sheet, group)
