"""The keys of the block `dynamics`, beside those of motors and resistances."""

import math
from typing import Annotated, Literal

from pydantic import Field

from tmm_report.chapters.lever.kinetostatics.block import TorsionSpring
from tmm_report.chapters.machine.dynamics.block.motors import MotorModel, ResistanceModel
from tmm_report.chapters.machine.dynamics.given import Coast, Spring, Start
from tmm_report.variant.language import CalledBy
from tmm_report.variant.model import Model
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import (
    Acceleration,
    Angle,
    Distance,
    Flag,
    ForceValue,
    Fraction,
    Inertia,
    Mass,
    MomentValue,
    Number,
    Positive,
    PositiveInertia,
    Speed,
    TurnAngle,
    Velocity,
    quantity,
    whole,
)

MOVES = {"up": 1, "down": -1, "level": 0}
PeriodAngle = Annotated[float, quantity("angle", 1e-6, 40 * math.pi, "0 … 7200 deg")]
Varying = Annotated[list[tuple[TurnAngle, PositiveInertia]], Field(min_length=2, max_length=1000)]


class PartModel(Model):
    """A shaft or a mass that the main shaft moves."""

    name: CalledBy
    ratio: Number = Field(
        default=1.0, description="speed of this shaft by that of the main shaft", examples=[0.1]
    )
    on: Literal["motor"] | None = Field(default=None, description="motor: this is its shaft, of its ratio")
    inertia: Inertia = Field(default=0.0, description="of the shaft")
    moment: MomentValue = Field(default=0.0, description="resisting it; below zero it drives")
    mass: Mass = Field(default=0.0, description="of what moves along")
    radius_of_gyration: Positive | None = Field(
        default=None, description="of the shaft with this mass, in place of its inertia", examples=["200 mm"]
    )
    velocity: Velocity | None = Field(default=None, description="of the mass, at the speed of the main shaft")
    radius: Positive | None = Field(
        default=None, description="of the drum that moves the mass, on this shaft"
    )
    moves: Literal["up", "down", "level"] = Field(default="level", description="for its weight")
    force: ForceValue = Field(default=0.0, description="resisting the mass")
    offset: Distance = Field(default=0.0, description="of a mass on the main shaft, from its axis")
    angle: Angle = Field(default=0.0, description="of the offset at the start, from the x axis")
    efficiency: Fraction = Field(default=1.0, description="from the main shaft to here")

    @property
    def turned(self) -> float:
        """The moment of inertia of the shaft, kg m²."""
        return self.inertia if self.radius_of_gyration is None else self.mass * self.radius_of_gyration**2

    @property
    def carried(self) -> float:
        """The mass that moves along, kg."""
        return self.mass if self.radius_of_gyration is None else 0.0


class DynamicsModel(Model):
    """The machine in motion, reduced to one shaft: the driving link of the mechanism, else the shaft of the motor."""

    name: CalledBy | None = Field(default=None, description="in the heading")
    parts: list[PartModel] = Field(default=[], max_length=20)
    motor: MotorModel | None = Field(default=None, description="left out, a moment that closes the cycle")
    resistance: list[ResistanceModel] = Field(default=[], max_length=10)
    springs: list[Stated[Spring]] = Field(default=[], max_length=5)
    torsion_springs: list[Stated[TorsionSpring]] = Field(
        default=[], max_length=5, description="between two links, or a link and the frame"
    )
    speed: Speed | None = Field(default=None, description="of the main shaft, to which velocities are stated")
    period: PeriodAngle | None = Field(default=None, description="angle of a cycle; left out, one turn")
    varying_inertia: Varying | None = Field(
        default=None, description="[[angle, moment of inertia], …] on the main shaft, without a mechanism"
    )
    losses_of_acceleration: Flag = Field(
        default=False,
        description="true: what accelerates the parts passes their gears too, J i²/η, or J i² η where they drive",
    )
    gravity: Acceleration = 9.81
    friction: Flag | None = Field(
        default=None, description="false: the friction of the mechanism's pairs is left out"
    )
    start: Stated[Start] | None = None
    steady: Flag | None = Field(default=None, description="left out, where the motion can become steady")
    coast: Stated[Coast] | None = None
    cycles: Annotated[int, whole(1, 100)] | None = Field(
        default=None,
        description="of the steady motion between start-up and run-down on one chart; left out, chosen",
    )
