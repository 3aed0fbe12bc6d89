"""Works that share numbers which are wrong for one of them: a copy, or another's variant. A flag, never a mark.

Written to three digits, two honest works of different variants share next to nothing of what is counted here: a
number wrong for the one, where the two solutions themselves differ by more than the course's limit. Works of one
variant are never set against each other: their right numbers are the same.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from tmm_report.quantity.text import round_significant
from tmm_report.records import dataclass

Array = Any

USUAL, OF = 13, 48  # of 48 cells more than 13 shared are worth a look; honest works share 9 once in 10 000
LEAST = 5  # fewer shared cells than this say nothing, however few there are
DIFFER = 0.05  # relative: solutions nearer than the limit are not told apart by numbers read off a plan
CROWD = 64  # works with one and the same number in a cell, above which each is set against one of them alone


def limit(cells: int) -> float:
    """So many shared cells, of `cells` compared, may be chance; more are a flag.

    In proportion to 13 of 48; above 48 cells with the root of their number, as chance goes; never below LEAST.
    """
    part = cells / OF
    return max(float(LEAST), USUAL * min(part, math.sqrt(part)))


@dataclass(frozen=True, eq=False)
class Entries:
    """The cells that students answered, all works one after another, each array (E,).

    `owner`: number of the work; `cell`: of the cell; `number`: the student's; `solution`: of his variant; `right`:
    whether his number is right for it.
    """

    owner: Array
    cell: Array
    number: Array
    solution: Array
    right: Array

    def of(self, chosen: Array) -> Entries:
        return Entries(*(getattr(self, name)[chosen] for name in self.__dataclass_fields__))


class Copy(NamedTuple):
    """`one` has `shared` numbers of `other` that are wrong for `one`'s variant; `fits` of them are right for
    `other`'s. `cells`: in so many their solutions differ and both gave a number. Works go by number."""

    one: int
    other: int
    shared: int
    fits: int
    cells: int


def copies(entries: Entries) -> list[Copy]:
    """All pairs that share more than chance, the most shared first.

    Of several that have one and the same work's numbers each is named with it, not with one another.
    """
    kept = entries.of(_telling(entries))
    flagged = [copy for copy in _candidates(kept) if copy.shared > limit(copy.cells)]
    flagged.sort(key=lambda copy: (-copy.fits, -copy.shared, copy.one, copy.other))
    return list(_without_echoes(flagged))


def _telling(entries: Entries) -> Array:
    """(E,) of bool: where the number says something: not 0, nor of one digit (5; 0,2; 1000)."""
    numbers = entries.number
    known = np.isfinite(numbers) & np.isfinite(entries.solution) & (numbers != 0)
    return known & (round_significant(numbers, 3) != round_significant(numbers, 1))


def _candidates(kept: Entries) -> Iterator[Copy]:
    """Pairs with more than LEAST shared cells, each with who has whose numbers."""
    ours, theirs = _shared(kept)
    if not len(ours):
        return
    pairs, at = np.unique(
        np.stack([kept.owner[ours], kept.owner[theirs]], axis=1), axis=0, return_inverse=True
    )
    wrong = [~kept.right[side] for side in (ours, theirs)]
    count = [np.bincount(at.ravel(), weights=side, minlength=len(pairs)).astype(int) for side in wrong]
    alone = [wrong[k] & ~wrong[1 - k] for k in (0, 1)]
    fits = [np.bincount(at.ravel(), weights=side, minlength=len(pairs)).astype(int) for side in alone]
    bounds = _bounds(kept.owner)
    for k in np.flatnonzero(np.maximum(*count) > LEAST):
        side = 0 if (fits[0][k], count[0][k]) > (fits[1][k], count[1][k]) else 1
        one, other = int(pairs[k][side]), int(pairs[k][1 - side])
        yield Copy(
            one, other, int(count[side][k]), int(fits[side][k]), _compared(kept, bounds[one], bounds[other])
        )


def _shared(kept: Entries) -> tuple[Array, Array]:
    """Pairs of entries (of the lower owner, of the higher) that hold one number in one cell, to three digits, wrong
    for one of them at least, their solutions apart."""
    code = round_significant(kept.number, 3)
    order = np.lexsort((kept.owner, code, kept.cell))
    fresh = np.flatnonzero(np.diff(kept.cell[order], prepend=-1).astype(bool) | _steps(code[order]))
    sizes = np.diff(fresh, append=len(order))
    doubtful = np.add.reduceat(~kept.right[order], fresh) > 0 if len(fresh) else np.zeros(0, dtype=bool)
    small, large = doubtful & (sizes > 1) & (sizes <= CROWD), doubtful & (sizes > CROWD)
    pairs = [*_neighbours(order, fresh[small], sizes[small]), *_hubs(kept, order, fresh[large], sizes[large])]
    if not pairs:
        return np.zeros(0, dtype=int), np.zeros(0, dtype=int)
    ours, theirs = (np.concatenate(side) for side in zip(*pairs, strict=True))
    apart = _apart(kept.solution[ours], kept.solution[theirs]) & ~(kept.right[ours] & kept.right[theirs])
    return ours[apart], theirs[apart]


def _steps(code: Array) -> Array:
    """(E,) of bool: where a sorted number is another than the one before it."""
    return np.concatenate([[True], code[1:] != code[:-1]]) if len(code) else np.zeros(0, dtype=bool)


def _apart(one: Array, other: Array) -> Array:
    """Whether two solutions are told apart: by more than DIFFER of the larger."""
    return np.abs(one - other) > DIFFER * np.maximum(np.abs(one), np.abs(other))


def _neighbours(order: Array, starts: Array, sizes: Array) -> Iterator[tuple[Array, Array]]:
    """All pairs within groups of equal numbers: those one apart in the sorted list, two apart, …"""
    ends = np.repeat(starts + sizes, sizes)
    places = np.arange(len(ends)) + np.repeat(starts + sizes - np.cumsum(sizes), sizes)
    for step in range(1, CROWD):
        inside = places + step < ends
        places, ends = places[inside], ends[inside]
        if not len(places):
            return
        yield order[places], order[places + step]


def _hubs(kept: Entries, order: Array, starts: Array, sizes: Array) -> Iterator[tuple[Array, Array]]:
    """In a crowd each entry is paired with one of them, the same from cell to cell: of those for which the number is
    right the work with the most right numbers, else the first."""
    rights = np.bincount(kept.owner, weights=kept.right)
    for start, size in zip(starts, sizes, strict=True):
        group = order[start : start + size]
        hub = group[int(np.argmax(rights[kept.owner[group]] * kept.right[group]))]
        others = group[group != hub]
        yield (
            np.minimum(others, hub),
            np.maximum(others, hub),
        )  # entries stand by owner, so this orders the owners


def _bounds(owner: Array) -> dict[int, slice]:
    """Where the entries of each work stand: works are one after another."""
    starts = np.flatnonzero(np.diff(owner, prepend=-1))
    ends = np.append(starts[1:], len(owner))
    return {int(owner[start]): slice(int(start), int(end)) for start, end in zip(starts, ends, strict=True)}


def _compared(kept: Entries, one: slice, other: slice) -> int:
    """In how many cells two works can be compared: both gave a number, and their solutions are apart."""
    _, a, b = np.intersect1d(kept.cell[one], kept.cell[other], return_indices=True)
    return int(np.count_nonzero(_apart(kept.solution[one][a], kept.solution[other][b])))


def _without_echoes(flagged: Sequence[Copy]) -> Iterator[Copy]:
    """Pairs whose both works are already named with one and the same third say nothing new."""
    source: dict[int, set[int]] = {}
    for copy in flagged:
        if not source.get(copy.one, set()) & source.get(copy.other, set()):
            source.setdefault(copy.one, set()).add(copy.other)
            yield copy
