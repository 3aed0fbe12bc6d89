"""Plane vectors as complex numbers: x + iy. Everything broadcasts over leading axes."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any  # ndarray or scalar that broadcasts
NOWHERE = complex(np.nan, np.nan)  # a vector that does not exist: none of its components does


def cross(a: Array, b: Array) -> Array:
    """a × b, the moment of b about the tail of a, + counter-clockwise."""
    return (a.conjugate() * b).imag


def dot(a: Array, b: Array) -> Array:
    return (a.conjugate() * b).real


def dual(e1: Array, e2: Array) -> tuple[Array, Array]:
    """Vectors k1, k2 by which any d = x·e1 − y·e2 is resolved: x = d × k1, y = d × k2 (Cramer).

    Parallel e1, e2 give inf or nan.
    """
    area = cross(e1, e2)
    return np.divide(e2, area), np.divide(e1, area)


def components(d: Array, k1: Array, k2: Array) -> tuple[Array, Array]:
    """d × k1 and d × k2."""
    mirrored = d.conjugate()
    return (mirrored * k1).imag, (mirrored * k2).imag


def resolve(d: Array, e1: Array, e2: Array) -> tuple[Array, Array]:
    """The numbers x, y with x·e1 + y·e2 = d. Parallel e1, e2 give inf or nan."""
    return components(d, *dual(e1, -e2))


def sine(e1: Array, e2: Array) -> Array:
    """|sin| of the angle between two directions: 1 far from a singular position, 0 in it."""
    return np.abs(cross(e1, e2)) / (np.abs(e1) * np.abs(e2))


def unit(v: Array) -> Array:
    """v / |v|; nan where v = 0."""
    return v / np.abs(v)


def if_known(known: Array, values: Array) -> Array:
    """Numbers or vectors where they are known, elsewhere nan: of a vector both components."""
    return np.where(known, values, NOWHERE if np.iscomplexobj(values) else np.nan)


def is_zero(x: Array) -> bool:
    """Whether a number, or all of an array, is 0. Cheap for a plain number, which most data are."""
    return not x.any() if isinstance(x, np.ndarray) else x == 0
