"""A driving slider or cylinder of a mechanism as it is written, and the link that follows it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from tmm_report.chapters.lever.structure.block.strokes.models import StrokeModel
from tmm_report.chapters.lever.structure.block.strokes.models import build as law_of
from tmm_report.chapters.lever.structure.block.strokes.parts import Refused as Refused
from tmm_report.chapters.lever.structure.block.strokes.parts import must_change
from tmm_report.chapters.lever.structure.block.strokes.reverse import moves_dyads, reversed_of
from tmm_report.chapters.lever.structure.block.strokes.triangle import stopped, triangle_of
from tmm_report.mechanics.lever.driving.reversed import Reversed
from tmm_report.mechanics.lever.driving.stroke import Stroke, Turned
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.mechanics.lever.mechanism import Assembly, Driver, Mechanism, ZeroAngle
from tmm_report.problems import ProblemError


def led(
    built: Mechanism,
    stroke: StrokeModel,
    slider: str | None,
    cylinder: tuple[str, str] | None,
    whole: Callable[[], Mechanism],
) -> Mechanism:
    """The mechanism with the law of the link that follows the stroke: by a triangle where there is one, dyads hang
    on its link and it goes all the way, else by reversing the motion of the `whole` mechanism, its wheels among it.
    Raises Refused, ProblemError."""
    law, ends = law_of(stroke), cylinder or ("", "")
    if cylinder is not None:
        must_change(built, cylinder)
    triangle = triangle_of(built, law, slider, ends)
    found: Stroke
    if triangle is None or not moves_dyads(whole(), triangle[0].link):
        found, assembly = reversed_of(whole(), law, slider, ends)
    elif (met := triangle[0].limit()) is None:
        found, assembly = triangle
    else:
        found, assembly = _by_another(triangle[0], met, lambda: reversed_of(whole(), law, slider, ends))
    turned = Turned(found)
    zero = ZeroAngle(float(turned.at(np.zeros(1))[0][0]))
    driver = Driver(found.link, 2 * np.pi / law.period, zero, law=turned, stroke=found)
    return replace(built, driver=driver, assembly=assembly)


def _by_another(
    triangle: Triangle, met: float, way: Callable[[], tuple[Reversed, tuple[Assembly, ...]]]
) -> tuple[Reversed, tuple[Assembly, ...]]:
    """Where a triangle stops on the way, its own link may but turn back, and another be followed all the way."""
    try:
        found = way()
    except (Refused, ProblemError):
        raise stopped(triangle, met) from None
    if not found[0].closes:
        raise stopped(triangle, met)
    return found
