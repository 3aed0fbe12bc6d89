"""The motion of the positions by the method that a variant names, or by the cheapest that holds its accuracy."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinematics.given import AUTO, Positions, Way
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.choice import ACCURACY, Choice, choose, named
from tmm_report.mechanics.rivals.motion.every import motion_method
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake

Array = Any
KEY = ("method",)
WIDEST = 0.5  # the largest accuracy that may be stated
OTHERS = N_("method: closed form, or method: auto")
WIDER = N_("method: closed form, method: auto, or accuracy: %(worst)s")


def chosen(way: Way, cycle: Cycle, positions: Positions) -> Choice:
    """The method taken, with its errors at the table and diagram positions. Raises ProblemError where the method that
    is named cannot be used, or loses positions that the mechanism has."""
    counts = tuple(dict.fromkeys((positions.table, positions.diagram)))
    accuracy = ACCURACY if way.accuracy is None else way.accuracy
    if way.method == AUTO:
        return choose(cycle, counts, accuracy)
    why = motion_method(way.method).refuses(cycle)
    if why is not None:
        text = N_("the method cannot be used here: %(why)s")
        raise ProblemError([mistake(text, KEY, Message(OTHERS), why=why)])
    choice = named(way.method, cycle, counts, accuracy)
    if not np.isfinite(choice.worst):
        text = N_("the method does not find the motion at every position that the mechanism has")
        raise ProblemError([mistake(text, KEY, Message(OTHERS))])
    return choice


def own(choice: Choice | None) -> bool:
    """Whether the motion is the program's own."""
    return choice is None or choice.own


def run(choice: Choice, cycle: Cycle, count: int) -> tuple[Array, Motion]:
    """Angles turned at `count` equal steps of the cycle, rad, the last included, and the motion there."""
    turned = np.arange(count + 1) * (cycle.period / count)
    with np.errstate(all="ignore"):
        motion = choice.taken.run(cycle, count)
    driver = cycle.linkage.mechanism.driver
    motion.state.w[driver.link] = driver.omega  # stated, one number, whatever array a method made of it
    return turned, motion


def missed(choice: Choice | None) -> Problem | None:
    """The method that the variant names does not hold the accuracy: a check that failed."""
    if choice is None or choice.holds:
        return None
    text = N_("the method errs by %(worst)s of the largest value, which is more than the accuracy %(asked)s")
    values = {"worst": power(choice.worst), "asked": power(choice.accuracy)}
    right = Message(WIDER, values) if choice.worst <= WIDEST else Message(OTHERS)
    return mistake(text, KEY, right, **values)


def power(value: float) -> str:
    """1e-6, 2.5e-3: as a variant writes it."""
    digits, _, exponent = f"{value:.1e}".partition("e")
    return f"{digits.removesuffix('.0')}e{int(exponent)}" if int(exponent) else digits.removesuffix(".0")
