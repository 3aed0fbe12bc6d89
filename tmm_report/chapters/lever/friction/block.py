"""The block `friction` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.friction.given import Friction, Rubbing
from tmm_report.chapters.lever.structure.block import (
    ASKED,
    FRAME,
    Names,
    has_cams,
    names,
    rails,
    stated,
    without,
)
from tmm_report.problems import N_, Message, Problem, doubt, mistake
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.materials import Rubbed
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Flag, KeyName, Positive


class PivotFriction(Rubbed):
    """Friction in pivots."""

    diameter: Positive = Field(description="of the journal", examples=["50 mm"])


class GuideFriction(Rubbed):
    """Friction in guides."""

    length: Positive | None = Field(default=None, description="of the slider, where it may tilt")


class JointFriction(Rubbed):
    """Friction in one joint; the diameter is for a pivot, the length for a guide."""

    diameter: Positive | None = None
    length: Positive | None = None


class FrictionModel(Model):
    """Friction in the joints: of all pivots, of all guides, of single ones."""

    pivots: PivotFriction | None = None
    guides: GuideFriction | None = None
    joints: dict[KeyName, JointFriction] = Field(default={}, description="by point or guide")
    corrected: Flag = Field(default=False, description="true: reactions and balancing moment with friction")


class Block(model.Block):
    """Friction."""

    friction: FrictionModel | None = None


class Given(TypedDict):
    friction: Friction | None


def given(read: Read) -> Given:
    written = read.block(Block).friction
    return {"friction": _friction(written, tuple(rails(read))) if written else None}


def _friction(written: FrictionModel, of_rails: tuple[str, ...]) -> Friction:
    pivots, guides = written.pivots, written.guides
    return Friction(
        Rubbing(pivots.f, pivots.diameter, stock=pivots.of) if pivots else None,
        Rubbing(guides.f, length=guides.length, stock=guides.of) if guides else None,
        {name: Rubbing(one.f, one.diameter, one.length, one.of) for name, one in written.joints.items()},
        written.corrected,
        of_rails,
    )


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "friction")
        return
    written, known = read.block(Block).friction, names(read.data)
    if written and has_cams(read):
        text = N_("friction is not worked out of a mechanism with a cam pair")
        yield mistake(text, ("friction",), Message(N_("leave this block out")))
        return
    joints = [*known.all_points, *known.guides]
    if written and written.corrected and not (written.pivots or written.guides or written.joints):
        text = N_("there is nothing to correct: no pair has friction")
        right = Message(N_("state the friction of pivots, guides or joints"))
        yield mistake(text, ("friction", "corrected"), right)
    for name, joint in written.joints.items() if written else ():
        path = ("friction", "joints", name)
        if name not in joints:
            text = N_("there is no joint %(name)s: neither a point nor a guide")
            yield mistake(text, path, near(name, joints), name=name)
        else:
            yield from _no_pivot(name, known, path)
            if name in (on_rails := rails(read)):
                text = N_(
                    "guide %(name)s stands for the rail on which wheel %(wheel)s rolls: nothing slides on it"
                )
                right = Message(N_("leave this joint out: rolling friction stands in contacts"))
                yield mistake(text, path, right, name=name, wheel=on_rails[name])
            yield from _sizes(joint, name in known.guides, path)


def _sizes(joint: JointFriction, guide: bool, path: tuple[str | int, ...]) -> Iterator[Problem]:
    """A pivot has the diameter of its journal, a guide the length of its slider."""
    if guide and joint.diameter is not None:
        text = N_("a guide has no journal")
        yield mistake(text, (*path, "diameter"), Message(N_("length: of the slider, where it may tilt")))
    if not guide and joint.length is not None:
        text = N_("a pivot has no length of a slider")
        yield mistake(text, (*path, "length"), Message(N_("diameter: of the journal")))
    if not guide and joint.diameter is None:
        text = N_("the moment of friction of a pivot needs the diameter of its journal")
        yield mistake(text, path, Message(N_("diameter: of the journal")))


def _no_pivot(name: str, known: Names, path: tuple[str | int, ...]) -> Iterator[Problem]:
    """A point of one link alone joins nothing."""
    links = [link for link, points in known.points.items() if name in points]
    if name in known.guides or len(links) != 1:
        return
    pivots = [point for point in known.all_points if known.pivot(point)]
    text, right = N_("%(name)s is no pivot: it is a point of link %(link)s alone"), near(name, pivots)
    if links == [FRAME]:
        text = N_("%(name)s is no pivot: it is a point of the frame alone")
    yield mistake(text, path, right, name=name, link=links[0])


def doubts(read: Read) -> Iterator[Problem]:
    written = read.block(Block).friction
    if written is None:
        return
    if "loads" not in read.data:
        text = N_("friction is not worked out: it needs the reactions, and there is no block loads")
        yield doubt(text, ("friction",), ASKED)
    elif not (written.pivots or written.guides or written.joints):
        right = Message(N_("state the friction of pivots, guides or joints"))
        yield doubt(N_("no pair has friction: this block has no effect"), ("friction",), right)
    if written.guides and not names(read.data).guides:
        yield doubt(N_("the mechanism has no guide: this has no effect"), ("friction", "guides"))
