"""Chapter of wear: guides with their sliders and pivots, from the reactions and the sliding over the cycle.

The law and its sources are in mechanics/pairs/wear.py.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.chapters.lever.kinetostatics.solve.positions import Solved, at, stated
from tmm_report.chapters.machine.wear import guide, pivot
from tmm_report.chapters.machine.wear.given import Given
from tmm_report.chapters.machine.wear.guide import GuideFound
from tmm_report.chapters.machine.wear.pivot import PivotFound
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.text import amounts
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from tmm_report.chapters.lever.moving import Moving

__all__ = ["Found", "Given", "solve"]


@dataclass(frozen=True, eq=False)
class Found:
    """Found by `solve`."""

    given: Given
    guides: tuple[GuideFound, ...]
    pivots: tuple[PivotFound, ...]

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        for one in self.guides:
            text = N_("wear of guide %(name)s: up to %(depth)s µm after %(cycles)s cycles")
            values = amounts({"depth": 1e6 * one.worst.greatest, "cycles": one.given.cycles})
            yield Message(text, {"name": one.given.guide, **values})
        for of in self.pivots:
            text = N_("wear of pivot %(name)s: up to %(depth)s µm after %(cycles)s cycles")
            values = amounts({"depth": 1e6 * of.worst.greatest, "cycles": of.given.cycles})
            yield Message(text, {"name": of.given.pivot, **values})


def solve(given: Given, moving: Moving | None) -> Found:
    """`moving`: the solved lever mechanism with its forces. Raises ProblemError with all that cannot be solved."""
    if moving is None or moving.forces is None:
        raise ProblemError(
            [mistake(N_("the wear follows from the reactions, and there are no loads"), ("wear",))]
        )
    solved, cycle = _solved(given, moving), moving.kinematics.cycle
    problems: list[Problem] = []
    guides, pivots = [], []
    for index, stated_guide in enumerate(given.guides):
        try:
            guides.append(guide.solve(stated_guide, solved, cycle, index))
        except ProblemError as error:
            problems += error.problems
    for index, stated_pivot in enumerate(given.pivots):
        try:
            pivots.append(pivot.solve(stated_pivot, solved, cycle, index))
        except ProblemError as error:
            problems += error.problems
    if problems:
        raise ProblemError(problems)
    return Found(given, tuple(guides), tuple(pivots))


def _solved(given: Given, moving: Moving) -> Solved:
    """The forces at equal steps over the whole cycle, each position once."""
    kinematics, forces = moving.kinematics, moving.forces
    assert forces is not None
    cycle = kinematics.cycle
    if not cycle.closed:
        text = N_("the driving link makes no full turns: the wear of a cycle is not known")
        raise ProblemError([mistake(text, ("wear",))])
    turned = cycle.turned(given.positions)
    motion = cycle.motion(turned)
    return at(forces.given, motion, turned, stated(forces.given, kinematics, motion, turned))
