"""Mistakes of the keys `wheels`, `racks` and `rolling`: names first, then sizes against the axes."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from tmm_report.chapters.cams.cam.block.laws import Wrong
from tmm_report.chapters.lever.structure.block.wheels import build
from tmm_report.mechanics.lever.mechanism import FRAME, Mechanism
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant.errors import near
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path

if TYPE_CHECKING:
    from tmm_report.chapters.lever.structure.block.checks import Names
    from tmm_report.chapters.lever.structure.block.models import MechanismModel

Found = Iterator[Problem]
HERE: Path = ("mechanism",)


def check(mechanism: MechanismModel, known: Names, built: Mechanism | None, read: Read) -> Found:
    """`built`: the mechanism without its wheels, None where its links have mistakes of their own."""
    named = list(_names(mechanism, known))
    yield from named
    yield from _together(mechanism, read)
    if built is None or named:
        return
    makes = [(("wheels", k), partial(build.gear_pair, k, one)) for k, one in enumerate(mechanism.wheels)]
    makes += [(("racks", k), partial(build.rack_pair, k, rack)) for k, rack in enumerate(mechanism.racks)]
    makes += [
        (("rolling", k), partial(build.rolling_pair, k, one)) for k, one in enumerate(mechanism.rolling)
    ]
    for path, make in makes:
        try:
            make(built)
        except Wrong as error:
            part = tuple(int(one) if one.isdigit() else one for one in error.key.split(".") if one)
            yield Problem(error.wrong, error.right, (*HERE, *path, *part))
        except KeyError:  # a guide or a point that is not there is told elsewhere
            continue


def _names(mechanism: MechanismModel, known: Names) -> Found:
    seen: dict[frozenset[str], Path] = {}
    moving = [name for name in known.points if name != FRAME]
    for one in _stated(mechanism):
        for link, place, fixed in one.links:
            if link == FRAME and not fixed:
                yield _frame(one, place, moving)
            elif link not in known.points:
                yield mistake(N_("there is no link %(name)s"), place, near(link, moving), name=link)
        links = [link for link, _, _ in one.links]
        if one.carrier is not None:
            yield from _of_carrier(one, links, known, moving)
        if links[0] == links[1]:
            text = N_("link %(name)s would be in mesh with itself")
            yield mistake(text, one.path, Message(N_("two different links")), name=links[0])
        if frozenset(links) in seen:
            text = N_("links %(links)s are in mesh twice")
            yield mistake(text, one.path, Message(N_("leave one of the two")), links=", ".join(links))
        seen[frozenset(links)] = one.path


class _Stated(NamedTuple):
    """A mesh by its names: `links` with their places and whether each may be the frame."""

    path: Path
    links: tuple[tuple[str, Path, bool], ...]
    carrier: str | None


def _stated(mechanism: MechanismModel) -> Iterator[_Stated]:
    for k, one in enumerate(mechanism.wheels):
        path = (*HERE, "wheels", k)
        fixed = one.carrier is not None, False
        links = zip(one.links, ((*path, "links", 0), (*path, "links", 1)), fixed, strict=True)
        yield _Stated(path, tuple(links), one.carrier)
    for k, rack in enumerate(mechanism.racks):
        path = (*HERE, "racks", k)
        ends = (rack.slider, (*path, "slider"), True), (rack.wheel, (*path, "wheel"), False)
        yield _Stated(path, ends, rack.carrier)
    for k, wheel in enumerate(mechanism.rolling):
        path = (*HERE, "rolling", k)
        ends = (FRAME, path, True), (wheel.wheel, (*path, "wheel"), False)
        yield _Stated(path, ends, wheel.carrier)


def _frame(one: _Stated, place: Path, moving: list[str]) -> Problem:
    """The frame where a moving link is wanted."""
    first, second = (link for link, _, _ in one.links)
    if one.carrier is not None and second == FRAME:
        right = Message(N_("links: [0, %(link)s], the fixed wheel first"), {"link": first})
        return mistake(N_("the fixed wheel stands behind the one that runs round"), place, right)
    text = N_(
        "the frame carries no wheel that turns, and the link on which another runs round it is not stated"
    )
    cure = N_("a moving link: %(words)s; or carrier: the moving link that holds both axes")
    return mistake(text, place, Message(cure, {"words": ", ".join(moving)}))


def _of_carrier(one: _Stated, links: list[str], known: Names, moving: list[str]) -> Found:
    place, carrier = (*one.path, "carrier"), str(one.carrier)
    if carrier == FRAME:
        text = N_("the frame is no carrier: the wheels then have fixed axes")
        yield mistake(text, place, Message(N_("leave this key out")))
    elif carrier not in known.points:
        yield mistake(N_("there is no link %(name)s"), place, near(carrier, moving), name=carrier)
    elif carrier in links:
        text = N_("link %(name)s would carry its own wheel")
        others = ", ".join(link for link in moving if link not in links)
        yield mistake(text, place, Message(N_("another link: %(words)s"), {"words": others}), name=carrier)


def _together(mechanism: MechanismModel, read: Read) -> Found:
    """What does not go with wheels yet."""
    key = next((key for key in ("wheels", "racks", "rolling") if getattr(mechanism, key)), None)
    if key is None:
        return
    right = Message(N_("leave one of the two"))
    if mechanism.cams:
        text = N_("cam pairs and wheels in one mechanism are not offered together")
        yield mistake(text, (*HERE, key), right)
    data: dict[str, Any] = read.data  # type: ignore[assignment]
    for block in ("methods", "method"):
        if block in data:
            text = N_("%(block)s is not worked out of a mechanism with wheels in mesh")
            cure = N_("leave this key out: what wheels move follows in closed form")
            yield mistake(text, (block,), Message(cure), block=block)
