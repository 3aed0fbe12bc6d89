"""The spring that keeps a follower on its cam: F = F₀ + cS, and the speed at which a given one does not.

At every angle F₀ + cS ≥ D, D = K(−mω²S'') − P: the inertia that lifts the follower off, with a reserve K, less what
holds it down without the spring. These are straight lines of the plane of F₀ and c, F₀ ≥ 0 and c ≥ 0 two more: a linear
programme of two variables, whose bounds are the points (S, D) of a loop above which the spring's line lies.

    preload of a rate c       F₀ = max(D − cS)
    rate of a preload F₀      c = max((D − F₀)/S)
    of a ratio κ = F₀/F_h     F_h = max(D/(κ + (1 − κ)S/h)),  F_h = F₀ + ch the greatest force
    smallest                  F_h = max D, and of all lines through it the steepest: c = min((F_h − D)/(h − S), F_h/h)

All are greatest ratios of two functions, found by Dinkelbach's method: λ = max(a/b) is where max(a − λb) = 0. The same
finds the speed of lifting off, ω² = min(P + F)/(m(−S'')).

Source: Levitsky, Cam mechanisms, ch. 5; Dinkelbach, Management Science 13 (1967).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.panels import Panels

Array = Any
TRIES = 60
NEAR = 1e-14  # of λ: a step of Dinkelbach's method by less ends it
NO_BASE = 1e-9  # of the largest: a denominator below it is none


class Reached(NamedTuple):
    """A greatest value and where, as an angle turned, rad."""

    value: float
    at: float


class Held(NamedTuple):
    """A spring that just keeps the follower on its cam. `preload`: F₀, N or N m; `rate`: c, N/m or N m/rad; `greatest`:
    F₀ + ch; `at`: where its line touches the loop, rad turned."""

    preload: float
    rate: float
    greatest: float
    at: float


def preload(panels: Panels, D: Array, S: Array, rate: float) -> Reached:
    """The least F₀ of a stated rate; none is below 0. `D`, `S`: on the panels, (K, n)."""
    value, at = panels.extremes(D - rate * S)[1]
    return Reached(max(value, 0.0), at)


def rate(panels: Panels, D: Array, S: Array, stated: float) -> Reached | None:
    """The least c of a stated preload; None where no rate is enough: it is lifted off where the spring is not drawn."""
    return largest_ratio(panels, D - stated, S)


def of_ratio(panels: Panels, D: Array, S: Array, lift: float, ratio: float) -> Reached | None:
    """The least greatest force of a stated F₀/F_h; None of a ratio 0 that no rate meets."""
    return largest_ratio(panels, D, ratio + (1 - ratio) * S / lift)


def smallest(panels: Panels, D: Array, S: Array, lift: float) -> Held:
    """The spring of the least greatest force and, of those, of the least preload."""
    most, at = panels.extremes(D)[1]
    if most <= 0:
        return Held(0.0, 0.0, 0.0, at)
    flattest = largest_ratio(panels, lift - S, most - D, least=lift / most)
    if flattest is None:  # most is asked below the greatest lift: any rate would ask for more there
        return Held(most, 0.0, most, at)
    return Held(most - lift / flattest.value, 1 / flattest.value, most, flattest.at)


def lifts_off(panels: Panels, holds: Array, mass: float, bend: Array) -> Reached | None:
    """The least angular velocity, rad/s, at which a follower leaves its cam. `holds`: what presses it to the cam at
    rest, N or N m, (K, n); `bend`: S''. 0 where it does not rest on it anyway; None where it leaves it at no speed."""
    least, at = panels.extremes(holds)[0]
    if least < 0:
        return Reached(0.0, at)
    found = largest_ratio(panels, -mass * bend, holds)
    if found is None:
        return Reached(0.0, at)
    return None if found.value <= 0 else Reached(1 / math.sqrt(found.value), found.at)


def largest_ratio(panels: Panels, top: Array, bottom: Array, least: float = 0.0) -> Reached | None:
    """max(top/bottom) over the turn, of a bottom that is nowhere below zero, not less than `least`; None where it grows
    without bound."""
    y, x, base = top.ravel(), panels.x.ravel(), bottom.ravel()
    based = base > NO_BASE * np.max(np.abs(base), initial=0.0)
    if not based.any():
        return None
    k = int(np.argmax(np.where(based, y / np.where(based, base, 1.0), -np.inf)))
    found, at = float(y[k] / base[k]), float(x[k])
    if found < least:
        found = least
    for _ in range(TRIES):
        lacking = top - found * bottom
        rest, place = panels.extremes(lacking)[1]
        under = _beneath(panels, lacking, bottom, place)
        if rest <= NEAR * (abs(found) * np.max(np.abs(base)) + np.max(np.abs(y))):
            return Reached(found, at)
        if under <= NO_BASE * np.max(np.abs(base)):
            return None
        found, at = found + rest / under, place
    return Reached(found, at)


def _beneath(panels: Panels, lacking: Array, bottom: Array, place: float) -> float:
    """The bottom where something lacks most; at an edge of the panels of the side that lacks more."""
    k = int(np.searchsorted(panels.edges, place))
    if panels.edges[k] != place:
        return float(panels.at(bottom, np.array([place]))[0])
    last = panels.shape[0]
    left, right = (k - 1) % last, k % last
    sides = [(ends[left, 1], ends[right, 0]) for ends in (panels.ends(lacking), panels.ends(bottom))]
    return float(sides[1][0] if sides[0][0] >= sides[0][1] else sides[1][1])
