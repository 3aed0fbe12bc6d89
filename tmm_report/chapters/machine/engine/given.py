"""What is given of an engine of several cylinders, as the block states it, SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, NamedTuple

from tmm_report.mechanics.masses import engine_cylinders as layouts
from tmm_report.problems import N_
from tmm_report.quantity.paper import ACCURACY
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Accuracy,
        Angle,
        Coefficient,
        Distance,
        Length,
        Mass,
        Name,
        Positive,
        PositiveMass,
        Range,
        Speed,
        whole,
    )

Columns = tuple[Any, Any, Any]


@dataclass(frozen=True)
class Cylinder:
    """One cylinder."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("reciprocating", "rotating", "mass", "rod"),
        N_("cylinders of different masses are not offered: those of engine hold for all of them"),
    )

    name: Annotated[Name | None, Field(description="left out, its number")] = None
    bank: Annotated[Angle, Field(description="of its axis from the upward vertical, counter-clockwise")] = 0.0
    crank: Annotated[Angle, Field(description="of its crank from that of angle 0", examples=["180 deg"])] = (
        0.0
    )
    at: Annotated[Length, Field(description="place along the crankshaft")] = 0.0


@dataclass(frozen=True)
class Inline:
    """Cylinders in a row."""

    cranks: Annotated[list[Angle], Field(min_length=1, max_length=24, examples=["[0, 180 deg, 180 deg, 0]"])]
    spacing: Annotated[Distance, Field(description="between neighbouring cylinders", examples=["90 mm"])] = (
        0.0
    )
    bank: Annotated[Angle, Field(description="of the row from the upward vertical")] = 0.0

    def columns(self) -> Columns:
        """Banks and cranks, rad, and places, m."""
        return layouts.inline(self.cranks, self.spacing, self.bank)


@dataclass(frozen=True)
class Vee:
    """Two rows, two cylinders on each crankpin."""

    angle: Annotated[Range, Field(description="between the rows", examples=["90 deg"])]
    cranks: Annotated[
        list[Angle],
        Field(
            min_length=1,
            max_length=24,
            description="of the crankpins",
            examples=["[0, 90 deg, 270 deg, 180 deg]"],
        ),
    ]
    spacing: Annotated[Distance, Field(description="between neighbouring crankpins")] = 0.0
    offset: Annotated[Distance, Field(description="along the shaft, of the two cylinders of a pin")] = 0.0

    def columns(self) -> Columns:
        return layouts.vee(self.angle, self.cranks, self.spacing, self.offset)


@dataclass(frozen=True)
class Opposed:
    """Lying cylinders to the left and to the right by turns, each with its own crankpin."""

    cranks: Annotated[list[Angle], Field(min_length=1, max_length=24, examples=["[0, 180 deg]"])]
    spacing: Annotated[Distance, Field(description="between neighbouring cylinders")] = 0.0

    def columns(self) -> Columns:
        return layouts.opposed(self.cranks, self.spacing)


@dataclass(frozen=True)
class Radial:
    """A star of cylinders about one crankpin."""

    cylinders: Annotated[Annotated[int, whole(2, 24)], Field(description="how many")]
    bank: Annotated[Angle, Field(description="of the first from the upward vertical")] = 0.0

    def columns(self) -> Columns:
        return layouts.radial(self.cylinders, self.bank)


@dataclass(frozen=True)
class Rod:
    """The connecting rod's mass, split statically between crankpin and piston pin."""

    mass: PositiveMass
    centre: Annotated[Distance, Field(description="of its mass centre from the crankpin", examples=["45 mm"])]


@dataclass(frozen=True)
class Counterweight:
    """Opposite each crank: two of the three, the third is found."""

    share: Annotated[
        Coefficient | None,
        Field(description="part of the reciprocating mass balanced beside all the rotating one"),
    ] = None
    radius: Positive | None = None
    mass: PositiveMass | None = None


class Laid(NamedTuple):
    """A cylinder of any layout. `bank`: of its axis from the upward vertical, `crank`: of its crank from that of angle
    0, rad, counter-clockwise; `at`: its place along the crankshaft, m."""

    name: str
    bank: float
    crank: float
    at: float


@dataclass(frozen=True, eq=False)
class Engine:
    """Balance of an engine of several cylinders; its layout by one key: cylinders, inline, vee, opposed or radial."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        "stroke": N_("the stroke is twice the crank_radius: state that"),
        **dict.fromkeys(
            ("ratio", "rod_ratio", "lambda"),
            N_("state the rod by its length: rod_length, the ratio times the crank_radius"),
        ),
    }

    name: Annotated[CalledBy | None, Field(description="in the heading")] = None
    cylinders: Annotated[list[Cylinder] | None, Field(min_length=1, max_length=24)] = None
    inline: Inline | None = None
    vee: Vee | None = None
    opposed: Opposed | None = None
    radial: Radial | None = None
    speed: Annotated[Speed, Field(examples=["3000 rpm"])] = field(kw_only=True)
    crank_radius: Annotated[Positive, Field(examples=["40 mm"])] = field(kw_only=True)
    rod_length: Annotated[Positive, Field(examples=["150 mm"])] = field(kw_only=True)
    reciprocating: Annotated[
        PositiveMass, Field(description="piston with its pin and rings, without the rod")
    ] = field(kw_only=True)
    rotating: Annotated[Mass, Field(description="brought to the crankpin, without the rod")] = 0.0
    rod: Rod | None = None
    counterweights: Counterweight | None = None
    about: Annotated[
        Length | None,
        Field(description="plane of the moments along the shaft; left out, the middle of the cylinders"),
    ] = None
    firing: Annotated[
        list[Name] | None, Field(max_length=24, description="order in which cylinders fire")
    ] = None
    strokes: Annotated[
        Literal[2, 4], Field(description="of a cycle: how the work of a cylinder is repeated")
    ] = 4
    accuracy: Annotated[Accuracy, Field(description="of the polygons, on paper")] = ACCURACY

    @cached_property
    def laid(self) -> tuple[Laid, ...]:
        """The cylinders of the layout that is stated; nothing where none is."""
        if self.cylinders is not None:
            return tuple(
                Laid(one.name or str(k), one.bank, one.crank, one.at)
                for k, one in enumerate(self.cylinders, 1)
            )
        layout = self.inline or self.vee or self.opposed or self.radial
        columns = zip(*layout.columns(), strict=True) if layout else ()
        return tuple(Laid(str(k), *map(float, column)) for k, column in enumerate(columns, 1))


Given = Engine
