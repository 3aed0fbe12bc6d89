"""What is given of the mechanism balanced on its foundation, as the block states it, SI."""

from __future__ import annotations

import math
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, Literal

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import Angle, Coefficient, KeyName, Name, Positive, PositiveMass, whole

FULL, PIVOTED, SUBSTITUTED, OPTIMUM, ROTORS = "full", "pivoted", "substituted", "optimum", "rotors"
METHODS = (FULL, PIVOTED, SUBSTITUTED, OPTIMUM, ROTORS)
STATED = "stated"


@dataclass(frozen=True)
class Counterweight:
    """A counterweight of which one size is chosen and the other found."""

    mass: Annotated[
        PositiveMass | None, Field(description="then the distance is found", examples=["2 kg"])
    ] = None
    distance: Annotated[
        Positive | None,
        Field(description="from the pivot of the link; then the mass is found", examples=["60 mm"]),
    ] = None


@dataclass(frozen=True)
class Existing:
    """A counterweight that is there already."""

    mass: Annotated[PositiveMass, Field(examples=["2 kg"])]
    distance: Annotated[Positive, Field(description="from the fixed pivot of the link", examples=["60 mm"])]
    angle: Annotated[
        Angle,
        Field(
            description="from the line from the pivot to the link's next joint, counter-clockwise",
            examples=["180 deg"],
        ),
    ] = math.pi


@dataclass(frozen=True)
class Rotors:
    """Lanchester's counter-rotating weights at the first and the second multiple of the speed."""

    first: Annotated[
        Positive, Field(description="radius of the weights of the first order", examples=["60 mm"])
    ]
    second: Annotated[
        Positive, Field(description="radius of the weights of the second order", examples=["40 mm"])
    ]


@dataclass(frozen=True, eq=False)
class Balancing:
    """The mechanism balanced on its foundation."""

    methods: Annotated[
        list[Literal["full", "pivoted", "substituted", "optimum", "rotors"]] | None,
        Field(
            min_length=1,
            description="full: all mass centres moved to the frame; pivoted: counterweights on all links with fixed "
            "pivots; substituted: by masses put into joints; optimum: one counterweight on the driving link; "
            "rotors: counter-rotating weights. Left out, full, substituted and optimum, and rotors where they are "
            "stated",
        ),
    ] = None
    counterweights: Annotated[dict[KeyName, Counterweight], Field(description="by link")] = field(
        default_factory=dict
    )
    stated: Annotated[
        dict[KeyName, Existing], Field(description="counterweights that are there, by link")
    ] = field(default_factory=dict)
    part: Annotated[
        Coefficient, Field(description="of the reciprocating masses that substituted balances")
    ] = 0.5
    about: Annotated[
        Name | None, Field(description="fixed point of the shaking moment; the driving pivot")
    ] = None
    rotors: Rotors | None = None
    highest: Annotated[
        Annotated[int, whole(2, 24)],
        Field(description="highest order of the harmonics of the shaking force"),
    ] = 6

    @property
    def ways(self) -> tuple[str, ...]:
        """The methods that are asked for."""
        usual = (FULL, SUBSTITUTED, OPTIMUM, *((ROTORS,) if self.rotors else ()))
        return tuple(self.methods) if self.methods else usual

    @property
    def radii(self) -> tuple[float, float] | None:
        """Of the rotors of the first and the second order, m; None where they are not asked for."""
        return (self.rotors.first, self.rotors.second) if self.rotors else None


Given = Balancing
