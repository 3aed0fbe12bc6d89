"""What limits a pair of wheels: one list, by which a pair is judged, refused, and its blocking contour is bounded.

A limit is kept where its margin is not negative. Margins are in modules, radians or pure numbers, and smooth up to the
limit, so that lines can be traced along it. They are plain functions, so that results that keep them can be pickled.
Source: Bolotovsky, Involute gears: a reference book, part 1.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np

from tmm_report.mechanics.gears.cutting import ByCutter, ByRack, real_start
from tmm_report.mechanics.gears.meshing import Pair

Array = Any
Quality = Callable[[Pair], Array]


class Limit(NamedTuple):
    """`value` of a pair must be at least `bound`. `wheel`: 1 or 2; 0 for both.

    `hard`: beyond it there are no such wheels at all; beyond the others they can be made, and work badly.
    """

    kind: str
    wheel: int
    bound: float
    value: Quality
    hard: bool = False

    def margin(self, pair: Pair) -> Array:
        return self.value(pair) - self.bound


def limits_of(pair: Pair, thickness: float, ratio: float, sliding: float | None = None) -> tuple[Limit, ...]:
    """All limits of wheels cut and mated as those of `pair` are, whatever its shifts.

    `thickness` of the tips, modules, and contact `ratio`: the least; `sliding`: the largest specific one, None: any.
    """
    return (*_soft(pair, thickness, ratio, sliding), *_hard(pair))


def _soft(pair: Pair, thickness: float, ratio: float, sliding: float | None) -> Iterator[Limit]:
    for i in _outer(pair):
        yield Limit("undercut", i + 1, float(pair.x_min[i]), partial(_shift, i))
    for i in (0, 1):
        yield Limit("pointing", i + 1, thickness, partial(_tip, i))
    yield Limit("contact", 0, ratio, attrgetter("eps"))
    for i in _touched(pair):
        yield Limit("interference", i + 1, 0.0, partial(_interference, i))
    if pair.internal:
        yield Limit("fouling", 0, 0.0, attrgetter("fouling"))
    for i in _cut_rings(pair):
        yield Limit("trimming", i + 1, 0.0, partial(_ring_tip_in_cutting, i))
        yield Limit("cutter fouling", i + 1, 0.0, partial(_fouling_in_cutting, i))
    for i in (0, 1) if sliding is not None else ():
        yield Limit("root sliding", i + 1, 1 / (1 + (sliding or 0.0)), partial(_rolling, i))


def _hard(pair: Pair) -> Iterator[Limit]:
    yield Limit("mesh", 0, 0.0, _in_mesh, hard=True)
    for i in (0, 1):
        if isinstance(pair.cuts[i], ByCutter):
            yield Limit("cut", i + 1, 0.0, partial(_in_cutting, i), hard=True)
    for i in _rings(pair):
        yield Limit("tips", i + 1, 0.0, partial(_above_base, i), hard=True)
        yield Limit("space", i + 1, 0.0, partial(_space, i), hard=True)
    for i in (0, 1):
        yield Limit("height", i + 1, 0.0, partial(_height, i), hard=True)
        yield Limit("root", i + 1, 0.0, partial(_root, i), hard=True)
        yield Limit("thickness", i + 1, 0.0, partial(_working, i), hard=True)
        yield Limit("involute", i + 1, 0.0, partial(_left, i), hard=True)
    yield Limit("reach", 0, 0.0, attrgetter("eps"), hard=True)


def broken(limits: tuple[Limit, ...], pair: Pair, rounding: float = 0.0) -> tuple[Limit, ...]:
    """Those that a single pair breaks; a margin that has no value, too."""
    with unknown():
        return tuple(limit for limit in limits if not float(limit.margin(pair)) >= -rounding)


def unknown() -> np.errstate:
    """Far from its limits a pair has no radii or no angles; there its qualities are nan."""
    return np.errstate(divide="ignore", invalid="ignore", over="ignore")


def _outer(pair: Pair) -> tuple[int, ...]:
    """Wheels that are not rings."""
    return tuple(i for i in (0, 1) if pair.signs[i] > 0)


def _rings(pair: Pair) -> tuple[int, ...]:
    return tuple(i for i in (0, 1) if pair.signs[i] < 0)


def _touched(pair: Pair) -> tuple[int, ...]:
    """Wheels whose fillets the other's tips may touch: not a pinion that its ring's tips are cut down to clear."""
    return _rings(pair) if pair.internal and pair.trimmed else (0, 1)


def _cut_rings(pair: Pair) -> tuple[int, ...]:
    """Rings cut by a pinion cutter that is stated."""
    return _rings(pair) if pair.cutter else ()


def _shift(i: int, pair: Pair) -> Array:
    return (pair.x1, pair.x2)[i] + 0 * pair.a_w


def _tip(i: int, pair: Pair) -> Array:
    return pair.s_na[i] / pair.m


def _interference(i: int, pair: Pair) -> Array:
    return pair.interference[i] / pair.m


def _rolling(i: int, pair: Pair) -> Array:
    """1 for no sliding at all, 0 where it has no bound."""
    return 1 / (1 + np.abs(pair.root_sliding[i]))


def _ring_tip_in_cutting(i: int, pair: Pair) -> Array:
    return pair.cut_ring(i).trimming / pair.m


def _fouling_in_cutting(i: int, pair: Pair) -> Array:
    return pair.cut_ring(i).fouling


def _in_mesh(pair: Pair) -> Array:
    """1 − cos α_w: 0 where the base circles touch; −1 where there is no such pair."""
    found = 1 - np.cos(pair.alpha_w)
    return np.where(np.isfinite(found), found, -1.0)


def _in_cutting(i: int, pair: Pair) -> Array:
    """The same of a wheel and the pinion cutter that cuts it."""
    cut = pair.cuts[i]
    assert isinstance(cut, ByCutter)
    value = 1 - np.cos(cut.alpha)
    return np.where(np.isfinite(value), value, -1.0)


def _above_base(i: int, pair: Pair) -> Array:
    return (pair.d_a[i] - pair.d_b[i]) / pair.m


def _space(i: int, pair: Pair) -> Array:
    return pair.spaces[i] / pair.m


def _height(i: int, pair: Pair) -> Array:
    return pair.height[i] / pair.m


def _root(i: int, pair: Pair) -> Array:
    return pair.d_f[i] / pair.m


def _working(i: int, pair: Pair) -> Array:
    return pair.s_w[i] / pair.m


def _left(i: int, pair: Pair) -> Array:
    """Of an external wheel that a pinion cutter cuts also what a rack would leave, whose fillets are drawn."""
    own, cut = pair.involute_left[i], pair.cuts[i]
    if isinstance(cut, ByRack) or pair.internal:
        return own / pair.m
    by_rack = real_start(ByRack(cut.z, cut.m, cut.x, cut.rack))
    return np.minimum(own, pair.tops[i] - by_rack) / pair.m
