"""A belt or a chain across its axes: both pulleys, the strands, the distance, the angles of wrap; mm of paper."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

from tmm_report.chapters.gears.ordinary.draw.common import OUT, PITCH, distance, turns, wheel
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import DASHED, NORMAL, THICK, THIN, Arc, Drawing, Item, Pen, Tag, line
from tmm_report.figures.lettering import Scale, lettered, symbol
from tmm_report.quantity.paper import fitting_scale
from tmm_report.quantity.symbols import Symbol

Words = Callable[[str], str]
WIDE, TALL = 130.0, 60.0  # mm of both pulleys together
CHAIN = Pen(THICK.width, dash=DASHED.dash)


def belt(found: Found, title: str, words: Words = str) -> Drawing:
    """To scale; the driving pulley stands left and turns counter-clockwise. `words` translates those of indices."""
    return _driven(found, title, THICK, words)


def chain(found: Found, title: str, words: Words = str) -> Drawing:
    """By the pitch circles; the chain is dashed."""
    return _driven(found, title, CHAIN, words)


def _driven(found: Found, title: str, pen: Pen, words: Words) -> Drawing:
    n, toothed = found.s.number, pen is CHAIN
    greatest = max(n("d1"), n("d2"))
    scale = fitting_scale(n("a") + (n("d1") + n("d2")) / 2, greatest, (WIDE, TALL))
    mm = 1 / scale
    one, two, centre = n("d1") / 2 * mm, n("d2") / 2 * mm, complex(n("a") * mm)
    circle = PITCH if toothed else NORMAL
    items = [*wheel(0j, one, circle), *wheel(centre, two, circle)]
    sense = found.given.sense
    items += [
        *_strands(one, two, centre.real, sense < 0, pen),
        *turns(0j, one, 1),
        *turns(centre, two, sense),
    ]
    low = -max(one, two) - OUT - 2
    dimension, letter = distance(-1j * one, centre - 1j * two, low, lettered(found.s.var("a").sign, words))
    names = found.given.wheels
    tags = [
        letter,
        Tag((symbol(names[0]),), (complex(-one, 0),), prefer=-1 + 1j),
        Tag((symbol(names[-1]),), (centre + two,), prefer=1 + 1j),
    ]
    if not toothed:
        tags += [
            Tag((symbol(f"α_{names[0]}"),), (-0.75 * one + 0j,), prefer=-1j),
            Tag((symbol(f"α_{names[-1]}"),), (centre + 0.75 * two,), prefer=-1j),
        ]
    return Drawing((*items, *dimension), title, scales=(Scale(Symbol("l"), scale, "m"),)).labelled(tags)


def _strands(one: float, two: float, far: float, crossed: bool, pen: Pen) -> list[Item]:
    """Both strands and the arcs about the pulleys; thin radii to the points where a belt leaves."""
    theta = math.asin(((one + two) if crossed else (two - one)) / far)
    # where the upper strand leaves the driving pulley
    start = math.pi / 2 - theta if crossed else math.pi / 2 + theta
    items: list[Item] = []
    for side in (1, -1):
        leave = cmath.rect(1, side * start)
        meet = -leave if crossed else leave
        ends = one * leave, far + two * meet
        items += [line(*ends, pen), line(0j, ends[0], THIN), line(complex(far), ends[1], THIN)]
    met = math.pi - start if crossed else start
    return [*items, Arc(0j, one, start, 2 * math.pi - start, pen), Arc(complex(far), two, met, -met, pen)]
