"""The block `mechanism` of a variant: its models, what they become, what its parts say wrong of one another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import ClassVar, TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import odd
from tmm_report.chapters.lever.structure.block.build import driver, mechanism
from tmm_report.chapters.lever.structure.block.checks import (
    Names,
    check,
    driven_by_stroke,
    has_cams,
    names,
    no_link,
    no_point,
    of_friction,
    rails,
    stated,
    without,
)
from tmm_report.chapters.lever.structure.block.doubts import ASKED, belongs, in_vain
from tmm_report.chapters.lever.structure.block.doubts import doubts as unserved
from tmm_report.chapters.lever.structure.block.models import MechanismModel
from tmm_report.chapters.lever.structure.block.synthesised import offered
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism
from tmm_report.problems import N_, Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read

__all__ = [
    "ASKED", "FRAME", "Block", "Given", "Names", "belongs", "doubts", "driven_by_stroke", "driver", "given",
    "has_cams", "in_vain", "mistakes", "names", "no_link", "no_point", "of_friction", "rails",
    "stated", "without",
]  # fmt: skip


class Block(model.Block):
    """The lever mechanism."""

    ONE_SIZE = True
    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("gears", "wheels"), N_("gears are stages of the block drive")
    )

    mechanism: MechanismModel = Field(default_factory=MechanismModel)


class Given(TypedDict):
    mechanism: Mechanism


def given(read: Read) -> Given:
    return {"mechanism": mechanism(read.block(Block).mechanism, offered(read))}


def mistakes(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from check(read.block(Block).mechanism, read)


def doubts(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from unserved(read.block(Block).mechanism, read)
        yield from odd.doubts(read.block(Block).mechanism, read)
