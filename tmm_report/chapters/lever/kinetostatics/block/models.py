"""The block `loads` as pydantic models."""

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, model_validator

from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import (
    MAP,
    SCALAR,
    Acceleration,
    AngleForces,
    AngleMoments,
    AnglePressures,
    Direction,
    FixedDirection,
    ForceValue,
    Label,
    MomentValue,
    Name,
    Positive,
    Pressure,
    Side,
    StrokeForces,
    StrokePressures,
    by_shape,
)

LAWS = ("constant", "by_position", "by_angle", "by_displacement")


class GravityModel(Model):
    """The acceleration of free fall and where it points."""

    value: Acceleration = 9.81
    direction: FixedDirection = -1j


_ZERO = "the extreme of the point that the stroke is counted from"
_STROKES = (
    "name of the stroke: [[x, value], ...], one for each stroke of the point in the cycle, in the order in which they "
    "follow: the first away from the zero, the next back to it; intake, compression, power, exhaust are translated"
)
_ON = (
    "the link that takes the force, where several share the point; left out, a slider, else the first of them"
)
_BY_POSITION = (
    "one value for each position of the table; of a cycle of full turns without the last position, which is the first "
    "again"
)
_FIRST = (
    "the stroke that is under way at position 0, or begins there; left out, the first of the strokes or, where the "
    "point goes to the zero there, the last"
)


class Diagram(Model):
    """An indicator diagram: force against the fraction of the stroke."""

    zero: Side = Field(description=_ZERO)
    forward: StrokeForces = Field(description="[[x, force], ...] on the way from the zero")
    back: StrokeForces = Field(description="[[x, force], ...] on the way back")


class PressureDiagram(Model):
    """An indicator diagram of pressure against the fraction of the stroke."""

    zero: Side = Field(description=_ZERO)
    forward: StrokePressures = Field(description="[[x, pressure], ...] on the way from the zero")
    back: StrokePressures = Field(description="[[x, pressure], ...] on the way back")


class StrokesDiagram(Model):
    """An indicator diagram of a cycle of several turns: force against the fraction of the stroke, stroke by stroke."""

    zero: Side = Field(description=_ZERO)
    strokes: dict[Label, StrokeForces] = Field(
        description=_STROKES,
        examples=["{intake: [[0, 5 N], [1, 5 N]], compression: [[0, 9 kN], [1, 5 N]], …}"],
    )
    first: Label | None = Field(default=None, description=_FIRST)


class PressureStrokesDiagram(Model):
    """An indicator diagram of a cycle of several turns: pressure against the fraction of the stroke, by strokes."""

    zero: Side = Field(description=_ZERO)
    strokes: dict[Label, StrokePressures] = Field(
        description=_STROKES, examples=["{intake: [[0, 0], [1, 0]], compression: [[0, 3 MPa], [1, 0]], …}"]
    )
    first: Label | None = Field(default=None, description=_FIRST)


def _by_strokes(value: Any) -> str:
    return "<strokes>" if isinstance(value, dict) and {"strokes", "first"} & value.keys() else "<ways>"


AnyDiagram = Annotated[
    Annotated[Diagram, Tag("<ways>")] | Annotated[StrokesDiagram, Tag("<strokes>")],
    Discriminator(_by_strokes),
]
AnyPressureDiagram = Annotated[
    Annotated[PressureDiagram, Tag("<ways>")] | Annotated[PressureStrokesDiagram, Tag("<strokes>")],
    Discriminator(_by_strokes),
]


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
    on: Name | None = Field(default=None, description=_ON, examples=["5"])
    direction: Direction
    constant: ForceValue | None = None
    by_position: list[ForceValue] | None = Field(default=None, description=_BY_POSITION)
    by_angle: AngleForces | None = Field(
        default=None, description="[[angle of turn, force], ...] over the whole cycle"
    )
    by_displacement: AnyDiagram | None = None
    one_law = model_validator(mode="after")(_one_law)


class PistonModel(Model):
    """A pressure on a piston at a named point."""

    name: Label | None = Field(default=None, description="for the tables; left out, F1, F2, …")
    at: Name = Field(description="the point", examples=["B"])
    on: Name | None = Field(default=None, description=_ON, examples=["5"])
    direction: Direction
    piston_diameter: Positive = Field(description="the values of the law are then pressures")
    constant: Pressure | None = None
    by_position: list[Pressure] | None = Field(default=None, description=_BY_POSITION)
    by_angle: AnglePressures | None = Field(
        default=None, description="[[angle of turn, pressure], ...] over the whole cycle"
    )
    by_displacement: AnyPressureDiagram | None = None
    one_law = model_validator(mode="after")(_one_law)


class MomentModel(Model):
    """A moment on a link."""

    name: Label | None = Field(default=None, description="for the tables; left out, M1, M2, …")
    on: Name = Field(description="the link", examples=["3"])
    direction: Literal["clockwise", "counter-clockwise", "along motion", "against motion"]
    constant: MomentValue | None = None
    by_position: list[MomentValue] | None = Field(default=None, description=_BY_POSITION)
    by_angle: AngleMoments | None = Field(
        default=None, description="[[angle of turn, moment], ...] over the whole cycle"
    )
    one_law = model_validator(mode="after")(_one_law)


Indicator = Diagram | PressureDiagram | StrokesDiagram | PressureStrokesDiagram


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
    # None: the hole of a load that is wrong in itself
    forces: list[AnyForce | None] = Field(default=[])
    moments: list[MomentModel | None] = Field(default=[])
