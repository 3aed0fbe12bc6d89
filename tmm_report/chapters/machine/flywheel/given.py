"""What is given of the flywheel: the loads of a machine that stands alone, the wanted unevenness, the wheel's shape."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING, Annotated, Literal

from tmm_report.mechanics.calculus.laws import Constant, Law
from tmm_report.problems import N_
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import (
        Fraction,
        Inertia,
        Period,
        Positive,
        PositiveInertia,
        PositiveMass,
        Scale,
        Speed,
        quantity,
    )

Shaft = Literal["main", "motor"]


@dataclass(frozen=True)
class Areas:
    """Works of the excess moment between its passages through zero, J, in their order over the cycle."""

    works: tuple[float, ...]


@dataclass(frozen=True)
class Punch:
    """Working strokes at equal times; the motor's power is constant."""

    work: Annotated[float, quantity("work", 1e-9), Field(description="of a stroke", examples=["15 kJ"])]
    period: Annotated[Period, Field(description="from stroke to stroke", examples=["5 s"])]
    time: Annotated[Period, Field(description="that a stroke takes", examples=["2 s"])]


@dataclass(frozen=True)
class Motor:
    """The driving motor."""

    power: Annotated[float, quantity("power", 1e-9), Field(description="nominal", examples=["5.5 kW"])]
    speed: Annotated[Speed, Field(description="nominal", examples=["960 rpm"])]
    inertia: Annotated[Inertia, Field(description="of the rotor on its own shaft")] = 0.0
    efficiency: Annotated[Fraction, Field(description="of the transmission to the main link")] = 1.0


@dataclass(frozen=True)
class Wheel:
    """A flywheel that is there: its moment of inertia, or mass and radius of gyration."""

    inertia: PositiveInertia | None = None
    mass: PositiveMass | None = None
    radius_of_gyration: Positive | None = None


@dataclass(frozen=True)
class Disc:
    """A solid disc."""

    width: Annotated[Scale, Field(description="b/D")] = 0.2
    diameter: Annotated[Positive | None, Field(description="stated, the width follows")] = None


@dataclass(frozen=True)
class Rim:
    """A rim of rectangular section on spokes."""

    height: Annotated[Fraction, Field(description="h/D, of the mean diameter")] = 0.1
    width: Annotated[Scale, Field(description="b/h")] = 1.5
    diameter: Annotated[Positive | None, Field(description="mean; stated, the height follows")] = None
    spokes: Annotated[
        float,
        quantity("number", 0.0, 0.9, "0 … 0.9"),
        Field(description="part of the moment of inertia that is in spokes and hub"),
    ] = 0.1


@dataclass(frozen=True)
class Gyration:
    """Of the wheel only its radius of gyration is known, m: the mass follows."""

    radius: float


Shape = Disc | Rim | Gyration


@dataclass(frozen=True)
class Material:
    """Density, kg/m³, and the speed of the rim that is commonly allowed, m/s."""

    name: str
    density: float
    limit: float


CAST_IRON = Material(N_("cast iron"), 7200.0, 35.0)
STEEL = Material(N_("steel"), 7850.0, 70.0)
MATERIALS = {one.name: one for one in (CAST_IRON, STEEL)}

USUAL: dict[str, tuple[float, float]] = {  # kind of machine -> usual δ, from fine to coarse
    N_("AC generator"): (1 / 300, 1 / 200),
    N_("DC generator"): (1 / 200, 1 / 100),
    N_("internal combustion engine"): (1 / 100, 1 / 80),
    N_("piston compressor"): (1 / 100, 1 / 50),
    N_("machine tool"): (1 / 50, 1 / 20),
    N_("pump"): (1 / 30, 1 / 5),
    N_("crusher"): (1 / 20, 1 / 5),
}


@dataclass(frozen=True)
class Given:
    """SI. Of `delta`, `speeds` (least, greatest) and `wheel` one is stated. Beside a lever mechanism there are neither
    loads, nor `inertia`, nor `speed`: they are the mechanism's. `own`: constant moment of inertia of the machine that
    turns with the main link besides; `ratio`: speed of the flywheel's shaft to that of the main link; `friction`:
    whether that of the mechanism's pairs, where it is stated, is among the resistances."""

    delta: float | None = None
    speeds: tuple[float, float] | None = None
    wheel: Wheel | None = None
    machine: str = ""
    speed: float | None = None
    motor: Motor | None = None
    turns: float = 1.0
    driving: Law | None = None
    resisting: Law | None = None
    areas: Areas | None = None
    punch: Punch | None = None
    inertia: Law = field(default_factory=lambda: Constant(0.0))
    own: float = 0.0
    shaft: Shaft = "main"
    ratio: float | None = None
    shape: Shape = field(default_factory=Disc)
    material: Material = STEEL
    positions: int = 24
    friction: bool = True
