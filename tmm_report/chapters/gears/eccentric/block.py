"""The block of an eccentric epicyclic mechanism."""

import re
from collections.abc import Iterator
from fractions import Fraction
from typing import Annotated, Any, Literal, TypedDict

from pydantic import Field, model_validator

from tmm_report.chapters.gears.eccentric.paths import Point
from tmm_report.chapters.gears.eccentric.solve import mechanism as eccentric
from tmm_report.chapters.gears.spur.given import Rack
from tmm_report.problems import N_, Message, Problem, shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.stated import Stated
from tmm_report.variant.values import (
    Angle,
    Density,
    Distance,
    Label,
    Module,
    Name,
    Positive,
    Reads,
    Span,
    Speed,
    Tooth,
    quantity,
    whole,
)

DENOMINATOR = 100  # the finest fraction a ratio may be
LARGEST = 20


def _no_ratio(value: Any, near: str) -> WrongValue:
    wrong = Message(N_("%(value)s is no ratio of whole numbers of teeth"), {"value": shown(value)})
    return WrongValue(wrong, Message(N_("a fraction, for example %(near)s"), {"near": near}))


def _ratio(value: Any) -> Fraction:
    """4, 4.25, 17/4 or −4: a magnitude, as a fraction."""
    if isinstance(value, str) and (match := re.fullmatch(r"\s*[-−+]?(\d{1,4})\s*/\s*(\d{1,4})\s*", value)):
        if not int(match[2]):
            raise _no_ratio(value, "7/2")
        found = Fraction(int(match[1]), int(match[2]))
    else:
        number = abs(units.parse(value, "number"))
        found = Fraction(number).limit_denominator(DENOMINATOR)
        if abs(found - number) > 1e-9 * number:
            raise _no_ratio(value, str(found))
    if found > LARGEST:
        wrong = Message(N_("the ratio %(value)s is out of reach"), {"value": shown(value)})
        raise WrongValue(wrong, Message(N_("a ratio up to %(most)s"), {"most": LARGEST}))
    return found


Ratio = Annotated[
    Fraction,
    Reads(
        _ratio,
        {"type": ["number", "string"], "description": "z3/z1, a number or a fraction", "examples": [4]},
    ),
]
Number = Annotated[int, whole(-10000, 10000)]
RingTeeth = Annotated[int, whole(20, 2000)]
Tolerance = Annotated[float, quantity("number", 1e-4, 0.1, "0.01 … 10 %")]


class PointModel(Model):
    """A point of the wheel that is the output: the ring while the sun stands still, the sun while the ring does."""

    wheel: Literal["ring", "sun"] = Field(default="ring", description="the other one stands still")
    radius: Positive = Field(description="from the axis of the wheel", examples=["150 mm"])
    angle: Angle = Field(default=0.0, description="at the start, from the line of the axes")


class EccentricModel(Model):
    """Sun and ring on parallel axes, satellites of different size between them."""

    name: Label | None = Field(default=None, description="in the heading")
    ratio: Ratio | None = Field(default=None, examples=[4])
    eccentricity: Positive | None = Field(
        default=None, description="distance of the axes, a whole number of half modules", examples=["18 mm"]
    )
    module: Module = Field(examples=["2 mm"])
    teeth: list[Tooth] | None = Field(
        default=None,
        min_length=2,
        max_length=3,
        description="sun and ring, or sun, largest satellite, ring: then the eccentricity follows",
        examples=["[34, 60, 136]"],
    )
    t: Number | None = Field(
        default=None, description="the set of the family; left out, the most compact of the fullest"
    )
    satellites: list[Literal["largest", "middle", "smallest"]] | None = Field(
        default=None, min_length=1, max_length=3, description="left out, as many as fit"
    )
    clearance: Distance = Field(default=0.0, description="δ, between the tip circles of neighbours")
    backlash: Distance = Field(default=0.0, description="of every mesh, along the normal")
    ring_up_to: RingTeeth | None = Field(
        default=None, description="the largest ring of the family; left out, 200 teeth or what the ratio asks"
    )
    rack: Stated[Rack] = Field(default_factory=Rack)
    speed: Speed | None = Field(default=None, description="of the driving wheel", examples=["600 rpm"])
    tolerance: Tolerance | None = Field(
        default=None, description="of the ratio: sets near it are listed too", examples=["2 %"]
    )
    width: Span | None = Field(default=None, description="of the faces, for the masses of the satellites")
    density: Density | None = Field(default=None, description="of the satellites", examples=["7800 kg/m^3"])
    points: dict[Name, PointModel] = Field(
        default_factory=dict, max_length=8, description="points whose paths are drawn over a turn of the axes"
    )

    @model_validator(mode="after")
    def mass(self) -> "EccentricModel":
        """Width and density are stated together."""
        if (self.width is None) != (self.density is None):
            missing = "width" if self.width is None else "density"
            wrong = Message(N_("the masses of the satellites need the %(missing)s too"), {"missing": missing})
            raise WrongValue(wrong, Message(N_("state both width and density, or neither")))
        return self


class Block(model.Block):
    """An eccentric epicyclic mechanism."""

    ALONE = True

    eccentric: EccentricModel | None = Field(default=None, description="an eccentric epicyclic mechanism")


class Given(TypedDict):
    eccentric: eccentric.Given | None


def given(read: Read) -> Given:
    written = read.block(Block).eccentric
    return {"eccentric": build(written) if written else None}


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()


def build(model: EccentricModel) -> eccentric.Given:
    return eccentric.Given(
        module=model.module,
        ratio=model.ratio,
        eccentricity=model.eccentricity,
        teeth=tuple(model.teeth) if model.teeth else None,
        rack=model.rack,
        clearance=model.clearance,
        backlash=model.backlash,
        t=model.t,
        satellites=tuple(model.satellites) if model.satellites else None,
        most_ring=model.ring_up_to,
        speed=model.speed,
        name=model.name or "",
        tolerance=model.tolerance,
        width=model.width,
        density=model.density,
        points=tuple(
            Point(name, "3" if of.wheel == "ring" else "1", of.radius, of.angle)
            for name, of in model.points.items()
        ),
    )
