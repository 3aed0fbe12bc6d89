"""Functions stated by points that repeat with every period."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Array = Any


def repeated(at: Array, x: Sequence[float], y: Sequence[float], period: float) -> Array:
    """Straight lines between points that ascend and lie within one period, the last joined to the first of the next
    one. numpy's own `period` puts the two values of a jump, and of an end that is not the beginning, the wrong way
    round."""
    places, values = np.append(x, x[0] + period), np.append(y, y[0])
    return np.interp(x[0] + np.mod(np.asarray(at) - x[0], period), places, values)
