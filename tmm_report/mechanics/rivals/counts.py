"""How many positions of a cycle a course needs: what it takes from a table of 12 … 100 positions, against the exact.

The greatest value of a table is that of the nearest position, so it is short by some y″h²/8; a sum over equal steps is
exact for a smooth function and off by a kink's share for others (see `integrals`); the excess work of a flywheel is the
height between two positions of a sum. The exact ones are those of the functions on panels, between kinks and jumps.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.lever.extremes import Peaks, peaks, size_peaks
from tmm_report.mechanics.rivals.integrals import trapezoid
from tmm_report.records import dataclass

Array = Any
Table = Callable[[int], Array]  # count -> values (..., count + 1) at as many equal steps, the last included
COUNTS = (12, 24, 36, 72, 100)
USUAL = 0.01  # what a course is content with where a variant states no accuracy
NOTHING = 1e-9  # of the largest: a row that is smaller is none


@dataclass(frozen=True, eq=False)
class Wanted:
    """What a course takes from its table. `exact` (F,): of each row; `sizes` (F,): by which its error is measured;
    `of`: the same from the values (F, count + 1) at `count` equal steps of the cycle."""

    key: str
    exact: Array
    sizes: Array
    table: Table
    of: Callable[[Array], Array]

    def error(self, count: int) -> float:
        """Of the worst row, relative; rows that are next to nothing beside the largest are left out."""
        off = np.abs(self.of(self.table(count)) - self.exact)
        some = self.sizes > NOTHING * np.max(self.sizes)
        return float(np.max(off[some] / self.sizes[some]))

    @property
    def known(self) -> bool:
        """Whether there is something to find."""
        return bool(np.max(self.sizes, initial=0.0) > 0)


@dataclass(frozen=True)
class Counted:
    """`errors`: key -> relative error at each of `counts`; `enough`: key -> the least count from which on it is within
    the accuracy, None where none of them is; `recommended`: the same of all of them."""

    counts: tuple[int, ...]
    accuracy: float
    errors: Mapping[str, tuple[float, ...]]

    @property
    def enough(self) -> dict[str, int | None]:
        return {key: self._least(row) for key, row in self.errors.items()}

    @property
    def recommended(self) -> int | None:
        found = self.enough.values()
        return None if None in found else max((count for count in found if count), default=self.counts[0])

    def _least(self, errors: Sequence[float]) -> int | None:
        """A table that is right by chance while a finer one is not does not count."""
        wrong = [k for k, error in enumerate(errors) if not error <= self.accuracy]
        first = wrong[-1] + 1 if wrong else 0
        return self.counts[first] if first < len(self.counts) else None


def counted(
    wanted: Sequence[Wanted], accuracy: float | None = None, counts: tuple[int, ...] = COUNTS
) -> Counted:
    """The errors of all that there is to find at each count."""
    rows = {one.key: tuple(one.error(count) for count in counts) for one in wanted if one.known}
    return Counted(counts, USUAL if accuracy is None else accuracy, rows)


# ---------------------------------------------------------------- what is taken from a table


def greatest(key: str, over: Panels, vectors: Array, table: Table, closed: bool = True) -> Wanted:
    """The greatest magnitude of vectors (F, K, n), each by itself."""
    exact = np.array([high.value for _, high in size_peaks(over, vectors, closed)])
    return Wanted(key, exact, exact, table, lambda values: np.max(np.abs(values), axis=-1))


def extremes(key: str, over: Panels, values: Array, table: Table, closed: bool = True) -> Wanted:
    """The least and the greatest of a function (K, n), by the larger of them."""
    return extremes_of(key, peaks(over, np.asarray(values)[None], closed)[0], table)


def extremes_of(key: str, known: Peaks, table: Table) -> Wanted:
    """The same where they are known."""
    exact = np.array([end.value for end in known])
    return Wanted(key, exact, np.full(2, np.max(np.abs(exact))), table, _ends)


def _ends(values: Array) -> Array:
    return np.array([np.min(values), np.max(values)])


def total(key: str, over: Panels, values: Array, table: Table) -> Wanted:
    """Integral over the cycle of a function (K, n), by the trapezoidal rule; nothing to find where it is rounding
    beside the integral of the magnitude."""
    exact = float(over.total(values))
    size = abs(exact) if abs(exact) > NOTHING * float(over.total(np.abs(values))) else 0.0
    return Wanted(key, np.array([exact]), np.array([size]), table, lambda y: _summed(y, over.period)[None])


def mean(key: str, over: Panels, values: Array, table: Table) -> Wanted:
    """Mean over the cycle, of the positions but the last, which is the first."""
    exact = float(over.mean(values))
    return Wanted(
        key,
        np.array([exact]),
        np.array([abs(exact)]),
        table,
        lambda y: _summed(y, over.period)[None] / over.period,
    )


def unevenness(key: str, over: Panels, functions: tuple[Array, Array], table: Table, omega: float) -> Wanted:
    """δ of the machine with a flywheel J_I by Mertsalov's method: the swing of what the first group of links must take
    up, ΔT_I = A − J ω²/2, by J_I ω². So δ is as wrong as the swing, and so is the flywheel for a stated δ.

    `functions`: the reduced moment of the loads and moment of inertia, (K, n) each; `table`: the same two rows."""
    moment, inertia = functions
    excess = moment - over.mean(moment)
    (low, _), (high, _) = over.extremes(over.running(excess) - inertia * omega**2 / 2)
    swing = high - low
    size = swing if np.any(np.abs(moment) > 0) else 0.0

    def of(values: Array) -> Array:
        return np.array([np.ptp(_work(values[0], over.period) - values[1] * omega**2 / 2)])

    return Wanted(key, np.array([swing]), np.array([size]), table, of)


def _work(moment: Array, period: float) -> Array:
    """Work of the excess moment up to each position, by trapezia."""
    step = period / (moment.shape[-1] - 1)
    excess = moment - _summed(moment, period) / period
    return np.concatenate([[0.0], np.cumsum(step * (excess[1:] + excess[:-1]) / 2)])


def _summed(values: Array, period: float) -> Array:
    return trapezoid(values, period / (values.shape[-1] - 1))
