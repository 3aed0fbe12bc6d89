"""The triangle of a driving slider or cylinder as it is written: which links make it, and on which side it lies.

It is there where a rod of two pivots joins the slider to a link that is pivoted to the frame, or the cylinder stands
between a fixed point and a point of such a link.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from tmm_report.chapters.lever.structure.block.strokes.parts import (
    DRIVER,
    Refused,
    chosen,
    cylinder_links,
    on_frame,
    pivot_of,
    straight,
)
from tmm_report.mechanics.calculus.motion_laws import MotionLaw
from tmm_report.mechanics.calculus.vectors import cross, dot
from tmm_report.mechanics.lever.driving.stroke import Taken
from tmm_report.mechanics.lever.driving.triangle import Triangle
from tmm_report.mechanics.lever.mechanism import FRAME, Assembly, Mechanism
from tmm_report.problems import N_, Message
from tmm_report.records import dataclass
from tmm_report.yamlread import Path


@dataclass(frozen=True)
class Joined:
    """The link that turns about a fixed point and what joins it to the slider or the cylinder, by their names."""

    link: str
    pivot: str
    pin: str
    far: str  # the slider's point, or the fixed one of the cylinder
    rod: str = ""


def triangle_of(
    built: Mechanism, law: MotionLaw, slider: str | None, cylinder: tuple[str, str]
) -> tuple[Triangle, tuple[Assembly, ...]] | None:
    """The triangle, and what is then stated of the groups; None where there is none. Raises Refused; how far
    it goes says its `limit`."""
    found = _of_slider(built, slider, law) if slider is not None else _of_cylinder(built, cylinder, law)
    if found is None:
        return None
    sided = replace(found, side=_side(built, found))
    return sided, tuple(_assembled(built, sided))


# ---------------------------------------------------------------- which links


def _of_slider(built: Mechanism, slider: str, law: MotionLaw) -> Triangle | None:
    slide, guide = on_frame(built, slider)
    joined = next(_joined(built, slider), None)
    if joined is None:
        return None
    links = built.links
    turn = guide.direction / slide.direction
    start = guide.through + turn * (links[slider].points[joined.far] - slide.through)
    rod = links[joined.rod].points
    return _stroke(
        built, joined, law, start=complex(start), way=complex(guide.direction),
        rod=float(abs(rod[joined.pin] - rod[joined.far])), by=(slider,), takes=(Taken(slider, joined.far, 1),),
    )  # fmt: skip


def _joined(built: Mechanism, slider: str) -> Iterator[Joined]:
    """Through which rods a slider turns links about fixed points."""
    for far in built.links[slider].points:
        for rod in built.links_at(far):
            if rod in (slider, FRAME):
                continue
            for pin in built.links[rod].points:
                for link in built.links_at(pin) if pin != far else ():
                    if link not in (rod, slider, FRAME) and (pivot := pivot_of(built, link)):
                        yield Joined(link, pivot, pin, far, rod)


def _of_cylinder(built: Mechanism, between: tuple[str, str], law: MotionLaw) -> Triangle | None:
    fixed = built.links[FRAME].points
    far, pin = sorted(between, key=lambda point: point not in fixed)
    link = next((one for one in built.links_at(pin) if pivot_of(built, one)), None)
    if far not in fixed or pin in fixed or link is None:
        return None
    barrel, rod = cylinder_links(built, far, pin)
    takes = (Taken(rod or link, pin, 1), *((Taken(barrel, far, -1),) if barrel else ()))
    joined = Joined(link, str(pivot_of(built, link)), pin, far)
    own = tuple(one for one in (barrel, rod) if one)
    return _stroke(built, joined, law, start=complex(fixed[far]), way=0j, rod=0.0, by=own, takes=takes)


def _stroke(built: Mechanism, joined: Joined, law: MotionLaw, **other: Any) -> Triangle:
    own = built.links[joined.link].points
    return Triangle(
        law=law, link=joined.link, pivot=complex(built.links[FRAME].points[joined.pivot]),
        pin=complex(own[joined.pin] - own[joined.pivot]), side=1, names=(joined.pivot, joined.pin, joined.far), **other,
    )  # fmt: skip


# ---------------------------------------------------------------- which way it is assembled


def _side(built: Mechanism, stroke: Triangle) -> int:
    """On which side of the line from O to Q the pin lies, as the key assembly says. Raises Refused."""
    pivot, pin, far = stroke.names
    begin = float(stroke.law.at(np.zeros(1))[0][0])
    if not abs(float(stroke.cosine(np.array([begin]))[0])) < 1:
        text = N_("the mechanism cannot be assembled where the stroke begins, at %(s)s mm")
        raise Refused(Message(text, {"s": f"{begin * 1e3:.6g}"}), _within(stroke), (*DRIVER, "stroke"))
    right = Message(
        N_('write "left of %(a)s-%(c)s" or "right of %(a)s-%(c)s": on which side of that line %(b)s lies'),
        {"a": pivot, "c": far, "b": pin},
    )
    path: Path = ("mechanism", "assembly")
    stated = next((one for one in built.assembly if one.key == pin), None)
    if stated is None and (side := _sketched(built, stroke)):
        return side
    if stated is None:
        text = N_(
            "%(point)s may lie on either side of the line %(a)s–%(c)s, and the key assembly does not say on which"
        )
        raise Refused(Message(text, {"point": pin, "a": pivot, "c": far}), right, path)
    places = [replace(stroke, side=side).place(begin) for side in (1, -1)]
    known = {**built.links[FRAME].points, far: places[0][1]}
    first, second = (chosen(stated, place[0], known) for place in places)
    if first == second or first is None or second is None:
        text = N_("this does not tell on which side of the line %(a)s–%(c)s %(point)s lies")
        raise Refused(Message(text, {"point": pin, "a": pivot, "c": far}), right, (*path, pin))
    return 1 if first > second else -1


def _sketched(built: Mechanism, stroke: Triangle) -> int:
    """The side in the sketch; 0 where that does not tell it."""
    known = {**built.sketch, **built.links[FRAME].points}
    if not {*stroke.names} <= known.keys():
        return 0
    pivot, pin, far = (known[name] for name in stroke.names)
    return int(np.sign(cross(far - pivot, pin - pivot)))


def _assembled(built: Mechanism, stroke: Triangle) -> Iterator[Assembly]:
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


def _own(built: Mechanism, stroke: Triangle) -> Assembly | None:
    """Of rod and slider how they stand where the stroke begins; of barrel and rod that the cylinder is not reversed."""
    pivot, pin, far = stroke.names
    if not stroke.slides:
        return straight(built, stroke.by)
    slider = stroke.by[0]
    rod = next(
        one.rod for one in _joined(built, slider) if (one.pivot, one.pin, one.far) == (pivot, pin, far)
    )
    place, end = stroke.place(float(stroke.law.at(np.zeros(1))[0][0]))
    return Assembly(f"{rod}-{slider}", 1 if dot(end - place, stroke.way) > 0 else -1)


# ---------------------------------------------------------------- how far it goes


def stopped(stroke: Triangle, met: float) -> Refused:
    """What is said where the law leads through a position, at a stroke, in which the triangle cannot go on."""
    pivot, pin, far = stroke.names
    told = {"s": f"{met * 1e3:.5g}", "link": stroke.link, "a": pivot, "b": pin, "c": far}
    text = N_(
        "at %(s)s mm of the stroke the mechanism cannot go on: %(a)s, %(b)s and %(c)s come into one line, or link "
        "%(link)s stops and would turn back"
    )
    return Refused(Message(text, told), _within(stroke), (*DRIVER, "stroke"))


def _within(stroke: Triangle) -> Message:
    """Of a cylinder between which lengths it is."""
    if stroke.slides:
        return Message(N_("a stroke that ends before it"))
    apart = abs(stroke.start - stroke.pivot)
    low, high = abs(stroke.crank - apart), stroke.crank + apart
    told = {"low": f"{low * 1e3:.6g}", "high": f"{high * 1e3:.6g}"}
    return Message(N_("lengths between %(low)s and %(high)s mm"), told)
