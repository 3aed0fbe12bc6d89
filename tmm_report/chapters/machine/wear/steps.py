"""The single numbers of a guide and of a pivot, each assigned the expression that the note prints."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.machine.wear.values import Depths, Guide, Pivot
from tmm_report.problems import Message
from tmm_report.quantity.formula import Number, cos, sin
from tmm_report.quantity.model import InRow
from tmm_report.quantity.sheet import Q

if TYPE_CHECKING:
    from tmm_report.chapters.machine.wear.guide import GuideFound, Surface
    from tmm_report.chapters.machine.wear.pivot import PivotFound

HOUR = 3600.0  # s


def guide(s: Guide, found: GuideFound) -> None:
    given, grid, worst = found.given, found.grid, found.worst_guide
    s.stroke, s.slider, s.width, s.parts = found.stroke, given.length, given.width, given.parts
    s.length = s.stroke + s.slider
    s.step = s.length / s.parts
    s.ratio = s.slider / s.step
    s.covered, s.positions, s.cycles = grid.covered, len(found.force), given.cycles
    s.greatest, s.repair, s.even = found.worst.greatest, grid.x[worst.worst], found.even
    if found.even:
        of = depth(worst, Message(found.faced(worst.face))).quantity
        deepest = InRow(of, worst.greatest, table=f"{s.PREFIX}profile", row=worst.worst)
        s.uneven = deepest.var("µm") / s.even
    s.shift, s.tilt = map(_largest, found.settled)
    s.volume, s.density = sum(found.volume(one) for one in found.surfaces), given.density
    if given.density is not None:
        s.mass = s.density * s.volume
    _in_time(s, found)


def _in_time(s: Guide, found: GuideFound) -> None:
    """Without running in the wear is the rate by the time."""
    run = found.given.running_in
    s.period, s.limit = found.period, found.given.limit
    s.time = s.cycles * s.period / Number(HOUR)
    s.rate = s.greatest / s.time
    if run is not None:
        s.run_in, s.constant = run.wear, run.time / HOUR
    if found.life is not None:
        s.life = s.limit / s.rate if run is None else found.life / HOUR
        s.life_cycles = 3600 * s.life / s.period


def depth(one: Surface, word: Message) -> Q:
    """The wear of the points of a face; `word`: what it is called."""
    return Depths.u.called(one.symbol, f"u_{one.face}", face=word)


def _largest(values: Any) -> float:
    """The size of the largest, of none 0."""
    return float(np.nanmax(np.abs(values), initial=0.0))


def pivot(s: Pivot, found: PivotFound) -> None:
    given = found.given
    s.take(given, "diameter", "width", "sectors", "cycles", "limit")
    s.arc = given.half_arc
    s.positions, s.pressure, s.rubbed = len(found.force), found.pressure, found.rubbed
    alpha = s.arc
    s.spread = (
        alpha / sin(alpha) if given.law == "uniform" else 2 * sin(alpha) / (alpha + sin(alpha) * cos(alpha))
    )
    s.greatest = found.worst.greatest
    if given.limit is not None:
        s.life_cycles = s.limit / s.greatest * s.cycles
