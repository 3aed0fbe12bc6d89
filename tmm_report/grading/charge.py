"""One mistake is charged once: which wrong values are the student's mistakes, and which follow from these.

A value follows from others where it agrees with what they make of it. Values hang together both ways (v_B = ω₃·l, and
ω₃ = v_B/l), so that two wrong ones may each follow from the other: then one of them is the mistake, the one from which
most follows. Everything is found position by position, all positions at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Clause:
    """A way in which a value may follow: `agrees`, (P,) of bool, where the value of `key` is what its wrong `sources`
    make of it."""

    key: str
    sources: tuple[str, ...]
    agrees: Array


def charged(wrong: Mapping[str, Array], clauses: Iterable[Clause]) -> Mapping[str, tuple[str, ...]]:
    """Key of every wrong column -> (P,) the wrong value from which a wrong cell follows, "" where it is a mistake by
    itself and where it is not wrong.

    `wrong`: key -> (P,) of bool, in the order in which the values are found: of equals the first is the mistake.
    """
    return _Charge(wrong, clauses).follows()


class _Charge:
    """`wrong`: (K, P) of bool, by columns and positions; `ways`: clauses by the numbers of their columns."""

    def __init__(self, wrong: Mapping[str, Array], clauses: Iterable[Clause]) -> None:
        self.keys = list(wrong)
        self.place = {key: number for number, key in enumerate(self.keys)}
        self.wrong = np.array(list(wrong.values()), dtype=bool)
        self.ways = [way for one in clauses if one.key in wrong and (way := self._way(one))[2].any()]

    def _way(self, one: Clause) -> tuple[int, list[int], Array]:
        """A clause by numbers. Where none of its sources is wrong nothing follows."""
        row = self.place[one.key]
        sources = sorted(self.place[key] for key in one.sources if key in self.place and key != one.key)
        return row, sources, one.agrees & self.wrong[row] & self.wrong[sources].any(axis=0)

    def follows(self) -> dict[str, tuple[str, ...]]:
        if not self.wrong.size:
            return {}
        able = np.zeros_like(self.wrong)
        for row, _, agrees in self.ways:
            able[row] |= agrees
        # what follows in no way is a mistake
        mistakes = self.wrong & ~able
        unsettled, _ = self._closed(self.wrong & able)
        chosen: list[int] = []
        while unsettled.any():
            row, rest = self._another(unsettled)
            mistakes[row] |= unsettled[row]
            chosen.append(row)
            unsettled = rest
        for row in chosen:
            mistakes[row] &= ~self._follows_after_all(row, mistakes, able)
        _, source = self._closed(self.wrong & ~mistakes)
        names = [[self.keys[number] if number >= 0 else "" for number in row] for row in source.tolist()]
        return dict(zip(self.keys, map(tuple, names), strict=True))

    def _another(self, unsettled: Array) -> tuple[int, Array]:
        """One mistake more, the column from which most follows, and what is unsettled then."""
        trials = []
        for row in np.flatnonzero(unsettled.any(axis=1)).tolist():
            rest = unsettled.copy()
            rest[row] = False
            trials.append((row, self._closed(rest)[0]))
        return min(trials, key=lambda trial: int(trial[1].sum()))

    def _follows_after_all(self, row: int, mistakes: Array, able: Array) -> Array:
        """(P,) of bool: where a mistake follows from those that were found after it."""
        others = mistakes.copy()
        others[row] &= ~able[row]
        unsettled, _ = self._closed(self.wrong & ~others)
        return mistakes[row] & able[row] & ~unsettled.any(axis=0)

    def _closed(self, unsettled: Array) -> tuple[Array, Array]:
        """What is unsettled still once all has followed that follows from what is settled, and from which column each
        cell follows."""
        unsettled, source, changed = unsettled.copy(), np.full(self.wrong.shape, -1), True
        while changed:
            changed = False
            for row, sources, agrees in self.ways:
                new = agrees & unsettled[row]
                if new.any() and (new := new & ~unsettled[sources].any(axis=0)).any():
                    changed = True
                    unsettled[row] &= ~new
                    source[row][new] = self._named(sources)[new]
        return unsettled, source

    def _named(self, sources: Sequence[int]) -> Array:
        """The first of the sources that is wrong, at each position."""
        return np.array(sources)[np.argmax(self.wrong[sources], axis=0)]
