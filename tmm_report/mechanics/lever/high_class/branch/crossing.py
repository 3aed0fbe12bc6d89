"""Change points: where the branch of a group crosses another and goes straight on.

The contours are reduced to one function g of two coordinates y, along the two directions that they hardly resist
(Lyapunov–Schmidt): the others are closed by Newton's method. Where ∇g = 0, with the Hessian H indefinite, two branches
cross if g = 0 there, along yᵀH y = 0; else they miss one another, at a distance of √(2|g|/|H|).
Source: Golubitsky, Schaeffer, Singularities and groups in bifurcation theory I (1985), ch. 1.
"""

from __future__ import annotations

from math import sqrt
from typing import Any

import numpy as np

from tmm_report.mechanics.lever.high_class.branch.curve import Curve, Node
from tmm_report.records import dataclass

Array = Any
NOISE = 3e-15  # of the contours, over the size of the group: what g cannot be told from 0 by
DIFFERENCE = 1e-5  # step of the differences that stand for second derivatives
SINGULAR = 1e5  # norm of the inverse of A from which a point counts as singular
FLAT = 1e-3  # least ratio of the Hessian's curvatures: below it the branches all but touch, not cross


@dataclass(frozen=True, eq=False)
class Saddle:
    """The critical point of g: place z, |g| there, and the directions along which g stays so, (2, k + 1); none where
    the curvatures of g have one sign."""

    z: Array
    value: float
    lines: Array


def saddle(curve: Curve, node: Node) -> Saddle | None:
    """The critical point near a node; None where there is none."""
    left, sines, right = np.linalg.svd(node.D)
    if sines[-2] < 20 * sines[-1]:
        return None
    closing, free = left[:, :-1].T, right[-2:]
    psi = left[:, -1]
    rows = len(closing)

    def reduced(z: Array) -> tuple[Array, Array, float]:
        """The contours but one with ∇g, all 0 in the point; dz/dy; g."""
        F, D = curve.at(z)
        bordered = np.vstack([closing @ D, free])
        Y = np.linalg.solve(bordered, np.eye(rows + 2)[:, -2:])
        return np.concatenate([closing @ F, psi @ D @ Y]), Y, float(psi @ F)

    z = node.z
    try:
        for _ in range(10):
            value, Y, g = reduced(z)
            slopes = _slopes(lambda x: reduced(x)[0], z)
            step = np.linalg.solve(slopes, value)
            z = z - step
            size = np.abs(step).max()
            if not np.abs(z - node.z).max() < 1:
                return None
            if size < 1e-12:
                break
        value, Y, g = reduced(z)
    except np.linalg.LinAlgError:
        return None
    if not size < 1e-9 or not np.isfinite(value).all():
        return None
    H = slopes[-2:] @ Y
    lines = _lines((H + H.T) / 2)
    return Saddle(z, abs(g), lines @ Y.T if len(lines) else np.zeros((0, len(z))))


def _slopes(of: Any, z: Array) -> Array:
    columns = []
    for n in range(len(z)):
        aside = np.zeros(len(z))
        aside[n] = DIFFERENCE
        columns.append((of(z + aside) - of(z - aside)) / (2 * DIFFERENCE))
    return np.array(columns).T


def _lines(H: Array) -> Array:
    """Directions with yᵀH y = 0, (2, 2); none where H is definite, or flat in one direction."""
    curvatures, axes = np.linalg.eigh(H)
    low, high = curvatures
    if not low < 0 < high or min(-low, high) < FLAT * max(-low, high):
        return np.zeros((0, 2))
    one, other = np.sqrt(high) * axes[:, 0], np.sqrt(-low) * axes[:, 1]
    return np.array([one + other, one - other])


def over(curve: Curve, node: Node, at: Saddle) -> tuple[Node, Node] | None:
    """The change point ahead and a node as far behind it; None where the branch does not cross another."""
    if at.value > NOISE or not len(at.lines):
        return None
    chord = at.z - node.z
    along = max(
        (sign * line / np.sqrt(line @ line) for line in at.lines for sign in (1, -1)), key=lambda x: x @ chord
    )
    far = along @ chord
    if not far > 0.9 * np.sqrt(chord @ chord) or node.t @ along < 0.5:
        return None
    # before the point z = c − far·t + aside, behind it z = c + far·t + aside
    aside = node.z - (at.z - far * along)
    return _behind(curve, at.z, along, far, at.z + far * along + aside)


def _behind(curve: Curve, z: Array, along: Array, far: float, guess: Array) -> tuple[Node, Node] | None:
    found = curve.closed(guess, along)
    if found is None or np.abs(found[0] - guess).max() > 0.3 * far:
        return None
    behind = curve.node(found[0], along, found[1])
    point = Node(z, along, behind.D, behind.left, behind.right, np.inf) if behind is not None else None
    return (point, behind) if point is not None and behind is not None else None


def straight(curve: Curve, before: Node, node: Node, far: float) -> tuple[Node, Node] | None:
    """Over a point where more falls together than two branches crossing (links of equal lengths): straight on along
    the curve's parabola over `far`, where the contours must be as regular as at the node; the point, and behind it."""
    curvature = bend(before, node)
    guess = node.z + far * node.t + far * far / 2 * curvature
    found = curve.closed(guess, node.t)
    if found is None or np.abs(found[0] - guess).max() > 3 * far**3:
        return None
    behind = curve.node(found[0], node.t, found[1])
    if behind is None or behind.beta > 3 * node.beta:
        return None
    if np.abs(behind.t - node.t - far * curvature).max() > 30 * far * far:
        return None
    best = _most_singular(curve, node, behind, far)
    return (best, behind) if best.beta > SINGULAR and not _missed(curve, best) else None


def _missed(curve: Curve, point: Node) -> bool:
    """Whether the branches beside a singular point miss one another, so that none goes straight on."""
    at = saddle(curve, point)
    return at is not None and at.value > NOISE


def bend(before: Node, node: Node) -> Array:
    """Curvature of the curve about a node, from the node before it."""
    chord = node.z - before.z
    length = np.sqrt(chord @ chord)
    return (node.t - before.t) / length if length > 0 else np.zeros(len(node.t))


def ahead(before: Node, node: Node, far: float) -> Array:
    """The place at the arc length `far` behind a node, by the cubic from the node before it."""
    chord, turn = node.z - before.z, node.t - before.t
    length = sqrt(chord @ chord) * (1 + turn @ turn / 24)
    if not length > 0:
        return node.z + far * node.t
    x, mean = far / length, chord / length
    bent = 2 * before.t + 4 * node.t - 6 * mean
    twisted = 6 * (before.t + node.t) - 12 * mean
    return node.z + far * (node.t + x * (bent / 2 + x / 6 * twisted))


def _most_singular(curve: Curve, node: Node, behind: Node, far: float) -> Node:
    """Of the points between, along the cubic, the one where A is most nearly singular."""
    low, high = 0.0, 1.0
    best = node
    for _ in range(7):
        grid = np.linspace(low, high, 17)
        nodes = [_between(curve, node, behind, far, u) for u in grid]
        k = int(np.argmax([one.beta for one in nodes]))
        best = nodes[k]
        low, high = grid[max(k - 1, 0)], grid[min(k + 1, len(grid) - 1)]
    return best


def _between(curve: Curve, node: Node, behind: Node, far: float, u: float) -> Node:
    z, t = cubic(node, behind, far, u)
    _, D = curve.at(z)
    sines = np.linalg.svd(np.vstack([D, t]), compute_uv=False)
    return Node(z, t, D, node.left, node.right, float(1 / max(sines[-1], 1e-300)))


def cubic(one: Node, other: Node, length: float, u: float) -> tuple[Array, Array]:
    """Point and unit tangent at the part u of the way along the cubic between two nodes."""
    a, b = length * one.t, length * other.t
    rise = other.z - one.z
    z = one.z + u * (a + u * (3 * rise - 2 * a - b + u * (a + b - 2 * rise)))
    t = a + u * (2 * (3 * rise - 2 * a - b) + 3 * u * (a + b - 2 * rise))
    return z, t / np.sqrt(t @ t)


def end_bend(one: Node, other: Node, length: float) -> float:
    """Second derivative of the driver's angle along the cubic between two nodes, at its end."""
    return float((2 * one.t[-1] + 4 * other.t[-1] - 6 * (other.z[-1] - one.z[-1]) / length) / length)
