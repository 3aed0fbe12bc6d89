"""The schemes of a lever mechanism that its initial data, structure and kinematics print: one set for a note."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmm_report.report.page import Page
from tmm_report.report.schemes import Schemes

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def schemes_of(lever: LeverFound, page: Page) -> Schemes:
    """The schemes of the note, made once for all its chapters."""
    return page.once(_schemes, lever)


def _schemes(lever: LeverFound) -> Schemes:
    k = lever.kinematics
    # every turn goes through the same places: those of the first are drawn
    turns, count = k.cycle.turns, k.positions.diagram
    paths = k.diagram if turns == 1 else k.cycle.motion(k.cycle.once(count)[: count // turns + 1])
    return Schemes(lever.given.mechanism, k.table, paths, k.distinct, lever.plans.length_scale)
