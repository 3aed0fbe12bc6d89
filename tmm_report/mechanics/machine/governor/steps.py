"""Steps in time of a few unknowns whose rates break often: the formulas of Dormand and Prince in plain numbers.

A sleeve with friction rests, leaves and turns some twenty times in a response. Formulas of many steps begin anew each
time, and what a library does around each step costs more than the rates. The order is 5; within a step the unknowns
are polynomials of the degree 4. (Dormand, Prince, J. Comput. Appl. Math. 6, 1980; Hairer, Nørsett, Wanner, Solving
ordinary differential equations I, ch. II.5–6)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.ode import Trajectory, integrate
from tmm_report.mechanics.calculus.roots import bisected

Array = Any
State = list[float]
Rates = Callable[[float, State], State]
Left = Callable[[State], dict[str, float]]  # of what may end a stretch, by names: positive while it lasts
LONGEST = 0.01  # of the end of the span: a step is not longer, so that nothing happens unseen within it
SHORTEST = 1e-12  # of it, below which a solution is given up
MOST = 50_000  # steps


class Step(NamedTuple):
    """From `t` by `h`: the unknowns at its ends and their rates k1, k3 … k7 in its stages; k2 has no weight."""

    t: float
    h: float
    y: State
    end: State
    stages: tuple[State, ...]


def follow(
    rate: Rates,
    start: State,
    span: tuple[float, float],
    left: Left,
    relative: float,
    absolute: State,
) -> Trajectory:
    """The solution of y' = rate(t, y) over the span, ended where something of what is `left` is used up (event 0);
    the error of each step is to be within `relative` of the unknowns and `absolute` (N,). Raises ArithmeticError
    where it takes too many steps, or a step too short."""
    (t, end), y, count = span, start, 1
    steps: list[Step] = []
    k = rate(t, y)
    h = _first(y, k, relative, absolute)
    while t < end and len(steps) < MOST:
        h = min(h, LONGEST * end, end - t)
        step = _step(rate, t, y, k, h)
        count += 6
        error = _error(step, relative, absolute)
        if error <= 1:
            steps.append(step)
            if min(left(step.end).values()) <= 0:
                return _trajectory(steps, _meets(step, left), 0, count)
            t, y, k = (end if h == end - t else t + h), step.end, step.stages[-1]
        h *= min(5.0, max(0.2, 0.9 * error**-0.2)) if error else 5.0
        if h < SHORTEST * end:
            break
    if t < end:
        raise ArithmeticError("the solution cannot be followed")
    return _trajectory(steps, 1.0, None, count)


def follow_stiff(
    rate: Rates, start: State, span: tuple[float, float], left: Left, relative: float, absolute: State
) -> Trajectory:
    """The same by LSODA, which needs no short steps where something dies away much more quickly than the span lasts."""

    def ends(t: float, y: Array) -> float:
        return min(left(y.tolist()).values())

    def rates(t: float, y: Array) -> State:
        return rate(t, y.tolist())

    return integrate(
        rates, np.array(start), span, events=[ends], relative=relative, absolute=np.array(absolute)
    )


def _first(y: State, k: State, relative: float, absolute: State) -> float:
    """Length of the first step by which no unknown changes by much of its tolerance's root, s."""
    fast = max(abs(r) / (a + relative * abs(u)) for u, r, a in zip(y, k, absolute, strict=True))
    return 1e3 / fast if fast else float("inf")


def _error(step: Step, relative: float, absolute: State) -> float:
    """The greatest error of an unknown, of the formulas of the order 4, by what it may be; infinite where it is no
    number."""
    found = 0.0
    for a, b, least, k, m, n, o, p, q in zip(step.y, step.end, absolute, *step.stages, strict=True):
        error = 71 / 57600 * k - 71 / 16695 * m + 71 / 1920 * n - 17253 / 339200 * o + 22 / 525 * p - q / 40
        one = abs(step.h * error) / (least + relative * max(abs(a), abs(b)))
        if not one <= found:
            found = one if one == one else float("inf")
    return found


def _step(rate: Rates, t: float, y: State, k1: State, h: float) -> Step:
    """One step of the formulas of the orders 5 and 4, the stages of which are k1 … k7."""
    k2 = rate(t + h / 5, [u + h / 5 * a for u, a in zip(y, k1, strict=True)])
    k3 = rate(t + 0.3 * h, [u + h * (0.075 * a + 0.225 * b) for u, a, b in zip(y, k1, k2, strict=True)])
    k4 = rate(
        t + 0.8 * h,
        [u + h * (44 / 45 * a - 56 / 15 * b + 32 / 9 * c) for u, a, b, c in zip(y, k1, k2, k3, strict=True)],
    )
    k5 = rate(
        t + 8 / 9 * h,
        [
            u + h * (19372 / 6561 * a - 25360 / 2187 * b + 64448 / 6561 * c - 212 / 729 * d)
            for u, a, b, c, d in zip(y, k1, k2, k3, k4, strict=True)
        ],
    )
    k6 = rate(
        t + h,
        [
            u + h * (9017 / 3168 * a - 355 / 33 * b + 46732 / 5247 * c + 49 / 176 * d - 5103 / 18656 * e)
            for u, a, b, c, d, e in zip(y, k1, k2, k3, k4, k5, strict=True)
        ],
    )
    z = [
        u + h * (35 / 384 * a + 500 / 1113 * c + 125 / 192 * d - 2187 / 6784 * e + 11 / 84 * f)
        for u, a, c, d, e, f in zip(y, k1, k3, k4, k5, k6, strict=True)
    ]
    k7 = rate(t + h, z)
    return Step(t, h, y, z, (k1, k3, k4, k5, k6, k7))


INNER = (
    -12715105075 / 11282082432, 87487479700 / 32700410799, -10690763975 / 1880347072,
    701980252875 / 199316789632, -1453857185 / 822651844, 69997945 / 29380423,
)  # fmt: skip


def _parts(steps: list[Step]) -> Array:
    """Of the polynomials over the steps, (5, steps, unknowns) (Hairer, Nørsett, Wanner, (6.19))."""
    y, z = np.array([step.y for step in steps]), np.array([step.end for step in steps])
    k = np.array([step.stages for step in steps]) * np.array([step.h for step in steps])[:, None, None]
    risen, bent = z - y, k[:, 0] - (z - y)
    return np.stack([y, risen, bent, risen - k[:, -1] - bent, np.einsum("j, sjn -> sn", INNER, k)])


def _within(parts: Array, x: Array) -> Array:
    """The unknowns at the part x of a step."""
    a, b, c, d, e = parts
    return a + x * (b + (1 - x) * (c + x * (d + (1 - x) * e)))


def _meets(step: Step, left: Left) -> float:
    """The part of the step at which nothing is left."""
    parts = _parts([step])[:, 0]
    _, found = bisected(lambda x: min(left(_within(parts, x).tolist()).values()) > 0, 0.0, 1.0)
    return found


def _trajectory(steps: list[Step], last: float, ended: int | None, count: int) -> Trajectory:
    """With the last step up to its part `last`."""
    t, h = np.array([step.t for step in steps]), np.array([step.h for step in steps])
    parts = _parts(steps)

    def at(x: Array) -> Array:
        k = np.clip(np.searchsorted(t, x, side="right") - 1, 0, len(t) - 1)
        return _within(parts[:, k], ((np.asarray(x) - t[k]) / h[k])[:, None]).T

    x = np.append(t, t[-1] + last * h[-1])
    return Trajectory(x, np.vstack([parts[0], _within(parts[:, -1], last)]).T, ended, at, count)
