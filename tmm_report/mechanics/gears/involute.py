"""The involute function inv α = tan α − α and its inverse, to a few units of the last digit.

tan α − α loses all its digits at small angles, and the inverse found from it as many; so both have a power series
there, and elsewhere the inverse is found by Halley's method in t = tan α, where the equation is nearly linear.
"""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any

SMALL = 0.5  # rad: below it the series, whose next terms are under 1e-17 of the sum
SMALL_INV = 0.0463  # inv 0.5 = 0.046302…
CHUNK = 8192  # numbers at a time: what the steps keep stays in the processor's cache
LARGEST = 1e20  # from here on α is π/2 to all digits

# tan α − α = α³ Σ TANGENT[k] α^2k; the coefficients of the tangent's own series from α³ on.
TANGENT = (
    0.3333333333333333,
    0.13333333333333333,
    0.05396825396825397,
    0.021869488536155203,
    0.008863235529902197,
    0.003592128036572481,
    0.0014558343870513183,
    0.000590027440945586,
    0.00023912911424355248,
    9.691537956929451e-05,
    3.927832388331683e-05,
    1.5918905069328964e-05,
    6.451689215655431e-06,
    2.6147711512907546e-06,
    1.0597268320104654e-06,
    4.294911078273806e-07,
)
# α = c Σ REVERTED[k] c^2k, c = (3 inv α)^(1/3): the series above reverted, as in 1 − 2/15 c² + 3/175 c⁴ − …
REVERTED = (
    1.0,
    -0.13333333333333333,
    0.017142857142857144,
    -0.0012698412698412698,
    -7.915893630179344e-05,
    3.857475857475858e-05,
    -4.003937609379786e-06,
    -4.997400358744896e-07,
    2.2322469705841372e-07,
    -2.369535194064616e-08,
    -3.7512161157990895e-09,
    1.6340619315781026e-09,
    -1.7445066621187087e-10,
)


def inv(alpha: Array) -> Array:
    """tan α − α; any shape, rad. Odd; holds for |α| < π/2."""
    alpha = np.asarray(alpha, dtype=float)
    near = np.abs(alpha) < SMALL
    if near.all():
        return _inv_small(alpha)
    found = np.tan(alpha) - alpha
    if near.any():
        found[near] = _inv_small(alpha[near])
    return found


def inverse(v: Array) -> Array:
    """α with tan α − α = v, rad, (−π/2, π/2]; any shape. Odd; nan for nan, π/2 for infinity.

    Within 4 ulp of the exact inverse of v for 1e-6 rad < |α| < 89.99°.
    """
    v = np.asarray(v, dtype=float)
    if v.size <= CHUNK:
        return _inverse(v)
    flat, found = v.ravel(), np.empty(v.size)
    for start in range(0, v.size, CHUNK):
        found[start : start + CHUNK] = _inverse(flat[start : start + CHUNK])
    return found.reshape(v.shape)


def _inverse(v: Array) -> Array:
    size = np.abs(v)
    near = size < SMALL_INV
    if near.all():
        return _inverse_small(v)
    found = np.empty(v.shape)
    found[near] = _inverse_small(size[near])
    found[~near] = _inverse_large(size[~near])
    return np.copysign(found, v)[()]


def _inv_small(alpha: Array) -> Array:
    square = alpha * alpha
    return alpha * square * _polynomial(TANGENT, square)


def _inverse_small(v: Array) -> Array:
    c = np.cbrt(3 * v)
    return c * _polynomial(REVERTED, c * c)


def _polynomial(coefficients: tuple[float, ...], x: Array) -> Array:
    if np.ndim(x) == 0:  # one number, without the cost of an array
        value, one = coefficients[-1], float(x)
        for coefficient in coefficients[-2::-1]:
            value = value * one + coefficient
        return value
    total = np.full_like(x, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        total *= x
        total += coefficient
    return total


def _inverse_large(v: Array) -> Array:
    """Three steps of Halley's method on f(t) = t − arctan t − v.

    f' = 1/(1 + u²) and f''/2f' = u³/(1 + u²) with u = 1/t, which cannot overflow.
    """
    v = np.minimum(v, LARGEST)
    t = _first_guess(v)
    for _ in range(3):
        u = 1 / t
        rise = 1 + u * u
        newton = (t - np.arctan(t) - v) * rise
        t -= newton / (1 - newton * u**3 / rise)
    return np.arctan(t)


def _first_guess(v: Array) -> Array:
    """tan α: two terms of the series in c for v < 0.7, else of t = v + π/2 − 1/t − …"""
    c, w = np.cbrt(3 * v), v + np.pi / 2
    return np.where(v < 0.7, c + c**3 / 5, w - 1 / w)
