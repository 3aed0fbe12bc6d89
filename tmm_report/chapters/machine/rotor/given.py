"""What is given of masses on a turning shaft."""

from __future__ import annotations

from tmm_report.quantity.paper import ACCURACY
from tmm_report.records import dataclass


@dataclass(frozen=True)
class Heavy:
    """A mass off the axis, an unbalance m·r stated as it is, or a body set with an eccentricity and askew.

    `product`: m r, kg m, a magnitude; `angle` from x, rad; `at`: along the shaft, m; `mass`, `radius`: where they are
    stated; `couple`: products of inertia J_xz + i J_yz, kg m²; `body`: whether it is a body on the shaft.
    """

    name: str
    product: float
    angle: float
    at: float
    mass: float | None = None
    radius: float | None = None
    couple: complex = 0j
    body: bool = False


@dataclass(frozen=True)
class Plane:
    """A plane of correction at `at`, m: where the weight's radius is stated its mass is found, and the other way about.
    `remove`: the mass is taken off the opposite side, as by drilling."""

    at: float
    radius: float | None = None
    mass: float | None = None
    remove: bool = False


@dataclass(frozen=True)
class Steps:
    """How finely weights are made: mass, kg, radius, m, angle, rad; 0: exactly."""

    mass: float = 0.0
    radius: float = 0.0
    angle: float = 0.0


@dataclass(frozen=True, eq=False)
class Given:
    """SI. `planes`: one (force alone balanced) or two; `bearings`: places of A and B; `grade`: e ω, m/s; `mass`: of the
    whole rotor, and `centre`, the place of its mass centre; `diameter`, `width`: they say which balance suffices;
    `accuracy`: of the polygons, m of paper."""

    heavy: tuple[Heavy, ...]
    planes: tuple[Plane, ...]
    bearings: tuple[float, float] | None = None
    speed: float | None = None
    grade: float | None = None
    mass: float | None = None
    centre: float | None = None
    diameter: float | None = None
    width: float | None = None
    steps: Steps | None = None
    accuracy: float = ACCURACY
    name: str = ""
