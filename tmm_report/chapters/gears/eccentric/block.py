"""The block of an eccentric epicyclic mechanism."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.gears.eccentric.given import Eccentric
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated


class Block(model.Block):
    """An eccentric epicyclic mechanism."""

    ALONE = True

    eccentric: Stated[Eccentric] | None = Field(default=None, description="an eccentric epicyclic mechanism")


class Given(TypedDict):
    eccentric: Eccentric | None


def given(read: Read) -> Given:
    return {"eccentric": read.block(Block).eccentric}


def mistakes(read: Read) -> Iterator[Problem]:
    yield from ()
