"""The angle whose involute function is given, tan α − α = v, by the ways a user might choose.

Each takes an array of v ≥ 0 and finds α of each, rad; the size of the task is the array, not a number of positions.
The equation is flat at 0, where f' = tan²α vanishes and the difference tan α − α is left without digits, and steep
towards 90°, where the usual start lies beyond the quarter.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.gears import involute
from tmm_report.mechanics.rivals.model import Method
from tmm_report.problems import N_

Array = Any
STEPS = 50  # of an iteration at most
SETTLED = 1e-12  # rad: a step after which the next is rounding
HALVINGS = 54

InvoluteMethod = Method[Array, Array]


def own(v: Array) -> Array:
    """The program's own way: a power series below 0.5 rad, Halley's method in the tangent above it."""
    return involute.inverse(v)


def newton(v: Array) -> Array:
    """α − (tan α − α − v)/tan²α from the usual start α = ∛(3v), the first term of the series. nan where it leaves the
    quarter (0, π/2) or does not settle."""
    return _iterated(v, lambda miss, t: miss / (t * t))


def halley(v: Array) -> Array:
    """The same with the second derivative, f'' = 2 tan α (1 + tan²α): steps s/(1 − s f''/2f'), s = f/f'."""
    return _iterated(v, lambda miss, t: _halley_step(miss / (t * t), t))


def _halley_step(step: Array, t: Array) -> Array:
    return step / (1 - step * (1 + t * t) / t)


def _iterated(v: Array, step_of: Callable[[Array, Array], Array]) -> Array:
    v = np.asarray(v, dtype=float)
    with np.errstate(all="ignore"):
        alpha = np.cbrt(3 * v)
        settled = alpha == 0
        for _ in range(STEPS):
            t = np.tan(alpha)
            step = np.where(settled, 0.0, step_of(t - alpha - v, t))
            alpha = alpha - step
            settled |= np.abs(step) <= SETTLED
            if settled.all():
                break
    return np.where(settled & (alpha >= 0) & (alpha < np.pi / 2), alpha, np.nan)


def bisection(v: Array) -> Array:
    """Halving of the bracket [0, π/2]; nan for nan."""
    v = np.asarray(v, dtype=float)
    low, high = np.zeros(v.shape), np.full(v.shape, np.pi / 2)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        beyond = np.tan(middle) - middle > v
        low, high = np.where(beyond, low, middle), np.where(beyond, middle, high)
    return np.where(np.isnan(v), np.nan, (low + high) / 2)


def series(v: Array) -> Array:
    """Five terms of the reverted series, α = c − 2c³/15 + 3c⁵/175 − 2c⁷/1575 − 144c⁹/1819125, c = ∛(3v). (Cheng,
    Derivation of the explicit solution of the inverse involute function and its applications, 1992)"""
    with np.errstate(over="ignore", invalid="ignore"):
        c = np.cbrt(3 * np.asarray(v, dtype=float))
        square = c * c
        total = -144 / 1819125 * square - 2 / 1575
        total = (total * square + 3 / 175) * square - 2 / 15
        return c * (total * square + 1)


INVOLUTES: tuple[InvoluteMethod, ...] = (
    Method("series_and_halley", N_("series near 0, Halley's method in the tangent"), lambda v, count: own(v)),
    Method("newton_involute", N_("Newton's method in the angle"), lambda v, count: newton(v)),
    Method("halley_involute", N_("Halley's method in the angle"), lambda v, count: halley(v)),
    Method("bisection", N_("bisection"), lambda v, count: bisection(v)),
    Method("series", N_("five terms of the series"), lambda v, count: series(v)),
)
