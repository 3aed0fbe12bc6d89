"""Conventional signs of kinematic schemes: joints, supports, blocks, guides, bushings, stiff corners, turning."""

from __future__ import annotations

import cmath
import math

from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THICK,
    THIN,
    Arc,
    Circle,
    Item,
    Moving,
    Pen,
    hatching,
    line,
    polygon,
)
from tmm_report.figures.schemes.bodies import BLOCK

JOINT = 1.3  # radius of a revolute joint, mm
BARREL = 1.8  # half width of the barrel of a cylinder, mm
SUPPORT = complex(3.0, 5.5)  # half width and height of a support, mm
MARK = Pen(0.4, "red")  # of a wheel as it turns on the screen


def joint(at: complex) -> list[Item]:
    return [Circle(at, JOINT, NORMAL, "white")]


def passing(at: complex, along: complex) -> list[Item]:
    """A stiff link that passes through a joint."""
    return [line(at - JOINT * along, at + JOINT * along, THICK)]


def half_joint(at: complex, out: complex) -> list[Item]:
    """The half of a revolute pair that stays with a link taken off; it opens along the unit vector `out`."""
    start = cmath.phase(out) + math.pi / 2
    return [Circle(at, 1.25 * JOINT, None, "white"), Arc(at, 1.25 * JOINT, start, start + math.pi, Pen(0.5))]


def place(at: complex) -> list[Item]:
    """A point of the frame that is no joint: a guide goes through it."""
    return [line(at - arm, at + arm, THIN) for arm in (0.8 + 0.8j, 0.8 - 0.8j)]


def support(at: complex) -> list[Item]:
    """A fixed pivot: a triangle on hatched ground."""
    left, right = at - SUPPORT, at + SUPPORT.conjugate()
    return [polygon((at, left, right), NORMAL, "white"), *ground(left - 2, right + 2, -1j)]


def ground(start: complex, end: complex, side: complex) -> list[Item]:
    """A line of the frame, hatched on one side."""
    return [hatching(start, end, side), line(start, end, NORMAL)]


def block(at: complex, along: complex, size: complex = BLOCK) -> list[Item]:
    """A slider of half length and half height `size`, mm."""
    half, up = size.real * along, 1j * size.imag * along
    return [polygon((at - half - up, at + half - up, at + half + up, at - half + up), NORMAL, "white")]


def fixed_guide(start: complex, end: complex, side: complex) -> list[Item]:
    """The hatched way of a block whose centre goes from `start` to `end`."""
    down = BLOCK.imag * side
    return ground(start + down, end + down, side)


def axis(start: complex, end: complex) -> list[Item]:
    return [line(start, end, AXIS)]


def bushing(at: complex, along: complex, fixed: bool = True) -> list[Item]:
    """Two cheeks that hold a rod; hatched where they belong to the frame."""
    items: list[Item] = []
    for side in (1j * along, -1j * along):
        start, end = at - BLOCK.real * along + 0.9 * side, at + BLOCK.real * along + 0.9 * side
        items += ground(start, end, side) if fixed else [line(start, end, NORMAL)]
    return items


def cylinder(start: complex, end: complex, least: float, most: float) -> list[Item]:
    """A hydraulic cylinder from the pivot of its barrel to that of its rod, which are between `least` and `most` mm
    apart over the motion: barrel, piston, rod."""
    along = (end - start) / abs(end - start)
    near, far = start + JOINT * along, start + (JOINT + 0.7 * (least - JOINT)) * along
    side = BARREL * 1j * along
    rod = most - 0.9 * abs(far - start)  # the piston stays within the barrel, if the stroke lets it
    piston = start + max(abs(end - start) - rod, JOINT + 0.5) * along
    items: list[Item] = [polygon((near - side, far - side, far + side, near + side), NORMAL, "white")]
    items += [line(piston - side, piston + side, THICK), line(piston, end, THICK)]
    return [*items, *joint(start), *joint(end)]


def weld(corner: complex, one: complex, other: complex) -> list[Item]:
    """A filled corner between two bars that are one piece."""
    legs = [corner + 2.2 * (end - corner) / abs(end - corner) for end in (one, other)]
    return [polygon((corner, *legs), None, "black")]


def turning(centre: complex, radius: float, start: float, sweep: float, pen: Pen = THIN) -> list[Item]:
    """An arc with an arrowhead at its end, from angle `start` over `sweep`, rad."""
    head = min(2.5, abs(sweep) * radius / 2)
    arc = Arc(centre, radius, start, start + sweep * (1 - 0.7 * head / (radius * abs(sweep))), pen)
    tip = arc.at(start + sweep)
    # the chord of the head, so that its base stands on the arc
    back = (arc.at(start + sweep * (1 - head / (radius * abs(sweep)))) - tip) / head
    base = tip + head * back
    return [arc, polygon((tip, base + 0.17j * head * back, base - 0.17j * head * back), None, pen.colour)]


def going_round(
    mark: Item, radius: float, name: str, side: int = 0, across: complex = 1j, sense: int = 0
) -> list[Moving]:
    """Marks of what is seen from the side, for the screen: `mark`, drawn on the axis, goes round at the radius, mm, so
    that one is always in sight. `side`: of what is drawn on one side of its axis alone, ±1."""
    rises = (radius, -radius, *((1j * radius, -1j * radius) if side else ()))
    return [
        Moving((mark,), of=name, sense=sense, rise=complex(rise), across=across, side=side) for rise in rises
    ]


def spot(at: complex) -> Circle:
    """A mark of a wheel where it touches another, seen from the side."""
    return Circle(at, 0.5, MARK, MARK.colour)
