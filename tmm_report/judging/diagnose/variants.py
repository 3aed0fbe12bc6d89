"""The numbers of another variant: whose?"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.judging.diagnose.candidates import SHARE, Candidates, Mistake, enough
from tmm_report.judging.diagnose.columns import Fit, Stack, only
from tmm_report.judging.judge import default_floor
from tmm_report.judging.model import Asked, Expected, Name
from tmm_report.records import dataclass

Array = Any

COST = 1.0
FEW, COLUMNS = 0.05, 3  # with fewer wrong cells, or columns, the work is the student's own

MENDED = 0.6  # of the wrong cells: others may be slips of the hand
SAMPLE, ABLE, LIKELY = (
    8,
    0.5,
    12,
)  # columns looked at first; part of them that must fit; variants looked at closely


@dataclass(frozen=True, eq=False)
class Others:
    """All variants of a year, ready to be compared with one work after another.

    `ids`: V of them, sorted. Columns are stacked as they are asked for: (V, P), nan of a variant that lacks it.
    """

    variants: Mapping[str, Expected]
    ids: tuple[str, ...]
    _stacked: dict[tuple[Name, int], tuple[Array, Array]] = field(default_factory=dict)

    def numbers(self, asked: Asked) -> tuple[Array, Array]:
        """(V, P) numbers of a column and (V, 1) their floors."""
        key = asked.name, len(asked.values)
        if key not in self._stacked:
            self._stacked[key] = self._stack(asked)
        return self._stacked[key]

    def _stack(self, asked: Asked) -> tuple[Array, Array]:
        numbers = np.full((len(self.ids), len(asked.values)), np.nan)
        floors = np.full((len(self.ids), 1), np.nan)
        for v, name in enumerate(self.ids):
            other = self.variants[name].get(asked.name)
            if other is not None and other.unit == asked.unit and len(other.values) == len(asked.values):
                numbers[v], floors[v] = other.values, default_floor(other)
        return numbers, floors


def prepared(variants: Mapping[str, Expected]) -> Others:
    """The variants stacked: make it once for a whole year of works."""
    return Others(variants, tuple(sorted(variants)))


def another(stacks: list[Stack], wrong: list[Stack], others: Others, found: Candidates) -> None:
    """The variant that fits the whole work, if one does: most of what is wrong, and most of all."""
    answered = sum(int(stack.count.sum()) for stack in stacks)
    own = sum(int((stack.ok & stack.answered).sum()) for stack in stacks)
    columns = sum(len(stack.asked) for stack in wrong)
    if not others.ids or own > (1 - FEW) * answered or columns < COLUMNS:
        return
    likely = _likely(wrong, others)
    right, score = np.zeros(len(likely)), np.zeros(len(likely))
    for stack in stacks if len(likely) else ():
        fit = stack.fit(stack.mine[:, None], *_aims(stack, others, likely))
        right += fit.right.sum(axis=0)
        score += fit.score.sum(axis=0)
    fitting = (right >= SHARE * answered) & (right - own >= MENDED * (answered - own))
    if fitting.any():
        best = int(np.argmax(np.where(fitting, score, -np.inf)))
        before = sum(float(stack.as_given.score.sum()) for stack in stacks)
        _claim(wrong, others, int(likely[best]), float(score[best]) - before, found)


def _likely(wrong: list[Stack], others: Others) -> Array:
    """The variants, at most `LIKELY`, that fit some of the wrong columns; the rest are not looked at any further."""
    most = max(wrong, key=lambda stack: int(stack.count.sum()))
    some = np.zeros(len(most.asked), dtype=bool)
    some[np.unique(np.linspace(0, len(some) - 1, SAMPLE).round().astype(int))] = True
    sample = only(most, some)
    fit = sample.fit(sample.mine[:, None], *_aims(sample, others, np.arange(len(others.ids))))
    right, score = fit.right.sum(axis=0), fit.score.sum(axis=0)
    able = np.flatnonzero(right >= ABLE * sample.count.sum())
    return np.sort(able[np.argsort(-score[able], kind="stable")[:LIKELY]])


def _aims(stack: Stack, others: Others, chosen: Array) -> tuple[Array, Array]:
    """(C, V, P) numbers of some of the other variants and (C, V, 1) floors."""
    pairs = [others.numbers(asked) for asked in stack.asked]
    return np.array([numbers[chosen] for numbers, _ in pairs]), np.array(
        [floors[chosen] for _, floors in pairs]
    )


def _claim(wrong: list[Stack], others: Others, best: int, gain: float, found: Candidates) -> None:
    """Its claims to the wrong columns. What it gains or loses in the right ones too is told by its cost."""
    fits = [stack.fit(stack.mine[:, None], *_aims(stack, others, np.array([best]))) for stack in wrong]
    marks = [_explained(stack, fit) for stack, fit in zip(wrong, fits, strict=True)]
    claimed = sum(
        float((fit.score - stack.as_given.score)[firm].sum())
        for stack, fit, (firm, _) in zip(wrong, fits, marks, strict=True)
    )
    mistake = Mistake("variant", others.ids[best], cost=COST - (gain - claimed), special=True, broad=True)
    for stack, fit, (firm, any_) in zip(wrong, fits, marks, strict=True):
        for c in np.flatnonzero(any_[:, 0]):
            found.claim(mistake, stack, fit, int(c), 0, bool(firm[c, 0]))


def _explained(stack: Stack, fit: Fit) -> tuple[Array, Array]:
    """(C, 1) of bool twice: where the variant explains enough to accuse a column by itself; where it mends any cell."""
    firm, weak = enough(stack, fit, np.array([True]))
    short = stack.short[:, None] & (fit.right >= SHARE * stack.count[:, None])
    return firm, firm | weak | short
