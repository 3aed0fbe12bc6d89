"""The keys of a motor and of a resistance in the block `dynamics`, and the characteristics that they state."""

from typing import Annotated, Any

from pydantic import Field, model_validator

from tmm_report.chapters.machine.dynamics.given import Motor, Resistance
from tmm_report.mechanics.calculus.laws import ByAngle, BySpeed, ByTime, Constant
from tmm_report.mechanics.machine import characteristics as ch
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.language import CalledBy
from tmm_report.variant.model import Model, one_of
from tmm_report.variant.values import (
    AngleMoments,
    Fraction,
    MomentValue,
    Scale,
    Speed,
    Time,
    TorsionalDamping,
    quantity,
)

PositiveMoment = Annotated[float, quantity("moment", 1e-12)]
PositivePower = Annotated[float, quantity("power", 1e-12)]
StatorShare = Annotated[float, quantity("number", 0.0, 10.0, "0 … 10")]
FromRest = Annotated[float, quantity("speed", 0.0)]
Curve = (Field(min_length=2, max_length=1000),)
SpeedMoments = Annotated[list[tuple[FromRest, MomentValue]], *Curve]
TimeMoments = Annotated[list[tuple[Time, MomentValue]], *Curve]


def _complete(model: Any, *sets: tuple[str, ...]) -> tuple[str, ...]:
    """The set of keys that is stated whole, and alone. Raises WrongValue."""
    stated = {name for name in type(model).model_fields if getattr(model, name) is not None}
    for names in sets:
        if set(names) <= stated and stated <= set(names) | {"stator"}:
            return names
    words = "; ".join(", ".join(names) for names in sets)
    right = Message(N_("state one of these sets of keys: %(words)s"), {"words": words})
    raise WrongValue(Message(N_("these keys do not state the characteristic")), right)


class ShuntModel(Model):
    """A shunt or separately excited motor: a straight line."""

    moment: PositiveMoment | None = Field(default=None, description="nominal")
    power: PositivePower | None = Field(default=None, description="nominal, in place of the moment")
    speed: Speed | None = Field(default=None, description="nominal", examples=["1430 rpm"])
    no_load: Speed | None = Field(default=None, description="speed without a load", examples=["1500 rpm"])
    voltage: Scale | None = Field(default=None, description="V")
    resistance: Scale | None = Field(default=None, description="of the armature circuit, ohm")
    constant: Scale | None = Field(default=None, description="moment by current, N m/A")

    @model_validator(mode="after")
    def whole(self) -> Any:
        self.law()
        return self

    def law(self) -> ch.Linear:
        circuit = ("voltage", "resistance", "constant")
        of = _complete(self, ("moment", "speed", "no_load"), ("power", "speed", "no_load"), circuit)
        if of == circuit:
            return ch.shunt_of_circuit(self.voltage or 0.0, self.resistance or 0.0, self.constant or 0.0)
        speed, no_load = self.speed or 0.0, self.no_load or 0.0
        _slower(speed, no_load)
        return ch.shunt(_nominal(self), speed, no_load)


class SeriesModel(Model):
    """A series-wound motor without saturation: M = a/(ω + b)²."""

    moment: PositiveMoment | None = Field(default=None, description="nominal")
    power: PositivePower | None = Field(default=None, description="nominal, in place of the moment")
    speed: Speed | None = Field(default=None, description="nominal", examples=["800 rpm"])
    stall: PositiveMoment | None = Field(default=None, description="moment at rest")
    voltage: Scale | None = Field(default=None, description="V")
    resistance: Scale | None = Field(default=None, description="of the circuit, ohm")
    constant: Scale | None = Field(default=None, description="moment by the square of the current, N m/A²")

    @model_validator(mode="after")
    def whole(self) -> Any:
        self.law()
        return self

    def law(self) -> ch.Series:
        circuit = ("voltage", "resistance", "constant")
        of = _complete(self, ("moment", "speed", "stall"), ("power", "speed", "stall"), circuit)
        if of == circuit:
            return ch.series_of_circuit(self.voltage or 0.0, self.resistance or 0.0, self.constant or 0.0)
        nominal, stall = _nominal(self), self.stall or 0.0
        if stall <= nominal:
            text = N_("the moment at rest is not greater than the nominal one")
            raise WrongValue(
                Message(text), Message(N_("the moment of a series-wound motor falls with speed"))
            )
        return ch.series(nominal, self.speed or 0.0, stall)


class InductionModel(Model):
    """An induction motor by Kloss's formula."""

    synchronous: Speed | None = Field(default=None, description="synchronous speed", examples=["1500 rpm"])
    moment: PositiveMoment | None = Field(default=None, description="nominal")
    power: PositivePower | None = Field(default=None, description="nominal, in place of the moment")
    speed: Speed | None = Field(default=None, description="nominal", examples=["1430 rpm"])
    overload: Scale | None = Field(default=None, description="greatest moment by the nominal one")
    max_moment: PositiveMoment | None = Field(default=None, description="greatest moment")
    critical_slip: Scale | None = Field(default=None, description="slip at which it is reached")
    stator: StatorShare | None = Field(
        default=None,
        description="ratio of the resistance of the stator to that of the rotor; left out, 0: simplified",
    )

    @model_validator(mode="after")
    def whole(self) -> Any:
        self.law()
        return self

    def law(self) -> ch.Kloss:
        direct = ("synchronous", "max_moment", "critical_slip")
        plate = ("synchronous", "speed", "overload")
        of = _complete(self, direct, ("moment", *plate), ("power", *plate))
        synchronous, a = self.synchronous or 0.0, self.stator or 0.0
        if of == direct:
            return ch.Kloss(synchronous, self.max_moment or 0.0, self.critical_slip or 0.0, a)
        speed, overload = self.speed or 0.0, self.overload or 0.0
        _slower(speed, synchronous)
        if overload <= 1:
            wrong = Message(N_("the greatest moment is not greater than the nominal one"))
            raise WrongValue(wrong, Message(N_("an overload of 1.7 to 3 is usual")))
        try:
            return ch.kloss(_nominal(self), speed, synchronous, overload, a)
        except ArithmeticError:
            wrong = Message(
                N_("with this resistance of the stator no motor has this overload at this nominal slip")
            )
            raise WrongValue(
                wrong, Message(N_("a smaller resistance of the stator, or leave it out"))
            ) from None


def _nominal(model: Any) -> float:
    return float(model.moment if model.moment is not None else model.power / model.speed)


def _slower(speed: float, no_load: float) -> None:
    if speed >= no_load:
        wrong = Message(N_("the nominal speed is not below the speed without a load"))
        raise WrongValue(wrong, Message(N_("a motor turns slower under its load")))


MOTORS = ("constant", "shunt", "series", "induction", "by_speed", "by_angle", "by_time")


class MotorModel(Model):
    """The motor."""

    constant: MomentValue | None = None
    shunt: ShuntModel | None = None
    series: SeriesModel | None = None
    induction: InductionModel | None = None
    by_speed: SpeedMoments | None = Field(default=None, description="[[speed, moment], …]")
    by_angle: AngleMoments | None = Field(default=None, description="[[angle of the main shaft, moment], …]")
    by_time: TimeMoments | None = Field(default=None, description="[[time, moment], …]")
    ratio: Scale = Field(default=1.0, description="speed of the motor by that of the main shaft")
    efficiency: Fraction = Field(default=1.0, description="of the gear between them")

    @model_validator(mode="after")
    def one(self) -> Any:
        return one_of(self, MOTORS, N_("the motor must be stated by one characteristic"))


class FanModel(Model):
    """A moment that grows with the square of the speed."""

    moment: PositiveMoment
    speed: Speed = Field(description="at which it has this moment")


RESISTANCES = ("friction", "viscous", "fan", "by_speed", "by_angle", "by_time")


class ResistanceModel(Model):
    """A moment against the rotation of the main shaft."""

    name: CalledBy | None = None
    friction: PositiveMoment | None = Field(default=None, description="constant: dry friction, or a load")
    viscous: TorsionalDamping | None = Field(default=None, description="moment by speed")
    fan: FanModel | None = None
    by_speed: SpeedMoments | None = Field(default=None, description="[[speed, moment], …]")
    by_angle: AngleMoments | None = Field(default=None, description="[[angle, moment], …]")
    by_time: TimeMoments | None = Field(default=None, description="[[time, moment], …]")

    @model_validator(mode="after")
    def one(self) -> Any:
        return one_of(self, RESISTANCES, N_("the resistance must be stated by one law"))


# ---------------------------------------------------------------- what they state


def motor(written: MotorModel, period: float) -> Motor:
    kind = next(name for name in MOTORS if getattr(written, name) is not None)
    own = _law(written, kind, period)
    plain = written.ratio == 1 and written.efficiency == 1
    law = own if plain else ch.Geared(own, written.ratio, written.efficiency)
    return Motor(kind, own, law, written.ratio, written.efficiency)


def resistance(written: ResistanceModel, period: float) -> Resistance:
    kind = next(name for name in RESISTANCES if getattr(written, name) is not None)
    return Resistance(kind, _law(written, kind, period), written.name or "")


def _law(written: MotorModel | ResistanceModel, kind: str, period: float) -> ch.Characteristic:
    stated = getattr(written, kind)
    match kind:
        case "constant" | "friction":
            return Constant(stated)
        case "viscous":
            return ch.Power(stated, 1.0)
        case "fan":
            return ch.Power(stated.moment, stated.speed, 2)
        case "by_speed" | "by_time" | "by_angle":
            x, y = (tuple(float(one) for one in row) for row in zip(*stated, strict=True))
            if kind == "by_angle":
                return ByAngle(x, y, period)
            return (BySpeed if kind == "by_speed" else ByTime)(x, y)
    found: ch.Characteristic = stated.law()
    return found
