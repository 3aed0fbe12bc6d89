"""A coefficient of friction as a variant states it: a number, or the materials of the pair."""

from typing import Literal

from pydantic import Field, model_validator

from tmm_report.mechanics.pairs.materials import Stock, mean, stock
from tmm_report.problems import N_, Message
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
        """Raises WrongValue for none and for both, for unknown materials, for a dash of the table."""
        if (self.coefficient is None) == (self.materials is None):
            wrong = Message(N_("the friction must be stated by its coefficient or by the materials"))
            raise WrongValue(
                wrong, Message(N_("exactly one of: %(words)s"), {"words": "coefficient, materials"})
            )
        if self.materials is not None:
            found = stock(self.materials, self.lubrication, self.state)
            if isinstance(found, tuple):
                raise WrongValue(*found)
        return self

    @property
    def of(self) -> Stock | None:
        """The materials, where they are stated."""
        if self.materials is None:
            return None
        found = stock(self.materials, self.lubrication, self.state)
        return found if isinstance(found, Stock) else None

    @property
    def f(self) -> float:
        """The coefficient: stated, or the middle of the table's range."""
        if self.of is not None and self.of.range is not None:
            return mean(self.of.range)
        return float(self.coefficient or 0.0)
