"""The block `dynamics` of a variant."""

import math
from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.kinematics.block import turns_of
from tmm_report.chapters.lever.structure.block import stated
from tmm_report.chapters.machine.dynamics.block.checks import check
from tmm_report.chapters.machine.dynamics.block.models import MOVES, DynamicsModel, PartModel
from tmm_report.chapters.machine.dynamics.block.motors import motor, resistance
from tmm_report.chapters.machine.dynamics.given import Given as Stated
from tmm_report.chapters.machine.dynamics.given import Part
from tmm_report.mechanics.calculus.laws import ByAngle
from tmm_report.problems import N_, Message, Problem, doubt
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
        parts=tuple(_part(one, _ratio(one, written), written.speed or 1.0) for one in written.parts),
        motor=motor(written.motor, period) if written.motor else None,
        resistances=tuple(resistance(one, period) for one in written.resistance),
        springs=tuple(written.springs),
        torsion_springs=tuple(written.torsion_springs),
        speed=written.speed,
        period=period,
        varying=ByAngle.through(written.varying_inertia, period) if written.varying_inertia else None,
        passing=written.losses_of_acceleration,
        gravity=written.gravity,
        friction=written.friction is not False,
        start=written.start,
        steady=written.steady,
        coast=written.coast,
        cycles=written.cycles,
        name=written.name or "",
    )


def _ratio(one: PartModel, written: DynamicsModel) -> float:
    """Its speed by that of the main shaft."""
    return written.motor.ratio if one.on == "motor" and written.motor else abs(one.ratio)


def _part(one: PartModel, ratio: float, speed: float) -> Part:
    """`speed`: of the main shaft, by which the arm of a mass follows from its velocity; no part states it."""
    arm = 0.0
    if one.carried or one.force:
        arm = one.velocity / speed if one.velocity is not None else (one.radius or one.offset) * ratio
    return Part(
        name=one.name,
        ratio=ratio,
        inertia=one.turned,
        moment=one.moment,
        mass=one.carried,
        arm=arm,
        force=one.force,
        moves=MOVES[one.moves],
        offset=one.offset,
        angle=one.angle,
        efficiency=one.efficiency,
    )


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).dynamics
    if written is not None:
        yield from check(written, read)


def doubts(read: Read) -> Iterator[Problem]:
    """A spring that stands among the loads, too, is there twice: those act in the machine in motion."""
    written = read.block(Block).dynamics
    loads = read.data.get("loads") or {}
    held = {str(point) for one in loads.get("springs") or () for point in one["between"]}
    for k, one in enumerate(written.springs if written is not None else ()):
        if one.at is not None and one.at in held:
            text = N_(
                "a spring at %(point)s stands among the loads, too, and both act in the machine in motion"
            )
            right = Message(N_("where it is the same spring, state it once, in loads.springs"))
            yield doubt(text, ("dynamics", "springs", k, "at"), right, point=one.at)
    turned = [{str(link) for link in one["links"]} for one in loads.get("torsion_springs") or ()]
    for k, spring in enumerate(written.torsion_springs if written is not None else ()):
        if set(spring.links) in turned:
            text = N_(
                "a torsion spring between %(one)s and %(other)s stands among the loads, too, and both act in the "
                "machine in motion"
            )
            right = Message(N_("where it is the same spring, state it once, in loads.torsion_springs"))
            links = dict(zip(("one", "other"), spring.links, strict=True))
            yield doubt(text, ("dynamics", "torsion_springs", k, "links"), right, **links)
