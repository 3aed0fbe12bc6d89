"""A method chosen for a mechanism, the same on every machine and at every run: costs by the table, errors against the
closed form in double precision, rounded up to one digit.

taken = choose(cycle, (12, 36), 1e-6)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.forces.reactions import Statics
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.rivals.cost import CLOSED, FOLLOWED, FORCES, MOTION, Cost
from tmm_report.mechanics.rivals.forces import FORCES as FORCE_METHODS
from tmm_report.mechanics.rivals.forces import force_method
from tmm_report.mechanics.rivals.model import Found, Loaded, MotionMethod, Pair, Scene, Trial
from tmm_report.mechanics.rivals.motion.every import MOTIONS, motion_method
from tmm_report.mechanics.rivals.trials import (
    Errors,
    Rivals,
    doubles,
    errors_of,
    force_rows,
    motion_rows,
    tried,
    worst,
)
from tmm_report.records import dataclass

FLOOR = 1e-12  # what double precision tells of two ways to one number; errors below are said to be this
DEAR = 2.5e4  # µs by the table: a method that takes longer at some number of positions is not tried there
ACCURACY = 1e-6  # where none is stated: of five printed digits the last is right


@dataclass(frozen=True, eq=False)
class Choice:
    """The method taken, and its largest errors over the positions, by kinds. `asked`: whether it was named, and not
    found; `accuracy`: what it was to hold, relative."""

    taken: MotionMethod
    errors: Errors
    accuracy: float
    asked: bool

    @property
    def worst(self) -> float:
        """nan where it loses positions."""
        return worst(self.errors)

    @property
    def own(self) -> bool:
        """Whether it is the closed form."""
        return self.taken.key == CLOSED

    @property
    def holds(self) -> bool:
        """Whether the accuracy is held; the closed form is what errors are measured by, and has none."""
        return self.own or self.worst <= self.accuracy


def rounded(error: float) -> float:
    """An error rounded up to one digit, and to what double precision tells; nan stays."""
    if not math.isfinite(error):
        return math.nan
    error = max(error, FLOOR)
    power = math.floor(math.log10(error) + 1e-9)
    return float(f"{math.ceil(error / 10.0**power - 1e-6)}e{power}")


def told(errors: Errors) -> Errors:
    return {kind: rounded(error) for kind, error in errors.items()}


def judged(cycle: Cycle) -> Callable[[int, Motion], Errors]:
    """The errors of a motion at `count` steps against the closed form's, which is found once a count."""
    closed = motion_method(CLOSED)

    @lru_cache
    def exact(count: int) -> Mapping[str, Pair]:
        return doubles(motion_rows(closed.run(cycle, count)))

    return lambda count, found: errors_of(exact(count), motion_rows(found))


def judged_forces(scene: Loaded) -> Callable[[int, Statics], Errors]:
    """The same of forces: against those by groups."""
    pairs = [pair.key for pair in scene.cycle.linkage.structure.pairs]

    @lru_cache
    def exact(count: int) -> Mapping[str, Pair]:
        return doubles(force_rows(pairs, force_method(CLOSED).run(scene, count)))

    return lambda count, found: errors_of(exact(count), force_rows(pairs, found))


def costed(rivals: Rivals[Scene, Found], costs: Mapping[str, Cost], links: int) -> list[Trial]:
    """All methods at all counts, with errors and seconds that are the same at every run; a count that is dear by the
    table is left out, and so are methods of which the table knows nothing."""
    found = []
    for count in rivals.counts:
        cheap = [
            method
            for method in rivals.usable
            if method.key in costs and costs[method.key].of(links, count) < DEAR
        ]
        found += tried(replace(rivals, methods=cheap, counts=(count,)))
    return [
        replace(one, errors=told(one.errors), seconds=1e-6 * costs[one.method.key].of(links, one.count))
        for one in found
    ]


def motions(cycle: Cycle, counts: Sequence[int]) -> tuple[Rivals[Cycle, Motion], list[Trial]]:
    """The methods of the motion."""
    rivals = Rivals(MOTIONS, cycle, judged(cycle), counts)
    return rivals, costed(rivals, table_of(cycle), moving(cycle))


def forces(scene: Loaded, counts: Sequence[int]) -> tuple[Rivals[Loaded, Statics], list[Trial]]:
    """The methods of the forces."""
    rivals = Rivals(FORCE_METHODS, scene, judged_forces(scene), counts)
    return rivals, costed(rivals, FORCES, moving(scene.cycle))


def moving(cycle: Cycle) -> int:
    """How many links move: by which costs are counted."""
    return len(cycle.linkage.mechanism.moving)


def table_of(cycle: Cycle) -> Mapping[str, Cost]:
    """What methods of the motion cost on this mechanism."""
    groups = cycle.linkage.structure.groups
    return FOLLOWED if any(group.group_class > 2 for group in groups) else MOTION


def choose(cycle: Cycle, counts: Sequence[int], accuracy: float) -> Choice:
    """The cheapest method whose errors at all the counts are within the accuracy; the closed form, where none is.

    Tried in the order of their costs, so that dear ones are not run where a cheap one will do.
    """
    links, judge, costs = moving(cycle), judged(cycle), table_of(cycle)

    def price(method: MotionMethod) -> float:
        return sum(costs[method.key].of(links, count) for count in counts)

    usable = [method for method in MOTIONS if method.refuses(cycle) is None]
    for method in sorted(usable, key=price):
        errors = errors_over(method, cycle, counts, judge)
        if method.key == CLOSED or worst(errors) <= accuracy:
            return Choice(method, errors, accuracy, False)
    return Choice(motion_method(CLOSED), told({"place": 0.0}), accuracy, False)


def named(key: str, cycle: Cycle, counts: Sequence[int], accuracy: float) -> Choice:
    """The method that the variant names, with its errors."""
    method = motion_method(key)
    return Choice(method, errors_over(method, cycle, counts, judged(cycle)), accuracy, True)


def errors_over(
    method: MotionMethod, cycle: Cycle, counts: Sequence[int], judge: Callable[[int, Motion], Errors]
) -> Errors:
    """The largest errors at all the counts, by kinds, rounded; none where it breaks down."""
    found = tried(Rivals((method,), cycle, judge, counts))
    if any(one.broken is not None for one in found):
        return {}
    kinds = found[0].errors if found else {}
    return told({kind: float(max(one.errors[kind] for one in found)) for kind in kinds})
