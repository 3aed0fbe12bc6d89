"""The block `dynamics` of a variant."""

import math
from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.kinematics.block import turns_of
from tmm_report.chapters.lever.structure.block import stated
from tmm_report.chapters.machine.dynamics.block.checks import check
from tmm_report.chapters.machine.dynamics.block.models import (
    MOVES,
    CoastModel,
    DynamicsModel,
    PartModel,
    SpringModel,
    StartModel,
)
from tmm_report.chapters.machine.dynamics.block.motors import motor, resistance
from tmm_report.chapters.machine.dynamics.given import Coast, Part, Spring, Start
from tmm_report.chapters.machine.dynamics.given import Given as Stated
from tmm_report.mechanics.calculus.laws import ByAngle
from tmm_report.problems import Problem
from tmm_report.variant import model
from tmm_report.variant.model import Read


class Block(model.Block):
    """The machine in motion."""

    ALONE = True

    dynamics: DynamicsModel | None = Field(default=None, description="the machine in motion")


class Given(TypedDict):
    dynamics: Stated | None


def given(read: Read) -> Given:
    written = read.block(Block).dynamics
    turn = 2 * math.pi * (turns_of(read) if stated(read) else 1)
    return {"dynamics": build(written, turn) if written else None}


def build(written: DynamicsModel, turn: float = 2 * math.pi) -> Stated:
    """`turn`: angle of a cycle that is not stated, rad."""
    period = written.period or turn
    return Stated(
        parts=tuple(_part(one, written.speed or 1.0) for one in written.parts),
        motor=motor(written.motor, period) if written.motor else None,
        resistances=tuple(resistance(one, period) for one in written.resistance),
        springs=tuple(_spring(one) for one in written.springs),
        speed=written.speed,
        period=period,
        varying=ByAngle.through(written.varying_inertia, period) if written.varying_inertia else None,
        passing=written.losses_of_acceleration,
        gravity=written.gravity,
        friction=written.friction is not False,
        start=_start(written.start) if written.start else None,
        steady=written.steady,
        coast=_coast(written.coast) if written.coast else None,
        name=written.name or "",
    )


def _part(one: PartModel, speed: float) -> Part:
    arm = 0.0
    if one.mass or one.force:
        arm = (
            one.velocity / speed if one.velocity is not None else (one.radius or one.offset) * abs(one.ratio)
        )
    return Part(
        one.name, abs(one.ratio), one.inertia, one.moment, one.mass, arm, one.force, MOVES[one.moves],
        one.offset, one.angle, one.efficiency,
    )  # fmt: skip


def _spring(one: SpringModel) -> Spring:
    to = complex(*one.to) if one.to else 0j
    return Spring(one.stiffness, one.length, one.at or "", to, one.radius or 0.0, one.angle, one.apart or 0.0)


def _start(one: StartModel) -> Start:
    return Start(one.begin, one.speed, one.time, one.angle, one.within, one.motor, one.at)


def _coast(one: CoastModel) -> Coast:
    return Coast(one.begin, one.speed, one.motor, one.brake or 0.0, one.load)


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).dynamics
    if written is not None:
        yield from check(written, read)
