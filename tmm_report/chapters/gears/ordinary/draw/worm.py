"""A worm and its wheel from the side of the wheel; mm of paper."""

from __future__ import annotations

import math

from tmm_report.chapters.gears.ordinary.draw.common import PITCH
from tmm_report.chapters.gears.ordinary.given import WormStage
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import (
    AXIS,
    THICK,
    THIN,
    Arrow,
    Circle,
    Drawing,
    Item,
    Tag,
    dot,
    line,
)
from tmm_report.figures.lettering import Scale, symbol
from tmm_report.figures.schemes.crossed_axes import thread
from tmm_report.figures.schemes.marks import turning
from tmm_report.quantity.paper import fitting_scale
from tmm_report.quantity.symbols import Symbol

WIDE, TALL = 110.0, 100.0  # mm


def worm(found: Found, title: str) -> Drawing:
    """The worm's shaft is level, its driving end on the left; both turn as they do where the worm turns
    counter-clockwise looked at from that end."""
    n, given = found.s.number, found.given
    assert isinstance(given, WormStage)
    scale = fitting_scale(n("d2") * 1.3, n("d1") + n("d2"), (WIDE, TALL))
    one, two = n("d1") / 2 / scale, n("d2") / 2 / scale
    up = 1 if given.worm == "above" else -1
    centre, half = 1j * up * (one + two), 0.75 * two
    items: list[Item] = [
        Circle(0j, two, PITCH), dot(0j),
        line(complex(-two - 4), complex(two + 4), AXIS), line(-1j * up * (two + 4), centre + 1j * up * (one + 4), AXIS),
        *thread(centre, half, one, given.hand == "right"),
        line(centre - half - 14, centre - half, THICK), line(centre + half, centre + half + 10, THICK),
        *turning(0j, 0.6 * two, math.radians(100 * given.sense), math.radians(-200 * given.sense)),
        *turning(centre - half - 10, 3.2, math.radians(-100), math.radians(200)),
    ]  # fmt: skip
    far = complex(two + 10)
    items += [
        line(0j, far + 2, THIN), line(centre, centre + two + 12, THIN),
        Arrow(far + centre / 2, far, THIN), Arrow(far + centre / 2, far + centre, THIN),
    ]  # fmt: skip
    tags = [
        Tag((symbol("a"),), (far + centre / 2,), prefer=1 + 0j),
        Tag((symbol(given.wheels[0]),), (centre + half + 6,), prefer=1j * up),
        Tag((symbol(given.wheels[1]),), (complex(-0.7 * two, -0.7 * two * up),), prefer=complex(-1, -up)),
        Tag((symbol(f"ω_{given.wheels[0]}"),), (centre - half - 10,), prefer=-1 + 1j * up),
        Tag((symbol(f"ω_{given.wheels[1]}"),), (complex(0.45 * two, 0.3 * two),), prefer=1 + 0j),
    ]
    return Drawing(tuple(items), title, scales=(Scale(Symbol("l"), scale, "m"),)).labelled(tags)
