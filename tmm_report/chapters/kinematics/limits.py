"""Singular positions in words: where a group cannot be assembled and what would cure it, change points, dead points.

Angles here are those of turn from position 0, rad, over one cycle.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from tmm_report.mechanics.cycle import Cycle, Extreme, Quantity, Slope
from tmm_report.mechanics.dyads import Dyad
from tmm_report.mechanics.motion import Motion
from tmm_report.mechanics.planar import cross, unit
from tmm_report.mechanics.singular import Critical
from tmm_report.problems import N_, Message, Problem, mistake

Array = Any
Interval = tuple[float, float]
FULL_TURN = 2 * np.pi


@dataclass(frozen=True)
class Gap:
    """A group that cannot be assembled over part of the cycle: why, and what would cure it."""

    group: str  # label
    links: tuple[str, ...]
    intervals: tuple[Interval, ...]
    why: Message
    cure: Message

    @property
    def text(self) -> Message:
        """E.g. "rod AB = 50 mm cannot reach guide x for 30° < φ < 150°; it needs at least 100 mm"."""
        return Message(
            N_("%(why)s for %(where)s (φ is the angle of turn from position 0); %(cure)s"),
            {"why": self.why, "where": angles(self.intervals), "cure": self.cure},
        )

    @property
    def problem(self) -> Problem:
        """The group that cannot be assembled at all, as a mistake."""
        text = N_("%(why)s at any position")
        return mistake(text, ("mechanism", "links", self.links[0]), self.cure, why=self.why)


@dataclass(frozen=True, eq=False)
class Closest:
    """How near a group comes to a singular position: `closeness` 1 … 0 and where; its exact singular positions.

    `corners`: those of the change points that are not passed smoothly.
    """

    group: str
    links: tuple[str, ...]
    is_dyad: bool
    closeness: Extreme
    changes: tuple[float, ...]
    limits: tuple[float, ...]
    parallel: tuple[float, ...]
    corners: tuple[float, ...]


class Moving(Protocol):
    """An output as a function of the motion: its velocity, and a speed beside which that is more than rounding."""

    @property
    def name(self) -> str: ...

    @property
    def link(self) -> str: ...

    def velocity(self, motion: Motion) -> Array: ...

    def size(self, motion: Motion) -> Array: ...


@dataclass(frozen=True)
class Dead:
    """Where an output link stands still: a dead point, were it to drive. `in_line`: links in one line there, if so."""

    output: str
    turned: tuple[float, ...]
    in_line: tuple[tuple[str, str] | None, ...]


def angles(intervals: tuple[Interval, ...]) -> str:
    """ "30.00° < φ < 150.00°", several joined by commas."""
    return ", ".join(f"{np.degrees(a):.2f}° < φ < {np.degrees(b):.2f}°" for a, b in intervals)


def gaps(cycle: Cycle) -> tuple[Gap, ...]:
    """Every group that cannot be assembled over part of the cycle."""
    found = []
    for critical in cycle.critical:
        intervals = tuple(sorted(_turned_intervals(cycle, critical)))
        if intervals:
            why, cure = _cause(critical)
            found.append(Gap(critical.group.group.label, critical.group.links, intervals, why, cure))
    return tuple(found)


def closest(cycle: Cycle) -> tuple[Closest, ...]:
    """Of every group the position nearest to a singular one, exactly, and its singular positions."""
    if not cycle.critical:
        return ()
    sines = [sine_of(critical.group.group.label) for critical in cycle.critical]
    extremes = cycle.extremes_of(sines, cycle.roots_of([Slope(sine) for sine in sines]))
    return tuple(nearest(cycle, c, least) for c, (least, _) in zip(cycle.critical, extremes, strict=True))


def sine_of(label: str) -> Quantity:
    """The sine of a group's transmission angle, as a function of the motion."""
    return lambda motion: motion.sines[label]


def nearest(cycle: Cycle, critical: Critical, at: Extreme) -> Closest:
    group = critical.group
    zeros = [_turned(cycle, part) for part in (critical.changes, critical.limits, critical.parallel)]
    if any(zeros):
        at = Extreme(0.0, min(x for part in zeros for x in part))
    corner = group.corner if isinstance(group, Dyad) else None
    zeros.append(() if corner is None else _turned(cycle, (corner,)))
    return Closest(group.group.label, group.links, isinstance(group, Dyad), at, *zeros)


def dead(cycle: Cycle, outputs: Sequence[Moving]) -> tuple[Dead, ...]:
    """Dead points of outputs, exactly; none of one that stands still beside its `size` all round."""
    moving = [output for output in outputs if cycle.moves(output.velocity, output.size)]
    found = dict(zip((o.name for o in moving), cycle.roots_of([o.velocity for o in moving]), strict=True))
    still = [found.get(output.name, np.array([])) for output in outputs]
    return tuple(
        told(output, turned, cycle.motion(turned)) for output, turned in zip(outputs, still, strict=True)
    )


def told(output: Moving, turned: Array, motion: Motion) -> Dead:
    """Dead points of an output at angles turned, and which links lie in line there, by the motion there."""
    lines = [_in_line(motion, k, output.link) for k in range(len(turned))]
    return Dead(output.name, tuple(turned.tolist()), tuple(lines))


def _in_line(motion: Motion, k: int, output: str) -> tuple[str, str] | None:
    """The driving link and a link pivoted to it, if their joints lie in one line: of several the one that moves the
    output link itself."""
    mechanism, found = motion.linkage.mechanism, list(_lines(motion, k))
    joints = mechanism.links[output].points
    nearest = (pair for pair in found if any(point in joints for point in mechanism.links[pair[1]].points))
    return next(nearest, next(iter(found), None))


def _lines(motion: Motion, k: int) -> Iterator[tuple[str, str]]:
    mechanism, pair = motion.linkage.mechanism, motion.linkage.structure.driver_pair
    driver = mechanism.driver.link
    for link in mechanism.moving:
        pins = [
            p for p in mechanism.links[link].points if p in mechanism.links[driver].points and link != driver
        ]
        ends = [p for p in mechanism.links[link].points if p not in pins and len(mechanism.links_at(p)) > 1]
        if pins and ends:
            O, A, B = (motion.place(p)[k] for p in (pair.name, pins[0], ends[0]))
            if abs(O - A) > 0 and abs(B - A) > 0 and abs(cross(unit(A - O), unit(B - A))) < 1e-6:
                yield driver, link


def _turned(cycle: Cycle, phi: tuple[float, ...]) -> tuple[float, ...]:
    """Driver angles as angles of turn from position 0, those within the cycle, ascending."""
    turned = np.mod(cycle.sense * (np.array(phi) - cycle.zero), FULL_TURN)
    turned = np.where(FULL_TURN - turned < 1e-9, 0.0, turned)
    return tuple(float(x) for x in np.sort(turned[turned <= cycle.sweep + 1e-9]))


def _turned_intervals(cycle: Cycle, critical: Critical) -> Iterator[Interval]:
    """Intervals without the group, within the cycle; one across position 0 goes on beyond a turn."""
    for first, last in critical.gaps:
        width = last - first
        if width >= FULL_TURN - 1e-12:
            yield 0.0, cycle.sweep
            continue
        start = np.mod((first if cycle.sense > 0 else -last) - cycle.sense * cycle.zero, FULL_TURN)
        if cycle.closed:
            yield float(start), float(start + width)
            continue
        for low in (start, start - FULL_TURN):
            a, b = max(low, 0.0), min(low + width, cycle.sweep)
            if a < b:
                yield float(a), float(b)


# ---------------------------------------------------------------- causes and cures


def _cause(critical: Critical) -> tuple[Message, Message]:
    d = critical.group
    if not isinstance(d, Dyad):
        why = Message(N_("group %(group)s cannot be assembled"), {"group": d.group.label})
        links = {"links": ", ".join(d.links)}
        return why, Message(
            N_("between its limit positions the lengths of links %(links)s do not suffice"), links
        )
    low, high = critical.reach or (0.0, 0.0)
    return {1: _two_rods, 2: _rod_to_guide, 3: _guide_past_joint}[d.kind](d, low, high)


def _rod_to_guide(d: Dyad, low: float, high: float) -> tuple[Message, Message]:
    rod = d.outer_a.name + d.inner.name
    why = Message(
        N_("rod %(rod)s = %(length)s cannot reach guide %(guide)s"),
        {"rod": rod, "length": _length(abs(d.arm_a)), "guide": d.outer_b.name},
    )
    text = N_("joint %(a)s goes as far as %(need)s from its line: the rod needs at least %(need)s")
    return why, Message(text, {"a": d.outer_a.name, "need": _length(high)})


def _two_rods(d: Dyad, low: float, high: float) -> tuple[Message, Message]:
    a, b, c = d.outer_a.name, d.inner.name, d.outer_b.name
    p, q = abs(d.arm_a), abs(d.arm_b)
    why = Message(
        N_("links %(a)s%(b)s = %(p)s and %(c)s%(b)s = %(q)s do not meet"),
        {"a": a, "b": b, "c": c, "p": _length(p), "q": _length(q)},
    )
    # lengths that differ by less than this from what is needed print alike
    far, near = high > (p + q) * (1 + 1e-9), low < abs(p - q) * (1 - 1e-9)
    values = {"a": a, "c": c, "far": _length(high), "near": _length(low)}
    if far and near:
        text = N_(
            "the distance of joints %(a)s and %(c)s is from %(near)s to %(far)s: together the links need at least "
            "%(far)s, and they may differ by at most %(near)s"
        )
    elif near:
        text = N_("joints %(a)s and %(c)s come as near as %(near)s: the links may differ by at most %(near)s")
    else:
        text = N_(
            "joints %(a)s and %(c)s go as far as %(far)s apart: together the links need at least %(far)s"
        )
    return why, Message(text, values)


def _guide_past_joint(d: Dyad, low: float, high: float) -> tuple[Message, Message]:
    why = Message(
        N_("guide %(guide)s does not reach joint %(c)s"), {"guide": d.inner.name, "c": d.outer_b.name}
    )
    text = N_(
        "joints %(a)s and %(c)s come as near as %(near)s: the guide may pass them at a distance of at most %(near)s"
    )
    return why, Message(text, {"a": d.outer_a.name, "c": d.outer_b.name, "near": _length(low)})


def _length(metres: float) -> Message:
    """A length in the unit in which it is written: mm in a mechanism of ordinary size."""
    if 1e-5 <= metres < 100:
        return Message(N_("%(x).6g mm"), {"x": 1e3 * metres})
    return Message(N_("%(x).6g m"), {"x": metres})
