"""The block `harmonics` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import FRAME, Names, names, no_link, no_point, stated, without
from tmm_report.chapters.machine.harmonics.given import Harmonics
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated
from tmm_report.yamlread import Path


class Block(model.Block):
    """Harmonics of the motion of points and links."""

    harmonics: Stated[Harmonics] | None = Field(
        default=None, description="harmonics of the motion of points and links"
    )


class Taken(TypedDict):
    harmonics: Harmonics | None


def given(read: Read) -> Taken:
    return {"harmonics": read.block(Block).harmonics}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "harmonics")
        return
    written, known = read.block(Block).harmonics, names(read.data)
    if written is None:
        return
    for index, point in enumerate(written.points):
        yield from _moving(point, ("harmonics", "points", index), known)
    for index, link in enumerate(written.links or ()):
        yield from _long(link, ("harmonics", "links", index), known)


def _moving(point: str, path: Path, known: Names) -> Iterator[Problem]:
    yield from no_point(point, path, known)
    fixed = known.points[FRAME]
    moving = [p for p in known.all_points if p not in fixed]
    if point in known.all_points and point not in moving:
        text = N_("the point %(name)s does not move: it has no harmonics")
        yield mistake(text, path, near(point, moving), name=point)


def _long(link: str, path: Path, known: Names) -> Iterator[Problem]:
    """The link is a moving one with two points or more."""
    yield from no_link(link, path, known)
    if link == FRAME:
        yield mistake(N_("the frame does not move: it has no harmonics"), path)
    elif len(known.points.get(link, ("", ""))) < 2:
        text = N_(
            "link %(name)s has less than two points: there is no line along which a wave could be followed"
        )
        yield mistake(text, path, Message(N_("a link with two joints")), name=link)
