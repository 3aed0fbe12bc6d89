"""Where a law of a load is read: its argument at the positions of a mechanism."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from tmm_report.chapters.lever.kinetostatics.given import Force, Moment
from tmm_report.chapters.lever.kinetostatics.solve.coordinates import coordinate
from tmm_report.chapters.lever.kinetostatics.solve.indicator_strokes import travelled, under_way
from tmm_report.chapters.lever.kinetostatics.solve.lengths import turned as turned_against
from tmm_report.chapters.lever.kinetostatics.ties import Twist
from tmm_report.mechanics.calculus.laws import ByPosition, ByTime, Diagram, Law
from tmm_report.mechanics.lever.motion import Motion

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any


class Reading(NamedTuple):
    """A law of the cycle, the places on its axis and the curves that hold there, (..., P)."""

    law: Law
    at: Array
    which: Array

    @property
    def value(self) -> Array:
        return self.law.value(self.at, self.which)


def reading(load: Force | Moment, kinematics: Kinematics, motion: Motion, turned: Array) -> Reading:
    """Of a load at angles `turned`, rad."""
    law = load.law
    if isinstance(load, Twist):
        return Reading(law, turned_against(load, kinematics, motion), 0)
    if not isinstance(law, Diagram):
        return Reading(over_cycle(law, kinematics), turned, 0)
    of = coordinate(load, kinematics.cycle)
    x = travelled(kinematics.cycle, motion, of)
    return Reading(law, x, under_way(law, kinematics.cycle, motion, turned, x, of))


def over_cycle(law: Law, kinematics: Kinematics) -> Law:
    """Over the angle turned from position 0, and repeated where the driving link goes round."""
    cycle = kinematics.cycle
    if isinstance(law, ByPosition):
        law = law.by_angle(cycle.period / kinematics.positions.table)
    if isinstance(law, ByTime):
        law = law.by_angle(abs(kinematics.omega))
    return law.repeating(cycle.period) if cycle.closed else law
