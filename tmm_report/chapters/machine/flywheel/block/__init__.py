"""The block `flywheel` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import stated
from tmm_report.chapters.machine.flywheel.block.build import built
from tmm_report.chapters.machine.flywheel.block.checks import check
from tmm_report.chapters.machine.flywheel.block.models import FlywheelModel
from tmm_report.chapters.machine.flywheel.given import Given as Stated
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """The flywheel."""

    ALONE = True

    flywheel: FlywheelModel | None = Field(default=None, description="the flywheel of the machine")


class Given(TypedDict):
    flywheel: Stated | None


def given(read: Read) -> Given:
    written = read.block(Block).flywheel
    return {"flywheel": built(written) if written else None}


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).flywheel
    if written is not None:
        yield from check(written, stated(read), read)
