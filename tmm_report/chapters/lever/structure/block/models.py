"""The block `mechanism` as pydantic models."""

import math
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, ConfigDict, Discriminator, Field, Tag, model_validator

from tmm_report.chapters.lever.structure.block.cams import CamModel
from tmm_report.chapters.lever.structure.block.driving import LawModel
from tmm_report.chapters.lever.structure.block.strokes.models import StrokeModel
from tmm_report.chapters.lever.structure.block.wheels.models import RackModel, RollingModel, WheelsModel
from tmm_report.mechanics.lever.stated_masses import Statement, Synthesised
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity.text import Typed
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import closed
from tmm_report.variant.model import Model
from tmm_report.variant.russian import english
from tmm_report.variant.values import (
    LIST,
    MAP,
    SCALAR,
    SIDES,
    Angle,
    Choice,
    GroupName,
    KeyName,
    Name,
    Period,
    Point,
    Positive,
    Reads,
    Turn,
    by_shape,
    quantity,
    shape,
    whole,
)

WHEELS = N_(
    "wheels and racks of links stand beside the links: mechanism.wheels: [{links: [1, 2], teeth: [20, 40]}], "
    "mechanism.racks: [{slider: 3, wheel: 4, radius: 48 mm}]"
)
ROLLS = N_(
    "a wheel that rolls on a rail stands beside the links: mechanism.rolling: [{wheel: 4, carrier: 3, radius: 50 mm, "
    "side: above}]"
)
BELTS = N_(
    "belts and chains within the linkage are not offered: wheels in mesh are, mechanism.wheels; a belt drive is a "
    "stage of the block drive, kind: belt"
)
STROKE = N_("{slider: 3, stroke: {from: 0.35 m, to: 0.60 m, speed: 1.2 m/s}}")
Turns = Annotated[int, whole(1, 4)]


def _stated(dimension: str, low: float, read: Callable[[str], Statement], examples: Sequence[str]) -> Reads:
    """A number with a unit, or how it follows from lengths and the masses of links."""
    plain = quantity(dimension, low)

    def value(written: object) -> float | Statement:
        try:
            return plain.value(written)
        except WrongValue:
            if isinstance(written, str) and closed.looks_closed(written):
                return read(written)
            raise

    # what is no number with a unit is read as a statement, whatever its letters
    texts = {"type": "string", "pattern": r"^[^;:#{}]*$", "maxLength": closed.LONGEST}
    shown = {"anyOf": [{"type": "number"}, texts], "examples": [*plain.schema["examples"], *examples]}
    return Reads(value, {**plain.schema, **shown}, dimension)


_SYNTHESISED = re.compile(r"\s*synthesis\.([a-z_]+)\s*")


def _angle(plain: Reads) -> Reads:
    """An angle, or one that the synthesis finds."""

    def value(written: object) -> float | Synthesised:
        if isinstance(written, str) and (match := _SYNTHESISED.fullmatch(written)):
            return Synthesised(match[1])
        return plain.value(written)  # type: ignore[no-any-return]

    texts = {"type": "string"}
    shown = {"anyOf": [*plain.schema["anyOf"], texts], "examples": [*plain.schema["examples"]]}
    return Reads(value, {**plain.schema, **shown}, "angle", plain.bounded)


AnyLength = Annotated[float | Statement, _stated("length", -math.inf, closed.length, ["0.4*l_AB"])]
AnyAngle = Annotated[float | Synthesised, _angle(quantity("angle"))]
AnyRange = Annotated[float | Synthesised, _angle(quantity("angle", 1e-6, 2 * math.pi, "0 … 360 deg"))]
AnyDistance = Annotated[float | Statement, _stated("length", 0.0, closed.length, ["0.4*l_AB"])]
AnyMass = Annotated[float | Statement, _stated("mass", 0.0, closed.mass, ["30 kg/m", "0.3*m2"])]
StatedInertia = Annotated[
    float | Statement, _stated("inertia", 0.0, closed.inertia, ["m*l^2/12", "0.17*m*l_AB^2"])
]


class Triangle(Model):
    """A point of a link found by its distances from two points of the same link placed before it."""

    from_: dict[KeyName, AnyDistance] = Field(
        alias="from",
        min_length=2,
        max_length=2,
        description="two points: distance",
        examples=["{A: 75 mm, B: 100 mm}"],
    )
    side: Literal["left", "right"] = Field(
        description="the side, seen going from the first point to the second"
    )


class Corner(Model):
    """A point of a link found by its distance from a point of the same link placed before it and by an angle."""

    distance: AnyDistance = Field(description="from that point", examples=["1.3 m"])
    angle: Angle = Field(
        description="counter-clockwise from the link's x axis, or from the way to another point",
        examples=["20 deg"],
    )
    about: Name | None = Field(
        default=None, description="the point it is measured from; left out, the first", examples=["B"]
    )
    to: Name | None = Field(
        default=None, description="the point to which the angle is 0; left out, along the link's x axis"
    )


AnyPoint = tuple[AnyLength, AnyLength]
CORNER = "<corner>"


def _by_shape(value: object) -> str:
    by_angle = isinstance(value, dict) and {"distance", "angle", "about", "to"} & value.keys()
    return CORNER if by_angle or isinstance(value, Corner) else shape(value)


Place = Annotated[
    Annotated[AnyLength, Tag(SCALAR)]
    | Annotated[AnyPoint, Tag(LIST)]
    | Annotated[Triangle, Tag(MAP)]
    | Annotated[Corner, Tag(CORNER)],
    Discriminator(
        _by_shape,
        custom_error_type="shape",
        custom_error_message=N_(
            "75 mm, [75 mm, 10 mm], {distance: 75 mm, angle: 20 deg} or {from: {A: 75 mm, B: 100 mm}, side: left}"
        ),
    ),
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


def _placed(points: Any) -> Any:
    """A list names one point alone: of several nothing says where they stand on the link."""
    if isinstance(points, list) and len(points) > 1:
        first, *rest = (shown(point, 20) for point in points[:3])
        values = {"points": shown(", ".join(str(point) for point in points), 60)}
        wrong = Message(
            N_("the list names several points (%(points)s), but not their places on the link"), values
        )
        example = ", ".join(
            [f"{first}: 0", *(f"{point}: {100 * k} mm" for k, point in enumerate(rest, start=1))]
        )
        raise WrongValue(
            wrong,
            Message(N_("the points with their places, such as {%(example)s}"), {"example": Typed(example)}),
        )
    return points


Points = Annotated[
    Annotated[dict[KeyName, Place], Field(min_length=1), Tag(MAP)]
    | Annotated[list[Name], Field(min_length=1, max_length=1), BeforeValidator(_placed), Tag(LIST)],
    by_shape(N_("{A: 0, B: 300 mm}, or [B] for a link of one point")),
]
COORDINATES = "<coordinates>"
_MEASURED = re.compile(r"[-+−]?\d[\d.,]*(\s.*|mm|cm|мм|см)")  # what can be no point's name


def _of_line(value: Any) -> str:
    """The shape of a line's points; coordinates where one of both has a unit or is no whole number."""
    items = value if isinstance(value, list | tuple) else ()
    measured = (isinstance(one, float) or _MEASURED.fullmatch(str(one)) for one in items)
    return COORDINATES if any(measured) else shape(value)


Through = Annotated[
    Annotated[Name, Tag(SCALAR)]
    | Annotated[list[Name], Field(min_length=2, max_length=2), Tag(LIST)]
    | Annotated[Point, Tag(COORDINATES)],
    Discriminator(
        _of_line,
        custom_error_type="shape",
        custom_error_message=N_("a point, two: [P, Q], or the coordinates of one: [12 mm, 0]"),
    ),
]


class InertiaModel(Model):
    """A moment of inertia about any point of the link; that about the mass centre follows by Steiner."""

    value: StatedInertia = Field(examples=["0.01 kg*m^2", "m*l^2/3"])
    about: Name = Field(description="a point of the link", examples=["O"])


AnyInertia = Annotated[
    Annotated[StatedInertia, Tag(SCALAR)] | Annotated[InertiaModel, Tag(MAP)],
    by_shape(N_("0.01 kg*m^2, or {value: 0.01 kg*m^2, about: O}")),
]


class LinkModel(Model):
    """A moving rigid link. Links that have a point of the same name are joined there by a pivot."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("wheel", "gear", "rack", "teeth"), WHEELS),
        "rolls": ROLLS,
    }

    points: Points = Field(description="its points, in its own axes", examples=["{A: 0, B: 300 mm}"])
    mass: AnyMass = Field(
        default=0.0, description="or of a metre of its length (30 kg/m), or of another link's (0.3*m2)"
    )
    mass_centre: Name | None = Field(
        default=None,
        description="the point that is the mass centre; left out, the middle of a link of two joints",
    )
    inertia: AnyInertia = Field(
        default=0.0,
        description="about the mass centre, or {value, about} a point of the link; by lengths: m*l^2/12",
    )
    slides: Slides | None = Field(default=None, description="the guide or guides the link slides along")


class GuideModel(Model):
    """A straight line along which links slide, carried by the frame or by a moving link."""

    through: Through = Field(
        description="a point of the line, two, P to Q, or the coordinates of one", examples=["O"]
    )
    angle: AnyAngle | None = Field(default=None, description="in the axes of the carrier; left out, 0")
    link: Name = Field(default="0", description="the link that carries the guide; left out, the frame")

    @model_validator(mode="before")
    @classmethod
    def through_its_points(cls, data: Any) -> Any:
        """Two points of a guide stand under `through`."""
        points = data.get("points") if isinstance(data, dict) and "through" not in data else None
        if isinstance(points, list) and len(points) == 2:
            names = ", ".join(shown(point, 20) for point in points)
            wrong = Message(N_("the points that the line of a guide goes through stand under another key"))
            raise WrongValue(wrong, Message("through: [%(names)s]", {"names": names}))
        return data


class ZeroModel(Model):
    """Position 0, from which positions are counted."""

    angle: AnyAngle | None = Field(default=None, description="of the driving link's x axis")
    point: Name | None = Field(default=None, description="the point that is at its extreme")
    link: Name | None = Field(default=None, description="the rocker that is at its extreme")
    extreme: Literal["right", "left", "up", "down", "clockwise", "counter-clockwise"] | None = Field(
        default=None, description="which extreme position: a side of a point, a sense of turning of a link"
    )

    @model_validator(mode="after")
    def one_way(self) -> "ZeroModel":
        given = [self.angle, self.point, self.link]
        words = SIDES if self.point is not None else ("clockwise", "counter-clockwise")
        wanted = self.extreme is None if self.angle is not None else self.extreme in words
        if sum(part is not None for part in given) == 1 and wanted:
            return self
        right = N_("{angle: 30 deg}, {point: B, extreme: right} or {link: 3, extreme: clockwise}")
        raise WrongValue(Message(N_("position 0 is not stated in one way")), Message(right))


class GearModel(Model):
    """A gear on the driving link's shaft, in mesh with the wheel that drives it: a balancing force in its teeth."""

    radius: Positive = Field(description="of its pitch circle", examples=["60 mm"])
    alpha_w: Angle = Field(default=math.radians(20), description="the angle of engagement; left out, 20 deg")
    at: Angle = Field(description="direction from the pivot to the pitch point", examples=["-90 deg"])
    flank: Literal["either", "driving"] = Field(
        default="either",
        description="in contact: that which the sense of the moment presses, or always that by which the wheel drives",
    )

    @model_validator(mode="after")
    def engaged(self) -> "GearModel":
        if not 0 <= self.alpha_w < math.radians(45):
            wrong = Message(N_("an angle of engagement from 0 to 45 degrees"))
            raise WrongValue(Message(N_("no teeth are in mesh at this angle of engagement")), wrong)
        return self


SLOWEST = 1e-12  # rad/s
_SPEED, _SIGNED = quantity("speed", SLOWEST), quantity("speed")


def _driver_speed(value: object) -> float | str | Synthesised:
    """A speed, negative clockwise, that of a synthesis, or the word that leaves it to the drive."""
    word = english(value, ("drive",))
    if isinstance(word, str) and word.strip() == "drive":
        return "drive"
    if isinstance(value, str) and (match := _SYNTHESISED.fullmatch(value)):
        return Synthesised(match[1])
    found = _SIGNED.value(value)
    return found if abs(found) >= SLOWEST else _SPEED.value(value)  # type: ignore[no-any-return]


DriverSpeed = Annotated[
    float | Literal["drive"] | Synthesised,
    Reads(
        _driver_speed,
        {
            "anyOf": [
                *_SPEED.schema["anyOf"],
                {"const": "drive"},
                {"type": "string", "pattern": r"^\s*synthesis\."},
            ],
            "examples": ["1200 rpm", "drive"],
            "x-unit": _SPEED.schema["x-unit"],
        },
        "speed",
    ),
]


class DriverModel(Model):
    """The driving link: it turns about a fixed point at constant speed, or by a law of the time; or a slider or a
    hydraulic cylinder by its stroke."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("acceleration", "angular_acceleration", "epsilon", "eps", "phi", "harmonic", "polynomial"),
        N_(
            "how the driving link moves, if not uniformly, stands under law: {speed: 10 rad/s, acceleration: 5 rad/s^2}"
        ),
    )

    model_config = ConfigDict(
        json_schema_extra={
            "anyOf": [
                {"required": ["link"]}, {"required": ["slider", "stroke"]}, {"required": ["cylinder", "stroke"]},
            ]
        }
    )  # fmt: skip

    link: Name | None = Field(default=None, description="the driving link", examples=["1"])
    slider: Name | None = Field(
        default=None, description="in place of link: a slider that drives by its stroke", examples=["3"]
    )
    cylinder: tuple[Name, Name] | None = Field(
        default=None, description="in place of link: a cylinder between two points", examples=["[A, B]"]
    )
    stroke: StrokeModel | None = Field(default=None, description="of the slider or the cylinder by the time")
    speed: DriverSpeed | None = Field(
        default=None,
        description="rad/s or rpm, negative: clockwise; drive: that of the output shaft of the drive",
    )
    period: Period | None = Field(default=None, description="the time of one turn")
    law: LawModel | None = Field(
        default=None,
        description="its angle by the time, instead of a speed",
        examples=["{speed: 10 rad/s, acceleration: 5 rad/s^2}"],
    )
    rotation: Turn = Field(default="counter-clockwise", description="the sense of rotation")
    zero: ZeroModel | None = Field(default=None, description="position 0; left out, the angle 0")
    range: AnyRange = Field(2 * math.pi, description="how far it turns")
    turns: Turns = Field(
        default=1, description="full turns in a cycle of the loads: 2 of a four-stroke engine"
    )
    gear: GearModel | None = Field(
        default=None, description="by which the link is turned; left out, a moment"
    )

    @model_validator(mode="before")
    @classmethod
    def has_a_stroke(cls, data: Any) -> Any:
        """Before a speed beside the slider is called wrong."""
        if isinstance(data, dict) and data.keys() & {"slider", "cylinder"} and "stroke" not in data:
            raise WrongValue(Message(N_("the stroke of the slider or cylinder is missing")), Message(STROKE))
        return data

    @model_validator(mode="after")
    def one_way(self) -> "DriverModel":
        if sum(way is not None for way in (self.link, self.slider, self.cylinder)) != 1:
            wrong = Message(N_("what drives must be stated once"))
            raise WrongValue(wrong, Message(N_("one of link: 1, slider: 3, cylinder: [A, B]")))
        if (self.stroke is not None) != (self.link is None):
            text = N_("a stroke is that of a slider or of a cylinder, and a link turns")
            raise WrongValue(Message(text), Message(STROKE))
        return self

    @model_validator(mode="after")
    def one_speed(self) -> "DriverModel":
        if self.stroke is not None:
            others = ("speed", "period", "law", "rotation", "zero", "range", "turns", "gear")
            for key in (key for key in others if key in self.model_fields_set):
                wrong = Message(
                    N_("%(key)s does not go together with a stroke: it says that itself"), {"key": key}
                )
                raise WrongValue(wrong, Message(N_("position 0 is where the stroke begins")))
            return self
        if sum(way is not None for way in (self.speed, self.period, self.law)) != 1:
            wrong = Message(N_("the speed must be stated once"))
            raise WrongValue(wrong, Message(N_("either speed: 1200 rpm or period: 0.05 s")))
        if self.law is not None and self.zero is not None and "angle" in self.law.model_fields_set:
            wrong = Message(N_("where the law begins is stated twice, by zero and by the angle of the law"))
            raise WrongValue(wrong, Message(N_("leave one of the two")))
        for key in ("rotation", "range", "turns", "gear"):
            if self.law is not None and key in self.model_fields_set:
                wrong = Message(
                    N_("%(key)s does not go together with a law: it says that itself"), {"key": key}
                )
                raise WrongValue(
                    wrong, Message(N_("position 0 is where the law begins, and its sense is its own"))
                )
        if isinstance(self.speed, float) and self.speed < 0 and "rotation" in self.model_fields_set:
            wrong = Message(N_("the sense of rotation is stated twice, by the minus and by rotation"))
            raise WrongValue(
                wrong, Message(N_("a positive speed with rotation, or a negative one, clockwise, without"))
            )
        return self

    @model_validator(mode="after")
    def one_cycle(self) -> "DriverModel":
        if self.turns > 1 and "range" in self.model_fields_set:
            wrong = Message(N_("a cycle of several turns is one of full turns: it has no range"))
            raise WrongValue(wrong, Message(N_("either turns: 2 or range: 90 deg")))
        return self


class MechanismModel(Model):
    """The mechanism as its drawing shows it. Groups of links are found by the program."""

    NOT_OFFERED: ClassVar[Mapping[str, str]] = {
        **dict.fromkeys(("wheel", "gear", "gears", "rack"), WHEELS),
        **dict.fromkeys(("belts", "chains"), BELTS),
        **dict.fromkeys(
            ("springs", "dampers"),
            N_("springs and dampers between points are loads: loads.springs, loads.dampers"),
        ),
    }

    # the parts that every mechanism has may be absent here, to check the rest all the same: `checks` wants them
    model_config = ConfigDict(json_schema_extra={"required": ["frame", "links", "driver"]})

    frame: dict[KeyName, AnyPoint] = Field(default={}, description="fixed points, in the axes of the drawing")
    guides: dict[KeyName, GuideModel] = Field(default={})
    links: dict[KeyName, LinkModel] = Field(default={}, description="the moving links")
    driver: DriverModel | None = None
    cams: dict[KeyName, CamModel] = Field(
        default={}, max_length=4, description="cam pairs, by the names of the links that replace them"
    )
    wheels: list[WheelsModel] = Field(
        default=[], max_length=8, description="pairs of wheels in mesh, each fixed to a link"
    )
    racks: list[RackModel] = Field(
        default=[], max_length=8, description="racks on sliders, with their wheels"
    )
    rolling: list[RollingModel] = Field(
        default=[], max_length=8, description="wheels that roll on fixed rails without slip"
    )
    assembly: dict[GroupName, Choice] = Field(
        default={},
        description="which of two ways a group is assembled, by its inner point (B) or its links (2-3)",
    )
    sketch: dict[KeyName, Point] = Field(
        default={}, description="rough places of points in some one position"
    )
