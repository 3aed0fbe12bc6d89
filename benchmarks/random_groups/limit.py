"""Limits between the two ends of a step, to the rounding of long doubles."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from benchmarks.random_groups.curve import bordered, onto, tangent
from benchmarks.random_groups.equations import Equations, solved

Array = Any


@dataclass(frozen=True, eq=False)
class Bracket:
    """Steps of the arc in which the driver's angle turns back: lanes, x and tangent at the begin, the length, and the
    number of the next angle to be recorded."""

    lanes: Array
    x: Array
    t: Array
    step: Array
    record: Array

    def of(self, some: Array) -> Bracket:
        return Bracket(*(getattr(self, name)[some] for name in Bracket.__dataclass_fields__))


def together(brackets: list[Bracket]) -> Bracket:
    return Bracket(
        *(np.concatenate([getattr(b, name) for b in brackets]) for name in Bracket.__dataclass_fields__)
    )


def turning_back(eq: Equations, bracket: Bracket, turn: Array) -> tuple[Array, Array]:
    """x in the limits, (L, n) of long doubles, and the length of the step to just beyond them."""
    low, high = np.zeros(len(bracket.lanes)), bracket.step.copy()
    for _ in range(16):
        middle = (low + high) / 2
        ahead = tangent(eq.rates(point(eq, bracket, middle)), bracket.t)[:, 0] * turn > 0
        low, high = np.where(ahead, middle, low), np.where(ahead, high, middle)
    return polished(eq, point(eq, bracket, (low + high) / 2), bracket.t), high


def point(eq: Equations, bracket: Bracket, s: Array) -> Array:
    """The points of the curve a part of the step on."""
    return onto(eq, bracket.x + s[:, None] * bracket.t, bracket.x, bracket.t, s, 3)[0]


def before(eq: Equations, bracket: Bracket, turn: Array, end: Array, phi: Array) -> Array:
    """The points within the step that have the driver's angle `phi`, by halving."""
    low, high = np.zeros(len(end)), end.copy()
    for _ in range(42):
        middle = (low + high) / 2
        below = (point(eq, bracket, middle)[:, 0] - phi) * turn < 0
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    return point(eq, bracket, low)


def polished(eq: Equations, x: Array, ahead: Array) -> Array:
    """Limits to rounding of long doubles: along the curve to where its angle stands still, then back onto it."""
    exact = eq.exact()
    y, ahead = x.astype(np.longdouble), ahead.astype(np.longdouble)
    for _ in range(4):
        t = tangent(exact.rates(y), ahead)
        B, rows = bordered(exact.rates(y), t)
        right = np.concatenate([-exact.bend(y, t) / rows, np.zeros((len(y), 1))], axis=1)
        bent = solved(B, right)
        with np.errstate(all="ignore"):
            ds = -t[:, 0] / bent[:, 0]
        ds = np.where(np.abs(ds) < 1e-4, ds, 0)
        moved = y + ds[:, None] * t + (ds**2 / 2)[:, None] * bent
        y = onto(exact, moved, y, t, ds, 3)[0]
    return y


def across(eq: Equations, x: Array) -> Array:
    """|ℓᵀ ∂F/∂φ| with ℓ the direction in which the other unknowns change nothing, in limits x."""
    J = eq.rates(x)
    left = np.linalg.svd(J[:, :, 1:])[0][:, :, -1]
    return np.abs((left * J[:, :, 0]).sum(axis=1))
