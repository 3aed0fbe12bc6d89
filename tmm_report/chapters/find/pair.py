"""Two numbers of the file from two demands on the results: all places of a rectangle at which both are met.

The variant is solved on a grid, and closer by Newton's method from its cells (mechanics/calculus/seek_two.py).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmm_report.chapters.find.asking import Asking, Course, Numbers
from tmm_report.chapters.find.closed import Closed, closed_pair
from tmm_report.chapters.find.given import Given
from tmm_report.chapters.find.letters import letters
from tmm_report.chapters.find.target import Target, level
from tmm_report.mechanics.calculus.seek_two import PARTS, Asked, Root, Sought, seek, sizes, slopes
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.model import Quantity
from tmm_report.quantity.text import Amount, equalities
from tmm_report.records import dataclass

Array = Any

MOST = 900  # pairs of values at which a variant is solved
TOLD = 6  # roots whose sensitivities are told
ALIKE = 1e-12  # of the greatest value: by less rounding differs
TOGETHER = 1e-6  # of the product of the slopes of both: a less determinant is of demands that hang together


@dataclass(frozen=True, eq=False)
class Both:
    """`levels`: the wanted numbers in the units of the results; `sought`: over parts of the ranges; `slopes`: of the
    roots, [demand][unknown] by the unknowns in SI, (roots, 2, 2); `chosen`: what the variant is solved with; `solved`:
    how many times it was solved; `reason`: why there are pairs with no results; `letters`: as the variant's own numbers
    call the unknowns, where they do; `doubts`: what was not tried; `closed`: what the textbook's formulas
    give, where it has them, with the number of the unknown."""

    given: Given
    targets: tuple[Target, ...]
    levels: tuple[float, float]
    sought: Sought
    slopes: Array
    chosen: Root
    solved: int
    reason: Message | None
    letters: tuple[Quantity | None, ...]
    doubts: list[Problem]
    closed: tuple[tuple[int, Closed], ...] = ()

    @property
    def sound(self) -> bool:
        """Whether the demands are met."""
        return bool(self.sought.roots)

    @property
    def numbers(self) -> Numbers:
        """The chosen values of the unknowns, in their own units."""
        return self.given.at(self.chosen.at)

    def sizes(self, parts: Any) -> Numbers:
        """The unknowns at parts of their ranges, SI."""
        return self.given.sizes(parts)

    def summary(self) -> Iterator[Message]:
        """The main numbers in sentences."""
        pairs = zip(self.given.unknowns, self.numbers, strict=True)
        made = zip(self.given.demands, self.chosen.value, self.targets, strict=True)
        told = {
            "unknowns": equalities({one.name: Amount(number, 8, one.unit) for one, number in pairs}),
            "results": equalities({of.name: Amount(y, 8, by.quantity.unit) for of, y, by in made}),
            "count": len(self.sought.roots),
        }
        if self.sound:
            yield Message(N_("find: %(unknowns)s, where %(results)s; roots: %(count)s"), told)
        else:
            yield Message(N_("find: not met; nearest is %(unknowns)s, where %(results)s"), told)


def solve(given: Given, course: Course) -> Both:
    """Raises ProblemError: nothing can be solved in the ranges; a demand names no number; no such root; the demands
    depend on one of the unknowns alone, or one of them on none, or on one another."""
    asking = Asking(given, course, MOST)
    first, second = (level(*one) for one in zip(given.demands, asking.targets, strict=True))
    asked, levels = Asked(asking), (first, second)
    line = np.linspace(0, 1, PARTS + 1)
    _depend(given, asked(np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1)))
    sought = seek(asked, levels)
    rates = _rates(given, asked, sought, levels)
    roots = sought.roots
    chosen = roots[place(given, len(roots))] if roots else sought.nearest
    own = letters(given, asking.samples)
    solved, told = len(asked.answers), (asking.reason, own, asking.doubts)
    forms = closed_pair(given, asking.targets, levels, own, asking.samples)
    return Both(given, asking.targets, levels, sought, rates, chosen, solved, *told, forms)


def place(given: Given, count: int) -> int:
    """Which of the roots is asked for. Raises ProblemError where there are not so many."""
    if given.choose <= count:
        return given.choose - 1 if given.choose > 0 else -1
    text = N_("there is no root %(number)s: the range has %(count)s")
    right = Message(N_("choose from 1 to %(count)s"), {"count": count})
    raise ProblemError([mistake(text, ("find", "choose"), right, number=given.choose, count=count)])


def _depend(given: Given, values: Array) -> None:
    """Raises ProblemError where a demanded number is the same all over, or neither changes with one unknown."""
    greatest = np.nanmax(np.abs(values), axis=(0, 1), initial=0.0)
    for k, one in enumerate(given.demands):
        if not np.nanmax(values[..., k]) - np.nanmin(values[..., k]) > ALIKE * greatest[k]:
            text = N_("%(name)s depends neither on %(first)s nor on %(second)s")
            names = dict(zip(("first", "second"), (of.name for of in given.unknowns), strict=True))
            right = Message(N_("name another number of the results, or other unknowns"))
            raise ProblemError([mistake(text, one.path, right, name=one.name, **names)])
    for k, of in enumerate(given.unknowns):
        change = np.abs(np.diff(values, axis=k))
        if not np.any(np.nan_to_num(change) > ALIKE * greatest):
            text = N_("neither of the demanded numbers depends on %(name)s")
            right = Message(N_("name another unknown, or other numbers of the results"))
            raise ProblemError([mistake(text, ("find", "unknown", of.name), right, name=of.name)])


def _rates(given: Given, asked: Asked, sought: Sought, levels: tuple[float, float]) -> Array:
    """Derivatives of the demanded numbers by the unknowns, SI. Raises ProblemError where the demands hang together:
    then every place of a line meets both, or none does."""
    width = np.array(given.sizes((1, 1))) - np.array(given.sizes((0, 0)))
    found = [slopes(asked, np.array(root.at)) for root in sought.roots[:TOLD]]
    size = sizes(sought.f, levels)[:, None]
    if len(found) > 1 and all(_together(one / size) for one in found):
        text = N_(
            "%(first)s and %(second)s change together: both demands are one, met at any number of places"
        )
        right = Message(N_("leave one unknown and one demand, or name another number of the results"))
        names = dict(zip(("first", "second"), (of.name for of in given.demands), strict=True))
        raise ProblemError([mistake(text, ("find", "so_that"), right, **names)])
    rest = [np.full((2, 2), np.nan)] * (len(sought.roots) - len(found))
    return np.array([*(one / width for one in found), *rest]).reshape(-1, 2, 2)


def _together(slope: Array) -> bool:
    rows = np.linalg.norm(slope, axis=1)
    return bool(abs(np.linalg.det(slope)) <= TOGETHER * rows[0] * rows[1])
