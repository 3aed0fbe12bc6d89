"""The block `friction` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.friction.given import Friction, Rubbing
from tmm_report.chapters.lever.structure.block import (
    ASKED,
    FRAME,
    Names,
    names,
    rails,
    rollers,
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


class CamFriction(Rubbed):
    """Friction between cams and their followers: of a roller on its pin, of an edge or a face on the cam."""

    diameter: Positive | None = Field(default=None, description="of the roller's pin", examples=["10 mm"])


class JointFriction(Rubbed):
    """Friction in one joint; the diameter is for a pivot or a roller's pin, the length for a guide."""

    diameter: Positive | None = None
    length: Positive | None = None


class FrictionModel(Model):
    """Friction in the joints: of all pivots, of all guides, of all cam pairs, of single ones."""

    pivots: PivotFriction | None = None
    guides: GuideFriction | None = None
    cams: CamFriction | None = None
    joints: dict[KeyName, JointFriction] = Field(default={}, description="by point, guide or cam pair")
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
    pivots, guides, cams = written.pivots, written.guides, written.cams
    return Friction(
        Rubbing(pivots.f, pivots.diameter, stock=pivots.of) if pivots else None,
        Rubbing(guides.f, length=guides.length, stock=guides.of) if guides else None,
        {name: Rubbing(one.f, one.diameter, one.length, one.of) for name, one in written.joints.items()},
        written.corrected,
        of_rails,
        Rubbing(cams.f, cams.diameter, stock=cams.of) if cams else None,
    )


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "friction")
        return
    written, known = read.block(Block).friction, names(read.data)
    cams = rollers(read)
    joints = [*known.all_points, *known.guides, *cams]
    if written and written.corrected and not _anything(written):
        text = N_("there is nothing to correct: no pair has friction")
        right = Message(N_("state the friction of pivots, guides or joints"))
        yield mistake(text, ("friction", "corrected"), right)
    for name, joint in written.joints.items() if written else ():
        path = ("friction", "joints", name)
        if name not in joints:
            text = N_("there is no joint %(name)s: neither a point nor a guide")
            yield mistake(text, path, near(name, joints), name=name)
        elif name in cams:
            yield from _cam_sizes(joint, cams[name], path)
        else:
            yield from _no_pivot(name, known, path)
            if name in (on_rails := rails(read)):
                text = N_(
                    "guide %(name)s stands for the rail on which wheel %(wheel)s rolls: nothing slides on it"
                )
                right = Message(N_("leave this joint out: rolling friction stands in contacts"))
                yield mistake(text, path, right, name=name, wheel=on_rails[name])
            yield from _sizes(joint, name in known.guides, path)

    if written and written.cams:
        for roller in cams.values():
            yield from _pin(written.cams.diameter, roller, ("friction", "cams"))


def _anything(written: FrictionModel) -> bool:
    return bool(written.pivots or written.guides or written.cams or written.joints)


def _cam_sizes(joint: JointFriction, roller: float | None, path: tuple[str | int, ...]) -> Iterator[Problem]:
    """A roller has the diameter of its pin; what slides on the cam has none."""
    if joint.length is not None:
        text = N_("a cam pair has no length of a slider")
        yield mistake(text, (*path, "length"), Message(N_("diameter: of the roller's pin")))
    if not roller and joint.diameter is not None:
        text = N_("an edge or a flat face slides on its cam and has no pin")
        yield mistake(text, (*path, "diameter"), Message(N_("leave it out")))
    yield from _pin(joint.diameter, roller, path)


def _pin(diameter: float | None, roller: float | None, path: tuple[str | int, ...]) -> Iterator[Problem]:
    """The pin of a roller is stated, and is thinner than the roller."""
    if roller and diameter is None:
        text = N_("the friction of a roller needs the diameter of its pin")
        yield mistake(text, path, Message(N_("diameter: of the roller's pin")))
    if roller and diameter is not None and diameter >= 2 * roller:
        text = N_("the pin of a roller is as thick as the roller itself")
        right = Message(N_("below %(most)s mm, the diameter of the roller"), {"most": f"{2e3 * roller:g}"})
        yield mistake(text, (*path, "diameter"), right)


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
    elif not _anything(written):
        right = Message(N_("state the friction of pivots, guides or joints"))
        yield doubt(N_("no pair has friction: this block has no effect"), ("friction",), right)
    if written.guides and not names(read.data).guides:
        yield doubt(N_("the mechanism has no guide: this has no effect"), ("friction", "guides"))
    if written.cams and not rollers(read):
        yield doubt(N_("the mechanism has no cam: this has no effect"), ("friction", "cams"))
