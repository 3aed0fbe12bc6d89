"""Sketches of what turns with friction, mm of paper: pivots, belts, wheels, journals, a crank; and all by the kind."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable

from tmm_report.chapters.machine.contacts import draw as plane
from tmm_report.chapters.machine.contacts.draw import FORCE, drawing, force, tag
from tmm_report.chapters.machine.contacts.solve import Found, Solved
from tmm_report.figures.drawing import (
    AXIS,
    DASHED,
    NORMAL,
    THICK,
    THIN,
    Arc,
    Arrow,
    Circle,
    Drawing,
    Item,
    Pen,
    dot,
    line,
    polygon,
)
from tmm_report.figures.schemes.marks import block, fixed_guide, ground, support, turning


def wheel(item: Solved, title: str) -> Drawing:
    """The reaction of the ground goes through a place ahead of the wheel's middle by the arm k; friction brakes a wheel
    that is pulled and pushes on one that is driven."""
    radius, arm = 20.0, 5.0
    driving = "M" in item.s
    letter = "T" if driving else "F"
    centre = 1j * radius
    items: list[Item] = [
        *ground(-30 + 0j, 34 + 0j, -1j),
        Circle(centre, radius, THICK),
        dot(centre, 1.0),
        line(centre, 0j, AXIS),
        line(centre, centre + cmath.rect(radius, math.radians(205)), THIN),
        line(complex(arm), complex(arm, -12), THIN),
        line(0j, -12j, THIN),
        Arrow(-7 - 9j, -9j, THIN, 2.0),
        Arrow(complex(arm + 7, -9), complex(arm, -9), THIN, 2.0),
        *turning(centre, radius + 4, math.radians(125), math.radians(-55)),
    ]
    arrows = [
        force(centre, -1j * 14, "N", -1),
        force(centre, -FORCE + 0j if driving else FORCE + 0j, letter, 1j),
        force(complex(arm), 17j, "N", 1),
        force(1 + 0.8j, 14 + 0j, letter, -1j) if driving else force(-1 + 0.8j, -14 + 0j, letter, 1j),
    ]
    tags = [
        tag("k", complex(arm + 8, -9), 1),
        tag("r", centre + cmath.rect(0.6 * radius, math.radians(205)), 1j),
        *([tag("M", centre + 1j * (radius + 7), 1)] if driving else []),
        *(one for _, one in arrows),
    ]
    return drawing([*items, *(arrow for arrow, _ in arrows)], tags, title)


def belt(item: Solved, title: str) -> Drawing:
    """The drum with the rope over its angle of contact; of more than a turn the rest of it is drawn."""
    radius, whole = 18.0, item.s.number("alpha")
    wrap = whole % (2 * math.pi) if whole > 2 * math.pi else whole
    wrap = wrap if wrap > 0.4 else math.pi
    start = math.pi / 2 + wrap / 2
    ends = [cmath.rect(radius, start), cmath.rect(radius, start - wrap)]
    tangents = [1j * ends[0] / radius, -1j * ends[1] / radius]
    items: list[Item] = [
        Circle(0j, radius, NORMAL),
        dot(0j),
        Arc(0j, radius + 0.6, start, start - wrap, THICK),
        *(line(0j, end, AXIS) for end in ends),
        Arc(0j, 8, start, start - wrap, THIN),
        *turning(0j, radius - 4, math.radians(295), math.radians(-50)),
    ]
    arrows = [
        force(end * (1 + 0.6 / radius), FORCE * along, text, 1j)
        for end, along, text in zip(ends, tangents, ("T_1", "T_2"), strict=True)
    ]
    tags = [tag("α", 10j, 1j), *(one for _, one in arrows)]
    return drawing([*items, *(arrow for arrow, _ in arrows)], tags, title)


def belt_drive(item: Solved, title: str) -> Drawing:
    """Both pulleys and their distance to one scale."""
    n = item.s.number
    mm = 90.0 / (n("a") + (n("d_1") + n("d_2")) / 2)
    one, other, far = n("d_1") / 2 * mm, n("d_2") / 2 * mm, n("a") * mm
    lean = math.asin((other - one) / far)
    items: list[Item] = [
        Circle(0j, one, NORMAL), Circle(complex(far), other, NORMAL), dot(0j), dot(complex(far)),
        line(complex(-one - 3), complex(far + other + 3), AXIS),
        *turning(0j, max(3.0, 0.6 * one), math.radians(200), math.radians(-120)),
    ]  # fmt: skip
    tags = [tag("a", complex(far / 2), -1j)]
    for sign, text in ((1, "T_2"), (-1, "T_1")):
        out = cmath.rect(1, sign * (math.pi / 2 + lean))
        ends = one * out, far + other * out
        items.append(line(*ends, THICK))
        tags.append(tag(text, (ends[0] + ends[1]) / 2, 1j * sign))
    tags += [tag("d_1", one * 1j, 1j), tag("d_2", complex(far, other), 1j)]
    return drawing(items, tags, title)


def journal(item: Solved, title: str) -> Drawing:
    """The journal rolls up its bearing until the reaction is tangent to the friction circle."""
    radius, circle = 18.0, 5.0
    foot = complex(circle, -math.sqrt(radius**2 - circle**2))
    items: list[Item] = [
        Circle(-2.4 * foot / radius, radius + 2.4, NORMAL),
        Circle(0j, radius, THICK),
        Circle(0j, circle, DASHED),
        dot(0j),
        line(complex(circle, -radius - 6), complex(circle, radius), AXIS),
        *turning(0j, radius + 8, math.radians(120), math.radians(-60)),
    ]
    arrows = [
        force(0j, -14j, "Q", -1),
        force(foot - 16j, 16j, "R", 1),
    ]
    tags = [tag("ρ", complex(circle / 2, 0.5), 1j), *(one for _, one in arrows)]
    return drawing([*items, *(arrow for arrow, _ in arrows)], tags, title)


def pivot(item: Solved, title: str) -> Drawing:
    """The end of the shaft in its bearing, cut along the axis."""
    n, outer = item.s.number, 20.0
    inner = outer * n("r_inner") / n("R_outer")
    deep = 0.0 if n("half_cone") == 90.0 else 1 / math.tan(_wide(n("half_cone")))
    rim, core = complex(outer, outer * deep), complex(inner, inner * deep)
    mirrored = [-z.conjugate() for z in (core, rim)]
    top = rim.imag + 22
    items: list[Item] = [
        polygon(
            (mirrored[1], mirrored[0], core, rim, complex(outer, top), complex(-outer, top)), THICK, "pale"
        ),
        *ground(mirrored[1], mirrored[0], -1j),
        *ground(core, rim, -1j),
        line(complex(0, -8), complex(0, top + 6), AXIS),
        *turning(complex(0, top + 3), 7, math.radians(200), math.radians(140)),
    ]
    load = force(complex(0, top + FORCE + 2), -1j * FORCE, "Q", 1, 0.2)
    sizes: list[Item] = [
        Arrow(0j + (rim.imag + 12) * 1j, rim + 12j, THIN, 2.0),
        *([Arrow(0j + (rim.imag + 5) * 1j, complex(inner, rim.imag + 5), THIN, 2.0)] if inner else []),
    ]
    tags = [tag("R", complex(outer / 2, rim.imag + 12), 1j), load[1]]
    tags += [tag("r", complex(inner / 2, rim.imag + 5), 1j)] if inner else []
    return drawing([*items, load[0], *sizes], tags, title)


def _wide(half_cone: float) -> float:
    return math.radians(min(max(half_cone, 30.0), 80.0))


def crank(item: Solved, title: str) -> Drawing:
    """The mechanism to scale with its friction circles enlarged, and the force that is tangent to them."""
    n = item.s.number
    mm, phi = 110.0 / (n("r") + n("l")), math.radians(n("phi"))
    length, pin, wrist = n("l") * mm, 4.0, 3.0
    at = cmath.rect(n("r") * mm, phi)
    slider = complex(at.real + math.sqrt(length**2 - at.imag**2))
    swing = 1 if math.cos(phi) > 0 else -1
    tilt = math.asin(at.imag / length) - math.asin((pin + swing * wrist) / length)
    along = cmath.rect(1, math.pi - tilt)
    across = 1j * along  # towards the shaft
    ends = slider - swing * wrist * across - 14 * along, at + pin * across + 14 * along
    items: list[Item] = [
        *support(0j), line(0j, at, THICK), line(at, slider, THICK), *block(slider, 1 + 0j),
        *fixed_guide(slider - 14, slider + 14, -1j),
        *(Circle(centre, size, DASHED) for centre, size in ((0j, 5.0), (at, pin), (slider, wrist))),
        *(Circle(centre, 1.0, NORMAL, "white") for centre in (0j, at, slider)),
        line(0j, complex(n("r") * mm), AXIS), Arc(0j, 9, 0, phi, THIN),
        Arrow(ends[0], ends[1], Pen(0.35, "red")),
    ]  # fmt: skip
    push = force(slider + 10 + FORCE, -FORCE + 0j, "F", 1j, 0.3)
    tags = [
        tag("φ", cmath.rect(11, phi / 2), 1), tag("ρ_1", -5 + 0j, -1), tag("ρ_2", at + pin * 1j, 1j),
        tag("ρ_3", slider + wrist * 1j, 1j), push[1],
    ]  # fmt: skip
    return drawing([*items, push[0]], tags, title)


SKETCHES: dict[str, Callable[[Solved, str], Drawing]] = {
    **plane.SKETCHES, "pivot": pivot, "belt": belt, "belt_drive": belt_drive, "wheel": wheel, "journal": journal,
    "crank": crank,
}  # fmt: skip


def picture(found: Found) -> Drawing:
    """The first pair that has a sketch."""
    drawn = [item for item in found.items if item.kind in SKETCHES]
    return SKETCHES[drawn[0].kind](drawn[0], "") if drawn else Drawing(())
