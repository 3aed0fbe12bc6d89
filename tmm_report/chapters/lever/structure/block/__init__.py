"""The block `mechanism` of a variant: its models, what they become, what its parts say wrong of one another."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import ClassVar, TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import odd
from tmm_report.chapters.lever.structure.block.build import driver as build_driver
from tmm_report.chapters.lever.structure.block.build import mechanism
from tmm_report.chapters.lever.structure.block.checks import (
    Names,
    check,
    driven_by_stroke,
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
from tmm_report.chapters.lever.structure.block.driving import begun
from tmm_report.chapters.lever.structure.block.models import MechanismModel
from tmm_report.chapters.lever.structure.block.synthesised import direction, offered
from tmm_report.mechanics.lever.mechanism import FRAME, Driver, Mechanism
from tmm_report.problems import N_, Problem, ProblemError
from tmm_report.quantity.units import WrongValue
from tmm_report.variant import model
from tmm_report.variant.model import Read

__all__ = [
    "ASKED", "FRAME", "Block", "Given", "Names", "belongs", "doubts", "driven_by_stroke", "driver", "given",
    "in_vain", "mistakes", "names", "no_link", "no_point", "of_friction", "rails", "rollers", "stated", "swept",
    "without",
]  # fmt: skip


class Block(model.Block):
    """The lever mechanism."""

    ONE_SIZE = True
    NOT_OFFERED: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("gears", "wheels"), N_("gears are stages of the block drive")
    )

    mechanism: MechanismModel = Field(default_factory=MechanismModel)


def rollers(read: Read) -> dict[str, float | None]:
    """The cam pairs of a file, each with the radius of its roller, m; None of an edge or a flat face."""
    cams = read.block(Block).mechanism.cams
    return {name: (cam.roller.radius or None) if cam.roller else None for name, cam in cams.items()}


def driver(read: Read) -> Driver | None:
    """The driving link of a file, of the speed 1 where it is that of the drive; None where there is none, or it takes
    what the synthesis does not find."""
    model = read.block(Block).mechanism.driver
    try:
        return build_driver(model, offered(read)) if model else None
    except WrongValue:
        return None


def swept(read: Read) -> float:
    """How far the driving link turns, rad; all round where that is not stated, or by a number that is not found."""
    model = read.block(Block).mechanism.driver
    try:
        return direction(model.range, offered(read)) if model else 2 * math.pi
    except WrongValue:
        return 2 * math.pi


class Given(TypedDict):
    mechanism: Mechanism


def given(read: Read) -> Given:
    return {"mechanism": begun(mechanism(read.block(Block).mechanism, offered(read)))}


def mistakes(read: Read) -> Iterator[Problem]:
    if stated(read):
        found = list(check(read.block(Block).mechanism, read))
        yield from found or _beginning(read)


def _beginning(read: Read) -> Iterator[Problem]:
    """What is wrong of the position in which a law of the driving link begins."""
    written = read.block(Block).mechanism
    if read.broken or written.driver is None or written.driver.law is None or written.driver.zero is None:
        return
    try:
        given(read)
    except ProblemError as error:
        yield from error.problems


def doubts(read: Read) -> Iterator[Problem]:
    if stated(read):
        yield from unserved(read.block(Block).mechanism, read)
        yield from odd.doubts(read.block(Block).mechanism, read)
