"""The key `cams` of the block `mechanism` as pydantic models."""

from typing import Literal

from pydantic import Field, model_validator

from tmm_report.chapters.cams.cam.block.models import CamStated
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import Angle, Distance, KeyName, Name


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


class CamModel(CamStated):
    """A cam pair: the follower's link touches the cam by a roller or a flat face."""

    cam: Name | None = Field(default=None, description="the cam's link; left out, the driving link")
    follower: Name = Field(description="a link that slides on a fixed guide or swings about a fixed point")
    roller: RollerModel | None = None
    flat: FlatModel | None = None
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

    @model_validator(mode="after")
    def one_end(self) -> "CamModel":
        if (self.roller is None) == (self.flat is None):
            wrong = Message(N_("the follower's end is not stated in one way"))
            raise WrongValue(
                wrong, Message(N_("roller: {at: B, radius: 10 mm} or flat: {at: B, angle: 0 deg}"))
            )
        return self

    @property
    def faced(self) -> bool:
        return self.flat is not None

    @property
    def at(self) -> str:
        end = self.roller or self.flat
        return end.at if end else ""
