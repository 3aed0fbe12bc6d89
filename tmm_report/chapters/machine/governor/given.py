"""What is given of the speed governor, as the block states it, SI."""

from __future__ import annotations

import math
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Annotated, Literal

from tmm_report.mechanics.machine.governor import brake, equilibrium, stability
from tmm_report.mechanics.machine.governor.equilibrium import GRAVITY, Geometry, Weights
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.language import CalledBy
    from tmm_report.variant.values import (
        Acceleration,
        Coefficient,
        Damping,
        Distance,
        Flag,
        ForceValue,
        Fraction,
        Length,
        Mass,
        MomentValue,
        Period,
        Positive,
        PositiveInertia,
        PositiveMass,
        Scale,
        Speed,
        Stiffness,
        TorsionalDamping,
        quantity,
        whole,
    )


@dataclass(frozen=True)
class Arms:
    """Two arms: the upper one hangs from the shaft, the lower one carries the sleeve."""

    upper: Annotated[
        Positive,
        Field(description="length of the upper arm, from its pivot to the pin", examples=["250 mm"]),
    ]
    lower: Annotated[
        Positive, Field(description="length of the lower arm, from the pin to its pivot on the sleeve")
    ]
    upper_offset: Annotated[
        Length,
        Field(description="distance of the upper pivot from the axis; negative where the arms cross"),
    ] = 0.0
    lower_offset: Annotated[Length, Field(description="distance of the lower pivot from the axis")] = 0.0


@dataclass(frozen=True)
class BellCrank:
    """A right-angled lever between ball and sleeve."""

    ball_arm: Annotated[Positive, Field(description="from the fulcrum to the ball", examples=["120 mm"])]
    sleeve_arm: Annotated[Positive, Field(description="from the fulcrum to the sleeve", examples=["80 mm"])]
    fulcrum: Annotated[
        Positive | None,
        Field(
            description="distance of the fulcrum from the axis, where the ball arm is upright; not needed with level"
        ),
    ] = None
    level: Annotated[Flag, Field(description="true: the obliquity of the arms is neglected")] = False


@dataclass(frozen=True)
class Balls:
    """The balls."""

    count: Annotated[Annotated[int, whole(1, 12)], Field(description="how many")] = 2
    mass: Annotated[PositiveMass | None, Field(description="of one; left out where it is chosen")] = None
    distance: Annotated[
        Positive | None, Field(description="along the upper arm from its pivot; left out, on the pin")
    ] = None
    extension: Annotated[
        Positive | None,
        Field(description="of the lower arm beyond the pin, upright at the lowest position (Proell)"),
    ] = None


@dataclass(frozen=True)
class Radius:
    """Of the pins of the arms, or of the balls on bell cranks."""

    lowest: Annotated[Positive, Field(description="with the sleeve at its lower stop", examples=["150 mm"])]
    highest: Annotated[
        Positive | None, Field(description="with the sleeve at its upper stop; or state the lift")
    ] = None


@dataclass(frozen=True)
class Sleeve:
    """The sleeve and what lies on it."""

    mass: Annotated[Mass | None, Field(description="left out, none, or chosen")] = None
    friction: Annotated[
        Annotated[float, quantity("force", 0.0)],
        Field(description="dry, against which the sleeve moves", examples=["15 N"]),
    ] = 0.0
    damping: Annotated[Damping, Field(description="of the dashpot on the sleeve")] = 0.0


@dataclass(frozen=True)
class Spring:
    """The spring that presses the sleeve down."""

    stiffness: Stiffness
    force: Annotated[ForceValue, Field(description="at the lower stop", examples=["1200 N"])] = 0.0


@dataclass(frozen=True)
class Choose:
    """What is found instead of stated, for speeds of the governor's shaft."""

    spring: Annotated[
        tuple[Speed, Speed] | None, Field(description="speeds at the lower and the upper stop")
    ] = None
    balls: Annotated[Speed | None, Field(description="speed at the middle of the lift")] = None
    sleeve: Annotated[Speed | None, Field(description="speed at the middle of the lift")] = None

    def __post_init__(self) -> None:
        if sum(way is not None for way in (self.spring, self.balls, self.sleeve)) != 1:
            right = Message(N_("exactly one of: %(words)s"), {"words": "spring, balls, sleeve"})
            raise WrongValue(Message(N_("one thing can be chosen")), right)

    @property
    def middle(self) -> float | None:
        """Speed at the middle of the lift, rad/s; None of a spring."""
        return self.sleeve if self.balls is None else self.balls


@dataclass(frozen=True)
class Torque:
    """The moment of the drive at full supply."""

    full: Annotated[
        Annotated[float, quantity("moment", 1e-12)],
        Field(description="at the mean speed", examples=["400 N*m"]),
    ]
    slope: Annotated[TorsionalDamping, Field(description="by which it falls with the speed")] = 0.0


@dataclass(frozen=True)
class Load:
    """The moment that is driven; it steps at the time 0."""

    before: Annotated[MomentValue, Field(description="at the mean speed", examples=["200 N*m"])]
    after: Annotated[MomentValue, Field(description="at the mean speed", examples=["280 N*m"])]
    slope: Annotated[TorsionalDamping, Field(description="by which it grows with the speed")] = 0.0


@dataclass(frozen=True)
class Throttle:
    """What the sleeve must move."""

    force: Annotated[
        Annotated[float, quantity("force", 0.0)],
        Field(description="that it takes at the sleeve", examples=["20 N"]),
    ] = 0.0
    insensitivity: Annotated[Fraction | None, Field(description="that it may cost", examples=["2 %"])] = None
    least: Annotated[
        Coefficient, Field(description="supply with the sleeve at its upper stop, of the full one")
    ] = 0.0


@dataclass(frozen=True)
class Plant:
    """The machine that is governed."""

    inertia: PositiveInertia
    ratio: Annotated[
        Scale, Field(description="ratio of the speed of the governor's shaft to that of the machine")
    ] = 1.0
    torque: Torque = field(kw_only=True)
    load: Load = field(kw_only=True)
    throttle: Throttle = Throttle()
    time: Annotated[
        Period | None, Field(description="that the diagrams show; left out, until it is steady")
    ] = None


@dataclass(frozen=True)
class Isodrome:
    """Feedback through a dashpot, which lets it go in time."""

    time: Annotated[Period, Field(description="of the dashpot and its spring", examples=["2 s"])]
    feedback: Annotated[
        Scale, Field(description="shift of the valve by the whole stroke of the piston, of the sleeve's lift")
    ]


@dataclass(frozen=True)
class Servomotor:
    """A hydraulic servomotor between sleeve and throttle."""

    time: Annotated[
        Period,
        Field(
            description="of its whole stroke with the valve shifted by the whole lift", examples=["0.15 s"]
        ),
    ]
    dead_zone: Annotated[Distance, Field(description="shift of the valve within which it stays closed")] = 0.0
    isodrome: Isodrome | None = None

    @property
    def in_loop(self) -> stability.Servo:
        back = self.isodrome
        return stability.Servo(
            T=self.time,
            zone=self.dead_zone,
            beta=back.feedback if back else 0.0,
            Ti=back.time if back else 0.0,
        )


@dataclass(frozen=True)
class ShoeArm:
    """The arm of a shoe, which swings about a pivot on the disc that turns."""

    pivot: Annotated[Positive, Field(description="its distance from the axis", examples=["25 mm"])]
    shoe: Annotated[
        Annotated[float, quantity("angle", math.radians(1), math.radians(175), "1 … 175 deg")],
        Field(description="at the axis, from the pivot to the middle of the shoe", examples=["100 deg"]),
    ]
    mass_centre: Annotated[
        Annotated[float, quantity("angle", math.radians(1), math.radians(175), "1 … 175 deg")],
        Field(description="at the axis, from the pivot to the mass centre", examples=["80 deg"]),
    ]
    spring: Annotated[Positive, Field(description="distance of the line of the spring from the pivot")]
    ahead: Annotated[
        Literal["pivot", "shoe"], Field(description="which of them goes before the other as the disc turns")
    ]

    @property
    def lever(self) -> brake.Lever:
        return brake.Lever(
            pivot=self.pivot,
            shoe=self.shoe,
            mass_centre=self.mass_centre,
            spring=self.spring,
            drawn_on=self.ahead == "shoe",
        )


@dataclass(frozen=True)
class ChooseBrake:
    """What of the brake is found instead of stated, for the speed that it holds."""

    mass: Annotated[Speed | None, Field(description="of a shoe", examples=["300 rpm"])] = None
    spring: Annotated[Speed | None, Field(description="the force of the spring of a shoe at rest")] = None

    def __post_init__(self) -> None:
        if (self.mass is None) == (self.spring is None):
            right = Message(N_("exactly one of: %(words)s"), {"words": "mass, spring"})
            raise WrongValue(Message(N_("one thing can be chosen")), right)


@dataclass(frozen=True)
class Brake:
    """A centrifugal brake: shoes on springs in a drum, sliding outwards or on pivoted arms."""

    count: Annotated[Annotated[int, whole(1, 12)], Field(description="of the shoes")] = 2
    mass: Annotated[
        PositiveMass | None, Field(description="of a shoe with its arm; left out where it is chosen")
    ] = None
    radius: Annotated[
        Positive, Field(description="of the mass centre of a shoe at rest", examples=["60 mm"])
    ] = field(kw_only=True)
    gap: Annotated[Distance, Field(description="between shoe and drum at rest")] = 0.0
    drum: Annotated[Positive, Field(description="inner radius of the drum")] = field(kw_only=True)
    friction: Coefficient = field(kw_only=True)
    spring: Annotated[Spring, Field(description="of a shoe; its force is that at rest")] = field(kw_only=True)
    moment: Annotated[
        Annotated[float, quantity("moment", 1e-12)], Field(description="that drives the shaft of the brake")
    ] = field(kw_only=True)
    inertia: Annotated[
        PositiveInertia | None, Field(description="on the shaft of the brake, for the start")
    ] = None
    arm: Annotated[
        ShoeArm | None, Field(description="on which a shoe swings; left out, it slides along the radius")
    ] = None
    choose: ChooseBrake | None = None

    @property
    def shoes(self) -> brake.Brake:
        """What is chosen is nought."""
        return brake.Brake(
            mass=self.mass or 0.0,
            radius=self.radius,
            gap=self.gap,
            drum=self.drum,
            friction=self.friction,
            stiffness=self.spring.stiffness,
            preload=self.spring.force,
            count=self.count,
            lever=self.arm.lever if self.arm else None,
        )


@dataclass(frozen=True, eq=False)
class Given:
    """The speed governor: centrifugal, alone or with the machine and a servomotor; a centrifugal brake."""

    name: Annotated[CalledBy | None, Field(description="in the heading")] = None
    arms: Annotated[Arms | None, Field(description="Watt, Porter, Proell")] = None
    bell_crank: Annotated[BellCrank | None, Field(description="Hartnell")] = None
    balls: Balls = Balls()
    radius: Radius | None = None
    lift: Annotated[Positive | None, Field(description="of the sleeve", examples=["30 mm"])] = None
    sleeve: Sleeve = Sleeve()
    spring: Spring | None = None
    choose: Choose | None = None
    effort: Annotated[Fraction, Field(description="relative change of the speed for the effort")] = 0.01
    gravity: Acceleration = GRAVITY
    machine: Plant | None = None
    servo: Servomotor | None = None
    brake: Brake | None = None

    @property
    def bare(self) -> Given:
        """Without the machine, whose response to a step is costly; the governor's own numbers are the same."""
        return replace(self, machine=None, servo=None) if self.centrifugal else self

    @property
    def centrifugal(self) -> bool:
        """Whether there is a governor, and not a brake alone."""
        return self.arms is not None or self.bell_crank is not None

    @property
    def lowest(self) -> float:
        """Radius of the pins or balls of a centrifugal governor at the lower stop, m."""
        assert self.radius is not None  # `mistakes`
        return self.radius.lowest

    @property
    def highest(self) -> float | None:
        return self.radius.highest if self.radius else None

    @cached_property
    def geometry(self) -> Geometry:
        """Of a centrifugal governor."""
        if self.arms is not None:
            return equilibrium.Arms(
                upper=self.arms.upper,
                lower=self.arms.lower,
                upper_offset=self.arms.upper_offset,
                lower_offset=self.arms.lower_offset,
                distance=self.balls.distance,
                extension=self.balls.extension,
                upright_at=self.lowest,
            )
        crank = self.bell_crank
        assert crank is not None  # `centrifugal`
        return equilibrium.BellCrank(
            ball_arm=crank.ball_arm, sleeve_arm=crank.sleeve_arm, fulcrum=crank.fulcrum, level=crank.level
        )

    @property
    def weights(self) -> Weights:
        """What is stated of them; what is chosen is nought."""
        return Weights(
            ball=self.balls.mass or 0.0,
            sleeve=self.sleeve.mass or 0.0,
            stiffness=self.spring.stiffness if self.spring else 0.0,
            preload=self.spring.force if self.spring else 0.0,
            count=self.balls.count,
            gravity=self.gravity,
        )
