"""What a person with pencil and paper makes of numbers: round scales, points placed and lengths read to so many mm.

With 0.01 mm a drawing is made by computer: its points are exact, and lengths are read to the accuracy.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.records import dataclass

Array = Any
ACCURACIES = (0.01, 0.1, 0.5)  # mm: by computer, with care, in haste
EXACT = 1e-12  # mm
CAD = 0.01  # mm: with this accuracy a drawing is made by computer
SHEET, LONGEST = 200.0, 180.0  # mm: of the scheme, of the longest vector of a plan
ROUND = np.array([1.0, 2.0, 2.5, 4.0, 5.0, 10.0])
DIGITS = 5


@dataclass(frozen=True, eq=False)
class Pen:
    """`accuracy`: mm; `metres`: m of the mechanism in a mm of the scheme."""

    accuracy: float
    metres: float

    def placed(self, point: Array) -> Array:
        """Where a point of a plan, mm, is put."""
        return (
            point
            if self.accuracy <= CAD
            else rounded(point.real, self.accuracy) + 1j * rounded(point.imag, self.accuracy)
        )

    def read(self, vector: Array) -> Array:
        """A vector of a plan with its length as it is read, mm."""
        size = np.abs(vector)
        return vector * (rounded(size, self.accuracy) / np.where(size > 0, size, 1.0))

    def moment(self, moment: Array, force: Array) -> Array:
        """Moment of a force, N m, whose arm is measured on the scheme. What has no arm on the sheet is a couple, and
        that is a number."""
        size = np.abs(force) * self.metres
        arm = moment / np.where(size > 0, size, np.nan)
        return written(np.where(np.abs(arm) < SHEET, rounded(arm, self.accuracy) * size, moment))


def rounded(x: Array, step: float) -> Array:
    """To a multiple of the step, half up."""
    return np.copysign(np.floor(np.abs(x) / step * (1 + 1e-12) + 0.5) * step, x)


def written(x: Array) -> Array:
    """With so many digits as a person writes."""
    size = np.abs(x)
    unit = 10.0 ** (np.floor(np.log10(np.where(size > 0, size, 1.0))) - (DIGITS - 1))
    return rounded(x / unit, 1.0) * unit


def round_scale(largest: Array, paper: float) -> Array:
    """The smallest round scale (1, 2, 2.5, 4, 5 · 10^n) at which `largest` (P,) is at most `paper` mm long."""
    least = np.where(largest > 0, largest, 1.0) / paper * (1 - 1e-9)
    decade = 10.0 ** np.floor(np.log10(least))
    return decade * ROUND[np.searchsorted(ROUND, least / decade)]
