"""The steady motion of a machine with a flywheel: by the energy integral, and step by step as a proof of it.

See `flywheel` for the symbols. Energy: ω² = 2(T₀ + A)/(J_I + J_II); the greatest and the least speed stand where the
tangents of slopes ω_max²/2 and ω_min²/2 touch the energy–mass curve. (Artobolevsky, Theory of mechanisms and machines,
ch. 16, 19)
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import newton
from tmm_report.mechanics.machine.flywheel.inertia import Cycle, Tangents, Touch, tangents
from tmm_report.records import dataclass

Array = Any
STEPS = 8  # steps of the integration in a panel
STILL = 2.0  # unevenness of a machine that just comes to a stand once a cycle


@dataclass(frozen=True, eq=False)
class Turning:
    """The steady motion with a constant moment of inertia `fixed` besides J_II: `delta`; `start`: T₀, J, the energy at
    the beginning of the cycle; the greatest and the least speed as touching lines; `omega` (K, n), rad/s."""

    cycle: Cycle
    fixed: float
    mean: float
    delta: float
    start: float
    upper: Touch
    lower: Touch

    @cached_property
    def inertia(self) -> Array:
        return self.fixed + self.cycle.varying

    @cached_property
    def omega(self) -> Array:
        return np.sqrt(2 * (self.start + self.cycle.work) / self.inertia)

    @cached_property
    def epsilon(self) -> Array:
        """Angular acceleration ε = (M − ω²J′/2)/J, rad/s²."""
        return (self.cycle.moment - self.omega**2 * self.cycle.slope / 2) / self.inertia

    @property
    def greatest(self) -> float:
        return self.mean * (1 + self.delta / 2)

    @property
    def least(self) -> float:
        return self.mean * (1 - self.delta / 2)


def turning(cycle: Cycle, fixed: float, mean: float) -> Turning | None:
    """The steady motion of mean speed `mean`, rad/s; None where the machine comes to a stand on the way, or would have
    to turn faster than twice the mean to pass. By Newton's method on (P − Q) − fixed·δω_m², which falls with δ."""
    if fixed + np.min(cycle.varying) <= 0 or _left(cycle, fixed, mean, STILL, _nearly)[0] >= 0:
        return None
    delta = newton(lambda x: _left(cycle, fixed, mean, x, _nearly)[:2], 0.0, STILL, 0.0)
    delta = newton(lambda x: _left(cycle, fixed, mean, x, tangents)[:2], 0.0, STILL, delta)
    upper, lower = _left(cycle, fixed, mean, delta, tangents)[2]
    # of the same line the energy at the beginning: at the least speed little of it is left to round
    start = fixed * lower.slope - lower.cut
    return Turning(cycle, fixed, mean, delta, start, upper, lower)


Left = tuple[float, float, Tangents]
Touching = Callable[[Cycle, float, float], Tangents]


def _left(cycle: Cycle, fixed: float, mean: float, delta: float, touching: Touching) -> Left:
    """(P − Q) − J_I δω_m² at a δ, its derivative by δ, and both tangents."""
    most, least = mean * (1 + delta / 2), mean * (1 - delta / 2)
    upper, lower = touching(cycle, most**2 / 2, least**2 / 2)
    slope = -mean / 2 * (most * upper.inertia + least * lower.inertia) - fixed * mean**2
    return upper.cut - lower.cut - fixed * delta * mean**2, slope, (upper, lower)


def _nearly(cycle: Cycle, upper: float, lower: float) -> Tangents:
    """`tangents` to the nearest of the panels' points: to begin with."""
    above, below = (cycle.work - slope * cycle.varying for slope in (upper, lower))
    return _at_point(cycle, upper, int(above.argmax())), _at_point(cycle, lower, int(below.argmin()))


def _at_point(cycle: Cycle, slope: float, k: int) -> Touch:
    at, inertia, work = (float(values.flat[k]) for values in (cycle.panels.x, cycle.varying, cycle.work))
    return Touch(slope, at, inertia, work)


# ---------------------------------------------------------------- proof by integration


@dataclass(frozen=True, eq=False)
class Integrated:
    """ω (S+1,), rad/s, at the angles x (S+1,) of a step-by-step integration over the cycle."""

    x: Array
    omega: Array
    slope: Array

    @property
    def closure(self) -> float:
        """By how much ω at the end differs from ω at the beginning, relative."""
        return float(abs(self.omega[-1] / self.omega[0] - 1))

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Least and greatest ω: of the cubics through values and slopes at the ends of the steps."""
        h, y, d = np.diff(self.x), self.omega, self.slope
        k = np.flatnonzero((d[:, 0] * d[:, 1] < 0) & (h > 0))
        h, ya, yb, da, db = h[k], y[k], y[k + 1], d[k, 0] * h[k], d[k, 1] * h[k]
        a, b = 2 * (ya - yb) + da + db, -3 * (ya - yb) - 2 * da - db
        # the slope 3a t² + 2b t + da changes its sign once within the step
        root = np.sqrt(np.maximum(b * b - 3 * a * da, 0.0))
        t = -da / np.where(b >= 0, b + root, b - root)
        t = np.where((t >= 0) & (t <= 1), t, (-b - np.copysign(root, b)) / np.where(a == 0, np.inf, 3 * a))
        peaks = ya + t * (da + t * (b + t * a))
        every = np.concatenate([y, peaks])
        return float(every.min()), float(every.max())

    @property
    def delta(self) -> float:
        low, high = self.ends
        return 2 * (high - low) / (high + low)


def integrated(cycle: Cycle, fixed: float, start: float, steps: int = STEPS) -> Integrated:
    """J ω dω/dφ = M − ω²J′/2 integrated from ω = `start` over the cycle by the method of Runge and Kutta of the fourth
    order, `steps` equal steps in every panel: no work is summed up, so it is another way to the motion."""
    inside = _fractions(cycle.panels.order, steps)
    moment, inertia, slope = (
        (values @ inside.T) for values in (cycle.moment, cycle.varying + fixed, cycle.slope / 2)
    )
    h = (2 * cycle.panels.half / steps).ravel()
    omega, rates = _stepped(moment.tolist(), inertia.tolist(), slope.tolist(), h.tolist(), start, steps)
    starts = cycle.panels.edges[:-1, None] + h[:, None] * np.arange(steps)
    x = np.append(starts.ravel(), cycle.panels.period)
    return Integrated(x, np.array(omega), np.array(rates))


def _stepped(
    moment: list[list[float]],
    inertia: list[list[float]],
    slope: list[list[float]],
    h: list[float],
    start: float,
    steps: int,
) -> tuple[list[float], list[tuple[float, float]]]:
    """ω at the ends of the steps; dω/dφ at both ends of each step, of its own panel."""
    w, omega, rates = start, [start], []
    for M, J, s, d in zip(moment, inertia, slope, h, strict=True):
        for k in range(0, 2 * steps, 2):
            a = (M[k] / w - w * s[k]) / J[k]
            u = w + a * d / 2
            b = (M[k + 1] / u - u * s[k + 1]) / J[k + 1]
            u = w + b * d / 2
            c = (M[k + 1] / u - u * s[k + 1]) / J[k + 1]
            u = w + c * d
            e = (M[k + 2] / u - u * s[k + 2]) / J[k + 2]
            w += d * (a + 2 * b + 2 * c + e) / 6
            omega.append(w)
            rates.append((a, (M[k + 2] / w - w * s[k + 2]) / J[k + 2]))
    return omega, rates


@cache
def _fractions(order: int, steps: int) -> Array:
    """From the values at a panel's points to those at its ends and at each half of a step, (2 steps + 1, n)."""
    points, _ = np.polynomial.legendre.leggauss(order)
    to_coefficients = np.linalg.inv(np.polynomial.legendre.legvander(points, order - 1))
    where = np.linspace(-1.0, 1.0, 2 * steps + 1)
    return np.polynomial.legendre.legvander(where, order - 1) @ to_coefficients
