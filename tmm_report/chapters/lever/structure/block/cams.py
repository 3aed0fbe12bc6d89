"""The key `cams` of the block `mechanism` as pydantic models."""

import math
from typing import Annotated, Literal

from pydantic import Field, model_validator

from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import Angle, Distance, KeyName, Length, Name, Point, Positive, quantity

PhaseAngle = Annotated[float, quantity("angle", 1e-6, 2 * math.pi, "0 … 360 deg")]
PressureLimit = Annotated[float, quantity("angle", 1e-6, math.pi / 2, "0 … 90 deg")]
LawName = Literal["parabolic", "cosine", "sine", "polynomial", "uniform"]


class PhaseModel(Model):
    """A part of the cam's turn: the follower rises, stands or returns."""

    rise: PhaseAngle | None = Field(default=None, description="the angle of a rise", examples=["120 deg"])
    dwell: PhaseAngle | None = Field(default=None, description="the angle of a dwell")
    return_: PhaseAngle | None = Field(default=None, alias="return", description="the angle of a return")
    law: LawName | None = Field(default=None, description="the law of a rise or a return")

    @model_validator(mode="after")
    def one_kind(self) -> "PhaseModel":
        if sum(angle is not None for angle in (self.rise, self.dwell, self.return_)) != 1:
            wrong = Message(N_("a phase is a rise, a dwell or a return, one of them"))
            raise WrongValue(wrong, Message(N_("{rise: 120 deg, law: sine} or {dwell: 30 deg}")))
        if (self.law is None) != (self.dwell is not None):
            wrong = Message(N_("a rise and a return have a law, a dwell has none"))
            right = N_("{rise: 120 deg, law: sine}; laws: parabolic, cosine, sine, polynomial, uniform")
            raise WrongValue(wrong, Message(right))
        return self


class RollerModel(Model):
    """The end of a follower that rolls on the cam; with the radius 0 a knife edge."""

    at: Name = Field(description="the follower's point, the roller's centre", examples=["B"])
    radius: Distance = Field(default=0.0, description="left out, a knife edge", examples=["10 mm"])


class FlatModel(Model):
    """The flat face of a follower, a line through one of its points."""

    at: Name = Field(description="a point of the follower on its face", examples=["B"])
    angle: Angle | None = Field(
        default=None,
        description="of the face in the follower's axes; left out, across the motion of a sliding follower, along the "
        "line to the pivot of a swinging one",
    )


class CircleModel(Model):
    """A circular cam."""

    radius: Positive
    at: Point = Field(
        description="its centre from the cam's pivot, in the cam's axes", examples=["[15 mm, 0]"]
    )


class ProfileModel(Model):
    """The cam's own profile in its axes, from its pivot."""

    circle: CircleModel | None = None
    points: list[Point] | None = Field(default=None, description="at least 8, all round", max_length=1000)
    polar: list[tuple[Angle, Positive]] | None = Field(
        default=None, description="pairs of polar angle and radius, at least 8", max_length=1000
    )

    @model_validator(mode="after")
    def one_way(self) -> "ProfileModel":
        if sum(part is not None for part in (self.circle, self.points, self.polar)) != 1:
            wrong = Message(N_("a profile is stated in one way"))
            raise WrongValue(wrong, Message(N_("circle, points or polar")))
        return self


class CamModel(Model):
    """A cam pair: the follower's link touches the cam by a roller or a flat face."""

    cam: Name | None = Field(default=None, description="the cam's link; left out, the driving link")
    follower: Name = Field(description="a link that slides on a fixed guide or swings about a fixed point")
    roller: RollerModel | None = None
    flat: FlatModel | None = None
    base: Positive | None = Field(default=None, description="least radius of the profile", examples=["40 mm"])
    lift: Positive | None = Field(default=None, description="of a sliding follower", examples=["30 mm"])
    swing: PhaseAngle | None = Field(default=None, description="of a swinging follower", examples=["20 deg"])
    phases: list[PhaseModel] = Field(default=[], max_length=24, description="the law, phase by phase")
    lifts: list[tuple[Angle, Length]] = Field(
        default=[], max_length=1000, description="the law as a table: cam angle, lift of a sliding follower"
    )
    swings: list[tuple[Angle, Angle]] = Field(
        default=[], max_length=1000, description="the law as a table: cam angle, swing"
    )
    profile: ProfileModel | None = Field(default=None, description="the cam itself, instead of a law")
    start: Angle | None = Field(
        default=None,
        description="angle of the cam's x axis at the beginning of the law; left out, that of position 0 where it is "
        "stated by an angle, else 0",
    )
    side: Literal["left", "right"] | None = Field(
        default=None,
        description="of a swinging follower: where it touches, seen from its pivot to the cam's",
    )
    centre: KeyName | None = Field(default=None, description="name of the centre of curvature; left out, K")
    pressure_angle_limit: PressureLimit | None = Field(
        default=None, description="left out, 30 deg of a sliding, 45 deg of a swinging follower"
    )

    @model_validator(mode="after")
    def one_end(self) -> "CamModel":
        if (self.roller is None) == (self.flat is None):
            wrong = Message(N_("the follower's end is not stated in one way"))
            raise WrongValue(
                wrong, Message(N_("roller: {at: B, radius: 10 mm} or flat: {at: B, angle: 0 deg}"))
            )
        return self

    @model_validator(mode="after")
    def one_law(self) -> "CamModel":
        ways = [self.phases, self.lifts, self.swings, self.profile]
        if sum(bool(way) for way in ways) != 1:
            wrong = Message(N_("the follower's law is not stated in one way"))
            right = Message(N_("phases with lift or swing, a table lifts or swings, or the cam's profile"))
            raise WrongValue(wrong, right)
        return self

    @property
    def at(self) -> str:
        end = self.roller or self.flat
        return end.at if end else ""
