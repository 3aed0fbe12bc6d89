"""The block `harmonics` of a variant."""

from collections.abc import Iterator
from typing import Annotated, TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import FRAME, Names, names, no_link, no_point, stated, without
from tmm_report.chapters.machine.harmonics.given import Given as Stated
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.model import Model, Read
from tmm_report.variant.values import Name, whole
from tmm_report.yamlread import Path

Order = Annotated[int, whole(1, 24)]
Steps = Annotated[int, whole(2, 50)]


class HarmonicsModel(Model):
    """Harmonics of the motion of points and links."""

    highest: Order = Field(default=4, description="highest order")
    points: list[Name] = Field(
        default=[], max_length=12, description="points beside the outputs", examples=[["S2"]]
    )
    links: list[Name] | None = Field(
        default=None,
        max_length=8,
        description="along which the wave of the motion is followed; left out, all that turn without a fixed pivot",
        examples=[["2"]],
    )
    steps: Steps = Field(default=10, description="equal parts of a link")


class Block(model.Block):
    """Harmonics of the motion of points and links."""

    harmonics: HarmonicsModel | None = Field(
        default=None, description="harmonics of the motion of points and links"
    )


class Given(TypedDict):
    harmonics: Stated | None


def given(read: Read) -> Given:
    written = read.block(Block).harmonics
    if written is None:
        return {"harmonics": None}
    links = None if written.links is None else tuple(dict.fromkeys(written.links))
    points = tuple(dict.fromkeys(written.points))
    return {"harmonics": Stated(written.highest, points, links, written.steps)}


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
