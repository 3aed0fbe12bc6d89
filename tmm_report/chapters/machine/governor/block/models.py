"""What the block `governor` of a variant is made of."""

from typing import Annotated, Any

from pydantic import Field, model_validator

from tmm_report.mechanics.machine.governor.equilibrium import GRAVITY
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import (
    Acceleration,
    Coefficient,
    Damping,
    Distance,
    Flag,
    ForceValue,
    Fraction,
    Label,
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

Count = Annotated[int, whole(1, 12)]
Force = Annotated[float, quantity("force", 0.0)]
Moment = Annotated[float, quantity("moment", 1e-12)]


class ArmsModel(Model):
    """Two arms: the upper one hangs from the shaft, the lower one carries the sleeve."""

    upper: Positive = Field(
        description="length of the upper arm, from its pivot to the pin", examples=["250 mm"]
    )
    lower: Positive = Field(description="length of the lower arm, from the pin to its pivot on the sleeve")
    upper_offset: Length = Field(
        default=0.0, description="distance of the upper pivot from the axis; negative where the arms cross"
    )
    lower_offset: Length = Field(default=0.0, description="distance of the lower pivot from the axis")


class BellCrankModel(Model):
    """A right-angled lever between ball and sleeve."""

    ball_arm: Positive = Field(description="from the fulcrum to the ball", examples=["120 mm"])
    sleeve_arm: Positive = Field(description="from the fulcrum to the sleeve", examples=["80 mm"])
    fulcrum: Positive | None = Field(
        default=None,
        description="distance of the fulcrum from the axis, where the ball arm is upright; not needed with level",
    )
    level: Flag = Field(default=False, description="true: the obliquity of the arms is neglected")


class BallsModel(Model):
    """The balls."""

    count: Count = 2
    mass: PositiveMass | None = Field(default=None, description="of one; left out where it is chosen")
    distance: Positive | None = Field(
        default=None, description="along the upper arm from its pivot; left out, on the pin"
    )
    extension: Positive | None = Field(
        default=None, description="of the lower arm beyond the pin, upright at the lowest position (Proell)"
    )


class RadiusModel(Model):
    """Of the pins of the arms, or of the balls on bell cranks."""

    lowest: Positive = Field(description="with the sleeve at its lower stop", examples=["150 mm"])
    highest: Positive | None = Field(
        default=None, description="with the sleeve at its upper stop; or state the lift"
    )


class SleeveModel(Model):
    """The sleeve and what lies on it."""

    mass: Mass | None = Field(default=None, description="left out, none, or chosen")
    friction: Force = Field(default=0.0, description="dry, against which the sleeve moves", examples=["15 N"])
    damping: Damping = Field(default=0.0, description="of the dashpot on the sleeve")


class SpringModel(Model):
    """The spring that presses the sleeve down."""

    stiffness: Stiffness
    force: ForceValue = Field(default=0.0, description="at the lower stop", examples=["1200 N"])


class ChooseModel(Model):
    """What is found instead of stated, for speeds of the governor's shaft."""

    spring: tuple[Speed, Speed] | None = Field(
        default=None, description="speeds at the lower and the upper stop"
    )
    balls: Speed | None = Field(default=None, description="speed at the middle of the lift")
    sleeve: Speed | None = Field(default=None, description="speed at the middle of the lift")

    @model_validator(mode="after")
    def one(self) -> Any:
        if sum(way is not None for way in (self.spring, self.balls, self.sleeve)) != 1:
            wrong = Message(N_("one thing can be chosen"))
            raise WrongValue(
                wrong, Message(N_("exactly one of: %(words)s"), {"words": "spring, balls, sleeve"})
            )
        return self


class TorqueModel(Model):
    """The moment of the drive at full supply."""

    full: Moment = Field(description="at the mean speed", examples=["400 N*m"])
    slope: TorsionalDamping = Field(default=0.0, description="by which it falls with the speed")


class LoadModel(Model):
    """The moment that is driven; it steps at the time 0."""

    before: MomentValue = Field(description="at the mean speed", examples=["200 N*m"])
    after: MomentValue = Field(description="at the mean speed", examples=["280 N*m"])
    slope: TorsionalDamping = Field(default=0.0, description="by which it grows with the speed")


class ThrottleModel(Model):
    """What the sleeve must move."""

    force: Force = Field(default=0.0, description="that it takes at the sleeve", examples=["20 N"])
    insensitivity: Fraction | None = Field(default=None, description="that it may cost", examples=["2 %"])
    least: Coefficient = Field(
        default=0.0, description="supply with the sleeve at its upper stop, of the full one"
    )


class MachineModel(Model):
    """The machine that is governed."""

    inertia: PositiveInertia
    ratio: Scale = Field(default=1.0, description="speed of the governor's shaft by that of the machine")
    torque: TorqueModel
    load: LoadModel
    throttle: ThrottleModel = ThrottleModel()
    time: Period | None = Field(
        default=None, description="that the diagrams show; left out, until it is steady"
    )


class IsodromeModel(Model):
    """Feedback through a dashpot, which lets it go in time."""

    time: Period = Field(description="of the dashpot and its spring", examples=["2 s"])
    feedback: Scale = Field(
        description="shift of the valve by the whole stroke of the piston, of the sleeve's lift"
    )


class ServoModel(Model):
    """A hydraulic servomotor between sleeve and throttle."""

    time: Period = Field(
        description="of its whole stroke with the valve shifted by the whole lift", examples=["0.15 s"]
    )
    dead_zone: Distance = Field(default=0.0, description="shift of the valve within which it stays closed")
    isodrome: IsodromeModel | None = None


class BrakeModel(Model):
    """A centrifugal brake: shoes on springs in a drum."""

    count: Count = Field(default=2, description="of the shoes")
    mass: PositiveMass = Field(description="of a shoe")
    radius: Positive = Field(description="of the mass centre of a shoe at rest", examples=["60 mm"])
    gap: Distance = Field(default=0.0, description="between shoe and drum at rest")
    drum: Positive = Field(description="inner radius of the drum")
    friction: Coefficient
    spring: SpringModel = Field(description="of a shoe; its force is that at rest")
    moment: Moment = Field(description="that drives the shaft of the brake")
    inertia: PositiveInertia | None = Field(
        default=None, description="on the shaft of the brake, for the start"
    )


class GovernorModel(Model):
    """The speed governor: centrifugal, alone or with the machine and a servomotor; a centrifugal brake."""

    name: Label | None = Field(default=None, description="in the heading")
    arms: ArmsModel | None = Field(default=None, description="Watt, Porter, Proell")
    bell_crank: BellCrankModel | None = Field(default=None, description="Hartnell")
    balls: BallsModel = BallsModel()
    radius: RadiusModel | None = None
    lift: Positive | None = Field(default=None, description="of the sleeve", examples=["30 mm"])
    sleeve: SleeveModel = SleeveModel()
    spring: SpringModel | None = None
    choose: ChooseModel | None = None
    effort: Fraction = Field(default=0.01, description="relative change of the speed for the effort")
    gravity: Acceleration = GRAVITY
    machine: MachineModel | None = None
    servo: ServoModel | None = None
    brake: BrakeModel | None = None
