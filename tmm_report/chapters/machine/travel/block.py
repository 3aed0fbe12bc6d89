"""The block `travel` of a variant: a machine whose main link slides."""

from collections.abc import Iterator
from typing import Annotated, Any, TypedDict

from pydantic import Field, model_validator

from tmm_report.chapters.lever.structure.block import driven_by_stroke, stated
from tmm_report.chapters.machine.travel.given import Force, Spring, Wheel
from tmm_report.chapters.machine.travel.given import Given as Travel
from tmm_report.mechanics.calculus.laws import ByPlace, BySpeed, ByTime, Constant
from tmm_report.mechanics.machine.characteristics import Characteristic, Power
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.language import CalledBy
from tmm_report.variant.model import Model, Read, one_of
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import (
    Acceleration,
    Damping,
    Length,
    Mass,
    PlaceForces,
    SpeedForces,
    TimeForces,
    UnsignedVelocity,
    quantity,
)

PositiveForce = Annotated[float, quantity("force", 1e-12)]
AtSpeed = Annotated[float, quantity("velocity", 1e-12)]
Rise = Annotated[float, quantity("angle", -1.5708, 1.5708, "−90 … 90 deg")]
KINDS = ("constant", "by_place", "by_time", "by_speed", "viscous", "square")


class SquareModel(Model):
    """A force that grows with the square of the speed."""

    force: PositiveForce
    speed: AtSpeed = Field(description="at which it is as great")


class ForceModel(Model):
    """A force along the guide, by one law."""

    name: CalledBy | None = None
    constant: PositiveForce | None = None
    by_place: PlaceForces | None = Field(default=None, description="[[place along the guide, force], …]")
    by_time: TimeForces | None = Field(default=None, description="[[time, force], …]")
    by_speed: SpeedForces | None = Field(default=None, description="[[speed, force], …]")
    viscous: Damping | None = Field(default=None, description="force by speed")
    square: SquareModel | None = None

    @model_validator(mode="after")
    def one(self) -> Any:
        return one_of(self, KINDS, N_("the force must be stated by one law"))

    @property
    def kind(self) -> str:
        return next(kind for kind in KINDS if getattr(self, kind) is not None)

    def law(self) -> Characteristic:
        stated_ = getattr(self, self.kind)
        match self.kind:
            case "constant":
                return Constant(stated_)
            case "viscous":
                return Power(stated_, 1.0)
            case "square":
                return Power(stated_.force, stated_.speed, 2)
        x, y = (tuple(float(one) for one in row) for row in zip(*stated_, strict=True))
        return {"by_place": ByPlace, "by_time": ByTime, "by_speed": BySpeed}[self.kind](x, y)


class TravelModel(Model):
    """The motion of a slider, a piston, a rod under forces along its guide, from one place to another."""

    name: CalledBy | None = Field(default=None, description="in the heading")
    from_: Length | None = Field(
        default=None,
        alias="from",
        description="place at the beginning; left out, 0, or where the stroke begins",
    )
    to: Length | None = Field(default=None, description="place at the end", examples=["0.4 m"])
    speed: UnsignedVelocity = Field(default=0.0, description="at the beginning, towards the end")
    mass: Mass = Field(default=0.0, description="of what slides; with a mechanism, besides its links")
    rise: Rise | None = Field(
        default=None,
        description="of the motion above the horizontal, for the weight of this mass; left out, no weight",
    )
    gravity: Acceleration = 9.81
    wheels: list[Stated[Wheel]] = Field(default=[], max_length=10)
    driving: list[ForceModel] = Field(default=[], max_length=10)
    resistance: list[ForceModel] = Field(default=[], max_length=10)
    springs: list[Stated[Spring]] = Field(default=[], max_length=5)


class Block(model.Block):
    """The motion of a main link that slides."""

    ALONE = True

    travel: TravelModel | None = Field(default=None, description="the motion of a main link that slides")


class Given(TypedDict):
    travel: Travel | None


def given(read: Read) -> Given:
    written = read.block(Block).travel
    return {"travel": _built(written) if written else None}


def _built(written: TravelModel) -> Travel:
    sides = ((True, written.driving), (False, written.resistance))
    return Travel(
        begin=written.from_,
        end=written.to,
        speed=written.speed,
        mass=written.mass,
        rise=written.rise,
        gravity=written.gravity,
        wheels=tuple(written.wheels),
        forces=tuple(
            Force(one.kind, one.law(), drives, one.name or "") for drives, many in sides for one in many
        ),
        springs=tuple(written.springs),
        name=written.name or "",
    )


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).travel
    if written is None:
        return
    if stated(read):
        if not driven_by_stroke(read):
            text = N_("the main link of this mechanism does not slide: its driving link turns")
            right = Message(N_("driver: {slider: 3, stroke: …}, or dynamics in place of travel"))
            yield mistake(text, ("travel",), right)
        return
    if read.is_broken("travel"):
        return
    if written.to is None:
        yield mistake(
            N_("it is not said where the motion ends"), ("travel",), Message(N_("to: the place at the end"))
        )
    if not written.mass and not any(one.inertia for one in written.wheels):
        yield mistake(
            N_("nothing in the machine has a mass"), ("travel",), Message(N_("mass: of what slides"))
        )
    acts = written.driving or written.resistance or written.springs or (written.rise and written.mass)
    if not acts and not written.speed:
        text = N_("nothing moves the main link: no force acts on it and it has no speed")
        yield mistake(text, ("travel",), Message(N_("state driving forces, a spring, rise or speed")))
