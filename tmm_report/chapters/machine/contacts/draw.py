"""Sketches of planes, wedges and screws with friction, mm of paper: what acts where, at angles that can be seen."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

from tmm_report.chapters.machine.contacts.given import Incline
from tmm_report.chapters.machine.contacts.solve import Solved
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Arc,
    Arrow,
    Drawing,
    Item,
    Tag,
    dot,
    line,
    polygon,
)
from tmm_report.figures.lettering import symbol
from tmm_report.figures.schemes.marks import ground

FORCE = 20.0  # length of a force, mm
BASE = 62.0  # of a plane


def _seen(angle: float, low: float = 9.0, high: float = 40.0) -> float:
    """An angle as it is drawn, rad: no flatter and no steeper than can be seen; `angle` in degrees."""
    return math.radians(min(max(angle, low), high))


def tag(text: str, at: complex, prefer: complex = 0j) -> Tag:
    return Tag((symbol(text),), (at,), prefer=prefer)


def force(
    start: complex, along: complex, text: str, side: complex = 0j, part: float = 0.85
) -> tuple[Item, Tag]:
    """An arrow from `start` along a vector, mm, lettered beside a part of it."""
    return Arrow(start, start + along, NORMAL), tag(text, start + part * along, side)


def drawing(items: list[Item], tags: list[Tag], title: str) -> Drawing:
    return Drawing(tuple(items), title).labelled(tags)


def _body(at: complex, along: complex, half: complex = 7 + 4.5j) -> Item:
    """A block that stands on its place `at`."""
    up = 1j * along
    foot, top = half.real * along, 2 * half.imag * up
    return polygon((at - foot, at + foot, at + foot + top, at - foot + top), THICK, "pale")


def incline(item: Solved, title: str) -> Drawing:
    level = isinstance(item.of, Incline) and item.of.force == "level"
    return _slope(item.s.number("alpha"), item.s.number("phi"), ("α", "φ"), level, title)


def screw(item: Solved, title: str) -> Drawing:
    """The thread unrolled: a plane of the lead angle."""
    drawn = _slope(item.s.number("psi"), item.s.number("phi_red"), ("ψ", "φ'"), True, title)
    slope = _seen(item.s.number("psi"))
    top = complex(BASE, BASE * math.tan(slope))
    tags = [
        tag("h", complex(BASE + 1, top.imag / 2), 1),
        Tag(("π", symbol("d_2")), (0.25 * BASE - 3j,), prefer=-1j),
    ]
    return drawn.labelled(tags)


def _slope(slope: float, phi: float, names: tuple[str, str], level: bool, title: str) -> Drawing:
    """A body on a plane: load, moving force, normal and the reaction that leans from it by the angle of friction."""
    angle, cone = _seen(slope), _seen(phi, 8.0, 30.0)
    along = cmath.rect(1, angle)
    up, top = 1j * along, complex(BASE, BASE * math.tan(angle))
    at = 0.6 * top
    centre = at + 4.5 * up
    push = FORCE * (1.0 if level else along)
    reaction = FORCE * 1.3 * up * cmath.rect(1, cone)
    items: list[Item] = [
        polygon((0j, complex(BASE), top), THICK),
        *ground(0j, complex(BASE), -1j),
        _body(at, along),
        line(at, at + 1.5 * FORCE * up, AXIS),
        Arc(0j, 17, 0, angle, THIN),
        Arc(at, 21, cmath.phase(up), cmath.phase(reaction), THIN),
        dot(centre),
    ]
    arrows = [
        force(centre - push, push, "F", 1j, 0.2),
        force(centre, -1j * FORCE, "Q", 1),
        force(at, reaction, "R", -1),
    ]
    middle = at + cmath.rect(24, (cmath.phase(up) + cmath.phase(reaction)) / 2)
    tags = [
        tag(names[0], cmath.rect(19, angle / 2), 1),
        tag(names[1], middle, 1j),
        *(one for _, one in arrows),
    ]
    return drawing([*items, *(arrow for arrow, _ in arrows)], tags, title)


def wedge(item: Solved, title: str) -> Drawing:
    """The wedge between the base and a load that is guided upright."""
    angle = _seen(item.s.number("alpha"))
    top = complex(BASE, BASE * math.tan(angle))
    left, right = 24.0, 42.0
    low, high = complex(left, left * math.tan(angle)), complex(right, right * math.tan(angle))
    roof = high.imag + 16
    load = (low, high, complex(right, roof), complex(left, roof))
    items: list[Item] = [
        polygon((0j, complex(BASE), top), THICK, "pale"),
        polygon(load, THICK, "white"),
        *ground(-6 + 0j, complex(BASE + 6), -1j),
        *ground(complex(left, roof - 1), complex(left, roof - 11), -1),
        *ground(complex(right, roof - 11), complex(right, roof - 1), 1),
        Arc(0j, 15, 0, angle, THIN),
    ]
    arrows = [
        force(complex(BASE + FORCE, top.imag / 2), -FORCE + 0j, "F", 1j),
        force(complex(33, roof + FORCE), -1j * FORCE, "Q", 1),
    ]
    tags = [tag("α", cmath.rect(17, angle / 2), 1), *(one for _, one in arrows)]
    return drawing([*items, *(arrow for arrow, _ in arrows)], tags, title)


def sliders(item: Solved, title: str) -> Drawing:
    """The driving slider on a level guide, the driven one in its guide, the face between them with its normal."""
    theta, alpha = math.radians(item.s.number("theta")), _seen(item.s.number("alpha"), 5.0, 68.0)
    at, normal, along = 10j, cmath.rect(1, alpha), cmath.rect(1, theta)
    face = 1j * normal

    def cut(y: float) -> complex:
        """Of the face with a level."""
        return at + face * (y - at.imag) / face.imag

    across = 1j * along
    edges = [at + face * width / (face.conjugate() * across).real for width in (-6.0, 6.0)]
    far = [at + 34 * along + width * across for width in (-6.0, 6.0)]
    items: list[Item] = [
        polygon((-28 + 0j, cut(0.0), cut(20.0), -28 + 20j), THICK, "pale"),
        polygon((edges[0], far[0], far[1], edges[1]), THICK, "white"),
        *ground(-34 + 0j, 12 + 0j, -1j),
        *(one for side, end in zip((-1, 1), far, strict=True) for one in _cheek(end, along, side * across)),
        line(at, at + 30 * normal, AXIS),
        line(at, at + 26, AXIS),
        Arc(at, 14, 0, alpha, THIN),
        Arc(at, 24, 0, theta, THIN),
    ]
    arrows = [force(-48 + 10j, FORCE + 0j, "F", 1j, 0.3), force(at + 56 * along, -FORCE * along, "Q", 1, 0.3)]
    tags = [
        tag("α", at + cmath.rect(16, alpha / 2), 1), tag("θ", at + cmath.rect(26, theta / 3), 1),
        *(one for _, one in arrows),
    ]  # fmt: skip
    return drawing([*items, *(arrow for arrow, _ in arrows)], tags, title)


def _cheek(end: complex, along: complex, side: complex) -> list[Item]:
    return ground(end - 14 * along, end - 2 * along, side)


SKETCHES: dict[str, Callable[[Solved, str], Drawing]] = {
    "incline": incline,
    "wedge": wedge,
    "screw": screw,
    "sliders": sliders,
}
