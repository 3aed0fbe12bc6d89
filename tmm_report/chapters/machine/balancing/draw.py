"""Drawings of the balancing: hodographs of the shaking force, the force as the driving link sees it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.chapters.machine.balancing.solve.whole import Case, Found
from tmm_report.figures.charts.plane import Num, Spot, Trace, framed, plane
from tmm_report.figures.drawing import NORMAL, THIN, Circle, Drawing, Item, Pen, dot, line
from tmm_report.figures.lettering import Part, Parts, Symbol
from tmm_report.figures.placing import Tag
from tmm_report.figures.schemes.scheme import standard_scale
from tmm_report.figures.schemes.view import view_of

Array = Any
Labels = tuple[Parts, Parts]
POINTS = 180  # of a hodograph that is drawn


def hodographs(found: Found, drawn: Sequence[tuple[int, Case]], labels: Labels, num: Num) -> Drawing:
    """The ends of the shaking force from one origin, before and after balancing, at one scale; positions numbered on
    the first. `labels`: of both axes."""
    curves = [_thinned(case.cycle.force) for _, case in drawn]
    frame = framed(curves, equal=True)
    traces = [
        Trace(curve, _name(number), closed=True) for curve, (number, _) in zip(curves, drawn, strict=True)
    ]
    count = found.kinematics.positions.table
    spots = [Spot(complex(z), (str(k),)) for k, z in enumerate(drawn[0][1].table.force[:count])]
    return plane(frame, traces, *labels, num, spots=_apart(spots, frame.x_scale))


def _name(number: int) -> tuple[Part, ...]:
    return (str(number),)


def _apart(spots: Sequence[Spot], scale: float) -> list[Spot]:
    """Numbers of positions that fall together stand side by side at one dot."""
    kept: list[Spot] = []
    for spot in spots:
        near = next((k for k, one in enumerate(kept) if abs(one.at - spot.at) < 1.5 * scale), None)
        if near is None:
            kept.append(spot)
        else:
            kept[near] = Spot(kept[near].at, (f"{kept[near].text[0]}, {spot.text[0]}",))
    return kept


def _thinned(values: Array) -> Array:
    """About as many points as a smooth line needs."""
    return values[:: max(1, len(values) // POINTS)]


def seen(found: Found, labels: Labels, num: Num) -> Drawing:
    """The force in the line of the driving link, over ω²: its mean, and the smallest circle round it."""
    centre, radius = found.circle
    curve, mean = _thinned(found.seen), complex(np.mean(found.seen))
    ring = centre + radius * np.exp(2j * np.pi * np.arange(60) / 60)
    frame = framed([curve, ring], equal=True)
    at = frame.at
    more: list[Item] = [
        Circle(at(centre), radius / frame.x_scale, Pen(0.25, "red", (2.0, 1.0))),
        line(at(0j), at(centre), THIN),
        dot(at(0j), 0.5),
        dot(at(centre), 0.8, "red"),
        dot(at(mean), 0.8, "blue"),
    ]
    tags = [Tag(("O",), (at(0j),)), Tag((Symbol("C"),), (at(centre),), colour="red")]
    if abs(mean - centre) > 2.5 * frame.x_scale:
        tags.append(Tag((Symbol("D"),), (at(mean),), colour="blue"))
    else:
        tags[-1] = Tag((Symbol("C"), ", ", Symbol("D")), (at(centre),))
    return plane(frame, [Trace(curve, closed=True)], *labels, num, more=more, tags=tags)


LARGEST = 4.0  # mm: radius of the heaviest counterweight


def fitted(found: Found, case: Case, position: int, mu: float) -> Drawing:
    """The mechanism at a position, `mu` m/mm, with a way's counterweights, their discs as large as their masses."""
    mechanism = found.kinematics.linkage.mechanism
    places, turns = seen_in(found)
    view = view_of(mechanism, places, turns, mu, position)
    heaviest = max(one.mass for one in case.placed)
    items: list[Item] = [*view.plates(), *view.frame()]
    tags = view.point_tags() + view.number_tags()
    for one in case.placed:
        start, end = (view.at(one.link, at / mu) for at in (one.about, one.weight.at))
        radius = LARGEST * (one.mass / heaviest) ** 0.5
        items += [line(start, end, NORMAL), Circle(end, radius, NORMAL, "grey")]
        tags.append(Tag((Symbol("m", f"c{one.link}"),), (end,), gap=radius + 0.8))
    return Drawing((*items, *view.links())).labelled(tags)


def scale(found: Found) -> float:
    """m/mm: of the drawing with the counterweights."""
    return standard_scale(found.kinematics.linkage.mechanism, *seen_in(found))


def seen_in(found: Found) -> tuple[dict[str, Array], dict[str, Array]]:
    """Places of the points and directions of the links at the table positions."""
    motion = found.kinematics.table
    places = {point: motion.place(point) for point in motion.point_index}
    return places, {link: motion.turn(link) for link in found.kinematics.linkage.mechanism.links}
