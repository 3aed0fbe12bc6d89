"""One student's work marked: every cell judged, what follows from a wrong value found, mistakes named, points given."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.course import Results
from tmm_report.grading import rubric as rubrics
from tmm_report.grading.charge import Clause, charged
from tmm_report.grading.expected import expected
from tmm_report.grading.first_row import full_turn
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
from tmm_report.grading.recognised import COLUMNS, FEWEST, Handed, Recognised, recognised
from tmm_report.grading.rubric import Rubric
from tmm_report.grading.senses import in_our_sense
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
HUGE = 1e6  # times the greatest number of a column: no plan is drawn of it
ALIKE, VARIED = 0.02, 0.2  # of the greatest number of a column: it stays the same; it clearly does not
OF_WRITING = ("mm for m", "shifted", "reversed", "rows", "swapped", "variant")
"""Mistakes that are made in writing numbers down, not in working them out: they are named also where the columns,
mistaken alike, follow from one another."""
WORLD = "world"  # from which columns follow that are right in another world
# how far along the course a number is found; within a stage by its unit
STAGES = {
    "positions_table": 0, "outputs_table": 1, "rates_table": 1,
    "loads_table": 2, "reactions_table": 3, "balancing_table": 4, "drive_table": 5,
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
    answers = full_turn(answers, asked) if closed(results) else answers
    answers, senses = _in_our_sense(results, asked, answers, rubric)
    work = _Work(results, asked, answers, rubric, others)
    causes = (*senses, *work.causes)
    columns = {name: work.column(name, causes) for name in work.judged}
    points = math.fsum(float(column.points.sum()) for column in columns.values())
    points = max(points - rubric.senses * len(senses), 0.0)
    title = {key: str(text) for key, text in vars(results.variant.title).items() if text}
    return Marked(
        answers.id,
        title,
        results.variant.language,
        answers,
        columns,
        causes,
        tuple(
            _cents(points + (rubric.senses if cause in senses else work.gain(cause, columns)))
            for cause in causes
        ),
        _cents(points),
        rubric.points,
    )


def closed(results: Results) -> bool:
    """Whether the last position of the tables is position 0 again."""
    return results.lever is not None and bool(results.lever.kinematics.cycle.closed)


def _in_our_sense(
    results: Results, asked: Expected, answers: Answers, rubric: Rubric
) -> tuple[Answers, tuple[Cause, ...]]:
    work = _Work(results, asked, answers, rubric)

    def judged(one: Asked, answered: Answered) -> Judged:
        return work.judge(one, answered.values, answered.given)

    return in_our_sense(results, asked, answers, judged, rubric.strict)


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

    def judge(self, one: Asked, values: Array, given: Array, floor: float | None = None) -> Judged:
        free = not self.rubric.strict(one.table) and not of_motion(one)
        return judge(
            one,
            values,
            given,
            limit=self.rubric.limit_of(one.table),
            floor=self.floor(one) if floor is None else floor,
            magnitudes=free and takes_magnitudes(one, values),
        )

    def floor(self, one: Asked, values: Array | None = None) -> float:
        """What cannot be read off the plan; of a plan with other values, where these are all there, as they are."""
        floor = self.own_floor(one)
        if values is None or (np.isnan(values) & np.isfinite(one.values)).any():
            return floor
        largest = float(np.nanmax(np.abs(values), initial=0.0))
        return floor * largest / one.largest if 0 < largest < HUGE * one.largest else floor

    def own_floor(self, one: Asked) -> float:
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
        return carried(self.results, self.given)

    @property
    def given(self) -> Mapping[str, Array]:
        return {name[1]: one.values for name, one in self.answers.columns.items() if name[0] in STAGES}

    @cached_property
    def names(self) -> Mapping[str, Name]:
        """Key of a column by positions that was answered -> its name."""
        return {name[1]: name for name in self.judged if self.asked[name].by_position}

    @cached_property
    def wrong(self) -> Mapping[str, Array]:
        """Key of a wrong column by positions -> where it is wrong, (P,), in the order in which values are found."""
        found = {
            name: np.array([rule in WRONG for rule in judged.rules])
            for name, judged in self.judged.items()
            if self.asked[name].by_position and any(rule in WRONG for rule in judged.rules)
        }
        return {name[1]: found[name] for name in sorted(found, key=self.order.__getitem__)}

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
        """(P,): the key of the wrong value from which a wrong cell follows rightly, "" elsewhere."""
        if self.asked[name].by_position and name[1] in self.wrong:
            return self.charged[name[1]]
        if (
            self.world is not None
            and (there := self.world.there.get(name)) is not None
            and not there.by_position
        ):
            return self.of_world(self.world, self.asked[name], there)
        return ("",) * len(self.asked[name].rows)

    def of_world(self, world: Recognised, one: Asked, there: Asked) -> tuple[str, ...]:
        """A single number that is wrong, but right in another world, follows from that world's first column."""
        rules, answered = self.judged[one.name].rules, self.answers.columns.get(one.name)
        if answered is None or there.values.shape != one.values.shape:
            return ("",) * len(one.rows)
        agrees = self.agrees(one, answered, there.values)
        first = next(key for key in self.wrong if self.names[key] in world.fits)
        return tuple(first if ok and rule in WRONG else "" for rule, ok in zip(rules, agrees, strict=True))

    @cached_property
    def causes(self) -> tuple[Cause, ...]:
        """What has likely gone wrong, where it was made: of the whole work, and in columns besides."""
        made = tuple(cause for one in self.mistakes if (cause := self.made(one)) is not None)
        if self.world is None:
            return made
        left = [of_some(one, [n for n in one.names if n not in self.world.fits], self.asked) for one in made]
        return (self.world.cause, *(one for one in left if one is not None))

    @cached_property
    def world(self) -> Recognised | None:
        """The mistake in the whole of the work, if it is one, looked for where others leave much unexplained."""
        if len(self.wrong) < COLUMNS or sum(int(some.sum()) for some in self.unexplained.values()) < FEWEST:
            return None
        wrong = {self.names[key]: some for key, some in self.wrong.items()}
        judged = {name: one for name, one in self.judged.items() if name in self.names.values()}
        answered = {name: one for name, one in self.answers.columns.items() if name in judged}
        judged = {name: one for name, one in judged.items() if name in answered and name[0] in STAGES}
        wrong = {name: some for name, some in wrong.items() if name in judged}
        floors = {name: self.floor(self.asked[name]) for name in judged}
        limit = self.rubric.limit
        return recognised(
            Handed(self.results, self.asked, answered, judged, wrong, self.agrees, limit, floors)
        )

    @cached_property
    def unexplained(self) -> Mapping[str, Array]:
        """Key of a wrong column -> where neither a mistake in it nor what it follows from explains it, (P,)."""
        if self.results.lever is None or self.anothers or not self.followed:
            return {}
        sources = charged(self.wrong, self.ways(self.followed))
        left = {key: wrong & (np.array(sources[key]) == "") for key, wrong in self.wrong.items()}
        for cause in self.mistakes:
            for name in cause.names:
                if name[1] in left and self.names.get(name[1]) == name:
                    left[name[1]] = left[name[1]] & ~self.mended(name, cause)
        idle = {key for key in left if key in self.unchanging}
        return {key: some for key, some in left.items() if key not in idle}

    @cached_property
    def charged(self) -> Mapping[str, tuple[str, ...]]:
        """Every wrong column by positions: what follows from another wrong value, and from which. What follows from
        the mistakes alone is looked for once more: a slip of the pen on the way need not have been carried on."""
        ways = list(self.ways(self.followed))
        found = charged(self.wrong, ways)
        for own in self.mistaken(found):
            ways += self.ways(carried(self.results, own, self.wrong))
        return charged(self.wrong, ways) if self.world is None else self.elsewhere(self.world, ways)

    def elsewhere(self, world: Recognised, ways: list[Clause]) -> Mapping[str, tuple[str, ...]]:
        """The same of a work that is right in another world: all its cells follow from the first column's."""
        ways += self.ways(carried(world.results, self.given, self.wrong))
        keys = [key for key in self.wrong if self.names[key] in world.fits]
        first, always = keys[0], np.ones(len(self.wrong[keys[0]]), dtype=bool)
        fits = world.fits[self.names[first]]
        ways = [replace(one, agrees=one.agrees & ~fits) if one.key == first else one for one in ways]
        ways += [Clause(key, (WORLD,), world.fits[self.names[key]]) for key in keys[1:]]
        found = charged({WORLD: always, **self.wrong}, ways)
        return {
            key: tuple(first if source == WORLD else source for source in sources)
            for key, sources in found.items()
            if key != WORLD
        }

    def mistaken(self, found: Mapping[str, tuple[str, ...]]) -> Iterator[Mapping[str, Array]]:
        """The student's numbers where they are mistakes by themselves: all of them, and the first column alone."""
        cells = {key: self.wrong[key] & (np.array(sources) == "") for key, sources in found.items()}
        own = {
            key: np.where(some, self.answers.columns[self.names[key]].values, np.nan)
            for key, some in cells.items()
            if some.any() and key not in self.unchanging
        }
        if self.followed and own:
            yield own
            if len(own) > 1:
                first = next(iter(own))
                yield {first: own[first]}

    def ways(self, followed: Mapping[str, Sequence[Follow]]) -> Iterator[Clause]:
        """In which ways wrong values follow from others of the student's."""
        for key, wrong in self.wrong.items():
            name = self.names[key]
            one, answered = self.asked[name], self.answers.columns[name]
            if key in self.unchanging or name in self.anothers:
                continue
            for follow in followed.get(key, ()):
                if self.unchanging.isdisjoint(follow.sources):
                    yield Clause(key, follow.sources, wrong & self.follows_from(one, answered, follow.values))

    def follows_from(self, one: Asked, answered: Answered, values: Array) -> Array:
        """(P,) of bool: where the student's numbers are those of a column as it would be from his own. Noughts all
        along follow from each other, and from nothing that a student did."""
        ok = self.agrees(one, answered, values)
        some = np.abs(values) > self.floor(one, values)
        return ok if 2 * (ok & some).sum() > ok.sum() else ok & some

    def agrees(self, one: Asked, answered: Answered, values: Array) -> Array:
        """(P,) of bool: where the student's numbers are those of a column with other values, which is read off a plan
        of its own size."""
        floor = self.floor(one, values)
        return self.judge(replace(one, values=values), answered.values, answered.given, floor).ok

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
