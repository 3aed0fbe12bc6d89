"""The block `drawing` of a variant."""

from collections.abc import Iterator
from typing import Annotated, TypedDict

from pydantic import ConfigDict, Field, Tag

from tmm_report.chapters.lever.kinematics.block import undrawn
from tmm_report.chapters.lever.plans.block import segments
from tmm_report.chapters.lever.plans.given import Drawing, Kind
from tmm_report.chapters.lever.structure.block import belongs, names, stated
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
    """How the plans are drawn. A scale is a number, or follows from a whole segment: OA: 50 mm, pa: 100 mm,
    pia: 120 mm, force: 200 mm."""

    model_config = ConfigDict(extra="allow")
    __pydantic_extra__: dict[str, segments.Written] = Field(init=False)

    accuracy: Accuracy = Field(default=ACCURACY, description="lengths on paper are read to it")
    scales: ScalesModel = Field(default_factory=ScalesModel)


class Block(model.Block):
    """How the plans are drawn."""

    drawing: DrawingModel = Field(default_factory=DrawingModel)


class Given(TypedDict):
    drawing: Drawing


def given(read: Read) -> Given:
    block = read.block(Block).drawing
    scales, chosen = block.scales, segments.segments(block.__pydantic_extra__ or {}, names(read.data).points)
    drawing = Drawing(
        block.accuracy, scales.length, scales.velocity, scales.acceleration, scales.force, chosen
    )
    return {"drawing": drawing}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        return
    yield from undrawn("plans", read)
    block = read.block(Block).drawing
    kinds: tuple[Kind, ...] = ("length", "velocity", "acceleration", "force")
    scales = {kind for kind in kinds if getattr(block.scales, kind) is not None}
    others = list(DrawingModel.model_fields)
    yield from segments.mistakes(block.__pydantic_extra__ or {}, names(read.data).points, scales, others)


def doubts(read: Read) -> Iterator[Problem]:
    yield from belongs(read, "drawing")
