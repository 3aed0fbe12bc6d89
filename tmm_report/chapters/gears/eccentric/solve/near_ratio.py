"""Sets of teeth near the wanted ratio: all whole numbers that keep the eccentricity and miss the ratio by little."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np

from tmm_report.chapters.gears.eccentric.given import Given
from tmm_report.chapters.gears.eccentric.solve import mistakes
from tmm_report.chapters.gears.eccentric.solve.family import Judged, judge, most_ring
from tmm_report.mechanics.gears.eccentric import mechanism as ecc
from tmm_report.mechanics.gears.pair_sizes import least_teeth
from tmm_report.records import dataclass

Array = Any

MOST = 5000  # sets that are judged: those of the smallest rings, where there are more
LISTED = 500  # sets of the results


@dataclass(frozen=True, eq=False)
class Near:
    """`judged`: sets with |z3/z1 − u| ≤ Δu u and z2 = (z3 − z1)/2 + e/m whole, best first; `ratio` (T,): z3/z1 of each;
    `deviation` (T,): from the wanted ratio, relative, signed; `ring`: the largest looked at."""

    judged: Judged
    ratio: Array
    deviation: Array
    ring: int

    @property
    def holding(self) -> int:
        """How many of the sets hold two satellites or more."""
        return int(np.count_nonzero(self.judged.held >= 2))


def near_sets(given: Given, u: Fraction, E: int, tolerance: float) -> Near:
    """Ranked: those that hold most satellites first, of these the most compact, of these the nearest to the ratio."""
    sun, ring = _pairs(float(u), E, tolerance, least_teeth(given.rack), most_ring(given, u))
    largest = (ring - sun + E) // 2
    middle = largest - E / 2
    sets = ecc.Family(
        np.zeros_like(sun), sun, ring, np.stack([largest, middle, largest - E, middle], axis=-1)
    )
    held = judge(given, u, E, sets).held
    off = ring / sun / float(u) - 1
    order = np.lexsort((np.abs(off), ring, -held))
    sets = ecc.Family(np.arange(1, len(order) + 1), *(part[order] for part in sets[1:]))
    return Near(judge(given, u, E, sets), (ring / sun)[order], off[order], int(ring.max(initial=0)))


def _pairs(u: float, E: int, tolerance: float, least: int, most: int) -> tuple[Array, Array]:
    """Teeth of sun and ring within the tolerance, by the ring's; the smallest satellite is large enough."""
    low, high = u * (1 - tolerance), u * (1 + tolerance)
    suns = np.arange(least, math.floor(most / low) + 1)
    first = np.ceil(low * suns - 1e-9).astype(int)
    last = np.minimum(np.floor(high * suns + 1e-9).astype(int), most)
    counts = np.maximum(last - first + 1, 0)
    sun = np.repeat(suns, counts)
    ring = np.repeat(first, counts) + np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    good = ((ring - sun + E) % 2 == 0) & ((ring - sun - E) // 2 >= mistakes.FEWEST)
    sun, ring = sun[good], ring[good]
    order = np.lexsort((sun, ring))[:MOST]
    return sun[order], ring[order]
