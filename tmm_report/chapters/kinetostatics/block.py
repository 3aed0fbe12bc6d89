"""The block `loads` of a variant."""

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal, TypedDict

from pydantic import Discriminator, Field, Tag, model_validator

from tmm_report.chapters.kinematics.block import table_of
from tmm_report.chapters.kinetostatics.loads import (
    ByAngle,
    ByDisplacement,
    ByPosition,
    Constant,
    Force,
    Law,
    Loads,
    Moment,
    Motion,
    TurnLaw,
)
from tmm_report.chapters.structure.block import FRAME, Names, names, no_link, no_point, stated, without
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    MAP,
    SCALAR,
    SENSES,
    SIDES,
    Acceleration,
    AngleForces,
    AngleMoments,
    Direction,
    FixedDirection,
    ForceValue,
    Label,
    MomentValue,
    Name,
    Positive,
    Side,
    StrokeForces,
    StrokePressures,
    by_shape,
)
from tmm_report.yamlread import Path

LAWS = ("constant", "by_position", "by_angle", "by_displacement")
_TURNS: dict[str, int | Motion] = {**SENSES, "along motion": "along", "against motion": "against"}


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
    # None: the hole of a load that is wrong in itself
    forces: list[AnyForce | None] = Field(default=[])
    moments: list[MomentModel | None] = Field(default=[])


class Block(model.Block):
    """Loads."""

    HOLES = frozenset({("loads", "forces"), ("loads", "moments")})

    loads: LoadsModel | None = None


class Given(TypedDict):
    loads: Loads | None


def given(read: Read) -> Given:
    written = read.block(Block).loads
    return {"loads": _loads(written) if written else None}


def _loads(written: LoadsModel) -> Loads:
    gravity = written.gravity
    pull = gravity.value * gravity.direction if isinstance(gravity, GravityModel) else gravity * -1j
    forces = [_force(one, index) for index, one in enumerate(written.forces, 1) if one]
    moments = [_moment(one, index) for index, one in enumerate(written.moments, 1) if one]
    return Loads(pull, tuple(forces), tuple(moments))


def _force(written: ForceModel | PistonModel, index: int) -> Force:
    return Force(written.name or f"F{index}", written.at, written.direction, _force_law(written))


def _moment(written: MomentModel, index: int) -> Moment:
    return Moment(written.name or f"M{index}", written.on, _TURNS[written.direction], _law(written))


def _force_law(written: ForceModel | PistonModel) -> Law:
    if isinstance(written, PistonModel):
        return _indicated(written.by_displacement, math.pi / 4 * written.piston_diameter**2)
    return _indicated(written.by_displacement, 1.0) if written.by_displacement else _law(written)


def _indicated(diagram: Diagram | PressureDiagram, area: float) -> ByDisplacement:
    """An indicator diagram; `area` turns pressures into forces."""
    forward, back = (tuple((x, y * area) for x, y in way) for way in (diagram.forward, diagram.back))
    return ByDisplacement(SIDES[diagram.zero], forward, back)


def _law(written: ForceModel | MomentModel) -> TurnLaw:
    """The one law of those that forces and moments have both."""
    if written.by_angle is not None:
        return ByAngle(tuple(x for x, _ in written.by_angle), tuple(y for _, y in written.by_angle))
    if written.by_position is not None:
        return ByPosition(tuple(written.by_position))
    assert written.constant is not None  # `_one_law` wants one of them
    return Constant(written.constant)


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "loads")
        return
    written, known = read.block(Block).loads or LoadsModel(), names(read.data)
    for index, force in enumerate(written.forces):
        if force:
            yield from _loaded(force.at, ("loads", "forces", index, "at"), known)
            yield from _one_each(force, ("loads", "forces", index), read)
    for index, moment in enumerate(written.moments):
        if moment:
            yield from no_link(moment.on, ("loads", "moments", index, "on"), known)
            yield from _one_each(moment, ("loads", "moments", index), read)


def _loaded(name: str, path: Path, known: Names) -> Iterator[Problem]:
    yield from no_point(name, path, known)
    moving = list(dict.fromkeys(p for link, points in known.points.items() if link != FRAME for p in points))
    if name in known.all_points and name not in moving:
        text = N_("the point %(name)s is on the frame only: a force there loads no moving link")
        yield mistake(text, path, near(name, moving), name=name)


def _one_each(load: ForceModel | PistonModel | MomentModel, path: Path, read: Read) -> Iterator[Problem]:
    """A value for each position of the table, where they are stated by position."""
    values, count = None if isinstance(load, PistonModel) else load.by_position, table_of(read)
    if values is not None and count is not None and len(values) != count:
        text = N_("%(found)s values, %(count)s positions")
        right = Message(N_("one value for each position of the table"))
        yield mistake(text, (*path, "by_position"), right, found=len(values), count=count)
