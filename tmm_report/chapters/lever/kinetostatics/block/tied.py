"""Mistakes of springs and dampers that are right in themselves: their points, the links that take them, positions."""

from __future__ import annotations

from collections.abc import Iterator

from tmm_report.chapters.lever.kinematics.block import beyond_the_table
from tmm_report.chapters.lever.kinetostatics.block.models import LoadsModel
from tmm_report.chapters.lever.kinetostatics.ties import Damper, Spring, Tie, TorsionSpring
from tmm_report.chapters.lever.structure.block import FRAME, Names, names, no_link, no_point
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant.errors import near
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path


def check(written: LoadsModel, read: Read) -> Iterator[Problem]:
    known = names(read.data)
    for key, ties in (("springs", written.springs), ("dampers", written.dampers)):
        for index, tie in enumerate(ties):
            if tie:
                yield from _of_tie(tie, ("loads", key, index), known, read)
    for index, spring in enumerate(written.torsion_springs):
        if spring:
            yield from of_torsion(spring, ("loads", "torsion_springs", index), known)


def of_torsion(tie: TorsionSpring, path: Path, known: Names) -> Iterator[Problem]:
    """Between two links of the mechanism."""
    unknown = [
        found
        for k, link in enumerate(tie.links)
        if link != FRAME
        for found in no_link(link, (*path, "links", k), known)
    ]
    yield from unknown
    one, other = tie.links
    if not unknown and one == other:
        text = N_("both ends are on link %(link)s: a torsion spring is between two links")
        others = [name for name in known.points if name != one]
        right = Message(N_("another link: %(words)s"), {"words": ", ".join(others)})
        yield mistake(text, (*path, "links"), right, link=one)


def _of_tie(tie: Tie, path: Path, known: Names, read: Read) -> Iterator[Problem]:
    unknown = [
        found for k, name in enumerate(tie.between) for found in no_point(name, (*path, "between", k), known)
    ]
    yield from unknown
    if not unknown:
        yield from _apart(tie, (*path, "between"), known)
    yield from _taken(tie, (*path, "on"), known)
    if isinstance(tie, Spring) and tie.at_position is not None:
        yield from beyond_the_table(tie.at_position, (*path, "at_position"), read)
    if isinstance(tie, Damper) and "dynamics" in read.data:
        text = N_(
            "a damper goes by the speed, which dynamics looks for: its force is known for the stated speed alone"
        )
        right = Message(N_("resistance: [{viscous: …}] in dynamics, or without the block dynamics"))
        yield mistake(text, path, right)


def _apart(tie: Tie, path: Path, known: Names) -> Iterator[Problem]:
    """Two points of which one at least moves, and that no link holds at a distance."""
    one, other = tie.between
    if one == other:
        others = [name for name in known.all_points if name != one]
        text = N_("both ends are at the point %(name)s: a spring or damper is between two points")
        yield mistake(
            text, path, Message(N_("another point: %(words)s"), {"words": ", ".join(others)}), name=one
        )
        return
    both = next((link for link, points in known.points.items() if one in points and other in points), None)
    if both == FRAME:
        text = N_("points %(one)s and %(other)s are fixed: between them nothing loads the links")
        yield mistake(text, path, Message(N_("one of the points on a moving link")), one=one, other=other)
    elif both is not None:
        text = N_("points %(one)s and %(other)s are both on link %(link)s: their distance never changes")
        yield mistake(text, path, Message(N_("points of two links")), one=one, other=other, link=both)


def _taken(tie: Tie, path: Path, known: Names) -> Iterator[Problem]:
    """The links that take the forces move and have the points."""
    for point, link in tie.on.items():
        here = (*path, point)
        on = [name for name, points in known.points.items() if name != FRAME and point in points]
        if point not in tie.between:
            text = N_(
                "the point %(name)s is none of the two: on says which link takes the force at one of them"
            )
            yield mistake(text, here, near(point, list(tie.between)), name=point)
        elif link == FRAME:
            text = N_("the frame takes every force: there it loads no moving link")
            yield mistake(text, here, near(link, on))
        elif link not in known.points:
            yield from no_link(link, here, known)
        elif point in known.all_points and link not in on:
            text = N_("the point %(name)s is not on link %(link)s")
            yield mistake(text, here, near(link, on), name=point, link=link)
