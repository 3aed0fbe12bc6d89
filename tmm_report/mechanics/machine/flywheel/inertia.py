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
from tmm_report.mechanics.calculus.zeros import evaluated, grid, zeros
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

    @cached_property
    def curve(self) -> Array:
        """The energy–mass curve: J_II and A, (2, K, n)."""
        return np.stack([self.varying, self.work])


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


Tangents = tuple[Touch, Touch]


def tangents(cycle: Cycle, upper: float, lower: float) -> Tangents:
    """The supporting lines of the slope `upper` above the energy–mass curve and of the slope `lower` below it."""
    above, below = (cycle.work - slope * cycle.varying for slope in (upper, lower))
    return touches(cycle, upper, lower, highest(cycle.panels, np.stack([above, -below])))


def touches(cycle: Cycle, upper: float, lower: float, at: Array) -> Tangents:
    """Lines of two slopes through the curve at two angles (2,). At the end of the period they have the values there,
    not those of the beginning: rounding of the work may part them."""
    end = cycle.panels.ends(cycle.curve)[:, -1:, 1]
    found = np.where(at >= cycle.panels.period, end, cycle.panels.at(cycle.curve, at))
    (one, other), (work, its) = found.tolist()
    return Touch(upper, float(at[0]), one, work), Touch(lower, float(at[1]), other, its)


def _method(key: str, upper: Touch, lower: Touch, delta: float, mean: float) -> Method:
    return Method(key, (upper.cut - lower.cut) / (delta * mean**2), upper, lower)


def exact(cycle: Cycle, delta: float, mean: float) -> Method:
    """The true solution: slopes ω_max²/2 and ω_min²/2, ω_m(1 ± δ/2). `mean`: ω_m, rad/s."""
    most, least = mean * (1 + delta / 2), mean * (1 - delta / 2)
    upper, lower = tangents(cycle, most**2 / 2, least**2 / 2)
    return _method("exact", upper, lower, delta, mean)


def wittenbauer(cycle: Cycle, delta: float, mean: float) -> Method:
    """Tangents to the energy–mass curve at tan ψ = ω_m²(1 ± δ)/2, where δ²/4 is left out of (1 ± δ/2)².
    (Wittenbauer; Artobolevsky, Theory of mechanisms and machines, ch. 19)"""
    upper, lower = tangents(cycle, mean**2 * (1 + delta) / 2, mean**2 * (1 - delta) / 2)
    return _method("wittenbauer", upper, lower, delta, mean)


def mertsalov(cycle: Cycle, delta: float, mean: float) -> Method:
    """The energy of the second group of links is taken at the mean speed, T_II = J_II ω_m²/2; what the first group must
    take up is ΔT_I = A − T_II, and J_I its swing by δω_m². (Mertsalov; Frolov (ed.), Theory of mechanisms, ch. 4)
    Of the exact one it is too large by some mean value of J_II."""
    upper, lower = tangents(cycle, mean**2 / 2, mean**2 / 2)
    return _method("mertsalov", upper, lower, delta, mean)


def rerikh(cycle: Cycle, delta: float, mean: float) -> Method:
    """The excess moment is taken as the force analysis at constant speed has it, with the inertia forces of the links,
    M − ω_m²J_II′/2: it passes through zero where its work is greatest and least. The equation of energy is written
    between these two positions, ω_max² and ω_min² as ω_m²(1 ± δ). Never above Wittenbauer's, which moves the positions
    to where the tangents touch. (the formulation taken here of the methods of Rerikh and of Artobolevsky)"""
    middle = mean**2 / 2
    at = np.array([touch.at for touch in tangents(cycle, middle, middle)])
    upper, lower = touches(cycle, middle * (1 + delta), middle * (1 - delta), at)
    return _method("rerikh", upper, lower, delta, mean)


def constant(cycle: Cycle, delta: float, mean: float) -> Method:
    """The estimate δ = A_ex/(J_r ω_m²) with a constant J_r = J_I + the mean of J_II."""
    (_, least), (_, greatest) = cycle.swing
    upper, lower = touches(cycle, 0.0, 0.0, np.array([greatest, least]))
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


def highest(over: Panels, values: Array) -> Array:
    """The angles of the greatest values of functions (F, K, n), of equal ones the first, (F,): as `extremes` of the
    panels, but only panels are looked into that may hold it, as tangents are laid some ten times for a flywheel."""
    ends = over.ends(values)
    rows = np.concatenate([ends[..., :1], values, ends[..., 1:]], axis=-1)
    top = rows.max(axis=-1)
    # between its points a polynomial of this degree rises above them by less than they differ
    f, k = np.nonzero(2 * top - rows.min(axis=-1) >= top.max(axis=-1, keepdims=True))
    places, heights = _places(over, k, rows[f, k])
    return np.array([_first(places[f == one], heights[f == one]) for one in range(len(values))])


def _first(places: Array, heights: Array) -> float:
    """Of places (R, n) of heights, nan where there is none, the first of the highest."""
    near = 1e-13 * np.nanmax(np.abs(heights))
    return float(places[heights >= np.nanmax(heights) - near].min())


def _places(over: Panels, k: Array, rows: Array) -> tuple[Array, Array]:
    """Of functions in panels k (R,), by their values at ends and points (R, n + 2): ends, points and the summits after
    them, and the function there, (R, 2 n + 3); nan where there is no summit."""
    on, values = grid(over.order), rows[:, 1:-1]
    rise = values @ _rises(over.order).T
    r, i = np.nonzero((rise[:, :-1] > 0) & (rise[:, 1:] <= 0))
    t = zeros(rise[r, 1:-1], on[i], on[i + 1], np.ones(len(r)))
    half = over.half[k]
    known = over.edges[k, None] + half * (1 + on)
    known[:, -1] = over.edges[k + 1]
    places, heights = np.full((2, len(k), over.order + 1), np.nan)
    places[r, i] = over.edges[k[r]] + half[r, 0] * (1 + t)
    heights[r, i] = evaluated(values[r], t)
    return np.concatenate([known, places], axis=1), np.concatenate([rows, heights], axis=1)


@cache
def _rises(order: int) -> Array:
    """From the values at a panel's points to the derivative at its ends and points, (n + 2, n)."""
    series = np.linalg.inv(np.polynomial.legendre.legvander(grid(order)[1:-1], order - 1))
    return np.polynomial.legendre.legval(grid(order), np.polynomial.legendre.legder(series)).T


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
