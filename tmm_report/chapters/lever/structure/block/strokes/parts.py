"""What both ways of solving a driving slider or cylinder ask of a mechanism as it is written."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.mechanism import FRAME, Assembly, Guide, Mechanism, Slide
from tmm_report.problems import N_, Message, Problem
from tmm_report.quantity.units import WrongValue
from tmm_report.yamlread import Path

DRIVER: Path = ("mechanism", "driver")


class Refused(WrongValue):
    """What drives so that the mechanism cannot be solved, or not by this program."""

    reached = 0.0  # how far of the stroke the mechanism goes before it, m

    def __init__(self, wrong: Message, right: Message | None, path: Path):
        super().__init__(wrong, right)
        self.problem = Problem(wrong, right, path)


def on_frame(built: Mechanism, slider: str) -> tuple[Slide, Guide]:
    """The guide of the frame along which a slider goes. Raises Refused."""
    for slide in built.slides:
        guide = built.guides[slide.guide]
        if slide.link == slider and guide.link == FRAME:
            return slide, guide
    text = N_("link %(link)s slides along no guide of the frame: only such a slider drives")
    right = Message(N_("its guide on the frame: guides: {x: {through: O}} and slides: x"))
    raise Refused(Message(text, {"link": slider}), right, (*DRIVER, "slider"))


def pivot_of(built: Mechanism, link: str) -> str | None:
    """The fixed point about which a link turns."""
    return next((point for point in built.links[link].points if point in built.links[FRAME].points), None)


def must_change(built: Mechanism, between: tuple[str, str]) -> None:
    """Raises Refused for a cylinder between two points whose distance nothing changes."""
    fixed = built.links[FRAME].points
    one, other = sorted(between, key=lambda point: point not in fixed)
    told, path = {"one": one, "other": other}, (*DRIVER, "cylinder")
    if other in fixed:
        text = N_("%(one)s and %(other)s are both fixed: the cylinder between them moves nothing")
        right = Message(N_("fixed points: %(words)s"), {"words": ", ".join(fixed)})
        raise Refused(Message(text, told), right, path)
    if {*built.links_at(one)} & {*built.links_at(other)}:
        text = N_("%(one)s and %(other)s are points of one link: the cylinder between them moves nothing")
        right = Message(N_("two points of different links, or a fixed one and one that moves"))
        raise Refused(Message(text, told), right, path)


def cylinder_links(built: Mechanism, start: str, end: str) -> tuple[str, str]:
    """Its barrel, at the point from which it pushes, and its rod, at the other: one slides along the other. Empty
    where they are no links of the mechanism, whatever else has a point there."""
    for slide in built.slides:
        one, other = slide.link, built.guides[slide.guide].link
        for barrel, rod in ((one, other), (other, one)):
            if FRAME not in (one, other) and barrel in built.links_at(start) and rod in built.links_at(end):
                return barrel, rod
    return "", ""


def straight(built: Mechanism, by: tuple[str, ...]) -> Assembly | None:
    """Of barrel and rod that the cylinder is not reversed; None where they are no links."""
    for slide in built.slides:
        if len(by) == 2 and (built.guides[slide.guide].link, slide.link) == by:
            return Assembly("-".join(by), 1)
    return None


def chosen(stated: Assembly, place: complex, known: Mapping[str, complex]) -> float | None:
    """How far a place is on the stated side; None where that says nothing of it."""
    choice = stated.choice
    if isinstance(choice, tuple):
        side, one, other = choice
        if one not in known or other not in known:
            return None
        off = cross(known[other] - known[one], place - known[one])
        return float(np.sign(off) * (1 if side == "left" else -1))
    return None if isinstance(choice, int) else round(float(dot(choice, place)), 9)
