"""Numbers, each once."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any


def distinct(values: Array) -> Array:
    """Ascending numbers (N,), equal ones once: as `numpy.unique`, which loads the masked arrays to look for them."""
    ordered = np.sort(np.ravel(values))
    new = np.ones(ordered.shape, dtype=bool)
    new[1:] = ordered[1:] != ordered[:-1]
    return ordered[new]
