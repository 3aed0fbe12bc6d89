"""How the members of a train go round one another on its scheme: shafts as levels above the axis, webs left or right.

Of each body that turns about the main axis: `level` of its shaft, the side of the web of each of its rings and
carriers, and whether it goes round outside. What crosses least is found by trying one change after another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

from tmm_report.records import dataclass

TOUCH = 0.4  # mm: ends nearer than this to a line lie on it
ROUNDS = 6


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
    cost = 0.0
    for one, other in combinations(bars, 2):
        if one.body == other.body:
            continue
        if one.upright and other.upright:
            near = abs(one.start.real - other.start.real) < TOUCH
            cost += 3.0 if near and _overlap(_span(one, 1), _span(other, 1)) else 0.0
        elif not one.upright and not other.upright:
            near = abs(one.start.imag - other.start.imag) < TOUCH
            cost += 3.0 if near and _overlap(_span(one, 0), _span(other, 0)) else 0.0
        else:
            tall, flat = (one, other) if one.upright else (other, one)
            x, y = tall.start.real, flat.start.imag
            low, high = _span(tall, 1)
            left, right = _span(flat, 0)
            cost += 1.0 if low - TOUCH < y < high + TOUCH and left - TOUCH < x < right + TOUCH else 0.0
    return cost + 1e-4 * sum(abs(bar.end - bar.start) for bar in bars)


def _span(bar: Bar, way: int) -> tuple[float, float]:
    ends = [(one.real, one.imag)[way] for one in (bar.start, bar.end)]
    return min(ends), max(ends)


def _overlap(one: tuple[float, float], other: tuple[float, float]) -> bool:
    return min(one[1], other[1]) - max(one[0], other[0]) > -TOUCH


def best(
    start: Route, sided: Sequence[str], free: Sequence[str], drawn: Callable[[Route], list[Bar]]
) -> Route:
    """The route with the fewest crossings that single changes lead to. `sided`: members with a web on either side;
    `free`: bodies that may go outside."""
    found, cost = start, crossings(drawn(start))
    for _ in range(ROUNDS):
        near = [(crossings(drawn(other)), k, other) for k, other in enumerate(_changed(found, sided, free))]
        if not near:
            break
        least, _, other = min(near, key=lambda one: one[:2])
        if least >= cost - 1e-9:
            break
        found, cost = other, least
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
