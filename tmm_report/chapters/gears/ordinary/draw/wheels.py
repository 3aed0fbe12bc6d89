"""Friction wheels and trains across their axes: circles that touch, and the forces that press them; mm of paper."""

from __future__ import annotations

from itertools import pairwise

from tmm_report.chapters.gears.ordinary.draw.common import OUT, PITCH, distance, turns, wheel
from tmm_report.chapters.gears.ordinary.solve import Found
from tmm_report.figures.drawing import NORMAL, THICK, Arrow, Drawing, Item, Tag
from tmm_report.figures.lettering import Scale, symbol
from tmm_report.mechanics.gears.trains import Member
from tmm_report.quantity.paper import fitting_scale
from tmm_report.quantity.symbols import Symbol

WIDE, TALL = 130.0, 70.0  # mm of all the wheels together
PRESS = 12.0  # of the arrow of a pressing force


def friction(found: Found, title: str) -> Drawing:
    """The driving wheel stands left and turns counter-clockwise."""
    members, mm = _placed(found)
    items, tags = _circles(found, members, mm, False)
    one, two = members
    side = 1 if one.kind == two.kind or one.radius > two.radius else -1
    touch = one.distance * mm + side * one.radius * mm
    for way in (-1, 1):
        items.append(Arrow(complex(touch + way * PRESS), complex(touch), THICK))
    tags.append(Tag((symbol("F_n"),), (complex(touch - PRESS),), prefer=-1j))
    return Drawing(tuple(items), title, scales=(Scale(Symbol("l"), 1 / mm, "m"),)).labelled(tags)


def train(found: Found, title: str) -> Drawing:
    """By the pitch circles, all axes in one line; the driving wheel turns counter-clockwise."""
    members, mm = _placed(found)
    items, tags = _circles(found, members, mm, True)
    return Drawing(tuple(items), title, scales=(Scale(Symbol("l"), 1 / mm, "m"),)).labelled(tags)


def _placed(found: Found) -> tuple[tuple[Member, ...], float]:
    """The members, and how many mm of paper a metre has."""
    members = found.members
    ends = [place for one in members for place in (one.distance - one.radius, one.distance + one.radius)]
    tall = max(2 * one.radius for one in members)
    return members, 1 / fitting_scale(max(ends) - min(ends), tall, (WIDE, TALL))


def _circles(
    found: Found, members: tuple[Member, ...], mm: float, toothed: bool
) -> tuple[list[Item], list[Tag]]:
    items: list[Item] = []
    tags: list[Tag] = []
    sense = 1
    low = -max(one.radius for one in members) * mm - OUT - 2
    for k, one in enumerate(members):
        centre, radius = complex(one.distance * mm), one.radius * mm
        if k:
            sense *= 1 if found.meshes[k - 1].internal else -1
        items += [*wheel(centre, radius, PITCH if toothed else NORMAL), *turns(centre, radius, sense)]
        tags.append(Tag((symbol(one.name),), (centre + radius * 1j,), prefer=1 + 1j))
    for one, two in pairwise(members):
        ends = sorted((complex(one.distance * mm), complex(two.distance * mm)), key=lambda z: z.real)
        if ends[1].real - ends[0].real > 1:
            text = "a" if len(members) == 2 else f"a_{one.name}"
            drawn, letter = distance(
                ends[0], ends[1], low - (6 if one.distance > two.distance else 0), symbol(text)
            )
            items += drawn
            tags.append(letter)
    return items, tags
