"""A curve of assemblies near one of its points: tangent, curvature, how far a step is certain, points of it near by."""

from __future__ import annotations

from typing import Any

import numpy as np

from benchmarks.random_groups.equations import Equations, solved

Array = Any
LONGEST = 0.1  # step of the arc; an arc of 1 is a link turned by a radian or a shift by the longest arm
SMALL = 1e-5  # of the difference that stands for a derivative


def local(eq: Equations, x: Array, ahead: Array) -> tuple[Array, Array, Array, Array]:
    """Unit tangent on the side of `ahead`, the certified step, the curvature vector, and 1/(‖B⁻¹‖ K), at points x.

    B = [J; t] has the singular values of J, whose rows are divided by their lengths, and 1. Along the step it changes
    by B⁻¹ D²F(t, ·) a unit: as long as that is no more than a quarter, one curve alone goes on.
    """
    J = eq.rates(x)
    rows = np.sqrt((J * J).sum(axis=2))
    left, sines, right = np.linalg.svd(J / rows[..., None])
    t = right[:, -1]
    t = t * np.where((t * ahead).sum(axis=1) < 0, -1.0, 1.0)[:, None]
    inverse = (right[:, :-1].transpose(0, 2, 1) / np.maximum(sines, 1e-300)[:, None]) @ left.transpose(
        0, 2, 1
    )
    turning = (eq.rates(x + SMALL * t) - eq.rates(x - SMALL * t)) / (2 * SMALL * rows[..., None])
    change = inverse @ turning
    bent = -(change @ t[..., None])[..., 0]
    reach = np.minimum(0.25 / np.sqrt((change**2).sum(axis=(1, 2))), LONGEST)
    K = np.sqrt(((eq.bound(x) / rows) ** 2).sum(axis=1))
    return t, reach, bent, np.minimum(sines[:, -1], 1.0) / K


def tangent(J: Array, ahead: Array) -> Array:
    """Unit tangent of the curve, (L, n), on the side of `ahead`, which is not far from it; in J's precision."""
    B = np.concatenate([J, ahead[:, None]], axis=1)
    last = np.zeros_like(ahead)
    last[:, -1] = 1
    t = solved(B, last)
    return t / np.sqrt((t * t).sum(axis=1))[:, None]


def bordered(J: Array, t: Array) -> tuple[Array, Array]:
    """[J; t] with J's rows of length 1, and their lengths."""
    rows = np.sqrt((J * J).sum(axis=2))
    return np.concatenate([J / rows[..., None], t[:, None]], axis=1), rows


def onto(eq: Equations, guess: Array, x: Array, t: Array, s: Array, steps: int = 3) -> tuple[Array, Array]:
    """The point of the curve in the plane t·(y − x) = s, and the size of Newton's last step."""
    y = guess
    for _ in range(steps):
        B, rows = bordered(eq.rates(y), t)
        off = ((y - x) * t).sum(axis=1) - s
        step = solved(B, np.concatenate([eq.value(y) / rows, off[:, None]], axis=1))
        y = y - step
    return y, np.abs(step).max(axis=1)


def between(x: Array, t: Array, y: Array, u: Array, target: Array, turn: Array) -> Array:
    """The point with the angle `target` of Hermite's cubic between two points of the curve."""
    h = np.sqrt(((y - x) ** 2).sum(axis=1))[:, None]

    def at(s: Array) -> Array:
        s = s[:, None]
        return (
            (1 + 2 * s) * (1 - s) ** 2 * x + s * (1 - s) ** 2 * h * t
            + s * s * (3 - 2 * s) * y + s * s * (s - 1) * h * u
        )  # fmt: skip

    low, high = np.zeros(len(x)), np.ones(len(x))
    for _ in range(40):
        middle = (low + high) / 2
        below = (at(middle)[:, 0] - target) * turn < 0
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return at(low)


def at_angle(eq: Equations, guess: Array, phi: Array, steps: int = 5, far: float = 1e-3) -> Array:
    """x at a given driver angle, by Newton's method from near by; nan where it strays."""
    x = guess.copy()
    x[:, 0] = phi
    for _ in range(steps):
        J = eq.rates(x)[:, :, 1:]
        with np.errstate(all="ignore"):
            try:
                step = solved(J, eq.value(x))
            except np.linalg.LinAlgError:
                return np.full_like(x, np.nan)
        x[:, 1:] -= step
    astray = ~(np.abs(x - guess).max(axis=1) < far) | ~(np.abs(step).max(axis=1) < 1e-7)
    x[astray] = np.nan
    return x
