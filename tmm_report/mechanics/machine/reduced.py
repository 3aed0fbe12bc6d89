"""A machine reduced to one shaft: moment of inertia over the cycle and what acts, by angle or by speed and time.

    d(J ω²/2)/dφ = M,    J dω/dt + J′ ω²/2 = M,    M = Σ M_i(φ) + Σ ±M_k(ω, t) − M_lost(ε)

What depends on the angle alone stands as values at the points of the panels, all else as a characteristic; what the
gears lose by the acceleration ε follows from the others.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.laws import SPEED, TIME
from tmm_report.mechanics.calculus.panels import Panels
from tmm_report.mechanics.calculus.roots import bisected
from tmm_report.mechanics.machine.characteristics import Characteristic
from tmm_report.mechanics.machine.passing import Passing
from tmm_report.records import dataclass

Array = Any
LOST = "gears"  # key of the work that the gears lose by the acceleration


@dataclass(frozen=True, eq=False)
class Acting:
    """What acts on the shaft: `values` (K, n), N m, in the sense of rotation, or `law`, whose moment counts with
    `sign`. `key` names it."""

    key: str
    values: Array = None
    law: Characteristic | None = None
    sign: float = 1.0

    @property
    def by_angle(self) -> bool:
        return self.law is None

    def at(self, omega: Array, t: Array = 0.0) -> Array:
        """Of a law."""
        assert self.law is not None
        return self.sign * self.law.at(omega, 0.0, t)

    def breaks(self, of: str) -> list[float]:
        """Speeds, rad/s, or times, s, at which its moment has a corner or a jump."""
        return [] if self.law is None or self.law.of != of else [one.at for one in self.law.breaks()]


@dataclass(frozen=True, eq=False)
class Plant:
    """`inertia`, `slope` (K, n): J, kg m², and dJ/dφ, kg m²/rad, at the points of `panels`; `passing`: the geared parts
    whose acceleration costs losses, None where there are none."""

    panels: Panels
    inertia: Array
    slope: Array
    acting: tuple[Acting, ...]
    passing: Passing | None = None

    @cached_property
    def placed(self) -> Array:
        """All that depends on the angle alone, (K, n)."""
        return sum((one.values for one in self.acting if one.by_angle), np.zeros(self.panels.shape))

    @cached_property
    def laws(self) -> tuple[Acting, ...]:
        """All that does not."""
        return tuple(one for one in self.acting if not one.by_angle)

    @property
    def of(self) -> set[str]:
        """What the moment depends on besides the angle."""
        return {one.law.of for one in self.laws if one.law is not None} & {SPEED, TIME}

    @cached_property
    def even(self) -> bool:
        """Whether J and what depends on the angle are the same all round."""
        size = max(float(np.abs(self.placed).max()), 1e-300)
        flat = np.ptp(self.inertia) <= 1e-12 * float(self.inertia.max())
        return bool(flat and np.ptp(self.placed) <= 1e-12 * size)

    @property
    def mean_moment(self) -> float:
        """Of what depends on the angle alone, over the cycle, N m."""
        return float(self.panels.mean(self.placed))

    def net(self, omega: Array, t: Array = 0.0) -> Array:
        """Mean over the cycle of all the moment at a speed that does not change, N m."""
        return self.mean_moment + sum((one.at(omega, t) for one in self.laws), np.zeros(np.shape(omega)))

    def acted(self, omega: Array) -> Array:
        """Moment of all that acts at speeds at the points of the panels, N m, (K, n)."""
        return self.placed + sum((one.at(omega) for one in self.laws), np.zeros(np.shape(omega)))

    def lost(self, moment: Array, omega: Array, inertia: Array, slope: Array) -> Array:
        """What the gears lose more than at a constant speed, N m, where all else is `moment`; J and J′ at the angle."""
        if self.passing is None:
            return np.zeros(np.shape(moment))
        left = moment - slope * np.asarray(omega) ** 2 / 2
        return self.passing.lost(self.passing.acceleration(left, inertia))

    def accelerating(self, omega: Array) -> Array:
        """`net` less what the gears then lose, N m: of a moment of inertia that does not vary."""
        net = self.net(omega)
        return net - self.lost(net, omega, float(self.inertia.flat[0]), 0.0)

    @cached_property
    def places(self) -> Callable[[float], tuple[float, ...]]:
        """J, J′ and the moment by angle at any one angle, as plain numbers, for integrators."""
        return pointwise(self.panels, (self.inertia, self.slope, self.placed))

    def works(self, start: float, end: float) -> dict[str, float]:
        """Work of each that depends on the angle alone from one angle turned to another, J."""
        return {one.key: between(self.panels, one.values, start, end) for one in self.acting if one.by_angle}


def between(panels: Panels, values: Array, start: float, end: float) -> float:
    """Integral of a periodic function from one angle to another, any number of periods apart."""
    low, high = (_primitive(panels, values, x) for x in (start, end))
    return float(high - low)


def _primitive(panels: Panels, values: Array, x: float) -> float:
    turns, rest = divmod(x, panels.period)
    inside = 0.0
    if rest:
        k = int(np.clip(np.searchsorted(panels.edges, rest, side="right") - 1, 0, panels.shape[0] - 1))
        first = Panels(np.array([0.0, rest - panels.edges[k]]), panels.order)
        piece = (
            panels.at(values, panels.edges[k] + first.x[0]) if first.period > 0 else np.zeros(panels.order)
        )
        inside = panels.running_edges(values)[k] + (first.total(piece[None]) if first.period > 0 else 0.0)
    return float(turns * panels.total(values) + inside)


def pointwise(panels: Panels, functions: Sequence[Array]) -> Callable[[float], tuple[float, ...]]:
    """Functions (K, n) at one angle as plain numbers: a twentieth of the time of arrays of one element."""
    stack = np.array([np.broadcast_to(one, panels.shape) for one in functions])
    if all(np.ptp(one) == 0 for one in stack):
        fixed = tuple(float(one.flat[0]) for one in stack)
        return lambda phi: fixed
    unit = Panels(np.array([0.0, 2.0]), panels.order).x[0] - 1
    powers = np.linalg.inv(np.vander(unit, increasing=False))
    rows = np.einsum("ij,fkj->kfi", powers, stack).tolist()
    edges, half, period = panels.edges.tolist(), panels.half.ravel().tolist(), panels.period
    last = len(half) - 1

    def at(phi: float) -> tuple[float, ...]:
        x = phi % period
        k = min(bisect_right(edges, x) - 1, last)
        u = (x - edges[k]) / half[k] - 1
        found = []
        for row in rows[k]:
            total = 0.0
            for one in row:
                total = total * u + one
            found.append(total)
        return tuple(found)

    return at


def level(net: Callable[[Array], Array], start: float, top: float = 1e6) -> float | None:
    """The first speed above `start` at which a moment that drives at first no longer does, rad/s; None where it drives
    at every speed up to `top`. `start` itself where it does not drive there."""
    if float(net(start)) <= 0:
        return start
    high = max(1.0, 2 * start)
    grid = np.linspace(start, high, 400)
    while not (net(grid) <= 0).any():
        if high > top:
            return None
        grid, high = np.linspace(high, 2 * high, 400), 2 * high
    first = int(np.argmax(net(grid) <= 0))
    _, found = bisected(
        lambda omega: float(net(omega)) > 0, float(grid[max(first - 1, 0)]), float(grid[first])
    )
    return found
