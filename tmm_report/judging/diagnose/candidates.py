"""A mistake that may have been made, and the columns that it would explain."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field
from typing import Any

import numpy as np

from tmm_report.judging.diagnose.columns import SHORT, Fit, Stack
from tmm_report.judging.model import Name
from tmm_report.records import dataclass

Array = Any

SHARE = 0.75  # of the answered cells that must be right once a mistake is undone
GAIN = 0.2  # by which that must beat the column as given
LOUD_CELLS = 2  # right cells far from 0, at least


@dataclass(frozen=True)
class Mistake:
    """One of KINDS with what tells it from others of its kind.

    `by`: a factor, or steps between positions. `names`: the two columns of a pair. `cost`: in cells, how many right
    ones it must explain beyond a simpler mistake. `special`: hits no number by chance, so that few cells show it.
    `broad`: made in the whole work rather than in one column.
    """

    kind: str
    detail: str = ""
    by: float = 0.0
    names: tuple[Name, ...] = ()
    cost: float = 0.0
    special: bool = False
    broad: bool = False


@dataclass(frozen=True, eq=False)
class Claim:
    """What undoing a mistake does to one column.

    `fits`: (P,) the cells that are then right, of `answered` ones. `score`: the same with the misfit taken off; `gain`:
    how much more than as given. `firm`: enough to accuse the column; else it only follows others.
    """

    fits: Array
    answered: int
    score: float
    gain: float
    firm: bool = True


@dataclass(eq=False)
class Candidate:
    """A mistake with its claims by column."""

    mistake: Mistake
    claims: dict[Name, Claim] = field(default_factory=dict)


class Candidates:
    """Candidates by their mistakes; those of several stacks are joined."""

    def __init__(self) -> None:
        self._by_mistake: dict[Mistake, Candidate] = {}

    def __iter__(self) -> Iterator[Candidate]:
        return iter(self._by_mistake.values())

    def add(
        self, mistakes: Sequence[Mistake], stack: Stack, fit: Fit, applies: Array, shown: Array | bool = True
    ) -> None:
        """The claims of T mistakes tried on a stack. `applies`: (C, T) of bool, where a mistake can be made; `shown`:
        where the column can accuse of it."""
        firm, weak = enough(stack, fit, np.array([m.special for m in mistakes]))
        firm &= shown
        weak &= np.array([m.broad for m in mistakes])
        for c, t in np.argwhere((firm | weak) & applies).tolist():
            self.claim(mistakes[t], stack, fit, c, t, bool(firm[c, t]))

    def claim(self, mistake: Mistake, stack: Stack, fit: Fit, c: int, t: int, firm: bool = True) -> None:
        score = float(fit.score[c, t])
        gain = score - float(stack.as_given.score[c, 0])
        candidate = self._by_mistake.setdefault(mistake, Candidate(mistake))
        candidate.claims[stack.asked[c].name] = Claim(fit.fits[c, t], int(stack.count[c]), score, gain, firm)


def enough(stack: Stack, fit: Fit, special: Array) -> tuple[Array, Array]:
    """(C, T) of bool twice: where a mistake explains enough to accuse a column; where it explains it and mends any."""
    long = ~stack.short[:, None]
    most = _most(stack.count[:, None], fit.right, fit.loud_right, fit.loud_count)
    better = fit.right - stack.before[:, None] * stack.count[:, None]
    firm = long & most & (better >= GAIN * stack.count[:, None])
    firm |= ~long & fit.tight & special & (better > 0)
    if (short := stack.short).any():
        firm[short] |= _pooled(stack, fit)[short] & (better[short] > 0)
    return firm, most & (better >= 1)


def _most(count: Array, right: Array, loud_right: Array, loud_count: Array) -> Array:
    loud = (loud_right >= LOUD_CELLS) & (loud_right >= SHARE * loud_count)
    return (right >= SHARE * count) & loud


def _pooled(stack: Stack, fit: Fit) -> Array:
    """(C, T): where the short columns of a table in one unit, taken together, are explained."""
    groups = [
        (one.table, one.unit) if short else None for one, short in zip(stack.asked, stack.short, strict=True)
    ]
    same = np.array([[a is not None and a == b for b in groups] for a in groups])
    count, before = same @ stack.count, same @ (stack.before * stack.count)
    right, loud_right, loud_count = (same @ one for one in (fit.right, fit.loud_right, fit.loud_count))
    most = _most(count[:, None], right, loud_right, loud_count)
    own = fit.right >= SHARE * stack.count[:, None]
    return own & most & (count >= SHORT)[:, None] & (right - before[:, None] >= GAIN * count[:, None])
