"""The integral of a function over a cycle from its values at equal steps, by the formulas of the textbooks.

Over a whole period of a smooth function the trapezoidal rule is exact but for harmonics beyond the steps, and no other
rule of equal steps is better; Simpson's errs as it does with half as many. A kink or a jump leaves an error
of the second or the first order of all of them, while the pieces between the breaks are again smooth: so Gauss's
formula on panels, which ends at every break, is the exact one. A periodic spline through equal steps has the
trapezoidal sum as its integral, to the last term: its bends add up to nothing. (Davis, Rabinowitz, Methods of numerical
integration, ch. 2; Trefethen, Weideman, The exponentially convergent trapezoidal rule, SIAM Review 56)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.panels import panels
from tmm_report.mechanics.rivals.model import Method
from tmm_report.mechanics.rivals.tables import spline_along
from tmm_report.problems import N_
from tmm_report.records import dataclass

Array = Any
ALIKE = 1e-9  # of the largest value: ends that differ by less are one


@dataclass(frozen=True, eq=False)
class Sampled:
    """A function over a cycle: `of(x)`: its values (..., P) at angles (P,) from 0 to `period`, rad, both ends among
    them; `breaks`: where it has a kink or a jump."""

    of: Callable[[Array], Array]
    period: float
    breaks: Array = ()

    def table(self, count: int) -> tuple[Array, float]:
        """Values at `count` equal steps, the last included, (..., count + 1), and the step."""
        step = self.period / count
        return np.asarray(self.of(np.arange(count + 1) * step), dtype=float), step


IntegralMethod = Method[Sampled, Array]


def trapezoid(values: Array, step: float) -> Array:
    """h (y₀/2 + y₁ + … + y_n/2)."""
    return step * (np.sum(values, axis=-1) - (values[..., 0] + values[..., -1]) / 2)


def simpson(values: Array, step: float) -> Array:
    """h/3 (y₀ + 4y₁ + 2y₂ + … + y_n). Raises ArithmeticError for an odd number of steps."""
    if values.shape[-1] % 2 == 0:
        raise ArithmeticError(N_("Simpson's rule takes an even number of steps"))
    odd, even = np.sum(values[..., 1::2], axis=-1), np.sum(values[..., ::2], axis=-1)
    return step / 3 * (4 * odd + 2 * even - values[..., 0] - values[..., -1])


def spline(values: Array, step: float) -> Array:
    """Of the cubic spline: the trapezoidal sum less h³/24 Σ (M_k + M_k+1) of its bends, which are nothing together
    where it repeats."""
    whole = trapezoid(values, step)
    apart = np.abs(values[..., 0] - values[..., -1])
    if np.all(apart <= ALIKE * np.max(np.abs(values), axis=-1, initial=0.0)):
        return whole
    bend = spline_along(values, step)[1]
    return whole - step**2 / 12 * trapezoid(bend, step)


def exact(scene: Sampled, count: int = 0) -> Array:
    """By Gauss's formula on panels that end at the breaks. A value that stands on a break is taken by none of them."""
    over = panels(scene.period, scene.breaks)
    values = np.asarray(scene.of(over.x.ravel()), dtype=float)
    return over.total(values.reshape(*values.shape[:-1], *over.shape))


INTEGRALS: tuple[IntegralMethod, ...] = (
    Method("panels", N_("Gauss's formula between the breaks"), exact),
    Method("trapezoid", N_("trapezoidal rule"), lambda scene, count: trapezoid(*scene.table(count))),
    Method("simpson", N_("Simpson's rule"), lambda scene, count: simpson(*scene.table(count))),
    Method(
        "spline_integral", N_("integral of a cubic spline"), lambda scene, count: spline(*scene.table(count))
    ),
)
