"""A student's answered columns stacked into arrays, for transformations tried on all of them at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.judging.judge import default_floor, deviation, full_turn, nearest
from tmm_report.judging.model import Answers, Asked, Expected, Judged, Name
from tmm_report.records import dataclass

Array = Any

SHORT = 4  # answered cells: below that a column tells too little by itself
LOUD = 2.0  # floors: a number below that is near 0 and fits almost anything


@dataclass(frozen=True, eq=False)
class Stack:
    """Columns C of equally many rows P.

    `right`, `mine`: (C, P), mine nan where there is no answer. `ok`: (C, P), as judged. `floor`, `turn`: (C, 1);
    turn is a full turn of an angle, nan of anything else. `magnitudes`: (C, 1), compared without signs.
    """

    asked: tuple[Asked, ...]
    right: Array
    mine: Array
    ok: Array
    floor: Array
    turn: Array
    magnitudes: Array
    limit: float

    @cached_property
    def answered(self) -> Array:
        """(C, P): where a number was asked and given."""
        return np.isfinite(self.right) & np.isfinite(self.mine)

    @cached_property
    def count(self) -> Array:
        """(C,): answered cells."""
        return self.answered.sum(axis=1)

    @cached_property
    def before(self) -> Array:
        """(C,): parts of the answered cells that are right as given."""
        return (self.ok & self.answered).sum(axis=1) / self.count

    @cached_property
    def short(self) -> Array:
        return self.count < SHORT

    def fit(self, undone: Array, aims: Array, floor: Array | None = None) -> Fit:
        """How numbers with a mistake undone agree with those aimed at; both (C, T, P) or broadcast to it.

        `floor`: (C, T, 1), where that of the column asked is not the one to read by.
        """
        limit, floor = self.limit, self.floor[:, None] if floor is None else floor
        if self.magnitudes.any():
            signless = self.magnitudes[:, None]
            undone, aims = np.where(signless, np.abs(undone), undone), np.where(signless, np.abs(aims), aims)
        if (circle := np.isfinite(self.turn[:, 0])).any():
            aims, undone = np.broadcast_arrays(aims, undone)
            near = nearest(aims[circle], undone[circle], self.turn[circle][:, None])
            undone = np.array(undone)
            undone[circle] = near
        apart = deviation(aims, undone, limit, floor)
        return Fit(apart, self.answered[:, None], np.broadcast_to(np.abs(aims) > LOUD * floor, apart.shape))

    @cached_property
    def as_given(self) -> Fit:
        """Without any mistake undone, T = 1."""
        return self.fit(self.mine[:, None], self.right[:, None])


@dataclass(frozen=True, eq=False)
class Fit:
    """`apart`: (C, T, P) deviations in parts of what is allowed, nan without a number. `answered`: (C, 1, P).
    `loud`: (C, T, P), where the number aimed at is far from 0."""

    apart: Array
    answered: Array
    loud: Array

    @cached_property
    def fits(self) -> Array:
        return self.answered & (self.apart <= 1)

    @cached_property
    def right(self) -> Array:
        """(C, T): cells that agree."""
        return self.fits.sum(axis=2)

    @cached_property
    def score(self) -> Array:
        """(C, T): cells that agree, one at the edge of what is allowed counting half."""
        return np.where(self.fits, 1 - self.apart**2 / 2, 0.0).sum(axis=2)

    @cached_property
    def loud_right(self) -> Array:
        return (self.fits & self.loud).sum(axis=2)

    @cached_property
    def loud_count(self) -> Array:
        return (self.answered & self.loud).sum(axis=2)

    @cached_property
    def tight(self) -> Array:
        """(C, T): whether every answered cell agrees to half of what is allowed, far from 0."""
        all_tight = np.where(self.answered, self.loud & (self.apart <= 0.5), True)
        return all_tight.all(axis=2) & self.answered.any(axis=2)


def stacks(
    answers: Answers,
    expected: Expected,
    judged: Mapping[Name, Judged],
    limit: float,
    floors: Mapping[Name, float],
) -> list[Stack]:
    """The columns that have an answered cell, stacked by their numbers of rows; whole numbers are left out."""
    by_rows: dict[int, list[Name]] = {}
    for name, column in answers.columns.items():
        if name in judged and name in expected and not expected[name].whole:
            numbers = np.isfinite(expected[name].values) & np.isfinite(column.values) & column.given
            if numbers.any():
                by_rows.setdefault(len(numbers), []).append(name)
    return [_stack(names, answers, expected, judged, limit, floors) for names in by_rows.values()]


def _stack(
    names: list[Name],
    answers: Answers,
    expected: Expected,
    judged: Mapping[Name, Judged],
    limit: float,
    floors: Mapping[Name, float],
) -> Stack:
    asked = tuple(expected[name] for name in names)
    columns = [answers.columns[name] for name in names]
    marks = [judged[name] for name in names]
    return Stack(
        asked,
        np.array([one.values for one in asked], dtype=float),
        np.array([np.where(one.given, one.values, np.nan) for one in columns], dtype=float),
        np.array([one.ok for one in marks], dtype=bool),
        np.array([[floors.get(one.name, default_floor(one))] for one in asked]),
        np.array([[full_turn(one.unit) if one.angle else np.nan] for one in asked]),
        np.array([[one.magnitudes] for one in marks], dtype=bool),
        limit,
    )


def only(stack: Stack, chosen: Array) -> Stack:
    """Some of the columns; `chosen`: (C,) of bool."""
    return Stack(
        tuple(one for one, yes in zip(stack.asked, chosen, strict=True) if yes),
        stack.right[chosen],
        stack.mine[chosen],
        stack.ok[chosen],
        stack.floor[chosen],
        stack.turn[chosen],
        stack.magnitudes[chosen],
        stack.limit,
    )


def wrong(all_stacks: list[Stack]) -> Iterator[Stack]:
    """The columns that have a wrong cell."""
    for stack in all_stacks:
        chosen = (stack.answered & ~stack.ok).any(axis=1)
        if chosen.any():
            yield only(stack, chosen)
