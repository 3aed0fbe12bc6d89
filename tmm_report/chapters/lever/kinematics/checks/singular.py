"""Singular positions exactly: how near each group comes to one, change points, limits, dead points.

Angles here are those of turn from position 0, rad, over one cycle.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Protocol

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, unit
from tmm_report.mechanics.lever.cycle import Cycle, Extreme, Quantity, Slope
from tmm_report.mechanics.lever.dyads import Dyad
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.mechanics.lever.singular import Critical
from tmm_report.records import dataclass

Array = Any
FULL_TURN = 2 * np.pi


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
    turned = cycle.turned_at(phi)
    turned = np.where(FULL_TURN - turned < 1e-9, 0.0, turned)
    return tuple(float(x) for x in np.sort(turned[turned <= cycle.sweep + 1e-9]))
