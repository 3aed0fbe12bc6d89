"""The blocks `drawing` and `readings` of a variant."""

from collections.abc import Iterator
from typing import Annotated, TypedDict

from pydantic import Field, Tag

from tmm_report.chapters.kinematics.block import beyond_the_table, undrawn
from tmm_report.chapters.plans.given import Drawing, Readings
from tmm_report.chapters.structure.block import stated, without
from tmm_report.problems import N_, Problem
from tmm_report.quantity.paper import ACCURACY
from tmm_report.variant import model
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    MAP,
    SCALAR,
    Accuracy,
    GroupName,
    Number,
    PositionKey,
    ReadingKey,
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
    """How the plans are drawn, and what a student read off them."""

    drawing: DrawingModel = Field(default_factory=DrawingModel)
    readings: dict[PositionKey, dict[ReadingKey, Number]] = Field(
        default={}, description="a student's own readings, SI: position -> symbol -> number"
    )


class Given(TypedDict):
    drawing: Drawing
    readings: Readings


def given(read: Read) -> Given:
    block = read.block(Block)
    scales = block.drawing.scales
    drawing = Drawing(
        block.drawing.accuracy, scales.length, scales.velocity, scales.acceleration, scales.force
    )
    return {
        "drawing": drawing,
        "readings": {int(position): symbols for position, symbols in block.readings.items()},
    }


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "readings")
        return
    yield from undrawn("plans", read)
    for position in read.block(Block).readings:
        yield from beyond_the_table(int(position), ("readings", position), read)
