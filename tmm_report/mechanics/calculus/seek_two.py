"""Where two costly functions of two numbers both take wanted levels, all over a rectangle.

The rectangle is mapped on 0 … 1 along either side. The functions are asked for many places at once, (N, 2) -> (N, 2),
and for none twice; nan is no value. A grid tells which of its cells may hold a root: neither function keeps its sign
there by more than it bends. From each such cell Newton's method goes on, with differences for its first matrix and
Broyden's corrections after. Roots that lie in one cell may be taken for one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from tmm_report.records import dataclass

Array = Any
Function = Callable[[Array], Array]
Pair = tuple[float, float]

PARTS = 16  # of the grid along either side
STARTS = 40  # cells from which a root is sought, at most
STEP = 1e-3  # of the rectangle, of a difference for a slope
REACH = 0.3  # of the rectangle: longest step
BEYOND = 0.6  # of a cell: so far beyond it what is straight may lead
BENT = 0.3  # of its slope: a cell that bends by more is entered from its quarters too
TRIES = 30  # steps of Newton's method
HALVED = 6  # times a step that leads away
SAME = 1e-7  # of the rectangle: two roots nearer than this are one
VANISHES = 1e-10  # of the sizes: what is nearer to the levels is at them
NARROW = 1e-14  # of the rectangle: a step that is none
ROUNDS = 50  # of the search of the nearest place, eight places each
FINEST = 1e-7  # of the rectangle, of the search of the nearest place
AROUND = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j], float)
CORNERS = np.array([(0, 0), (1, 0), (0, 1), (1, 1)])


class Root(NamedTuple):
    """`at`: its place; `value`: the functions there."""

    at: Pair
    value: Pair


@dataclass(frozen=True, eq=False)
class Sought:
    """`x`, `f`: the grid, (P + 1, P + 1, 2): places, by both numbers, and values; `nearest`: the place whose values are
    nearest to the levels."""

    x: Array
    f: Array
    roots: tuple[Root, ...]
    nearest: Root


class Asked:
    """Functions that are asked for each place once. `answers`: place -> values."""

    def __init__(self, f: Function):
        self._f = f
        self.answers: dict[Pair, Pair] = {}

    def __call__(self, x: Array) -> Array:
        places = [(float(a), float(b)) for a, b in np.reshape(x, (-1, 2))]
        if fresh := [one for one in dict.fromkeys(places) if one not in self.answers]:
            found = np.asarray(self._f(np.array(fresh)), float)
            sound = np.isfinite(found).all(axis=1, keepdims=True)
            self.answers.update(zip(fresh, map(tuple, np.where(sound, found, np.nan).tolist()), strict=True))
        return np.array([self.answers[one] for one in places]).reshape(np.shape(x))


def seek(f: Function, levels: Pair, parts: int = PARTS) -> Sought:
    """All places of the rectangle where the functions are at the levels, as far as the grid parts them."""
    asked = f if isinstance(f, Asked) else Asked(f)
    line = np.linspace(0, 1, parts + 1)
    x = np.stack(np.meshgrid(line, line, indexing="ij"), axis=-1)
    values = asked(x)
    size = sizes(values, levels)

    def rest(place: Array) -> Array:
        return (asked(place) - np.array(levels)) / size

    roots: list[Root] = []
    for start, bent in _starts((values - np.array(levels)) / size):
        known = [float(np.abs(start - np.array(root.at)).max()) for root in roots]
        if not bent and min(known, default=1.0) < 0.3 / parts:
            continue
        at = _closed_in(rest, start)
        if at is not None and all(np.abs(at - np.array(root.at)).max() > SAME for root in roots):
            roots.append(_root(asked, at))
    nearest = _nearest(asked, rest, x, roots)
    return Sought(x, values, tuple(sorted(roots, key=_in_order)), nearest)


def sizes(values: Array, levels: Pair) -> Array:
    """By what the distance from each level is measured: the level, or the greatest value where that is nought."""
    greatest = np.nanmax(np.abs(values.reshape(-1, 2)), axis=0)
    return np.where(np.array(levels) != 0, np.abs(levels), np.where(greatest > 0, greatest, 1.0))


def _in_order(root: Root) -> Pair:
    """By the first number, then by the second; rounding parts no two."""
    return (round(root.at[0] / SAME) * SAME, root.at[1])


def _root(asked: Asked, at: Array) -> Root:
    a, b = asked(at)
    return Root((float(at[0]), float(at[1])), (float(a), float(b)))


# --- cells that may hold a root


def _starts(rest: Array) -> Iterator[tuple[Array, bool]]:
    """Where Newton's method begins, the likeliest first; whether the cell is bent."""
    parts = len(rest) - 1
    bends = _bends(rest)
    found: list[tuple[float, Array, bool]] = []
    for i, j in np.ndindex(parts, parts):
        corners = rest[i : i + 2, j : j + 2].transpose(1, 0, 2).reshape(4, 2)  # in the order of CORNERS
        sound = np.isfinite(corners[:, 0])
        if sound.sum() < 3:
            continue
        spare = np.sort(bends[i : i + 2, j : j + 2].reshape(4, 2), axis=0)[
            1
        ]  # a pole beside bends one corner or two
        low, high = corners[sound].min(axis=0), corners[sound].max(axis=0)
        if (low > spare).any() or (high < -spare).any():
            continue
        flat, *_ = np.linalg.lstsq(np.c_[np.ones(sound.sum()), CORNERS[sound]], corners[sound], rcond=None)
        bent = bool((spare > BENT * np.abs(flat[1:]).max(axis=0)).any())
        place = np.linalg.lstsq(flat[1:].T, -flat[0], rcond=None)[0]
        away = float(np.maximum(-place, place - 1).max())
        if away <= BEYOND:
            found.append((max(away, 0.0), (np.clip(place, 0, 1) + np.array([i, j])) / parts, bent))
        if bent:
            quarters = (np.array([0.25, 0.75])[CORNERS] + np.array([i, j])) / parts
            found += [(BEYOND, quarter, True) for quarter in quarters]
    found.sort(key=lambda one: one[0])
    yield from ((place, bent) for _, place, bent in found[:STARTS])


def _bends(rest: Array) -> Array:
    """By how much the functions may leave their chords beside each place of the grid."""
    along = np.zeros_like(rest)
    across = np.zeros_like(rest)
    along[1:-1] = np.abs(rest[2:] - 2 * rest[1:-1] + rest[:-2])
    across[:, 1:-1] = np.abs(rest[:, 2:] - 2 * rest[:, 1:-1] + rest[:, :-2])
    along[[0, -1]], across[:, [0, -1]] = along[[1, -2]], across[:, [1, -2]]
    return np.nan_to_num(along + across) / 4


# --- from a cell to its root


def _closed_in(rest: Function, start: Array) -> Array | None:
    """The root to which Newton's method comes; None where it comes to none within the rectangle."""
    x, r = start, rest(start)
    if not np.isfinite(r).all():
        return None
    matrix, fresh = slopes(rest, x), True
    for _ in range(TRIES):
        if not r.any():
            break
        if not np.isfinite(matrix).all():
            return None
        step = np.linalg.lstsq(matrix, -r, rcond=1e-14)[0]
        step = step * min(1.0, REACH / max(float(np.abs(step).max()), 1e-300))
        ahead, there = _better(rest, x, r, step)
        moved = ahead - x
        slow = np.abs(there).max() > 0.3 * np.abs(r).max()
        if not moved.any() or np.abs(moved).max() < NARROW:
            if fresh:
                break
            matrix, fresh = slopes(rest, x), True
            continue
        fresh = False
        matrix = matrix + np.outer(there - r - matrix @ moved, moved) / (moved @ moved)
        x, r = ahead, there
        if slow:
            matrix, fresh = slopes(rest, x), True
    return x if np.abs(r).max() <= VANISHES else None


def _better(rest: Function, x: Array, r: Array, step: Array) -> tuple[Array, Array]:
    """A place along the step that is nearer to the root, and what is left there; where there is none, the same."""
    for _ in range(HALVED):
        ahead = np.clip(x + step, 0, 1)
        there = rest(ahead)
        if np.isfinite(there).all() and there @ there < r @ r:
            return ahead, there
        step = step / 2
    return x, r


def slopes(f: Function, x: Array) -> Array:
    """Derivatives at a place, [function, number], by a difference of fourth order; at an edge, or where there are no
    values beside, of second order to the side that there is; nan where there is neither."""
    return np.stack([_slope(f, x, np.eye(2)[k]) for k in (0, 1)], axis=-1)


def _slope(f: Function, x: Array, along: Array) -> Array:
    at = float(x @ along)
    if 2 * STEP <= at <= 1 - 2 * STEP:
        a, b, c, d = f(x + np.outer((-2, -1, 1, 2), along) * STEP)
        if np.isfinite(found := (a - 8 * b + 8 * c - d) / (12 * STEP)).all():
            return found
    for h in (STEP / 10, -STEP / 10):
        if 0 <= at + 2 * h <= 1:
            a, b = f(x + np.outer((1, 2), along) * h)
            if np.isfinite(found := (4 * a - b - 3 * f(x)) / (2 * h)).all():
                return found
    return np.full(2, np.nan)


# --- how near it comes


def _nearest(asked: Asked, rest: Function, x: Array, roots: list[Root]) -> Root:
    """The first root; where there is none, the place of least distance, by steps to all sides that grow shorter."""
    if roots:
        return min(roots, key=_in_order)
    places = np.array(list(asked.answers))
    at = places[int(np.nanargmin(_away(rest(places))))]
    step = float(x[1, 0, 0] - x[0, 0, 0]) / 2
    for _ in range(ROUNDS):
        if step <= FINEST:
            break
        about = np.clip(at + step * AROUND, 0, 1)
        distances = _away(rest(about))
        k = int(np.argmin(distances))
        if distances[k] < _away(rest(at)):
            at = about[k]
        else:
            step /= 2
    return _root(asked, at)


def _away(rest: Array) -> Array:
    size = np.linalg.norm(rest, axis=-1)
    return np.where(np.isfinite(size), size, np.inf)
