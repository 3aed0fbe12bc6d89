"""A question asked backwards: at which value of an unknown number a number of the results is as it is demanded.

The variant is solved as it stands with many values of the unknown, on a grid and then closer to the places where the
demand is met (mechanics/calculus/seek.py).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.find.given import Given
from tmm_report.chapters.find.target import Chapter, Target, level, target
from tmm_report.mechanics.calculus.seek import PARTS, Asked, Root, Sought, best, seek, slopes
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any
Answer = Sequence[Chapter] | ProblemError
Course = Callable[[Sequence[float], str], Iterable[Answer]]
"""Values of the unknown in its own unit, the chapter that is asked for ("": all) -> of each its results, or why there
are none."""

MOST = 600  # values of the unknown at which a variant is solved
TOLD = 12  # roots whose sensitivity is told
ALIKE = 1e-12  # of the greatest value: by less rounding differs


@dataclass(frozen=True, eq=False)
class Found:
    """`level`: the wanted number in the unit of the results, nan of the best value; `sought`: over parts of the range;
    `slopes`: of the roots, by the unknown in SI; `chosen`: what the variant is solved with; `solved`: how many times
    it was solved; `reason`: why there are values of the unknown with no results; `within`: the demand is met all over
    the range, though nowhere just so."""

    given: Given
    target: Target
    level: float
    sought: Sought
    slopes: tuple[float, ...]
    chosen: Root
    solved: int
    reason: Message | None
    within: bool

    @property
    def sound(self) -> bool:
        """Whether the demand is met."""
        return bool(self.sought.roots) or self.within

    @property
    def number(self) -> float:
        """The chosen value of the unknown, in its own unit."""
        return self.given.unknown.at(self.chosen.at)

    def size(self, part: float) -> float:
        """The unknown at a part of the range, SI."""
        return self.given.unknown.size(self.given.unknown.at(part))

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        unknown, demand = self.given.unknown, self.given.demand
        told = {
            "unknown": unknown.name,
            "x": f"{self.number:.8g} {unknown.unit}".strip(),
            "name": demand.name,
            "y": f"{self.chosen.value:.8g} {self.target.quantity.unit}".strip(),
            "count": len(self.sought.roots),
        }
        if not self.sound:
            yield Message(N_("find: not met; nearest is %(unknown)s = %(x)s, where %(name)s = %(y)s"), told)
        elif demand.best or self.within:
            yield Message(N_("find: %(unknown)s = %(x)s, where %(name)s = %(y)s"), told)
        else:
            yield Message(N_("find: %(unknown)s = %(x)s, where %(name)s = %(y)s; roots: %(count)s"), told)


def solve(given: Given, course: Course) -> Found:
    """Raises ProblemError: nothing can be solved in the range; the demand names no number; no such root."""
    asking = _Asking(given, course)
    of, asked = asking.target, Asked(asking)
    demand = given.demand
    if demand.best:
        sought, wanted = best(asked, demand.best), math.nan
    else:
        wanted = level(demand, of)
        sought = seek(asked, wanted)
    _depends(given, sought)
    rates = _rates(given, sought.roots, asked, demand.best is not None)
    chosen, within = _chosen(given, sought, wanted)
    return Found(given, of, wanted, sought, rates, chosen, len(asked.answers), asking.reason, within)


class _Asking:
    """The demanded number as a function of parts of the range. `reason`: the first for which there was none."""

    def __init__(self, given: Given, course: Course):
        self.given, self.course = given, course
        self.left = MOST
        self.reason: Message | None = None
        self.target = self._named()

    def _named(self) -> Target:
        """Of the first value of a coarse grid that can be solved. Raises ProblemError."""
        first: ProblemError | None = None
        for part in (0.5, 0.0, 1.0, *np.linspace(0, 1, PARTS // 4 + 1).tolist()):
            (found,) = self.course([self.given.unknown.at(part)], "")
            if not isinstance(found, ProblemError):
                return target(self.given.demand, found)
            first = first or found
        assert first is not None
        text = N_("with no value of the range %(name)s can the variant be solved: %(why)s")
        path = ("find", "unknown", self.given.unknown.name)
        raise ProblemError([mistake(text, path, name=self.given.unknown.name, why=first.problems[0].said)])

    def __call__(self, parts: Array) -> Array:
        numbers = [self.given.unknown.at(part) for part in parts.tolist()][: max(0, self.left)]
        self.left -= len(numbers)
        found = np.full(len(parts), np.nan)
        for k, answer in enumerate(self.course(numbers, self.target.chapter)):
            if isinstance(answer, ProblemError):
                self.reason = self.reason or answer.problems[0].said
            else:
                found[k] = self.target.number(answer)
        return found


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
        if given.choose > len(roots):
            text = N_("there is no root %(number)s: the range has %(count)s")
            right = Message(N_("choose from 1 to %(count)s"), {"count": len(roots)})
            raise ProblemError(
                [mistake(text, ("find", "choose"), right, number=given.choose, count=len(roots))]
            )
        return roots[given.choose - 1 if given.choose > 0 else -1], False
    sound = np.flatnonzero([math.isfinite(y) and given.demand.met(y - wanted) for y in sought.f.tolist()])
    if sound.size:
        k = int(sound[0 if given.choose > 0 else -1])
        return Root(float(sought.x[k]), float(sought.f[k])), True
    return sought.nearest, False
