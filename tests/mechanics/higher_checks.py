"""A second way to the positions of groups above class II: distances of points, and nothing of the loop equations."""

from __future__ import annotations

from itertools import combinations
from typing import NamedTuple

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross
from tmm_report.mechanics.lever import motion
from tmm_report.mechanics.lever.cycle import Cycle
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism

Array = np.ndarray


def unclosed(found: motion.Motion) -> Array:
    """Greatest violation of the joints at every position, m, (P,); 0 where the mechanism is null."""
    m, s = found.linkage.mechanism, found.state
    worst = np.zeros(found.shape)
    for point in m.point_names:
        first, *others = (s.world(link, m.links[link].points[point]) for link in m.links_at(point))
        for place in others:
            worst = np.fmax(worst, np.abs(place - first))
    for slide in m.slides:
        guide = m.guides[slide.guide]
        t = s.u[guide.link] * guide.direction
        gap = s.world(slide.link, slide.through) - s.world(guide.link, guide.through)
        worst = np.fmax(worst, np.fmax(np.abs(cross(t, gap)), np.abs(t - s.u[slide.link] * slide.direction)))
    return np.where(found.closes, worst, 0.0)


def jumps(found: motion.Motion, step: float) -> Array:
    """By how much links turn between neighbouring positions more than three times what their angular velocities
    make of the step, rad, (P − 1,)."""
    worst = np.zeros(found.shape[0] - 1)
    omega = abs(float(found.linkage.mechanism.driver.omega))
    with np.errstate(invalid="ignore"):
        for link in found.linkage.mechanism.moving:
            u, w = found.turn(link), np.abs(found.angular_velocity(link)) / omega
            turned = np.abs(np.angle(u[1:] * u[:-1].conj()))
            worst = np.fmax(worst, turned - 3 * step * np.maximum(w[1:], w[:-1]))
    return worst


def beside(cycle: Cycle) -> Array:
    """Angles turned from 1e-2 to 1e-12 rad within the limits of the last group."""
    run = cycle.critical[-1].run
    near = 10.0 ** -np.arange(2, 13)
    ends = [] if run.forward is None else [run.forward - near]
    if run.backward is not None and not run.overlaps:
        ends.append(2 * np.pi - run.backward + near)
    found = np.concatenate(ends) if ends else np.array([])
    return found[(found > 0) & (found < 2 * np.pi)]


# ---------------------------------------------------------------- points alone, of mechanisms with pivots


class Points(NamedTuple):
    """Names of the points that are unknown, and the distances that are kept, (name, name, length)."""

    names: list[str]
    kept: list[tuple[str, str, float]]
    mechanism: Mechanism


def points_of(m: Mechanism) -> Points:
    fixed = {*m.links[FRAME].points, *m.links[m.driver.link].points}
    joints = {p for p in m.point_names if len(m.links_at(p)) > 1}
    kept = [
        (a, b, float(abs(body.points[a] - body.points[b])))
        for name, body in m.links.items()
        if name not in (FRAME, m.driver.link)
        for a, b in combinations([p for p in body.points if p in joints], 2)
    ]
    return Points(sorted(joints - fixed), kept, m)


def given(points: Points, phi: float) -> dict[str, complex]:
    """Places of the frame's points and the crank's at a driver angle."""
    m = points.mechanism
    crank = m.links[m.driver.link].points
    pivot = next(p for p in crank if p in m.links[FRAME].points)
    origin = m.links[FRAME].points[pivot]
    turned = {p: origin + (at - crank[pivot]) * np.exp(1j * phi) for p, at in crank.items()}
    return {**turned, **m.links[FRAME].points}


def distances(points: Points, z: Array, phi: float) -> tuple[Array, Array]:
    """Errors of the squared distances over 2 at places z (N,) of the unknown points, and the Jacobian, square."""
    known = given(points, phi)
    at = {**known, **dict(zip(points.names, z, strict=True))}
    residual, J = [], np.zeros((len(points.kept), 2 * len(z)))
    for row, (a, b, length) in enumerate(points.kept):
        gap = at[a] - at[b]
        residual.append((abs(gap) ** 2 - length**2) / 2)
        for name, sign in ((a, 1), (b, -1)):
            if name in points.names:
                n = points.names.index(name)
                J[row, 2 * n], J[row, 2 * n + 1] = sign * gap.real, sign * gap.imag
    return np.array(residual), J


def stepped(points: Points, z: Array, phi: Array) -> tuple[Array, Array]:
    """Places by Newton's method from one driver angle (N,) to the next, and det J, in steps of a millionth of theirs
    where need be; they end where det J changes its sign or Newton's method fails."""
    walked = [(float(phi[0]), z, float(np.linalg.det(distances(points, z, phi[0])[1])))]
    places, dets = [z], [walked[0][2]]
    for target in phi[1:]:
        step = float(target) - walked[-1][0]
        least = abs(step) / 1e6
        while abs(left := float(target) - walked[-1][0]) > 1e-13:
            step = left if abs(left) < abs(step) else step
            new = _one_step(points, walked, walked[-1][0] + step)
            if new is None:
                step /= 2
                if abs(step) < least:
                    return np.array(places), np.array(dets)
                continue
            walked = [walked[-1], new]
            step *= 2
        places.append(walked[-1][1])
        dets.append(walked[-1][2])
    return np.array(places), np.array(dets)


def _one_step(
    points: Points, walked: list[tuple[float, Array, float]], phi: float
) -> tuple[float, Array, float] | None:
    before, at, det = walked[-1]
    guess = at
    if len(walked) > 1:
        earlier, other, _ = walked[-2]
        guess = at + (at - other) * (phi - before) / (before - earlier)
    z = guess
    for _ in range(6):
        residual, J = distances(points, z, phi)
        step = np.linalg.solve(J, residual)
        z = z - (step[::2] + 1j * step[1::2])
        if np.abs(step).max() < 1e-14:
            break
    new = float(np.linalg.det(J))
    strays = np.abs(z - guess).max() > 1e-3 * float(np.abs(z).max()) or not 0.7 < new / det < 1.4
    return None if strays or np.abs(step).max() > 1e-9 else (phi, z, new)


def limit_from(points: Points, z: Array, phi: float, way: int) -> float:
    """The limit beyond driver angle phi (way ±1) near a position z: Newton's method on the distances and det J = 0, by
    differences."""

    def of(x: Array) -> Array:
        residual, J = distances(points, x[:-1:2] + 1j * x[1:-1:2], x[-1])
        return np.append(residual, np.linalg.det(J) / scale)

    x = np.append(np.stack([z.real, z.imag], axis=-1).ravel(), phi)
    scale = 1.0
    scale = max(abs(of(x)[-1]), 1e-300)
    for _ in range(60):
        value = of(x)
        columns = [(of(x + e) - of(x - e)) / 2e-7 for e in 1e-7 * np.eye(len(x))]
        step = np.linalg.solve(np.array(columns).T, value)
        x = x - step * min(1.0, 0.05 / np.abs(step).max())
        if np.abs(step).max() < 1e-13:
            break
    return float(x[-1])
