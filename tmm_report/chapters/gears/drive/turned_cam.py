"""A cam that stands alone with the speed and the sense of the drive's output shaft, where it says `speed: drive`."""

from __future__ import annotations

import math
from dataclasses import replace

from tmm_report.chapters.cams.cam import block as cam
from tmm_report.chapters.gears.drive import solve as drive
from tmm_report.chapters.gears.drive.block import SLOWEST, Block, given
from tmm_report.problems import N_, Message, ProblemError, mistake
from tmm_report.variant.model import Read

SPEED = ("cam", "speed")
STATE = Message(N_("state the speed of the cam"))


def geared(read: Read) -> Read:
    """The blocks with the output's speed in the place of `speed: drive` of the cam. Raises ProblemError."""
    stated, model = read.block(cam.Block).cam, read.block(Block).drive
    found = given(read)["drive"]
    if stated is None or not stated.driven or model is None or found is None:
        return read
    if not math.isfinite(found.speed) or any(getattr(stage, "open", False) for stage in model.stages):
        wrong = N_(
            "the motor or the stages of the drive are chosen only when it is solved: the cam has no speed yet"
        )
        raise ProblemError([mistake(wrong, SPEED, STATE)])
    speed = drive.output_speed(found)
    if not abs(speed) > SLOWEST * abs(found.speed):
        raise ProblemError(
            [mistake(N_("the output of the drive stands still, so the cam has no speed"), SPEED, STATE)]
        )
    sense = "counter-clockwise" if speed > 0 else "clockwise"
    if "rotation" in stated.model_fields_set and stated.rotation != sense:
        wrong = N_("the output of the drive turns the other way, its input turning counter-clockwise")
        right = Message(N_("leave out rotation, or a speed of the cam that is its own"))
        raise ProblemError([mistake(wrong, ("cam", "rotation"), right)])
    turned = stated.model_copy(update={"speed": abs(speed), "rotation": sense})
    made = replace(read, blocks={**read.blocks, cam.Block: cam.Block(cam=turned)})
    if told := [*cam.mistakes(made)]:
        raise ProblemError(told)
    return made
