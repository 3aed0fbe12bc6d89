"""The Assur groups of a mechanism taken apart: each with the free halves of its outer joints."""

from __future__ import annotations

import re
from collections.abc import Sequence

from tmm_report.figures.drawing import Drawing, Item, Tag, Text
from tmm_report.figures.lettering import Parts, Symbol
from tmm_report.figures.schemes import marks
from tmm_report.figures.schemes.bodies import BLOCK, NEAR, bushing, is_rod, number
from tmm_report.figures.schemes.view import View
from tmm_report.mechanics.lever.mechanism import FRAME


def taken_off(view: View, name: str, links: Sequence[str]) -> Drawing:
    """One group with its free half-joints, lettered, its name in the middle under it."""
    items, tags = loose(view, links)
    drawing = Drawing(tuple(items)).labelled(tags)
    left, bottom, right, _ = drawing.box
    return Drawing((*drawing.items, Text(complex((left + right) / 2, bottom - 4), _class(name), align=0)))


def _class(name: str) -> Parts:
    """The name of a group, its order an index: II2(2,3)."""
    match = re.fullmatch(r"([IVX]+) ?(\d+)(\(.*)", name)
    return (Symbol(match[1], match[2], italic=False), match[3]) if match else (name,)


def loose(view: View, links: Sequence[str]) -> tuple[list[Item], list[Tag]]:
    """A group taken off: its items, and the tags of its points and links."""
    own = [link for link in links if link in view.bodies]
    items = [*view.plates(own), *_free_guides(view, links), *view.links(links)]
    items += [item for point in view.joints for item in _free_joint(view, point, links)]
    if FRAME in links:
        fixed = [
            view.points[p] for p, names in view.joints.items() if FRAME in names and set(own) & set(names)
        ]
        items = [*(item for z in fixed for item in marks.support(z)), *items]
        items += view.rotation()
    shown = [p for p in view.points if set(view.mechanism.links_at(p)) & set(own)]
    tags = view.point_tags(shown) + view.number_tags(own)
    tags += view.rotation_tags() if FRAME in links else []
    return items, tags


def _free_joint(view: View, point: str, links: Sequence[str]) -> list[Item]:
    """The half of a joint whose other links belong elsewhere."""
    own = [name for name in view.joints[point] if name in links]
    if len(own) != 1 or own[0] == FRAME or own[0] not in view.bodies:
        return []
    body, local = view.bodies[own[0]], view.motion.local(own[0], point)
    if view.passes(own[0], point):
        return view.joint_mark(point)
    ends = [z for bar in body.bars for z in bar] + list(body.plate)
    inward = sum(z - local for z in ends)
    out = -inward / abs(inward) if abs(inward) > NEAR else 0j
    return (
        marks.half_joint(view.points[point], out * view.turn(own[0]))
        if out
        else marks.joint(view.points[point])
    )


def _free_guides(view: View, links: Sequence[str]) -> list[Item]:
    """Guides that stay elsewhere, under the group's own blocks and rods."""
    items: list[Item] = []
    for slide in view.mechanism.slides:
        guide = view.mechanism.guides[slide.guide]
        if slide.link not in links or guide.link in links or slide.link not in view.bodies:
            continue
        along = view.turn(guide.link) * number(guide.direction)
        centre = view.at(slide.link, number(slide.through) / view.motion.mu)
        if is_rod(view.motion, slide):
            items += marks.bushing(
                view.motion.on_guide(guide, bushing(view.motion, slide)), along, fixed=False
            )
        else:
            items += marks.axis(centre - 2.2 * BLOCK.real * along, centre + 2.2 * BLOCK.real * along)
    return items


def in_rows(drawings: Sequence[Drawing], wide: float, gap: float = 6.0) -> tuple[Item, ...]:
    """Drawings set in rows not wider than `wide`, mm, their feet on one line."""
    items: list[Item] = []
    x = y = 0.0
    row: list[tuple[Drawing, float]] = []
    for drawing in [*drawings, None]:
        if row and (drawing is None or x + drawing.size[0] > wide):
            y -= max(one.size[1] for one, _ in row)
            items += [
                item for one, at in row for item in one.moved(complex(at, y) - complex(*one.box[:2])).items
            ]
            x, y, row = 0.0, y - gap, []
        if drawing is not None:
            row.append((drawing, x))
            x += drawing.size[0] + gap
    return tuple(items)
