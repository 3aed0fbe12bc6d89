"""What a drive states of its machine, of the motors to choose from and of the losses beside those of the stages."""

from __future__ import annotations

import math
from dataclasses import field
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple

from tmm_report.problems import N_, Message
from tmm_report.quantity import units
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass

if TYPE_CHECKING:
    from pydantic import Field

    from tmm_report.variant.values import (
        Efficiency,
        Number,
        Reads,
        Span,
        quantity,
        whole,
    )

GRAVITY = 9.81  # m/s², of a load that is stated by its mass
BOUND = 1e-9


class Rate(NamedTuple):
    """How fast the machine works: m/s where it is `linear`, else rad/s; None of a bare number."""

    value: float
    linear: bool | None


def _rate(written: Any) -> Rate:
    """m/s, or rad/s and rpm."""
    if isinstance(written, int | float) and not isinstance(written, bool):
        return Rate(_above(units.parse(written, "number"), written), None)
    try:
        return Rate(_above(units.parse(written, "speed"), written), False)
    except WrongValue as error:
        try:
            return Rate(_above(units.parse(written, "velocity"), written), True)
        except WrongValue:
            raise error from None


def _load(written: Any) -> float:
    """N; of a mass its weight."""
    try:
        return _above(units.parse(written, "force"), written)
    except WrongValue as error:
        try:
            return GRAVITY * _above(units.parse(written, "mass"), written)
        except WrongValue:
            raise error from None


def _above(number: float, written: Any) -> float:
    if BOUND <= number <= 1e12:
        return number
    wrong = Message(N_("%(value)s is not more than zero"), {"value": str(written)[:40]})
    raise WrongValue(wrong, Message(N_("a number greater than zero, its sense is that of the drive")))


RATE = {"type": ["number", "string"], "description": "m/s, or rpm or rad/s", "x-unit": "m/s, rad/s"}
LOAD = {"type": ["number", "string"], "description": "a force, or a mass whose weight it is", "x-unit": "N"}


@dataclass(frozen=True)
class Machine:
    """What the output shaft turns: its load and how fast it works. Either may be left out where the motor says it."""

    force: Annotated[
        Annotated[float, Reads(_load, LOAD)] | None,
        Field(description="circumferential force, pull of the belt, chain or rope", examples=["3.2 kN"]),
    ] = None
    torque: Annotated[float, quantity("moment", 1e-9)] | None = None
    power: Annotated[float, quantity("power", 1e-9)] | None = None
    speed: Annotated[
        Annotated[Any, Reads(_rate, RATE)] | None,
        Field(description="of the belt, chain or rope, or of the shaft", examples=["0.85 m/s", "45 rpm"]),
    ] = None
    diameter: Annotated[
        Span | None, Field(description="of the drum, pulley or sprocket", examples=["315 mm"])
    ] = None
    teeth: Annotated[
        Annotated[int, whole(3, 200)] | None, Field(description="of a sprocket, with its pitch")
    ] = None
    pitch: Annotated[Span | None, Field(description="of the chain on the sprocket")] = None
    efficiency: Annotated[
        Efficiency, Field(description="of the working member itself: the drum, the chain on its sprocket")
    ] = 1.0

    def __post_init__(self) -> None:
        loads = [key for key in ("force", "torque", "power") if getattr(self, key) is not None]
        if len(loads) > 1:
            wrong = Message(N_("the load is stated twice: %(keys)s"), {"keys": ", ".join(loads)})
            raise WrongValue(
                wrong, Message(N_("exactly one of: %(words)s"), {"words": "force, torque, power"})
            )
        if (self.teeth is None) != (self.pitch is None) or (self.teeth and self.diameter):
            wrong = Message(N_("a sprocket has teeth and a pitch, a drum has a diameter"))
            raise WrongValue(wrong, Message(N_("diameter: 315 mm, or teeth: 9 and pitch: 80 mm")))
        rate = self.speed
        linear = rate is not None and (rate.linear or (rate.linear is None and self.radius is not None))
        if self.radius is None and (self.force is not None or linear):
            wrong = Message(
                N_("the diameter of the drum is not stated, so the speed of its shaft is not known")
            )
            if self.force is not None and not linear:
                wrong = Message(
                    N_("the diameter of the drum is not stated, so the torque on its shaft is not known")
                )
            raise WrongValue(wrong, Message(N_("diameter: 315 mm, or teeth: 9 and pitch: 80 mm")))
        if rate is not None:
            object.__setattr__(self, "speed", Rate(rate.value, linear))

    @property
    def radius(self) -> float | None:
        """At which the force pulls, m: of a sprocket that of its z pitches laid round, t z/2π."""
        if self.diameter is not None:
            return self.diameter / 2
        return None if self.teeth is None or self.pitch is None else self.teeth * self.pitch / (2 * math.pi)

    @property
    def omega(self) -> float | None:
        """Of its shaft as it is wanted, rad/s."""
        if self.speed is None:
            return None
        value, linear = self.speed
        return float(value / self.radius if linear and self.radius else value)

    @property
    def loaded(self) -> bool:
        return not self.force is self.torque is self.power is None


@dataclass(frozen=True)
class Bearings:
    """Pairs of bearings of the shafts."""

    efficiency: Annotated[Efficiency, Field(description="of one pair", examples=[0.99])]
    pairs: Annotated[
        Annotated[tuple[Annotated[int, whole(0, 6)], ...], Field(min_length=2, max_length=18)] | None,
        Field(description="of every shaft, the motor's first; left out, one of each but the motor's"),
    ] = None


@dataclass(frozen=True)
class Coupling:
    """Couplings, all of one kind."""

    efficiency: Annotated[Efficiency, Field(examples=[0.98])]
    after: Annotated[
        Annotated[tuple[Annotated[int, whole(0, 8)], ...], Field(min_length=1, max_length=9)] | None,
        Field(
            description="behind which stages they stand, 0: behind the motor; left out, behind the motor, or behind "
            "the last stage where a belt or a chain is on the motor's shaft",
            examples=["[0, 2]"],
        ),
    ] = None


@dataclass(frozen=True)
class Split:
    """How the ratio is divided among the stages that have none."""

    slow: Annotated[
        Number | None, Field(description="of two: u of the slow one is so many √u", examples=[0.88])
    ] = None
    fast: Annotated[
        Number | None, Field(description="of two: u of the fast one is so many √u", examples=[1.2])
    ] = None
    step: Annotated[
        Number | None, Field(description="u of each is so many times that of the next", examples=[1.25])
    ] = None

    def __post_init__(self) -> None:
        stated = [one for one in (self.slow, self.fast, self.step) if one is not None]
        if len(stated) != 1:
            wrong = Message(N_("one rule divides the ratio"))
            raise WrongValue(wrong, Message(N_("exactly one of: %(words)s"), {"words": "slow, fast, step"}))
        if not 0.05 <= stated[0] <= 20:
            wrong = Message(
                N_("%(value)s is out of range: from 0.05 to 20 is expected"), {"value": f"{stated[0]:g}"}
            )
            raise WrongValue(wrong)


@dataclass(frozen=True)
class Shafts:
    """How the table of the shafts is printed."""

    by: Annotated[
        Literal["required", "rated"],
        Field(description="powers from that which is needed, or from the motor's own"),
    ] = "required"
    torque: Annotated[
        Literal["exact", 9550], Field(description="T = P/ω, or T = 9550 P/n with the rounded factor")
    ] = "exact"
    at: Annotated[
        Literal["after bearings", "before bearings"],
        Field(
            description="where the power of a shaft is: behind its own bearings, or as its wheel receives it"
        ),
    ] = "after bearings"


class Motor(NamedTuple):
    """A motor of the list: W, rad/s."""

    name: str
    power: float
    speed: float


@dataclass(frozen=True)
class Given:
    """The drive's power side. `machine`: None where it is the driving link; `peak`: of that link, whether the motor
    must have the greatest power; `motors`: none, one that is stated, or those to choose from."""

    machine: Machine | None = None
    motors: tuple[Motor, ...] = ()
    overload: float = 0.0
    range: tuple[float, float] | None = None
    bearings: Bearings = field(default_factory=lambda: Bearings(1.0))
    couplings: Coupling | None = None
    split: Split | None = None
    shafts: Shafts = field(default_factory=Shafts)
    peak: bool = False
