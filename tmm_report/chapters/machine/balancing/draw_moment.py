"""What lowers the shaking moment, drawn: wheels geared to the links of the mechanism, weights in antiphase.

The wheels are in the proportion of their turns and not to scale; the arms of the weights and the distance of their axes
are.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from tmm_report.chapters.machine.balancing.draw import seen_in
from tmm_report.chapters.machine.balancing.solve.whole import Case, Found
from tmm_report.figures.dimensions import span
from tmm_report.figures.drawing import AXIS, NORMAL, THICK, THIN, Circle, Drawing, Item, line
from tmm_report.figures.lettering import Symbol
from tmm_report.figures.placing import Tag
from tmm_report.figures.schemes import marks
from tmm_report.figures.schemes.view import View, view_of
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.masses.shaking_moment import Couple, Wheel

PITCH = 6.0  # mm: mean radius of a wheel and of the one on its link
WIDE = 90.0  # mm: between the axes of the weights, at most
WEIGHT = 2.2  # mm: radius of a weight
AROUND = 12  # directions in which a wheel's axis is tried


def geared(found: Found, case: Case, position: int, mu: float) -> Drawing:
    """The mechanism at a position, `mu` m/mm, with its wheels: of a link with a fixed pivot a wheel there and its mate
    on an axis of the frame, between them an idler where both turn alike; a ring on a link that is made heavier."""
    view = view_of(found.kinematics.linkage.mechanism, *seen_in(found), mu, position)
    under: list[Item] = []
    tags = view.point_tags() + view.number_tags()
    for wheel in case.wheels:
        if wheel.inertia:
            items, at, radius = _wheel(view, wheel)
            under += items
            tags.append(Tag((Symbol("J", f"w{wheel.link}"),), (at,), gap=radius + 0.8))
    return Drawing((*view.plates(), *under, *view.frame(), *view.links())).labelled(tags)


def _wheel(view: View, wheel: Wheel) -> tuple[list[Item], complex, float]:
    """Its items, the axis and the radius of the one that has the inertia."""
    points = view.mechanism.links[wheel.link].points
    fixed = [view.points[p] for p in points if p in view.mechanism.links[FRAME].points]
    if wheel.ratio == 1 or not fixed:
        centre = view.mechanism.links[wheel.link].mass_centre
        own = [view.points[p] for p in ([centre] if centre in view.points else points) if p in view.points]
        at = sum(own) / len(own)
        return [Circle(at, 1.5 * PITCH, AXIS)], at, 1.5 * PITCH
    at = fixed[0]
    radii = [PITCH * abs(wheel.ratio) ** 0.5, PITCH / abs(wheel.ratio) ** 0.5]
    if wheel.ratio > 0:
        radii.insert(1, 0.6 * PITCH)  # an idler keeps the sense
    way = _free(view, at, radii[0] + sum(2 * radius for radius in radii[1:]))
    items: list[Item] = []
    for k, radius in enumerate(radii):
        items.append(Circle(at, radius, NORMAL, "pale" if k == len(radii) - 1 else ""))
        if k:
            items += [*marks.support(at), *marks.joint(at)]
        if k < len(radii) - 1:
            at += (radius + radii[k + 1]) * way
    return items, at, radii[-1]


def _free(view: View, pivot: complex, reach: float) -> complex:
    """The direction in which most room is between what stands there and the points of the mechanism."""
    others = [z for z in view.points.values() if abs(z - pivot) > 1e-6]

    def room(way: complex) -> float:
        return min(
            (abs(pivot + share * reach * way - z) for z in others for share in (0.5, 0.75, 1.0)), default=0.0
        )

    ways = [cmath.rect(1.0, 2 * math.pi * k / AROUND) for k in range(AROUND)]
    return max(ways, key=lambda way: round(room(way), 3))


# ---------------------------------------------------------------- weights in antiphase


def antiphase(found: Found, case: Case, position: int) -> Drawing:
    """Each pair of weights at a position of the mechanism, one order under another, in one scale."""
    turned = float(found.kinematics.turned[position]) * found.kinematics.cycle.sense
    pairs = [one for one in case.couples if one.moment]
    mu = antiphase_scale(case)
    items: list[Item] = []
    tags: list[Tag] = []
    y = 0.0
    for one in pairs:
        y -= one.radius / mu
        own, letters = _pair(one, turned, y, mu)
        items += own
        tags += letters
        y -= one.radius / mu + 18.0
    return Drawing(tuple(items)).labelled(tags)


def antiphase_scale(case: Case) -> float:
    """m/mm: of the widest pair."""
    return max(one.distance + 2 * one.radius for one in case.couples) / WIDE


def _pair(one: Couple, turned: float, y: float, mu: float) -> tuple[list[Item], list[Tag]]:
    half, arm = one.distance / 2 / mu, one.radius / mu
    angle = one.angle + one.order * turned
    ends = list(_ends(half, arm, angle, y))
    items: list[Item] = []
    tags: list[Tag] = []
    for axis, weight in ends:
        items += [*marks.support(axis), Circle(axis, arm, AXIS), line(axis, weight, THICK)]
        items += [*marks.joint(axis), Circle(weight, WEIGHT, NORMAL, "grey")]
        tags.append(Tag((Symbol("m", "c", f"({one.order})"),), (weight,), gap=WEIGHT + 0.8))
    foot = -1j * (arm + 9.0)
    first, second = (axis for axis, _ in ends)
    items += [line(axis, axis + 1.1 * foot, THIN) for axis in (first, second)]
    items += span(first + foot, second + foot)
    tags.append(Tag((Symbol("d", "c", f"({one.order})"),), ((first + second) / 2 + foot,)))
    return items, tags


def _ends(half: float, arm: float, angle: float, y: float) -> Iterator[Sequence[complex]]:
    """The axis and the weight to the left, then those to the right, at which the angle is told, mm."""
    for side in (-1, 1):
        axis = complex(side * half, y)
        yield axis, axis + side * cmath.rect(arm, angle)
