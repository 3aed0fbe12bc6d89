"""Where roots are looked for over a cycle: brackets of equal steps, finer beside singular positions, and pairs of roots
nearer than a step, which change no sign on the grid.

Values are (P,) at ascending angles; nan where there is none.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.distinct import distinct

Array = Any

LOW = 0.1  # closeness of a group below which the motion changes faster than the steps of the search
FINER = 4e-3 * 10 ** (-np.arange(14) / 2)  # rad, from a singular position: from a step of the search to 1e-9
ROUNDING = 64 * np.finfo(float).eps  # of a velocity far from singular positions, relative to the largest
SHALLOW = 0.1  # part of its rise to both sides: a dip nearer to zero than this may go through it
ROUNDS = 12  # of the search for the lowest point of a dip: parabolas double the digits in two of them


def finer(turned: Array) -> Array:
    """Angles ever nearer to each of `turned` (N,) on both sides of it, rad, (M,), ascending."""
    return distinct(turned[:, None] + np.concatenate([-FINER, FINER]))


def changes_of_sign(values: Array) -> Array:
    """Where the next value has another sign, (N,) of int; a zero on the grid itself ends its bracket."""
    signs = np.where(values == 0, 1.0, np.sign(values))
    return np.flatnonzero(signs[:-1] * signs[1:] < 0)


def certain(values: Array, closeness: Array, size: float) -> Array:
    """Where a value's sign is more than rounding, which towards a singular position grows with 1/closeness², (P,)."""
    with np.errstate(invalid="ignore", divide="ignore"):
        noise = np.where(closeness < LOW, ROUNDING * size / closeness**2, -1.0)
        return np.isfinite(values) & (np.abs(values) > noise)


def signed_brackets(values: Array, sure: Array, exists: Array) -> tuple[Array, Array]:
    """Numbers of the two ends of every bracket, (N,): neighbours among the sure values, of unlike signs, between which
    the mechanism exists."""
    at = np.flatnonzero(sure)
    if at.size < 2:
        return at[:0], at[:0]
    lost = np.cumsum(~exists)
    turns = changes_of_sign(values[at])
    low, high = at[turns], at[turns + 1]
    whole = lost[low] == lost[high]
    return low[whole], high[whole]


def dips(values: Array, least: float) -> Array:
    """Where a value (…, P) is nearest to zero among its neighbours and the parabola through the three comes to zero, or
    all but: there may be two roots between. True in the middle of the three. `least`: what is more than rounding."""
    left, middle, right = values[..., :-2], values[..., 1:-1], values[..., 2:]
    with np.errstate(invalid="ignore", divide="ignore"):
        sign = np.sign(middle)
        a, b, c = sign * left, sign * middle, sign * right
        bend, tilt = (a + c) / 2 - b, (c - a) / 2
        lowest = b - tilt**2 / (4 * bend)
        rise = np.maximum(a, c) - b
        found = (a >= b) & (c > b) & (b > 0) & (lowest < SHALLOW * rise) & (np.maximum(a, c) > least)
    inner = np.zeros(np.shape(values), dtype=bool)
    inner[..., 1:-1] = found
    return inner


def opened(
    f: Callable[[Array], Array], grid: Array, rows: Array, at: Array, real: Array
) -> tuple[Array, Array, Array, Array]:
    """Of dips at numbers `at` (…, K) of the grid, of values `rows` (3, …, K) there and beside it, both brackets that
    the lowest point opens: low and high ends and values at the low ends, (2, …, K), and where there are any, (…, K).
    What is not `real` fills up a row."""
    x, sign = np.stack([grid[at - 1], grid[at], grid[at + 1]]), np.sign(rows[1])
    middle, below = lowest(lambda new: sign * f(new), x, np.where(real, sign * rows, -1.0))
    ends = np.stack([x[0], middle]), np.stack([middle, x[2]]), np.stack([rows[0], sign * below])
    return *ends, real & (below < 0)


def lowest(f: Callable[[Array], Array], x: Array, y: Array) -> tuple[Array, Array]:
    """The lowest points of functions, (…, N), and the values there, from three points x (3, …, N) of each with values
    y > 0, the middle one lowest: by parabolas through the lowest three, until all are below zero."""
    x, y = np.array(x), np.array(y)
    for _ in range(ROUNDS):
        new = _vertex(x, y)
        value = f(new)
        keep = (y[1] < 0) | ~np.isfinite(value)
        value, new = np.where(keep, np.inf, value), np.where(keep, x[1], new)
        x, y = _three(x, y, new, value)
        if np.all(y[1] < 0):
            break
    return x[1], y[1]


def _vertex(x: Array, y: Array) -> Array:
    """The vertex of the parabola through three points; where it says nothing new the middle of the wider half."""
    left, right = x[0] - x[1], x[2] - x[1]
    p, q = (y[0] - y[1]) * right, (y[2] - y[1]) * left
    with np.errstate(invalid="ignore", divide="ignore"):
        new = x[1] + (p * right - q * left) / (2 * (p - q))
    wide = np.where(-left > right, x[1] + left / 2, x[1] + right / 2)
    near = np.minimum(np.abs(new - x).min(axis=0), np.minimum(new - x[0], x[2] - new))
    return np.where(near > 1e-3 * (x[2] - x[0]), new, wide)


def _three(x: Array, y: Array, new: Array, value: Array) -> tuple[Array, Array]:
    """The lowest of four points with its neighbours."""
    order = np.argsort(np.concatenate([x, new[None]]), axis=0, kind="stable")
    x4 = np.take_along_axis(np.concatenate([x, new[None]]), order, axis=0)
    y4 = np.take_along_axis(np.concatenate([y, value[None]]), order, axis=0)
    at = np.clip(np.argmin(y4, axis=0), 1, 2)
    pick = np.stack([at - 1, at, at + 1])
    return np.take_along_axis(x4, pick, axis=0), np.take_along_axis(y4, pick, axis=0)
