"""The schemes of a lever mechanism that its initial data, structure and kinematics print: one set for a note."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmm_report.report.page import Page
from tmm_report.report.schemes import Schemes

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def schemes_of(lever: LeverFound, page: Page) -> Schemes:
    """The schemes of the note, made once for all its chapters."""
    k = lever.kinematics
    count = len(k.turned) - (1 if k.cycle.closed else 0)
    return page.once(Schemes, lever.given.mechanism, k.table, k.diagram, count, lever.plans.length_scale)
