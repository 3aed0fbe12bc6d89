"""The cam pairs in the note: the chapter of a cam prints them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.chapters.cams.cam.solve.found import Sampled
from tmm_report.report.page import Page
from tmm_report.report.part import Inner

if TYPE_CHECKING:
    from tmm_report.course import LeverFound


def parts(lever: LeverFound, page: Page) -> Iterator[Inner]:
    if lever.cams is not None:
        yield Inner("cam", Sampled(lever.cams, lever.sample), "")
