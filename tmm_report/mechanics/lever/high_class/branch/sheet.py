"""The sheet of a group's assemblies on which its motion lies: from position 0 in the sense of rotation to the first
limit, and what is reached backwards from position 0, as far as the two do not meet.

Angles `x` here are turned from the position from which the branch was followed, in the sense of rotation, rad.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.high_class.branch.curve import Curve, Node
from tmm_report.mechanics.lever.high_class.branch.known import Known
from tmm_report.mechanics.lever.high_class.branch.trace import Interval, Trace, trace
from tmm_report.mechanics.lever.loop_equations import Loops
from tmm_report.records import dataclass

Array = Any
FULL_TURN = 2 * np.pi
SAME = 1e-6  # rad: assemblies after a turn that are one
ROUND = 1e-12  # rad: angles beside position 0 that are it


@dataclass(frozen=True, eq=False)
class Run:
    """How far a group goes from the position in which it was followed; angles turned from there, rad, ≥ 0.

    `zero`: driver angle of that position; `sense` of rotation. `forward`: its first limit in the sense of rotation,
    `backward`: the one behind it, counted backwards; None where there is none within the turn. `overlaps`: what is
    found backwards lies over what is found forwards: another assembly, not reached. `returns`: False where a turn
    without limits ends in another assembly. `blocked`: whether the forward, the backward end are those of the links
    before the group.
    """

    zero: float
    sense: int
    forward: float | None
    backward: float | None
    overlaps: bool
    returns: bool
    blocked: tuple[bool, bool]
    sweep: float = FULL_TURN

    @property
    def whole(self) -> bool:
        """Whether the group goes all round, and is then as it was."""
        return self.forward is None and self.returns

    @property
    def lost(self) -> Interval | None:
        """Angles turned between which the group is not, within the sweep; None where it is everywhere."""
        if self.forward is None:
            return None
        behind = self.sweep < FULL_TURN or self.overlaps or self.backward is None
        last = self.sweep if behind else FULL_TURN - (self.backward or 0.0)
        return (self.forward, last) if self.forward < last else None


@dataclass(frozen=True, eq=False)
class Branch:
    """A group followed over the turn: `q` (N, k) at angles `x` (N,), ascending, with the tangent `by_x`, `by_q` of the
    curve there, of length 1. `room`: how far from the cubic between two nodes its own root may lie, (N − 1,).
    `changes`: driver angles at which another branch crosses, rad.
    """

    run: Run
    x: Array
    q: Array
    by_x: Array
    by_q: Array
    room: Array
    changes: tuple[float, ...]

    @property
    def returns(self) -> bool:
        return self.run.returns

    @property
    def limits(self) -> tuple[float | None, float | None]:
        """Driver angles of the limits met forwards and backwards, rad."""
        run = self.run
        ends = (run.forward, None if run.backward is None else -run.backward)
        return tuple(None if x is None else run.zero + run.sense * x for x in ends)  # type: ignore[return-value]

    def turned(self, phi: Array) -> Array:
        """Angles from where the branch begins, nan where it is not; those behind position 0 below zero."""
        raw = self.run.sense * (phi - self.run.zero)
        x = np.mod(raw, FULL_TURN)
        x = np.where(FULL_TURN - x < ROUND, 0.0, x)
        if not self.run.returns:  # the end of the turn is another assembly than its beginning
            x = np.where(np.abs(raw - FULL_TURN) < ROUND, FULL_TURN, x)
        low, high = self.x[0], self.x[-1]
        behind = (x > high) if self.run.forward is not None else (x > max(high, self.run.sweep))
        x = np.where(behind & (x - FULL_TURN >= low), x - FULL_TURN, x)
        return np.where((x >= low) & (x <= high), x, np.nan)

    def guess(self, phi: Array) -> Array:
        """q near driver angles `phi`, (..., P, k), by the cubics between the nodes; nan beyond the ends."""
        return self.near(phi)[0]

    def near(self, phi: Array) -> tuple[Array, Array]:
        """q near driver angles, (..., P, k), and how far from it the branch's own root may be, (..., P)."""
        x = self.turned(np.asarray(phi, dtype=float))
        i = np.clip(np.searchsorted(self.x, x, side="right") - 1, 0, len(self.x) - 2)
        length = self._lengths[i]
        u = _part(x - self.x[i], self.x[i + 1] - self.x[i], length * self.by_x[i], length * self.by_x[i + 1])
        q = self._cubic(i, u[..., None], length[..., None])
        ends = np.minimum(np.where(self._special[i], u, 1.0), np.where(self._special[i + 1], 1 - u, 1.0))
        return np.where(np.isnan(x)[..., None], np.nan, q), self.room[i] * ends

    def _cubic(self, i: Array, u: Array, length: Array) -> Array:
        a, b, rise = length * self.by_q[i], length * self.by_q[i + 1], self.q[i + 1] - self.q[i]
        return self.q[i] + u * (a + u * (3 * rise - 2 * a - b + u * (a + b - 2 * rise)))

    @cached_property
    def _lengths(self) -> Array:
        chord = np.hypot(np.diff(self.x), np.linalg.norm(np.diff(self.q, axis=0), axis=-1))
        turn = np.diff(self.by_x) ** 2 + np.sum(np.diff(self.by_q, axis=0) ** 2, axis=-1)
        return chord * (1 + turn / 24)

    @cached_property
    def _special(self) -> Array:
        """Nodes in which the group itself is singular: its limits and change points."""
        special = self.by_x < 1e-6
        special[-1] &= not self.run.blocked[0]
        special[0] &= not self.run.blocked[1]
        if self.changes:
            turned = self.run.sense * (np.array(self.changes) - self.run.zero)
            own = np.mod(turned - self.x[0], FULL_TURN) + self.x[0]
            special |= np.abs(self.x[:, None] - own).min(axis=1) < 1e-9
        return special


def _part(rise: Array, whole: Array, a: Array, b: Array) -> Array:
    """Where, part u of the way, a cubic that rises from 0 to `whole` with slopes a, b has the value `rise`: each step
    solves the parabola, which beside a limit is what the cubic is."""
    c2, c3 = 3 * whole - 2 * a - b, a + b - 2 * whole
    u = rise / whole
    for _ in range(6):
        left = rise - u * (a + u * (c2 + u * c3))
        slope, bend = a + u * (2 * c2 + 3 * u * c3), 2 * c2 + 6 * u * c3
        root = np.sqrt(np.maximum(slope**2 + 2 * bend * left, 0.0))
        step = 2 * left / np.maximum(slope + root, 1e-300)
        u = np.clip(u + step, 0.0, 1.0)
    return u


# ---------------------------------------------------------------- following


def follow(
    loops: Loops,
    known: Known,
    phi: float,
    q: Array,
    sense: int = 1,
    sweep: float = FULL_TURN,
    walls: Sequence[Interval] = (),
) -> Branch:
    """The branch through `q` at driver angle `phi`, rad, followed in the sense of rotation over the sweep, and back."""
    curve = Curve(loops, known)
    start = curve.start(phi, q, sense)
    if start is None or abs(start.t[-1]) < 1e-9:
        return _nowhere(phi, np.asarray(q), sense)
    margin = 0.0 if sweep >= FULL_TURN - ROUND else BESIDE
    ahead = trace(curve, start, sense, sweep + margin, walls)
    back = None
    turned = sense * (ahead.nodes[-1].phi - phi)
    ended = turned < sweep
    if ended or margin:
        backward = curve.start(phi, q, -sense)
        assert backward is not None
        back = trace(curve, backward, -sense, FULL_TURN if ended and not margin else margin, walls)
    returns = ended or bool(margin) or _same(curve, ahead, start, sense)
    return _branch(start, ahead, back, sense, sweep, returns)


BESIDE_WALL = 0.02  # of q
BESIDE = 0.15  # rad beyond the ends of a range that limits and differences there may ask for


def _same(curve: Curve, ahead: Trace, start: Node, sense: int) -> bool:
    """Whether a full turn brings back the same assembly."""
    one, other = ahead.nodes[-2:] if len(ahead.nodes) > 1 else (start, start)
    part = (sense * (start.phi - one.phi) + FULL_TURN) / (sense * (other.phi - one.phi))
    z = one.z + part * (other.z - one.z)
    z[-1] = start.phi + sense * FULL_TURN
    found = curve.closed(z, np.eye(len(z))[-1])
    if found is None:
        return False
    n = curve.angles
    gap = [np.exp(1j * found[0][:n]) - np.exp(1j * start.z[:n]), (found[0] - start.z)[n:-1]]
    return bool(np.abs(np.concatenate(gap)).max() < SAME)


def _branch(start: Node, ahead: Trace, back: Trace | None, sense: int, sweep: float, returns: bool) -> Branch:
    behind = list(reversed(back.nodes[1:])) if back is not None else []
    nodes = [*behind, *ahead.nodes]
    turn = np.array([-1.0] * len(behind) + [1.0] * len(ahead.nodes))[:, None]
    z, t = np.array([node.z for node in nodes]), turn * np.array([node.t for node in nodes])
    x = sense * (z[:, -1] - start.phi)
    changes = [ahead.nodes[n].phi for n in ahead.changes]
    forward = float(x[-1]) if x[-1] < sweep else None
    backward = None
    if back is not None and forward is not None and sweep >= FULL_TURN - ROUND:
        changes += [back.nodes[n].phi for n in back.changes]
        backward = float(-x[0]) if -x[0] < FULL_TURN else None
    overlaps = (
        forward is not None
        and sweep >= FULL_TURN - ROUND
        and (backward is None or forward + backward >= FULL_TURN)
    )
    run = Run(
        start.phi, sense, forward, backward, overlaps, returns,
        (ahead.blocked, back is not None and back.blocked), sweep,
    )  # fmt: skip
    if overlaps:
        first = len(behind)
        z, t, x = z[first:], t[first:], x[first:]
    by_x = np.maximum(sense * t[:, -1], 0.0)
    return _ascending(run, x, z[:, :-1], by_x, t[:, :-1], tuple(changes))


def _ascending(run: Run, x: Array, q: Array, by_x: Array, by_q: Array, changes: tuple[float, ...]) -> Branch:
    """Without nodes that rounding has put on one angle."""
    keep = np.concatenate([[True], np.diff(np.maximum.accumulate(x)) > 0])
    if not keep[-1] and keep.sum() > 1:  # the limit itself stays, the node beside it goes
        keep[np.flatnonzero(keep)[-1]] = False
        keep[-1] = True
    x, q, by_x, by_q = x[keep], q[keep], by_x[keep], by_q[keep]
    if len(x) < 2:
        return _nowhere(run.zero, q[0], run.sense)
    chord = np.sqrt(np.diff(x) ** 2 + np.sum(np.diff(q, axis=0) ** 2, axis=-1))
    return Branch(run, x, q, by_x, by_q, _room(run, q, 0.25 * chord), changes)


def _room(run: Run, q: Array, room: Array) -> Array:
    """Where the links before the group end, its own contours are regular: there it is not the steps that tell."""
    for blocked, end in zip(run.blocked, (q[-1], q[0]), strict=True):
        if blocked:
            beside = np.abs(q[:-1] - end).max(axis=-1) < BESIDE_WALL
            room = np.where(beside, np.maximum(room, BESIDE_WALL / 10), room)
    return room


def _nowhere(phi: float, q: Array, sense: int) -> Branch:
    """Of a group that is singular where it should begin: that position alone."""
    run = Run(phi, sense, 0.0, 0.0, False, True, (False, False))
    x = np.array([0.0, 1e-15])
    none = np.zeros((2, len(q)))
    return Branch(run, x, np.array([q, q]), np.ones(2), none, np.zeros(1), ())
