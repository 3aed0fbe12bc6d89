"""Mistakes of the key `cams`: names first, then what the geometry of cam and follower says against them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from tmm_report.chapters.lever.structure.block import build
from tmm_report.chapters.lever.structure.block import models as m
from tmm_report.chapters.lever.structure.block.cam_build import Wrong
from tmm_report.chapters.lever.structure.block.synthesised import offered
from tmm_report.problems import N_, Message, Problem, ProblemError, mistake
from tmm_report.quantity.units import WrongValue
from tmm_report.variant.errors import near
from tmm_report.variant.model import Read
from tmm_report.yamlread import Path

if TYPE_CHECKING:
    from tmm_report.chapters.lever.structure.block.checks import Names

Found = Iterator[Problem]
CAMS: Path = ("mechanism", "cams")


def check(mechanism: m.MechanismModel, read: Read, known: Names) -> Found:
    named = list(_names(mechanism, known))
    yield from named
    if mechanism.driver is None or not mechanism.cams or named:
        return
    try:
        built = build.without_cams(mechanism, offered(read))
    except (WrongValue, KeyError, ProblemError):  # the links have mistakes of their own
        return
    for name, cam in mechanism.cams.items():
        try:
            build.cam_of(name, cam, built)
        except Wrong as error:
            key = error.key if error.key in cam.model_fields_set else ""
            yield Problem(error.wrong, error.right, (*CAMS, name, key) if key else (*CAMS, name))
        except KeyError:  # a guide or a point that is not there is told elsewhere
            return


def _names(mechanism: m.MechanismModel, known: Names) -> Found:
    """Names of links, and those that the replacing link brings with it."""
    taken = {*known.all_points, *known.guides, *known.points}
    driver = mechanism.driver.link if mechanism.driver else None
    for name, cam in mechanism.cams.items():
        path = (*CAMS, name)
        if name in known.points:
            right = Message(N_("call it otherwise: the link that replaces the cam pair has this name"))
            yield mistake(N_("a link is also called %(name)s"), path, right, name=name)
        if cam.follower not in known.points:
            guess = near(cam.follower, list(known.points))
            yield mistake(N_("there is no link %(name)s"), (*path, "follower"), guess, name=cam.follower)
        elif cam.follower == driver:
            yield mistake(N_("the driving link cannot be the follower"), (*path, "follower"))
        if cam.cam is not None and cam.cam != driver:
            right = Message(N_("the driving link, %(link)s"), {"link": driver or "1"})
            yield mistake(N_("only the driving link can be a cam"), (*path, "cam"), right)
        centre = cam.centre or "K"
        if centre in taken:
            right = Message(N_("state centre: another name of the cam's centre of curvature"))
            yield mistake(N_("a point is also called %(name)s"), path, right, name=centre)
        taken.add(centre)
