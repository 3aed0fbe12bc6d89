"""A coefficient of friction as a variant states it: a number, or the materials of the pair."""

from typing import Literal

from pydantic import Field, model_validator

from tmm_report.mechanics.pairs.materials import Stock, mean, stated
from tmm_report.problems import Message
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.model import Model
from tmm_report.variant.values import Coefficient, Label


class Rubbed(Model):
    """A coefficient of friction, or two materials of the table."""

    coefficient: Coefficient | None = Field(default=None, examples=[0.1])
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
        return stated(self.coefficient, self.materials, self.lubrication, self.state)

    @property
    def of(self) -> Stock | None:
        """The materials, where they are stated."""
        return self._found if isinstance(self._found, Stock) else None

    @property
    def f(self) -> float:
        """The coefficient: stated, or the middle of the table's range."""
        if self.of is not None and self.of.range is not None:
            return mean(self.of.range)
        return float(self.coefficient or 0.0)
