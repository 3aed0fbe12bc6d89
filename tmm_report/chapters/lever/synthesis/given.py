"""What is given of a synthesis, as the block states it, SI: one kind of linkage, and what is asked of it."""

from __future__ import annotations

import math
from dataclasses import field, fields
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Discriminator, Field, Tag

    from tmm_report.variant.values import (
        Angle,
        Flag,
        FunctionOfX,
        Length,
        Name,
        Point,
        Pose,
        Positive,
        PositiveVelocity,
        PressureAngle,
        Side,
        Speed,
        Swing,
        TimeRatio,
        TransmissionAngle,
        Within,
        quantity,
    )


_PRESSURE = "of the rod, greatest permitted; without `rod` it is reached"
_SPEED = "mean velocity of the slider on the working stroke: it gives the speed of the crank"
_TRANSMISSION = (
    "least permitted angle between the rod and the normal of the slide line, in place of `pressure_angle`"
)


class Permits:
    """What states a permitted pressure angle, or the transmission angle that it lacks to a right one."""

    pressure_angle: float | None
    transmission: float | None

    @property
    def permitted(self) -> float | None:
        """Greatest pressure angle, rad."""
        return self.pressure_angle if self.transmission is None else math.pi / 2 - self.transmission


@dataclass(frozen=True, eq=False)
class SliderCrank(Permits):
    """A slider-crank of a stroke; what is left free is chosen for the least pressure angle."""

    stroke: Annotated[Positive | None, Field(description="of the slider", examples=["120 mm"])] = None
    mean_speed: Annotated[
        PositiveVelocity | None,
        Field(
            description="of the slider over the turn: with the stroke it gives the speed of the crank, with that the "
            "stroke"
        ),
    ] = None
    speed: Annotated[
        Speed | None,
        Field(description="of the crank, with `mean_speed` in place of the stroke", examples=["120 rpm"]),
    ] = None
    K: Annotated[TimeRatio, Field(description="time of the slower stroke by that of the faster one")] = 1.0
    ratio: Annotated[
        Annotated[float, quantity("number", 1.000001, 1000.0, "1 … 1000")] | None,
        Field(description="rod by crank", examples=[4]),
    ] = None
    offset: Annotated[Positive | None, Field(description="of the slide line from the crank's pivot")] = None
    offset_ratio: Annotated[
        Annotated[float, quantity("number", 0.0, 1000.0, "0 … 1000")] | None,
        Field(description="offset by crank, with `ratio` in place of K"),
    ] = None
    pressure_angle: Annotated[
        PressureAngle | None, Field(description="greatest permitted", examples=["12 deg"])
    ] = None
    transmission: Annotated[TransmissionAngle | None, Field(description=_TRANSMISSION)] = None


@dataclass(frozen=True, eq=False)
class CrankRocker:
    """A crank-rocker of a swing; what is left free is chosen for the best transmission angle."""

    swing: Annotated[Swing, Field(description="of the rocker", examples=["32 deg"])]
    rocker: Annotated[Positive, Field(description="length between its joints", examples=["0.6 m"])]
    K: Annotated[TimeRatio, Field(description="time of the slower stroke by that of the faster one")] = 1.0
    crank: Positive | None = None
    rod: Positive | None = None
    frame: Annotated[Positive | None, Field(description="distance of the fixed pivots")] = None
    beyond: Annotated[
        Flag, Field(description="true: the crank's pivot lies beyond the chord of the rocker's swing")
    ] = False
    middle: Annotated[
        Angle, Field(description="direction of the rocker in the middle of its swing, of the x axis")
    ] = field(default=-1.5707963267948966)
    crank_at: Annotated[
        Side, Field(description="on which side of the rocker's middle position the crank's pivot lies")
    ] = field(default=-1 + 0j)
    transmission: Annotated[TransmissionAngle | None, Field(description="least permitted angle")] = None


@dataclass(frozen=True, eq=False)
class SlottedLink(Permits):
    """A crank that drives a swinging slotted link, a rod and a slider: a shaper."""

    stroke: Annotated[Positive, Field(description="of the slider", examples=["400 mm"])]
    K: Annotated[
        TimeRatio | None,
        Field(description="time of the working stroke by that of the return", examples=[1.5]),
    ] = None
    swing: Annotated[
        Swing | None, Field(description="of the slotted link, in place of K; or both crank and frame")
    ] = None
    frame: Annotated[
        Positive | None, Field(description="distance of the fixed pivots", examples=["420 mm"])
    ] = None
    crank: Annotated[Positive | None, Field(description="in place of the frame, or of K")] = None
    rod: Positive | None = None
    rod_ratio: Annotated[
        Annotated[float, quantity("number", 1e-3, 1000.0, "0.001 … 1000")] | None,
        Field(description="rod by slotted link", examples=[0.25]),
    ] = None
    pressure_angle: Annotated[PressureAngle | None, Field(description=_PRESSURE)] = None
    transmission: Annotated[TransmissionAngle | None, Field(description=_TRANSMISSION)] = None
    working_speed: Annotated[PositiveVelocity | None, Field(description=_SPEED)] = None


@dataclass(frozen=True, eq=False)
class TurningGuide(Permits):
    """A crank that drives a slotted link all round, an arm and a rod of which drive a slider: Whitworth's mechanism."""

    stroke: Annotated[Positive, Field(description="of the slider", examples=["300 mm"])]
    K: Annotated[TimeRatio, Field(description="time of the working stroke by that of the return")]
    frame: Annotated[Positive | None, Field(description="distance of the fixed pivots")] = None
    crank: Annotated[Positive | None, Field(description="in place of the frame")] = None
    rod: Positive | None = None
    rod_ratio: Annotated[
        Annotated[float, quantity("number", 1.000001, 1000.0, "1 … 1000")] | None,
        Field(description="rod by arm", examples=[4]),
    ] = None
    pressure_angle: Annotated[PressureAngle | None, Field(description=_PRESSURE)] = None
    transmission: Annotated[TransmissionAngle | None, Field(description=_TRANSMISSION)] = None
    working_speed: Annotated[PositiveVelocity | None, Field(description=_SPEED)] = None


@dataclass(frozen=True, eq=False)
class AnglePairs:
    """A four-bar linkage whose crank and rocker go together through three pairs of angles."""

    pairs: Annotated[
        list[tuple[Angle, Angle]],
        Field(
            min_length=3,
            max_length=3,
            description="of crank and rocker from the line of the pivots, as the crank goes through them",
            examples=["[[20 deg, 35 deg], [35 deg, 45 deg], [50 deg, 60 deg]]"],
        ),
    ]
    frame: Annotated[Positive, Field(description="distance of the fixed pivots", examples=["400 mm"])]


@dataclass(frozen=True, eq=False)
class Generator:
    """A four-bar linkage that sets the angle of its rocker to that of its crank as a function, at three points."""

    y: Annotated[FunctionOfX, Field(description="the function of x", examples=["log10 x", "x^1.5"])]
    x: Annotated[Within, Field(description="from … to", examples=["[1, 2]"])]
    crank_from: Annotated[
        Angle,
        Field(description="of the crank at the first x, from the line of the pivots", examples=["30 deg"]),
    ]
    crank_turn: Annotated[
        Angle, Field(description="of the crank over the range, with its sign", examples=["60 deg"])
    ]
    rocker_from: Annotated[Angle, Field(description="of the rocker at the first x", examples=["180 deg"])]
    rocker_turn: Annotated[
        Angle, Field(description="of the rocker over the range of y", examples=["-90 deg"])
    ]
    frame: Annotated[Positive, Field(description="distance of the fixed pivots", examples=["400 mm"])]
    spacing: Annotated[
        Literal["chebyshev", "ends"],
        Field(description="the points of accuracy; ends: both ends and the middle"),
    ] = "chebyshev"


@dataclass(frozen=True, eq=False)
class Dwell:
    """A rod on a point of the coupler of a crank-rocker, whose path is nearly an arc: the slider dwells there."""

    crank: Positive
    coupler: Annotated[Positive, Field(description="between its joints")]
    rocker: Positive
    frame: Annotated[Positive, Field(description="distance of the fixed pivots; the rocker's to the right")]
    point: Annotated[
        Point,
        Field(
            description="of the coupler: along it from the crank pin, and to its left",
            examples=["[0.1, 0.1]"],
        ),
    ]
    angles: Annotated[
        list[Angle],
        Field(
            min_length=3, max_length=3, description="of the crank, at which the arc is laid through the point"
        ),
    ]
    rocker_joint: Annotated[
        Literal["left", "right"], Field(description="of the line from the crank pin to the rocker's pivot")
    ] = "left"


@dataclass(frozen=True, eq=False)
class Body:
    """A four-bar linkage whose coupler is led through three positions, or from one to another; its pins are stated
    points of the body."""

    positions: Annotated[
        list[Pose],
        Field(
            min_length=2,
            max_length=3,
            description="place of the body's origin and angle of its x axis: [x, y, angle]",
            examples=["[[0, 0, 0], [50 mm, 20 mm, 30 deg], [90 mm, 10 mm, 60 deg]]"],
        ),
    ]
    points: Annotated[
        list[Point],
        Field(min_length=2, max_length=2, description="pins of crank and rocker, in the axes of the body"),
    ]
    crank: Annotated[Positive | None, Field(description="of two positions: its length")] = None
    rocker: Annotated[
        Positive | None,
        Field(description="of two positions; left out, chosen for the best transmission angle"),
    ] = None
    crank_pivot: Annotated[
        Literal["left", "right"] | None,
        Field(description="of two positions: of the way of its pin from the first place to the second"),
    ] = None
    rocker_pivot: Annotated[
        Literal["left", "right"] | None, Field(description="of two positions: as that of the crank")
    ] = None


def by_pairs(value: Any) -> str:
    """The form of a function: by its law, or by the pairs of angles themselves."""
    paired = "pairs" in value if isinstance(value, dict) else isinstance(value, AnglePairs)
    return "<pairs>" if paired else "<law>"


@dataclass(frozen=True, eq=False)
class RockerPositions:
    """A four-bar linkage by two positions of its rocker: the extreme ones, or two with those of the crank. Angles are
    counted from the line of the pivots, from the crank's to the rocker's."""

    angles: Annotated[
        list[Angle],
        Field(min_length=2, max_length=2, description="of the rocker", examples=["[60 deg, 100 deg]"]),
    ]
    rocker: Annotated[
        Positive | None,
        Field(
            description="length between its joints; with crank_angles left out, chosen for the best transmission angle"
        ),
    ] = None
    frame: Annotated[
        Positive | None,
        Field(
            description="distance of the fixed pivots; of extreme positions left out, chosen for the best transmission "
            "angle"
        ),
    ] = None
    crank_angles: Annotated[
        list[Angle] | None,
        Field(
            min_length=2, max_length=2, description="of the crank there; left out, the positions are extreme"
        ),
    ] = None
    transmission: Annotated[TransmissionAngle | None, Field(description="least permitted angle")] = None


@dataclass(frozen=True, eq=False)
class SliderPositions:
    """A slider-crank by two places of its slider: the extreme ones, or two with the angles of the crank. Places are
    counted along the slide line from the crank's pivot, angles from its direction."""

    places: Annotated[
        list[Length],
        Field(min_length=2, max_length=2, description="of the slider", examples=["[150 mm, 270 mm]"]),
    ]
    offset: Annotated[
        Length | None,
        Field(
            description="of the slide line, above zero below the crank's pivot; left out, none, with crank_angles "
            "chosen for the least pressure angle"
        ),
    ] = None
    crank_angles: Annotated[
        list[Angle] | None,
        Field(min_length=2, max_length=2, description="of the crank there; left out, the places are extreme"),
    ] = None
    pressure_angle: Annotated[PressureAngle | None, Field(description="greatest permitted")] = None


Kind = (
    SliderPositions
    | RockerPositions
    | SliderCrank
    | CrankRocker
    | SlottedLink
    | TurningGuide
    | Generator
    | AnglePairs
    | Dwell
    | Body
)


@dataclass(frozen=True, eq=False)
class Synthesis:
    """Lengths of a linkage from what is asked of its motion; the mechanism takes them: `A: synthesis.crank`."""

    NOT_STATED: ClassVar[tuple[str, ...]] = ()

    slider_crank: SliderCrank | None = None
    crank_rocker: CrankRocker | None = None
    slotted_link: SlottedLink | None = None
    turning_guide: TurningGuide | None = None
    function: (
        Annotated[
            Annotated[Generator, Tag("<law>")] | Annotated[AnglePairs, Tag("<pairs>")],
            Discriminator(by_pairs),
        ]
        | None
    ) = None
    dwell: Dwell | None = None
    body: Body | None = None
    rocker_positions: RockerPositions | None = None
    slider_positions: SliderPositions | None = None
    round: Annotated[
        Positive | None, Field(description="to which the lengths are rounded", examples=["1 mm"])
    ] = None
    output: Annotated[
        Name | None,
        Field(description="the slider's point or the rocker whose motion is asked; left out, the only one"),
    ] = None

    @property
    def stated(self) -> tuple[str, ...]:
        """The kinds of linkages that are asked for: one, of a block without mistakes."""
        return tuple(name for name in KINDS if getattr(self, name) is not None)

    @property
    def kind(self) -> str:
        return self.stated[0]

    @property
    def asked(self) -> Kind:
        found: Kind = getattr(self, self.kind)
        return found


KINDS = tuple(one.name for one in fields(Synthesis) if one.name not in ("round", "output"))
Given = Synthesis
