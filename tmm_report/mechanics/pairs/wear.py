"""Wear by Archard's law, u = k p s: of a guide and its slider cut into equal parts, of a pivot cut into sectors.

A coefficient k, 1/Pa, times a path under pressure, Pa m, is a depth, m. A guide's points j = 1 … N + 1 stand ΔL
apart, its slider covers N_s of them; each point stands for a part of the width b and the length ΔL. Arrays (P,) run
over the positions of the cycle.
Sources: Pronikov, Reliability of machines; the paper on wear of the prismatic pair of a forging machine; Archard,
1953.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import bisected
from tmm_report.records import dataclass

Array = Any


# --- a guide and its slider


@dataclass(frozen=True, eq=False)
class Grid:
    """`parts` of ΔL = `step`, m, along the guide; the slider covers `covered` points, in each position from point
    `start` (P,), counted from 0."""

    parts: int
    step: float
    covered: int
    start: Array

    @property
    def x(self) -> Array:
        """Places of the guide's points from its beginning, m, (N + 1,)."""
        return np.arange(self.parts + 1) * self.step

    @property
    def xi(self) -> Array:
        """Places of the slider's points from its middle, m, (N_s,): ξ_k = (k − (N_s + 1)/2) ΔL."""
        return (np.arange(self.covered) - (self.covered - 1) / 2) * self.step

    @property
    def under(self) -> Array:
        """Points of the guide under those of the slider, (P, N_s)."""
        return self.start[:, None] + np.arange(self.covered)

    def on_guide(self, paths: Array) -> Array:
        """What points of the slider carry, (P, N_s), summed over the positions at the points of the guide, (N +
        1,)."""
        return np.bincount(self.under.ravel(), np.ravel(paths), self.parts + 1)


def grid(travel: Array, stroke: float, length: float, parts: int) -> Grid:
    """Of a slider of `length` that stands at `travel`, 0 … stroke, (P,), from one end of its stroke: L = S_max +
    l_s."""
    step = (stroke + length) / parts
    covered = round(length / step) + 1
    start = np.rint(travel / step).astype(int)
    return Grid(parts, step, covered, np.minimum(start, parts + 1 - covered))


def share(grid: Grid) -> Array:
    """Of each point in the force of its half of the slider, by the triangular law: |ξ_k|/Σ|ξ| over a half, (N_s,)."""
    xi = np.abs(grid.xi)
    return xi / (xi.sum() / 2)


def couple_force(moment: Array, length: float) -> Array:
    """F_M = |M|/(⅔ l_s), N: on one face over one half of the slider, on the other over the other."""
    return np.abs(moment) / (2 / 3 * length)


@dataclass(frozen=True, eq=False)
class Rubbed:
    """Σ R_i|q_i|Δφ at the points of the guide (N + 1,) and of the slider (N_s,), N m a cycle: of the lower and of the
    upper face, from the central reaction and from its moment."""

    guide_force: tuple[Array, Array]
    guide_couple: tuple[Array, Array]
    slider_force: tuple[Array, Array]
    slider_couple: tuple[Array, Array]


def rubbed(grid: Grid, force: Array, moment: Array, path: Array, length: float) -> Rubbed:
    """`force` along the guide's normal and `moment` about the slider's middle, of the guide on the slider, (P,);
    `path`: |q_i| Δφ, m. A force along the normal presses the lower faces together; a moment counter-clockwise
    presses the lower faces at ξ > 0 and the upper ones at ξ < 0."""
    laid = pressing(grid, np.abs(force) * path, couple_force(moment, length) * path, force, moment)
    return Rubbed(
        *((grid.on_guide(lower), grid.on_guide(upper)) for lower, upper in laid),
        *((lower.sum(axis=0), upper.sum(axis=0)) for lower, upper in laid),
    )


Faces = tuple[Array, Array]


def pressing(grid: Grid, even: Array, couple: Array, force: Array, moment: Array) -> tuple[Faces, Faces]:
    """What comes to each point of the slider (P, N_s) on its lower and upper face: of `even`, as of the central
    reaction, all points alike, and of `couple` by the triangular law, (P,); `force`, `moment`: their senses."""
    alike = np.full(grid.covered, 1 / grid.covered)
    halves, ahead = share(grid), grid.xi > 0
    lower, upper = (np.where(face, even, 0.0)[:, None] * alike for face in (force > 0, force < 0))
    lifts, dips = (np.where(sense, couple, 0.0)[:, None] for sense in (moment > 0, moment < 0))
    return (lower, upper), (
        lifts * np.where(ahead, halves, 0.0) + dips * np.where(ahead, 0.0, halves),
        lifts * np.where(ahead, 0.0, halves) + dips * np.where(ahead, halves, 0.0),
    )


def mean_over_path(values: Array, path: Array, where: Array) -> float:
    """Mean of values (P,) over the path where they count; 0 where nothing does."""
    weight = np.where(where, path, 0.0)
    whole = float(weight.sum())
    return float(np.sum(weight * np.abs(values)) / whole) if whole > 0 else 0.0


def settling(grid: Grid, travel: Array, guide: Array, slider: Array) -> tuple[Array, Array]:
    """How deep a slider has sunk into a worn face, m, and how far it has tilted, rad, (P,): the straight line
    nearest to the depths of the guide (N + 1,) and of the slider (N_s,) under it, added up."""
    xi = grid.xi
    depth = np.interp(travel[:, None] + xi - xi[0], grid.x, guide) + slider
    return depth.mean(axis=1), depth @ xi / np.sum(xi**2)


# --- a pivot


def pressure_path(
    arc: float, law: str, radius: float, width: float, force: Array, path: Array, centre: Array, sectors: int
) -> Array:
    """Σ p|ds| of each sector of a cylinder over the cycle, Pa m, (N,); `path`: m, (P,)."""
    return pressures(arc, law, radius, width, force * path, centre, sectors).sum(axis=0)


def pressures(
    arc: float, law: str, radius: float, width: float, force: Array, centre: Array, sectors: int
) -> Array:
    """Mean pressures of the sectors of a cylinder, Pa, (P, N): sector j reaches from 2πj/N to 2π(j + 1)/N.

    `centre`: angle of the middle of the contact on the cylinder, rad, (P,); `arc`: its half angle. Law "uniform", p
    even, or "cosine", p = p0 cos ψ; the pressures add up to the force: R = b r ∫ p cos ψ dψ.
    """
    edges = 2 * np.pi / sectors * np.arange(sectors + 1)
    away = np.mod(edges - centre[:, None] + np.pi, 2 * np.pi) - np.pi  # of each edge from the middle, −π … π
    # the integral of the law from −π to each edge; a sector that holds ±π begins near π and ends near −π
    held = _running(np.clip(away, -arc, arc), arc, law)
    whole = _running(np.array(arc), arc, law)
    begin, end = held[:, :-1], held[:, 1:]
    part = np.where(away[:, 1:] >= away[:, :-1], end - begin, end + whole - begin)
    mean = part / (2 * np.pi / sectors)
    top = force / (radius * width * _lift(arc, law))
    return top[:, None] * mean


def _running(angle: Array, arc: float, law: str) -> Array:
    """∫ p/p0 dψ from −arc."""
    return angle + arc if law == "uniform" else np.sin(angle) + np.sin(arc)


def _lift(arc: float, law: str) -> float:
    """∫ (p/p0) cos ψ dψ over the contact."""
    return float(2 * np.sin(arc) if law == "uniform" else arc + np.sin(arc) * np.cos(arc))


def spread(arc: float, law: str) -> float:
    """∫ p dψ by ∫ p cos ψ dψ: by how much the pressures exceed the force, as they also squeeze sideways."""
    whole = float(_running(np.array(arc), arc, law))
    return whole / _lift(arc, law)


# --- stages of wear, and its law on a ring


def staged(time: Array, run_in: float, constant: float, rate: float) -> Array:
    """u(t) = u0 (1 − e^{−t/τ}) + γ t: running in, then steady wear."""
    return run_in * -np.expm1(-np.asarray(time) / constant) + rate * np.asarray(time)


def life(limit: float, rate: float, run_in: float = 0.0, constant: float = 1.0) -> float:
    """When the wear of `staged` reaches the limit; inf where it never does."""
    if not rate > 0:
        return float(-constant * np.log1p(-limit / run_in)) if run_in > limit else float("inf")
    low, high = max(0.0, (limit - run_in) / rate), limit / rate
    _, found = bisected(lambda time: float(staged(time, run_in, constant, rate)) < limit, low, high)
    return found


def ring_pressure(force: float, inner: float, outer: float, radius: Array) -> Array:
    """Pressure on a flat ring that wears evenly, Pa: p r = F/(2π (r2 − r1)) everywhere, as the depth follows p r."""
    return force / (2 * np.pi * (outer - inner) * np.asarray(radius))


def ring_mean(force: float, inner: float, outer: float) -> float:
    """Mean pressure on a flat ring, Pa."""
    return force / (np.pi * (outer**2 - inner**2))
