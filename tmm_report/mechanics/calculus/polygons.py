"""Area that two closed polygons share, and the distance between their sides. Vertices (N,) complex, counter-clockwise.

An `other` that is `opening` bounds a hole, as the inside of a ring wheel: its material lies outside. Sides are compared
in blocks by their boxes, so that wheels of some ten thousand sides take milliseconds; polygons in many places (P, N)
are compared together.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

Array = Any
Boxes = list[Array]  # left, bottom, right, top, (P, blocks) each
Pairs = tuple[Array, Array, Array]  # place, side of the one, side of the other, (K,) each, by places
Sides = tuple[Array, Array]  # starts and ends of sides, (K,) each
BLOCK = 8  # sides in a box
AT_ONCE = 500_000  # pairs of boxes that are compared at a time
SLACK = 0.01  # of the width of a polygon: how near what it may meet is looked for at first
BOUND = 50  # vertices of each chain from which a first bound of their distance is found


def overlap(one: Array, other: Array, opening: bool = False) -> float:
    """Area the two materials share, in the square of the unit of the vertices; 0 where they only touch."""
    return overlap_and_clearance(one, other, opening)[0]


def clearance(one: Array, other: Array, opening: bool = False) -> float:
    """Smallest distance between the boundaries; where they overlap, less the depth of the deepest vertex."""
    return overlap_and_clearance(one, other, opening)[1]


def overlap_and_clearance(one: Array, other: Array, opening: bool = False) -> tuple[float, float]:
    """Both, from one search for the crossings."""
    shared, apart = overlaps_and_clearances(one[None], other[None], opening)
    return float(shared[0]), float(apart[0])


def overlaps_and_clearances(one: Array, other: Array, opening: bool = False) -> tuple[Array, Array]:
    """Both, (P,), of polygons (P, N) and (P, M) in P places, from one search for the sides that are near.

    Of each boundary only the chain takes part that comes near the box of the other.
    """
    around = _around(_corners(one)), _around(_corners(other))
    reach = SLACK * float((around[0][2] - around[0][0]).max())
    mine, theirs = _chain(one, around[1], reach), _chain(other, around[0], reach)
    bound = _between_vertices(mine.places, theirs.places)
    if bound.max() > reach:
        mine, theirs = _chain(one, around[1], bound.max()), _chain(other, around[0], bound.max())
    p, i, j = _near(mine.places, theirs.places, bound)
    own, its = ((chain.places[p, k], chain.places[p, k + 1]) for chain, k in ((mine, i), (theirs, j)))
    shared, apart = _nested(one, other, opening), _distances(p, own, its, bound)
    apart[shared > 0] *= -1
    for k, crossed in _crossings(p, own, its, (mine.number[i], theirs.number[j])):
        shared[k] = _overlap(one[k], other[k], crossed, opening)
        apart[k] = 0.0 - _sunk(one[k], other[k], crossed, opening)
    return shared, apart


class Chain(NamedTuple):
    """A piece of a boundary: `places` of its vertices (P, n + 1) with n sides between them, and which they are."""

    places: Array
    number: Array


def _chain(polygon: Array, box: Boxes, reach: float) -> Chain:
    """The shortest piece that has all vertices which in any of the places come within `reach` of a box, and their
    neighbours; the whole boundary where none come or all do."""
    n = polygon.shape[1]
    near = np.nonzero(_meet(_corners(polygon), box, reach).any(axis=0))[0]
    number = np.arange(n + 1) % n
    if len(near):
        beyond = np.diff(near, append=near[0] + n)
        gap = int(np.argmax(beyond))  # the longest way round between two of them is left out
        if beyond[gap] > 2:
            number = (near[gap] + beyond[gap] - 1 + np.arange(n - beyond[gap] + 3)) % n
    return Chain(polygon[:, number], number)


def _overlap(one: Array, other: Array, crossed: tuple[Array, Array], opening: bool) -> float:
    """Area between boundaries that cross."""
    at, there = crossed
    origin = one[int(at[0])]  # close by, so that nothing is lost to rounding
    one, other = one - origin, other - origin
    sign = -1 if opening else 1
    total = sum(_fan(chain) for chain in _runs(one, at, other, not opening))
    return float(max(0.0, total + sign * sum(_fan(chain) for chain in _runs(other, there, one, True))))


def _sunk(one: Array, other: Array, crossed: tuple[Array, Array], opening: bool) -> float:
    """How deep the deepest vertex is in the other material, where the boundaries cross."""
    at, there = crossed
    sunk = [(chain[1:-1], other) for chain in _runs(one, at, other, not opening)]
    sunk += [(chain[1:-1], one) for chain in _runs(other, there, one, True)]
    return max((_depth(points, sides) for points, sides in sunk if len(points)), default=0.0)


def _crossings(
    p: Array, one: Sides, other: Sides, numbers: tuple[Array, Array]
) -> Iterator[tuple[int, tuple[Array, Array]]]:
    """Places where the boundaries cross, and where on each of them: index of the side and the part of it passed, (K,),
    ascending. Of near sides (S,) in places p, with their `numbers`."""
    start, there = one[0], other[0]
    along, across, gap = one[1] - start, other[1] - there, there - start
    turn = _cross(along, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = _cross(gap, across) / turn, _cross(gap, along) / turn
    hit = (s >= 0) & (s < 1) & (t >= 0) & (t < 1)
    p, mine, theirs = p[hit], numbers[0][hit] + s[hit], numbers[1][hit] + t[hit]
    for k in np.unique(p):
        yield int(k), (np.sort(mine[p == k]), np.sort(theirs[p == k]))


def inside(points: Array, polygon: Array) -> Array:
    """Whether each of the points (K,) lies inside the polygon (N,), or its own of (K, N), by the number of sides to the
    right of it."""
    below = polygon.imag <= points.imag[:, None]
    # the few that a horizontal through the point meets
    k, side = np.nonzero(below != np.roll(below, -1, axis=1))
    polygon, point = np.broadcast_to(polygon, below.shape), points[k]
    low = polygon[k, side]
    along = polygon[k, (side + 1) % polygon.shape[1]] - low
    x = low.real + (point.imag - low.imag) * along.real / along.imag
    return np.bincount(k[x > point.real], minlength=len(points)) % 2 == 1


def area(polygon: Array) -> float:
    return float(_cross(polygon, np.roll(polygon, -1)).sum() / 2)


def _nested(one: Array, other: Array, opening: bool) -> Array:
    """Area shared where the boundaries do not cross, (P,)."""
    within, around = inside(one[:, 0], other), inside(other[:, 0], one)
    shared = np.zeros(len(one))
    for k in np.nonzero(~within if opening else within)[0]:
        shared[k] = area(one[k])
    for k in np.nonzero(around & ~within)[0]:
        shared[k] = shared[k] - area(other[k]) if opening else area(other[k])
    return shared


def _runs(polygon: Array, at: Array, other: Array, wanted: bool) -> Iterator[Array]:
    """Chains of the boundary between crossings, those that lie inside the other (`wanted`) or outside."""
    ends = [*at, at[0] + len(polygon)]
    middles = np.array([_point(polygon, (a + b) / 2) for a, b in pairwise(ends)])
    for (a, b), within in zip(pairwise(ends), inside(middles, other), strict=True):
        if within == wanted:
            vertices = polygon[np.arange(int(a) + 1, int(np.ceil(b))) % len(polygon)]
            yield np.array([_point(polygon, a), *vertices, _point(polygon, b)])


def _point(polygon: Array, at: float) -> complex:
    k = int(at) % len(polygon)
    return complex(polygon[k] + (at - int(at)) * (polygon[(k + 1) % len(polygon)] - polygon[k]))


def _fan(chain: Array) -> float:
    """Area of the triangles from the origin to the sides of a chain."""
    return float(_cross(chain[:-1], chain[1:]).sum() / 2)


def _distances(p: Array, one: Sides, other: Sides, bound: Array) -> Array:
    """Least distances of near sides (S,) in places p, (P,), not above the bounds."""
    least = bound**2
    for point, side in ((one[0], other), (other[0], one)):
        np.minimum.at(least, p, _to_side(point, *side))
    return np.sqrt(least)


def _between_vertices(one: Array, other: Array) -> Array:
    """Of each place a distance of two vertices, about the least, (P,): of some of them, then of the neighbours of the
    nearest two."""
    places = np.arange(len(one))
    step = [max(1, p.shape[1] // BOUND) for p in (one, other)]
    apart = _square(one[:, :: step[0], None] - other[:, None, :: step[1]])
    near = np.unravel_index(np.argmin(apart.reshape(len(one), -1), axis=1), apart.shape[1:])
    mine, theirs = (
        p[places[:, None], np.clip(k[:, None] * s + np.arange(-s, s + 1), 0, p.shape[1] - 1)]
        for p, k, s in zip((one, other), near, step, strict=True)
    )
    return np.sqrt(_square(mine[:, :, None] - theirs[:, None]).min(axis=(1, 2)))


def _depth(points: Array, polygon: Array) -> float:
    """How far from the boundary the deepest of the points is."""
    deepest = max(_to_side(point, polygon, np.roll(polygon, -1)).min() for point in points)
    return float(np.sqrt(deepest))


def _to_side(point: Array, start: Array, end: Array) -> Array:
    """Squares of the distances."""
    along, to = end - start, point - start
    part = (to.real * along.real + to.imag * along.imag) / np.maximum(_square(along), 1e-300)
    return _square(to - np.clip(part, 0, 1) * along)


def _square(vectors: Array) -> Array:
    """Of their lengths: several times as fast as the lengths."""
    return vectors.real**2 + vectors.imag**2


def _near(one: Array, other: Array, reach: Array) -> Pairs:
    """The pairs of sides of chains whose blocks' boxes come within `reach` (P,) of each other."""
    mine, theirs = _boxes(one), _boxes(other)
    first, second = _meeting(mine, _around(theirs), reach), _meeting(theirs, _around(mine), reach)
    low, high = [side[:, first, None] for side in mine], [side[:, None, second] for side in theirs]
    taken = max(1, AT_ONCE // max(1, len(first) * len(second)))
    met = [
        _meet([x[own] for x in low], [x[own] for x in high], reach[own, None, None])
        for own in (slice(k, k + taken) for k in range(0, len(one), taken))
    ]
    p, a, b = np.nonzero(np.concatenate(met))
    k = np.arange(BLOCK)
    i = first[a][:, None, None] * BLOCK + k[:, None] + 0 * k
    j = second[b][:, None, None] * BLOCK + k + 0 * k[:, None]
    known = (i < one.shape[1] - 1) & (j < other.shape[1] - 1)
    return np.broadcast_to(p[:, None, None], i.shape)[known], i[known], j[known]


def _boxes(chain: Array) -> Boxes:
    """Of the blocks of a chain's sides, (P, blocks)."""
    last = chain.shape[1] - 1
    starts = np.arange(0, last, BLOCK)

    def ends(pick: np.ufunc, x: Array) -> Array:
        """Of each block, whose last side ends where the next one starts."""
        return pick(pick.reduceat(x[:, :last], starts, axis=1), x[:, np.minimum(starts + BLOCK, last)])

    x, y = chain.real.copy(), chain.imag.copy()
    return [ends(np.minimum, x), ends(np.minimum, y), ends(np.maximum, x), ends(np.maximum, y)]


def _corners(polygon: Array) -> Boxes:
    """The boxes of its vertices."""
    return [polygon.real, polygon.imag, polygon.real, polygon.imag]


def _around(boxes: Boxes) -> Boxes:
    """The box of them all, (P, 1)."""
    picked = zip((np.min, np.min, np.max, np.max), boxes, strict=True)
    return [pick(side, axis=1, keepdims=True) for pick, side in picked]


def _meeting(boxes: Boxes, box: Boxes, reach: Array) -> Array:
    """The blocks that meet a box in any place."""
    return np.nonzero(_meet(boxes, box, reach[:, None]).any(axis=0))[0]


def _meet(one: Boxes, other: Boxes, reach: Array | float) -> Array:
    """Whether boxes come within `reach` of others, which are the fewer."""
    x0, y0, x1, y1 = one
    u0, v0, u1, v1 = other
    return (x0 <= u1 + reach) & (x1 >= u0 - reach) & (y0 <= v1 + reach) & (y1 >= v0 - reach)


def _cross(a: Array, b: Array) -> Array:
    return (np.conj(a) * b).imag
