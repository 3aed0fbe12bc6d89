"""Strokes of a loaded point over the cycle, and which curve of an indicator diagram holds in each.

angle turned   0     begins[0]    begins[1]            begins[n-1]    period
stroke         ·  n-1   |      0      |      1      …       |    n-1     |
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.solve.coordinates import Coordinate
from tmm_report.mechanics.calculus.laws import ByStrokes, Diagram
from tmm_report.mechanics.lever.cycle import Cycle, Extreme
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
WHOLE = 2 * np.pi - 1e-6  # rad: a swing as wide is a whole turn
AT_ONCE = 1e-9  # rad: a stroke that begins so soon has begun
LOADS = ("loads", "forces")


@dataclass(frozen=True, eq=False)
class Strokes:
    """`begins`: angles turned at which the strokes begin, rad, ascending over the cycle, (n,); `stated`: the number of
    the stated stroke that begins there, (n,); `period`: the whole cycle, rad."""

    begins: Array
    stated: Array
    period: float

    def at(self, turned: Array) -> Array:
        """Number of the stated stroke at angles turned, rad; at an end of a stroke, of the one that begins there."""
        within = np.mod(turned + AT_ONCE, self.period)
        return self.stated[np.searchsorted(self.begins, within, side="right") - 1]

    @property
    def ends(self) -> Array:
        """Angles turned at which the strokes end, rad, (n,): the last may end beyond the cycle."""
        return np.append(self.begins[1:], self.begins[0] + self.period)


def reach(cycle: Cycle, of: Coordinate) -> tuple[Array, tuple[Extreme, Extreme]]:
    """Angles turned within one turn at which a coordinate stands still, rad; its extremes there, m or rad."""
    still = cycle.roots(of.rate)
    return still, cycle.extremes_of([of.value], [still])[0]


def strokes(law: ByStrokes, cycle: Cycle, of: Coordinate) -> Strokes:
    """Raises ProblemError where the point makes not as many strokes as are stated, or begins with another one."""
    still, _ = reach(cycle, of)
    begins, count = cycle.repeated(still), len(law.curves)
    if len(begins) != count:
        text = N_("point %(name)s makes %(found)s strokes in the cycle, %(count)s are stated")
        right = Message(N_("a curve for each stroke of the cycle, in the order in which they follow"))
        raise ProblemError([mistake(text, LOADS, right, name=of.name, found=len(begins), count=count)])
    begun = 0 if begins[0] <= AT_ONCE else -1  # which of them is under way just after position 0
    leaves = _leaves(cycle, of, begins)[begun]
    first = law.first if law.first is not None else 0 if leaves else count - 1
    if (first % 2 == 0) != leaves:
        text = N_(
            "point %(name)s goes away from the zero of its diagram at position 0: %(stroke)s is a stroke towards it"
        )
        if not leaves:
            text = N_(
                "point %(name)s goes towards the zero of its diagram at position 0: %(stroke)s is a stroke away from it"
            )
        fitting = ", ".join(law.names[0 if leaves else 1 :: 2])
        right = Message(N_("first: one of %(words)s"), {"words": fitting})
        raise ProblemError([mistake(text, LOADS, right, name=of.name, stroke=law.names[first])])
    return Strokes(begins, (first - begun + np.arange(count)) % count, cycle.period)


def _leaves(cycle: Cycle, of: Coordinate, begins: Array) -> Array:
    """Of each stroke whether the point goes away from the zero in it, (n,) of bool: by its velocity half way."""
    middle = (begins + np.append(begins[1:], begins[0] + cycle.period)) / 2
    return of.rate(cycle.motion(middle)) < 0


def travelled(cycle: Cycle, motion: Motion, of: Coordinate) -> Array:
    """x = displacement / stroke of the loaded point or link, counted from the extreme in `zero`, (..., P).

    Raises ProblemError for what has no stroke in the direction or sense from which the diagram counts.
    """
    _, (low, high) = reach(cycle, of)
    if of.middle is not None and (high.value - low.value > WHOLE or goes_round(cycle, of)):
        text = N_("by_displacement: link %(name)s turns all round and has no swing")
        right = Message(N_("name a link that swings, or give the moment by angle"))
        raise ProblemError([mistake(text, ("loads", "moments"), right, name=of.name)])
    size: Array = 1.0
    if of.middle is None:
        size = np.abs(motion.place(of.name) - np.nanmean(motion.place(of.name)))
    if not high.value - low.value > 1e-9 * np.nanmax(size):
        text = N_("by_displacement: point %(name)s does not move in the direction of zero")
        right = Message(N_("name a point that moves there, or give the load by angle"))
        if of.middle is not None:
            text = N_("by_displacement: link %(name)s does not turn")
        raise ProblemError([mistake(text, LOADS, right, name=of.name)])
    return (high.value - of.value(motion)) / (high.value - low.value)


def goes_round(cycle: Cycle, of: Coordinate) -> bool:
    """Whether a link turns all round: its angular velocity never changes its sign."""
    return not cycle.roots(of.rate).size and cycle.returns


def under_way(law: Diagram, cycle: Cycle, motion: Motion, turned: Array, x: Array, of: Coordinate) -> Array:
    """Number of the curve that holds at angles `turned`, rad, where the point or link has travelled `x`, (..., P): of
    the stroke under way, or of the way in which it goes."""
    if isinstance(law, ByStrokes):
        return strokes(law, cycle, of).at(turned)
    rate = of.rate(motion)
    # at the ends of the stroke it stands still: the stroke that begins there holds, not the rounding's sign
    still = np.abs(rate) <= 1e-9 * np.nanmax(np.abs(rate), initial=0.0)
    return np.where(np.where(still, x < 0.5, rate <= 0), 0, 1)
