"""How the members of a train go round one another on its scheme: shafts as levels above the axis, webs left or right.

Of each body that turns about the main axis: `level` of its shaft, the side of the web of each of its rings and
carriers, and whether it goes round outside. What crosses least is found by trying one change after another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from tmm_report.records import dataclass

TOUCH = 0.4  # mm: ends nearer than this to a line lie on it
TRIED = 400  # changes: a train of many rows is drawn as it stands then


class Bar(NamedTuple):
    """A stroke of a body, along the axis or across it."""

    body: str
    start: complex
    end: complex

    @property
    def upright(self) -> bool:
        return abs((self.end - self.start).real) < 1e-6


@dataclass(frozen=True)
class Route:
    """`order`: the bodies from the innermost shaft outwards; `right`: members whose web stands on the right; `outside`:
    bodies that go round outside."""

    order: tuple[str, ...]
    right: frozenset[str] = frozenset()
    outside: frozenset[str] = frozenset()


def crossings(bars: Sequence[Bar]) -> float:
    """How many strokes of two bodies cross, those that lie on one another counted thrice, long strokes a little."""
    start, end = (np.array([getattr(bar, key) for bar in bars]) for key in ("start", "end"))
    low = np.minimum(start.real, end.real), np.minimum(start.imag, end.imag)
    high = np.maximum(start.real, end.real), np.maximum(start.imag, end.imag)
    # what overlaps along both axes meets: of an upright and a level stroke that is a crossing
    along, across = (
        np.minimum.outer(h, h) - np.maximum.outer(w, w) > -TOUCH for w, h in zip(low, high, strict=True)
    )
    names, upright = np.array([bar.body for bar in bars]), np.array([bar.upright for bar in bars])
    met = along & across & (names[:, None] != names)
    alike = met & (upright[:, None] == upright)
    return float(met.sum() + 2 * alike.sum()) / 2 + 1e-4 * float(np.abs(end - start).sum())


def best(
    start: Route, sided: Sequence[str], free: Sequence[str], drawn: Callable[[Route], list[Bar]]
) -> Route:
    """A route with few crossings that single changes lead to, each taken as it is met. `sided`: members with a web on
    either side; `free`: bodies that may go outside."""
    found, cost, tried, better = start, crossings(drawn(start)), 0, True
    while better:
        better = False
        for other in _changed(found, sided, free):
            if (tried := tried + 1) > TRIED:
                return found
            if (least := crossings(drawn(other))) < cost - 1e-9:
                found, cost, better = other, least, True
                break
    return found


def _changed(route: Route, sided: Sequence[str], free: Sequence[str]) -> Iterator[Route]:
    for name in sided:
        yield replace(route, right=route.right ^ {name})
    for body in free:
        yield replace(route, outside=route.outside ^ {body})
        for name in sided:
            yield replace(route, outside=route.outside ^ {body}, right=route.right ^ {name})
    for i, j in combinations(range(len(route.order)), 2):
        order = list(route.order)
        order[i], order[j] = order[j], order[i]
        yield replace(route, order=tuple(order))
        for name in sided:
            yield replace(route, order=tuple(order), right=route.right ^ {name})
