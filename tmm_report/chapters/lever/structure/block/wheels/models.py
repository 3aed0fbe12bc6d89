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
    "the link that keeps the axes apart is the carrier; the wheel that runs round stands among the links: "
    "{links: [0, 2], carrier: 1, radii: [60 mm, 30 mm]}; several planet gears are stages of the block drive"
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
    """Two wheels in mesh, each fixed to a link that turns about a fixed point, or about a point of the carrier."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("planet", "satellite", "sun", "arm"), PLANETS),
        "friction": N_("friction in the teeth is not offered: the drive takes it by an efficiency"),
    }

    links: tuple[Name, Name] = Field(
        description="the two links; 0, the first, with a carrier: a wheel that is fixed", examples=["[1, 2]"]
    )
    carrier: Name | None = Field(
        default=None,
        description="the moving link to which both wheels are pivoted; left out, both axes are fixed",
        examples=["1"],
    )
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
        default=None,
        description="angle of the second link's x axis where those of the first and of the carrier are 0",
    )
    angles: tuple[Angle, Angle] | None = Field(
        default=None,
        description="angles of both links at one time, where that of a carrier is 0, instead of phase",
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
    """A rack cut on a link that slides along a fixed guide, or on the frame, in mesh with a wheel that turns about a
    fixed point, or on a carrier that slides along a parallel guide."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        "friction": WheelsModel.NOT_OFFERED["friction"],
        **dict.fromkeys(("axle", "slides"), N_("the slider to which the wheel is pivoted is the carrier")),
    }

    slider: Name = Field(description="the link that is the rack; 0: a fixed one", examples=["3"])
    wheel: Name = Field(description="the link that carries the wheel", examples=["4"])
    carrier: Name | None = Field(
        default=None,
        description="the slider to which the wheel is pivoted; left out, it turns about a fixed point",
        examples=["3"],
    )
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
        default=0.0,
        description="angle of the wheel's x axis where the slider, and the carrier, are at their guides' own points",
    )

    @model_validator(mode="after")
    def sized(self) -> "RackModel":
        by_teeth = self.teeth is not None or self.module is not None
        if by_teeth == (self.radius is not None) or (self.teeth is None) != (self.module is None):
            wrong = Message(N_("the size of the wheel is not stated in one way"))
            raise WrongValue(wrong, Message(N_("either teeth: 24 with module: 4 mm, or radius: 48 mm")))
        return self


class RollingModel(Model):
    """A wheel without teeth that rolls on a straight fixed rail without slip, its axle a slider along the rail."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(
            ("slider", "on"),
            N_(
                "a wheel rolls on a fixed rail, that of its carrier's guide; on a moving one it is held by teeth, "
                "mechanism.racks with a carrier"
            ),
        ),
        **dict.fromkeys(("guide", "rail"), N_("the rail runs along the guide of the carrier")),
        **dict.fromkeys(
            ("friction", "f", "arm", "k"),
            N_("the friction that rolling needs is told by the note; friction of rolling stands in contacts"),
        ),
    }

    wheel: Name = Field(description="the link that is the wheel", examples=["4"])
    carrier: Name = Field(
        description="its axle: a slider of one point on a fixed guide, to which the wheel is pivoted",
        examples=["3"],
    )
    radius: Positive = Field(description="of the wheel")
    side: Literal["above", "below", "left", "right"] = Field(
        description="on which side of the rail the wheel stands"
    )
    phase: Angle = Field(
        default=0.0, description="angle of the wheel's x axis where the axle is at the guide's own point"
    )
