"""Roots in brackets, and differences of high order: what search over a cycle is made of. All brackets at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

Array = Any

# central difference of eighth order: f' ≈ Σ c_k (f(x + kh) − f(x − kh)) / h
DIFFERENCE = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
# the value in the middle from its neighbours, eighth order: f ≈ Σ c_k (f(x + kh) + f(x − kh))
MIDDLE = (4 / 5, -2 / 5, 4 / 35, -1 / 70)


def slope(f: Callable[[Array], Array], x: Array, step: float) -> Array:
    """Derivative of `f` at `x`, (N,), by a difference of eighth order; error about f⁽⁹⁾·step⁸/630."""
    k = np.arange(1, len(DIFFERENCE) + 1)[:, None]
    ahead, behind = (f((x + sign * k * step).ravel()).reshape(k.size, -1) for sign in (1, -1))
    return np.array(DIFFERENCE) @ (ahead - behind) / step


def bracketed(
    f: Callable[[Array], Array], low: Array, high: Array, f_low: Array, noise: float
) -> tuple[Array, Array]:
    """Roots in many brackets at once, and f there: regula falsi with Illinois' halving of a stale end.

    Stops where |f| is within `noise`, its rounding error, or the bracket is a few bits wide.
    """
    f_high, x, fx = f(high), low, f_low
    for _ in range(60):
        with np.errstate(invalid="ignore", divide="ignore"):
            step = (low * f_high - high * f_low) / (f_high - f_low)
        x = np.where((step > low) & (step < high), step, (low + high) / 2)
        fx = f(x)
        if np.all((np.abs(fx) <= noise) | (high - low < 1e-15)):
            break
        left = np.sign(fx) == np.sign(f_low)
        low, f_low = np.where(left, x, low), np.where(left, fx, f_low / 2)
        high, f_high = np.where(left, high, x), np.where(left, f_high / 2, fx)
    return x, fx
