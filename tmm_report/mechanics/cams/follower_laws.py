"""Laws of a follower's motion over a turn of its cam: phases of rise, dwell and return, a table of lifts, or a cam of
arcs.

A phase of the angle β lifts by h·f(τ), τ = θ/β, so that S' = h f'/β and S'' = h f''/β²; a return lowers by the same.
The shapes f stand in `shapes.py`.

Source: Artobolevsky, Theory of mechanisms and machines, ch. 26; Frolov (ed.), Theory of mechanisms, ch. 15.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.cams.arcs import EDGE as EDGE
from tmm_report.mechanics.cams.arcs import FULL_TURN as FULL_TURN
from tmm_report.mechanics.cams.arcs import ArcLaw
from tmm_report.mechanics.cams.shapes import Shape, Three
from tmm_report.records import dataclass

Array = Any
Kind = Literal["rise", "dwell", "return"]
BEFORE = 7 * EDGE  # rad: surely before a break


@dataclass(frozen=True)
class Phase:
    """A part of the cam's turn of `angle`, rad, by the shape of its law; a dwell has none. `parts`: into how many equal
    parts it is divided for a table, 0 of none."""

    kind: Kind
    angle: float
    law: Shape | None = None
    parts: int = 0


@dataclass(frozen=True, eq=False)
class Phases:
    """A follower's law by phases that fill a turn, from the lowest position and back to it; of a driving link the
    last may end in the high one. `lift`: m or rad."""

    phases: tuple[Phase, ...]
    lift: float

    @cached_property
    def edges(self) -> Array:
        """Where each phase begins, and the end of the turn, rad of the cam's angle."""
        return np.concatenate([[0.0], np.cumsum([phase.angle for phase in self.phases])])

    @cached_property
    def breaks(self) -> tuple[float, ...]:
        """Angles at which the acceleration, or its rate, may jump, rad."""
        inside = [
            start + phase.angle * share
            for start, phase in zip(self.edges, self.phases, strict=False)
            if phase.law is not None
            for share in phase.law.breaks
        ]
        return tuple(sorted([*(float(x) for x in self.edges[:-1]), *map(float, inside)]))

    def of(self, theta: Array) -> Three:
        """S, dS/dθ, d²S/dθ² at cam angles from the beginning of the first phase, rad; m or rad."""
        theta = np.asarray(theta, dtype=float)
        if not self.level(len(self.phases)):
            theta = np.mod(theta + EDGE, FULL_TURN) - EDGE
        number = np.clip(np.searchsorted(self.edges - EDGE, theta, side="right") - 1, 0, len(self.phases) - 1)
        found = tuple(np.zeros(np.shape(theta)) for _ in range(3))
        for k, phase in enumerate(self.phases):
            here = number == k
            if not np.any(here):
                continue
            for whole, part in zip(found, self.of_phase(k, phase, theta[here]), strict=True):
                whole[here] = part
        return found  # type: ignore[return-value]

    def of_phase(self, k: int, phase: Phase, theta: Array) -> Three:
        if phase.law is None:
            high = self.level(k)
            return np.full_like(theta, high), np.zeros_like(theta), np.zeros_like(theta)
        t = np.clip((theta - self.edges[k]) / phase.angle, 0.0, 1.0)
        f, slope, bend = phase.law.of(t)
        h, way = self.lift, 1 if phase.kind == "rise" else -1
        start = 0.0 if way > 0 else h
        return start + way * h * f, way * h * slope / phase.angle, way * h * bend / phase.angle**2

    def within(self, k: int) -> WithinPhase:
        """The law as phase `k` has it, its ends as they are within it."""
        return WithinPhase(self.phases, self.lift, k)

    def third(self, theta: Array) -> Array:
        """d³S/dθ³, within the pieces."""
        theta = np.mod(np.asarray(theta, dtype=float) + EDGE, FULL_TURN) - EDGE
        number = np.clip(np.searchsorted(self.edges - EDGE, theta, side="right") - 1, 0, len(self.phases) - 1)
        found = np.zeros(theta.shape)
        for k, phase in enumerate(self.phases):
            if phase.law is not None:
                t = np.clip((theta - self.edges[k]) / phase.angle, 0.0, 1.0)
                way = 1 if phase.kind == "rise" else -1
                np.copyto(found, way * self.lift / phase.angle**3 * phase.law.third(t), where=number == k)
        return found

    def level(self, k: int) -> float:
        """The displacement at which phase `k` begins: that of the low or of the high position."""
        last = next((p.kind for p in reversed(self.phases[:k]) if p.kind != "dwell"), "return")
        return self.lift if last == "rise" else 0.0


@dataclass(frozen=True, eq=False)
class WithinPhase(Phases):
    """A law by phases as one of them, its `number` from 0, has it: where it ends its derivatives are still its own."""

    number: int = 0

    def of(self, theta: Array) -> Three:
        return self.of_phase(self.number, self.phases[self.number], np.asarray(theta, dtype=float))


@dataclass(frozen=True, eq=False)
class Spline:
    """The periodic cubic spline through values at ascending knots `x` (n + 1,); the last value repeats the first.

    Its second derivative is continuous. `values` may be complex. Source: de Boor, A practical guide to splines, ch. 4.
    """

    x: Array
    values: Array

    @cached_property
    def _bends(self) -> Array:
        """Second derivatives at the knots, (n + 1,)."""
        h, n = np.diff(self.x), len(self.x) - 1
        rise = np.diff(self.values) / h
        before = np.roll(h, 1)
        A = np.zeros((n, n))
        k = np.arange(n)
        A[k, k] = 2 * (before + h)
        A[k, (k - 1) % n] += before
        A[k, (k + 1) % n] += h
        bends = np.linalg.solve(A, 6 * (rise - np.roll(rise, 1)))
        return np.append(bends, bends[0])

    def of(self, at: Array) -> Three:
        """Value and first two derivatives."""
        period = self.x[-1] - self.x[0]
        at = self.x[0] + np.mod(np.asarray(at, dtype=float) - self.x[0], period)
        k = np.clip(np.searchsorted(self.x, at, side="right") - 1, 0, len(self.x) - 2)
        h = self.x[k + 1] - self.x[k]
        b = (at - self.x[k]) / h
        a = 1 - b
        low, high, y0, y1 = self._bends[k], self._bends[k + 1], self.values[k], self.values[k + 1]
        value = a * y0 + b * y1 + ((a**3 - a) * low + (b**3 - b) * high) * h * h / 6
        slope = (y1 - y0) / h + ((3 * b * b - 1) * high - (3 * a * a - 1) * low) * h / 6
        return value, slope, a * low + b * high

    def third(self, at: Array) -> Array:
        """The third derivative, one between two knots."""
        at = self.x[0] + np.mod(np.asarray(at, dtype=float) - self.x[0], self.x[-1] - self.x[0])
        k = np.clip(np.searchsorted(self.x, at, side="right") - 1, 0, len(self.x) - 2)
        return (self._bends[k + 1] - self._bends[k]) / (self.x[k + 1] - self.x[k])


@dataclass(frozen=True, eq=False)
class Tabled:
    """A follower's law through stated lifts at ascending cam angles, rad, of one turn, by a periodic spline."""

    angles: tuple[float, ...]
    lifts: tuple[float, ...]

    @cached_property
    def spline(self) -> Spline:
        x = np.array([*self.angles, self.angles[0] + FULL_TURN])
        return Spline(x, np.array([*self.lifts, self.lifts[0]]))

    def third(self, theta: Array) -> Array:
        """d³S/dθ³, one between two angles of the table."""
        return self.spline.third(theta)

    @property
    def breaks(self) -> tuple[float, ...]:
        """Its acceleration jumps nowhere; its third derivative does at every angle of the table."""
        return self.angles

    @cached_property
    def lift(self) -> float:
        """The greatest lift of the table, m or rad."""
        return max(self.lifts)

    def of(self, theta: Array) -> Three:
        return self.spline.of(theta)


Law = Phases | Tabled | ArcLaw
