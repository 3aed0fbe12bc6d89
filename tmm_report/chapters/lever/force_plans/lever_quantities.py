"""The numbers of Zhukovsky's lever: arms and moments of the forces, the balancing force, the ways compared."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.kinetostatics.quantities.driving_stroke import FORCE
from tmm_report.chapters.lever.kinetostatics.quantities.positions import BY_LEVER
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Quantity, Table, text_column
from tmm_report.quantity.symbols import Symbol
from tmm_report.quantity.written import worked_table

if TYPE_CHECKING:
    from tmm_report.chapters.lever.force_plans.lever import Lever

ARMS = Message(N_("arms of the forces as read off the velocity polygon turned by 90°, and their moments"))
COMPARED = Message(N_("the balancing moment by Zhukovsky's lever beside that by other ways"))
THRUST = Message(N_("the balancing force along the stroke by Zhukovsky's lever beside that by other ways"))

SIZE = Quantity("size", Symbol("F"), "N", Message(N_("size of the force")))
ARM = Quantity("arm_mm", Symbol("h′"), "mm", Message(N_("arm of the force about the pole")))
MOMENT = Quantity(
    "moment",
    Symbol("F·h"),
    "N·mm",
    Message(N_("moment of the force about the pole, positive counter-clockwise")),
)
LEVER_SUM = Quantity(
    "SigmaM_p", Symbol("SigmaM", "p"), "N·mm", Message(N_("sum of the moments of the forces about the pole"))
)
LEVER_FORCE = Quantity(
    "P_bal",
    Symbol("P", "bal"),
    "N",
    Message(N_("balancing force at the crank, perpendicular to it, positive counter-clockwise")),
)
LEVER_MOMENT = replace(BY_LEVER, key="M_bal")
DELTA = Quantity("delta", None, "%", Message(N_("difference of the lever from it")))


def arm_on_lever(force: Quantity) -> Quantity:
    name = force.sign
    symbol = Symbol("h′", name.base + name.sub, name.sup)
    meaning = Message(N_("arm of force %(of)s on the lever"), {"of": name})
    return Quantity(f"h_{force.key}_p", symbol, "mm", meaning)


def pair_force(couple: Quantity) -> Quantity:
    """One of the two forces that replace a couple."""
    name = couple.sign
    meaning = Message(N_("force of the pair that replaces moment %(of)s"), {"of": name})
    return Quantity(f"F_{couple.key}", Symbol("F", name.base + name.sub, name.sup), "N", meaning)


def tables(levers: tuple[Lever, ...]) -> Iterator[Table]:
    for lever in levers:
        yield worked_table(lever.worked)
        yield _arms(lever)
        yield _compared(lever)


def _arms(lever: Lever) -> Table:
    """One row a force, the balancing one last."""
    rows = [*lever.arms, lever.driving]
    return Table(
        f"lever_arms_{lever.position}",
        ARMS,
        (
            text_column("force", Message(N_("force")), [row.quantity.key for row in rows]),
            text_column(
                "point",
                Message(N_("point of the polygon at which it acts")),
                [row.point.lower() for row in rows],
            ),
            SIZE.column([abs(row.vector) for row in rows]),
            ARM.column([row.arm for row in rows]),
            MOMENT.column([row.moment for row in rows]),
        ),
    )


def _compared(lever: Lever) -> Table:
    rows = lever.compared
    moment = replace(BY_LEVER, key="moment", meaning=Message(N_("balancing moment")))
    if lever.thrust:
        moment = replace(FORCE, key="force")
    return Table(
        f"lever_compared_{lever.position}",
        THRUST if lever.thrust else COMPARED,
        (
            text_column("way", Message(N_("the other way")), [row.key for row in rows]),
            moment.column([row.analytic for row in rows]),
            DELTA.column([np.nan if row.delta is None else row.delta for row in rows]),
        ),
    )
