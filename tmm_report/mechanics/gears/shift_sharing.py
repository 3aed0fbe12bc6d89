"""How the sum of the shifts is divided between the two wheels."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.mechanics.calculus.roots import first_root
from tmm_report.mechanics.gears.meshing import Pair, Rack

Array = Any
SHIFTS = np.linspace(-5.0, 5.0, 129)  # among which that of equal sliding is looked for


def rule_teeth(rack: Rack) -> float:
    """The least number of teeth without undercut, rounded down: 17 for 20° and ha* = 1."""
    return float(np.floor(2 * rack.ha / np.sin(rack.alpha) ** 2))


def rule_shift(z: Array, rack: Rack, beta: float = 0.0) -> Array:
    """The course's rule: ha* (17 − z)/17, 17 being the least number of teeth of the rack rounded down; not below 0.

    z of helical teeth is that of the equivalent straight ones, z/cos³β.
    """
    least = rule_teeth(rack)
    return np.maximum(rack.ha * (least - z / np.cos(beta) ** 3) / least, 0.0)


def equal_sliding(pair: Pair) -> float:
    """x1 at which both roots slide equally, the centre distance and the sum of shifts kept; nan where there is none.

    `Pair.sliding_difference` falls steadily between the shifts at which either tip reaches the other's base circle.
    """

    def difference(x1: Array) -> Array:
        trial = with_first_shift(pair, x1)
        sound = (trial.rho_p[0] > 0) & (trial.rho_p[1] > 0) & (trial.active > 0)
        return np.where(sound, trial.sliding_difference, np.nan)

    found = first_root(difference, SHIFTS)
    return float("nan") if found is None else found


def with_first_shift(pair: Pair, x1: Array) -> Pair:
    """The same pair with wheel 1 shifted by x1 and wheel 2 so that `x_sum` stays."""
    return filling(pair, 0, x1, pair.x_sum)


def filling(pair: Pair, wheel: int, x: Array, x_sum: Array) -> Pair:
    """The same pair with one wheel (0 or 1) shifted by x and the other so that `Pair.x_sum` becomes x_sum."""
    own, other = pair.signs[wheel], pair.signs[1 - wheel]
    rest = other * (pair.side * x_sum - own * x)
    return replace(pair, x1=x, x2=rest) if wheel == 0 else replace(pair, x1=rest, x2=x)
