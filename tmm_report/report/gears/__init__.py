"""The gear chapters of the note: which templates, each with the view it prints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from markupsafe import Markup

from tmm_report.report.page import Page


def chapters(results: Any, page: Page) -> list[tuple[str, Any]]:
    """(template, view) of every gear chapter that was solved, in the order of the note."""
    return [*_drive(results.drive, page), *_eccentric(results.eccentric, page)]


def conclusions(views: list[tuple[str, Any]]) -> list[Markup]:
    """What the conclusions of the note say of the gears."""
    said = dict.fromkeys(view for _, view in views)
    return [line for view in said for line in view.conclusions()]


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
