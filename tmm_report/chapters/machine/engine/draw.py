"""Drawings of an engine: cranks and cylinders from the side and from the end, polygons of cranks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.chapters.machine.engine.drawn import Star
from tmm_report.chapters.machine.engine.solve import Found
from tmm_report.chapters.machine.engine.values import KINDS
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    Circle,
    Drawing,
    Item,
    Pen,
    Tag,
    Text,
    dot,
    line,
    polygon,
    together,
)
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.plans import PlanVector, plan
from tmm_report.figures.schemes.marks import joint
from tmm_report.mechanics.masses.rotor import Polygon
from tmm_report.quantity.paper import round_scale

Array = Any
LONG, THROW = 56.0, 11.0  # mm of paper: the shaft, the crank
REACH = 2.2 * THROW  # of a cylinder's axis in the end view
PISTON = 8.0 + 6.0j  # across and along its axis, mm
SPOKE = 12.0  # mm: cranks of a star
APART = 12.0  # between pictures side by side
LEAST = 0.5  # mm: a shorter sum is drawn as none
WIDE = 150.0  # a wider picture of direct and reverse cranks is put in two rows
SHAFT = Pen(1.0)
NAMES = 4  # written out at one place; of more the first and the last


def scheme(found: Found, title: str = "") -> Drawing:
    """The cranks along the shaft and from its end, with the cylinders' axes and pistons, at angle 0."""
    end = _end_view(found)
    left = -min(z.real for item in end.items for stroke in item.outline() for z in stroke)
    if found.spread:
        side = _side_view(found)
        end = end.moved(complex(LONG / 2 + APART + left, 0))
        return Drawing((*side.items, *end.items), title)
    return Drawing(end.items, title)


def along_scale(found: Found) -> float:
    """m/mm of the side view, along the shaft."""
    return round_scale(2 * found.spread, LONG)


def _side_view(found: Found) -> Drawing:
    """Cranks at the heights of their pins; the plane of the moments is the dashed line."""
    scale = along_scale(found)
    pins = 1j * np.exp(1j * found.angles) * THROW
    items: list[Item] = [line(-LONG / 2 - 6 + 0j, LONG / 2 + 6 + 0j, AXIS)]
    items += [line(-LONG / 2 - 3 + 0j, LONG / 2 + 3 + 0j, SHAFT)]
    items += [line(-1j * (THROW + 5), 1j * (THROW + 5), AXIS)]
    tags = []
    for one, pin, at in zip(found.given.laid, pins, found.places / scale, strict=True):
        foot, top = complex(at), complex(at, pin.imag)
        if abs(pin.imag) > 0.5:
            items.append(line(foot, top, THICK))
        items.append(dot(top, 1.1))
        tags.append(Tag((one.name,), (top,), prefer=1j if pin.imag >= 0 else -1j))
    items.append(Text(complex(LONG / 2 + 7, -3), (Symbol("z"),), 3.2, 0))
    return Drawing(tuple(items)).labelled(tags)


def _end_view(found: Found) -> Drawing:
    axes = 1j * np.exp(1j * found.banks)
    pins = {
        one.name: complex(pin)
        for one, pin in zip(found.given.laid, 1j * np.exp(1j * found.angles) * THROW, strict=True)
    }
    heads = {one.name: complex(axis) * REACH for one, axis in zip(found.given.laid, axes, strict=True)}
    items: list[Item] = [Circle(0j, THROW, AXIS)]
    tags: list[Tag] = []
    for names, head in together(heads):
        unit = head / abs(head)
        items += [line(-0.25 * head, 1.25 * head, AXIS), _piston(head, unit)]
        tags.append(Tag((_listed(names),), (head + unit * PISTON.imag,), prefer=unit))
    for names, pin in together(pins):
        items += [line(0j, pin, THICK), *joint(pin)]
        tags.append(Tag((_listed(names),), (pin,), prefer=pin / abs(pin)))
    return Drawing((*items, *joint(0j))).labelled(tags)


def _listed(names: Sequence[str]) -> str:
    """Names at one place."""
    return ", ".join(names if len(names) <= NAMES else [*names[:2], "…", names[-1]])


def _piston(at: complex, along: complex) -> Item:
    half, deep = 1j * along * PISTON.real / 2, along * PISTON.imag / 2
    return polygon((at - half - deep, at + half - deep, at + half + deep, at - half + deep), NORMAL, "white")


# --- stars and polygons of cranks


def star_picture(star: Star, words: Sequence[str], mirrored: bool, title: str) -> Drawing:
    """Direct cranks as a star and as a polygon with its sum; beside them the reverse ones, where they do not mirror
    the direct ones. `words`: what stands over the halves."""
    halves = [(star.direct_cranks, star.direct, words[0])]
    if not mirrored:
        halves.append((star.reverse_cranks, star.reverse, words[1]))
    rows = [list(_half(star, cranks, drawn, word)) for cranks, drawn, word in halves]
    whole = beside([picture for row in rows for picture in row], title)
    left, _, right, _ = whole.box
    return whole if right - left <= WIDE else above([beside(row, title) for row in rows], title)


def _half(star: Star, cranks: Array, drawn: Polygon, word: str) -> Iterator[Drawing]:
    wheel = _wheel(drawn.names, cranks)
    said = [Text(complex(0, wheel.box[3] + 3), (word,), 3.0, 0)] if word else []
    yield Drawing((*wheel.items, *said))
    corners = [complex(z) for z in drawn.corners]
    vectors = [
        PlanVector(start, end, name, "force")
        for (start, end), name in zip(pairwise(corners), drawn.names, strict=True)
    ]
    total = -drawn.closing
    if abs(total) > LEAST:
        sign = Symbol("d", f"{KINDS[star.of].letter}{star.order}", "" if drawn is star.direct else "'")
        vectors.append(PlanVector(corners[0], corners[0] + total, sign, "reaction"))
    if any(abs(vector.end - vector.start) > 0.05 for vector in vectors):
        yield plan(vectors, {"O": corners[0]}, pole="O")


def _wheel(names: Sequence[str], cranks: Array) -> Drawing:
    ends = {name: complex(crank) * SPOKE for name, crank in zip(names, cranks, strict=True)}
    items: list[Item] = [Circle(0j, SPOKE, AXIS), line(-1j * (SPOKE + 2), 1j * (SPOKE + 2), AXIS)]
    tags = []
    for group, end in together(ends):
        items += [line(0j, end, THICK), dot(end, 0.9)]
        tags.append(Tag((_listed(group),), (end,), prefer=end / abs(end)))
    return Drawing((*items, dot(0j, 0.8))).labelled(tags)


def above(pictures: Sequence[Drawing], title: str) -> Drawing:
    """Drawings one over another, their middles in one line."""
    items: list[Item] = []
    y = 0.0
    for picture in pictures:
        left, bottom, right, top = picture.box
        items += picture.moved(complex(-(left + right) / 2, y - top)).items
        y -= top - bottom + APART / 2
    return Drawing(tuple(items), title)


def beside(pictures: Sequence[Drawing], title: str) -> Drawing:
    """Drawings side by side, their middles at one height."""
    items: list[Item] = []
    x = 0.0
    for picture in pictures:
        left, bottom, right, top = picture.box
        moved = picture.moved(complex(x - left, -(bottom + top) / 2))
        items += moved.items
        x += right - left + APART / 2
    return Drawing(tuple(items), title)
