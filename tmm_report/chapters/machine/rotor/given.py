"""What is given of masses on a turning shaft, as the block states it, SI."""

from __future__ import annotations

import math
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from tmm_report.mechanics.masses.rotor import tilted
from tmm_report.problems import N_, Message
from tmm_report.quantity import units
from tmm_report.quantity.paper import ACCURACY
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Accuracy,
        Angle,
        Distance,
        Flag,
        Inertia,
        Length,
        Mass,
        Name,
        Positive,
        PositiveMass,
        Reads,
        Scale,
        Speed,
        quantity,
    )


def read_product(value: Any) -> float:
    """A product of mass and radius as it is written, kg m. Raises WrongValue."""
    number, unit = units.measured(value)
    found = number * (units.between(unit, "kg*m") if unit else 1.0)
    if found > 1e12:
        text = N_("%(value)s is no product of mass and radius that there can be")
        raise WrongValue(
            Message(text, {"value": value}), Message(N_("a product such as 12 g*mm, or 0.02 kg*m"))
        )
    if found < 0:
        text = N_("%(value)s is negative: the product of mass and radius cannot be")
        raise WrongValue(Message(text, {"value": value}), Message(N_("turn its angle by 180 deg instead")))
    return found


PRODUCT = {
    "anyOf": [{"type": "number"}, {"type": "string"}],
    "description": "mass by radius: SI (kg*m) or text with a unit",
    "examples": ["12 g*mm"],
    "x-unit": "kg*m",
}


@dataclass(frozen=True)
class Heavy:
    """A mass off the axis: its mass and radius, or the product of both."""

    name: Annotated[Name | None, Field(description="left out, its number")] = None
    mass: Annotated[PositiveMass | None, Field(examples=["2 kg"])] = None
    radius: Annotated[Distance | None, Field(description="of its centre", examples=["30 mm"])] = None
    unbalance: Annotated[
        Annotated[float, Reads(read_product, PRODUCT)] | None,
        Field(description="mass by radius, in place of both"),
    ] = None
    angle: Annotated[Angle, Field(description="from x, counter-clockwise", examples=["60 deg"])] = field(
        kw_only=True
    )
    at: Annotated[Length, Field(description="place along the shaft")] = 0.0
    is_body: ClassVar[bool] = False
    couple: ClassVar[complex] = 0j

    @property
    def product(self) -> float:
        """m r, kg m, a magnitude."""
        return self.unbalance if self.unbalance is not None else (self.mass or 0.0) * (self.radius or 0.0)


@dataclass(frozen=True)
class Tilt:
    """A body of revolution set askew."""

    angle: Annotated[Angle, Field(description="between its axis and that of the shaft", examples=["0.2 deg"])]
    towards: Annotated[Angle, Field(description="direction in which its axis leans, from x")]
    axial: Annotated[
        Inertia, Field(description="moment of inertia about its own axis", examples=["0.8 kg*m^2"])
    ]
    across: Annotated[
        Inertia, Field(description="moment of inertia about a diameter", examples=["0.5 kg*m^2"])
    ]


@dataclass(frozen=True)
class Products:
    """Products of inertia about the body's mass centre."""

    xz: Annotated[float, quantity("inertia")] = 0.0
    yz: Annotated[float, quantity("inertia")] = 0.0


@dataclass(frozen=True)
class Body:
    """A body whose mass centre is off the axis, or which is set askew."""

    name: Annotated[Name | None, Field(description="for the tables")] = None
    mass: PositiveMass = field(kw_only=True)
    eccentricity: Distance = 0.0
    angle: Annotated[Angle, Field(description="direction of the eccentricity, from x")] = 0.0
    at: Annotated[Length, Field(description="place of the mass centre along the shaft")] = 0.0
    products: Products | None = None
    tilt: Tilt | None = None
    is_body: ClassVar[bool] = True

    @property
    def radius(self) -> float:
        return self.eccentricity

    @property
    def product(self) -> float:
        """m r, kg m, a magnitude."""
        return self.mass * self.eccentricity

    @property
    def couple(self) -> complex:
        """Products of inertia J_xz + i J_yz, kg m²."""
        couple = complex(self.products.xz, self.products.yz) if self.products else 0j
        tilt = self.tilt
        return couple + tilted(tilt.axial, tilt.across, tilt.angle, tilt.towards) if tilt else couple


@dataclass(frozen=True)
class Plane:
    """A correction plane: the weight's radius or its mass."""

    at: Length = 0.0
    radius: Annotated[Positive | None, Field(description="the mass is found", examples=["120 mm"])] = None
    mass: Annotated[PositiveMass | None, Field(description="the radius is found", examples=["0.4 kg"])] = None
    remove: Annotated[Flag, Field(description="material is taken off the opposite side")] = False


@dataclass(frozen=True)
class Steps:
    """How finely weights are made."""

    mass: Annotated[Mass, Field(examples=["10 g"])] = 0.0
    radius: Annotated[Distance, Field(examples=["1 mm"])] = 0.0
    angle: Annotated[
        Annotated[float, quantity("angle", 0.0, math.pi, "0 … 180 deg")], Field(examples=["1 deg"])
    ] = 0.0


@dataclass(frozen=True, eq=False)
class Given:
    """Masses on a turning shaft balanced in one plane or in two."""

    name: Annotated[CalledBy | None, Field(description="in the heading")] = None
    masses: Annotated[list[Heavy], Field(max_length=30)] = field(default_factory=list)
    bodies: Annotated[list[Body], Field(max_length=10)] = field(default_factory=list)
    planes: Annotated[
        list[Plane],
        Field(
            min_length=1,
            max_length=2,
            description="one: static; two: dynamic",
            examples=["[{at: 60 mm, radius: 120 mm}, {at: 400 mm, radius: 120 mm}]"],
        ),
    ] = field(kw_only=True)
    bearings: Annotated[tuple[Length, Length] | None, Field(description="places of A and B")] = None
    speed: Annotated[Speed | None, Field(examples=["1500 rpm"])] = None
    grade: Annotated[Scale | None, Field(description="balance quality grade G, mm/s", examples=[6.3])] = None
    mass: Annotated[PositiveMass | None, Field(description="of the whole rotor")] = None
    centre: Annotated[Length | None, Field(description="place of its mass centre along the shaft")] = None
    diameter: Positive | None = None
    width: Positive | None = None
    steps: Annotated[Steps | None, Field(description="how finely weights are made")] = None
    accuracy: Annotated[Accuracy, Field(description="of the polygons, on paper")] = ACCURACY

    @property
    def heavy(self) -> list[Heavy | Body]:
        """All that is on the shaft."""
        return [*self.masses, *self.bodies]

    @property
    def names(self) -> list[str]:
        """Of each, its number where none is stated."""
        return [one.name or str(k) for k, one in enumerate(self.heavy, 1)]
