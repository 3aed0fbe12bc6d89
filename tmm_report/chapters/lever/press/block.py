"""The block `press` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.press.given import Press
from tmm_report.chapters.lever.structure.block import FRAME, names, no_link, stated, without
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated


class Block(model.Block):
    """A press."""

    press: Stated[Press] | None = Field(default=None, description="what the slider of a press is rated by")


class Given(TypedDict):
    press: Press | None


def given(read: Read) -> Given:
    return {"press": read.block(Block).press}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "press")
        return
    written = read.block(Block).press
    if written is None:
        return
    yield from no_link(written.slider, ("press", "slider"), names(read.data))
    if written.slider == FRAME:
        yield mistake(N_("the frame does not move: it is no slider"), ("press", "slider"))
    keys = read.data["press"]
    if not any(keys.get(key) is not None for key in ("torque", "rated", "within", "working")):
        right = Message(N_("state torque and rated, within or working"))
        yield mistake(N_("nothing is asked of the press"), ("press",), right)
    if written.rated is not None and keys.get("torque") is None:
        right = Message(N_("state torque, which the driving link may bear"))
        yield mistake(
            N_("a rated force says nothing without the permitted torque"), ("press", "rated"), right
        )
    if written.working is not None and written.working[0] <= written.working[1]:
        right = Message(N_("the path left at its beginning, then the shorter one at its end: [30 mm, 0]"))
        yield mistake(N_("the working part of the stroke ends before it begins"), ("press", "working"), right)
