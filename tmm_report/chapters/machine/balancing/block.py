"""The block `balancing` of a variant."""

from collections.abc import Iterable, Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.lever.structure.block import FRAME, Names, names, no_link, no_point, stated, without
from tmm_report.chapters.machine.balancing.given import (
    COUPLES,
    FULL,
    INERTIA,
    MOMENT,
    NONE,
    STATED,
    Balancing,
    order_of,
)
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
    no_radii = not written.rotors and not _broken(read, ("balancing", "rotors"))
    if written.methods and "rotors" in written.methods and no_radii:
        right = Message(N_("for example, rotors: {first: 60 mm, second: 40 mm}"))
        yield mistake(N_("the radii of the rotors are not stated"), ("balancing", "rotors"), right)
    yield from _orders(written, "rotors", written.rotors)
    yield from _against_moment(read, written, known)
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


def _orders(written: Balancing, name: str, keys: Iterable[str]) -> Iterator[Problem]:
    """Weights are stated by the order of a harmonic, each once."""
    seen: set[int] = set()
    for key in keys:
        path, order = ("balancing", name, key), order_of(key)
        if not 1 <= order <= written.highest:
            right = Message(N_("a whole number, 1 … %(most)s (highest)"), {"most": written.highest})
            yield mistake(N_("%(order)s is no order of the harmonics looked at"), path, right, order=key)
        elif order in seen:
            yield mistake(N_("the order %(order)s is stated twice"), path, Message(N_("once")), order=order)
        seen.add(order)


def _against_moment(read: Read, written: Balancing, known: Names) -> Iterator[Problem]:
    """Wheels are geared to links with fixed pivots, or fixed to links; weights in antiphase have an order."""
    for link, ratio in written.wheels.items():
        path = ("balancing", "wheels", link)
        yield from _moving(link, path, known)
        if not ratio:
            right = Message(N_("for example, %(near)s"), {"near": "-1"})
            yield mistake(N_("a wheel that does not turn takes nothing of the moment"), path, right)
        elif ratio != 1 and link in known.points and link != FRAME and not _pivots(link, known):
            text = N_(
                "link %(link)s is not pivoted to the frame: no wheel on an axis of the frame is geared to it"
            )
            yield mistake(
                text, path, Message(N_("1: a larger moment of inertia of the link itself")), link=link
            )
    yield from _orders(written, "couples", written.couples)
    if COUPLES in written.ways and not written.couples and not _broken(read, ("balancing", "couples")):
        right = Message(N_("for example, couples: {1: {radius: 60 mm, distance: 300 mm}}"))
        yield mistake(N_("the weights in antiphase are not stated"), ("balancing", "couples"), right)
    used = {
        "wheels": (written.wheels, (INERTIA,)),
        "couples": (written.couples, (COUPLES,)),
        "after": (written.after, MOMENT),
    }
    for key, (value, methods) in used.items():
        if value and not set(methods) & set(written.ways):
            right = Message(
                N_("add %(method)s to the methods, or leave this key out"), {"method": methods[0]}
            )
            text = N_("%(key)s is stated, but no method that uses it is asked for")
            yield mistake(text, ("balancing", key), right, key=key)
    no_way = written.after not in (None, NONE, STATED, *written.ways) or (
        written.after == STATED and not written.stated
    )
    if no_way:
        text = N_("the way %(way)s, after which the moment is to be balanced, is not asked for")
        ways = [NONE, *((STATED,) if written.stated else ()), *(w for w in written.ways if w not in MOMENT)]
        right = Message(N_("one of: %(words)s"), {"words": ", ".join(ways)})
        yield mistake(text, ("balancing", "after"), right, way=written.after)


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
