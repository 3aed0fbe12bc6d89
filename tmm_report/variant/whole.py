"""The whole format: the lever mechanism's blocks and those of the gears; loaded only where there are gears."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from tmm_report.variant import gears
from tmm_report.variant.gears import DriveModel, eccentric
from tmm_report.variant.gears.eccentric import EccentricModel
from tmm_report.variant.models import LeverModel


class VariantModel(LeverModel):
    """A variant of a course project: a lever mechanism, a gear drive, an eccentric mechanism, or several of them."""

    drive: DriveModel | None = Field(default=None, description="a gear drive")
    eccentric: EccentricModel | None = Field(default=None, description="an eccentric epicyclic mechanism")


def gears_of(model: Any) -> dict[str, Any]:
    """The gear chapters' Given, in SI, by the names of the fields of `course.Variant`."""
    assert isinstance(model, VariantModel)
    accuracy = model.drawing.accuracy
    return {
        "drive": gears.build(model.drive, accuracy) if model.drive else None,
        "eccentric": eccentric.build(model.eccentric) if model.eccentric else None,
    }
