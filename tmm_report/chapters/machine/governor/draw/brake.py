"""The centrifugal brake, not to scale: the drum, the shoes on their springs, the shaft."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

from tmm_report.chapters.machine.governor.given import ShoeArm
from tmm_report.chapters.machine.governor.solve.brake import BrakeFound
from tmm_report.chapters.machine.governor.values import Brake, Braking
from tmm_report.figures.dimensions import span
from tmm_report.figures.drawing import (
    AXIS,
    NORMAL,
    THIN,
    Arrow,
    Circle,
    Drawing,
    Item,
    Tag,
    line,
    polygon,
    polyline,
)
from tmm_report.figures.lettering import Parts, Symbol, lettered
from tmm_report.figures.schemes.marks import turning
from tmm_report.quantity.sheet import Q

OUTER, INNER, SHAFT = 34.0, 30.0, 4.0  # radii of the drum and the shaft, mm
FACE, BACK, CENTRE = (
    28.0,
    19.0,
    23.0,
)  # of a shoe: its face a gap away from the drum, its back, its mass centre
LOW = -42.0  # where the radius of the mass centre is stated


def brake(found: BrakeFound, title: str = "", words: Callable[[str], str] = str) -> Drawing:
    """All the shoes at rest; the first one is lettered; `words` translates those of indices."""
    count = found.given.count
    step = 2 * math.pi / count
    items: list[Item] = [Circle(0j, OUTER), Circle(0j, INNER), Circle(0j, SHAFT, NORMAL, "white")]
    items += [line(-40 + 0j, 40 + 0j, AXIS), line(-40j, 40j, AXIS)]
    for k in range(count):
        items += _shoe(cmath.rect(1.0, k * step), min(0.5, 0.4 * step))
        items += _arm(cmath.rect(1.0, k * step), found.given.arm, found.given.drum) if found.given.arm else []
    radius = cmath.rect(INNER, step / 2)
    items += [Arrow(0j, radius, THIN), *_dimension(), *turning(0j, 9.0, 1.5 * step - 0.35, 0.7)]

    def named(of: Q) -> Parts:
        letter = lettered(of.symbol, words)
        return (letter,) if letter else ()

    tags = [
        Tag(named(Brake.m), (complex(CENTRE, 2.6),), 0.0),
        Tag(named(Brake.R), (0.62 * radius,), 1.0),
        Tag(named(Brake.gap), (37 + 7j,), 0.0),
        Tag(named(Brake.c), (12.5 - 3j,), 1.0, -1j),
        Tag((Symbol("ρ", "0"),), (complex(CENTRE / 2, LOW),), 1.0, 1j),
        *([Tag((Symbol("A"),), (_pivot(arm, found.given.drum),), 2.0)] if (arm := found.given.arm) else []),
        Tag(named(Braking.omega), (cmath.rect(12.0, 1.5 * step),), 0.4),
    ]
    return Drawing(tuple(items), title).labelled(tags)


def _pivot(arm: ShoeArm, drum: float) -> complex:
    """Of the first shoe: a shoe that goes before its pivot has it behind; all turn counter-clockwise."""
    angle = -arm.shoe if arm.ahead == "shoe" else arm.shoe
    return cmath.rect(min(max(INNER * arm.pivot / drum, SHAFT + 4), BACK - 2), angle)


def _arm(turn: complex, arm: ShoeArm, drum: float) -> list[Item]:
    """The arm from its pivot to its shoe."""
    pivot = turn * _pivot(arm, drum)
    return [line(pivot, turn * BACK), Circle(pivot, 1.4, NORMAL, "white")]


def _dimension() -> list[Item]:
    """Of the radius of the mass centre, and a line to the gap."""
    lines = [line(complex(CENTRE, 0), complex(CENTRE, LOW - 2), THIN), line(0j, complex(0, LOW - 2), THIN)]
    return [*lines, *span(complex(0, LOW), complex(CENTRE, LOW)), line(29 + 2j, 36 + 6j, THIN)]


def _shoe(turn: complex, half: float) -> list[Item]:
    """A shoe at rest and its spring to the shaft."""
    angles = [half * k / 5 for k in range(-5, 6)]
    face = [cmath.rect(FACE, angle) for angle in angles]
    back = [cmath.rect(BACK, angle) for angle in reversed(angles)]
    zigzag = [complex(5 + 14 * k / 12, 1.8 * (0 if k in (0, 12) else (-1) ** k)) for k in range(13)]
    shoe = polygon([turn * z for z in (*face, *back)], NORMAL, "pale")
    return [shoe, polyline([turn * z for z in zigzag])]
