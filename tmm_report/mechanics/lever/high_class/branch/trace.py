"""A branch followed from a position to where it ends, in steps that cannot leave it.

Two solutions in one plane across the curve would need a singular mean of the bordered Jacobian A between them. While
A changes by less than what makes it singular (see `Node.change`) there is just one: a step is taken when the change at
its end is below a half, and when it is so short that in between A cannot stray by more than a quarter from what is
linear. So it is as long as the distance to the next branch allows, and never leaps to it.
Source: Ortega, Rheinboldt, Iterative solution of nonlinear equations in several variables, ch. 5, 12.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from tmm_report.mechanics.lever.high_class.branch import crossing
from tmm_report.mechanics.lever.high_class.branch.crossing import cubic, end_bend
from tmm_report.mechanics.lever.high_class.branch.curve import Curve, Node
from tmm_report.records import dataclass

Array = Any
LONGEST = 0.25  # step along the curve, rad
TURNED = 0.3  # change of A that a step shall make; 1 could make it singular
NEAR = 0.01  # a step this short means that another branch is near
STRAIGHT = (0.01, 0.03, 0.09)  # steps tried over a point where more than two branches meet
LEAST = 1e-10  # shorter steps are made of rounding errors
LEVEL = (
    1e-10  # slope of the angle along the curve in an inflection: what it turns back by is less than rounding
)
STEPS = 6000
Interval = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Trace:
    """Nodes along a branch. `blocked`: whether it ends where the links before the group do. `changes`: numbers of the
    nodes that are change points."""

    nodes: Sequence[Node]
    blocked: bool
    changes: tuple[int, ...]


@dataclass
class _Walk:
    """What is kept from step to step."""

    curve: Curve
    way: int  # of the driver's angle
    walls: Sequence[Interval]  # driver angles in which the links before the group do not exist
    nodes: list[Node]
    changes: list[int]
    h: float = 0.05
    tried: float = np.inf  # step at which a crossing was last looked for


def trace(curve: Curve, start: Node, way: int, far: float, walls: Sequence[Interval] = ()) -> Trace:
    """The branch from a node in the sense of `start.t`, by which the driver's angle goes the way ±1, until it has
    turned by `far`, rad, or the branch ends."""
    walk = _Walk(curve, way, walls, [start], [])
    for _ in range(STEPS):
        node = walk.nodes[-1]
        if way * (node.phi - start.phi) >= far:
            return Trace(walk.nodes, False, tuple(walk.changes))
        walk.h = min(walk.h, LONGEST, _straight(curve, node))
        if walk.h < min(NEAR, walk.tried / 3):
            walk.tried = walk.h
            if _crossed(walk):
                continue
        if walk.h < LEAST:
            return Trace(walk.nodes, False, tuple(walk.changes))
        ended = _step(walk)
        if ended is not None:
            return Trace(walk.nodes, ended == "wall", tuple(walk.changes))
    return Trace(walk.nodes, False, tuple(walk.changes))


def _straight(curve: Curve, node: Node) -> float:
    """The step over which A strays by at most a quarter of what makes it singular from what is linear."""
    return float(np.sqrt(2 / (node.beta * curve.spread))) if np.isfinite(node.beta) else np.inf


def _crossed(walk: _Walk) -> bool:
    """Go over a change point ahead, if there is one."""
    node = walk.nodes[-1]
    at = crossing.saddle(walk.curve, node)
    found = crossing.over(walk.curve, node, at) if at is not None else None
    if (at is None or not len(at.lines)) and len(walk.nodes) > 1:
        for far in sorted((8 * walk.h, 24 * walk.h, *STRAIGHT)):
            if far < 0.1 and found is None:
                found = crossing.straight(walk.curve, walk.nodes[-2], node, far)
    if found is None or any(one.t[-1] * walk.way <= 0 for one in found):
        return False
    walk.changes.append(len(walk.nodes))
    walk.nodes += found
    walk.tried = np.inf
    return True


def _step(walk: _Walk) -> Literal["limit", "wall"] | None:
    """One step; where the branch ends, in what."""
    node, h = walk.nodes[-1], walk.h
    guess = crossing.ahead(walk.nodes[-2], node, h) if len(walk.nodes) > 1 else node.z + h * node.t
    wall = _wall(walk, float(guess[-1]))
    if wall is not None:
        if _to_wall(walk, wall):
            return "wall"
        walk.h = h / 2
        return None
    new = _next(walk.curve, node, guess)
    if new is None:
        walk.h = h / 2
        return None
    found, change = new
    if _falls(walk.curve, walk.way, node, found, walk.nodes):
        return "limit"
    walk.nodes.append(found)
    walk.h = h * min(max(TURNED / change, 0.3), 2.0) if change > 0 else 2 * h
    if walk.h > NEAR:
        walk.tried = np.inf
    return None


def _next(curve: Curve, node: Node, guess: Array) -> tuple[Node, float] | None:
    """The node near the guess and the change of A to it; None where it may lie on another branch."""
    found = curve.closed(guess, node.t, node.beta)
    if found is None:
        return None
    z, D = found
    change = node.change(D)
    if change > 0.5:
        return None
    new = curve.node(z, node.t, D)
    return (new, change) if new is not None else None


# ---------------------------------------------------------------- limits


def _falls(curve: Curve, way: int, one: Node, other: Node, nodes: list[Node], depth: int = 0) -> bool:
    """Whether the driver's angle turns back between two nodes; if so, its first extreme is put behind `nodes`."""
    if way * other.t[-1] <= (-LEVEL if depth else 0):
        nodes.append(_extreme(curve, way, one, other))
        nodes[-1:-1] = _towards(curve, way, one, nodes[-1])
        return True
    u = _doubtful(way, one, other)
    if u is None or depth > 40:
        return False
    middle = _at(curve, one, other, u)
    if middle is None or np.abs(middle.z - one.z).max() < 1e-7:
        return False
    return _falls(curve, way, one, middle, nodes, depth + 1) or _second(
        curve, way, middle, other, nodes, depth + 1
    )


def _second(curve: Curve, way: int, one: Node, other: Node, nodes: list[Node], depth: int) -> bool:
    nodes.append(one)
    return _falls(curve, way, one, other, nodes, depth)


def _doubtful(way: int, one: Node, other: Node) -> float | None:
    """Where, part of the way, the driver's angle may turn back between two nodes of which it rises in both."""
    length = _length(one, other)
    p, r = way * one.t[-1], way * other.t[-1]
    mean = way * (other.z[-1] - one.z[-1]) / length
    a, b = 3 * p + 3 * r - 6 * mean, 6 * mean - 4 * p - 2 * r
    if a <= 0:
        return None
    u = -b / (2 * a)
    least = p - b * b / (4 * a)
    return float(u) if 0.02 < u < 0.98 and least < 0.3 * min(p, r) else None


def _length(one: Node, other: Node) -> float:
    chord, turn = other.z - one.z, other.t - one.t
    return float(np.sqrt(chord @ chord) * (1 + turn @ turn / 24))


def _at(curve: Curve, one: Node, other: Node, u: float) -> Node | None:
    """The node at the part u of the way between two."""
    z, t = cubic(one, other, _length(one, other), u)
    found = curve.closed(z, t, one.beta)
    return curve.node(found[0], t, found[1]) if found is not None else None


def _extreme(curve: Curve, way: int, one: Node, other: Node) -> Node:
    """The node between two at which the driver's angle is extreme, by the Illinois method on its slope: none of
    `calculus.roots`, as every trial is a node that may be lost on the way, and the best one is kept."""
    a, b, fa, fb = 0.0, 1.0, way * one.t[-1], way * other.t[-1]
    best = other if abs(fb) < abs(fa) else one
    side = 0
    for _ in range(60):
        if abs(best.t[-1]) < 1e-14 or b - a < 1e-15:
            break
        u = (a * fb - b * fa) / (fb - fa)
        new = _at(curve, one, other, u if a < u < b else (a + b) / 2)
        if new is None:
            break
        f = way * new.t[-1]
        if abs(f) < abs(best.t[-1]):
            best = new
        if f > 0:
            a, fa = u, f
            fb = fb / 2 if side > 0 else fb
            side = 1
        else:
            b, fb = u, f
            fa = fa / 2 if side < 0 else fa
            side = -1
    return best


def _towards(curve: Curve, way: int, one: Node, limit: Node) -> list[Node]:
    """Nodes before a limit, each halving what is left, until the cubic bends there as the curve does: near a cusp."""
    found: list[Node] = []
    while len(found) < 12:
        middle = _at(curve, one, limit, 0.5)
        if middle is None:
            break
        before, after = (way * end_bend(node, limit, _length(node, limit)) for node in (one, middle))
        if abs(before - after) < -0.1 * after:
            break
        found.append(middle)
        one = middle
    return found


# ---------------------------------------------------------------- where the links before end


def _wall(walk: _Walk, phi: float) -> float | None:
    """The driver angle between the last node and `phi` at which the links before the group cease to exist."""
    node, way = walk.nodes[-1], walk.way
    ahead = [
        (way * ((low if way > 0 else high) - node.phi) + 1e-12) % (2 * np.pi) - 1e-12
        for low, high in walk.walls
    ]
    near = [x for x in ahead if x <= way * (phi - node.phi)]
    if near:
        return float(node.phi + way * max(min(near), 0.0))
    known = walk.curve.known
    if known.is_known(phi):
        return None
    low, high = node.phi, phi
    for _ in range(7):
        grid = np.linspace(low, high, 257)
        lost = np.flatnonzero(~known.exists(grid))
        if not lost.size or lost[0] == 0:
            break
        low, high = grid[lost[0] - 1], grid[lost[0]]
    return None if known.exists(np.array([high + way * 1e-7]))[0] else float(low)


def _to_wall(walk: _Walk, wall: float) -> bool:
    """Follow the branch to the wall, by the square root of the angle that is left: there the links before stretch to
    their limit, and the group's links with them. Whether it was reached."""
    curve, way, node = walk.curve, walk.way, walk.nodes[-1]
    tau = float(np.sqrt(max(way * (wall - node.phi), 0.0)))
    across = np.eye(len(node.z))[-1]
    nodes, factor = [node], 0.5
    slope = -2 * tau * way * node.t / node.t[-1] if node.t[-1] != 0 else 0 * node.t
    slope[-1] = 0.0
    while tau > 1e-7:
        last, new_tau = nodes[-1], factor * tau
        guess = last.z + (new_tau - tau) * slope
        guess[-1] = wall - way * new_tau**2
        found = curve.closed(guess, across)
        new = curve.node(found[0], last.t, found[1]) if found is not None else None
        if new is None or _own_change(last, new) > 0.5:
            factor = (1 + factor) / 2
            if factor > 0.97:
                return False
            continue
        slope = (new.z - last.z) / (new_tau - tau)
        slope[-1] = 0.0
        nodes.append(new)
        tau = new_tau
    last = nodes[-1]
    z = last.z - tau * slope
    z[-1] = wall
    length = np.sqrt(slope @ slope)
    walk.nodes += nodes[1:]
    walk.nodes.append(
        Node(z, -slope / length if length > 0 else last.t, last.D, last.left, last.right, last.beta)
    )
    return True


def _own_change(one: Node, other: Node) -> float:
    """‖J₀⁻¹(J − J₀)‖ of the group alone, the links before standing still."""
    J, new = one.D[:, :-1], other.D[:, :-1]
    try:
        return float(np.linalg.norm(np.linalg.solve(J, new - J)))
    except np.linalg.LinAlgError:
        return np.inf
