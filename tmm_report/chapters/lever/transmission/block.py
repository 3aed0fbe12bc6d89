"""The key `transmission` of a variant: the least angle at which a coupler is to drive its follower."""

from collections.abc import Iterator
from typing import Annotated, TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import stated, without
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.values import quantity


class Block(model.Block):
    """Transmission angles."""

    transmission: Annotated[float, quantity("angle", 1e-3, 1.5708, "0 … 90 deg")] | None = Field(
        default=None, description="least permitted transmission angle", examples=["40 deg"]
    )


class Given(TypedDict):
    transmission: float | None


def given(read: Read) -> Given:
    return {"transmission": read.block(Block).transmission}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "transmission")
