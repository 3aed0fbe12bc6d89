"""What is odd in a mechanism and is solved all the same: parts without effect; what other blocks state in vain where
there are no loads."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from tmm_report.chapters.lever.structure.block import build
from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.problems import N_, Message, Problem, doubt
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path

_UNEVEN = ("dynamics", "flywheel", "governor", "reduction", "travel")
"""Blocks that reckon with the inertia of the driving link."""
_OF_INERTIA = ("loads", *_UNEVEN)
ASKED = Message(
    N_("loads: {gravity: 9.81 m/s^2} asks for the force analysis, with weights and inertia forces")
)


def written(read: Read, path: Path) -> Any:
    """What the file says at a path; None where it says nothing."""
    found: Any = read.data
    for part in path:
        found = found.get(part) if isinstance(found, Mapping) else None
    return found


def in_vain(read: Read, path: Path) -> Iterator[Problem]:
    """A key of what is found from the loads, in a file without them."""
    if "loads" not in read.data and written(read, path) is not None:
        text = N_("%(key)s has no effect: there is no block loads")
        yield doubt(text, path, ASKED, key=path[-1])


def belongs(read: Read, *keys: str) -> Iterator[Problem]:
    """Keys of a lever mechanism in a file without one."""
    for key in keys:
        if "mechanism" not in read.data and key in read.data:
            text = N_("there is no lever mechanism that %(block)s could belong to")
            right = Message(N_("describe the mechanism in the block mechanism, or take this block out"))
            yield doubt(text, (key,), right, block=key)


def doubts(mechanism: m.MechanismModel, read: Read) -> Iterator[Problem]:
    yield from _weightless(mechanism, read)
    yield from _inertialess(mechanism, read)
    yield from _idle(mechanism)
    yield from in_vain(read, ("mechanism", "driver", "gear"))


def _weightless(mechanism: m.MechanismModel, read: Read) -> Iterator[Problem]:
    """A mass centre with no mass in it, where the file speaks of masses at all."""
    if "loads" not in read.data and not any(link.mass for link in mechanism.links.values()):
        return
    for name, link in mechanism.links.items():
        path = ("mechanism", "links", name)
        if link.mass_centre is not None and written(read, (*path, "mass")) is None:
            text = N_("link %(link)s has a mass centre and no mass: neither a weight nor an inertia force")
            right = Message(N_("give it its mass, or mass: 0 where it is meant so"))
            yield doubt(text, (*path, "mass_centre"), right, link=name)


def _inertialess(mechanism: m.MechanismModel, read: Read) -> Iterator[Problem]:
    """A link of some length that turns with a mass and without a moment of inertia, where inertia is reckoned with.

    A slider's block on a moving guide is a point, and a link that slides along the frame does not turn. The driving
    link turns evenly, unless it moves by a law or a chapter asks how it runs.
    """
    if not any(key in read.data for key in _OF_INERTIA):
        return
    for name, link in mechanism.links.items():
        path = ("mechanism", "links", name)
        driving = mechanism.driver is not None and name == mechanism.driver.link
        uneven = any(key in read.data for key in _UNEVEN) or (
            mechanism.driver and (mechanism.driver.law or mechanism.driver.stroke)
        )
        if driving and not uneven:
            continue
        stated = written(read, (*path, "inertia")) is not None
        if link.mass and not stated and len(link.points) > 1 and not _slides_on_frame(link, mechanism):
            text = N_("link %(link)s turns and has a mass and no moment of inertia: none is reckoned with")
            right = Message(
                N_("give it its inertia (of a uniform rod m·l²/12), or inertia: 0 where it is meant so")
            )
            yield doubt(text, (*path, "mass"), right, link=name)


def _slides_on_frame(link: m.LinkModel, mechanism: m.MechanismModel) -> bool:
    guides = (mechanism.guides.get(slide.guide) for slide in build.slides_of(link))
    return any(guide is not None and guide.link == FRAME for guide in guides)


def _idle(mechanism: m.MechanismModel) -> Iterator[Problem]:
    """Guides along which nothing slides."""
    used = {slide.guide for link in mechanism.links.values() for slide in build.slides_of(link)}
    for name in mechanism.guides:
        if name not in used:
            text = N_("no link slides along guide %(name)s: it has no effect")
            yield doubt(text, ("mechanism", "guides", name), name=name)
