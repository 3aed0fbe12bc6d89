"""The block `balancing` of a variant."""

from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import FRAME, Names, names, no_link, no_point, stated, without
from tmm_report.chapters.machine.balancing.given import FULL, Balancing
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.errors import near
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated


class Block(model.Block):
    """The mechanism balanced on its foundation."""

    balancing: Stated[Balancing] | None = Field(
        default=None, description="the mechanism balanced on its foundation"
    )


class Taken(TypedDict):
    balancing: Balancing | None


def given(read: Read) -> Taken:
    return {"balancing": read.block(Block).balancing}


def mistakes(read: Read) -> Iterator[Problem]:
    if not stated(read):
        yield from without(read, "balancing")
        return
    written = read.block(Block).balancing
    if written is None:
        return
    known = names(read.data)
    yield from _sizes(read, written, known)
    yield from _fixed(written, known)
    no_radii = written.rotors is None and not _broken(read, ("balancing", "rotors"))
    if written.methods and "rotors" in written.methods and no_radii:
        right = Message(N_("for example, rotors: {first: 60 mm, second: 40 mm}"))
        yield mistake(N_("the radii of the rotors are not stated"), ("balancing", "rotors"), right)
    if not _heavy(read.data):
        right = Message(N_("give the links their mass, mass_centre and inertia"))
        yield mistake(N_("there is nothing to balance: no link has a mass"), ("balancing",), right)


def _broken(read: Read, path: tuple[str, ...]) -> bool:
    """Whether something is wrong in itself at a place of the file or within it: what is missing there is no mistake."""
    return any(one[: len(path)] == path for one in read.broken)


def _sizes(read: Read, written: Balancing, known: Names) -> Iterator[Problem]:
    """Each counterweight is on a moving link, and one of its sizes is stated."""
    for link, one in written.counterweights.items():
        path = ("balancing", "counterweights", link)
        yield from _moving(link, path, known)
        if (one.mass is None) == (one.distance is None) and not _broken(read, path):
            text = (
                N_("the counterweight of link %(link)s has neither a mass nor a distance")
                if one.mass is None
                else N_("the counterweight of link %(link)s has both: one of them follows from the other")
            )
            yield mistake(text, path, Message(N_("distance: 60 mm, or mass: 2 kg")), link=link)
        floating = link in known.points and link != FRAME and not _pivots(link, known)
        if floating and written.methods and FULL not in written.methods:
            yield _not_pivoted(link, path, known)
    for link in written.stated:
        path = ("balancing", "stated", link)
        yield from _moving(link, path, known)
        if link in known.points and link != FRAME and not _pivots(link, known):
            yield _not_pivoted(link, path, known)


def _moving(link: str, path: tuple[str, ...], known: Names) -> Iterator[Problem]:
    yield from no_link(link, path, known)
    if link == FRAME:
        yield mistake(N_("the frame does not move: a counterweight on it balances nothing"), path)


def _pivots(link: str, known: Names) -> list[str]:
    return [point for point in known.points[link] if point in known.points[FRAME]]


def _not_pivoted(link: str, path: tuple[str, ...], known: Names) -> Problem:
    text = N_("link %(link)s is not pivoted to the frame: a counterweight on it is no part of these methods")
    right = [name for name in known.points if name != FRAME and _pivots(name, known)]
    return mistake(text, path, Message(N_("one of: %(words)s"), {"words": ", ".join(right)}), link=link)


def _fixed(written: Balancing, known: Names) -> Iterator[Problem]:
    """The point of the moment is of the frame."""
    if written.about is not None:
        path = ("balancing", "about")
        yield from no_point(written.about, path, known)
        if written.about in known.all_points and written.about not in known.points[FRAME]:
            text = N_("the point %(name)s moves: the shaking moment is about a fixed point")
            yield mistake(text, path, near(written.about, known.points[FRAME]), name=written.about)


def _heavy(data: object) -> bool:
    mechanism = data.get("mechanism") if isinstance(data, dict) else None
    links = mechanism.get("links") if isinstance(mechanism, dict) else None
    written = links.values() if isinstance(links, dict) else ()
    return any(isinstance(link, dict) and link.get("mass") for link in written)
