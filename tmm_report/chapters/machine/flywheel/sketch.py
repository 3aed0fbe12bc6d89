"""The flywheel drawn to scale: half of it seen along the shaft, and its section through the axis, with dimensions."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator

from tmm_report.chapters.machine.flywheel.given import Disc
from tmm_report.chapters.machine.flywheel.solve import Found
from tmm_report.figures.dimensions import span
from tmm_report.figures.drawing import AXIS, NORMAL, THIN, Circle, Drawing, Item, Text, line, polygon
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.figures.primitives import Path
from tmm_report.quantity.paper import round_scale

SHEET = 80.0  # mm: the wheel is drawn at a round scale within it
HUB, BORE = 0.22, 0.11  # diameters of hub and shaft to that of the wheel: as they usually are, not found
SPOKES = 6
APART = 34.0  # mm, from the wheel to its section
Num = Callable[[float], str]


def scale_of(found: Found) -> float:
    """m for a millimetre, round."""
    return round_scale(max(found.s.number("D_out"), 1.2 * found.s.number("b")), SHEET)


def sketch(found: Found, num: Num, outer_word: str = "outer", title: str = "") -> Drawing:
    """`outer_word`: index of the outer diameter."""
    mm = 1 / scale_of(found)
    outer, width, height = (mm * (found.s.get(key) or 0.0) for key in ("D_out", "b", "h"))
    inner = outer - 2 * height if height else 0.0
    front = [*_front(outer, inner, isinstance(found.given.shape, Disc))]
    centre = complex(outer / 2 + APART + width / 2, 0)
    side = [*_section(centre, outer, inner, width)]
    return Drawing(
        (*front, *side, *_dimensions(found, centre, outer, width, mm, num, outer_word)), title, margin=3.0
    )


def _front(outer: float, inner: float, disc: bool) -> Iterator[Item]:
    """Seen along the shaft."""
    reach = outer / 2 + 4
    yield line(complex(-reach, 0), complex(reach, 0), AXIS)
    yield line(complex(0, -reach), complex(0, reach), AXIS)
    yield Circle(0j, outer / 2)
    hub, bore = HUB * outer / 2, BORE * outer / 2
    yield Circle(0j, bore)
    yield Circle(0j, hub)
    if disc:
        return
    yield Circle(0j, inner / 2)
    for k in range(SPOKES):
        turn = cmath.rect(1, math.pi / 2 + 2 * math.pi * k / SPOKES)
        half = 0.35 * hub * 1j * turn
        for side in (half, -half):
            yield line(hub * 0.95 * turn + side, inner / 2 * 0.995 * turn + side, NORMAL)


def _section(centre: complex, outer: float, inner: float, width: float) -> Iterator[Item]:
    """Through the axis of the shaft: what is cut is hatched."""
    hub, bore = HUB * outer / 2, BORE * outer / 2
    for up in (1, -1):
        foot = bore if not inner else inner / 2
        yield from _cut(centre, width / 2, up * foot, up * outer / 2)
        if inner:
            web = min(0.35 * hub, width / 2)
            yield from _cut(centre, max(width / 2, web) * 1.1, up * bore, up * hub)
            for side in (web * 0.6, -web * 0.6):
                yield line(centre + complex(side, up * hub), centre + complex(side, up * inner / 2), NORMAL)
    yield line(centre - (width / 2 + 6), centre + (width / 2 + 6), AXIS)


def _cut(centre: complex, half: float, low: float, high: float) -> Iterator[Item]:
    """A hatched rectangle about the upright through the centre."""
    corners = [centre + complex(x, y) for x, y in ((-half, low), (half, low), (half, high), (-half, high))]
    yield polygon(corners, NORMAL)
    yield _hatched(centre, half, *sorted((low, high)))


def _hatched(centre: complex, half: float, low: float, high: float) -> Path:
    """Strokes at 45° clipped to the rectangle."""
    strokes = []
    step, wide, tall = 2.5, 2 * half, high - low
    for k in range(1, int((wide + tall) / step) + 1):
        c = k * step  # x + y of the stroke from the lower left corner
        one = complex(min(c, wide), c - min(c, wide))
        other = complex(c - min(c, tall), min(c, tall))
        if abs(one - other) > 0.3:
            corner = centre + complex(-half, low)
            strokes.append((corner + one, corner + other))
    return Path(tuple(strokes), THIN)


def _dimensions(
    found: Found, centre: complex, outer: float, width: float, mm: float, num: Num, word: str
) -> Iterator[Item]:
    """Diameters to the right of the section, the width under it, the height of a rim's section to the left."""
    s = found.s
    edge = centre + width / 2
    name = Symbol("D", word) if "h" in s else Symbol("D")
    yield from _upright(edge, outer, 9.0, _equal(name, num(1e3 * s.number("D_out"))))
    if "h" in s:
        diameter, height = s.number("D"), s.number("h")
        yield from _upright(edge, diameter * mm, 42.0, _equal(Symbol("D"), num(1e3 * diameter)))
        text = _equal(Symbol("h"), num(1e3 * height))
        yield from _height(centre - width / 2, outer, height * mm, text)
    foot = centre - 1j * (outer / 2)
    ends = foot - width / 2, foot + width / 2
    for end in ends:
        yield line(end, end - 11j, THIN)
    yield from span(ends[0] - 9j, ends[1] - 9j)
    yield Text(foot - 13j, _equal(Symbol("b"), num(1e3 * s.number("b"))), align=0)


def _equal(name: Symbol, number: str) -> Parts:
    return (name, f" = {number}")


def _upright(edge: complex, tall: float, off: float, text: Parts) -> Iterator[Item]:
    """A dimension from −tall/2 to tall/2, `off` to the right of the section."""
    ends = edge + 1j * tall / 2, edge - 1j * tall / 2
    for end in ends:
        yield line(end, end + off + 2, THIN)
    yield from span(ends[0] + off, ends[1] + off)
    yield Text(edge + off + 1.5 + 3j, text)


def _height(edge: complex, outer: float, tall: float, text: Parts) -> Iterator[Item]:
    """The rim's section, to the left of it."""
    top = edge + 1j * outer / 2
    for end in (top, top - 1j * tall):
        yield line(end, end - 9, THIN)
    yield from span(top - 7, top - 7 - 1j * tall)
    yield Text(top - 9 + 3j, text, align=1)
