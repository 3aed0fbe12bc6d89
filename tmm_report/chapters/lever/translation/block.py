"""What the key `reduction` of a variant asks for of a link that slides; the key is of the chapter before."""

from collections.abc import Iterator
from typing import TypedDict

from tmm_report.chapters.lever.reduction.block import Block as Reduction
from tmm_report.chapters.lever.reduction.block import ToModel
from tmm_report.chapters.lever.structure.block import driven_by_stroke
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """No keys of its own."""


class Given(TypedDict):
    translation: str | None


def given(read: Read) -> Given:
    asked = read.block(Reduction).reduction
    if isinstance(asked, ToModel):
        return {"translation": asked.link}
    return {"translation": "" if asked and driven_by_stroke(read) else None}


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()
