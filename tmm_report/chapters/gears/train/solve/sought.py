"""The teeth of a compound train for a wanted ratio: the task, and the best of what is found."""

from __future__ import annotations

from collections.abc import Mapping

from tmm_report.chapters.gears.train.given import GearTrain
from tmm_report.chapters.gears.train.solve.built import Built, build
from tmm_report.chapters.gears.train.solve.conditions import USUAL
from tmm_report.mechanics.gears.compound.rows import order, rows_of
from tmm_report.mechanics.gears.compound.search import Candidates, Reason, Task, extent, search
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.records import dataclass

MOST = 20_000_000  # combinations: some three seconds


@dataclass(frozen=True, eq=False)
class Sought:
    """What was judged; the first of the solutions is taken."""

    task: Task
    candidates: Candidates
    efficiency: tuple[float, ...] = ()  # of the solutions, 0 of one that locks itself; none without losses

    @property
    def teeth(self) -> Mapping[str, int]:
        return self.candidates.set(0)

    @property
    def satellites(self) -> tuple[int, ...]:
        k = int(self.candidates.satellites[0])
        return (k,) if k else ()


def task_of(given: GearTrain) -> Task:
    """Raises ProblemError where the rows give the ratio only together."""
    assert given.find is not None
    built = build(given, {name: one.low for name, one in given.wheels.items()})
    rows = rows_of(built.train, built.outer, given.fixed)
    still = tuple({built.body(name) for name in given.fixed})
    output, entry = built.body(given.output[0]), built.body(given.input[0])
    steps = order(rows, {output, *still})
    if steps is None:
        wrong = N_("the rows of this train give its ratio only together: its teeth cannot be sought")
        raise ProblemError([mistake(wrong, ("train", "find"), Message(N_("the teeth of all wheels")))])
    moving = any(row.carrier for row in rows)
    return Task(
        built.train,
        rows,
        steps,
        still,
        entry,
        output,
        given.find.ratio,
        given.find.tolerance,
        {name: (one.low, one.high) for name, one in given.wheels.items()},
        (given.satellites or USUAL) if moving else (),
        given.find.shifted,
        {name: _module(built, name) for name in given.wheels},
        built.flat,
    )


def _module(built: Built, name: str) -> float:
    """In parts of the first wheel's."""
    return built.module(name) / built.module(next(iter(built.given.wheels)))


def find(given: GearTrain) -> Sought:
    """Raises ProblemError: of too many combinations, before any is tried; of none that meets the conditions."""
    task = task_of(given)
    count = extent(task)
    if count > MOST:
        wrong = N_("the ranges of teeth have %(count)s combinations, and at most %(most)s are tried")
        right = Message(N_("narrower ranges, or more wheels whose teeth are stated"))
        raise ProblemError([mistake(wrong, ("train", "wheels"), right, count=count, most=MOST)])
    found = search(task)
    if not found.counts.get(Reason.ACCEPTED):
        wrong = N_(
            "no teeth in the ranges give the ratio: of %(count)s sets %(ratio)s have it, none meets all conditions"
        )
        near = sum(n for reason, n in found.counts.items() if reason > Reason.RATIO)
        right = Message(N_("wider ranges, a wider tolerance, other numbers of planet gears or shifted: 1"))
        raise ProblemError([mistake(wrong, ("train", "find"), right, count=found.examined, ratio=near)])
    return Sought(task, found)
