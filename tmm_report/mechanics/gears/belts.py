"""Belts about two pulleys: angle of a strand, length, distance of the centres; rows of preferred numbers.

A strand makes the angle θ with the line of centres, sin θ = (d2 − d1)/(2a), of a crossed belt (d1 + d2)/(2a); positive
where the strands go apart towards the driven pulley. Source: Artobolevsky, Theory of mechanisms and machines, ch. VII.
"""

from __future__ import annotations

import math

R20 = (
    1.0,
    1.12,
    1.25,
    1.4,
    1.6,
    1.8,
    2.0,
    2.24,
    2.5,
    2.8,
    3.15,
    3.55,
    4.0,
    4.5,
    5.0,
    5.6,
    6.3,
    7.1,
    8.0,
    9.0,
)


def preferred(size: float) -> float:
    """The number of the row R 20 (ISO 3) that is nearest to a size > 0, by their difference; the lesser of two."""
    decade = 10.0 ** math.floor(math.log10(size))
    row = [one * scale for scale in (decade / 10, decade, decade * 10) for one in R20]
    return float(f"{min(row, key=lambda one: (abs(one - size), one)):.6g}")


def length(one: float, other: float, distance: float, crossed: bool) -> float:
    """Of the belt about pulleys of the diameters `one`, `other`, m: two strands and both arcs; nan where there are no
    such strands."""
    reach = one + other if crossed else other - one
    sine = reach / (2 * distance)
    if abs(sine) > 1:
        return math.nan
    theta = math.asin(sine)
    arcs = (one + other) * (math.pi / 2 + theta) if crossed else (one + other) * math.pi / 2 + theta * reach
    return 2 * distance * math.cos(theta) + arcs


def distance(one: float, other: float, belt: float, crossed: bool) -> float:
    """Of the centres, m, for a belt of length `belt`, m, which grows with it; nan for one so short that the pulleys
    would meet."""
    low = (one + other) / 2
    if length(one, other, low, crossed) >= belt:
        return math.nan
    high = belt / 2 + low
    for _ in range(200):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        low, high = (middle, high) if length(one, other, middle, crossed) < belt else (low, middle)
    return (low + high) / 2
