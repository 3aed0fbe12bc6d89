"""Area that two closed polygons share, and the distance between their sides. Vertices (N,) complex, counter-clockwise.

An `other` that is `opening` bounds a hole, as the inside of a ring wheel: its material lies outside. Sides are compared
in blocks by their boxes, so that wheels of some ten thousand sides take milliseconds.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

Array = Any
Boxes = tuple[Array, Array, Array, Array]  # left, bottom, right, top
BLOCK = 8  # sides in a box
BOUND = 100  # vertices of each polygon from which a first bound of their distance is found


def overlap(one: Array, other: Array, opening: bool = False) -> float:
    """Area the two materials share, in the square of the unit of the vertices; 0 where they only touch."""
    return overlap_and_clearance(one, other, opening)[0]


def clearance(one: Array, other: Array, opening: bool = False) -> float:
    """Smallest distance between the boundaries; where they overlap, less the depth of the deepest vertex."""
    return overlap_and_clearance(one, other, opening)[1]


def overlap_and_clearance(one: Array, other: Array, opening: bool = False) -> tuple[float, float]:
    """Both, from one search for the crossings."""
    boxes = _boxes(one), _boxes(other)
    crossed = _crossings(one, other, boxes)
    if not len(crossed[0]):
        shared = _nested(one, other, opening)
        return shared, _distance(one, other, boxes) * (-1 if shared else 1)
    return _overlap(one, other, crossed, opening), 0.0 - _sunk(one, other, crossed, opening)


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


def _crossings(one: Array, other: Array, boxes: tuple[Boxes, Boxes]) -> tuple[Array, Array]:
    """Where the boundaries cross, on each of them: index of the side and the part of it passed, (K,), ascending."""
    i, j = _near(one, other, boxes, 0.0)
    start, along = one[i], _next(one, i) - one[i]
    gap, across = other[j] - start, _next(other, j) - other[j]
    turn = _cross(along, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = _cross(gap, across) / turn, _cross(gap, along) / turn
    hit = (s >= 0) & (s < 1) & (t >= 0) & (t < 1)
    return np.sort((i + s)[hit]), np.sort((j + t)[hit])


def inside(points: Array, polygon: Array) -> Array:
    """Whether each of the points (K,) lies inside, by the number of sides to the right of it."""
    below = np.append(polygon, polygon[0]).imag <= points.imag[:, None]
    k, side = np.nonzero(below[:, :-1] != below[:, 1:])  # the few that a horizontal through the point meets
    low, along, point = polygon[side], _next(polygon, side) - polygon[side], points[k]
    x = low.real + (point.imag - low.imag) * along.real / along.imag
    return np.bincount(k[x > point.real], minlength=len(points)) % 2 == 1


def area(polygon: Array) -> float:
    return float(_cross(polygon, np.roll(polygon, -1)).sum() / 2)


def _nested(one: Array, other: Array, opening: bool) -> float:
    """Area shared where the boundaries do not cross."""
    if inside(one[:1], other)[0]:
        return 0.0 if opening else area(one)
    around = area(other) if inside(other[:1], one)[0] else 0.0
    return area(one) - around if opening else around


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


def _distance(one: Array, other: Array, boxes: tuple[Boxes, Boxes]) -> float:
    bound = _between_vertices(one, other)
    i, j = _near(one, other, boxes, bound)
    ends = (one[i], _next(one, i)), (other[j], _next(other, j))
    return float(
        min(
            bound,
            *(_to_side(a[0], *b).min() for a, b in ((ends[0], ends[1]), (ends[1], ends[0]))),
        )
    )


def _between_vertices(one: Array, other: Array) -> float:
    """A distance of two vertices, about the least: of some of them, then of the neighbours of the nearest two."""
    step = [max(1, len(p) // BOUND) for p in (one, other)]
    apart = _square(one[:: step[0], None] - other[None, :: step[1]])
    near = np.unravel_index(np.argmin(apart), apart.shape)
    mine, theirs = (
        p[(k * s + np.arange(-s, s + 1)) % len(p)] for p, k, s in zip((one, other), near, step, strict=True)
    )
    return float(np.sqrt(_square(mine[:, None] - theirs).min()))


def _depth(points: Array, polygon: Array) -> float:
    """How far from the boundary the deepest of the points is."""
    return float(max(_to_side(point, polygon, np.roll(polygon, -1)).min() for point in points))


def _to_side(point: Array, start: Array, end: Array) -> Array:
    along = end - start
    part = ((point - start) * along.conj()).real / np.maximum(_square(along), 1e-300)
    return np.abs(point - start - np.clip(part, 0, 1) * along)


def _square(vectors: Array) -> Array:
    """Of their lengths: several times as fast as the lengths."""
    return vectors.real**2 + vectors.imag**2


def _near(one: Array, other: Array, boxes: tuple[Boxes, Boxes], reach: float) -> tuple[Array, Array]:
    """Indices of the pairs of sides whose blocks' boxes come within `reach` of each other."""
    mine, theirs = boxes
    first, second = _meeting(mine, _around(theirs), reach), _meeting(theirs, _around(mine), reach)
    low, high = (box[:, None] for box in _taken(mine, first)), (box[None] for box in _taken(theirs, second))
    a, b = np.nonzero(_meet(tuple(low), tuple(high), reach))
    k = np.arange(BLOCK)
    i = first[a][:, None, None] * BLOCK + k[:, None] + 0 * k
    j = second[b][:, None, None] * BLOCK + k + 0 * k[:, None]
    known = (i < len(one)) & (j < len(other))
    return i[known], j[known]


def _boxes(polygon: Array) -> Boxes:
    starts = np.arange(0, len(polygon), BLOCK)

    def ends(pick: np.ufunc, x: Array) -> Array:
        """Of each block, whose last side ends where the next one starts."""
        return pick(pick.reduceat(x, starts), np.append(x[starts[1:]], x[0]))

    x, y = polygon.real.copy(), polygon.imag.copy()
    return ends(np.minimum, x), ends(np.minimum, y), ends(np.maximum, x), ends(np.maximum, y)


def _around(boxes: Boxes) -> Boxes:
    """The box of them all."""
    left, bottom, right, top = boxes
    return left.min(), bottom.min(), right.max(), top.max()


def _taken(boxes: Boxes, which: Array) -> Iterator[Array]:
    return (side[which] for side in boxes)


def _meeting(boxes: Boxes, box: Boxes, reach: float) -> Array:
    return np.nonzero(_meet(boxes, box, reach))[0]


def _meet(one: Any, other: Any, reach: float) -> Array:
    x0, y0, x1, y1 = one
    u0, v0, u1, v1 = other
    return (x0 - reach <= u1) & (u0 <= x1 + reach) & (y0 - reach <= v1) & (v0 <= y1 + reach)


def _next(polygon: Array, i: Array) -> Array:
    return polygon[(i + 1) % len(polygon)]


def _cross(a: Array, b: Array) -> Array:
    return (np.conj(a) * b).imag
