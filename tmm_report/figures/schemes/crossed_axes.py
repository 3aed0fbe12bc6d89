"""What wheels of crossing axes are drawn of: the frustum of a cone, a worm with its thread; mm of paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from tmm_report.figures.drawing import NORMAL, THICK, THIN, Item, Pen, line, polygon

THREADS = 7  # as many lines of a thread are drawn


def cone(axis: float, delta: float, outer: float, inner: float, pen: Pen) -> Iterator[Item]:
    """A frustum about the direction `axis` from the apex at 0, with the half angle `delta`; a shaft behind it."""
    ends = [cmath.rect(r, axis + side * delta) for side in (1, -1) for r in (inner, outer)]
    yield polygon([ends[0], ends[1], ends[3], ends[2]], pen)
    back = cmath.rect(outer * math.cos(delta), axis)
    yield line(back, back + cmath.rect(10, axis), THICK)


def thread(centre: complex, half: float, radius: float, right: bool) -> Iterator[Item]:
    """The worm's outline with the near side of its thread: of a right-handed one it falls to the right."""
    corner = complex(half, radius)
    corners = (-corner, corner.conjugate(), corner, -corner.conjugate())
    yield polygon([centre + one for one in corners], NORMAL)
    lean = complex(0.6 * 2 * half / THREADS / 2, -radius if right else radius)
    for k in range(THREADS):
        middle = centre + half * (2 * k + 1 - THREADS) / THREADS
        yield line(middle - lean, middle + lean, THIN)
