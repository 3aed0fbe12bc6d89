"""The numbers of a press, over the stroke to its dead point."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.lever.press.solve import Found
from tmm_report.chapters.lever.press.values import Stroke
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Table, Value
from tmm_report.quantity.tabulated import tabulated

Array = Any
STROKE = Message(N_("slider of the press before its dead point"))
STEP, MOST = 5.0, 90.0  # degrees between the rows of the table, and up to which it goes
CURVE = 120  # intervals of the diagram


@tabulated
def tables(found: Found) -> Iterator[Table]:
    most = min(MOST, np.degrees(found.begins))
    rows = np.radians(np.arange(0.0, most + 1e-9, STEP))
    curve = np.linspace(0.0, found.begins, CURVE + 1)
    for name, alpha in (("table", rows), ("diagram", curve)):
        yield Table(f"press_{name}", STROKE, tuple(_columns(found, alpha)))


@tabulated
def values(found: Found) -> Iterator[Value]:
    return found.s.values()


def _columns(found: Found, alpha: Array) -> Iterator[Column]:
    motion = found.before(alpha)
    still = (alpha == 0) | (alpha == found.begins)  # to the last digit
    arm = np.where(still, 0.0, found.arm(motion))
    yield Stroke.alpha.column(alpha)
    yield Stroke.s.column(np.where(alpha == 0, 0.0, found.path(motion)))
    yield Stroke.h.column(arm)
    yield Stroke.v.column(np.where(still, 0.0, found.output.velocity(motion)))
    if found.given.torque is not None:
        yield Stroke.F_lim.column(found.given.torque / np.where(still, np.nan, arm))
    if found.given.rated is not None:
        yield Stroke.F_nom.column(np.full(len(alpha), found.given.rated))
