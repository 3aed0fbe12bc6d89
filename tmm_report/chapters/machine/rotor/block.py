"""The block `rotor` of a variant."""

import math
from collections.abc import Iterator
from typing import Annotated, Any, TypedDict

from pydantic import Field

from tmm_report.chapters.machine.rotor.given import Given as Stated
from tmm_report.chapters.machine.rotor.given import Heavy, Plane, Steps
from tmm_report.mechanics.masses.rotor import tilted
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.quantity import units
from tmm_report.quantity.paper import ACCURACY
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    Accuracy,
    Angle,
    Distance,
    Flag,
    Inertia,
    Label,
    Length,
    Mass,
    Name,
    Positive,
    PositiveMass,
    Reads,
    Scale,
    Speed,
    quantity,
)
from tmm_report.yamlread import Path

PATH = ("rotor",)
NEAR = 1e-6  # m: planes so close are one


def _unbalance(value: Any) -> float:
    """A product of mass and radius, kg m."""
    number, unit = units.measured(value)
    found = number * (units.between(unit, "kg*m") if unit else 1.0)
    if found > 1e12:
        text = N_("%(value)s is no product of mass and radius that there can be")
        raise WrongValue(
            Message(text, {"value": value}), Message(N_("a product such as 12 g*mm, or 0.02 kg*m"))
        )
    if found < 0:
        text = N_("%(value)s is negative: the product of mass and radius cannot be")
        raise WrongValue(Message(text, {"value": value}), Message(N_("turn its angle by 180 deg instead")))
    return found


Unbalance = Annotated[
    float,
    Reads(
        _unbalance,
        {
            "anyOf": [{"type": "number"}, {"type": "string"}],
            "description": "mass by radius: SI (kg*m) or text with a unit",
            "examples": ["12 g*mm"],
        },
    ),
]
Product = Annotated[float, quantity("inertia")]
Turned = Annotated[float, quantity("angle", 0.0, math.pi, "0 … 180 deg")]


class HeavyModel(Model):
    """A mass off the axis: its mass and radius, or the product of both."""

    name: Name | None = Field(default=None, description="left out, its number")
    mass: PositiveMass | None = Field(default=None, examples=["2 kg"])
    radius: Distance | None = Field(default=None, description="of its centre", examples=["30 mm"])
    unbalance: Unbalance | None = Field(default=None, description="mass by radius, in place of both")
    angle: Angle = Field(description="from x, counter-clockwise", examples=["60 deg"])
    at: Length = Field(default=0.0, description="place along the shaft")


class TiltModel(Model):
    """A body of revolution set askew."""

    angle: Angle = Field(description="between its axis and that of the shaft", examples=["0.2 deg"])
    towards: Angle = Field(description="direction in which its axis leans, from x")
    axial: Inertia = Field(description="moment of inertia about its own axis", examples=["0.8 kg*m^2"])
    across: Inertia = Field(description="moment of inertia about a diameter", examples=["0.5 kg*m^2"])


class ProductsModel(Model):
    """Products of inertia about the body's mass centre."""

    xz: Product = 0.0
    yz: Product = 0.0


class BodyModel(Model):
    """A body whose mass centre is off the axis, or which is set askew."""

    name: Name | None = None
    mass: PositiveMass
    eccentricity: Distance = 0.0
    angle: Angle = Field(default=0.0, description="direction of the eccentricity, from x")
    at: Length = Field(default=0.0, description="place of the mass centre along the shaft")
    products: ProductsModel | None = None
    tilt: TiltModel | None = None


class PlaneModel(Model):
    """A plane of correction: the weight's radius or its mass."""

    at: Length = 0.0
    radius: Positive | None = Field(default=None, description="the mass is found", examples=["120 mm"])
    mass: PositiveMass | None = Field(default=None, description="the radius is found", examples=["0.4 kg"])
    remove: Flag = Field(default=False, description="material is taken off the opposite side")


class StepsModel(Model):
    """How finely weights are made."""

    mass: Mass = Field(default=0.0, examples=["10 g"])
    radius: Distance = Field(default=0.0, examples=["1 mm"])
    angle: Turned = Field(default=0.0, examples=["1 deg"])


class RotorModel(Model):
    """Masses on a turning shaft balanced in one plane or in two."""

    name: Label | None = Field(default=None, description="in the heading")
    masses: list[HeavyModel] = Field(default=[], max_length=30)
    bodies: list[BodyModel] = Field(default=[], max_length=10)
    planes: list[PlaneModel] = Field(min_length=1, max_length=2, description="one: static; two: dynamic")
    bearings: tuple[Length, Length] | None = Field(default=None, description="places of A and B")
    speed: Speed | None = Field(default=None, examples=["1500 rpm"])
    grade: Scale | None = Field(default=None, description="balance quality grade G, mm/s", examples=[6.3])
    mass: PositiveMass | None = Field(default=None, description="of the whole rotor")
    centre: Length | None = Field(default=None, description="place of its mass centre along the shaft")
    diameter: Positive | None = None
    width: Positive | None = None
    steps: StepsModel | None = Field(default=None, description="how finely weights are made")
    accuracy: Accuracy = Field(default=ACCURACY, description="of the polygons, on paper")


class Block(model.Block):
    """Masses on a turning shaft balanced."""

    ALONE = True

    rotor: RotorModel | None = Field(default=None, description="masses on a turning shaft balanced")


class Given(TypedDict):
    rotor: Stated | None


def given(read: Read) -> Given:
    written = read.block(Block).rotor
    return {"rotor": _stated(written) if written else None}


def _stated(written: RotorModel) -> Stated:
    masses = [_mass(one, str(k)) for k, one in enumerate(written.masses, 1)]
    bodies = [_body(one, str(k)) for k, one in enumerate(written.bodies, 1 + len(masses))]
    return Stated(
        heavy=(*masses, *bodies),
        planes=tuple(Plane(one.at, one.radius, one.mass, one.remove) for one in written.planes),
        bearings=written.bearings,
        speed=written.speed,
        grade=written.grade * 1e-3 if written.grade else None,
        mass=written.mass,
        centre=written.centre,
        diameter=written.diameter,
        width=written.width,
        steps=Steps(written.steps.mass, written.steps.radius, written.steps.angle) if written.steps else None,
        accuracy=written.accuracy,
        name=written.name or "",
    )


def _mass(written: HeavyModel, name: str) -> Heavy:
    product = (
        written.unbalance if written.unbalance is not None else (written.mass or 0) * (written.radius or 0)
    )
    return Heavy(written.name or name, product, written.angle, written.at, written.mass, written.radius)


def _body(written: BodyModel, name: str) -> Heavy:
    couple = 0j
    if written.products:
        couple += complex(written.products.xz, written.products.yz)
    if tilt := written.tilt:
        couple += tilted(tilt.axial, tilt.across, tilt.angle, tilt.towards)
    product = written.mass * written.eccentricity
    named = written.name or name
    return Heavy(named, product, written.angle, written.at, written.mass, written.eccentricity, couple, True)


# --- mistakes


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).rotor
    if written is None:
        return
    # what is wrong in itself is missing here: nothing is said of what belongs with it
    broken = {path[1] for path in read.broken if path[:1] == PATH and len(path) > 1}
    if not broken & {"masses", "bodies"}:
        yield from _masses(written)
        yield from _bodies(written)
    if "planes" not in broken:
        yield from _planes(written)
    yield from _together(written, broken)


def _masses(written: RotorModel) -> Iterator[Problem]:
    if not written.masses and not written.bodies:
        text = N_("the rotor has neither masses nor bodies: there is nothing to balance")
        yield mistake(
            text, PATH, Message(N_("masses: [{mass: 2 kg, radius: 30 mm, angle: 0 deg, at: 50 mm}]"))
        )
    stated = [*(one.name for one in written.masses), *(one.name for one in written.bodies)]
    names = [name or str(k) for k, name in enumerate(stated, 1)]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield mistake(N_("two masses are named %(name)s"), (*PATH, "masses"), name=name)
    for k, one in enumerate(written.masses):
        both = one.mass is not None and one.radius is not None
        neither = one.mass is None and one.radius is None
        if not (both if one.unbalance is None else neither):
            text = N_("a mass needs its mass and its radius, or its unbalance alone")
            yield mistake(text, (*PATH, "masses", k), Message(N_("mass: 2 kg, radius: 30 mm")))


def _planes(written: RotorModel) -> Iterator[Problem]:
    for k, plane in enumerate(written.planes):
        if (plane.radius is None) == (plane.mass is None):
            text = N_("a plane of correction states the radius of its weight or its mass, the other is found")
            yield mistake(text, (*PATH, "planes", k), Message(N_("radius: 120 mm, or mass: 0.4 kg")))
    if len(written.planes) == 2 and abs(written.planes[0].at - written.planes[1].at) < NEAR:
        text = N_("both planes of correction stand at one place: forces in one plane balance no couple")
        yield mistake(text, (*PATH, "planes", 1, "at"), Message(N_("two different places along the shaft")))


def _bodies(written: RotorModel) -> Iterator[Problem]:
    for k, body in enumerate(written.bodies):
        if body.tilt and body.products:
            text = N_("the couple of a body is stated twice: by its products of inertia and by its tilt")
            yield mistake(text, (*PATH, "bodies", k), Message(N_("one of them")))
        if body.tilt and abs(body.tilt.angle) >= math.pi / 2:
            path: Path = (*PATH, "bodies", k, "tilt", "angle")
            yield mistake(N_("a body cannot lean by 90° or more"), path)
        if body.tilt and body.tilt.axial > 2 * body.tilt.across * (1 + 1e-9):
            text = N_("no body has a moment of inertia about its axis above twice that about a diameter")
            yield mistake(text, (*PATH, "bodies", k, "tilt"))


def _together(written: RotorModel, broken: set[str | int]) -> Iterator[Problem]:
    if written.bearings and abs(written.bearings[0] - written.bearings[1]) < NEAR:
        text = N_("both bearings stand at one place: they cannot hold a couple")
        yield mistake(text, (*PATH, "bearings"), Message(N_("two different places along the shaft")))
    if written.grade and not written.speed and "speed" not in broken:
        text = N_("a balance quality grade limits e·ω: the speed is needed")
        yield mistake(text, (*PATH, "grade"), Message(N_("speed: 1500 rpm")))
    unknown = not written.bodies or any(one.mass is None for one in written.masses)
    if written.grade and written.mass is None and unknown and not broken & {"mass", "masses", "bodies"}:
        text = N_("a balance quality grade needs the mass of the whole rotor")
        yield mistake(text, (*PATH, "grade"), Message(N_("mass: 40 kg")))
    if (written.diameter is None) != (written.width is None) and not broken & {"diameter", "width"}:
        text = N_("which balance suffices is seen from the width and the diameter together")
        yield mistake(text, PATH, Message(N_("diameter: 300 mm, width: 60 mm")))
