"""The block `readings` of a variant: a student's own numbers."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.kinematics.block import beyond_the_table
from tmm_report.chapters.lever.readings.given import Readings
from tmm_report.chapters.lever.structure.block import stated, without
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.values import PositionKey, Reading, ReadingKey


class Block(model.Block):
    """A student's own numbers."""

    readings: dict[PositionKey, dict[ReadingKey, Reading]] = Field(
        default={},
        description="a student's own numbers: position -> quantity -> number, with its unit or in SI",
    )


class Given(TypedDict):
    readings: Readings


def given(read: Read) -> Given:
    written = read.block(Block).readings
    return {"readings": {int(position): numbers for position, numbers in written.items()}}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "readings")
        return
    for position in read.block(Block).readings:
        yield from beyond_the_table(int(position), ("readings", position), read)
