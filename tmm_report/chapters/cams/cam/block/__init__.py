"""The block `cam` of a variant, a cam that stands alone; and what is stated alike of any cam."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.cams.cam.block.alone import DRIVE, CamAloneModel
from tmm_report.chapters.cams.cam.given import Forces, Given
from tmm_report.problems import N_, Message, Problem, doubt, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """A cam that stands alone."""

    ALONE = True

    cam: CamAloneModel | None = Field(default=None, description="a cam with its follower, standing alone")


class Taken(TypedDict):
    cam: Given | None
    cam_forces: Forces | None


def given(read: Read) -> Taken:
    from tmm_report.chapters.cams.cam.block.build import built
    from tmm_report.chapters.cams.cam.block.forces import built_forces

    stated = read.block(Block).cam
    if stated is None:
        return {"cam": None, "cam_forces": None}
    own = built(stated, read.says(("cam", "speed"), DRIVE))
    return {"cam": own, "cam_forces": built_forces(stated, own) if stated.loaded else None}


def mistakes(read: Read) -> Iterator[Problem]:
    from tmm_report.chapters.cams.cam.block.build import tried
    from tmm_report.chapters.cams.cam.block.forces import wrong as wrong_forces

    stated = read.block(Block).cam
    if stated is not None and not read.is_broken("cam"):
        if stated.driven and "drive" not in read.data:
            wrong = N_("speed: drive takes the speed of the drive's output shaft, and there is no drive")
            yield mistake(
                wrong, ("cam", "speed"), Message(N_("state the block drive, or the speed: 100 rpm"))
            )
        own, found = tried(stated)
        yield from found
        if stated.loaded and own is not None and not found:
            yield from wrong_forces(stated, own)


def doubts(read: Read) -> Iterator[Problem]:
    stated = read.block(Block).cam
    if stated is None or not stated.loaded or read.is_broken("cam"):
        return
    if stated.follower is None and stated.roller is None:
        text = N_("how the follower touches the cam is not stated: a knife edge is taken")
        yield doubt(text, ("cam",), Message(N_("roller: 10 mm, or follower: knife, or follower: flat")))
    if stated.sought and stated.base is None:
        text = N_("no base circle is stated: the smallest by the permitted pressure angle is taken")
        yield doubt(text, ("cam",), Message(N_("base: 40 mm, or base: smallest")))
