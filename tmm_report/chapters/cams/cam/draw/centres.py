"""Where the axis of a cam may stand under a swinging roller, as it is constructed: the follower's arm in its positions,
lψ′ laid off along it from the roller's centre, through the end lines at the permitted pressure angles to the
perpendicular; the zone between all of them, and in it the axis."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from math import tan

import numpy as np

from tmm_report.chapters.cams.cam.draw.profile import finest
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.chapters.cams.cam.solve.lifting import side_of
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Drawing,
    Item,
    Pen,
    Tag,
    dot,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Symbol, symbol
from tmm_report.figures.primitives import Circle
from tmm_report.figures.schemes import marks
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.sizes.centres import Way, zone
from tmm_report.mechanics.cams.sizes.least_size import Lever

RAY, LAID, ARM = Pen(0.13, "blue"), Pen(0.35, "blue"), Pen(0.18, "grey")
FINE = 721
MARGIN = 0.5  # of the arm: how far beyond all that matters the zone is drawn


def scale(found: CamFound, lever: Lever) -> float:
    """At which the construction fits a page, m/mm."""
    return finest(2 * lever.arm, partial(_items, found, lever))


def drawing(found: CamFound, lever: Lever, mu: float) -> Drawing:
    """At the scale of `mu` m/mm; the follower's pivot at the origin, all as in the mechanism."""
    return Drawing(tuple(_items(found, lever, mu))).labelled([*_letters(found, lever, mu)])


def placed(found: CamFound) -> complex:
    """Direction of the lowest arm in the drawing: places of the zone lie from it on the side of the lift."""
    return complex(np.exp(1j * side_of(found.cam) * found.low))


def _to_page(found: CamFound, z: np.ndarray) -> np.ndarray:
    """Places from the follower's pivot, the x axis along its lowest arm, lifts counter-clockwise, as they are drawn."""
    return placed(found) * (z if side_of(found.cam) > 0 else np.conj(z))


def _box(found: CamFound, lever: Lever) -> tuple[complex, complex]:
    """Low left and high right corner of what is drawn, about the axes and the arms, m."""
    S, slope, _ = lever.law.of(np.linspace(0.0, FULL_TURN, FINE))
    laid = lever.arm * (1 + (-1 if lever.alike else 1) * slope) * np.exp(1j * S)
    inside = np.concatenate([laid, [0, lever.arm, _made(found), lever.centres.best.p]])
    wide = MARGIN * lever.arm * (1 + 1j)
    return (
        complex(inside.real.min(), inside.imag.min()) - wide,
        complex(inside.real.max(), inside.imag.max()) + wide,
    )


def _made(found: CamFound) -> complex:
    """The axis of the cam as it is made, from the follower's pivot."""
    return abs(found.pivot) * complex(np.exp(-1j * found.start))


def permitted(found: CamFound, lever: Lever) -> np.ndarray:
    """Corners of the zone as far as it is drawn, m, from the follower's pivot."""
    low, high = _box(found, lever)
    around = [low, complex(high.real, low.imag), high, complex(low.real, high.imag)]
    theta = np.unique(np.concatenate([np.linspace(0.0, FULL_TURN, FINE), lever.law.breaks]))
    return np.array(zone(*lever.centres.conditions(theta), around))


def _rays(found: CamFound, lever: Lever) -> Iterator[tuple[complex, complex]]:
    """The lines of the positions in which the follower moves, from the ends of what is laid off to the edge."""
    low, high = _box(found, lever)
    k = -1 if lever.alike else 1
    limits: dict[Way, float] = dict(lever.centres.limits)
    for S, slope in _positions(found):
        limit = limits.get("rise" if slope >= 0 else "return")
        if limit is None:
            continue
        v = complex(np.exp(1j * S))
        start = lever.arm * (1 + k * slope) * v
        for side in (1, -1):
            way = -1j * v + side * tan(limit) * v
            reach = [
                ((edge - at) / step)
                for at, step, edges in (
                    (start.real, way.real, (low.real, high.real)), (start.imag, way.imag, (low.imag, high.imag)),
                )
                for edge in edges
                if step
            ]  # fmt: skip
            far = min((x for x in reach if x > 0), default=0.0)
            yield start, start + far * way


def _positions(found: CamFound) -> list[tuple[float, float]]:
    """Displacement and derivative at the table positions, those of a dwell once."""
    count = found.turn.distinct
    pairs = zip(found.table.S[:count], found.table.first[:count], strict=True)
    return list(dict.fromkeys((round(float(S), 12), round(float(slope), 12)) for S, slope in pairs))


def _items(found: CamFound, lever: Lever, mu: float) -> Iterator[Item]:
    def page(*places: complex) -> list[complex]:
        return [complex(z) / mu for z in _to_page(found, np.array(places, dtype=complex))]

    corners = permitted(found, lever)
    if len(corners):
        yield polygon(page(*corners), None, "pale", 0.6)
    S, slope, _ = lever.law.of(np.linspace(0.0, FULL_TURN, FINE))
    k = -1 if lever.alike else 1
    arms = lever.arm * np.exp(1j * S)
    yield polyline(page(*(arms * (1 + k * slope))), THICK)
    yield polyline(page(*(lever.arm * np.exp(1j * np.linspace(S.min(), S.max(), 61)))), NORMAL)
    for start, end in _rays(found, lever):
        yield polyline(page(start, end), RAY)
    for lifted, rate in _positions(found):
        v = complex(np.exp(1j * lifted))
        at, end = page(lever.arm * v, lever.arm * (1 + k * rate) * v)
        yield line(0j, at, ARM)
        yield line(at, end, LAID)
        yield dot(at, 0.5)
    best, made = page(lever.centres.best.p, _made(found))
    yield line(0j, made, AXIS)
    yield polyline([made, *page(lever.arm)], THIN)
    yield Circle(made, 1.0, None, "black")
    yield dot(best, 1.0)
    yield from marks.support(0j)
    yield from marks.joint(0j)


def _letters(found: CamFound, lever: Lever, mu: float) -> Iterator[Tag]:
    centre, pivot = (symbol(name) for name in found.letters)
    best, made, lowest = (
        complex(z) / mu for z in _to_page(found, np.array([lever.centres.best.p, _made(found), lever.arm]))
    )
    yield Tag((pivot,), (0j,), gap=2.0, prefer=-1 - 1j)
    yield Tag((centre,), (made,), gap=2.0, prefer=-1 - 1j)
    yield Tag((Symbol(centre.base, centre.sub, "*"),), (best,), gap=2.0, prefer=1 - 1j)
    point = symbol(found.cam.point)
    yield Tag((Symbol(point.base, "0"),), (lowest,), gap=1.5, prefer=1 + 1j)
