"""Where polynomials on [-1, 1] pass through zero, many of them at once: by Newton's method, kept between brackets.

A polynomial is its values at the Gauss–Legendre points of a panel (see `panels`). It is evaluated by its Chebyshev
series, Σ c_m cos mθ with t = cos θ: exact to the rounding of a double all over, and a single step of numpy.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

Array = Any
STEPS = 60  # of the search; four or five do where a zero is simple
NEAR = 1e-15  # of t: a step no longer than that is the last
ROUNDING = 2e-16  # of the sum of a series' coefficients, what is left at a zero


@cache
def grid(order: int) -> Array:
    """The ends and the points, ascending, (n + 2,)."""
    return np.concatenate([[-1.0], np.polynomial.legendre.leggauss(order)[0], [1.0]])


@cache
def _series(order: int) -> tuple[Array, Array]:
    """Matrices from the values at the points to the coefficients of the function and of its derivative, (n, n)."""
    of = np.linalg.inv(np.polynomial.chebyshev.chebvander(grid(order)[1:-1], order - 1))
    return of, np.pad(np.polynomial.chebyshev.chebder(of), ((0, 1), (0, 0)))


def _basis(t: Array, order: int) -> Array:
    """What series are summed over at places t (S,): (S, n)."""
    return np.cos(np.arccos(t)[:, None] * np.arange(order))


def _sum(series: Array, basis: Array) -> Array:
    """Of series (S, n), each at its own place."""
    return np.einsum("ij,ij->i", basis, series)


def evaluated(values: Array, t: Array) -> Array:
    """Polynomials of values (S, n), each at its own place t (S,)."""
    order = values.shape[-1]
    return _sum(values @ _series(order)[0].T, _basis(t, order))


def zeros(values: Array, low: Array, high: Array, sign: Array) -> Array:
    """Places t (S,) of polynomials of values (S, n), each within its bracket, where it goes from the `sign` (S,) that
    it has at `low` to the other one at `high`."""
    of, slope_of = (values @ matrix.T * sign[:, None] for matrix in _series(values.shape[-1]))
    nothing = ROUNDING * np.abs(of).sum(axis=1)
    t = (low + high) / 2
    for _ in range(STEPS if t.size else 0):
        basis = _basis(t, of.shape[-1])
        value, slope = _sum(of, basis), _sum(slope_of, basis)
        above, falls = value > 0, slope < 0
        low, high = np.where(above, t, low), np.where(above, high, t)
        step = t - value / np.where(falls, slope, -np.inf)
        step = np.where(falls & (step >= low) & (step <= high), step, (low + high) / 2)
        step = np.where(np.abs(value) <= nothing, t, step)
        done = np.abs(step - t).max() < NEAR
        t = step
        if done:
            break
    return t
