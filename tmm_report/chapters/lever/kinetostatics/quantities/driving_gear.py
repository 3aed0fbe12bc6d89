"""The numbers of a driving link turned by a gear: the balancing force on the line of action over the cycle."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from tmm_report.chapters.lever.kinematics.quantities import where
from tmm_report.mechanics.lever.forces.force_on_crank_gear import GearDrive
from tmm_report.problems import N_, Message
from tmm_report.quantity.model import Column, Quantity, Table, Value
from tmm_report.quantity.symbols import Symbol

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinetostatics.solve.positions import Kinetostatics, Solved

TABLE = Message(N_("the balancing force of the gear on the driving link, along the line of action"))
PITCH_RADIUS = Quantity(
    "r_w_gear",
    Symbol("r", "w"),
    "m",
    Message(N_("working pitch radius of the gear on the driving link")),
)
ANGLE = Quantity("alpha_w_gear", Symbol("alpha", "w"), "deg", Message(N_("angle of engagement of the gear")))
BASE_RADIUS = Quantity(
    "r_b_gear",
    Symbol("r", "b"),
    "m",
    Message(N_("radius of the base circle of the gear: the arm of its force")),
)
FORCE = Quantity("F_bal", Symbol("F", "bal"), "N", Message(N_("balancing force in the teeth of the gear")))
WAY = Quantity(
    "alpha_F_bal",
    Symbol("alpha", "F"),
    "deg",
    Message(N_("angle of the line of action, in the sense of a positive force, with the x axis")),
)


def gear_of(found: Kinetostatics) -> GearDrive | None:
    return found.kinematics.linkage.mechanism.driver.gear


def tables(found: Kinetostatics) -> Iterator[Table]:
    gear = gear_of(found)
    if gear is not None:
        for name, solved in (("table", found.table), ("diagram", found.diagram)):
            yield Table(f"gear_{name}", TABLE, (*where(solved.turned), *_columns(found, solved, gear)))


def _columns(found: Kinetostatics, solved: Solved, gear: GearDrive) -> Iterator[Column]:
    omega, moment = found.kinematics.omega, solved.balancing
    yield FORCE.column(gear.size(moment, omega))
    yield WAY.column(np.degrees(np.angle(gear.line(moment, omega))) % 360)


def values(found: Kinetostatics) -> Iterator[Value]:
    """The gear, and the extremes of the force: where those of the moment are."""
    gear = gear_of(found)
    if gear is None:
        return
    yield PITCH_RADIUS.value(gear.radius)
    yield ANGLE.value(float(np.degrees(gear.pressure)))
    yield BASE_RADIUS.value(float(gear.base_radius))
    ends = [(gear.size(end.value, found.kinematics.omega), end.turned) for end in found.extremes]
    for (force, turned), key, text in zip(
        sorted(ends),
        ("min", "max"),
        (N_("least balancing force"), N_("greatest balancing force")),
        strict=True,
    ):
        yield Quantity(f"F_bal_{key}", FORCE.sign, "N", Message(text)).value(float(force), turned)
