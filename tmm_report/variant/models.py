"""The format of a variant as pydantic models; the JSON Schema comes from them.

What one part of the file says about another (a load on a known point, a guide through a point of its carrier)
is in `checks`.
"""

import math
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag, model_validator

from tmm_report.languages import DEFAULT, DecimalSign
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.language import CODE
from tmm_report.variant.values import (
    LIST,
    MAP,
    SCALAR,
    SIDES,
    Acceleration,
    Accuracy,
    Angle,
    AngleForces,
    AngleMoments,
    Choice,
    Coefficient,
    DiagramCount,
    Direction,
    Distance,
    FixedDirection,
    Flag,
    ForceValue,
    GroupName,
    Inertia,
    KeyName,
    Label,
    Length,
    Mass,
    MomentValue,
    Name,
    Number,
    Period,
    Point,
    Position,
    PositionKey,
    Positive,
    Range,
    ReadingKey,
    Scale,
    Side,
    Speed,
    StrokeForces,
    StrokePressures,
    TableCount,
    Text,
    Turn,
    by_shape,
)

LAWS = ("constant", "by_position", "by_angle", "by_displacement")


class Model(BaseModel):
    model_config = ConfigDict(
        extra="forbid", allow_inf_nan=False, hide_input_in_errors=True, defer_build=True, frozen=True
    )


class Triangle(Model):
    """A point of a link found by its distances from two points of the same link placed before it."""

    from_: dict[KeyName, Distance] = Field(
        alias="from",
        min_length=2,
        max_length=2,
        description="two points: distance",
        examples=["{A: 75 mm, B: 100 mm}"],
    )
    side: Literal["left", "right"] = Field(
        description="the side, seen going from the first point to the second"
    )


Place = Annotated[
    Annotated[Length, Tag(SCALAR)] | Annotated[Point, Tag(LIST)] | Annotated[Triangle, Tag(MAP)],
    by_shape(N_("75 mm, [75 mm, 10 mm] or {from: {A: 75 mm, B: 100 mm}, side: left}")),
]


class SlideModel(Model):
    """The link slides along a guide."""

    guide: Name = Field(description="the guide's name", examples=["x"])
    at: Name | None = Field(
        default=None, description="the link's point on the guide; left out, its first point"
    )
    angle: Angle = Field(default=0.0, description="the guide's angle in the axes of the sliding link")


_SLIDE = by_shape(N_("the name of a guide, {guide: x, at: B} or a list of these"))
OneSlide = Annotated[Annotated[Name, Tag(SCALAR)] | Annotated[SlideModel, Tag(MAP)], _SLIDE]
Slides = Annotated[
    Annotated[Name, Tag(SCALAR)] | Annotated[SlideModel, Tag(MAP)] | Annotated[list[OneSlide], Tag(LIST)],
    _SLIDE,
]
Points = Annotated[
    Annotated[dict[KeyName, Place], Field(min_length=1), Tag(MAP)]
    | Annotated[list[Name], Field(min_length=1, max_length=1), Tag(LIST)],
    by_shape(N_("{A: 0, B: 300 mm}, or [B] for a link of one point")),
]
Through = Annotated[
    Annotated[Name, Tag(SCALAR)] | Annotated[list[Name], Field(min_length=2, max_length=2), Tag(LIST)],
    by_shape(N_("a point, or two: [P, Q]")),
]


class LinkModel(Model):
    """A moving rigid link. Links that have a point of the same name are joined there by a pivot."""

    points: Points = Field(description="its points, in its own axes", examples=["{A: 0, B: 300 mm}"])
    mass: Mass = 0.0
    mass_centre: Name | None = Field(default=None, description="the point that is the mass centre")
    inertia: Inertia = Field(default=0.0, description="about the mass centre")
    slides: Slides | None = Field(default=None, description="the guide or guides the link slides along")


class GuideModel(Model):
    """A straight line along which links slide, carried by the frame or by a moving link."""

    through: Through = Field(description="a point of the line, or two, P to Q", examples=["O"])
    angle: Angle | None = Field(default=None, description="in the axes of the carrier; left out, 0")
    link: Name = Field(default="0", description="the link that carries the guide; left out, the frame")


class ZeroModel(Model):
    """Position 0, from which positions are counted."""

    angle: Angle | None = Field(default=None, description="of the driving link's x axis")
    point: Name | None = Field(default=None, description="the point that is at its extreme")
    link: Name | None = Field(default=None, description="the rocker that is at its extreme")
    extreme: Literal["right", "left", "up", "down", "clockwise", "counter-clockwise"] | None = None

    @model_validator(mode="after")
    def one_way(self) -> "ZeroModel":
        given = [self.angle, self.point, self.link]
        words = SIDES if self.point is not None else ("clockwise", "counter-clockwise")
        wanted = self.extreme is None if self.angle is not None else self.extreme in words
        if sum(part is not None for part in given) == 1 and wanted:
            return self
        right = N_("{angle: 30 deg}, {point: B, extreme: right} or {link: 3, extreme: clockwise}")
        raise WrongValue(Message(N_("position 0 is not stated in one way")), Message(right))


class DriverModel(Model):
    """The driving link: it turns about a fixed point at constant speed."""

    link: Name = Field(description="the driving link", examples=["1"])
    speed: Speed | None = Field(default=None, description="rad/s or rpm")
    period: Period | None = Field(default=None, description="the time of one turn")
    rotation: Turn = Field(default="counter-clockwise", description="the sense of rotation")
    zero: ZeroModel | None = Field(default=None, description="position 0; left out, the angle 0")
    range: Range = Field(2 * math.pi, description="how far it turns")

    @model_validator(mode="after")
    def one_speed(self) -> "DriverModel":
        if (self.speed is None) == (self.period is None):
            wrong = Message(N_("the speed must be stated once"))
            raise WrongValue(wrong, Message(N_("either speed: 1200 rpm or period: 0.05 s")))
        return self


class MechanismModel(Model):
    """The mechanism as its drawing shows it. Groups of links are found by the program."""

    frame: dict[KeyName, Point] = Field(default={}, description="fixed points, in the axes of the drawing")
    guides: dict[KeyName, GuideModel] = {}
    links: dict[KeyName, LinkModel] = Field(default={}, description="the moving links")
    driver: DriverModel | None = None
    assembly: dict[GroupName, Choice] = Field(
        default={},
        description="which of two ways a group is assembled, by its inner point (B) or its links (2-3)",
    )
    sketch: dict[KeyName, Point] = Field(
        default={}, description="rough places of points in some one position"
    )


class GravityModel(Model):
    """The acceleration of free fall and where it points."""

    value: Acceleration = 9.81
    direction: FixedDirection = -1j


class Diagram(Model):
    """An indicator diagram: force against the fraction of the stroke."""

    zero: Side = Field(description="the extreme of the point that the stroke is counted from")
    forward: StrokeForces = Field(description="[[x, force], ...] on the way from the zero")
    back: StrokeForces = Field(description="[[x, force], ...] on the way back")


class PressureDiagram(Model):
    """An indicator diagram of pressure against the fraction of the stroke."""

    zero: Side = Field(description="the extreme of the point that the stroke is counted from")
    forward: StrokePressures = Field(description="[[x, pressure], ...] on the way from the zero")
    back: StrokePressures = Field(description="[[x, pressure], ...] on the way back")


def _one_law(model: Any) -> Any:
    if sum(getattr(model, law, None) is not None for law in LAWS) != 1:
        wrong = Message(N_("the load's magnitude must be stated by one law"))
        laws = ", ".join(law for law in LAWS if law in type(model).model_fields)
        raise WrongValue(wrong, Message(N_("exactly one of: %(words)s"), {"words": laws}))
    return model


class ForceModel(Model):
    """A force on a named point."""

    name: Label | None = Field(default=None, description="for the tables; left out, F1, F2, …")
    at: Name = Field(description="the point", examples=["B"])
    direction: Direction
    constant: ForceValue | None = None
    by_position: list[ForceValue] | None = Field(
        default=None, description="one value for each position of the table"
    )
    by_angle: AngleForces | None = Field(default=None, description="[[angle of turn, force], ...]")
    by_displacement: Diagram | None = None
    one_law = model_validator(mode="after")(_one_law)


class PistonModel(Model):
    """A pressure on a piston at a named point."""

    name: Label | None = Field(default=None, description="for the tables; left out, F1, F2, …")
    at: Name = Field(description="the point", examples=["B"])
    direction: Direction
    piston_diameter: Positive = Field(description="the values of by_displacement are then pressures")
    by_displacement: PressureDiagram


class MomentModel(Model):
    """A moment on a link."""

    name: Label | None = Field(default=None, description="for the tables; left out, M1, M2, …")
    on: Name = Field(description="the link", examples=["3"])
    direction: Literal["clockwise", "counter-clockwise", "along motion", "against motion"]
    constant: MomentValue | None = None
    by_position: list[MomentValue] | None = Field(
        default=None, description="one value for each position of the table"
    )
    by_angle: AngleMoments | None = Field(default=None, description="[[angle of turn, moment], ...]")
    one_law = model_validator(mode="after")(_one_law)


def _force_kind(value: Any) -> str:
    return "<piston>" if isinstance(value, dict) and "piston_diameter" in value else "<force>"


AnyForce = Annotated[
    Annotated[ForceModel, Tag("<force>")] | Annotated[PistonModel, Tag("<piston>")],
    Discriminator(_force_kind),
]


Gravity = Annotated[
    Annotated[Acceleration, Tag(SCALAR)] | Annotated[GravityModel, Tag(MAP)],
    by_shape(N_("9.81 m/s^2, or {value: 9.81 m/s^2, direction: down}")),
]


class LoadsModel(Model):
    """What acts on the mechanism. Inertia comes from the masses of the links."""

    gravity: Gravity = Field(
        default=9.81, description="downwards unless {value, direction}; 0 switches it off"
    )
    forces: list[AnyForce | None] = []  # None: the hole of a load that is wrong in itself
    moments: list[MomentModel | None] = []


class PivotFriction(Model):
    """Friction in pivots."""

    coefficient: Coefficient
    diameter: Positive = Field(description="of the journal", examples=["50 mm"])


class GuideFriction(Model):
    """Friction in guides."""

    coefficient: Coefficient


class JointFriction(Model):
    """Friction in one joint; the diameter is for a pivot."""

    coefficient: Coefficient
    diameter: Positive | None = None


class FrictionModel(Model):
    """Friction in the joints: of all pivots, of all guides, of single ones."""

    pivots: PivotFriction | None = None
    guides: GuideFriction | None = None
    joints: dict[KeyName, JointFriction] = Field(default={}, description="by point or guide")


Some = Annotated[
    Annotated[Position, Tag(SCALAR)] | Annotated[list[Position], Field(min_length=1), Tag(LIST)],
    by_shape(N_("a position, or a list of positions")),
]


class PositionsModel(Model):
    """How many positions are solved and which are drawn."""

    table: TableCount = Field(default=12, description="positions of the tables")
    diagram: DiagramCount = Field(default=36, description="positions of the diagrams")
    plans: Some | None = Field(
        default=None, description="table positions whose plans are drawn", examples=["[1, 7]"]
    )
    force_plan: Some | None = Field(default=None, description="table positions whose force plan is drawn")


ForceScale = Annotated[
    Annotated[Scale, Tag(SCALAR)] | Annotated[dict[GroupName, Scale], Tag(MAP)],
    by_shape(N_("a number, or a mapping: {2-3: 20}")),
]


class ScalesModel(Model):
    """Scales of the drawings, SI units per mm of paper."""

    length: Scale | None = None
    velocity: Scale | None = None
    acceleration: Scale | None = None
    force: ForceScale | None = Field(default=None, description="one for all, or by group: {2-3: 20}")


class DrawingModel(Model):
    """How the plans are drawn."""

    accuracy: Accuracy = Field(default=1e-5, description="lengths on paper are read to it")
    scales: ScalesModel = Field(default_factory=ScalesModel)


class TitleModel(Model):
    """The title page. Every field is free text."""

    institution: Text = ""
    department: Text = ""
    course: Text = ""
    topic: Text = ""
    student: Text = ""
    group: Text = ""
    variant: Text = ""
    teacher: Text = ""
    city: Text = ""
    year: Text = ""


class LeverModel(Model):
    """A variant without gears: one lever mechanism and all that is given about it."""

    title: TitleModel = Field(default_factory=TitleModel)
    language: Annotated[str, CODE] = Field(default=DEFAULT, description="of the note")
    decimal_sign: DecimalSign | None = Field(default=None, description="left out, it follows the language")
    mechanism: MechanismModel = Field(default_factory=MechanismModel)
    allow_partial: Flag = Field(
        default=False, description="true: a mechanism that exists over part of the cycle only is meant so"
    )
    loads: LoadsModel | None = None
    friction: FrictionModel | None = None
    positions: PositionsModel = Field(default_factory=PositionsModel)
    drawing: DrawingModel = Field(default_factory=DrawingModel)
    readings: dict[PositionKey, dict[ReadingKey, Number]] = Field(
        default={}, description="a student's own readings, SI: position -> symbol -> number"
    )
