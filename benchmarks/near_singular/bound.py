"""The conditioning bound: by how much each quantity changes when every number of the mechanism is rounded once.

Every vector z of the mechanism (a point of a link, a point and the direction of a guide) and the driver's angle may be
off by ε of its size. The quantity y then moves by at most ε Σ |∂y/∂z| |z|, and is itself rounded by ε |y|. The
derivatives are those of the motion in 130 digits, each number moved by 1e-30 of itself. No method that takes its
numbers in doubles can promise less.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from benchmarks.near_singular.closed import Number, exactly, lifted, mp
from tmm_report.mechanics.lever.mechanism import Mechanism

EPS = mp.mpf(2) ** -52
MOVE = mp.mpf(10) ** -30
TURN = mp.mpc(0, 1)

Key = tuple[str, str]  # kind of quantity, its point, link or pair
Solver = Callable[[Mechanism, Number], Mapping[Key, Number]]


@dataclass(frozen=True)
class Value:
    """An exact value and its conditioning bound, absolute."""

    exact: Number
    bound: Number

    @property
    def condition(self) -> float:
        """Relative condition number; inf of what is zero."""
        return float(self.bound / (EPS * abs(self.exact))) if self.exact else float("inf")

    def times(self, found: Any) -> float:
        """The error of what was found, as times the bound."""
        return float(abs(exactly(found) - self.exact) / self.bound) if self.bound else 0.0


def bounded(mechanism: Mechanism, phi: float, solve: Solver) -> dict[Key, Value]:
    """Every quantity that `solve` finds at driver angle `phi`, rad, with its bound."""
    whole, angle = lifted(mechanism), exactly(float(phi))
    exact = solve(whole, angle)
    moved = dict.fromkeys(exact, mp.mpf(0))
    for sides in _moved(whole, angle):
        squares = dict.fromkeys(exact, mp.mpf(0))
        for one, at in sides:
            for key, y in solve(one, at).items():
                squares[key] += abs(y - exact[key]) ** 2
        for key, square in squares.items():
            moved[key] += mp.sqrt(square) / MOVE
    return {key: Value(y, EPS * (moved[key] + abs(y))) for key, y in exact.items()}


def _moved(m: Mechanism, phi: Number) -> Iterator[list[tuple[Mechanism, Number]]]:
    """The mechanism with one of its numbers longer, and turned; the angle alone."""
    yield [(m, phi * (1 + MOVE) if phi else MOVE)]
    for name, link in m.links.items():
        for point, z in link.points.items():
            if z:
                ways = [{**link.points, point: z * by} for by in (1 + MOVE, 1 + TURN * MOVE)]
                yield [(replace(m, links={**m.links, name: replace(link, points=way)}), phi) for way in ways]
    for name, guide in m.guides.items():
        for part in _parts(guide):
            yield [(replace(m, guides={**m.guides, name: one}), phi) for one in part]
    for k, slide in enumerate(m.slides):
        for part in _parts(slide):
            yield [(replace(m, slides=[*m.slides[:k], one, *m.slides[k + 1 :]]), phi) for one in part]


def _parts(line: Any) -> Iterator[list[Any]]:
    """A guide or slide with its point moved both ways, and with its direction turned."""
    if line.through:
        yield [replace(line, through=line.through * by) for by in (1 + MOVE, 1 + TURN * MOVE)]
    yield [replace(line, direction=line.direction * (1 + TURN * MOVE))]
