"""The block `cam` of a variant, a cam that stands alone; and what is stated alike of any cam."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.cams.cam.block.alone import CamAloneModel
from tmm_report.chapters.cams.cam.given import Given
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """A cam that stands alone."""

    ALONE = True

    cam: CamAloneModel | None = Field(default=None, description="a cam with its follower, standing alone")


class Taken(TypedDict):
    cam: Given | None


def given(read: Read) -> Taken:
    from tmm_report.chapters.cams.cam.block.build import built

    stated = read.block(Block).cam
    return {"cam": None if stated is None else built(stated)}


def mistakes(read: Read) -> Iterator[Problem]:
    from tmm_report.chapters.cams.cam.block.build import wrong

    stated = read.block(Block).cam
    if stated is not None and not read.is_broken("cam"):
        yield from wrong(stated)
