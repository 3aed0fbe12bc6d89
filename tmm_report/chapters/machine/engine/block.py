"""The block `engine` of a variant."""

from collections.abc import Iterator, Sequence
from typing import Annotated, Literal, TypedDict

from pydantic import Field

from tmm_report.chapters.machine.engine.given import Counterweight, Cylinder, Rod
from tmm_report.chapters.machine.engine.given import Given as Stated
from tmm_report.mechanics.masses import engine_cylinders as layouts
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.quantity.paper import ACCURACY
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    Accuracy,
    Angle,
    Coefficient,
    Distance,
    Label,
    Length,
    Mass,
    Name,
    Positive,
    PositiveMass,
    Range,
    Speed,
    whole,
)

PATH = ("engine",)
LAYOUTS = ("cylinders", "inline", "vee", "opposed", "radial")
LONGEST = 0.9  # the largest r/l that is solved
Count = Annotated[int, whole(2, 24)]
Cranks = Annotated[list[Angle], Field(min_length=1, max_length=24)]


class CylinderModel(Model):
    """One cylinder."""

    name: Name | None = Field(default=None, description="left out, its number")
    bank: Angle = Field(default=0.0, description="of its axis from the upward vertical, counter-clockwise")
    crank: Angle = Field(default=0.0, description="of its crank from that of angle 0", examples=["180 deg"])
    at: Length = Field(default=0.0, description="place along the crankshaft")


class InlineModel(Model):
    """Cylinders in a row."""

    cranks: Cranks = Field(examples=["[0, 180 deg, 180 deg, 0]"])
    spacing: Distance = Field(default=0.0, description="between neighbouring cylinders", examples=["90 mm"])
    bank: Angle = Field(default=0.0, description="of the row from the upward vertical")


class VeeModel(Model):
    """Two rows, two cylinders on each crankpin."""

    angle: Range = Field(description="between the rows", examples=["90 deg"])
    cranks: Cranks = Field(description="of the crankpins", examples=["[0, 90 deg, 270 deg, 180 deg]"])
    spacing: Distance = Field(default=0.0, description="between neighbouring crankpins")
    offset: Distance = Field(default=0.0, description="along the shaft, of the two cylinders of a pin")


class OpposedModel(Model):
    """Lying cylinders to the left and to the right by turns, each with its own crankpin."""

    cranks: Cranks = Field(examples=["[0, 180 deg]"])
    spacing: Distance = Field(default=0.0, description="between neighbouring cylinders")


class RadialModel(Model):
    """A star of cylinders about one crankpin."""

    cylinders: Count
    bank: Angle = Field(default=0.0, description="of the first from the upward vertical")


class RodModel(Model):
    """The connecting rod's mass, split statically between crankpin and piston pin."""

    mass: PositiveMass
    centre: Distance = Field(description="of its mass centre from the crankpin", examples=["45 mm"])


class CounterweightModel(Model):
    """Opposite each crank: two of the three, the third is found."""

    share: Coefficient | None = Field(
        default=None, description="part of the reciprocating mass balanced beside all the rotating one"
    )
    radius: Positive | None = None
    mass: PositiveMass | None = None


class EngineModel(Model):
    """Balance of an engine of several cylinders; its layout by one key: cylinders, inline, vee, opposed or radial."""

    name: Label | None = Field(default=None, description="in the heading")
    cylinders: list[CylinderModel] | None = Field(default=None, min_length=1, max_length=24)
    inline: InlineModel | None = None
    vee: VeeModel | None = None
    opposed: OpposedModel | None = None
    radial: RadialModel | None = None
    speed: Speed = Field(examples=["3000 rpm"])
    crank_radius: Positive = Field(examples=["40 mm"])
    rod_length: Positive = Field(examples=["150 mm"])
    reciprocating: PositiveMass = Field(description="piston with its pin and rings, without the rod")
    rotating: Mass = Field(default=0.0, description="brought to the crankpin, without the rod")
    rod: RodModel | None = None
    counterweights: CounterweightModel | None = None
    about: Length | None = Field(
        default=None,
        description="plane of the moments along the shaft; left out, the middle of the cylinders",
    )
    firing: list[Name] | None = Field(
        default=None, max_length=24, description="order in which cylinders fire"
    )
    strokes: Literal[2, 4] = 4
    accuracy: Accuracy = Field(default=ACCURACY, description="of the polygons, on paper")


class Block(model.Block):
    """Balance of an engine of several cylinders."""

    ALONE = True

    engine: EngineModel | None = Field(default=None, description="balance of an engine of several cylinders")


class Given(TypedDict):
    engine: Stated | None


def given(read: Read) -> Given:
    written = read.block(Block).engine
    return {"engine": _stated(written) if written else None}


def _stated(written: EngineModel) -> Stated:
    rod, weight = written.rod, written.counterweights
    return Stated(
        cylinders=cylinders(written),
        radius=written.crank_radius,
        length=written.rod_length,
        speed=written.speed,
        piston=written.reciprocating,
        rotating=written.rotating,
        rod=Rod(rod.mass, rod.centre) if rod else None,
        counterweight=Counterweight(weight.share, weight.radius, weight.mass) if weight else None,
        about=written.about,
        firing=tuple(written.firing or ()),
        strokes=written.strokes,
        accuracy=written.accuracy,
        name=written.name or "",
    )


def cylinders(written: EngineModel) -> tuple[Cylinder, ...]:
    """Of the layout that is stated; nothing where none is."""
    if written.cylinders is not None:
        return tuple(
            Cylinder(one.name or str(k), one.bank, one.crank, one.at)
            for k, one in enumerate(written.cylinders, 1)
        )
    if written.inline is not None:
        return _numbered(layouts.inline(written.inline.cranks, written.inline.spacing, written.inline.bank))
    if written.vee is not None:
        vee = written.vee
        return _numbered(layouts.vee(vee.angle, vee.cranks, vee.spacing, vee.offset))
    if written.opposed is not None:
        return _numbered(layouts.opposed(written.opposed.cranks, written.opposed.spacing))
    if written.radial is not None:
        return _numbered(layouts.radial(written.radial.cylinders, written.radial.bank))
    return ()


def _numbered(layout: Sequence[Sequence[float]]) -> tuple[Cylinder, ...]:
    columns = zip(*layout, strict=True)
    return tuple(
        Cylinder(str(k), float(bank), float(crank), float(at))
        for k, (bank, crank, at) in enumerate(columns, 1)
    )


# --- mistakes


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).engine
    if written is None:
        return
    # what is wrong in itself is missing here: nothing is said of what belongs with it
    broken = {path[1] for path in read.broken if path[:1] == PATH and len(path) > 1}
    laid = not broken.intersection(LAYOUTS)
    if laid:
        yield from _layout(written)
    yield from _sizes(written)
    if "counterweights" not in broken:
        yield from _counterweights(written)
    if laid and "firing" not in broken:
        yield from _firing(written)


def _layout(written: EngineModel) -> Iterator[Problem]:
    stated = [key for key in LAYOUTS if getattr(written, key) is not None]
    if len(stated) != 1:
        text = N_("the layout of the cylinders must be stated by one key")
        yield mistake(text, PATH, Message(N_("exactly one of: %(words)s"), {"words": ", ".join(LAYOUTS)}))
    names = [one.name for one in cylinders(written)]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield mistake(N_("two cylinders are named %(name)s"), (*PATH, "cylinders"), name=name)


def _sizes(written: EngineModel) -> Iterator[Problem]:
    if written.crank_radius > LONGEST * written.rod_length:
        text = N_(
            "the connecting rod is too short: with the crank radius at %(ratio)s of it the crank hardly turns over"
        )
        ratio = f"{written.crank_radius / written.rod_length:.3g}"
        right = Message(
            N_("a connecting rod at least %(least)s mm long"),
            {"least": f"{1e3 * written.crank_radius / LONGEST:.4g}"},
        )
        yield mistake(text, (*PATH, "rod_length"), right, ratio=ratio)
    if written.rod and written.rod.centre > written.rod_length:
        text = N_("the mass centre of the connecting rod lies beyond its piston pin")
        right = Message(N_("a distance from the crankpin up to the length of the rod"))
        yield mistake(text, (*PATH, "rod", "centre"), right)


def _counterweights(written: EngineModel) -> Iterator[Problem]:
    weight = written.counterweights
    if weight is None:
        return
    stated = sum(one is not None for one in (weight.share, weight.radius, weight.mass))
    if stated != 2:
        text = N_("of a counterweight two of share, radius and mass are stated, the third is found")
        yield mistake(text, (*PATH, "counterweights"), Message(N_("share: 0.5, radius: 60 mm")))


def _firing(written: EngineModel) -> Iterator[Problem]:
    names = {one.name for one in cylinders(written)}
    order = written.firing
    if order is not None and names and sorted(order) != sorted(names):
        text = N_("the order of firing must name every cylinder once")
        right = Message(
            N_("the cylinders are %(names)s"), {"names": ", ".join(sorted(names, key=lambda n: (len(n), n)))}
        )
        yield mistake(text, (*PATH, "firing"), right)
