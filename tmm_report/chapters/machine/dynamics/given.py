"""What is given of the machine in motion."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from tmm_report.mechanics.calculus.laws import ByAngle
from tmm_report.mechanics.machine.characteristics import Characteristic
from tmm_report.problems import N_
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.chapters.lever.kinetostatics.solve.lengths import TorsionSpring
    from tmm_report.variant.values import (
        Angle,
        Distance,
        Flag,
        Name,
        Point,
        Positive,
        Speed,
        Stiffness,
        quantity,
    )

Supply = Literal["on", "off", "reversed"]
G = 9.81  # m/s²


@dataclass(frozen=True)
class Part:
    """A shaft or a mass that the main shaft moves. `ratio`: its speed to that of the main shaft; `arm`: of a mass, its
    velocity by the speed of the main shaft, m; `moment`, `force`: resistance on the shaft, to the mass; `moves`: +1 up,
    −1 down, 0 neither, for its weight; `offset`: a mass that turns with the main shaft at this distance from its axis,
    at the angle `angle` from the x axis in position 0; `efficiency` of all between it and the main shaft."""

    name: str
    ratio: float = 1.0
    inertia: float = 0.0
    moment: float = 0.0
    mass: float = 0.0
    arm: float = 0.0
    force: float = 0.0
    moves: int = 0
    offset: float = 0.0
    angle: float = 0.0
    efficiency: float = 1.0

    @property
    def turns(self) -> bool:
        """Whether it is a shaft."""
        return bool(self.inertia or self.moment) or not self.mass


@dataclass(frozen=True)
class Spring:
    """A spring from a fixed point to a point of the mechanism, or to a pin on the main shaft."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        "links": N_(
            "a torsion spring between two links stands in dynamics.torsion_springs, or among the loads"
        )
    }

    stiffness: Stiffness
    length: Annotated[Distance, Field(description="free")]
    at: Annotated[Name | None, Field(description="the point of the mechanism")] = None
    to: Annotated[Point | None, Field(description="the fixed end, [x, y]")] = None
    radius: Annotated[Positive | None, Field(description="of the pin; without a mechanism")] = None
    angle: Annotated[Angle, Field(description="of the pin at the start, from the line to the fixed end")] = (
        0.0
    )
    apart: Annotated[Positive | None, Field(description="of the fixed end from the axis of the shaft")] = None


@dataclass(frozen=True, eq=False)
class Motor:
    """`law`: on the main shaft, its gear included; `own`: on its own shaft, as stated; `kind`: of its formula."""

    kind: str
    own: Characteristic
    law: Characteristic
    ratio: float = 1.0
    efficiency: float = 1.0

    @property
    def geared(self) -> bool:
        """Whether its own shaft is not the main one."""
        return self.ratio != 1 or self.efficiency != 1


@dataclass(frozen=True, eq=False)
class Resistance:
    """Against the rotation of the main shaft."""

    kind: str
    law: Characteristic
    name: str = ""


@dataclass(frozen=True)
class Start:
    """The start-up. It ends at a speed, after a time or an angle, else near the steady motion."""

    begin: Annotated[float, quantity("speed", 0.0), Field(description="speed at the beginning")] = 0.0
    speed: Annotated[Speed | None, Field(description="to be reached")] = None
    time: Annotated[float, quantity("time", 1e-9)] | None = None
    angle: Annotated[Annotated[float, quantity("angle", 1e-9)] | None, Field(description="to be turned")] = (
        None
    )
    within: Annotated[
        float,
        quantity("number", 1e-9, 0.99, "0 … 0.99"),
        Field(description="part of the steady speed that may be lacking"),
    ] = 0.02
    motor: Annotated[Supply, Field(description="on, off, or reversed: against the rotation")] = "on"
    at: Annotated[Angle, Field(description="angle turned from position 0 at the beginning")] = 0.0


@dataclass(frozen=True)
class Coast:
    """Run-down or braking."""

    begin: Annotated[Speed | None, Field(description="left out, the steady speed")] = None
    speed: Annotated[float, quantity("speed", 0.0), Field(description="to which; 0: to a stop")] = 0.0
    motor: Annotated[Supply, Field(description="on, off, or reversed: braking by counter-current")] = "off"
    brake: Annotated[
        Annotated[float, quantity("moment", 1e-12)] | None,
        Field(description="moment of a brake on the main shaft"),
    ] = None
    load: Annotated[Flag, Field(description="whether the resistances act on")] = True


@dataclass(frozen=True, eq=False)
class Given:
    """SI. `speed`: of the main shaft as stated, rad/s; `period`: angle of a cycle without a mechanism, rad; `varying`:
    a moment of inertia that is stated, kg m²; `passing`: whether what accelerates a part is lost in
    its gears too; `friction`: whether that of the mechanism's pairs resists, where it is stated; `steady`: None: where
    it follows from what is stated; `cycles`: of the steady motion between start-up and run-down, None: chosen."""

    parts: tuple[Part, ...] = ()
    motor: Motor | None = None
    resistances: tuple[Resistance, ...] = ()
    springs: tuple[Spring, ...] = ()
    torsion_springs: tuple[TorsionSpring, ...] = ()
    speed: float | None = None
    period: float = 2 * math.pi
    varying: ByAngle | None = None
    passing: bool = False
    gravity: float = G
    friction: bool = True
    start: Start | None = None
    steady: bool | None = None
    coast: Coast | None = None
    cycles: int | None = None
    name: str = field(default="")

    @property
    def held(self) -> tuple[tuple[str, complex], ...]:
        """Of the springs at points of the mechanism the point and the fixed place, m."""
        return tuple((one.at, complex(*one.to)) for one in self.springs if one.at and one.to)
