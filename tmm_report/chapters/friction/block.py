"""The block `friction` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.friction.given import Friction, Rubbing
from tmm_report.chapters.structure.block import names, stated, without
from tmm_report.problems import N_, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import (
    Coefficient,
    KeyName,
    Positive,
)


class PivotFriction(Model):
    """Friction in pivots."""

    coefficient: Coefficient
    diameter: Positive = Field(description="of the journal", examples=["50 mm"])


class GuideFriction(Model):
    """Friction in guides."""

    coefficient: Coefficient


class JointFriction(Model):
    """Friction in one joint; the diameter is for a pivot."""

    coefficient: Coefficient
    diameter: Positive | None = None


class FrictionModel(Model):
    """Friction in the joints: of all pivots, of all guides, of single ones."""

    pivots: PivotFriction | None = None
    guides: GuideFriction | None = None
    joints: dict[KeyName, JointFriction] = Field(default={}, description="by point or guide")


class Block(model.Block):
    """Friction."""

    friction: FrictionModel | None = None


class Given(TypedDict):
    friction: Friction | None


def given(read: Read) -> Given:
    written = read.block(Block).friction
    return {"friction": _friction(written) if written else None}


def _friction(written: FrictionModel) -> Friction:
    joints = {name: Rubbing(one.coefficient, one.diameter) for name, one in written.joints.items()}
    pivots = Rubbing(written.pivots.coefficient, written.pivots.diameter) if written.pivots else None
    return Friction(pivots, Rubbing(written.guides.coefficient) if written.guides else None, joints)


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "friction")
        return
    written, known = read.block(Block).friction, names(read.data)
    joints = [*known.all_points, *known.guides]
    for name in written.joints if written else ():
        if name not in joints:
            text = N_("there is no joint %(name)s: neither a point nor a guide")
            yield mistake(text, ("friction", "joints", name), near(name, joints), name=name)
