"""What is given of the mechanism balanced on its foundation, as the block states it, SI."""

from __future__ import annotations

import math
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, Literal

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import (
        Angle,
        Coefficient,
        KeyName,
        Name,
        Number,
        Positive,
        PositiveMass,
        whole,
    )

FULL, PIVOTED, SUBSTITUTED, OPTIMUM, ROTORS = "full", "pivoted", "substituted", "optimum", "rotors"
INERTIA, COUPLES = "inertia", "couples"  # against the moment, after one of the others against the force
MOMENT = (INERTIA, COUPLES)
METHODS = (FULL, PIVOTED, SUBSTITUTED, OPTIMUM, ROTORS, *MOMENT)
STATED, NONE = "stated", "none"
ORDERS = 24  # the highest order of a harmonic
WORDS = {"first": 1, "second": 2}


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
class Antiphase:
    """Two equal weights that turn alike, half a turn apart, on axes side by side: a moment and no force."""

    radius: Annotated[Positive, Field(description="of both weights", examples=["60 mm"])]
    distance: Annotated[Positive, Field(description="between their axes", examples=["300 mm"])]


def order_of(key: str) -> int:
    """Of a harmonic; 0 of what is no order."""
    return WORDS.get(key) or (int(key) if key.isdecimal() else 0)


@dataclass(frozen=True, eq=False)
class Balancing:
    """The mechanism balanced on its foundation."""

    methods: Annotated[
        list[Literal["full", "pivoted", "substituted", "optimum", "rotors", "inertia", "couples"]] | None,
        Field(
            min_length=1,
            description="full: all mass centres moved to the frame; pivoted: counterweights on all links with fixed "
            "pivots; substituted: by masses put into joints; optimum: one counterweight on the driving link; "
            "rotors: counter-rotating weights; and against the moment inertia: wheels geared to the links; couples: "
            "weights in antiphase. Left out, full, substituted and optimum, and what is stated of the others",
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
    rotors: Annotated[
        dict[KeyName, Positive],
        Field(
            description="radius of Lanchester's counter-rotating weights by their order: turns in a turn of the "
            "driving link; first and second are 1 and 2",
            examples=["{1: 60 mm, 2: 40 mm}"],
        ),
    ] = field(default_factory=dict)
    after: Annotated[
        Literal["none", "stated", "full", "pivoted", "substituted", "optimum", "rotors"] | None,
        Field(
            description="the balance of the force that inertia and couples are added to; left out, the one that "
            "leaves least of the force"
        ),
    ] = None
    wheels: Annotated[
        dict[KeyName, Number],
        Field(
            description="by link: turns of the wheel geared to it for one of the link, negative against it; 1 is a "
            "larger moment of inertia of the link itself. Left out, −1 of links with fixed pivots, 1 of others",
            examples=["{3: -1}"],
        ),
    ] = field(default_factory=dict)
    couples: Annotated[
        dict[KeyName, Antiphase], Field(description="by order: turns in a turn of the driving link")
    ] = field(default_factory=dict)
    highest: Annotated[
        Annotated[int, whole(2, ORDERS)],
        Field(description="highest order of the harmonics of the shaking force"),
    ] = 6

    @property
    def ways(self) -> tuple[str, ...]:
        """The methods that are asked for."""
        if self.methods:
            return tuple(self.methods)
        more = ((ROTORS, self.rotors), (INERTIA, self.wheels), (COUPLES, self.couples))
        return (FULL, SUBSTITUTED, OPTIMUM, *(name for name, stated in more if stated))

    @property
    def radii(self) -> dict[int, float]:
        """Of the rotors by their order, m."""
        found = {order_of(key): radius for key, radius in self.rotors.items()}
        return {order: found[order] for order in sorted(found)}


Given = Balancing
