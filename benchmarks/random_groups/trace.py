"""The curve of assemblies through position 0, followed by its arc in certified steps, a lane each mechanism.

The driver's angle is one of the unknowns, so that the curve is as smooth in a limit position as anywhere. A step is so
short that by the theorem of Newton and Kantorovich one point alone of the curve lies in its plane near the prediction:
with t the tangent and B = [J; t], a step along which B changes by no more than a quarter of itself leaves no other
curve to slip to. A limit is where the angle
turns back; it is refined in long doubles.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from benchmarks.random_groups.curve import at_angle, between, local, onto
from benchmarks.random_groups.equations import Equations
from benchmarks.random_groups.limit import Bracket, across, before, together, turning_back

Array = Any
LEAST = 2e-8  # a step this short means that another curve crosses, or comes as near as rounding tells
OVER = 3e-3  # how far a crossing is passed straight on
MOST = 60_000  # steps of a run
TURN = 2 * np.pi


@dataclass(frozen=True, eq=False)
class Run:
    """What a run in one sense found, L lanes. Angles turned from position 0 are positive in that sense, rad."""

    limit: Array  # (L,): where the first limit is met; inf where a full turn was made without one
    at: Array  # (L, n): x in the limit, nan
    across: (
        Array  # (L,): part of the equations' change with the angle that nothing can make up for in the limit
    )
    path: Array  # (L, count + 1, n): x at equal steps of the angle, nan beyond the limit
    crossed: Array  # (L,): angle turned of the last crossing that was passed straight on, nan
    lost: Array  # (L,) bool: the curve could not be followed
    nearest: Array  # (L,): shortest certified step


@dataclass(eq=False)
class _Front:
    """The lanes still running, at their last points."""

    lanes: Array
    x: Array
    t: Array
    bent: Array
    reach: Array  # the certified step
    ball: Array  # within a quarter of it one point alone of the curve lies in a plane across
    forced: Array  # a step that ends where the angle's rate is least, nan
    shrink: Array
    record: Array  # number of the next angle to be recorded

    def of(self, some: Array) -> _Front:
        return _Front(*(getattr(self, name)[some] for name in self.__dataclass_fields__))


@dataclass(frozen=True, eq=False)
class _Chase:
    """What is asked of all lanes, and what has been found."""

    equations: Equations
    start: Array
    sense: Array
    count: int
    span: float
    run: Run
    brackets: list[Bracket] = field(default_factory=list)

    def turned(self, lanes: Array, x: Array) -> Array:
        return (x[:, 0] - self.start[lanes, 0]) * self.sense[lanes]

    def recorded(self, lanes: Array, number: Array) -> Array:
        """Driver angles of numbered records."""
        return self.start[lanes, 0] + self.sense[lanes] * number * (self.span / self.count)


def trace(equations: Equations, x: Array, sense: Array, count: int = 360, span: float = TURN) -> Run:
    """Follow every lane from x (L, n) in its `sense` (L,) of ±1 to its first limit or through the `span`, rad."""
    chase = _Chase(equations, x, sense, count, span, _nothing(len(x), x.shape[1], count))
    chase.run.path[:, 0] = x
    front, eq = _front(chase), equations
    for _ in range(MOST):
        if not front.lanes.size:
            break
        keep = _advance(chase, eq, front)
        if not keep.all():
            front = front.of(keep)
            eq = equations.of(front.lanes)
    chase.run.lost[front.lanes] = True
    _refine(chase)
    return chase.run


def _nothing(lanes: int, n: int, count: int) -> Run:
    """A run of which nothing is found yet."""
    lost, nearest = np.zeros(lanes, bool), np.full(lanes, np.inf)
    at, path = np.full((lanes, n), np.nan), np.full((lanes, count + 1, n), np.nan)
    return Run(
        np.full(lanes, np.inf), at, np.full(lanes, np.nan), path, np.full(lanes, np.nan), lost, nearest
    )


def _front(chase: _Chase) -> _Front:
    x, sense, count = chase.start, chase.sense, len(chase.start)
    ahead = np.zeros_like(x)
    ahead[:, 0] = sense
    t, reach, bent, ball = local(chase.equations, x, ahead)
    t = t * np.where(t[:, 0] * sense < 0, -1.0, 1.0)[:, None]
    free, first = np.full(count, np.nan), np.ones(count, int)
    return _Front(np.arange(count), x.copy(), t, bent, reach, ball, free, np.ones(count), first)


def _advance(chase: _Chase, eq: Equations, f: _Front) -> Array:
    """One step of all lanes; which of them go on."""
    lanes, turn, run = f.lanes, chase.sense[f.lanes], chase.run
    run.nearest[lanes] = np.minimum(run.nearest[lanes], f.reach)
    stuck = (f.reach < LEAST) | (f.shrink * f.ball < LEAST)
    step = np.where(stuck, OVER, np.where(np.isnan(f.forced), f.reach * f.shrink, f.forced))
    bent = np.where(stuck[:, None], 0.0, f.bent)
    guess = f.x + step[:, None] * f.t + (step**2 / 2)[:, None] * bent
    y, last = onto(eq, guess, f.x, f.t, step, 4)
    t, reach, bent, ball = local(eq, y, f.t)
    good = _arrived(f, y, t, guess, last, step, stuck)
    first, second = f.t[:, 0] * turn, t[:, 0] * turn
    dip, where = _dip(first, second, f.bent[:, 0] * turn, bent[:, 0] * turn, step)
    dip &= good & ~stuck & (second > 0) & (step > 1e-7)
    f.forced = np.where(dip, where, np.nan)
    f.shrink = np.where(good, np.minimum(1.0, 2 * f.shrink), f.shrink / 4)
    failed = (f.shrink < 1e-7) | (stuck & ~good)
    run.lost[lanes[failed]] = True
    back = good & ~dip & (second <= 0)
    on = good & ~dip & ~back
    run.crossed[lanes[on & stuck]] = chase.turned(lanes, f.x)[on & stuck]
    if back.any():
        chase.brackets.append(Bracket(lanes[back], f.x[back], f.t[back], step[back], f.record[back]))
    done = _record(chase, eq, f, on, y, t)
    for name, new in (("x", y), ("t", t), ("bent", bent), ("reach", reach), ("ball", ball)):
        old = getattr(f, name)
        setattr(f, name, np.where(on[:, None] if old.ndim == 2 else on, new, old))
    return ~(failed | back | done)


def _arrived(f: _Front, y: Array, t: Array, guess: Array, last: Array, step: Array, stuck: Array) -> Array:
    """Whether Newton's method has settled, where it was to; over a crossing, straight on."""
    rounding = np.minimum(np.maximum(1e-12, 1e-15 / f.ball), 0.1 * f.ball)
    off = np.abs(y - guess).max(axis=1)
    straight = (off < 20 * step**2) & ((t * f.t).sum(axis=1) > 1 - 50 * step**2) & (last < 1e-9)
    return np.where(stuck, straight, (last < rounding) & (off < 0.25 * f.ball))


def _dip(a: Array, b: Array, da: Array, db: Array, h: Array) -> tuple[Array, Array]:
    """Whether a cubic with values a, b and slopes da, db at 0 and h dips well below its ends, and where it is least."""
    c2, c3 = 3 * (b - a) / h**2 - (2 * da + db) / h, 2 * (a - b) / h**3 + (da + db) / h**2
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.sqrt(np.maximum(c2**2 - 3 * c3 * da, 0))
        where = -da / (c2 + root)  # the root of da + 2 c2 s + 3 c3 s² with a rising slope
        least = a + da * where + c2 * where**2 + c3 * where**3
    inside = (da < 0) & (db > 0) & (where > 1e-3 * h) & (where < 0.999 * h)
    return inside & (least < 0.5 * np.minimum(a, b)), where


def _record(chase: _Chase, eq: Equations, f: _Front, on: Array, y: Array, t: Array) -> Array:
    """Put down x at the angles that the step passed; whether the turn is full."""
    lanes, sense = f.lanes, chase.sense[f.lanes]
    end, step = chase.turned(lanes, y), chase.span / chase.count
    while (passed := on & (f.record <= chase.count) & (f.record * step <= end)).any():
        which = np.flatnonzero(passed)
        phi = chase.recorded(lanes[which], f.record[which])
        guess = between(f.x[which], f.t[which], y[which], t[which], phi, sense[which])
        chase.run.path[lanes[which], f.record[which]] = at_angle(eq.of(which), guess, phi)
        f.record[which] += 1
    return f.record > chase.count


def _refine(chase: _Chase) -> None:
    """The limits, and the angles recorded before them within their last steps."""
    if not chase.brackets:
        return
    every, run = together(chase.brackets), chase.run
    lanes, eq, turn = every.lanes, chase.equations.of(every.lanes), chase.sense[every.lanes]
    exact, high = turning_back(eq, every, turn)
    limit = ((exact[:, 0] - chase.start[lanes, 0].astype(np.longdouble)) * turn).astype(float)
    run.limit[lanes], run.at[lanes] = limit, exact.astype(float)
    run.across[lanes] = across(eq, run.at[lanes])
    record = every.record.copy()
    while (left := (record <= chase.count) & (record * (chase.span / chase.count) < limit)).any():
        at = np.flatnonzero(left)
        phi = chase.recorded(lanes[at], record[at])
        run.path[lanes[at], record[at]] = before(eq.of(at), every.of(at), turn[at], high[at], phi)
        record[at] += 1
