"""Flywheel of a machine in steady motion: its moment of inertia for a wanted unevenness, by several methods; its
dimensions.

    T(φ) = T₀ + A(φ) = (J_I + J_II(φ)) ω²/2,   A(φ) = ∫ M dφ

M is the excess of the driving moment over the resisting one, J_II what varies with the angle, J_I the constant rest,
the flywheel in it. The mean speed is ω_m = (ω_max + ω_min)/2, the unevenness δ = (ω_max − ω_min)/ω_m. That ω reaches
ω_max and goes no further says that T₀ = J_I ω_max²/2 − max(A − J_II ω_max²/2); the same of ω_min; their difference is

    J_I = (P − Q)/(δ ω_m²),   P = max(A − s₁ J_II),   Q = min(A − s₂ J_II)

exactly with s₁ = ω_max²/2, s₂ = ω_min²/2: on the energy–mass diagram P and Q are where its two tangents of these slopes
cut the axis of energies. The methods of the textbooks put other slopes there.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True, eq=False)
class Cycle:
    """One cycle of the steady motion at the points of its panels, (K, n): `moment`, the excess moment, N m; `varying`:
    J_II, kg m². `own`: the constant part of the machine without the flywheel, kg m²."""

    panels: Panels
    moment: Array
    varying: Array
    own: float = 0.0

    @cached_property
    def work(self) -> Array:
        """A(φ), J: work of the excess moment from the beginning of the cycle."""
        return self.panels.running(self.moment)

    @cached_property
    def slope(self) -> Array:
        """dJ_II/dφ, kg m²/rad."""
        return self.panels.slope(self.varying)

    @cached_property
    def swing(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Least and greatest work, each with its angle: their difference is the greatest excess work."""
        return self.panels.extremes(self.work)

    @cached_property
    def mean_inertia(self) -> float:
        return float(self.panels.mean(self.varying))

    def at(self, values: Array, x: float) -> float:
        """A continuous function at one angle."""
        return float(self.panels.at(values, np.array([x]))[0])


@dataclass(frozen=True)
class Touch:
    """A tangent of slope `slope`, (rad/s)²/2, to the energy–mass curve: it touches it at the angle `at`, where J_II is
    `inertia` and A is `work`, and cuts the axis of energies at `cut`, J."""

    slope: float
    at: float
    inertia: float
    work: float

    @property
    def cut(self) -> float:
        return self.work - self.slope * self.inertia


@dataclass(frozen=True)
class Method:
    """What a method finds: the constant moment of inertia J_I, kg m², and what it took for both ends."""

    key: str
    inertia: float
    upper: Touch
    lower: Touch


def tangent(cycle: Cycle, slope: float, upper: bool) -> Touch:
    """The supporting line of a slope above or below the energy–mass curve."""
    heights = cycle.work - slope * cycle.varying
    return _touch(cycle, slope, highest(cycle.panels, heights if upper else -heights))


def _touch(cycle: Cycle, slope: float, at: float) -> Touch:
    at = float(at)
    return Touch(slope, at, _either(cycle, cycle.varying, at), _either(cycle, cycle.work, at))


def _either(cycle: Cycle, values: Array, at: float) -> float:
    """At the end of the period the value there, not that of the beginning: rounding of the work may part them."""
    if at >= cycle.panels.period:
        return float(cycle.panels.ends(values)[-1, 1])
    return cycle.at(values, at)


def _method(key: str, upper: Touch, lower: Touch, delta: float, mean: float) -> Method:
    return Method(key, (upper.cut - lower.cut) / (delta * mean**2), upper, lower)


def exact(cycle: Cycle, delta: float, mean: float) -> Method:
    """The true solution: slopes ω_max²/2 and ω_min²/2, ω_m(1 ± δ/2). `mean`: ω_m, rad/s."""
    most, least = mean * (1 + delta / 2), mean * (1 - delta / 2)
    upper, lower = tangent(cycle, most**2 / 2, True), tangent(cycle, least**2 / 2, False)
    return _method("exact", upper, lower, delta, mean)


def wittenbauer(cycle: Cycle, delta: float, mean: float) -> Method:
    """Tangents to the energy–mass curve at tan ψ = ω_m²(1 ± δ)/2, where δ²/4 is left out of (1 ± δ/2)².
    (Wittenbauer; Artobolevsky, Theory of mechanisms and machines, ch. 19)"""
    upper = tangent(cycle, mean**2 * (1 + delta) / 2, True)
    lower = tangent(cycle, mean**2 * (1 - delta) / 2, False)
    return _method("wittenbauer", upper, lower, delta, mean)


def mertsalov(cycle: Cycle, delta: float, mean: float) -> Method:
    """The energy of the second group of links is taken at the mean speed, T_II = J_II ω_m²/2; what the first group must
    take up is ΔT_I = A − T_II, and J_I its swing by δω_m². (Mertsalov; Frolov (ed.), Theory of mechanisms, ch. 4)
    Of the exact one it is too large by some mean value of J_II."""
    upper, lower = tangent(cycle, mean**2 / 2, True), tangent(cycle, mean**2 / 2, False)
    return _method("mertsalov", upper, lower, delta, mean)


def rerikh(cycle: Cycle, delta: float, mean: float) -> Method:
    """The excess moment is taken as the force analysis at constant speed has it, with the inertia forces of the links,
    M − ω_m²J_II′/2: it passes through zero where its work is greatest and least. The equation of energy is written
    between these two positions, ω_max² and ω_min² as ω_m²(1 ± δ). Never above Wittenbauer's, which moves the positions
    to where the tangents touch. (the formulation taken here of the methods of Rerikh and of Artobolevsky)"""
    middle = mean**2 / 2
    greatest, least = tangent(cycle, middle, True).at, tangent(cycle, middle, False).at
    upper, lower = (
        _touch(cycle, middle * (1 + delta), greatest),
        _touch(cycle, middle * (1 - delta), least),
    )
    return _method("rerikh", upper, lower, delta, mean)


def constant(cycle: Cycle, delta: float, mean: float) -> Method:
    """The estimate δ = A_ex/(J_r ω_m²) with a constant J_r = J_I + the mean of J_II."""
    (_, least), (_, greatest) = cycle.swing
    upper, lower = _touch(cycle, 0.0, greatest), _touch(cycle, 0.0, least)
    found = _method("constant", upper, lower, delta, mean)
    return Method(found.key, found.inertia - cycle.mean_inertia, upper, lower)


METHODS: tuple[Callable[[Cycle, float, float], Method], ...] = (
    exact,
    mertsalov,
    wittenbauer,
    rerikh,
    constant,
)


# ---------------------------------------------------------------- the highest place


def highest(over: Panels, values: Array) -> float:
    """The angle of the greatest value of a function (K, n), of equal ones the first: as `extremes` of the panels, but
    only panels are looked into that may hold it, as a tangent is laid some twenty times for a flywheel."""
    rows = np.concatenate([values, over.ends(values)], axis=1)
    top = rows.max(axis=1)
    # between its points a polynomial of this degree rises above them by less than they differ
    rivals = np.flatnonzero(2 * top - rows.min(axis=1) >= top.max())
    places, heights = _places(over, rivals, values[rivals])
    order = np.argsort(places, kind="stable")
    near = 1e-13 * np.abs(heights).max()
    return float(places[order][heights[order] >= heights.max() - near][0])


def _places(over: Panels, rivals: Array, values: Array) -> tuple[Array, Array]:
    """Ends, points and summits of some panels, and the function there."""
    grid, series, first, second, rises = _legendre(over.order)
    rise = values @ rises.T
    k, i = np.nonzero((rise[:, :-1] > 0) & (rise[:, 1:] <= 0))
    t = _summits(values[k] @ first.T, values[k] @ second.T, grid[i], grid[i + 1])
    summits = np.sum(_basis(t, over.order) * (values[k] @ series.T), axis=1)
    left, half = over.edges[rivals, None], over.half[rivals]
    inside = left + half * (1 + grid)
    inside[:, -1] = over.edges[rivals + 1]
    tops = (left + half)[k, 0] + half[k, 0] * t
    known = np.concatenate([over.ends(values)[:, :1], values, over.ends(values)[:, 1:]], axis=1)
    return np.concatenate([inside.ravel(), tops]), np.concatenate([known.ravel(), summits])


def _summits(first: Array, second: Array, low: Array, high: Array) -> Array:
    """Where series (m, n) pass from above zero to below it, between `low` and `high` (m,): by Newton's method with the
    series of their derivatives, kept between the ends by halving."""
    order = first.shape[-1]
    t = (low + high) / 2
    for _ in range(60):
        basis = _basis(t, order)
        value, slope = np.sum(basis * first, axis=1), np.sum(basis * second, axis=1)
        low, high = np.where(value > 0, t, low), np.where(value > 0, high, t)
        step = t - value / np.where(slope < 0, slope, -np.inf)
        step = np.where((step >= low) & (step <= high) & (slope < 0), step, (low + high) / 2)
        if np.all(np.abs(step - t) < 1e-15):
            break
        t = step
    return t


def _basis(t: Array, order: int) -> Array:
    return np.polynomial.legendre.legvander(t, order - 1)


@cache
def _legendre(order: int) -> tuple[Array, Array, Array, Array, Array]:
    """Of a panel on [-1, 1]: its ends and points; from the values at its points the series of the function, of its
    first and of its second derivative, and the first derivative at ends and points."""
    grid = np.concatenate([[-1.0], np.polynomial.legendre.leggauss(order)[0], [1.0]])
    series = np.linalg.inv(_basis(grid[1:-1], order))
    first, second = (np.polynomial.legendre.legder(series, m) for m in (1, 2))
    first, second = (np.pad(each, ((0, order - len(each)), (0, 0))) for each in (first, second))
    return grid, series, first, second, _basis(grid, order) @ first


# ---------------------------------------------------------------- dimensions


def disc(inertia: float, ratio: float, density: float) -> float:
    """Diameter D, m, of a solid disc of width ratio·D: J = πρ·ratio·D⁵/32."""
    return (32 * inertia / (math.pi * density * ratio)) ** 0.2


def disc_width(inertia: float, diameter: float, density: float) -> float:
    """Width, m, of a solid disc of a stated diameter."""
    return 32 * inertia / (math.pi * density * diameter**4)


def rim(inertia: float, height: float, width: float, density: float) -> float:
    """Mean diameter D, m, of a rim of rectangular section: height·D radially, width·(height·D) along the axis.
    J = m(D² + h²)/4, m = πρDhb: the sum of R₁² and R₂² of a ring is (D² + h²)/2."""
    return (4 * inertia / (math.pi * density * width * height**2 * (1 + height**2))) ** 0.2


def rim_height(inertia: float, diameter: float, width: float, density: float) -> float:
    """Height h, m, of the rim of a stated mean diameter, b = width·h: h²(D² + h²) = 4J/(πρ D·width)."""
    c = 4 * inertia / (math.pi * density * diameter * width)
    return math.sqrt((math.sqrt(diameter**4 + 4 * c) - diameter**2) / 2)


def hoop_stress(density: float, speed: float) -> float:
    """σ = ρv² in a thin rim that turns, Pa."""
    return density * speed**2
