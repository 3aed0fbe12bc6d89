"""Mistakes of the keys `wheels` and `racks`: names first, then sizes against the axes."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

from tmm_report.chapters.lever.structure.block.cam_laws_build import Wrong
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
    meshes: list[tuple[Path, tuple[str, ...], tuple[Path, Path]]] = []
    for k, one in enumerate(mechanism.wheels):
        path = (*HERE, "wheels", k)
        meshes.append((path, one.links, ((*path, "links", 0), (*path, "links", 1))))
    for k, rack in enumerate(mechanism.racks):
        path = (*HERE, "racks", k)
        meshes.append((path, (rack.slider, rack.wheel), ((*path, "slider"), (*path, "wheel"))))
    moving = [name for name in known.points if name != FRAME]
    for path, links, places in meshes:
        for link, place in zip(links, places, strict=True):
            if link == FRAME:
                text = N_("the frame carries no wheel that turns: rolling on a fixed one is not offered")
                yield mistake(
                    text, place, Message(N_("a moving link: %(words)s"), {"words": ", ".join(moving)})
                )
            elif link not in known.points:
                yield mistake(N_("there is no link %(name)s"), place, near(link, moving), name=link)
        if links[0] == links[1]:
            text = N_("link %(name)s would be in mesh with itself")
            yield mistake(text, path, Message(N_("two different links")), name=links[0])
        if frozenset(links) in seen:
            text = N_("links %(links)s are in mesh twice")
            yield mistake(text, path, Message(N_("leave one of the two")), links=", ".join(links))
        seen[frozenset(links)] = path


def _together(mechanism: MechanismModel, read: Read) -> Found:
    """What does not go with wheels yet."""
    if not (mechanism.wheels or mechanism.racks):
        return
    key = "wheels" if mechanism.wheels else "racks"
    right = Message(N_("leave one of the two"))
    if mechanism.cams:
        text = N_("cam pairs and wheels in one mechanism are not offered together")
        yield mistake(text, (*HERE, key), right)
    data: dict[str, Any] = read.data  # type: ignore[assignment]
    for block in ("friction", "balancing", "methods", "method", "readings"):
        if block in data:
            text = N_("%(block)s is not worked out of a mechanism with wheels in mesh")
            yield mistake(text, (block,), Message(N_("leave this key out")), block=block)
    positions = data.get("positions")
    if isinstance(positions, dict) and "force_plan" in positions:
        text = N_("force plans of a mechanism with wheels in mesh are not offered")
        told = Message(N_("leave the key out: the reactions and the forces in the teeth stand in tables"))
        yield mistake(text, ("positions", "force_plan"), told)
