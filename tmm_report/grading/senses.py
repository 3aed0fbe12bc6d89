"""Which way positive numbers point: told to the student, and another sense held throughout a work recognised.

Whose axis points the other way has every number of it with the opposite sign: that is no mistake of his.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from tmm_report.course import Results, room
from tmm_report.judging.diagnose.words import named
from tmm_report.judging.model import Answered, Answers, Asked, Cause, Expected, Judged, Name
from tmm_report.problems import N_, Message
from tmm_report.quantity.terms.directions import direction, sense

Judge = Callable[[Asked, Answered], Judged]
THROUGHOUT = 0.9  # of the answered cells of a work that must be right with the other sign: others are slips
EACH = 0.5  # of those of every column
TURNING = ("rad/s", "rad/s²", "N·m")


def told(results: Results) -> Iterator[Message]:
    """Which way positive displacements, velocities, accelerations and moments point."""
    if results.lever is None:
        return
    quantities = room("kinematics", "quantities")
    for travel in results.lever.kinematics.travels:
        keys = ", ".join(one.key for one in quantities.motion_of(travel.output))
        slides = travel.output.kind == "slider"
        way = direction(travel.output.direction) if slides else sense(float(np.real(travel.output.direction)))
        yield Message(POSITIVE, {"columns": keys, "way": way})
    yield Message(TURNS)


def in_our_sense(
    results: Results, asked: Expected, answers: Answers, judge: Judge, strict: Callable[[str], bool]
) -> tuple[Answers, tuple[Cause, ...]]:
    """The answers with the signs of the solution where another sense is held throughout, and what is said of it.
    `strict`: the tables whose signs are asked as they are."""
    causes = []
    for names, text in _groups(results, asked, answers, strict):
        if _held(names, asked, answers, judge):
            columns = {name: _turned(answers.columns[name]) for name in names}
            mended = {name: one.values for name, one in columns.items()}
            answers = replace(answers, columns={**answers.columns, **columns})
            what = replace(text, values={**text.values, "columns": named(names, asked)})
            causes.append(Cause("sense", tuple(names), what, "", mended, 1.0))
    return answers, tuple(causes)


def _groups(
    results: Results, asked: Expected, answers: Answers, strict: Callable[[str], bool]
) -> Iterator[tuple[Sequence[Name], Message]]:
    """Columns whose signs go together: those of one output; all that turns, with the balancing moment or without."""
    if results.lever is None:
        return
    motion_of = room("kinematics", "quantities").motion_of
    for travel in results.lever.kinematics.travels:
        keys = {one.key for one in motion_of(travel.output)}
        names = [name for name in answers.columns if name[1] in keys and name[0].startswith("outputs_")]
        slides = travel.output.kind == "slider"
        way = (
            direction(-travel.output.direction) if slides else sense(-float(np.real(travel.output.direction)))
        )
        if names and not any(strict(name[0]) for name in names):
            yield names, Message(AXIS, {"way": way})
    turning = [name for name in answers.columns if _turns(asked[name]) and not strict(name[0])]
    for names in (turning, [name for name in turning if name[0] != "balancing_table"]):
        if names:
            yield names, Message(CLOCKWISE)


def _turns(one: Asked) -> bool:
    """Whether a column's sign is a sense of turning, of what is not an output: these have their own axis."""
    return one.by_position and one.signed and one.unit in TURNING and not one.table.startswith("outputs_")


def _held(names: Sequence[Name], asked: Expected, answers: Answers, judge: Judge) -> bool:
    """Whether nearly everything in some columns is right with the opposite sign, and not as it stands; columns of
    magnitudes, and those that are nothing, say nothing of it."""
    before = after = count = columns = 0
    for name in names:
        one, answered = asked[name], answers.columns[name]
        as_given, turned = judge(one, answered), judge(one, _turned(answered))
        loud = np.abs(one.values) > 0.05 * one.largest
        some = answered.given & np.isfinite(answered.values) & loud
        if as_given.magnitudes or not some.any() or (as_given.ok & turned.ok)[some].all():
            continue
        if turned.ok[some].mean() < EACH:
            return False
        columns += 1
        count += int(some.sum())
        before += int(as_given.ok[some].sum())
        after += int(turned.ok[some].sum())
    return columns > 1 and after >= THROUGHOUT * count and before < (1 - THROUGHOUT) * count


def _turned(answered: Answered) -> Answered:
    return replace(answered, values=-answered.values)


def lines(results: Results, gettext: Callable[[str], str]) -> list[str]:
    """The same for a sheet, a line each."""
    return [one.render(gettext) for one in told(results)]


POSITIVE = N_("%(columns)s: positive %(way)s")
TURNS = N_(
    "Angles, angular velocities, angular accelerations and moments are positive counter-clockwise; "
    "the x axis points to the right, the y axis upwards."
)
AXIS = N_("%(columns)s: positive %(way)s throughout the work, and judged so")
CLOCKWISE = N_("%(columns)s: positive clockwise throughout the work, and judged so")
