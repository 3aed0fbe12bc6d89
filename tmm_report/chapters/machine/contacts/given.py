"""What is given of friction in single pairs, as the block states it: planes and wedges, screws, pivots, belts, wheels,
journals; SI, rad."""

from __future__ import annotations

from dataclasses import KW_ONLY
from math import cos, pi
from typing import TYPE_CHECKING, Annotated, Literal

from tmm_report.mechanics.pairs.materials import Stock, mean, stated
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Angle,
        Coefficient,
        Density,
        Distance,
        Label,
        Positive,
        Speed,
        quantity,
        whole,
    )


@dataclass(frozen=True)
class Rough:
    """What every pair with friction states: a coefficient of friction, or two materials of the table."""

    _: KW_ONLY
    coefficient: Annotated[Coefficient | None, Field(examples=[0.1])] = None
    materials: Annotated[
        Label | None, Field(description="two of steel, cast iron, bronze", examples=["steel–bronze"])
    ] = None
    lubrication: Annotated[
        Literal["dry", "semi-fluid"], Field(description="which column of the table of materials")
    ] = "dry"
    state: Annotated[
        Literal["moving", "rest"], Field(description="the coefficient of motion or of rest from the table")
    ] = "moving"
    name: Annotated[CalledBy | None, Field(description="in the heading")] = None

    def __post_init__(self) -> None:
        if isinstance(self._stated, tuple):
            raise WrongValue(*self._stated)

    @property
    def _stated(self) -> float | Stock | tuple[Message, Message]:
        return stated(self.coefficient, self.materials, self.lubrication, self.state)

    @property
    def stock(self) -> Stock | None:
        """The materials that the coefficient is taken of, where they are stated."""
        return self._stated if isinstance(self._stated, Stock) else None

    @property
    def f(self) -> float:
        """The coefficient: stated, or the middle of the table's range."""
        if self.stock is not None and self.stock.range is not None:
            return mean(self.stock.range)
        return float(self.coefficient or 0.0)


@dataclass(frozen=True)
class Incline(Rough):
    """A body on a plane."""

    _: KW_ONLY
    kind: Literal["incline"]
    angle: Annotated[Angle, Field(description="of the plane", examples=["12 deg"])]
    load: Annotated[Annotated[float, quantity("force", 1e-12)], Field(examples=["2 kN"])]
    force: Annotated[
        Literal["level", "along"], Field(description="that moves the body: level, or along the plane")
    ] = "level"


@dataclass(frozen=True)
class Wedge(Rough):
    """A wedge under a load."""

    _: KW_ONLY
    kind: Literal["wedge"]
    angle: Angle
    load: Annotated[float, quantity("force", 1e-12)]
    base: Annotated[Coefficient | None, Field(description="coefficient on the base; left out, the same")] = (
        None
    )

    @property
    def f_base(self) -> float:
        return self.f if self.base is None else self.base


@dataclass(frozen=True)
class Sliders(Rough):
    """Two guided sliders, one driving the other over a sloping face."""

    _: KW_ONLY
    kind: Literal["sliders"]
    between: Annotated[Angle, Field(description="angle between the directions of the sliders")]
    guides: Annotated[Coefficient, Field(description="coefficient in the guides")]
    face: Annotated[
        Angle | None,
        Field(description="normal of the face against the driving direction; left out, the best"),
    ] = None
    load: Annotated[
        Annotated[float, quantity("force", 1e-12)] | None, Field(description="on the driven slider")
    ] = None


@dataclass(frozen=True)
class Trial:
    """A body just pulled and just pushed: its coefficient of friction and weight."""

    _: KW_ONLY
    kind: Literal["trial"]
    name: Annotated[CalledBy | None, Field(description="in the heading")] = None
    angle: Annotated[Angle, Field(description="of the pull above the level, of the push below it")]
    pull: Annotated[float, quantity("force", 1e-12)]
    push: Annotated[float, quantity("force", 1e-12)]


@dataclass(frozen=True)
class Collar:
    """The collar or end on which a screw turns."""

    coefficient: Coefficient
    radius: Annotated[Positive, Field(description="mean radius")]


@dataclass(frozen=True)
class Screw(Rough):
    """A screw under load."""

    _: KW_ONLY
    kind: Literal["screw"]
    diameter: Annotated[Positive, Field(description="mean, of the thread", examples=["25 mm"])]
    pitch: Positive
    starts: Annotated[
        Annotated[int, whole(1, 12)], Field(description="how many threads run side by side")
    ] = 1
    profile: Annotated[Angle, Field(description="half the angle of the thread; 0: square")] = 0.0
    load: Annotated[float, quantity("force", 1e-12)]
    collar: Collar | None = None
    arm: Annotated[Positive | None, Field(description="of the force of the hand")] = None
    hand_force: Annotated[
        Annotated[float, quantity("force", 1e-12)] | None,
        Field(description="of each hand: then the wheel is found"),
    ] = None
    hands: Annotated[
        Annotated[int, whole(1, 12)] | None, Field(description="left out, 1 on an arm, 2 on a wheel")
    ] = None

    def __post_init__(self) -> None:
        """Hands alone say nothing: their arm or their force is needed."""
        super().__post_init__()
        if self.hands is not None and self.arm is None and self.hand_force is None:
            wrong = Message(N_("the number of hands is stated, but neither their arm nor their force"))
            raise WrongValue(wrong, Message(N_("one of: %(words)s"), {"words": "arm, hand_force"}))

    @property
    def sharing(self) -> int:
        """Hands."""
        return self.hands or (2 if self.hand_force is not None else 1)


@dataclass(frozen=True)
class Pivot(Rough):
    """A pivot or collar."""

    _: KW_ONLY
    kind: Literal["pivot"]
    outer: Annotated[Positive, Field(description="radius")]
    inner: Annotated[Distance | None, Field(description="radius; left out, none")] = None
    ratio: Annotated[
        Annotated[float, quantity("number", 1e-6, 0.999999, "0 … 1")] | None,
        Field(description="of the inner radius to the outer one, in place of inner", examples=[0.5]),
    ] = None
    half_cone: Annotated[Angle, Field(description="half the angle of the cone; 90 deg: flat")] = pi / 2
    load: Annotated[float, quantity("force", 1e-12)]
    speed: Speed | None = None
    surfaces: Annotated[
        Annotated[int, whole(1, 100)],
        Field(description="of a clutch: pairs of plates that rub, each under the whole load"),
    ] = 1
    collars: Annotated[
        Annotated[int, whole(1, 100)], Field(description="side by side on one shaft: they share the load")
    ] = 1

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.inner is not None and self.ratio is not None:
            wrong = Message(N_("the inner radius is stated twice: by itself and by the outer one"))
            raise WrongValue(wrong, Message(N_("at most one of: %(words)s"), {"words": "inner, ratio"}))

    @property
    def hole(self) -> float:
        """The inner radius."""
        return self.ratio * self.outer if self.ratio is not None else self.inner or 0.0


@dataclass(frozen=True)
class Belt(Rough):
    """A rope or belt round a drum."""

    _: KW_ONLY
    kind: Literal["belt"]
    wrap: Annotated[Annotated[float, quantity("angle", 1e-6)], Field(examples=["270 deg"])]
    tight: Annotated[Annotated[float, quantity("force", 1e-12)], Field(description="the greater tension")]
    groove: Annotated[Angle, Field(description="half the angle of the groove; 90 deg: flat")] = pi / 2
    diameter: Positive | None = None
    speed: Speed | None = None


@dataclass(frozen=True)
class BeltDrive(Rough):
    """An open belt drive."""

    _: KW_ONLY
    kind: Literal["belt drive"]
    driving: Annotated[Positive | None, Field(description="diameter of the driving pulley")] = None
    driven: Annotated[Positive | None, Field(description="diameter of the driven pulley")] = None
    distance: Positive
    speed: Annotated[Speed, Field(description="of the driving pulley")]
    driven_speed: Annotated[Speed | None, Field(description="in place of one of the diameters")] = None
    width: Positive
    thickness: Positive
    stress: Annotated[
        Annotated[float, quantity("pressure", 1e-12)],
        Field(description="allowed in the belt", examples=["1.4 MPa"]),
    ]
    density: Annotated[
        Density | None,
        Field(description="left out, centrifugal forces are neglected", examples=["1000 kg/m^3"]),
    ] = None

    def __post_init__(self) -> None:
        """Two of both diameters and the driven speed give the third."""
        super().__post_init__()
        if [self.driving, self.driven, self.driven_speed].count(None) != 1:
            wrong = Message(N_("the pulleys need two of their diameters and the driven speed"))
            words = {"words": "driving, driven, driven_speed"}
            raise WrongValue(wrong, Message(N_("two of: %(words)s"), words))

    @property
    def diameters(self) -> tuple[float, float]:
        """Of the driving and of the driven pulley."""
        slow = self.driven_speed / self.speed if self.driven_speed else 1.0
        driving = self.driving or (self.driven or 0.0) * slow
        return driving, self.driven or driving / slow


@dataclass(frozen=True)
class Wheel(Rough):
    """A rolling wheel."""

    _: KW_ONLY
    kind: Literal["wheel"]
    radius: Positive
    arm: Annotated[Positive, Field(description="of rolling resistance, k", examples=["0.5 mm"])]
    load: Annotated[float, quantity("force", 1e-12)]
    pull: Annotated[
        Annotated[float, quantity("force", 1e-12)] | None, Field(description="level force at the axle")
    ] = None
    moment: Annotated[
        Annotated[float, quantity("moment", 1e-12)] | None,
        Field(description="that drives the wheel, in place of pull"),
    ] = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.pull is not None and self.moment is not None:
            wrong = Message(N_("a wheel is pulled at its axle or driven by a moment, not both"))
            raise WrongValue(wrong, Message(N_("at most one of: %(words)s"), {"words": "pull, moment"}))
        if self.moment is not None and self.f == 0:
            wrong = Message(N_("without friction a driving wheel slips under any moment"))
            raise WrongValue(wrong, Message(N_("for example, coefficient: 0.2")))


@dataclass(frozen=True)
class Journal(Rough):
    """A journal in its bearing."""

    _: KW_ONLY
    kind: Literal["journal"]
    diameter: Positive
    load: Annotated[float, quantity("force", 1e-12)]
    speed: Speed | None = None


@dataclass(frozen=True)
class Journals:
    """Diameters of the journals of a slider-crank."""

    shaft: Positive
    crank_pin: Positive
    wrist_pin: Positive


@dataclass(frozen=True)
class Crank(Rough):
    """A slider-crank with friction circles."""

    _: KW_ONLY
    kind: Literal["crank"]
    force: Annotated[Annotated[float, quantity("force", 1e-12)], Field(description="on the slider")]
    crank: Positive
    rod: Positive
    angle: Annotated[Angle, Field(description="of the crank from its dead point")]
    journals: Journals

    @property
    def diameters(self) -> tuple[float, float, float]:
        of = self.journals
        return of.shaft, of.crank_pin, of.wrist_pin

    @property
    def swing(self) -> int:
        """+1 while the rod swings out, −1 while it swings back past 90°: so the wrist pin turns its force."""
        return 1 if cos(self.angle) > 0 else -1


Contact = (
    Incline | Wedge | Sliders | Trial | Screw | Pivot | Belt | BeltDrive | Wheel | Journal | Crank
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class Given:
    """The pairs in the order of the file."""

    items: tuple[Contact, ...] = ()
