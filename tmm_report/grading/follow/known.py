"""A number by positions, and which of a student's own numbers it was made of."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any
NONE: frozenset[str] = frozenset()
NOWHERE = np.False_


@dataclass(frozen=True, eq=False)
class Known:
    """`value`: (P,), the student's where it is his own or follows from what is his own, elsewhere the right one.

    `told`: (P,) of bool, or one for all, where it is the student's; `sources`: the keys of his numbers it was made of.
    """

    value: Array
    told: Array = NOWHERE
    sources: frozenset[str] = NONE


def derived(right: Array, how: Callable[..., Array], *inputs: Known) -> Known:
    """What `how` makes of the inputs' values where one of them is the student's; `right` elsewhere."""
    return derived_together([right], lambda *values: [how(*values)], *inputs)[0]


def derived_together(
    rights: Sequence[Array], how: Callable[..., Sequence[Array]], *inputs: Known
) -> list[Known]:
    """The same of several numbers that are found in one step."""
    his = [known for known in inputs if known.sources]
    if not his:
        return [Known(right) for right in rights]
    told = reduce(np.logical_or, [known.told for known in his])
    sources = his[0].sources.union(*(known.sources for known in his[1:]))
    found = how(*(known.value for known in inputs))
    return [_where(right, value, told, sources) for right, value in zip(rights, found, strict=True)]


def _where(right: Array, value: Array, told: Array, sources: frozenset[str]) -> Known:
    told = told & np.isfinite(value)
    if told.all() and told.shape == np.shape(right):
        return Known(value, told, sources)
    return Known(np.where(told, value, right), told, sources) if told.any() else Known(right)


def first(right: Array, choices: Sequence[Known]) -> Known:
    """At every position the first of the choices that is the student's, else the right one. What adds no position is
    no source."""
    his = [known for known in choices if known.sources]
    if his and his[0].told.all():
        return his[0]
    value, told, sources = right, NOWHERE, NONE
    for known in his:
        new = known.told & ~told
        if np.any(new):
            value, told, sources = (
                np.where(new, known.value, value),
                told | known.told,
                sources | known.sources,
            )
    return Known(value, told, sources)
