"""A belt drive across its axes: both pulleys, the strands, the distance, the angles of wrap; mm of paper."""

from __future__ import annotations

import cmath
import math

from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Arc,
    Arrow,
    Circle,
    Drawing,
    Item,
    Tag,
    dot,
    line,
)
from tmm_report.figures.lettering import Scale, symbol
from tmm_report.figures.schemes.marks import turning
from tmm_report.quantity.symbols import Symbol

WIDE, TALL = 130.0, 60.0  # mm of both pulleys together
OUT = 5.0  # of a dimension line from what it measures


def belt(found: Found, title: str) -> Drawing:
    """To scale; the driving pulley stands left and turns counter-clockwise."""
    n = found.s.number
    greatest = max(n("d1"), n("d2"))
    mm = min(WIDE / (n("a") + (n("d1") + n("d2")) / 2), TALL / greatest)
    one, two, far = n("d1") / 2 * mm, n("d2") / 2 * mm, n("a") * mm
    centre = complex(far)
    items: list[Item] = [
        Circle(0j, one, NORMAL), Circle(centre, two, NORMAL), dot(0j), dot(centre),
        line(complex(-one - 3), complex(far + two + 3), AXIS),
        line(-1j * (one + 3), 1j * (one + 3), AXIS), line(centre - 1j * (two + 3), centre + 1j * (two + 3), AXIS),
    ]  # fmt: skip
    items += _strands(found, one, two, far)
    items += turning(0j, max(2.5, 0.55 * one), math.radians(-100), math.radians(200))
    same = found.given.sense > 0
    items += turning(
        centre, max(2.5, 0.55 * two), math.radians(-100 if same else 100), math.radians(200 if same else -200)
    )
    low = -max(one, two) - OUT - 2
    items += [
        *(line(complex(x, 0 - (one if x == 0 else two)), complex(x, low - 1.5), THIN) for x in (0.0, far)),
        Arrow(complex(far / 2, low), complex(0, low), THIN), Arrow(complex(far / 2, low), complex(far, low), THIN),
    ]  # fmt: skip
    names = found.given.wheels
    tags = [
        Tag((symbol("a"),), (complex(far / 2, low),), prefer=1j),
        Tag((symbol(names[0]),), (complex(-one, 0),), prefer=-1 + 1j),
        Tag((symbol(names[-1]),), (complex(far + two, 0),), prefer=1 + 1j),
        Tag((symbol(f"α_{names[0]}"),), (-0.75 * one + 0j,), prefer=-1j),
        Tag((symbol(f"α_{names[-1]}"),), (complex(far + 0.75 * two, 0),), prefer=-1j),
    ]
    return Drawing(tuple(items), title, scales=(Scale(Symbol("l"), 1 / mm, "m"),)).labelled(tags)


def _strands(found: Found, one: float, two: float, far: float) -> list[Item]:
    """Both strands and the arcs about the pulleys, drawn thick; radii to the points where the belt leaves."""
    theta, crossed = found.s.number("theta"), found.given.sense < 0
    items: list[Item] = []
    for side in (1, -1):
        leave = cmath.rect(1, side * (math.pi / 2 + theta))
        meet = -leave if crossed else leave
        ends = one * leave, far + two * meet
        items += [line(*ends, THICK), line(0j, ends[0], THIN), line(complex(far), ends[1], THIN)]
    start = math.pi / 2 + theta
    items.append(Arc(0j, one, start, 2 * math.pi - start, THICK))
    meet_angle = -start + math.pi if crossed else start
    items.append(Arc(complex(far), two, meet_angle, -meet_angle, THICK))
    return items
