"""Mechanisms at a stated distance from a singular position: every kind of dyad, and a group of class III.

The driving link swings by `SWEEP` from an easy position to the near-singular one, which is the last of its cycle. A
`jitter` changes lengths by some per cent, so that roundings fall otherwise.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tmm_report.mechanics.lever.assembly.stated import assemble
from tmm_report.mechanics.lever.cycle import Cycle, cycle_of
from tmm_report.mechanics.lever.mechanism import Assembly, Driver, Guide, Link, Mechanism, Slide, ZeroAngle

OMEGA = 7.0
SWEEP = 0.5  # rad
GRAVITY = -9.81j
PUSH = -20 + 5j  # N, on the last link


@dataclass(frozen=True)
class Scene:
    """`build(distance, jitter)`: the mechanism, and the driver's angle in the near-singular position, rad. `of`: what
    the distance is. `push`: the link and its point on which a force acts."""

    title: str
    of: str
    build: Callable[[float, int], tuple[Mechanism, float]]
    push: tuple[str, str] = ("3", "S3")
    way: int = 1  # of rotation, towards the near-singular position

    def cycle(self, distance: float, jitter: int = 0) -> Cycle:
        mechanism, angle = self.build(distance, jitter)
        driver = Driver("1", OMEGA * self.way, ZeroAngle(angle - self.way * SWEEP), SWEEP)
        return cycle_of(assemble(replace(mechanism, driver=driver)))


def turned(angle: float) -> complex:
    return complex(np.exp(1j * angle))


def mechanism(
    links: Sequence[Link], guides: Sequence[Guide] = (), slides: Sequence[Slide] = (), key: str = ""
) -> Mechanism:
    """`key`: of the dyad with two roots, whose first is taken."""
    named, stated = {guide.name: guide for guide in guides}, (Assembly(key, 1),) if key else ()
    return Mechanism({link.name: link for link in links}, Driver("1", OMEGA), named, tuple(slides), stated)


def _length(jitter: int) -> float:
    return 0.31 * (1 + 0.013 * jitter)


def slider_crank(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """l = r (1 + d), the crank upright: the rod is nearly at right angles to the guide."""
    l, along = _length(jitter), 0.2 + 0.07 * jitter
    links = [
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": l / (1 + distance) + 0j}),
        Link("2", {"A": 0j, "B": l + 0j, "S2": 0.1 + 0.02j}, 1.1, "S2", 0.004),
        Link("3", {"B": 0j, "S3": 0.01 + 0.02j}, 0.9, "S3"),
    ]
    line = Guide("x", "0", 0j, turned(along))
    return mechanism(links, [line], [Slide("3", "x")], "B"), along + np.pi / 2


def slider_crank_limit(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """An offset slider-crank whose rod is too short for a turn, before the position where it is upright."""
    r, l, e = _length(jitter), 0.2, 0.05
    links = [
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": r + 0j}),
        Link("2", {"A": 0j, "B": l + 0j, "S2": 0.1 + 0.02j}, 1.1, "S2", 0.004),
        Link("3", {"B": 0j, "S3": 0.01 + 0.02j}, 0.9, "S3"),
    ]
    end = float(np.arcsin((l + e) / r))
    line = Guide("x", "0", 1j * e, 1 + 0j)
    return mechanism(links, [line], [Slide("3", "x")], "B"), end * (1 - distance)


def four_bar_limit(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """A double rocker before the position where rod and rocker are in line."""
    a, b, c, f = 0.3, 0.12 * (1 + 0.013 * jitter), 0.2, 0.42
    end = float(np.arccos((a * a + f * f - (b + c) ** 2) / (2 * a * f)))
    return _four_bar(a, b, c, f), end * (1 - 0.99 * distance)


def four_bar_change(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """A parallelogram but for its rod and rocker, longer by d and 2d, where all its links are nearly in line."""
    a, f = 0.1 * (1 + 0.013 * jitter), 0.3
    return _four_bar(a, f * (1 + distance), a * (1 + 2 * distance), f), np.pi


def parallelogram(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """Exactly a parallelogram, before the position in which all its links are in line."""
    a, f = 0.1 * (1 + 0.013 * jitter), 0.3
    return _four_bar(a, f, a, f), np.pi - distance


def equal_rod(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """Rod exactly as long as the crank, before the position in which both are upright."""
    made, _ = slider_crank(0.0, jitter)
    return made, 0.2 + 0.07 * jitter + np.pi / 2 - distance


def _four_bar(a: float, b: float, c: float, f: float) -> Mechanism:
    links = [
        Link("0", {"O": 0j, "C": f + 0j}),
        Link("1", {"O": 0j, "A": a + 0j}),
        Link("2", {"A": 0j, "B": b + 0j, "S2": 0.05 + 0.01j}, 1.5, "S2", 0.002),
        Link("3", {"C": 0j, "B": c + 0j, "S3": 0.1 + 0.01j}, 0.8, "S3", 0.001),
    ]
    return mechanism(links, key="B")


def slotted_short(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """A slotted link whose pivot the crank's pin passes at d of its length: a short arm."""
    a, f, at = 0.1 * (1 + 0.013 * jitter), 0.1 * (1 + 0.013 * jitter) * (1 + distance), 0.7
    return _slotted(a, f * turned(at), 0.0), at + 0.3 * distance


def slotted_offset(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """A slotted link whose slot passes its pivot nearly as far off as the crank's pin comes near."""
    a, f, at = 0.1 * (1 + 0.013 * jitter), 0.3, 0.7
    return _slotted(a, f * turned(at), (f - a) * (1 - distance)), at


def _slotted(a: float, C: complex, offset: float) -> Mechanism:
    links = [
        Link("0", {"O": 0.02 + 0.01j, "C": 0.02 + 0.01j + C}),
        Link("1", {"O": 0j, "A": a + 0j}),
        Link("2", {"A": 0j, "S2": 0.01 + 0j}, 0.3, "S2", 0.0002),
        Link("3", {"C": 0j, "S3": 0.15 + 0.02j}, 1.2, "S3", 0.01),
    ]
    return mechanism(links, [Guide("k", "3", 1j * offset, 1 + 0j)], [Slide("2", "k")], "2-3")


def crossing_guides(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """A pin where a guide of the driving link crosses a fixed one: they are nearly parallel, and the pin is far off."""
    along = 0.1 * (jitter + 1)
    links = [
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": 0.1 + 0j}),
        Link("2", {"B": 0.01j, "S2": 0.01 + 0j}, 0.3, "S2", 0.0002),
        Link("3", {"B": 0.02 + 0j, "S3": 0.15 + 0.02j}, 1.2, "S3", 0.01),
    ]
    guides = [Guide("f", "0", 0.2j, turned(along)), Guide("m", "1", 0.03j, 1 + 0j)]
    return mechanism(links, guides, [Slide("2", "m"), Slide("3", "f")]), along + distance


def flat_yoke(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """A yoke whose slot is nearly parallel to its guide: the slider runs far off."""
    links = [
        Link("0", {"O": 0j}),
        Link("1", {"O": 0j, "A": 0.1 * (1 + 0.013 * jitter) + 0j}),
        Link("2", {"A": 0.01j, "S2": 0.01 + 0j}, 0.3, "S2", 0.0002),
        Link("3", {"S3": 0.03 + 0.02j}, 1.2, "S3", 0.01),
    ]
    guides = [Guide("x", "0", 0.05j, turned(0.3)), Guide("s", "3", 0.02 - 0.01j, turned(distance))]
    return mechanism(links, guides, [Slide("2", "s"), Slide("3", "x")]), 1.1


TRIAD_ANGLE = -2.35  # rad, of the sketch
TRIAD = {"A": -0.0614 - 0.0622j, "B": 0.2092 + 0.0435j, "C": 0.1962 - 0.0491j, "D": 0.3796 - 0.0127j}


def triad(distance: float, jitter: int) -> tuple[Mechanism, float]:
    """A triad with three pivots before the position in which it is stretched to its utmost."""
    links = [
        Link("0", {"O": 0j, "E": 0.13 - 0.296j, "F": 0.464 - 0.206j}),
        Link("1", {"O": 0j, "A": 0.0874 + 0j}),
        Link("2", {"A": 0j, "B": 0.2905 * (1 + 0.002 * jitter) + 0j, "S2": 0.046 + 0.07j}, 1.57, "S2", 0.025),
        Link(
            "3", {"B": 0j, "C": 0.0935 + 0j, "D": 0.0319 + 0.1766j, "S3": 0.086 + 0.045j}, 2.18, "S3", 0.0058
        ),
        Link("4", {"C": 0j, "E": 0.2554 + 0j, "S4": 0.0735 - 0.0704j}, 3.15, "S4", 0.0336),
        Link("5", {"D": 0j, "F": 0.2108 + 0j, "S5": 0.123 - 0.021j}, 3.25, "S5", 0.0196),
    ]
    driver = Driver("1", OMEGA, ZeroAngle(TRIAD_ANGLE))
    made = replace(mechanism(links), sketch=TRIAD, driver=driver)
    end = cycle_of(assemble(made)).critical[0].limits[0]
    return made, end - 0.5 * distance


ANGLE = "angle from the limit, of itself"
SCENES = {
    "rod = crank": Scene("Slider-crank, r/l → 1 (kind 2)", "l/r − 1", slider_crank),
    "upright rod": Scene("Offset slider-crank before its limit (kind 2)", ANGLE, slider_crank_limit),
    "links in line": Scene("Four-bar before its limit (kind 1)", ANGLE, four_bar_limit),
    "nearly a parallelogram": Scene("Four-bar beside a parallelogram (kind 1)", "b/d − 1", four_bar_change),
    "parallelogram": Scene("Parallelogram before its change point (kind 1)", "angle from it, rad", parallelogram),
    "equal rod": Scene("Rod equal to crank before its change point (kind 2)", "angle from it, rad", equal_rod),
    "short arm": Scene("Slotted link, pin beside its pivot (kind 3)", "AC/a", slotted_short),
    "tangent slot": Scene("Slotted link, slot tangent (kind 3)", "1 − h/AC", slotted_offset),
    "parallel guides": Scene("Crossing guides (kind 4)", "angle, rad", crossing_guides, way=-1),
    "flat yoke": Scene("Yoke with a flat slot (kind 5)", "angle, rad", flat_yoke),
    "stretched triad": Scene("Class III before its limit", "angle from the limit, half a rad", triad),
}  # fmt: skip
