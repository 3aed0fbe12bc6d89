"""Bevel wheels and friction cones in the plane of their axes; mm of paper.

The driving axis is level, the apex O of the cones at its right end; the driven axis goes from O at the angle Σ to it.
"""

from __future__ import annotations

import cmath
import math

from tmm_report.chapters.gears.ordinary.draw.common import PITCH
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THIN,
    Arc,
    Drawing,
    Item,
    Tag,
    dot,
    line,
)
from tmm_report.figures.lettering import Scale, symbol
from tmm_report.figures.schemes.crossed_axes import cone
from tmm_report.quantity.paper import fitting_scale
from tmm_report.quantity.symbols import Symbol

WIDE, TALL = 110.0, 90.0  # mm of both cones together


def cones(found: Found, title: str) -> Drawing:
    """To scale, the pitch cones with their angles."""
    outer, inner = _reach(found)
    n = found.s.number
    angles = math.radians(n("delta1")), math.radians(n("delta2"))
    whole = angles[0] + angles[1]
    scale = fitting_scale(2 * outer, 2 * outer, (WIDE, TALL))
    outer, inner = outer / scale, inner / scale
    items: list[Item] = [dot(0j)]
    tags = [Tag((symbol("O"),), (0j,), prefer=1 + 1j)]
    for name, axis, delta in zip(found.given.wheels, (math.pi, math.pi + whole), angles, strict=True):
        items += list(cone(axis, delta, outer, inner, NORMAL))
        items.append(
            line(cmath.rect(4, axis + math.pi), cmath.rect(outer * math.cos(delta) + 14, axis), AXIS)
        )
        tags.append(Tag((symbol(name),), (cmath.rect(outer * math.cos(delta) + 8, axis),), prefer=1 + 1j))
    items.append(line(0j, cmath.rect(outer + 6, math.pi + angles[0]), PITCH))
    items += [
        Arc(0j, 0.35 * inner, math.pi, math.pi + angles[0], THIN),
        Arc(0j, 0.5 * inner, math.pi + angles[0], math.pi + whole, THIN),
    ]
    middles = math.pi + angles[0] / 2, math.pi + angles[0] + angles[1] / 2
    for name, middle, part in zip(found.given.wheels, middles, (0.35, 0.5), strict=True):
        tags.append(
            Tag((symbol(f"δ_{name}"),), (cmath.rect(part * inner, middle),), prefer=cmath.rect(1, middle))
        )
    return Drawing(tuple(items), title, scales=(Scale(Symbol("l"), scale, "m"),)).labelled(tags)


def _reach(found: Found) -> tuple[float, float]:
    """Outer and inner cone distance, m."""
    n = found.s.number
    if "R_e" in found.s:
        return n("R_e"), n("R_e") - n("b")
    mean = n("d1") / 2 / math.sin(math.radians(n("delta1")))
    wide = n("b") if "b" in found.s else 0.3 * mean
    return mean + wide / 2, max(mean - wide / 2, 0.2 * mean)
