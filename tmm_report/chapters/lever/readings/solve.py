"""A student's own numbers of any quantity against the analytical ones; what is wrong, and why it may be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from tmm_report.chapters.lever.plans.quantities import comparison
from tmm_report.chapters.lever.plans.solve import LIMIT, Plans
from tmm_report.chapters.lever.readings.given import Readings, Written
from tmm_report.judging.asked import POSITION, of_motion, of_table
from tmm_report.judging.judge import default_floor, judge, takes_magnitudes
from tmm_report.judging.model import RIGHT, Answered, Answers, Asked, Cause, Judged, Name, Rule
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity import naming
from tmm_report.quantity.model import Table
from tmm_report.quantity.units import WrongValue, between
from tmm_report.records import dataclass

Array = Any

READINGS = Message(N_("the student's own readings against the analytical method"))


@dataclass(frozen=True, eq=False)
class Reading:
    """One number. `graph`, `analytic`: the student's and the right one in the unit of the results, without signs where
    the student gave none; `delta`: %, None where both are nothing or the signs are opposite; `causes`: of the mistakes
    found, those that explain it."""

    position: int
    written: str  # its name in the file
    asked: Asked
    graph: float
    analytic: float
    delta: float | None
    rule: Rule
    causes: tuple[Cause, ...] = ()
    unsigned: bool = False  # given without the minus that the analytical value has

    @property
    def key(self) -> str:
        return self.asked.key

    @property
    def ok(self) -> bool:
        return self.rule in (*RIGHT, Rule.NOT_ASKED)

    @property
    def problem(self) -> Problem:
        """What is wrong with it, and what it looks like."""
        path = ("readings", str(self.position), self.written)
        right = Message(N_("likely: %(cause)s"), {"cause": self.causes[0].what}) if self.causes else None
        if self.delta is None:
            return mistake(N_("the sign is opposite to that of the analytical value"), path, right)
        text = N_("differs from the analytical value by %(delta)s %%")
        return mistake(text, path, right, delta=f"{self.delta:.3g}")


@dataclass(frozen=True, eq=False)
class ReadingsFound:
    """Found by `solve`: every number by position, in the order of the file, and the mistakes that explain them."""

    rows: Mapping[int, tuple[Reading, ...]]
    causes: tuple[Cause, ...]

    def compared(self, position: int) -> Table:
        """The numbers of a position beside the analytical ones, a row each."""
        rows = self.rows[position]
        units = {one.key: one.asked.unit for one in rows}
        return comparison(f"readings_{position}", READINGS, rows, units.__getitem__)

    @property
    def wrong(self) -> tuple[Reading, ...]:
        return tuple(one for rows in self.rows.values() for one in rows if not one.ok)

    @property
    def unsigned(self) -> tuple[Reading, ...]:
        """Those of which the sense is not judged: right in magnitude, written without a minus."""
        return tuple(one for rows in self.rows.values() for one in rows if one.unsigned and one.ok)

    @property
    def worst(self) -> float:
        """Largest |delta|, %."""
        deltas = (one.delta for rows in self.rows.values() for one in rows)
        return max((abs(delta) for delta in deltas if delta is not None), default=0.0)


def solve(readings: Readings, plans: Plans, tables: Iterable[tuple[str, Table]]) -> ReadingsFound:
    """Compare the numbers with those of the tables by positions, each with the chapter that found it. Tables are made
    when they are reached: those behind the last quantity that is read only to look for the causes of what is wrong.

    Raises ProblemError for quantities and units that there are not."""
    every = (one for chapter, table in tables if POSITION in table for one in of_table(table, chapter))
    asked = _until(every, {name for numbers in readings.values() for name in numbers})
    meant = _meant(readings, asked)
    columns = {one.name: _answered(one, meant) for one in {id(one): one for one, *_ in meant}.values()}
    judged = {name: _judged(asked[name], column, plans) for name, column in columns.items()}
    wrong = any((columns[name].given & ~one.ok).any() for name, one in judged.items())
    causes = _causes(columns, asked | {one.name: one for one in every}, judged) if wrong else ()
    rows: dict[int, list[Reading]] = {position: [] for position in readings}
    for one, position, written, number in meant:
        rows[position].append(_reading(one, position, written, number, judged[one.name], causes))
    return ReadingsFound({position: tuple(found) for position, found in rows.items()}, causes)


def _until(every: Iterator[Asked], keys: set[str]) -> dict[Name, Asked]:
    """The columns up to the last of the keys; all of them where a key is a name that is written otherwise."""
    asked, left = {}, set(keys)
    while left and (one := next(every, None)) is not None:
        asked[one.name] = one
        left.discard(one.key)
    return asked


Meant = list[
    tuple[Asked, int, str, float]
]  # what is meant, its position, its name in the file, the number in SI


def _meant(readings: Readings, asked: Mapping[Name, Asked]) -> Meant:
    by_key: dict[str, Asked] = {}
    for one in asked.values():
        by_key.setdefault(one.key, one)
    quantities = {key: one.quantity for key, one in by_key.items()}
    found: Meant = []
    problems: list[Problem] = []
    for position, numbers in readings.items():
        for name, written in numbers.items():
            path = ("readings", str(position), name)
            try:
                one = by_key[naming.one(name, quantities, path).key]
                found.append((one, position, name, _number(written, one)))
            except ProblemError as error:
                problems += error.problems
            except WrongValue as error:
                problems.append(Problem(error.wrong, error.right, path))
    if problems:
        raise ProblemError(problems)
    return found


def _causes(
    columns: Mapping[Name, Answered], asked: Mapping[Name, Asked], judged: Mapping[Name, Judged]
) -> tuple[Cause, ...]:
    from tmm_report.judging.diagnose import diagnose  # loaded where something is wrong

    return tuple(diagnose(Answers("", columns), asked, judged, limit=LIMIT, others=None))


def _number(written: Written, one: Asked) -> float:
    number, unit = written
    return number * between(unit, one.unit) if unit else number


def _answered(one: Asked, meant: Meant) -> Answered:
    values = np.full(len(one.rows), np.nan)
    for other, position, _, number in meant:
        if other is one:
            values[position] = number
    given = np.isfinite(values)
    return Answered(values, given, ("",) * len(values), ("",) * len(values))


def _judged(one: Asked, answered: Answered, plans: Plans) -> Judged:
    """What is below 1 mm of the plan is nothing."""
    per_mm = {"m/s": plans.velocity_scale, "m/s²": plans.acceleration_scale}.get(one.unit)
    floor = default_floor(one) if per_mm is None or one.table != "rates_table" else per_mm
    magnitudes = not of_motion(one) and takes_magnitudes(one, answered.values)
    return judge(one, answered.values, answered.given, limit=LIMIT, floor=floor, magnitudes=magnitudes)


def _reading(
    one: Asked, k: int, written: str, number: float, judged: Judged, causes: tuple[Cause, ...]
) -> Reading:
    right, delta, rule = float(one.values[k]), float(judged.delta[k]), judged.rules[k]
    unsigned = judged.magnitudes and right < 0
    if judged.magnitudes:
        number, right = abs(number), abs(right)
    none = rule in (Rule.ZERO, Rule.SIGN) or not np.isfinite(delta)
    explained = () if rule in RIGHT else tuple(cause for cause in causes if one.name in cause.names)
    return Reading(k, written, one, number, right, None if none else delta, rule, explained, unsigned)
