"""One student's work marked: every cell judged, what follows from a wrong value found, mistakes named, points given."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.course import Results
from tmm_report.grading import rubric as rubrics
from tmm_report.grading.expected import expected
from tmm_report.grading.follow import Follow, carried
from tmm_report.grading.model import (
    Answered,
    Answers,
    Asked,
    Cause,
    Digest,
    Expected,
    Judged,
    Marked,
    MarkedColumn,
    Name,
    Rule,
)
from tmm_report.grading.rubric import Rubric
from tmm_report.judging.asked import of_motion
from tmm_report.judging.diagnose import diagnose
from tmm_report.judging.diagnose.variants import Others
from tmm_report.judging.diagnose.words import of_some
from tmm_report.judging.judge import default_floor, judge, takes_magnitudes
from tmm_report.records import dataclass

Array = Any

LONGEST = 50.0  # mm, of the longest vector of a plan: a coarser scale than that is no excuse
SCALE_OF = {"m": "mu_l", "m/s": "mu_v", "m/s²": "mu_a", "N": "mu_F"}
WRONG = (Rule.OFF, Rule.SIGN)
MOST = (
    0.7  # of the wrong cells of a mistake: if more of them follow from another value, that one is the mistake
)
FEW = 3  # answered cells: fewer of them may be alike by chance
ALIKE, VARIED = 0.02, 0.2  # of the greatest number of a column: it stays the same; it clearly does not
OF_WRITING = ("mm for m", "shifted", "reversed", "swapped", "variant")
"""Mistakes that are made in writing numbers down, not in working them out: they are named also where the columns,
mistaken alike, follow from one another."""
# how far along the course a number is found; within a stage by its unit
STAGES = {
    "positions_table": 0, "outputs_table": 1, "rates_table": 1,
    "loads_table": 2, "reactions_table": 3, "balancing_table": 4,
}  # fmt: skip
UNITS = ("m", "deg", "rad", "m/s", "rad/s", "m/s²", "rad/s²", "N", "N·m")


def grade(
    results: Results,
    answers: Answers,
    rubric: Rubric,
    asked: Expected | None = None,
    others: Others | None = None,
) -> Marked:
    """Mark a student's answers. `asked`: `expected(results)`, if it is at hand; `others`: the solutions of the other
    variants, to tell whose numbers these are."""
    asked = expected(results) if asked is None else asked
    answers = _full_turn(answers, asked) if closed(results) else answers
    work = _Work(results, asked, answers, rubric, others)
    causes = tuple(cause for one in work.mistakes if (cause := work.made(one)) is not None)
    columns = {name: work.column(name, causes) for name in work.judged}
    points = math.fsum(float(column.points.sum()) for column in columns.values())
    title = {key: str(text) for key, text in vars(results.variant.title).items() if text}
    return Marked(
        answers.id,
        title,
        results.variant.language,
        answers,
        columns,
        causes,
        tuple(_cents(points + work.gain(cause, columns)) for cause in causes),
        _cents(points),
        rubric.points,
    )


def closed(results: Results) -> bool:
    """Whether the last position of the tables is position 0 again."""
    return results.lever is not None and bool(results.lever.kinematics.cycle.closed)


def _full_turn(answers: Answers, asked: Expected) -> Answers:
    """The same where position 0 is answered by the last one alone, which it is: who numbers from 1 to 12 says 12."""
    columns = {name: _begun(one) if asked[name].by_position else one for name, one in answers.columns.items()}
    return replace(answers, columns=columns)


def _begun(one: Answered) -> Answered:
    if one.given[0] or not one.given[-1]:
        return one
    values, given = one.values.copy(), one.given.copy()
    values[0], given[0] = values[-1], True
    texts, places = (one.texts[-1], *one.texts[1:]), (one.places[-1], *one.places[1:])
    return replace(one, values=values, given=given, texts=texts, places=places)


def _cents(points: float) -> float:
    """Points as they are written: to a hundredth, half up."""
    return math.floor(points * 100 + 0.5 + 1e-9) / 100


@dataclass(frozen=True, eq=False)
class _Work:
    """A student's work beside the solution."""

    results: Results
    asked: Expected
    answers: Answers
    rubric: Rubric
    others: Others | None = None
    _carried: dict[Name, tuple[str, ...]] = field(default_factory=dict)

    @cached_property
    def mistakes(self) -> Sequence[Cause]:
        """What has likely gone wrong, by whole columns."""
        answers, limit = self.answers, self.rubric.limit
        return diagnose(answers, self.asked, self.judged, limit=limit, others=self.others, floors=self.floors)

    @cached_property
    def worth(self) -> Mapping[Name, Array]:
        return rubrics.worth(self.rubric, self.asked, closed(self.results))

    @cached_property
    def order(self) -> Mapping[Name, tuple[int, int, int]]:
        """Where along the course each column is found."""
        return {name: _rank(one, place) for place, (name, one) in enumerate(self.asked.items())}

    # ------------------------------------------------------------ cells

    @cached_property
    def judged(self) -> dict[Name, Judged]:
        """Every column that is asked or answered, in the order of the note."""
        return {
            name: self._judged(name)
            for name in self.asked
            if name in self.worth or name in self.answers.columns
        }

    def _judged(self, name: Name) -> Judged:
        one, answered = self.asked[name], self.answers.columns.get(name)
        if answered is None:
            return _unanswered(one)
        judged = self.judge(one, answered.values, answered.given)
        return _nothing_said(judged) if self.is_idle(name, judged) else judged

    def is_idle(self, name: Name, judged: Judged) -> bool:
        """Whether a column is one of noughts where the solution has numbers: none of these is right, and at most half
        as many numbers are anything at all. Some noughts are then right by chance."""
        one, values = self.asked[name], np.abs(self.answers.columns[name].values)
        if not one.by_position or one.angle or one.whole or np.isfinite(values).sum() < FEW:
            return False
        floor = self.floor(one)
        wanted = np.isfinite(one.values) & (self.worth.get(name, np.ones(len(values))) > 0)
        loud = wanted & (np.abs(one.values) > floor)
        said = wanted & (values > floor)
        return bool(loud.any() and not judged.ok[loud].any() and 2 * said.sum() <= loud.sum())

    def judge(self, one: Asked, values: Array, given: Array) -> Judged:
        free = not self.rubric.strict(one.table) and not of_motion(one)
        return judge(
            one,
            values,
            given,
            limit=self.rubric.limit_of(one.table),
            floor=self.floor(one),
            magnitudes=free and takes_magnitudes(one, values),
        )

    def floor(self, one: Asked) -> float:
        """What cannot be read off the plan: `reading` mm at the student's own scale, else of a vector of `LONGEST`.

        A scale at which the longest vector of the plan would be shorter than that is not believed. What does not
        change, as weights, is worked out and not read off.
        """
        scale = self.answers.scales.get(SCALE_OF.get(one.unit, ""))
        same = np.ptp(np.abs(one.values)) <= 1e-9 * one.largest
        if scale is None or same or not one.by_position:
            return default_floor(one, self.rubric.reading)
        return self.rubric.reading * min(scale, self.largest[one.table, one.unit] / LONGEST)

    @cached_property
    def floors(self) -> Mapping[Name, float]:
        return {name: self.floor(self.asked[name]) for name in self.answers.columns}

    @cached_property
    def largest(self) -> Mapping[tuple[str, str], float]:
        """The greatest number of each unit in each table."""
        found: dict[tuple[str, str], float] = {}
        for one in self.asked.values():
            found[one.table, one.unit] = max(found.get((one.table, one.unit), 0.0), one.largest)
        return found

    # ------------------------------------------------------------ what follows from a wrong value

    @cached_property
    def followed(self) -> Mapping[str, Sequence[Follow]]:
        """What each column would be, were it worked from the student's own values; nothing where all is right."""
        wrong = any(rule in WRONG for one in self.judged.values() for rule in one.rules)
        if self.results.lever is None or not wrong:
            return {}
        columns = self.answers.columns.items()
        return carried(self.results, {name[1]: one.values for name, one in columns if name[0] in STAGES})

    @cached_property
    def wrong(self) -> Mapping[str, tuple[tuple[int, int, int], Array]]:
        """Key of a wrong column by positions -> where along the course it is found, and where it is wrong, (P,)."""
        return {
            name[1]: (self.order[name], np.array([rule in WRONG for rule in judged.rules]))
            for name, judged in self.judged.items()
            if self.asked[name].by_position and any(rule in WRONG for rule in judged.rules)
        }

    @cached_property
    def unchanging(self) -> frozenset[str]:
        """Keys of wrong columns with one number all along where the solution has many: it comes from nowhere, and
        nothing follows from it."""
        return frozenset(
            name[1]
            for name, column in self.answers.columns.items()
            if name[1] in self.wrong and _is_unchanging(self.asked[name], column.values)
        )

    @cached_property
    def anothers(self) -> frozenset[Name]:
        """Columns with the numbers of another variant: they follow from its data, not from the student's values."""
        return frozenset(name for cause in self.mistakes if cause.kind == "variant" for name in cause.names)

    def carried(self, name: Name) -> tuple[str, ...]:
        if name in self.anothers:
            return ("",) * len(self.asked[name].rows)
        if name not in self._carried:
            self._carried[name] = self._found_carried(name)
        return self._carried[name]

    def _found_carried(self, name: Name) -> tuple[str, ...]:
        """(P,): the key of the wrong value from which a wrong cell follows rightly, "" elsewhere."""
        one, found = self.asked[name], [""] * len(self.asked[name].rows)
        if not one.by_position or one.key not in self.wrong:
            return tuple(found)
        answered, wrong = self.answers.columns[name], self.wrong[one.key][1]
        if one.key in self.unchanging:
            return tuple(found)
        for follow in self.followed.get(one.key, ()):
            if not self.unchanging.isdisjoint(follow.sources):
                continue
            again = self.judge(replace(one, values=follow.values), answered.values, answered.given)
            # noughts all along follow from each other, and from nothing that a student did
            some = np.abs(follow.values) > self.floor(one)
            for k in np.flatnonzero(wrong & again.ok & some):
                found[k] = found[k] or self.source(follow, int(k), self.order[name])
        return tuple(found)

    def made(self, cause: Cause) -> Cause | None:
        """A mistake where it was made: without the columns that follow from others, where most of it follows."""
        if cause.kind in OF_WRITING or not self.follows(cause.names):
            return cause
        return of_some(cause, [name for name in cause.names if not self.follows([name])], self.asked)

    def follows(self, names: Sequence[Name]) -> bool:
        """Whether most of what is wrong in some columns follows from other wrong values."""
        pairs = [
            pair for name in names for pair in zip(self.judged[name].rules, self.carried(name), strict=True)
        ]
        sources = [source for rule, source in pairs if rule in WRONG]
        return sum(map(bool, sources)) > MOST * len(sources)

    def source(self, follow: Follow, k: int, order: tuple[int, int, int]) -> str:
        """The wrong value that a cell follows from. A value follows from earlier ones alone, or two wrong ones would
        excuse each other."""
        for key in follow.sources:
            earlier, wrong = self.wrong.get(key, ((9, 9, 0), None))
            if wrong is not None and wrong[k] and earlier < order:
                return key
        return ""

    # ------------------------------------------------------------ points

    def column(self, name: Name, causes: Sequence[Cause]) -> MarkedColumn:
        one, judged = self.asked[name], self.judged[name]
        follows = self.carried(name)
        pairs = zip(judged.rules, follows, strict=True)
        rules = tuple(Rule.CARRIED if source else rule for rule, source in pairs)
        worth = self.worth.get(name, np.zeros(len(one.rows)))
        return MarkedColumn(
            one, self.answers.columns.get(name), judged, rules, follows,
            worth * self.share(name, judged, rules, causes), worth,
        )  # fmt: skip

    def share(self, name: Name, judged: Judged, rules: Sequence[Rule], causes: Sequence[Cause]) -> Array:
        """Part of its points that each cell gets, (P,)."""
        share = np.where(judged.ok, 1.0, 0.0)
        share[[rule is Rule.CARRIED for rule in rules]] = self.rubric.carried
        for cause in causes if self.rubric.named else ():
            if name in cause.mended:
                share = np.where(self.mended(name, cause), np.maximum(share, self.rubric.named), share)
        return share

    def mended(self, name: Name, cause: Cause) -> Array:
        """Where a column is right once a mistake is undone, (P,) of bool."""
        values = cause.mended[name]
        return self.judge(self.asked[name], values, np.isfinite(values)).ok

    def gain(self, cause: Cause, columns: Mapping[Name, MarkedColumn]) -> float:
        """Points that the work would have more without a mistake."""
        gains = [
            float(
                np.maximum(columns[name].worth * self.mended(name, cause) - columns[name].points, 0.0).sum()
            )
            for name in cause.mended
        ]
        return math.fsum(gains)


def _unanswered(one: Asked) -> Judged:
    """A column that was left out."""
    rules = [Rule.NO_ANSWER if number else Rule.NOT_ASKED for number in np.isfinite(one.values).tolist()]
    return Judged(np.full(len(rules), np.nan), tuple(rules))


def _nothing_said(judged: Judged) -> Judged:
    """The same, where what is right by what can be read is not."""
    nothing = (Rule.FLOOR, Rule.ZERO)
    return replace(judged, rules=tuple(Rule.OFF if rule in nothing else rule for rule in judged.rules))


def _is_unchanging(one: Asked, values: Array) -> bool:
    """Whether numbers (P,) are alike where those of the solution are not."""
    both = np.isfinite(values) & np.isfinite(one.values)
    if both.sum() < FEW or one.angle:
        return False
    mine, right = np.abs(values[both]), np.abs(one.values[both])
    return bool(np.ptp(mine) <= ALIKE * mine.max() and np.ptp(right) > VARIED * right.max())


def _rank(one: Asked, place: int) -> tuple[int, int, int]:
    unit = UNITS.index(one.unit) if one.unit in UNITS else len(UNITS)
    return STAGES.get(one.table, len(STAGES)), unit, place


def digest(marked: Marked) -> Digest:
    """What gradebook and statistics keep of a marked work."""
    cells: dict[tuple[str, str, str], tuple[float, str]] = {}
    right: dict[tuple[str, str, str], float] = {}
    for (table, key), column in marked.columns.items():
        given = column.answered.given if column.answered is not None else False
        for k in np.flatnonzero((column.worth > 0) | column.judged.asked & given):
            at = table, key, column.asked.rows[k]
            number = column.answered.values[k] if column.answered is not None else math.nan
            cells[at] = float(number), str(column.rules[k])
            right[at] = float(column.asked.values[k])
    return Digest(
        marked.id,
        marked.title.get("student", ""),
        marked.title.get("group", ""),
        marked.title.get("variant", ""),
        marked.points,
        marked.worth,
        cells,
        right,
        tuple((cause.kind, cause.detail, tuple(key for _, key in cause.names)) for cause in marked.causes),
        columns={
            name: (float(column.points.sum()), float(column.worth.sum()))
            for name, column in marked.columns.items()
        },
    )
