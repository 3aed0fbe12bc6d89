"""The block `drawing` of a variant."""

from collections.abc import Iterator
from typing import Annotated, TypedDict

from pydantic import Field, Tag

from tmm_report.chapters.kinematics.block import undrawn
from tmm_report.chapters.plans.given import Drawing
from tmm_report.chapters.structure.block import stated
from tmm_report.problems import N_, Problem
from tmm_report.quantity.paper import ACCURACY
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    MAP,
    SCALAR,
    Accuracy,
    GroupName,
    Scale,
    by_shape,
)

ForceScale = Annotated[
    Annotated[Scale, Tag(SCALAR)] | Annotated[dict[GroupName, Scale], Tag(MAP)],
    by_shape(N_("a number, or a mapping: {2-3: 20}")),
]


class ScalesModel(Model):
    """Scales of the drawings, SI units per mm of paper."""

    length: Scale | None = None
    velocity: Scale | None = None
    acceleration: Scale | None = None
    force: ForceScale | None = Field(default=None, description="one for all, or by group: {2-3: 20}")


class DrawingModel(Model):
    """How the plans are drawn."""

    accuracy: Accuracy = Field(default=ACCURACY, description="lengths on paper are read to it")
    scales: ScalesModel = Field(default_factory=ScalesModel)


class Block(model.Block):
    """How the plans are drawn."""

    drawing: DrawingModel = Field(default_factory=DrawingModel)


class Given(TypedDict):
    drawing: Drawing


def given(read: Read) -> Given:
    block = read.block(Block)
    scales = block.drawing.scales
    drawing = Drawing(
        block.drawing.accuracy, scales.length, scales.velocity, scales.acceleration, scales.force
    )
    return {"drawing": drawing}


def mistakes(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from undrawn("plans", read)
