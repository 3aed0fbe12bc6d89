"""The diagram of displacements over their second derivatives with the tangent at 45°: below it stands the axis of a cam
under a flat face, lower by the least permitted radius of curvature; both axes to one scale."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmm_report.chapters.cams.cam.draw.profile import finest
from tmm_report.chapters.cams.cam.solve.found import CamFound
from tmm_report.chapters.cams.cam.solve.turn import BEFORE
from tmm_report.figures.drawing import AXIS, THICK, THIN, Drawing, Item, Pen, Tag, dot, line, polyline
from tmm_report.figures.lettering import Symbol, symbol
from tmm_report.figures.primitives import Arrow
from tmm_report.mechanics.cams.follower_laws import FULL_TURN
from tmm_report.mechanics.cams.sizes.least_face import Face

ROOM = (140.0, 95.0)  # mm: what the diagram may fill
TANGENT = Pen(0.22, "blue")
PAST = 8.0  # mm: how far lines go on


def scale(found: CamFound, under: Face) -> float:
    """At which the diagram fits a page, m/mm."""
    return finest(found.lift + 2 * found.cam.base, partial(_items, found, under), ROOM)


def drawing(found: CamFound, under: Face, mu: float) -> Drawing:
    """At the scale of `mu` m/mm, along both axes."""
    return Drawing(tuple(_items(found, under, mu))).labelled([*_letters(found, under, mu)])


def curve(found: CamFound) -> np.ndarray:
    """S'' + iS over the turn, m; a jump of S'' is drawn."""
    assert found.law is not None
    law = found.law.law
    edges = np.array([*law.breaks, FULL_TURN])
    theta = np.unique(np.concatenate([np.linspace(0.0, FULL_TURN, 1441), edges, edges - BEFORE]))
    S, _, bend = law.of(theta[(theta >= 0) & (theta < FULL_TURN)])
    return np.asarray(bend + 1j * S)


def _touch(under: Face) -> complex:
    """Where the tangent touches."""
    return complex(under.curvature - under.asked.b - under.asked.S, under.asked.S)


def _items(found: CamFound, under: Face, mu: float) -> Iterator[Item]:
    places, touch = curve(found) / mu, _touch(under) / mu
    foot = touch.real + touch.imag  # where the tangent meets the axis of s
    low, wide = -found.cam.base / mu, float(np.abs(places.real).max())
    for start, end in (
        (-wide - PAST + 0j, wide + PAST + 2 + 0j), (1j * (low - PAST), 1j * (found.lift / mu + PAST + 2)),
    ):  # fmt: skip
        yield line(start, end, THIN)
        yield Arrow(end - 3 * (end - start) / abs(end - start), end, THIN)
    yield polyline([complex(z) for z in places], THICK)
    yield line(touch + PAST * (-1 + 1j), complex(PAST, foot - PAST), TANGENT)
    yield dot(touch)
    yield dot(1j * foot)
    yield dot(1j * low, 1.0)
    yield line(1j * low, complex(2 * PAST, low), AXIS)


def _letters(found: CamFound, under: Face, mu: float) -> Iterator[Tag]:
    centre = symbol(found.letters[0])
    wide = float(np.abs(curve(found).real).max()) / mu
    yield Tag((centre,), (-1j * found.cam.base / mu,), gap=2.0, prefer=-1 - 1j)
    yield Tag((Symbol("s", "", "′′"),), (wide + PAST + 2 + 0j,), gap=1.5)
    yield Tag((Symbol("s"),), (1j * (found.lift / mu + PAST + 2),), gap=1.5)
