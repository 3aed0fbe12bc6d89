"""The four schemes of a planetary stage side by side for one wanted ratio, and the choice among them.

Each is searched through as it would be alone; its best teeth speak for it. Of the schemes that give the ratio and can
be driven those are taken whose efficiency is within one per cent of the best, and of these the most compact: a more
efficient stage is the better one, but not for the last per cent at a larger size. Source: Frolov (ed.), Theory of
mechanisms and machines, ch. 15.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.gears.planetary.given import Given
from tmm_report.mechanics.gears.planetary import stage as p
from tmm_report.mechanics.gears.planetary.search import Candidates, Task, ranked, search
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

Array = Any

WORTH = 0.01  # of efficiency: less is no reason for a larger stage


@dataclass(frozen=True, eq=False)
class Judged:
    """A scheme with its best teeth: `given`: the stage of that scheme; `solutions`: their number; of the best of them
    `teeth` and number of `satellites`, `ratio`, the diameter `overall` that it fills, m, and its `efficiency`, not
    above zero where it locks itself. Without a solution these are None and nan."""

    given: Given
    found: Candidates
    ranking: Array
    teeth: tuple[int, int, int, int] | None
    satellites: int
    ratio: float
    overall: float
    efficiency: float

    @property
    def scheme(self) -> p.Scheme:
        return self.given.task.scheme

    @property
    def solutions(self) -> int:
        return self.found.solutions

    @property
    def works(self) -> bool:
        """Whether it gives the ratio and can be driven from its input."""
        return self.teeth is not None and self.efficiency > 0


@dataclass(frozen=True, eq=False)
class Choice:
    """`judged`: the schemes in the order of the course; `chosen`: the place of the one that is taken; `close`: places
    of those whose efficiency is within WORTH of the best."""

    judged: tuple[Judged, ...]
    chosen: int
    close: tuple[int, ...]

    @property
    def taken(self) -> Judged:
        return self.judged[self.chosen]


def choose(given: Given) -> Choice:
    """Raises ProblemError where no scheme gives the ratio, or all that do lock themselves."""
    judged = tuple(_judged(_of_scheme(given, scheme)) for scheme in _schemes(given))
    works = [k for k, one in enumerate(judged) if one.works]
    if not works:
        raise _none(given)
    best = max(judged[k].efficiency for k in works)
    close = tuple(k for k in works if judged[k].efficiency >= best - WORTH)
    return Choice(judged, min(close, key=lambda k: judged[k].overall), close)


def tasks(given: Given) -> list[Task]:
    """What is searched through for a stage: one task, or that of every scheme."""
    if not given.any_scheme:
        return [given.task]
    return [replace(given.task, scheme=scheme) for scheme in _schemes(given)]


def _schemes(given: Given) -> Iterator[p.Scheme]:
    """A single row has one module."""
    one = given.task.modules[0] == given.task.modules[1]
    return (scheme for scheme in p.SCHEMES.values() if one or not scheme.single)


def _of_scheme(given: Given, scheme: p.Scheme) -> Given:
    """The stage of one scheme; a single row has no second crown."""
    names = given.names if not scheme.single else (*given.names[:2], *given.names[3:])
    return replace(given, task=replace(given.task, scheme=scheme), names=names, any_scheme=False)


def _judged(given: Given) -> Judged:
    task = given.task
    found = search(task)
    order = ranked(task, found)
    if not len(order):
        return Judged(given, found, order, None, 0, np.nan, np.nan, np.nan)
    z1, z2, z2_, z3 = teeth = tuple(int(z) for z in found.teeth[:, order[0]])
    basic = float(p.basic_ratio(task.scheme, teeth))
    flow = p.power_flow(basic, given.efficiency, task.input, task.output)
    overall = float(task.sizes(np.array(teeth)).overall)
    ratio = float(p.stage_ratio(basic, task.input, task.output))
    count = int(found.satellites[order[0]])
    return Judged(given, found, order, (z1, z2, z2_, z3), count, ratio, overall, float(flow.efficiency))


def _none(given: Given) -> ProblemError:
    task = given.task
    values = {"ratio": f"{task.ratio:.5g}", "tolerance": f"{100 * task.tolerance:.3g}"}
    wrong = N_("none of the schemes gives the ratio %(ratio)s within %(tolerance)s %% and can be driven")
    right = Message(N_("another ratio, wider ranges of teeth, or other planet gears would work"))
    return ProblemError([mistake(wrong, ("ratio",), right, **values)])
