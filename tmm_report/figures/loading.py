"""Loading schemes: links taken off with the forces that act on them, mm of paper.

Forces are not to scale, their lengths only hint at their sizes. An arm is a dimension from the point about which
moments are taken to the line in which the force acts; it has its true length.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from tmm_report.figures.aside import asides
from tmm_report.figures.dimensions import head
from tmm_report.figures.drawing import THIN, Arrow, Drawing, Item, Pen, Tag, dot, line
from tmm_report.figures.lettering import Part
from tmm_report.figures.plans import PENS, Style
from tmm_report.figures.schemes import marks
from tmm_report.records import dataclass

LETTER = 2.8  # height of the letters of forces and arms, mm
ARROW = (11.0, 17.0)  # the shortest arrow of a force, and by how much the largest force is longer, mm
ARM = Pen(0.18, "green")
ACTION = Pen(0.15, "grey", (2.4, 1.0))
LANE = 5.0  # between dimensions side by side, mm
NEAR = 2.2  # lines nearer than this lie upon one another, mm
SEEN = 0.5  # a shorter arm is not drawn, mm
TURN = 6.0  # radius of the arc of a couple, mm

Segment = tuple[complex, complex]
Array = Any


@dataclass(frozen=True)
class Force:
    """A force at `at`; `vector` says where it points and, against the largest of them, how long it is.

    `of`: key of its quantity; `assumed`: it is only the sense assumed for one that acts the other way.
    """

    at: complex
    vector: complex
    label: Part | None
    style: Style
    of: str = ""
    assumed: bool = False


@dataclass(frozen=True)
class Arm:
    """From `centre` to the line through `at` along the unit vector `along`."""

    centre: complex
    at: complex
    along: complex
    label: Part | None
    of: str = ""

    @property
    def foot(self) -> complex:
        """Where the perpendicular from the centre meets the line."""
        return self.at + ((self.centre - self.at) * self.along.conjugate()).real * self.along


@dataclass(frozen=True)
class Couple:
    """A couple drawn about `at`, + counter-clockwise."""

    at: complex
    sense: float
    label: Part | None


def loading(
    items: Sequence[Item],
    tags: Sequence[Tag],
    forces: Sequence[Force],
    arms: Sequence[Arm] = (),
    couples: Sequence[Couple] = (),
) -> Drawing:
    """`items`, `tags`: the links and their letters. A force that is nil has no arrow."""
    forces = [force for force in forces if force.vector]
    arrows = _arrows(forces)
    drawn = [(arm, lane) for arm, lane in _lanes(arms, items, arrows)]
    lines = [item for arm, lane in drawn for item in _dimension(arm, lane)]
    turns = [item for couple in couples for item in _turn(couple)]
    all_tags = [*_force_tags(forces, arrows), *map(_couple_tag, couples), *_arm_tags(drawn), *tags]
    return Drawing((*lines, *items, *turns, *arrows)).labelled(all_tags)


def point_mark(place: complex) -> Item:
    return dot(place, 0.7)


# ------------------------------------------------------------ forces


def _arrows(forces: Sequence[Force]) -> list[Arrow]:
    """Those that would lie upon one another stand side by side."""
    largest = max((abs(force.vector) for force in forces), default=1.0)
    ends = [(f.at, f.at + _length(f, largest) * f.vector / abs(f.vector)) for f in forces]
    aside = asides(ends)
    return [_arrow(*row) for row in zip(forces, ends, aside, strict=True)]


def _length(force: Force, largest: float) -> float:
    return ARROW[0] + ARROW[1] * abs(force.vector) / largest


def _arrow(force: Force, ends: Segment, aside: float) -> Arrow:
    by = 1j * aside * (ends[1] - ends[0]) / abs(ends[1] - ends[0])
    pen = replace(PENS[force.style], dash=(1.2, 0.8), width=0.2) if force.assumed else PENS[force.style]
    return Arrow(ends[0] + by, ends[1] + by, pen, of="" if force.assumed else force.of, aside=aside)


def _force_tags(forces: Sequence[Force], arrows: Sequence[Arrow]) -> Iterator[Tag]:
    for force, arrow in zip(forces, arrows, strict=True):
        if force.label is not None:
            along = arrow.end - arrow.start
            anchors = tuple(arrow.start + share * along for share in (1.0, 0.75, 0.5))
            out = along / abs(along)
            yield Tag((force.label,), anchors, 0.7, out, LETTER, PENS[force.style].colour)


# ------------------------------------------------------------ arms


def _lanes(
    arms: Sequence[Arm], items: Sequence[Item], arrows: Sequence[Arrow]
) -> Iterator[tuple[Arm, float]]:
    """Each arm with how far it is moved along its force, so that it lies on no other line."""
    taken = [pair for item in (*items, *arrows) for stroke in item.outline() for pair in pairwise(stroke)]
    for arm in arms:
        if abs(arm.foot - arm.centre) < SEEN:
            continue
        lane = _free_lane(arm, taken)
        shift = lane * arm.along
        taken.append((arm.centre + shift, arm.foot + shift))
        yield arm, lane


def _free_lane(arm: Arm, taken: Sequence[Segment]) -> float:
    """Of the nearest lanes that which lies on least."""
    lanes = [0.0, *(side * LANE * k for k in range(1, 7) for side in (1, -1))]
    others = np.array(taken, complex).reshape(-1, 2)
    return min(lanes, key=lambda lane: (_hidden(arm, lane, others), abs(lane)))


def _hidden(arm: Arm, lane: float, taken: Array) -> float:
    """Length of a moved arm that lies on other lines (N, 2), mm, in whole lengths of a letter."""
    start, end = arm.centre + lane * arm.along, arm.foot + lane * arm.along
    return round(sum(_upon(start, end, taken).tolist()) / 3.0)


def _upon(start: complex, end: complex, others: Array) -> Array:
    """Length of a segment that each of others, nearly parallel and near, lies upon."""
    unit = (end - start) / abs(end - start)
    a, b = ((others - start) / unit).T
    near = np.maximum(abs(a.imag), abs(b.imag)) <= NEAR
    upon = np.minimum(np.maximum(a.real, b.real), abs(end - start)) - np.maximum(
        np.minimum(a.real, b.real), 0.0
    )
    return np.where(near, np.maximum(0.0, upon), 0.0)


def _dimension(arm: Arm, lane: float) -> list[Item]:
    """The line of action, the dimension and what leads to it where it is moved."""
    start, end = arm.centre + lane * arm.along, arm.foot + lane * arm.along
    size = min(2.2, abs(end - start) / 4)
    items = [_action(arm, end)]
    items += [line(arm.centre, start + (1.0 if lane > 0 else -1.0) * arm.along, THIN)] if lane else []
    back = size * (end - start) / abs(end - start)
    return [*items, Arrow(start, end, ARM, size, arm.of), replace(head(start, back), fill=ARM.colour)]


def _action(arm: Arm, end: complex) -> Item:
    """The line in which the force acts, past its place and the foot of the dimension."""
    reach = [((z - arm.at) * arm.along.conjugate()).real for z in (arm.at, arm.foot, end)]
    return line(arm.at + (min(reach) - 2) * arm.along, arm.at + (max(reach) + 2) * arm.along, ACTION)


def _arm_tags(drawn: Sequence[tuple[Arm, float]]) -> Iterator[Tag]:
    for arm, lane in drawn:
        if arm.label is not None:
            start, end = arm.centre + lane * arm.along, arm.foot + lane * arm.along
            anchors = tuple(start + share * (end - start) for share in (0.5, 0.35, 0.65, 0.2, 0.8))
            side = arm.along * (1 if lane >= 0 else -1)
            yield Tag((arm.label,), anchors, 0.6, side, LETTER, ARM.colour)


# ------------------------------------------------------------ couples


def _turn(couple: Couple) -> list[Item]:
    start = -0.75 if couple.sense > 0 else cmath.pi + 0.75
    sweep = 1.3 * cmath.pi * (1 if couple.sense > 0 else -1)
    return marks.turning(couple.at, TURN, start, sweep, Pen(0.35, "blue"))


def _couple_tag(couple: Couple) -> Tag:
    spots = tuple(couple.at + cmath.rect(TURN, angle) for angle in (1.57, 0.8, 2.4, 3.14, 0.0))
    return Tag((couple.label,) if couple.label else (), spots, 0.8, 1j, LETTER, "blue")
