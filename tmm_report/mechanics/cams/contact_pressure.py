"""Pressure in the contact of a cam and its follower, two cylinders that touch along a line (Hertz).

    σ = √(N / (π B ρ' θ)),   1/ρ' = 1/r + 1/ρ,   θ = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂

which of ν = 0.3 is σ = 0.418 √(N E'/(B ρ')), E' = 2E₁E₂/(E₁ + E₂). r is the radius of the roller (a flat face has
none), ρ that of the profile, below zero where it is concave.

Source: Timoshenko, Goodier, Theory of elasticity, ch. 13; Levitsky, Cam mechanisms, ch. 5.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from tmm_report.mechanics.cams.cam import Cam
from tmm_report.records import dataclass

Array = Any


@dataclass(frozen=True)
class Material:
    """Young's modulus, Pa, and Poisson's ratio."""

    E: float
    nu: float

    @property
    def yields(self) -> float:
        """(1 − ν²)/E, 1/Pa."""
        return (1 - self.nu**2) / self.E


def curvature(cam: Cam, phi: Array, outer: Array | bool = False) -> Array:
    """1/ρ', 1/m, (P,), of a roller or a flat face at angles of the cam's x axis; `outer`: on the outer wall of a
    groove, which is hollow where the pitch curve is convex."""
    radius = cam.contact(phi).radius
    if cam.flat:
        return 1 / radius
    roller = cam.roller or np.nan  # an edge has no pressure along a line
    return 1 / roller + np.where(outer, -1 / (radius + roller), 1 / (radius - roller))


def hertz(N: Array, width: float, curved: Array, one: Material, other: Material) -> Array:
    """Greatest pressure, Pa, of a force, N, over a width, m, at 1/ρ', 1/m; 0 where nothing presses."""
    pressing = np.maximum(np.abs(N), 0.0) * np.maximum(curved, 0.0)
    return np.sqrt(pressing / (np.pi * width * (one.yields + other.yields)))
