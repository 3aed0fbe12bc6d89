"""A question asked backwards: at which value of an unknown number a number of the results is as it is demanded.

The variant is solved as it stands with many values of the unknown, on a grid and then closer to the places where the
demand is met (mechanics/calculus/seek.py).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.find import pair
from tmm_report.chapters.find.asking import Answer, Asking, Course, Numbers
from tmm_report.chapters.find.closed import Closed, closed
from tmm_report.chapters.find.given import Given
from tmm_report.chapters.find.letters import letters
from tmm_report.chapters.find.pair import Both
from tmm_report.chapters.find.target import Target, level
from tmm_report.mechanics.calculus.seek import Asked, Root, Sought, best, seek, slopes
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.text import Amount
from tmm_report.records import dataclass

__all__ = ["Answer", "Both", "Course", "Found", "Given", "Numbers", "solve"]

Array = Any

MOST = 600  # values of the unknown at which a variant is solved
TOLD = 12  # roots whose sensitivity is told
ALIKE = 1e-12  # of the greatest value: by less rounding differs


@dataclass(frozen=True, eq=False)
class Found:
    """`level`: the wanted number in the unit of the results, nan of the best value; `sought`: over parts of the range;
    `slopes`: of the roots, by the unknown in SI; `chosen`: what the variant is solved with; `solved`: how many times
    it was solved; `reason`: why there are values of the unknown with no results; `within`: the demand is met all over
    the range, though nowhere just so; `letter`: as the variant's own numbers call the unknown, where they do; `closed`:
    what the textbook's formula gives, where it has one; `doubts`: what was not tried."""

    given: Given
    target: Target
    level: float
    sought: Sought
    slopes: tuple[float, ...]
    chosen: Root
    solved: int
    reason: Message | None
    within: bool
    letter: Quantity | None = None
    closed: Closed | None = None
    doubts: Sequence[Problem] = ()

    @property
    def sound(self) -> bool:
        """Whether the demand is met."""
        return bool(self.sought.roots) or self.within

    @property
    def number(self) -> float:
        """The chosen value of the unknown, in its own unit."""
        return self.given.unknown.at(self.chosen.at)

    @property
    def numbers(self) -> Numbers:
        return (self.number,)

    def size(self, part: float) -> float:
        """The unknown at a part of the range, SI."""
        return self.given.unknown.size(self.given.unknown.at(part))

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        unknown, demand = self.given.unknown, self.given.demand
        told = {
            "unknown": unknown.name,
            "x": Amount(self.number, 8, unknown.unit),
            "name": demand.name,
            "y": Amount(self.chosen.value, 8, self.target.quantity.unit),
            "count": len(self.sought.roots),
        }
        if not self.sound:
            yield Message(N_("find: not met; nearest is %(unknown)s = %(x)s, where %(name)s = %(y)s"), told)
        elif demand.best or self.within:
            yield Message(N_("find: %(unknown)s = %(x)s, where %(name)s = %(y)s"), told)
        else:
            yield Message(N_("find: %(unknown)s = %(x)s, where %(name)s = %(y)s; roots: %(count)s"), told)


def solve(given: Given, course: Course) -> Found | Both:
    """Raises ProblemError: nothing can be solved in the range; the demand names no number; no such root."""
    if len(given.unknowns) > 1:
        return pair.solve(given, course)
    asking = Asking(given, course, MOST)
    of, asked = asking.targets[0], Asked(lambda parts: asking(parts[:, None])[:, 0])
    demand = given.demand
    if demand.best:
        sought, wanted = best(asked, demand.best), math.nan
    else:
        wanted = level(demand, of)
        sought = seek(asked, wanted)
    _depends(given, sought)
    rates = _rates(given, sought.roots, asked, demand.best is not None)
    chosen, within = _chosen(given, sought, wanted)
    (letter,) = letters(given, asking.samples)
    form = closed(given, of, wanted, asking.samples) if sought.roots else None
    told = (len(asked.answers), asking.reason, within, letter, form, asking.doubts)
    return Found(given, of, wanted, sought, rates, chosen, *told)


def _depends(given: Given, sought: Sought) -> None:
    """Raises ProblemError where the number is the same all over the range."""
    sound = sought.f[np.isfinite(sought.f)]
    if np.ptp(sound) > ALIKE * np.abs(sound).max():
        return
    text = N_("%(name)s does not depend on %(unknown)s: it is %(value)s all over the range")
    told = {"name": given.demand.name, "unknown": given.unknown.name, "value": f"{sound[0]:.6g}"}
    right = Message(N_("name another number of the results, or another unknown"))
    raise ProblemError([mistake(text, given.demand.path, right, **told)])


def _rates(given: Given, roots: Sequence[Root], asked: Asked, best: bool) -> tuple[float, ...]:
    """Derivatives of the demanded number by the unknown, SI; of the best value there is none to tell."""
    if best or not roots:
        return (math.nan,) * len(roots)
    unknown = given.unknown
    width = unknown.size(unknown.high) - unknown.size(unknown.low)
    told = roots[:TOLD]
    found = slopes(asked, np.array([root.at for root in told])) / width
    return (*found.tolist(), *(math.nan,) * (len(roots) - len(told)))


def _chosen(given: Given, sought: Sought, wanted: float) -> tuple[Root, bool]:
    """The root that is asked for; where there is none the end of a range all of which meets the demand, else the
    nearest place. Raises ProblemError."""
    if roots := sought.roots:
        return roots[pair.place(given, len(roots))], False
    sound = np.flatnonzero([math.isfinite(y) and given.demand.met(y - wanted) for y in sought.f.tolist()])
    if sound.size:
        k = int(sound[0 if given.choose > 0 else -1])
        return Root(float(sought.x[k]), float(sought.f[k])), True
    return sought.nearest, False
