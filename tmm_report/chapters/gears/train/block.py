"""The block of a compound gear train."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.gears.train.given import GearTrain
from tmm_report.chapters.gears.train.solve.mistakes import mistakes_of
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated


class Block(model.Block):
    """A gear train of any scheme."""

    ALONE = True

    train: Stated[GearTrain] | None = Field(default=None, description="a gear train of any scheme")


class Given(TypedDict):
    train: GearTrain | None


def given(read: Read) -> Given:
    return {"train": read.block(Block).train}


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).train
    if written is not None:
        yield from mistakes_of(written)
