"""What is given of the flywheel, as the block states it, SI: the loads of a machine that stands alone, the wanted
unevenness, the wheel's shape."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from tmm_report.mechanics.calculus import laws
from tmm_report.mechanics.calculus.laws import ByAngle, Constant, Harmonics, Law
from tmm_report.problems import N_, Message, shown
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field, Tag

    from tmm_report.variant import values
    from tmm_report.variant.values import (
        MAP,
        SCALAR,
        Density,
        Flag,
        Fraction,
        MomentValue,
        Number,
        Period,
        Positive,
        PositiveInertia,
        PositiveMass,
        Reads,
        Scale,
        Speed,
        Turned,
        by_shape,
        quantity,
        whole,
    )


def _delta(value: Any) -> float:
    """1/30 or 0.0333: a number between nothing and one."""
    found = units.parse(value, "number")
    if found < 0:
        text = N_("%(value)s: the greatest speed is never below the least")
        raise WrongValue(Message(text, {"value": shown(value)}), Message(N_("for example, 1/30")))
    if found == 0:
        text = N_("%(value)s: without any unevenness the flywheel would be infinitely heavy")
        raise WrongValue(Message(text, {"value": shown(value)}), Message(N_("for example, 1/30")))
    if found >= 1:
        text = N_("%(value)s is no unevenness of a steady motion: the speed would vary by as much as it is")
        raise WrongValue(Message(text, {"value": shown(value)}), Message(N_("for example, 1/30")))
    return found


_FRACTION = {"type": ["number", "string"], "description": "a number or a fraction", "examples": ["1/30"]}


@dataclass(frozen=True)
class Wave(laws.Wave):
    """A harmonic of the angle turned: cos·cos(order φ) + sin·sin(order φ)."""

    order: Annotated[
        float,
        quantity("number", 0.01, 24.0, "0.01 … 24"),
        Field(description="1: one wave in a turn", examples=[2]),
    ]


@dataclass(frozen=True)
class Harmonic(Wave):
    """A harmonic of a moment: cos·cos(order φ) + sin·sin(order φ)."""

    cos: MomentValue = 0.0
    sin: MomentValue = 0.0


@dataclass(frozen=True)
class InertiaHarmonic(Wave):
    """A harmonic of a moment of inertia: cos·cos(order φ) + sin·sin(order φ)."""

    cos: Annotated[float, quantity("inertia")] = 0.0
    sin: Annotated[float, quantity("inertia")] = 0.0


@dataclass(frozen=True)
class Moment:
    """A moment on the main link over the cycle, by one law."""

    constant: MomentValue | None = None
    table: Annotated[
        list[tuple[Turned, MomentValue]] | None,
        Field(min_length=2, max_length=1000, description="[[angle turned, moment], ...], linear between"),
    ] = None
    mean: Annotated[MomentValue | None, Field(description="with harmonics: the mean moment")] = None
    harmonics: Annotated[list[Harmonic] | None, Field(min_length=1, max_length=50)] = None

    @property
    def law(self) -> Law:
        return _law(self)


@dataclass(frozen=True)
class Inertia:
    """Reduced moment of inertia of the machine without the flywheel, by one law."""

    constant: values.Inertia | None = None
    table: Annotated[
        list[tuple[Turned, values.Inertia]] | None,
        Field(
            min_length=2,
            max_length=1000,
            description="[[angle turned, inertia], ...], linear between; of one turn, it repeats in every turn",
        ),
    ] = None
    mean: Annotated[values.Inertia | None, Field(description="with harmonics: the mean inertia")] = None
    harmonics: Annotated[list[InertiaHarmonic] | None, Field(min_length=1, max_length=50)] = None

    @property
    def law(self) -> Law:
        return _law(self)


def _law(stated: Moment | Inertia) -> Law:
    mean = stated.mean or 0.0
    if stated.table is not None:
        return ByAngle.through(stated.table)
    if stated.harmonics is not None:
        return Harmonics(mean, tuple(stated.harmonics))
    return Constant(mean if stated.constant is None else stated.constant)


@dataclass(frozen=True)
class Areas:
    """Areas of a turning-moment diagram above (+) and below (−) the mean moment, in their order."""

    values: Annotated[list[Number], Field(min_length=2, max_length=100)]
    scale: Annotated[
        float,
        quantity("work", 1e-9),
        Field(description="work that a unit of area stands for", examples=["3141.6 J"]),
    ] = 1.0

    @property
    def works(self) -> list[float]:
        """Of the excess moment between its passages through zero, J."""
        return [area * self.scale for area in self.values]


@dataclass(frozen=True)
class Punch:
    """Working strokes at equal times; the motor's power is constant."""

    work: Annotated[float, quantity("work", 1e-9), Field(description="of a stroke", examples=["15 kJ"])]
    period: Annotated[Period, Field(description="from stroke to stroke", examples=["5 s"])]
    time: Annotated[Period, Field(description="that a stroke takes", examples=["2 s"])]


@dataclass(frozen=True)
class Motor:
    """The driving motor."""

    power: Annotated[float, quantity("power", 1e-9), Field(description="nominal", examples=["5.5 kW"])]
    speed: Annotated[Speed, Field(description="nominal", examples=["960 rpm"])]
    inertia: Annotated[values.Inertia, Field(description="of the rotor on its own shaft")] = 0.0
    efficiency: Annotated[Fraction, Field(description="of the transmission to the main link")] = 1.0


@dataclass(frozen=True)
class Wheel:
    """A flywheel that is there: its moment of inertia, or mass and radius of gyration."""

    inertia: PositiveInertia | None = None
    mass: PositiveMass | None = None
    radius_of_gyration: Positive | None = None


@dataclass(frozen=True)
class Disc:
    """A solid disc."""

    width: Annotated[Scale, Field(description="b/D")] = 0.2
    diameter: Annotated[Positive | None, Field(description="stated, the width follows")] = None


@dataclass(frozen=True)
class Rim:
    """A rim of rectangular section on spokes."""

    height: Annotated[Fraction, Field(description="h/D, of the mean diameter")] = 0.1
    width: Annotated[Scale, Field(description="b/h")] = 1.5
    diameter: Annotated[Positive | None, Field(description="mean; stated, the height follows")] = None
    spokes: Annotated[
        float,
        quantity("number", 0.0, 0.9, "0 … 0.9"),
        Field(description="part of the moment of inertia that is in spokes and hub"),
    ] = 0.1


@dataclass(frozen=True)
class Gyration:
    """Of the wheel only its radius of gyration is known, m: the mass follows."""

    radius: float


Shape = Disc | Rim | Gyration


@dataclass(frozen=True)
class Material:
    """Of the wheel, by its numbers."""

    NOT_STATED: ClassVar = ("name",)

    density: Density
    speed: Annotated[
        Annotated[float, quantity("velocity", 1e-3)] | None,
        Field(description="allowed at the rim", examples=["35 m/s"]),
    ] = None
    stress: Annotated[
        Annotated[float, quantity("pressure", 1.0)] | None,
        Field(description="allowed in the rim, in place of the speed", examples=["6 MPa"]),
    ] = None
    name: str = ""

    def __post_init__(self) -> None:
        if (self.speed is None) == (self.stress is None):
            wrong = Message(N_("of the material its density is stated, and what its rim may bear"))
            raise WrongValue(wrong, Message(N_("exactly one of: %(words)s"), {"words": "speed, stress"}))


MATERIALS = {
    one.name: one
    for one in (Material(7200.0, 35.0, name=N_("cast iron")), Material(7850.0, 70.0, name=N_("steel")))
}

USUAL: dict[str, tuple[float, float]] = {  # kind of machine -> usual δ, from fine to coarse
    N_("AC generator"): (1 / 300, 1 / 200),
    N_("DC generator"): (1 / 200, 1 / 100),
    N_("internal combustion engine"): (1 / 100, 1 / 80),
    N_("piston compressor"): (1 / 100, 1 / 50),
    N_("machine tool"): (1 / 50, 1 / 20),
    N_("pump"): (1 / 30, 1 / 5),
    N_("crusher"): (1 / 20, 1 / 5),
}


@dataclass(frozen=True)
class Flywheel:
    """A flywheel for a wanted unevenness. Beside a lever mechanism loads, inertia and speed are the mechanism's."""

    machine: Annotated[
        Literal[tuple(USUAL)] | None,  # type: ignore[valid-type]
        Field(description="kind of machine, whose usual unevenness is told"),
    ] = None
    delta: Annotated[
        Annotated[float, Reads(_delta, _FRACTION)] | None,
        Field(description="coefficient of speed fluctuation", examples=["1/30"]),
    ] = None
    speeds: Annotated[
        tuple[Speed, Speed] | None,
        Field(description="least and greatest speed, in place of delta", examples=["[200 rpm, 225 rpm]"]),
    ] = None
    wheel: Annotated[Wheel | None, Field(description="in place of delta: what unevenness it leaves")] = None
    speed: Annotated[Speed | None, Field(description="mean speed of the main link", examples=["200 rpm"])] = (
        None
    )
    motor: Motor | None = None
    turns: Annotated[
        Annotated[int, whole(1, 24)] | None, Field(description="turns of a cycle; left out, one")
    ] = None
    driving: Annotated[Moment | None, Field(description="left out, the constant that closes the cycle")] = (
        None
    )
    resisting: Annotated[Moment | None, Field(description="left out, the constant that closes the cycle")] = (
        None
    )
    areas: Annotated[Areas | None, Field(description="in place of the moments")] = None
    punch: Annotated[Punch | None, Field(description="in place of the moments")] = None
    inertia: Annotated[Inertia | None, Field(description="of the machine without the flywheel")] = None
    own: Annotated[
        values.Inertia,
        Field(description="of what turns with the main link and is not in the mechanism's masses"),
    ] = 0.0
    shaft: Annotated[Literal["main", "motor"], Field(description="that carries the flywheel")] = "main"
    ratio: Annotated[
        Scale | None, Field(description="speed of the flywheel's shaft to that of the main link")
    ] = None
    disc: Disc | None = None
    rim: Rim | None = None
    radius_of_gyration: Annotated[
        Positive | None, Field(description="in place of disc or rim: gives the mass")
    ] = None
    material: Annotated[
        Annotated[Literal["cast iron", "steel"], Tag(SCALAR)] | Annotated[Material, Tag(MAP)],
        by_shape(N_("cast iron, steel, or {density: 7200 kg/m^3, speed: 30 m/s}")),
    ] = "steel"
    positions: Annotated[
        Annotated[int, whole(8, 72)] | None,
        Field(description="of the table over the cycle; left out, 24"),
    ] = None
    friction: Annotated[
        Flag | None,
        Field(description="false: the friction of the mechanism's pairs is left out of the resistances"),
    ] = None
    methods: Annotated[
        list[Literal["mertsalov", "wittenbauer", "rerikh"]] | None,
        Field(
            min_length=1,
            description="that the text works out, beside the exact value; left out, mertsalov",
            examples=["[wittenbauer]"],
        ),
    ] = None

    @property
    def usual(self) -> tuple[float, float] | None:
        """The unevenness usual for machines of the kind."""
        return USUAL.get(self.machine) if self.machine else None

    @property
    def varying(self) -> Law:
        """The machine's moment of inertia over the cycle as it is stated, kg m²."""
        return self.inertia.law if self.inertia else Constant(0.0)

    @property
    def fixed(self) -> float:
        """The constant moment of inertia that is stated of what turns with the main link, kg m²."""
        return self.own + (self.varying.amount if isinstance(self.varying, Constant) else 0.0)

    @property
    def chosen(self) -> dict[str, bool]:
        """Of each method whether the text works it out; the others stand where the note has what few want."""
        return {
            name: name in (self.methods or ["mertsalov"]) for name in ("mertsalov", "wittenbauer", "rerikh")
        }

    @property
    def shape(self) -> Shape:
        if self.radius_of_gyration is not None:
            return Gyration(self.radius_of_gyration)
        return self.rim or self.disc or Disc()

    @property
    def metal(self) -> Material:
        """What the wheel is made of."""
        return self.material if isinstance(self.material, Material) else MATERIALS[self.material]


Given = Flywheel
