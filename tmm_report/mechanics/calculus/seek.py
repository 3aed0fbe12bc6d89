"""Where a costly function of one number takes a wanted level, all over a range: its roots, the places where it only
touches the level or jumps over it, where it has no value, where it is greatest or least.

The range is mapped on 0 … 1. The function is asked for many places at once, (N,) -> (N,), and for none twice; nan is no
value. Two roots closer than a step of the grid may be missed where the function turns between them unseen.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any, Literal, NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.roots import interpolated, slope
from tmm_report.records import dataclass

Array = Any
Function = Callable[[Array], Array]

PARTS = 64  # of the grid
NARROW = 1e-13  # of the range: a bracket is left
VANISHES = 1e-10  # of the numbers about it: what is nearer to the level is at it
SHRINKS = 1e-6  # of the ends of its bracket: a root's residual does, a jump's does not
HALVED = 26  # times an interval at whose one end there is no value: 2e-10 of the range
PEAKS = 8  # places of a least distance that are looked at closer
BEST = 3  # the same where the greatest or least value is sought
STEPS = 44  # of the golden section: 1e-11 of the range
GOLDEN = (np.sqrt(5) - 1) / 2
ROUNDING = 4e-16  # of the level
STEP = 1e-3  # of the range, of a difference for a slope
SLIGHT = 1e-4  # the same where the range ends


class Root(NamedTuple):
    """`at`: its place; `value`: the function there; `touches`: the level is met and not crossed."""

    at: float
    value: float
    touches: bool = False


@dataclass(frozen=True, eq=False)
class Sought:
    """`x`, `f`: what was asked, (N,) ascending; `jumps`: where the function passes the level by a jump or a pole;
    `lost`: intervals with no value; `nearest`: the place whose value is nearest to the level."""

    x: Array
    f: Array
    roots: tuple[Root, ...]
    jumps: tuple[float, ...]
    lost: tuple[tuple[float, float], ...]
    nearest: Root


class Asked:
    """A function that is asked for each place once. `answers`: place -> value."""

    def __init__(self, f: Function):
        self._f = f
        self.answers: dict[float, float] = {}

    def __call__(self, x: Array) -> Array:
        places = np.ravel(np.asarray(x, float)).tolist()
        if fresh := [one for one in dict.fromkeys(places) if one not in self.answers]:
            found = np.asarray(self._f(np.array(fresh)), float)
            self.answers.update(zip(fresh, np.where(np.isfinite(found), found, np.nan).tolist(), strict=True))
        return np.array([self.answers[one] for one in places]).reshape(np.shape(x))

    def sampled(self) -> tuple[Array, Array]:
        """All places within the range, ascending, and the values there."""
        x = np.array(sorted(one for one in self.answers if 0 <= one <= 1))
        return x, np.array([self.answers[one] for one in x.tolist()])


def seek(f: Function, level: float, parts: int = PARTS) -> Sought:
    """All places of 0 … 1 where `f` is at the level."""
    asked = f if isinstance(f, Asked) else Asked(f)
    asked(np.linspace(0, 1, parts + 1))
    _edges(asked)
    x, values = asked.sampled()
    rest = values - level
    at = np.abs(rest) <= ROUNDING * abs(level)
    met = np.flatnonzero(_ends_of_runs(at))
    roots = [Root(float(x[k]), float(values[k]), _same_sides(rest, int(k))) for k in met]
    brackets = [(x[k], x[k + 1]) for k in np.flatnonzero(_unlike(rest, at))]
    for low, high, turned in _turns(asked, x, rest, at, level):
        value = float(asked(np.array([turned]))[0])
        if (value - level) * (float(asked(np.array([low]))[0]) - level) < 0:
            brackets += [(low, turned), (turned, high)]
        elif abs(value - level) <= VANISHES * max(abs(level), abs(value)):
            roots.append(Root(turned, value, True))
    found, jumps = _closed_in(asked, brackets, level)
    x, values = asked.sampled()
    return Sought(
        x, values, tuple(sorted([*roots, *found])), tuple(jumps), _lost(x, values), _nearest(x, values, level)
    )


def _ends_of_runs(at: Array) -> Array:
    """Of neighbouring places that all are at the level the first and the last."""
    held = np.concatenate([[False], at, [False]])
    return at & ~(held[:-2] & held[2:])


def _same_sides(rest: Array, k: int) -> bool:
    """Whether the level is not crossed at a place of the grid."""
    if not 0 < k < rest.size - 1:
        return False
    return bool(rest[k - 1] * rest[k + 1] > 0)


def _unlike(rest: Array, at: Array) -> Array:
    with np.errstate(invalid="ignore"):
        return (rest[:-1] * rest[1:] < 0) & ~at[:-1] & ~at[1:]


def _edges(asked: Asked) -> None:
    """Where the function begins and ceases to have a value, closed in by halving."""
    x, values = asked.sampled()
    sound = np.isfinite(values)
    k = np.flatnonzero(sound[:-1] != sound[1:])[: 2 * PEAKS]
    if not k.size:
        return
    within, without = np.where(sound[k], x[k], x[k + 1]), np.where(sound[k], x[k + 1], x[k])
    for _ in range(HALVED):
        middle = (within + without) / 2
        there = np.isfinite(asked(middle))
        within, without = np.where(there, middle, within), np.where(there, without, middle)


def _turns(asked: Asked, x: Array, rest: Array, at: Array, level: float) -> list[tuple[float, float, float]]:
    """Intervals in which the distance from the level is least without a change of sign, and where: of those in which it
    may come to it, by how much it changes from place to place."""
    size = np.abs(rest)
    found = []
    for k in range(1, x.size - 1):
        near = size[max(0, k - 2) : k + 3]
        if at[k - 1 : k + 2].any() or not np.isfinite(size[k - 1 : k + 2]).all():
            continue
        if not rest[k - 1] * rest[k] > 0 < rest[k] * rest[k + 1] or size[k] > min(size[k - 1], size[k + 1]):
            continue
        drop = np.nanmax(np.abs(np.diff(near)))
        if size[k] <= 1.5 * drop:
            found.append((size[k] / drop if drop else 0.0, x[k - 1], x[k + 1]))
    ends = np.array([(low, high) for _, low, high in sorted(found)[:PEAKS]]).reshape(-1, 2)
    sign = np.sign(asked(ends[:, 0]) - level)
    turned = _least(lambda t: sign * (asked(t) - level), ends[:, 0], ends[:, 1], below=0.0)
    return list(zip(ends[:, 0].tolist(), ends[:, 1].tolist(), turned.tolist(), strict=True))


def _least(f: Function, low: Array, high: Array, below: float = -np.inf) -> Array:
    """Where functions are least in intervals (N,), by the golden section; one that comes `below` a number stays there.
    No value is never the least."""
    if not low.size:
        return low

    def sound(t: Array) -> Array:
        values = f(t)
        return np.where(np.isfinite(values), values, np.inf)

    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    fa, fb = sound(a), sound(b)
    for _ in range(STEPS):
        done = (np.minimum(fa, fb) < below) | (high - low < NARROW)
        if done.all():
            break
        left = fa <= fb
        new_low, new_high = np.where(left, low, a), np.where(left, b, high)
        inner = np.where(
            left, new_high - GOLDEN * (new_high - new_low), new_low + GOLDEN * (new_high - new_low)
        )
        inner = np.where(done, np.where(left, a, b), inner)
        value = sound(inner)
        new = (
            np.where(left, inner, b),
            np.where(left, a, inner),
            np.where(left, value, fb),
            np.where(left, fa, value),
        )
        a, b, fa, fb = (np.where(done, old, one) for old, one in zip((a, b, fa, fb), new, strict=True))
        low, high = np.where(done, low, new_low), np.where(done, high, new_high)
    return np.where(fa <= fb, a, b)


def _closed_in(
    asked: Asked, brackets: list[tuple[float, float]], level: float
) -> tuple[list[Root], list[float]]:
    """Roots and jumps in brackets."""
    if not brackets:
        return [], []
    ends = np.array(brackets)
    f_low, f_high = (asked(end) - level for end in ends.T)
    noise = np.full(len(brackets), ROUNDING * abs(level))
    x, rest = interpolated(lambda t: asked(t) - level, ends[:, 0], ends[:, 1], f_low, noise, NARROW)
    both = np.abs([f_low, f_high])
    tolerance = np.maximum(VANISHES * np.maximum(both.max(axis=0), abs(level)), SHRINKS * both.min(axis=0))
    found = [
        (float(at), float(r), bool(abs(r) <= limit))
        for at, r, limit in zip(x, rest, tolerance, strict=True)
        if np.isfinite(r)
    ]
    roots = [Root(at, float(asked(np.array([at]))[0])) for at, _, good in found if good]
    return roots, sorted(at for at, _, good in found if not good)


def _lost(x: Array, values: Array) -> tuple[tuple[float, float], ...]:
    """Intervals between neighbouring places with values in which there are none."""
    sound = x[np.isfinite(values)].tolist()
    missing = x[~np.isfinite(values)]
    ends = [0.0, *sound, 1.0]
    return tuple((low, high) for low, high in pairwise(ends) if ((missing >= low) & (missing <= high)).any())


def _nearest(x: Array, values: Array, level: float) -> Root:
    k = int(np.nanargmin(np.abs(values - level)))
    return Root(float(x[k]), float(values[k]))


def best(f: Function, kind: Literal["greatest", "least"], parts: int = PARTS) -> Sought:
    """The place of 0 … 1 where `f` is greatest or least, its only root."""
    asked = f if isinstance(f, Asked) else Asked(f)
    asked(np.linspace(0, 1, parts + 1))
    _edges(asked)
    x, values = asked.sampled()
    sign = 1.0 if kind == "least" else -1.0
    size = np.where(np.isfinite(values), sign * values, np.inf)
    k = np.arange(x.size)
    before, after = size[np.maximum(k - 1, 0)], size[np.minimum(k + 1, x.size - 1)]
    turns = k[(size <= before) & (size <= after) & np.isfinite(size)]
    turns = turns[np.argsort(size[turns], kind="stable")][:BEST]
    low, high = x[np.maximum(turns - 1, 0)], x[np.minimum(turns + 1, x.size - 1)]
    _least(lambda t: sign * asked(t), low, high)
    x, values = asked.sampled()
    at = int(np.nanargmin(sign * values))
    root = Root(float(x[at]), float(values[at]))
    return Sought(x, values, (root,), (), _lost(x, values), root)


def slopes(f: Function, x: Array) -> Array:
    """Derivatives at places (N,) of 0 … 1 by a difference of eighth order; where the range ends or there are no values
    about, by one of second order to the side that there is; nan where there is neither."""
    asked = f if isinstance(f, Asked) else Asked(f)
    x = np.asarray(x, float)
    inside = (x >= 4 * STEP) & (x <= 1 - 4 * STEP)
    found = np.full(x.shape, np.nan)
    if inside.any():
        found[inside] = slope(asked, x[inside], STEP)
    for side in (1.0, -1.0):
        rest = np.isnan(found) & (x + 2 * side * SLIGHT >= 0) & (x + 2 * side * SLIGHT <= 1)
        if rest.any():
            h, at = side * SLIGHT, x[rest]
            found[rest] = (4 * asked(at + h) - asked(at + 2 * h) - 3 * asked(at)) / (2 * h)
    return found
