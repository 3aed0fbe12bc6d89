"""The angle of a link that turns, from position 0 and without jumps of a turn, and its extremes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.cycle import Cycle, Extreme, least_and_greatest
from tmm_report.mechanics.lever.meeting import AT
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.records import dataclass

Array = Any

SAME = 1e-9  # of turned unit vectors: position N of a full turn is position 0
HALF_TURN = 1e-6  # rad: a jump as near to half a turn as this may be one either way


def swing(
    cycle: Cycle, link: str, motions: Sequence[Motion], reference: float, stops: Array
) -> tuple[list[Array], tuple[Extreme, Extreme]]:
    """Angles of a link from position 0, rad, at the positions of each of the motions, which are equal steps of the
    cycle, and the exact extremes over the cycle; of what goes all round, the ends. `stops`: angles turned at which it
    stands still; `reference`: its direction at the first position, rad."""
    fine = np.linspace(0, cycle.period, 360 * cycle.turns + 1)
    where = np.sort(np.concatenate([fine, cycle.repeated(stops), cycle.repeated(cycle.ends)]))
    if cycle.corners.size or cycle.meets:
        beside = np.mod(cycle.search[0], cycle.sweep)
        found = _followed(cycle, link, np.union1d(where, cycle.repeated(beside)))
        if found is not None:
            return [found.at(m.turn(link)) for m in motions], found.extremes
    angle = _unwrapped(cycle.motion(where).turn(link), reference)
    return [_unwrapped(m.turn(link), reference) for m in motions], least_and_greatest(angle, where)


def first(values: Array) -> Any:
    """The value at the first position that exists: position 0, where the mechanism closes there."""
    return values[np.argmax(np.isfinite(values))]


def _unwrapped(u: Array, reference: float) -> Array:
    """Angle from the first position, rad, continuous along the positions that exist."""
    angle = np.angle(u * np.exp(-1j * reference))
    exists = np.isfinite(angle)
    angle[exists] = np.unwrap(angle[exists])
    if (
        not exists.all() and abs(u[-1] - u[0]) < SAME
    ):  # what lies behind a gap is reached backwards over position 0
        behind = np.flatnonzero(~exists)[-1] + 1
        angle[behind:] += angle[0] - angle[-1]
    return angle - first(angle)


# ---------------------------------------------------------------- over corners and change points


@dataclass(frozen=True, eq=False)
class _Followed:
    """A link followed over the cycle: its directions `u` and angles from position 0 at angles turned `x`, ascending,
    rad; in a corner first those before it, `side` -1, then those after it, +1."""

    x: Array
    u: Array
    angle: Array
    side: Array

    @property
    def extremes(self) -> tuple[Extreme, Extreme]:
        return least_and_greatest(self.angle, self.x, side=self.side)

    def at(self, u: Array) -> Array:
        """Its angles where it has the directions `u` at equal steps of the cycle, rad."""
        turned = np.arange(len(u)) * (self.x[-1] / (len(u) - 1))
        before = np.maximum(np.searchsorted(self.x, turned - 2 * AT, side="right") - 1, 0)
        return self.angle[before] + np.angle(u / self.u[before])


def _followed(cycle: Cycle, link: str, where: Array) -> _Followed | None:
    """The link at the angles turned `where` and on both sides of every corner; None where the mechanism is not.

    Beside a change point a link may turn nearly all round within a fraction of a degree: `where` is dense there.
    """
    off = np.abs(np.angle(np.exp(1j * (where[:, None] - cycle.corners)))).min(axis=-1, initial=np.inf)
    x = where[off > 2 * AT]
    parts: list[tuple[Array, Array, Array]] = [(x, cycle.motion(x).turn(link), np.zeros(x.shape, dtype=int))]
    for corners, of in cycle.sides if cycle.corners.size else ():
        at = cycle.repeated(corners)
        parts.append((at, np.tile(cycle.beside(corners, of).turn(link), cycle.turns), np.full(at.shape, of)))
    x, u, side = (np.concatenate(part) for part in zip(*parts, strict=True))
    order = np.lexsort((side, x))
    x, u, side = x[order], u[order], side[order]
    if not np.isfinite(u).all():
        return None
    steps = np.angle(u[1:] / u[:-1])
    jumps = (side[:-1] < 0) & (side[1:] > 0)
    # half a turn may be made either way: back, so that after the turn the link is where it began
    drift = np.sum(steps[~jumps])
    back = jumps & (np.abs(steps) > np.pi - HALF_TURN)
    steps[back] = -np.copysign(np.abs(steps[back]), drift)
    return _Followed(x, u, np.concatenate([[0.0], np.cumsum(steps)]), side)
