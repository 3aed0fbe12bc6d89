"""Roots in brackets, and differences of high order. The only finders of roots in one unknown:

- of one function `bisected` (of it is known whether it holds), `root_between` and `first_root` (its values), `newton`
  (its values and slopes);
- of many brackets at once `bracketed` and `interpolated`, of which search over a cycle is made.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

Array = Any
Finder = Callable[[Callable[[Array], Array], Array, Array, Array, Array], tuple[Array, Array]]
"""f, low and high ends of brackets, f at the low ends, noise -> roots and f there."""

TRIES = (
    60  # evaluations after which a bracket is left as it is: bisection alone would have come to a few bits
)
FEW_BITS = 1e-15  # width of a bracket of angles, rad
CLOSE = 1e-13  # relative, of two steps of Newton's method: the next would be the square of it

# central difference of eighth order: f' ≈ Σ c_k (f(x + kh) − f(x − kh)) / h
DIFFERENCE = (4 / 5, -1 / 5, 4 / 105, -1 / 280)


def slope(f: Callable[[Array], Array], x: Array, step: float) -> Array:
    """Derivative of `f` at `x`, (N,), by a difference of eighth order; error about f⁽⁹⁾·step⁸/630."""
    k = np.arange(1, len(DIFFERENCE) + 1)[:, None]
    ahead, behind = (f((x + sign * k * step).ravel()).reshape(k.size, -1) for sign in (1, -1))
    return np.array(DIFFERENCE) @ (ahead - behind) / step


def bisected(holds: Callable[[float], bool], low: float, high: float) -> tuple[float, float]:
    """The two neighbouring numbers between which what `holds` at `low` and not at `high` ends."""
    while low < (middle := low + (high - low) / 2) < high:
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low, high


def root_between(f: Callable[[Array], Array], low: float, high: float) -> float:
    """The root of one function of arrays, (N,) -> (N,), between two numbers at which it has unlike signs."""
    ends = np.array([low]), np.array([high])
    return float(interpolated(f, *ends, f(ends[0]), np.zeros(1))[0][0])


def first_root(f: Callable[[Array], Array], grid: Array) -> float | None:
    """The root in the first interval of an ascending grid at whose ends the function has unlike signs; what is nan has
    none. None where there is no such interval."""
    values = f(grid)
    turns = np.flatnonzero(values[:-1] * values[1:] <= 0)
    return root_between(f, grid[turns[0]], grid[turns[0] + 1]) if turns.size else None


def newton(f: Callable[[float], tuple[float, float]], low: float, high: float, start: float) -> float:
    """The root of one function, of which `f` tells the value and the slope: above zero at `low`, not at `high`, and
    looked for from `start` on. Newton's method, kept between the ends by halving."""
    x = start
    for _ in range(TRIES):
        value, slope = f(x)
        low, high = (x, high) if value > 0 else (low, x)
        step = x - value / slope if slope < 0 else (low + high) / 2
        step = step if low <= step <= high else (low + high) / 2
        if abs(step - x) <= FEW_BITS + CLOSE * abs(step):
            return step
        x = step
    return x


def bracketed(
    f: Callable[[Array], Array], low: Array, high: Array, f_low: Array, noise: float | Array
) -> tuple[Array, Array]:
    """Roots in many brackets at once, (..., N), and f there: regula falsi with Illinois' halving of a stale end.

    A row of brackets stops where |f| of all is within `noise`, its rounding error, or the bracket a few bits wide.
    """
    f_high, x, fx = f(high), low, f_low
    over = np.zeros((*np.shape(low)[:-1], 1), dtype=bool)
    for _ in range(TRIES):
        with np.errstate(invalid="ignore", divide="ignore"):
            step = (low * f_high - high * f_low) / (f_high - f_low)
        step = np.where((step > low) & (step < high), step, (low + high) / 2)
        x = np.where(over, x, step)
        fx = f(x)
        done = (np.abs(fx) <= noise) | (high - low < FEW_BITS)
        over = over | done.all(axis=-1, keepdims=True)
        if over.all():
            break
        left = np.sign(fx) == np.sign(f_low)
        low, f_low = np.where(left, x, low), np.where(left, fx, f_low / 2)
        high, f_high = np.where(left, high, x), np.where(left, f_high / 2, fx)
    return x, fx


def interpolated(
    f: Callable[[Array], Array],
    low: Array,
    high: Array,
    f_low: Array,
    noise: Array,
    narrow: float = FEW_BITS,
) -> tuple[Array, Array]:
    """Roots in many brackets at once, (..., N), and f there: inverse quadratic interpolation, guarded by bisection.

    Stops where |f| is within `noise` (a number, or one a bracket), its rounding error, or the bracket is `narrow`, as
    it comes to be about a jump. `f` is always asked for all brackets, those already done at their roots, which they
    keep.
    Source: Chandrupatla, Adv. Eng. Software 28 (1997) 145.
    """
    a, fa, b, fb = low, f_low, high, f(high)  # a: the newest point; b: the other end
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        x = (low * fb - high * fa) / (fb - fa)
        x = np.where((x > low) & (x < high), x, (low + high) / 2)
        for _ in range(TRIES):
            fx = f(x)
            same = np.sign(fx) == np.sign(fa)
            c, fc = np.where(same, a, b), np.where(same, fa, fb)
            b, fb = np.where(same, b, a), np.where(same, fb, fa)
            a, fa = x, fx
            done = (np.abs(fa) <= noise) | (np.abs(b - a) < narrow)
            if done.all():
                break
            x = np.where(done, a, a + _inside(_interpolated(a, b, c, fa, fb, fc), b - a) * (b - a))
    return a, fa


def _interpolated(a: Array, b: Array, c: Array, fa: Array, fb: Array, fc: Array) -> Array:
    """Part of the way from a to b at which the parabola x(f) through three points is 0; a half where it misleads."""
    xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
    good = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
    part = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
    return np.where(good, part, 0.5)


def _inside(part: Array, width: Array) -> Array:
    """A part of a bracket that leaves a few bits at both its ends; a half for nan."""
    least = np.minimum(FEW_BITS / 2 / np.abs(width), 0.5)
    return np.where(np.isfinite(part), np.clip(part, least, 1 - least), 0.5)
