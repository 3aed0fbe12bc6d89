"""Reversed motion: the follower found back from the finished profile, which is all that this knows of the cam.

The profile is turned by φ with its cam, and the follower is let down on it: it rests where the coordinate at which it
touches a point of the profile is the greatest of all points. With a point w seen from the foot of a sliding follower,
a = w·t along its line and b across it, or from the pivot of one that swings, at ρ exp iθ:

    roller   q = a + √(r² − b²)              σq = σθ + arccos((l² + ρ² − r²)/(2lρ))
    flat     q = n·(w)/n·t                   σq = σ(θ − δ) + arccos(B·n/ρ), n = exp i(q + δ)
    edge     q = a where b = 0               σq = σθ where ρ = l

A profile that is cut by its own other parts lifts the follower higher than its law. Source: Levitsky, Cam mechanisms,
ch. 4.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.cams.cam import Cam, Sliding, Swinging
from tmm_report.mechanics.cams.follower_laws import FULL_TURN

Array = Any
LAID = 721  # points of the profile on which the follower is first let down
AT_ONCE = 256  # angles at which it is let down at once: 40 kB of points each
PARTS = 8  # of a bracket, at whose ends they are tried at once: a call costs more than a few points of it
NARROWED = 14  # times a bracket of two points of the profile becomes two of its parts: that leaves 4e-11 rad
HALVED = 18  # times it becomes one of its parts: the rounding of an angle


def recovered(cam: Cam, phi: Array) -> Array:
    """σq of the follower let down on the profile at angles of the cam's x axis, (P,): m, or rad up to whole turns."""
    phi = np.asarray(phi, dtype=float)
    u = np.linspace(0.0, FULL_TURN, LAID)
    points = cam.profile(u)
    let_down = _on_edge if cam.roller == 0.0 else _on_points
    parts = np.split(phi, range(AT_ONCE, len(phi), AT_ONCE))
    return np.concatenate([let_down(cam, part, u, points) for part in parts])


def _on_points(cam: Cam, phi: Array, u: Array, points: Array) -> Array:
    """The farthest lifted of all points, and between its neighbours."""
    values = touching(cam, points, phi[:, None])
    k, each = np.argmax(values, axis=1), np.arange(len(phi))
    step = FULL_TURN / (LAID - 1)
    return np.maximum(
        values[each, k], _refined(lambda x: touching(cam, cam.profile(x), phi), u[k] - step, u[k] + step)
    )


def touching(cam: Cam, points: Array, phi: Array) -> Array:
    """σq at which the follower touches points of the cam, in its axes, at angles of its x axis; −∞ where it cannot. Of
    an edge its distance from the path is passed over."""
    w = points * np.exp(1j * phi)
    return _slid(cam, cam.motion, w) if isinstance(cam.motion, Sliding) else _swung(cam, cam.motion, w)


def _slid(cam: Cam, motion: Sliding, w: Array) -> Array:
    w = w - motion.foot
    if cam.flat:
        n = complex(cam.normal(np.array(0.0)))
        return dot(n, w) / dot(n, motion.along)
    along, across = dot(motion.along, w), cross(motion.along, w)
    return along + _root(cam, across)


def _root(cam: Cam, across: Array) -> Array:
    if not cam.roller:
        return 0.0
    square = cam.roller**2 - across**2
    return np.where(square >= 0, np.sqrt(np.maximum(square, 0.0)), -np.inf)


def _swung(cam: Cam, motion: Swinging, w: Array) -> Array:
    w = w - motion.pivot
    towards, rho, side = float(np.angle(-motion.pivot)), np.abs(w), motion.side
    turned = side * (np.angle(w * np.exp(-1j * towards)) + towards)
    if cam.flat:
        delta = float(np.angle(complex(cam.normal(np.array(0.0)))))
        cosine = abs(motion.arm) * np.cos(delta) / rho
        turned = turned - side * delta
    elif not cam.roller:
        return turned
    else:
        cosine = (abs(motion.arm) ** 2 + rho**2 - cam.roller**2) / (2 * abs(motion.arm) * rho)
    return np.where(np.abs(cosine) <= 1, turned + np.arccos(np.clip(cosine, -1, 1)), -np.inf)


def _refined(of: Callable[[Array], Array], low: Array, high: Array) -> Array:
    """The greatest value between the ends, (P,)."""
    for _ in range(NARROWED):
        x = _parted(low, high)
        k, each = np.argmax(of(x), axis=0), np.arange(len(low))
        low, high = x[np.maximum(k - 1, 0), each], x[np.minimum(k + 1, PARTS), each]
    return of((low + high) / 2)


def _parted(low: Array, high: Array) -> Array:
    """The ends of equal parts of brackets, (PARTS + 1, P)."""
    return low + (high - low) * (np.arange(PARTS + 1) / PARTS)[:, None]


def _on_edge(cam: Cam, phi: Array, u: Array, points: Array) -> Array:
    """Where the profile crosses the path of the edge, the farthest lifted of all crossings."""
    gap = _gap(cam, points, phi[:, None])
    crosses = np.sign(gap[:, :-1]) * np.sign(gap[:, 1:]) <= 0
    values = np.where(crosses, touching(cam, points, phi[:, None])[:, :-1], -np.inf)
    k, each = np.argmax(values, axis=1), np.arange(len(phi))
    low, high, sign = u[k], u[k + 1], np.sign(gap[each, k])
    for _ in range(HALVED):
        x = _parted(low, high)
        same = np.sign(_gap(cam, cam.profile(x[1:-1]), phi)) == sign
        passed = np.argmin(np.concatenate([same, np.zeros((1, len(phi)), bool)]), axis=0)  # the first beyond
        low, high = x[passed, each], x[passed + 1, each]
    return touching(cam, cam.profile((low + high) / 2), phi)


def _gap(cam: Cam, points: Array, phi: Array) -> Array:
    """How far points are from the path of the edge, m."""
    w, motion = points * np.exp(1j * phi), cam.motion
    if isinstance(motion, Sliding):
        return cross(motion.along, w - motion.foot)
    return np.abs(w - motion.pivot) - abs(motion.arm)
