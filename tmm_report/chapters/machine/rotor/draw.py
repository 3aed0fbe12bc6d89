"""Drawings of a rotor: the shaft from the side and from its end, the polygons of unbalances and of moments."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.chapters.machine.rotor.solve import Found
from tmm_report.figures.dimensions import span
from tmm_report.figures.drawing import (
    AXIS,
    DASHED,
    NORMAL,
    THICK,
    THIN,
    Arrow,
    Circle,
    Drawing,
    Item,
    Pen,
    Tag,
    Text,
    dot,
    line,
    polygon,
)
from tmm_report.figures.lettering import Symbol, width
from tmm_report.figures.plans import PlanVector, plan
from tmm_report.figures.schemes.marks import support
from tmm_report.mechanics.masses.rotor import Polygon
from tmm_report.quantity.paper import round_scale

Num = Any
LONG, HIGH = 92.0, 20.0  # mm of paper: the shaft, the largest radius
GAP = 16.0  # between the views
WEIGHT = Pen(0.5, "blue")
SMALL = 2.6
DISC = (2 + 8j, -2 + 8j, -2 - 8j, 2 - 8j)  # mm: a body from the side


def polygon_picture(drawn: Polygon, letter: str, title: str) -> Drawing:
    """The vectors one after another, the closing one in red."""
    corners = [complex(z) for z in drawn.corners]
    vectors = [
        PlanVector(start, end, Symbol(letter, name), "force", f"{letter}_{name}")
        for (start, end), name in zip(pairwise(corners), drawn.names, strict=True)
    ]
    closing = Symbol(letter, drawn.closes)
    start = corners[-1]
    vectors.append(PlanVector(start, start + drawn.closing, closing, "reaction", f"{letter}_{drawn.closes}"))
    return plan(vectors, {"O": corners[0]}, title=title, pole="O")


# --- the scheme


class Sheet:
    """Where things stand on the scheme, mm: the shaft along x from its left end, radii at a scale of their own."""

    def __init__(self, found: Found):
        given = found.given
        ends = [*found.places, *(one.at for one in found.corrections), *(given.bearings or ())]
        self.left = float(min(ends))
        extent = float(max(ends)) - self.left
        self.along = round_scale(extent, LONG) if extent > 0 else 1.0  # m/mm
        radii = [one.radius for one in given.heavy if one.radius] + [one.radius for one in found.corrections]
        self.across = round_scale(max(radii, default=1.0) or 1.0, HIGH)
        self.extent = extent / self.along
        self.end = complex(self.extent + GAP + HIGH + 6, 0)

    def x(self, at: float) -> float:
        return (at - self.left) / self.along

    def off(self, radius: float | None, angle: float) -> complex:
        """From the axis in the end view; a mass without a radius stands at a third of the largest."""
        size = HIGH / 3 if radius is None else radius / self.across
        return complex(size * np.cos(angle), size * np.sin(angle))


def scheme(found: Found, num: Num = str, title: str = "") -> Drawing:
    """Side view with the planes of correction and the bearings, end view with the directions of the unbalances."""
    sheet = Sheet(found)
    items: list[Item] = [*_shaft(found, sheet), *_planes(found, sheet), *_end_view(sheet)]
    tags: list[Tag] = []
    for place, radius, angle, name, weight in _marks(found):
        marked, letters = _mark(sheet, place, radius, angle, name, weight)
        items += marked
        tags += letters
    return Drawing((*items, *_chain(found, sheet, num)), title).labelled(tags)


def _marks(found: Found) -> Iterator[tuple[float, float | None, float, str, bool]]:
    """Place, radius, angle, name; whether a weight of correction."""
    for name, one in zip(found.given.names, found.given.heavy, strict=True):
        yield one.at, one.radius, one.angle, name, False
    for made in found.corrections:
        if made.product:
            yield made.at, made.radius, made.angle, made.name, True


def _shaft(found: Found, sheet: Sheet) -> Iterator[Item]:
    yield line(-8 + 0j, complex(sheet.extent + 8, 0), AXIS)
    yield line(-4 + 0j, complex(sheet.extent + 4, 0), Pen(1.0))
    for at in found.given.bearings or ():
        yield from support(complex(sheet.x(at), -0.5))
    for one in found.given.heavy:
        if one.is_body:
            yield polygon(tuple(sheet.x(one.at) + corner for corner in DISC), NORMAL, "white")


def _planes(found: Found, sheet: Sheet) -> Iterator[Item]:
    for one in found.corrections:
        x = sheet.x(one.at)
        yield line(complex(x, -HIGH - 3), complex(x, HIGH + 3), DASHED)
        yield Text(complex(x, HIGH + 5.5), (one.name,), 3.2, 0)


def _end_view(sheet: Sheet) -> Iterator[Item]:
    yield line(sheet.end - HIGH - 4, sheet.end + HIGH + 6, AXIS)
    yield line(sheet.end - 1j * (HIGH + 4), sheet.end + 1j * (HIGH + 6), AXIS)
    yield Circle(sheet.end, 2.0, NORMAL, "white")
    yield Text(sheet.end + complex(HIGH + 6, -2.5), (Symbol("x"),), 3.2, 0)
    yield Text(sheet.end + complex(-2.5, HIGH + 6), (Symbol("y"),), 3.2, 0)


def _mark(
    sheet: Sheet, place: float, radius: float | None, angle: float, name: str, weight: bool
) -> tuple[list[Item], list[Tag]]:
    """A mass in both views: seen from the side at the height of its y."""
    off, pen = sheet.off(radius, angle), WEIGHT if weight else THICK
    foot = complex(sheet.x(place), 0)
    side = foot + 1j * off.imag
    items: list[Item] = [line(foot, side, pen)] if abs(off.imag) > 0.5 else []
    items += [Arrow(sheet.end, sheet.end + off, pen)] if abs(off) > 0.5 else []
    items += [_blob(side, weight), _blob(sheet.end + off, weight)]
    letters = (Symbol("m", name),)
    colour = "blue" if weight else "black"
    out = off / abs(off) if abs(off) > 0.5 else 1j
    up = 1j if off.imag >= 0 else -1j
    return items, [
        Tag(letters, (side,), prefer=up, colour=colour),
        Tag(letters, (sheet.end + off,), prefer=out, colour=colour),
    ]


def _blob(at: complex, weight: bool) -> Item:
    if not weight:
        return dot(at, 1.3)
    half = 1.2
    corners = tuple(at + half * turn for turn in (1 + 1j, -1 + 1j, -1 - 1j, 1 - 1j))
    return polygon(corners, None, "blue")


def _chain(found: Found, sheet: Sheet, num: Num) -> Iterator[Item]:
    """Distances along the shaft, mm, of all that stands on it: one row under the view."""
    given = found.given
    at = sorted(
        {round(z, 9) for z in (*found.places, *(c.at for c in found.corrections), *(given.bearings or ()))}
    )
    low = -HIGH - 9.0
    for z in at:
        yield line(complex(sheet.x(z), -HIGH - 3), complex(sheet.x(z), low - 1.5), THIN)
    for one, other in pairwise(at):
        start, end = complex(sheet.x(one), low), complex(sheet.x(other), low)
        yield from span(start, end)
        text = (num(1e3 * (other - one)),)
        if width(text, SMALL) < end.real - start.real - 1.0:
            yield Text((start + end) / 2 + 2.0j, text, SMALL, 0)
