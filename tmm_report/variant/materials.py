"""A coefficient of friction as a variant states it: a number, a law of the sliding, or the materials of the pair."""

from itertools import pairwise
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Field, Tag, model_validator

from tmm_report.mechanics.pairs.coefficients import BySliding, Rubs, Stribeck
from tmm_report.mechanics.pairs.materials import Stock, mean, stated
from tmm_report.problems import N_, Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import (
    MAP,
    SCALAR,
    Coefficient,
    Label,
    UnsignedVelocity,
    by_shape,
    quantity,
    whole,
)


def _faster(points: Any) -> Any:
    if any(one >= other for (one, _), (other, _) in pairwise(points)):
        wrong = Message(N_("the velocities of sliding must ascend, each greater than the one before"))
        raise WrongValue(wrong, Message(N_("[[0, 0.15], [0.5 m/s, 0.1]]")))
    return points


Points = Annotated[
    list[tuple[UnsignedVelocity, Coefficient]], Field(min_length=2, max_length=100), AfterValidator(_faster)
]


class StribeckModel(Model):
    """Stribeck's law: the coefficient falls from rest to motion; with a viscous part it grows again."""

    static: Coefficient = Field(description="at rest", examples=[0.15])
    kinetic: Coefficient = Field(description="that it nears in motion", examples=[0.08])
    speed: Annotated[float, quantity("velocity", 1e-9)] = Field(
        description="of sliding, by which it falls", examples=["0.1 m/s"]
    )
    viscous: Annotated[float, quantity("slowness", 0.0)] = Field(
        default=0.0, description="by which it grows with the velocity of sliding"
    )
    exponent: Annotated[int, whole(1, 2)] = Field(default=1, description="of the velocity, 1 or 2")

    @model_validator(mode="after")
    def falls(self) -> "StribeckModel":
        if self.static < self.kinetic:
            wrong = Message(N_("the coefficient at rest is less than that in motion"))
            raise WrongValue(wrong, Message(N_("exchange static and kinetic")))
        return self


class SpeedModel(Model):
    """A coefficient of friction that changes with the velocity of sliding."""

    by_speed: Points | None = Field(
        default=None, description="[[velocity, coefficient], …]", examples=[[[0, 0.15], ["0.5 m/s", 0.1]]]
    )
    stribeck: StribeckModel | None = None

    @model_validator(mode="after")
    def one(self) -> "SpeedModel":
        if (self.by_speed is None) == (self.stribeck is None):
            wrong = Message(N_("the coefficient must be stated by one law of the sliding"))
            raise WrongValue(wrong, Message(N_("exactly one of: %(words)s"), {"words": "by_speed, stribeck"}))
        return self

    @property
    def law(self) -> Rubs:
        of = self.stribeck
        if of is not None:
            return Stribeck(of.static, of.kinetic, of.speed, of.viscous, of.exponent)
        speeds, values = zip(*self.by_speed or (), strict=True)
        return BySliding(speeds, values)


Stated = Annotated[
    Annotated[Coefficient, Tag(SCALAR)] | Annotated[SpeedModel, Tag(MAP)],
    by_shape(
        N_("a number, {by_speed: [[velocity, coefficient], …]} or {stribeck: {static, kinetic, speed}}")
    ),
]


class Rubbed(Model):
    """A coefficient of friction, or two materials of the table."""

    coefficient: Stated | None = Field(default=None, examples=[0.1])
    materials: Label | None = Field(
        default=None, description="two of steel, cast iron, bronze", examples=["steel–bronze"]
    )
    lubrication: Literal["dry", "semi-fluid"] = Field(
        default="dry", description="which column of the table of materials"
    )
    state: Literal["moving", "rest"] = Field(
        default="moving", description="the coefficient of motion or of rest from the table"
    )

    @model_validator(mode="after")
    def one_coefficient(self) -> "Rubbed":
        """Raises WrongValue for what `stated` finds wrong."""
        if isinstance(self._found, tuple):
            raise WrongValue(*self._found)
        return self

    @property
    def _found(self) -> float | Stock | tuple[Message, Message]:
        coefficient = 0.0 if isinstance(self.coefficient, SpeedModel) else self.coefficient
        return stated(coefficient, self.materials, self.lubrication, self.state)

    @property
    def of(self) -> Stock | None:
        """The materials, where they are stated."""
        return self._found if isinstance(self._found, Stock) else None

    @property
    def f(self) -> float | Rubs:
        """The coefficient: stated, as a number or a law, or the middle of the table's range."""
        if self.of is not None and self.of.range is not None:
            return mean(self.of.range)
        if isinstance(self.coefficient, SpeedModel):
            return self.coefficient.law
        return float(self.coefficient or 0.0)
