"""A driving slider or cylinder of a mechanism as it is written: the link that follows it, and their triangle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.structure.block.strokes.models import StrokeModel
from tmm_report.chapters.lever.structure.block.strokes.models import build as law_of
from tmm_report.mechanics.calculus.motion_laws import MotionLaw
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.driving.stroke import Stroke, Taken, Turned
from tmm_report.mechanics.lever.mechanism import FRAME, Assembly, Driver, Guide, Mechanism, Slide, ZeroAngle
from tmm_report.problems import N_, Message, Problem
from tmm_report.quantity.units import WrongValue
from tmm_report.records import dataclass
from tmm_report.yamlread import Path

_DRIVER: Path = ("mechanism", "driver")


class Refused(WrongValue):
    """What drives so that the mechanism cannot be solved, or not by this program."""

    def __init__(self, wrong: Message, right: Message | None, path: Path):
        super().__init__(wrong, right)
        self.problem = Problem(wrong, right, path)


@dataclass(frozen=True)
class Joined:
    """The link that turns about a fixed point and what joins it to the slider or the cylinder, by their names."""

    link: str
    pivot: str
    pin: str
    far: str  # the slider's point, or the fixed one of the cylinder
    rod: str = ""


def led(
    built: Mechanism, stroke: StrokeModel, slider: str | None, cylinder: tuple[str, str] | None
) -> Mechanism:
    """The mechanism with the law of the link that follows the stroke. Raises Refused."""
    law = law_of(stroke)
    found = (
        _of_slider(built, slider, law)
        if slider is not None
        else _of_cylinder(built, cylinder or ("", ""), law)
    )
    sided = replace(found, side=_side(built, found))
    _goes(sided)
    turned = Turned(sided)
    zero = ZeroAngle(float(turned.at(np.zeros(1))[0][0]))
    driver = Driver(found.link, 2 * np.pi / law.period, zero, law=turned, stroke=sided)
    return replace(built, driver=driver, assembly=tuple(_assembled(built, sided)))


# ---------------------------------------------------------------- which links


def _of_slider(built: Mechanism, slider: str, law: MotionLaw) -> Stroke:
    slide, guide = _on_frame(built, slider)
    joined = next(_joined(built, slider), None)
    if joined is None:
        text = N_(
            "no rod joins slider %(link)s to a link that turns about a fixed point: such a driving slider is not "
            "offered"
        )
        right = N_("a link of two pivots between the slider and a link that is pivoted to the frame")
        raise Refused(Message(text, {"link": slider}), Message(right), (*_DRIVER, "slider"))
    links = built.links
    turn = guide.direction / slide.direction
    start = guide.through + turn * (links[slider].points[joined.far] - slide.through)
    rod = links[joined.rod].points
    return _stroke(
        built, joined, law, start=complex(start), way=complex(guide.direction),
        rod=float(abs(rod[joined.pin] - rod[joined.far])), by=(slider,), takes=(Taken(slider, joined.far, 1),),
    )  # fmt: skip


def _on_frame(built: Mechanism, slider: str) -> tuple[Slide, Guide]:
    for slide in built.slides:
        guide = built.guides[slide.guide]
        if slide.link == slider and guide.link == FRAME:
            return slide, guide
    text = N_("link %(link)s slides along no guide of the frame: only such a slider drives")
    right = Message(N_("its guide on the frame: guides: {x: {through: O}} and slides: x"))
    raise Refused(Message(text, {"link": slider}), right, (*_DRIVER, "slider"))


def _joined(built: Mechanism, slider: str) -> Iterator[Joined]:
    """Through which rods a slider turns links about fixed points."""
    for far in built.links[slider].points:
        for rod in built.links_at(far):
            if rod in (slider, FRAME):
                continue
            for pin in built.links[rod].points:
                for link in built.links_at(pin) if pin != far else ():
                    if link not in (rod, slider, FRAME) and (pivot := _pivot(built, link)):
                        yield Joined(link, pivot, pin, far, rod)


def _pivot(built: Mechanism, link: str) -> str | None:
    """The fixed point about which a link turns."""
    return next((point for point in built.links[link].points if point in built.links[FRAME].points), None)


def _of_cylinder(built: Mechanism, between: tuple[str, str], law: MotionLaw) -> Stroke:
    fixed = built.links[FRAME].points
    path = (*_DRIVER, "cylinder")
    ends = sorted(between, key=lambda point: point not in fixed)
    far, pin = ends
    if far not in fixed or pin in fixed:
        text = N_(
            "a driving cylinder is between a fixed point and a point of a link that is pivoted to the frame"
        )
        right = Message(N_("fixed points: %(words)s"), {"words": ", ".join(fixed)})
        raise Refused(Message(text), right, path)
    link = next((one for one in built.links_at(pin) if _pivot(built, one)), None)
    if link is None:
        text = N_(
            "no link with the point %(point)s turns about a fixed point: such a driving cylinder is not offered"
        )
        right = Message(N_("the rod on a link that is pivoted to the frame"))
        raise Refused(Message(text, {"point": pin}), right, path)
    barrel, rod = _cylinder(built, far, pin)
    takes = (Taken(rod or link, pin, 1), *((Taken(barrel, far, -1),) if barrel else ()))
    joined = Joined(link, str(_pivot(built, link)), pin, far)
    own = tuple(one for one in (barrel, rod) if one)
    return _stroke(built, joined, law, start=complex(fixed[far]), way=0j, rod=0.0, by=own, takes=takes)


def _cylinder(built: Mechanism, far: str, pin: str) -> tuple[str, str]:
    """Its barrel, pivoted at the fixed point, and its rod, at the pin: one slides along the other. Empty where they
    are no links of the mechanism, whatever else has a point there."""
    for slide in built.slides:
        one, other = slide.link, built.guides[slide.guide].link
        for barrel, rod in ((one, other), (other, one)):
            if FRAME not in (one, other) and barrel in built.links_at(far) and rod in built.links_at(pin):
                return barrel, rod
    return "", ""


def _stroke(built: Mechanism, joined: Joined, law: MotionLaw, **other: Any) -> Stroke:
    own = built.links[joined.link].points
    return Stroke(
        law=law, link=joined.link, pivot=complex(built.links[FRAME].points[joined.pivot]),
        pin=complex(own[joined.pin] - own[joined.pivot]), side=1, names=(joined.pivot, joined.pin, joined.far), **other,
    )  # fmt: skip


# ---------------------------------------------------------------- which way it is assembled


def _side(built: Mechanism, stroke: Stroke) -> int:
    """On which side of the line from O to Q the pin lies, as the key assembly says. Raises Refused."""
    pivot, pin, far = stroke.names
    begin = float(stroke.law.at(np.zeros(1))[0][0])
    if not abs(float(stroke.cosine(np.array([begin]))[0])) < 1:
        text = N_("the mechanism cannot be assembled where the stroke begins, at %(s)s mm")
        raise Refused(Message(text, {"s": f"{begin * 1e3:.6g}"}), _within(stroke), (*_DRIVER, "stroke"))
    right = Message(
        N_('write "left of %(a)s-%(c)s" or "right of %(a)s-%(c)s": on which side of that line %(b)s lies'),
        {"a": pivot, "c": far, "b": pin},
    )
    path: Path = ("mechanism", "assembly")
    stated = next((one for one in built.assembly if one.key == pin), None)
    if stated is None:
        text = N_(
            "%(point)s may lie on either side of the line %(a)s–%(c)s, and the key assembly does not say on which"
        )
        raise Refused(Message(text, {"point": pin, "a": pivot, "c": far}), right, path)
    places = [replace(stroke, side=side).place(begin) for side in (1, -1)]
    known = {**built.links[FRAME].points, far: places[0][1]}
    first, second = (_chosen(stated, place[0], known) for place in places)
    if first == second or first is None or second is None:
        text = N_("this does not tell on which side of the line %(a)s–%(c)s %(point)s lies")
        raise Refused(Message(text, {"point": pin, "a": pivot, "c": far}), right, (*path, pin))
    return 1 if first > second else -1


def _chosen(stated: Assembly, place: complex, known: Mapping[str, complex]) -> float | None:
    """How far a place is on the stated side; None where that says nothing of it."""
    choice = stated.choice
    if isinstance(choice, tuple):
        side, one, other = choice
        if one not in known or other not in known:
            return None
        off = cross(known[other] - known[one], place - known[one])
        return float(np.sign(off) * (1 if side == "left" else -1))
    return None if isinstance(choice, int) else round(float(dot(choice, place)), 9)


def _assembled(built: Mechanism, stroke: Stroke) -> Iterator[Assembly]:
    """What is stated of the groups, without the side of the pin, and what the stroke says of its own group."""
    _, pin, far = stroke.names
    own = _own(built, stroke)
    keys = {own.key, "-".join(reversed(own.key.split("-"))), far} if own else set()
    for one in built.assembly:
        if one.key == pin:
            continue
        if one.key in keys and stroke.slides:
            text = N_("the stroke itself says how this group is assembled")
            raise Refused(Message(text), Message(N_("leave it out")), ("mechanism", "assembly", one.key))
        yield one
    guides = {
        slide.guide for slide in built.slides if {slide.link, built.guides[slide.guide].link} == {*stroke.by}
    }
    if own and not {one.key for one in built.assembly} & {*keys, *guides}:
        yield own


def _own(built: Mechanism, stroke: Stroke) -> Assembly | None:
    """Of rod and slider how they stand where the stroke begins; of barrel and rod that the cylinder is not reversed."""
    pivot, pin, far = stroke.names
    if not stroke.slides:
        for slide in built.slides:
            if len(stroke.by) == 2 and (built.guides[slide.guide].link, slide.link) == stroke.by:
                return Assembly("-".join(stroke.by), 1)
        return None
    slider = stroke.by[0]
    rod = next(
        one.rod for one in _joined(built, slider) if (one.pivot, one.pin, one.far) == (pivot, pin, far)
    )
    place, end = stroke.place(float(stroke.law.at(np.zeros(1))[0][0]))
    return Assembly(f"{rod}-{slider}", 1 if dot(end - place, stroke.way) > 0 else -1)


# ---------------------------------------------------------------- how far it goes


def _goes(stroke: Stroke) -> None:
    """Raises Refused where the law leads through a position in which the mechanism cannot go on."""
    met = stroke.limit()
    if met is None:
        return
    pivot, pin, far = stroke.names
    told = {"s": f"{met * 1e3:.5g}", "link": stroke.link, "a": pivot, "b": pin, "c": far}
    text = N_(
        "at %(s)s mm of the stroke the mechanism cannot go on: %(a)s, %(b)s and %(c)s come into one line, or link "
        "%(link)s stops and would turn back"
    )
    raise Refused(Message(text, told), _within(stroke), (*_DRIVER, "stroke"))


def _within(stroke: Stroke) -> Message:
    """Of a cylinder between which lengths it is."""
    if stroke.slides:
        return Message(N_("a stroke that ends before it"))
    apart = abs(stroke.start - stroke.pivot)
    low, high = abs(stroke.crank - apart), stroke.crank + apart
    told = {"low": f"{low * 1e3:.6g}", "high": f"{high * 1e3:.6g}"}
    return Message(N_("lengths between %(low)s and %(high)s mm"), told)
