"""Assur groups above class II: Newton's method on their own loop equations, along one branch that is proved.

A group is followed once over the cycle from the assembly of the sketch. Each step is so short that by the
Newton–Kantorovich theorem just one root lies near the prediction, on the branch it came from:

    h = β·K·η ≤ 1/2,   β = ‖J⁻¹‖,  K bounds the second derivatives of the contours,  η the first Newton step

The branch ends where J becomes singular and the links stretch to their limit; where two branches cross (a change
point), it goes straight on. Any position is then solved from the nearest node in two or three Newton steps, all at
once. Source: Ortega, Rheinboldt, Iterative solution of nonlinear equations in several variables, 12.6 (Kantorovich).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.dyads import State
from tmm_report.mechanics.loops import Loops, newton, solve_each
from tmm_report.mechanics.structure import Group, Pair

Array = Any
Known = Callable[
    [Array], State
]  # driver angles (P,) -> the links before the group, rates by the driver's angle

STEP = 0.1  # longest step of the driving link, rad: what the cubic between two nodes can bridge
NEAR = 2e-3  # rad; a step this short means that a singular position is ahead
LEAST = 1e-6  # rad: nearer to a singular point than that the branch is not followed
FULL_TURN = 2 * np.pi


@dataclass(frozen=True, eq=False)
class Limit:
    """The limit of assembly: driver angle `phi`, rad, and `q` in it. Before it, q goes with τ = √|φ − phi|."""

    phi: float
    q: Array

    def guess(self, phi: Array, node: float, q: Array, slope: Array) -> Array:
        """q between a node and the limit: the parabola in τ through both, with the node's slope."""
        far, tau = np.sqrt(np.abs(node - self.phi)), np.sqrt(np.abs(phi - self.phi))[..., None]
        by_tau = slope * 2 * far * np.sign(node - self.phi)
        bend = (by_tau * far - (q - self.q)) / far**2
        return self.q + tau * ((q - self.q) / far - bend * far) + tau**2 * bend


@dataclass(frozen=True, eq=False)
class Branch:
    """A group followed over the cycle: `q` (N, k) and its slope by the driver angle, at ascending angles `phi`, rad.

    `limits`: at its lower and upper end, None where it goes all round. `changes`: angles at which another branch
    crosses. `returns`: whether a full turn brings back the same assembly.
    """

    phi: Array
    q: Array
    slope: Array
    limits: tuple[Limit | None, Limit | None]
    changes: tuple[float, ...]
    returns: bool

    @property
    def ends(self) -> tuple[float, float] | None:
        """Driver angles of the limits, the lower first, rad; None where the branch goes all round."""
        low, high = self.limits
        return (low.phi, high.phi) if low is not None and high is not None else None

    def guess(self, phi: Array) -> Array:
        """q near driver angles `phi`, (..., P, k), by the cubic between the nodes; nan beyond the ends."""
        low, high = self.ends or (self.phi[0], self.phi[-1])
        x = low + np.mod(phi - low, FULL_TURN)
        x = np.where((x > high) & (x - FULL_TURN > low - 1e-12), low, x)  # rounding at the seam of the turn
        i = np.clip(np.searchsorted(self.phi, x, side="right") - 1, 0, len(self.phi) - 2)
        h = self.phi[i + 1] - self.phi[i]
        t = ((x - self.phi[i]) / h)[..., None]
        h = h[..., None]
        q = (
            (1 + 2 * t) * (1 - t) ** 2 * self.q[i]
            + t * (1 - t) ** 2 * h * self.slope[i]
            + t * t * (3 - 2 * t) * self.q[i + 1]
            + t * t * (t - 1) * h * self.slope[i + 1]
        )
        for limit, end, beyond in zip(self.limits, (0, -1), (x < self.phi[0], x > self.phi[-1]), strict=True):
            if limit is not None and beyond.any():
                near = limit.guess(x, self.phi[end], self.q[end], self.slope[end])
                q = np.where(beyond[..., None], near, q)
        return np.where(((x >= low) & (x <= high))[..., None], q, np.nan)


@dataclass(frozen=True, eq=False)
class HigherGroup:
    """A group of class III, IV or above in the assembly `start`: (driver angle, rad; q there).

    `known`: motion of the links before it; one such function a variant. `own`: of several variants at once, the loops
    of each alone.
    """

    group: Group
    loops: Loops
    start: tuple[tuple[float, Array], ...]
    known: tuple[Known, ...]
    own: tuple[Loops, ...] = ()

    @property
    def links(self) -> tuple[str, ...]:
        return self.group.links

    @property
    def references(self) -> Mapping[str, Pair]:
        return self.loops.references

    @cached_property
    def branches(self) -> tuple[Branch, ...]:
        """The branch of every variant."""
        each = zip(self.own or (self.loops,), self.known, self.start, strict=True)
        return tuple(follow(loops, known, *start) for loops, known, start in each)

    @property
    def changes(self) -> tuple[float, ...]:
        return self.branches[0].changes

    def place(self, s: State) -> None:
        """Add the poses of the links to the state; nan where the group cannot be assembled."""
        phi = np.asarray(s.phi, dtype=float)
        if len(self.branches) == 1:
            guess = self.branches[0].guess(phi)
        else:
            rows = np.broadcast_to(phi, np.broadcast_shapes(phi.shape, (len(self.branches), 1)))
            axis = rows.ndim - 2
            parts = [b.guess(np.take(rows, v, axis=axis)) for v, b in enumerate(self.branches)]
            guess = np.stack(parts, axis=axis)
        q = newton(self.loops, s, guess)
        # next to a change point Newton's method may slip to the other branch, or not settle
        with np.errstate(invalid="ignore"):
            astray = ~(np.abs(q - guess).max(axis=-1) < 1e-3)
        self.loops.place(s, np.where(astray[..., None], guess, q))

    def move(self, s: State) -> None:
        """Add the rates of the links to the state."""
        self.loops.move(s, self.loops.read(s))

    def closeness(self, s: State) -> Array:
        """Smallest singular value of the scaled Jacobian, (..., P)."""
        return self.loops.closeness(s, self.loops.read(s))


# ---------------------------------------------------------------- following a branch


@dataclass(frozen=True, eq=False)
class _Node:
    phi: float
    q: Array
    slope: Array
    bend: Array  # second derivative of q by the angle
    reach: float  # how far the next step may go by the theorem, rad
    sign: float  # of det J
    sine: float
    left: Array  # left singular vector of J for its smallest singular value
    right: Array
    across: float  # part of the contours' change with the angle that J can hardly make up for


def follow(loops: Loops, known: Known, phi: float, q: Array) -> Branch:
    """The branch through `q` at driver angle `phi`: a full turn, or between the limits on both sides of it."""
    follower = _Follower(loops, known)
    start = follower.node(phi, q)
    up, high = follower.run(start, +1)
    if abs(up[-1].phi - phi) > FULL_TURN - 1e-9:
        gap = np.concatenate(
            [
                np.exp(1j * up[-1].q[: loops.angles]) - np.exp(1j * q[: loops.angles]),
                (up[-1].q - q)[loops.angles :],
            ]
        )
        return _branch(up, (None, None), follower.changes, bool(np.abs(gap).max() < 1e-6))
    down, low = follower.run(start, -1)
    return _branch([*reversed(down[1:]), *up], (low, high), follower.changes, True)


def _branch(
    nodes: list[_Node], limits: tuple[Limit | None, Limit | None], changes: list[float], returns: bool
) -> Branch:
    phi, q, slope = (np.array([getattr(node, name) for node in nodes]) for name in ("phi", "q", "slope"))
    return Branch(phi, q, slope, limits, tuple(sorted(changes)), returns)


def _ended(nodes: list[_Node]) -> Limit:
    """Where a branch ends that could be followed no further: at a limit the square of the sine falls linearly to 0."""
    node, before = nodes[-1], nodes[max(len(nodes) - 2, 0)]
    fall = before.sine**2 - node.sine**2
    ahead = (node.phi - before.phi) * node.sine**2 / fall if fall > 0 else 0.0
    return Limit(node.phi + ahead, node.q + ahead * node.slope)


class _Follower:
    def __init__(self, loops: Loops, known: Known):
        self.loops, self.known = loops, known
        self.changes: list[float] = []

    def node(self, phi: float, q: Array, s: State | None = None) -> _Node:
        """Slope and allowed step at a point of the branch."""
        s = self.known(np.array([phi])) if s is None else s
        J = self.loops.jacobian(s, q[None])[0]
        turned = self.loops.known_rate(s, q[None])[0]
        left, sines, right = np.linalg.svd(J)
        slope = -right.T @ ((left.T @ turned) / sines)
        bent = self.loops.bend(s, q[None], slope[None])[0]
        bend = -right.T @ ((left.T @ bent) / sines)
        beta, K = 1 / sines[-1], self._second_derivatives(q)
        # β at most doubles on the step; then h = 2β·K·(|bent|·step²/2)·2β ≤ 1/2
        reach = 1 / (2 * beta * max(2 * K * np.linalg.norm(slope), np.sqrt(K * np.linalg.norm(bent)), 1e-9))
        across = abs(left[:, -1] @ turned) / (np.linalg.norm(turned) or 1.0)
        return _Node(
            phi, q, slope, bend, float(min(reach, STEP)), float(np.sign(np.linalg.det(J))), float(sines[-1]),
            left[:, -1], right[-1], float(across),
        )  # fmt: skip

    def _second_derivatives(self, q: Array) -> float:
        """Bound K of the second derivatives of the contours by q near a point: arms and displacements, over `size`."""
        own, used = self._arms
        slides = used * np.abs(q[self.loops.angles :])
        mixed = (used @ self.loops.turns_with.sum(axis=1)) ** 2
        return 1.2 * float(np.sqrt(np.sum((own + slides @ self.loops.turns_with) ** 2) + 2 * np.sum(mixed)))

    @cached_property
    def _arms(self) -> tuple[Array, Array]:
        """Lengths of the arms in the contours over `size`, (k/2, angles), and which guides they have, (k/2, guides)."""
        contours = len(self.loops.closures)
        arms = np.abs(self.loops.units[:contours]).reshape(contours, self.loops.angles, -1).max(axis=-1)
        return arms / self.loops.size, np.abs(self.loops.slides[:contours])

    def run(self, start: _Node, sense: int) -> tuple[list[_Node], Limit | None]:
        """Nodes from `start` over a turn, and the limit of assembly, if one was met."""
        nodes, left, tried = [start], FULL_TURN, np.inf
        while left > 1e-12:
            node = nodes[-1]
            over: _Node | Limit | None = None
            if node.reach < min(NEAR, tried / 3):
                tried = node.reach
                over = self._singular_point(node, sense, left)
            if isinstance(over, Limit):
                return nodes, over
            new = over or self._step(node, sense * min(node.reach, left))
            if new is None or node.reach < LEAST:
                return nodes, _ended(nodes)
            tried = np.inf if new.reach > NEAR else tried
            nodes.append(new)
            left = FULL_TURN - abs(new.phi - start.phi)
        return nodes, None

    def _step(self, node: _Node, step: float) -> _Node | None:
        """One step along the branch, halved until Newton's method stays within the theorem's ball."""
        for _ in range(20):
            phi = node.phi + step
            s = self.known(np.array([phi]))
            guess = node.q + step * node.slope + step * step / 2 * node.bend
            q = newton(self.loops, s, guess[None])[0]
            if np.max(np.abs(q - guess)) * self._second_derivatives(node.q) <= 0.5 * node.sine:
                return self.node(phi, q, s)
            step /= 2
        return None

    def _singular_point(self, node: _Node, sense: int, left: float) -> Limit | _Node | None:
        """The limit of assembly ahead, or the branch beyond the change point ahead; None where neither is near."""
        # at a limit the contours change across what J can make up for, in a change point they do not
        searches = [self._limit, self._over]
        for search in searches if node.across > 5 * node.sine else reversed(searches):
            if (found := search(node, sense, left)) is not None:
                return found
        return None

    def _limit(self, node: _Node, sense: int, left: float) -> Limit | None:
        """The limit of assembly by Newton's method: contours closed, and the bordered Jacobian's indicator g = 0,

        [J b; cᵀ 0] [v; g] = [0; 1], with b, c the singular vectors of the node (Griewank, Reddien 1984).
        """
        k = len(node.q)
        z = np.append(node.q, node.phi)
        for _ in range(12):
            eps = 1e-6 * np.concatenate([np.zeros((1, k + 1)), np.eye(k + 1), -np.eye(k + 1)])
            values = self._with_indicator(z + eps, node)
            slopes = (values[1 : k + 2] - values[k + 2 :]).T / 2e-6
            if not np.isfinite(slopes).all():
                return None
            step = np.linalg.lstsq(slopes, values[0], rcond=None)[0]
            z = z - step
            if np.abs(step).max() < 1e-12:
                break
        ahead = sense * (z[-1] - node.phi)
        if np.abs(step).max() > 1e-8 or not 0 < ahead < 0.2 or np.abs(z[:-1] - node.q).max() > 1:
            return None
        end = self.node(float(z[-1]), z[:-1])
        return Limit(end.phi, end.q) if end.across > 1e-4 and end.sine < 1e-5 else None

    def _with_indicator(self, z: Array, node: _Node) -> Array:
        """Contours and indicator at points (N, k + 1) of (q, φ)."""
        s = self.known(z[:, -1])
        residual, J = self.loops.closing(s, z[:, :-1], self.loops.gaps(s, z[:, :-1]))
        count, k = residual.shape
        bordered = np.zeros((count, k + 1, k + 1))
        bordered[:, :k, :k], bordered[:, :k, k], bordered[:, k, :k] = J, node.left, node.right
        last = np.broadcast_to(np.eye(k + 1)[-1], (count, k + 1))
        return np.concatenate([residual, solve_each(bordered, last)[:, -1:]], axis=1)

    def _over(self, node: _Node, sense: int, left: float) -> _Node | None:
        """Straight over a change point: both branches have a slope there.

        det J changes its sign there, or touches zero where two changes fall together (links of equal lengths).
        """
        for gap in (2 * NEAR, 5 * NEAR, 15 * NEAR):
            if gap > left:
                return None
            step = sense * gap
            s = self.known(np.array([node.phi + step]))
            guess = node.q + step * node.slope + step * step / 2 * node.bend
            q = newton(self.loops, s, guess[None])[0]
            if not np.max(np.abs(q - guess)) < gap**2:
                continue
            over = self.node(node.phi + step, q, s)
            turned = np.abs(over.slope - node.slope - step * node.bend).max()
            if turned < 100 * gap**2 * (1 + np.abs(node.bend).max()) and over.sine > node.sine / 3:
                order = 1.0 if over.sign == -node.sign else 0.5  # of the zero that the sine has there
                to_zero = step * node.sine**order / (node.sine**order + over.sine**order)
                if order == 1.0 or self._touches(node, to_zero, 0.1 * min(node.sine, over.sine)):
                    self.changes.append(node.phi + to_zero)
                    return over
        return None

    def _touches(self, node: _Node, step: float, least: float) -> bool:
        """Whether the smallest singular value all but vanishes a step from the node."""
        s = self.known(np.array([node.phi + step]))
        q = node.q + step * node.slope + step * step / 2 * node.bend
        return bool(np.linalg.svd(self.loops.jacobian(s, q[None])[0], compute_uv=False)[-1] < least)
