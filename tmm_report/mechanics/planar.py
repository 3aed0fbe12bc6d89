"""Plane vectors as complex numbers: x + iy. Everything broadcasts over leading axes."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = Any  # ndarray or scalar that broadcasts


def cross(a: Array, b: Array) -> Array:
    """a × b, the moment of b about the tail of a, + counter-clockwise."""
    return a.real * b.imag - a.imag * b.real


def dot(a: Array, b: Array) -> Array:
    return a.real * b.real + a.imag * b.imag


def resolve(d: Array, e1: Array, e2: Array) -> tuple[Array, Array]:
    """The numbers x, y with x·e1 + y·e2 = d (Cramer). Parallel e1, e2 give inf or nan."""
    inverse = 1.0 / cross(e1, e2)
    return cross(d, e2) * inverse, cross(e1, d) * inverse


def sine(e1: Array, e2: Array) -> Array:
    """|sin| of the angle between two directions: 1 far from a singular position, 0 in it."""
    return np.abs(cross(e1, e2)) / (np.abs(e1) * np.abs(e2))


def unit(v: Array) -> Array:
    """v / |v|; nan where v = 0."""
    return v / np.abs(v)
