"""The gear chapters of the note: which templates, each with the view it prints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from tmm_report.report.page import Page
from tmm_report.report.part import Part


def parts(found: Any, page: Page) -> Iterator[Part]:
    """(template, view) of a gear chapter, in the order of the note."""
    make = _eccentric if found.__class__.__module__.endswith("eccentric.solve") else _drive
    yield from (Part(template, view) for template, view in make(found, page))


def _drive(found: Any, page: Page) -> Iterator[tuple[str, Any]]:
    if found is None:
        return
    from tmm_report.chapters.drive.view import DriveView
    from tmm_report.chapters.planetary.view import PlanetaryView
    from tmm_report.chapters.spur import solve as spur
    from tmm_report.chapters.spur.view import SpurView

    whole = DriveView(found, page, "drive")
    yield "drive", whole
    for number, stage in enumerate(found.stages, 1):
        label = f"stage{number}"
        if isinstance(stage, spur.Found):
            yield "spur", SpurView(stage, page, label)
        else:
            yield "planetary", PlanetaryView(stage, page, label)
    yield "drive_whole", whole


def _eccentric(found: Any, page: Page) -> Iterator[tuple[str, Any]]:
    if found is not None:
        from tmm_report.chapters.eccentric.view import EccentricView

        yield "eccentric", EccentricView(found, page, "eccentric")
