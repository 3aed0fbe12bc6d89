"""What is given of the machine in motion."""

from __future__ import annotations

import math
from dataclasses import field
from typing import Literal

from tmm_report.mechanics.calculus.laws import ByAngle
from tmm_report.mechanics.machine.characteristics import Characteristic
from tmm_report.records import dataclass

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
    """Between a fixed point `to` and the point `at` of the mechanism, else a pin of the main shaft at the distance
    `radius`, at `angle` from the line to the fixed point, at the distance `apart`. `length` when it is free."""

    stiffness: float
    length: float
    at: str = ""
    to: complex = 0j
    radius: float = 0.0
    angle: float = 0.0
    apart: float = 0.0


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
    """From the speed `begin`, at the angle `phi` turned; to a speed, for a time, by an angle; else until the speed is
    `within` this part of that of steady motion."""

    begin: float = 0.0
    speed: float | None = None
    time: float | None = None
    angle: float | None = None
    within: float = 0.02
    supply: Supply = "on"
    phi: float = 0.0


@dataclass(frozen=True)
class Coast:
    """From the speed `begin` (None: that of steady motion) to `speed`, with the motor off or reversed and a `brake`;
    `load`: whether the working resistances act on."""

    begin: float | None = None
    speed: float = 0.0
    supply: Supply = "off"
    brake: float = 0.0
    load: bool = True


@dataclass(frozen=True, eq=False)
class Given:
    """SI. `speed`: of the main shaft as stated, rad/s; `period`: angle of a cycle without a mechanism, rad; `varying`:
    a moment of inertia that is stated, kg m²; `passing`: whether what accelerates a part is lost in
    its gears too; `friction`: whether that of the mechanism's pairs resists, where it is stated; `steady`: None: where
    it follows from what is stated."""

    parts: tuple[Part, ...] = ()
    motor: Motor | None = None
    resistances: tuple[Resistance, ...] = ()
    springs: tuple[Spring, ...] = ()
    speed: float | None = None
    period: float = 2 * math.pi
    varying: ByAngle | None = None
    passing: bool = False
    gravity: float = G
    friction: bool = True
    start: Start | None = None
    steady: bool | None = None
    coast: Coast | None = None
    name: str = field(default="")
