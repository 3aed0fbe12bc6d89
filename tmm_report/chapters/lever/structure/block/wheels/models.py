"""The keys `wheels` and `racks` of the block `mechanism` as pydantic models."""

import math
from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field, model_validator

from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import Angle, Name, Positive, Tooth, quantity

LIMIT = math.radians(45)
ENGAGEMENT = N_(
    "the angle of engagement; left out, 20 deg; 0: the force at the pitch point, along the circles"
)
Ratio = Annotated[float, quantity("number", -1e3, 1e3)]
PLANETS = N_(
    "a wheel whose axis moves is not offered within the linkage: satellites are stages of the block drive, or of "
    "eccentric"
)


class _Meshing(Model):
    """What wheels and racks have in common."""

    pressure_angle: Angle = Field(default=math.radians(20), description=ENGAGEMENT)

    @model_validator(mode="after")
    def engaged(self) -> Any:
        if not 0 <= self.pressure_angle < LIMIT:
            wrong = Message(N_("an angle of engagement from 0 to 45 degrees"))
            raise WrongValue(Message(N_("no teeth are in mesh at this angle of engagement")), wrong)
        return self


class WheelsModel(_Meshing):
    """Two wheels in mesh, each fixed to a link that turns about a fixed point."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("carrier", "planet", "satellite"), PLANETS),
        "friction": N_("friction in the teeth is not offered: the drive takes it by an efficiency"),
    }

    links: tuple[Name, Name] = Field(description="the two links", examples=["[1, 2]"])
    teeth: tuple[Tooth, Tooth] | None = Field(default=None, description="numbers of teeth, in that order")
    module: Positive | None = Field(
        default=None, description="with teeth; left out, it follows from the distance of the axes"
    )
    radii: tuple[Positive, Positive] | None = Field(
        default=None, description="of the working pitch circles", examples=["[100 mm, 200 mm]"]
    )
    ratio: Ratio | None = Field(
        default=None, description="turns of the first link for one of the second, r2/r1", examples=["2"]
    )
    mesh: Literal["external", "internal"] = Field(
        default="external", description="internal: the larger wheel is a ring, and both turn alike"
    )
    phase: Angle | None = Field(
        default=None, description="angle of the second link's x axis where that of the first is 0"
    )
    angles: tuple[Angle, Angle] | None = Field(
        default=None, description="angles of both links at one time, instead of phase"
    )

    @model_validator(mode="after")
    def sized(self) -> "WheelsModel":
        """The sizes are stated once."""
        ways = [key for key in ("teeth", "radii", "ratio") if getattr(self, key) is not None]
        if len(ways) != 1:
            wrong = Message(N_("the sizes of the wheels are not stated in one way"))
            right = Message(N_("teeth: [20, 40], radii: [100 mm, 200 mm] or ratio: 2, one of them"))
            raise WrongValue(wrong, right)
        if self.module is not None and self.teeth is None:
            wrong = Message(N_("a module without numbers of teeth"))
            raise WrongValue(wrong, Message(N_("state teeth: [20, 40], or leave the module out")))
        if self.ratio is not None and self.ratio <= 0:
            wrong = Message(N_("the ratio is a size, r2/r1: the sense of rotation follows from the mesh"))
            right = Message(
                N_("ratio: %(ratio)s with mesh: external (opposite senses) or internal (the same)"),
                {"ratio": f"{abs(self.ratio):g}" if self.ratio else "2"},
            )
            raise WrongValue(wrong, right)
        return self

    @model_validator(mode="after")
    def phased(self) -> "WheelsModel":
        if self.phase is not None and self.angles is not None:
            wrong = Message(N_("the phase is stated twice, by phase and by angles"))
            raise WrongValue(wrong, Message(N_("leave one of the two")))
        return self


class RackModel(_Meshing):
    """A rack cut on a link that slides along a fixed guide, in mesh with a wheel that turns about a fixed point."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = WheelsModel.NOT_OFFERED

    slider: Name = Field(description="the link that is the rack", examples=["3"])
    wheel: Name = Field(description="the link that carries the wheel", examples=["4"])
    teeth: Tooth | None = Field(default=None, description="of the wheel, with module")
    module: Positive | None = Field(default=None, description="with teeth")
    radius: Positive | None = Field(
        default=None, description="of the wheel's working pitch circle, instead of both"
    )
    side: Literal["above", "below", "left", "right"] | None = Field(
        default=None,
        description="on which side of the rack the wheel stands; left out, that of the guide on which its axis is",
    )
    phase: Angle = Field(
        default=0.0, description="angle of the wheel's x axis where the slider is at the guide's own point"
    )

    @model_validator(mode="after")
    def sized(self) -> "RackModel":
        by_teeth = self.teeth is not None or self.module is not None
        if by_teeth == (self.radius is not None) or (self.teeth is None) != (self.module is None):
            wrong = Message(N_("the size of the wheel is not stated in one way"))
            raise WrongValue(wrong, Message(N_("either teeth: 24 with module: 4 mm, or radius: 48 mm")))
        return self
