"""The numbers of a driving slider or cylinder: the balancing force along its stroke, by three ways."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.chapters.lever.kinematics.solve.analogues import time
from tmm_report.chapters.lever.kinematics.solve.points_and_links import along
from tmm_report.mechanics.lever.cycle import Extreme, least_and_greatest
from tmm_report.mechanics.lever.driving.stroke import Stroke
from tmm_report.mechanics.lever.extremes import peaks
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved

Array = Any

TABLE = Message(N_("the balancing force along the stroke of the driving slider or cylinder, by three ways"))
FORCE = Quantity("F_stroke", Symbol("F", "bal"), "N", Message(N_("balancing force along the stroke")))


def by_lever(of: Quantity, key: str) -> Quantity:
    return replace(of, key=key, meaning=Message(N_("%(of)s by Zhukovsky's lever"), {"of": of.meaning}))


def by_power(of: Quantity, key: str) -> Quantity:
    return replace(of, key=key, meaning=Message(N_("%(of)s by the power balance"), {"of": of.meaning}))


BY_LEVER, BY_POWER = by_lever(FORCE, "F_lever"), by_power(FORCE, "F_power")


def tables(found: Kinetostatics) -> Iterator[Table]:
    stroke = found.kinematics.stroke
    if stroke is None:
        return
    for name, solved in (("table", found.table), ("diagram", found.diagram)):
        yield Table(f"drive_{name}", TABLE, (*where(solved.turned, True), *_columns(stroke, solved)))
    if found.asked is not None:
        turned = found.asked.turned
        at = (along(True).column(np.degrees(turned)), time(found.kinematics, turned))
        columns = (replace(one, asked=False) for one in _columns(stroke, found.asked))
        yield Table("drive_at", TABLE, (*at, *columns))


def _columns(stroke: Stroke, solved: Solved) -> Iterator[Column]:
    transfer = stroke.transfer(stroke.law.of_phase(solved.motion.phase)[0])
    yield FORCE.column(np.broadcast_to(solved.statics.driving, solved.motion.shape))
    yield BY_LEVER.column(solved.lever * transfer)
    yield BY_POWER.column(solved.power * transfer)


def values(found: Kinetostatics) -> Iterator[Value]:
    """The least and the greatest force: where the moment has extremes."""
    if found.kinematics.stroke is None:
        return
    texts = (N_("least balancing force along the stroke"), N_("greatest balancing force along the stroke"))
    for end, key, text in zip(extremes(found), ("min", "max"), texts, strict=True):
        meaning = Message(text)
        yield replace(FORCE, key=f"F_stroke_{key}", meaning=meaning).value(end.value, end.turned, end.side)


def extremes(found: Kinetostatics) -> tuple[Extreme, Extreme]:
    """Over the whole cycle, both sides of a jump; where some position has no forces, of the diagram positions."""
    over = found.over
    if over is not None:
        found_ends: tuple[Extreme, Extreme] = peaks(
            over.panels, over.on(over.statics.driving)[None], over.closed
        )[0]
        return found_ends
    return least_and_greatest(found.diagram.statics.driving, found.diagram.turned)
