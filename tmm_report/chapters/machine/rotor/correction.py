"""What balances a rotor in one plane: the weight by its product, as it follows and as it is made."""

from __future__ import annotations

import numpy as np

from tmm_report.chapters.machine.rotor.given import Given, Steps
from tmm_report.quantity.paper import rounded
from tmm_report.records import dataclass

PLANES = ("I", "II")


@dataclass(frozen=True)
class Correction:
    """What balances in a plane: `product`, kg m; the weight at `angle`, rad, opposite where material is taken off;
    `made`: product of the weight as it is made, by the steps; `mass`, `radius`, `angle`: exact, then as made."""

    name: str
    at: float
    product: complex
    mass: float
    radius: float
    angle: float
    made_mass: float
    made_radius: float
    made_angle: float
    remove: bool

    @property
    def direction(self) -> float:
        """Angle of the product, rad; nan of a plane that needs no weight."""
        return float(np.angle(self.product)) if self.product else np.nan

    @property
    def made(self) -> complex:
        sign = -1 if self.remove else 1
        return complex(sign * self.made_mass * self.made_radius * np.exp(1j * self.made_angle))


def correction(given: Given, k: int, product: complex) -> Correction:
    """What balances `product`, kg m, in the plane number `k`, exactly and as it is made."""
    plane, steps = given.planes[k], given.steps or Steps()
    angle = float(np.angle(-product if plane.remove else product)) % (2 * np.pi)
    mass = plane.mass or abs(product) / (plane.radius or 1.0)
    radius = plane.radius or abs(product) / mass
    return Correction(
        PLANES[k] if len(given.planes) == 2 else PLANES[0],
        plane.at,
        product,
        mass,
        radius,
        angle,
        rounded(mass, steps.mass) if plane.mass is None else mass,
        rounded(radius, steps.radius) if plane.radius is None else radius,
        rounded(angle, steps.angle),
        plane.remove,
    )
