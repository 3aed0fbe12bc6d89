"""Two positions in each other's place, in every column or in those of one table."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np

from tmm_report.judging.diagnose.columns import Stack
from tmm_report.judging.diagnose.single import goes_round
from tmm_report.judging.model import Name
from tmm_report.records import dataclass

Array = Any
COLUMNS = 3  # that must show it: two numbers of one column may be near each other's by chance
SHARE = 0.75  # of the wrong cells of both rows that must be right when they are put back


@dataclass(frozen=True, eq=False)
class Exchange:
    """Rows `one` and `other` stand in each other's place in the columns `names`."""

    one: int
    other: int
    names: tuple[Name, ...]
    right: int
    wrong: int


def exchanged(stack: Stack) -> Exchange | None:
    """The two rows, if there are such, that put back mend most of what is wrong in them."""
    chosen = np.array([goes_round(one) for one in stack.asked], dtype=bool)
    wrong = stack.answered & ~stack.ok & chosen[:, None]
    if wrong.any(axis=1).sum() < COLUMNS:
        return None
    found: list[tuple[int, Exchange]] = []
    rows = np.flatnonzero(wrong.sum(axis=0) >= COLUMNS).tolist()
    for i, j in combinations(rows, 2):
        if (one := _tried(stack, wrong, i, j)) is not None:
            found.append(one)
    return max(found, key=lambda pair: pair[0])[1] if found else None


def _tried(stack: Stack, wrong: Array, i: int, j: int) -> tuple[int, Exchange] | None:
    back = stack.mine.copy()
    back[:, [i, j]] = stack.mine[:, [j, i]]
    here = [i, j]
    after = (stack.fit(back[:, None], stack.right[:, None]).apart[:, 0] <= 1)[:, here]
    before = wrong[:, here]
    gain = (after & before).sum(axis=1) - (~after & stack.ok[:, here] & stack.answered[:, here]).sum(axis=1)
    columns = gain > 0
    mended, all_wrong = int((after & before)[columns].sum()), int(before.sum())
    if columns.sum() < COLUMNS or mended < SHARE * all_wrong:
        return None
    names = tuple(one.name for one, yes in zip(stack.asked, columns, strict=True) if yes)
    return int(gain[columns].sum()), Exchange(i, j, names, mended, int(before[columns].sum()))
