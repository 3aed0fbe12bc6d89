"""Dimensions of drawings: arrowheads, straight and angular spans, labels spread into a column; mm of paper."""

from __future__ import annotations

import cmath
from collections.abc import Sequence

from tmm_report.figures.drawing import THIN, Arc, Item, Path, line, polygon

HEAD = 2.2  # length of an arrowhead, mm


def head(tip: complex, back: complex) -> Path:
    """An arrowhead from `tip` along the vector `back`."""
    return polygon((tip, tip + back + 0.17j * back, tip + back - 0.17j * back), None, "black")


def span(one: complex, other: complex) -> list[Item]:
    """A straight dimension, its arrowheads outside where it is too short for them."""
    unit = (other - one) / abs(other - one)
    inwards = 1 if abs(other - one) > 3 * HEAD else -1
    tails = 0 if inwards > 0 else 2.5 * HEAD
    return [
        line(one - tails * unit, other + tails * unit, THIN),
        head(one, inwards * HEAD * unit),
        head(other, -inwards * HEAD * unit),
    ]


def arc_span(centre: complex, radius: float, start: float, end: float) -> list[Item]:
    """An arc from angle `start` to `end`, rad, with an arrowhead at either end, as `span` has them."""
    items: list[Item] = [Arc(centre, radius, start, end, THIN)]
    inwards = 1 if abs(end - start) * radius > 3 * HEAD else -1
    for angle, sign in ((start, 1), (end, -1)):
        tip = centre + cmath.rect(radius, angle)
        back = centre + cmath.rect(radius, angle + inwards * sign * HEAD / radius) - tip
        items.append(head(tip, back))
    return items


def spread(heights: Sequence[float], step: float) -> list[float]:
    """Ascending heights moved apart to `step` at least, each cluster about its middle."""
    clusters: list[list[float]] = []
    for y in heights:
        clusters.append([y])
        while len(clusters) > 1 and _low(clusters[-1], step) - _low(clusters[-2], step) < step * len(
            clusters[-2]
        ):
            clusters[-2:] = [clusters[-2] + clusters[-1]]
    return [_low(cluster, step) + step * k for cluster in clusters for k in range(len(cluster))]


def _low(cluster: Sequence[float], step: float) -> float:
    return sum(cluster) / len(cluster) - step * (len(cluster) - 1) / 2
