"""What an eccentric epicyclic mechanism states; SI."""

from __future__ import annotations

import math
import re
from dataclasses import field
from fractions import Fraction
from typing import TYPE_CHECKING, Annotated, Any, Literal

from tmm_report.chapters.gears.spur.given import Rack
from tmm_report.mechanics.gears.eccentric.mechanism import EXACT
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Angle,
        Density,
        Distance,
        Module,
        MomentValue,
        Name,
        Positive,
        Reads,
        Span,
        Speed,
        Stiffness,
        Tooth,
        quantity,
        whole,
    )

SUN, RING, CARRIER = "1", "3", "H"
DENOMINATOR = 100  # the finest fraction a ratio may be
LARGEST = 20


def _no_ratio(value: Any, near: str) -> WrongValue:
    wrong = Message(N_("%(value)s is no ratio of whole numbers of teeth"), {"value": shown(value)})
    return WrongValue(wrong, Message(N_("a fraction, for example %(near)s"), {"near": near}))


def of_teeth(value: Any) -> Fraction:
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


RATIO = {"type": ["number", "string"], "description": "z3/z1, a number or a fraction", "examples": [4]}


@dataclass(frozen=True)
class Point:
    """A point of the wheel that is the output: the ring while the sun stands still, the sun while the ring does."""

    wheel: Annotated[Literal["ring", "sun"], Field(description="the other one stands still")] = field(
        default="ring", kw_only=True
    )
    radius: Annotated[Positive, Field(description="from the axis of the wheel", examples=["150 mm"])]
    angle: Annotated[Angle, Field(description="at the start, from the line of the axes")] = 0.0

    @property
    def of_ring(self) -> bool:
        return self.wheel == "ring"

    @property
    def members(self) -> tuple[str, str]:
        """Its wheel, and the one that stands still."""
        return (RING, SUN) if self.of_ring else (SUN, RING)


@dataclass(frozen=True)
class MeshLoad:
    """The moment that loads the meshes, and how stiff they and the axes of the satellites are."""

    moment: Annotated[MomentValue, Field(description="positive counter-clockwise", examples=["20 N*m"])]
    on: Annotated[Literal["sun", "ring"], Field(description="the wheel on which it acts")] = "sun"
    meshes: Annotated[
        Stiffness | None,
        Field(description="stiffness of each mesh along the normal", examples=["4e8 N/m"]),
    ] = None
    axes: Annotated[
        Stiffness | None,
        Field(description="stiffness of the axis of each planet gear; left out, rigid", examples=["2e8 N/m"]),
    ] = None

    def __post_init__(self) -> None:
        """A moment, and both stiffnesses or neither."""
        if not self.moment:
            raise WrongValue(Message(N_("a moment of 0 loads no mesh")), Message(N_("for example, 20 N*m")))
        if (self.meshes is None) != (self.axes is None):
            missing = "meshes" if self.meshes is None else "axes"
            wrong = Message(
                N_("the load of elastic planet gears needs the stiffness %(missing)s too"),
                {"missing": missing},
            )
            raise WrongValue(wrong, Message(N_("state both meshes and axes, or neither")))
        if 0 in (self.meshes, self.axes):
            wrong = Message(N_("without stiffness meshes and axes carry no load"))
            raise WrongValue(wrong, Message(N_("a stiffness greater than zero, for example 4e8 N/m")))

    @property
    def yielding(self) -> float | None:
        """Stiffness of a mesh by that of an axis; None where the axes are rigid."""
        return self.meshes / self.axes if self.meshes and self.axes else None


@dataclass(frozen=True, eq=False)
class Eccentric:
    """Sun and ring on parallel axes, planet gears of different size between them."""

    name: Annotated[CalledBy | None, Field(description="in the heading")] = field(default=None, kw_only=True)
    ratio: Annotated[Annotated[Fraction, Reads(of_teeth, RATIO)] | None, Field(examples=[4])] = field(
        default=None, kw_only=True
    )
    eccentricity: Annotated[
        Positive | None,
        Field(description="distance of the axes, a whole number of half modules", examples=["18 mm"]),
    ] = field(default=None, kw_only=True)
    module: Annotated[Module, Field(examples=["2 mm"])]
    teeth: Annotated[
        list[Tooth] | None,
        Field(
            min_length=2,
            max_length=3,
            description="sun and ring, or sun, largest planet gear, ring: then the eccentricity follows",
            examples=["[34, 60, 136]"],
        ),
    ] = None
    t: Annotated[
        Annotated[int, whole(-10000, 10000)] | None,
        Field(description="the set of the family; left out, the most compact of the fullest"),
    ] = None
    satellites: Annotated[
        list[Literal["largest", "middle", "smallest"]] | None,
        Field(min_length=1, max_length=3, description="left out, as many as fit"),
    ] = None
    clearance: Annotated[Distance, Field(description="δ, between the tip circles of neighbours")] = 0.0
    backlash: Annotated[Distance, Field(description="of every mesh, along the normal")] = 0.0
    ring_up_to: Annotated[
        Annotated[int, whole(20, 2000)] | None,
        Field(description="the largest ring of the family; left out, 200 teeth or what the ratio asks"),
    ] = None
    rack: Rack = field(default_factory=Rack)
    speed: Annotated[Speed | None, Field(description="of the driving wheel", examples=["600 rpm"])] = None
    tolerance: Annotated[
        Annotated[float, quantity("number", 1e-4, 0.1, "0.01 … 10 %")] | None,
        Field(description="of the ratio: sets near it are listed too", examples=["2 %"]),
    ] = None
    width: Annotated[Span | None, Field(description="of the faces, for the masses of the planet gears")] = (
        None
    )
    density: Annotated[Density | None, Field(description="of the planet gears", examples=["7800 kg/m^3"])] = (
        None
    )
    load: Annotated[
        MeshLoad | None, Field(description="the moment for which the forces in the meshes are found")
    ] = None
    points: Annotated[
        dict[Name, Point],
        Field(max_length=8, description="points whose paths are drawn over a turn of the axes"),
    ] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Width and density are stated together."""
        if (self.width is None) != (self.density is None):
            missing = "width" if self.width is None else "density"
            wrong = Message(
                N_("the masses of the planet gears need the %(missing)s too"), {"missing": missing}
            )
            raise WrongValue(wrong, Message(N_("state both width and density, or neither")))

    @property
    def slack(self) -> float:
        """The residue of assembly that the backlash takes up, pitches: half a backlash in each of two meshes."""
        pitch = math.pi * self.module
        return self.backlash / math.cos(self.rack.alpha) / pitch + EXACT


Given = Eccentric
