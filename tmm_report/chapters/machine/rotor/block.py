"""The block `rotor` of a variant."""

import math
from collections.abc import Iterator
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.machine.rotor.given import Given
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated
from tmm_report.yamlread import Path

PATH = ("rotor",)
NEAR = 1e-6  # m: planes so close are one


class Block(model.Block):
    """Masses on a turning shaft balanced."""

    ALONE = True

    rotor: Stated[Given] | None = Field(default=None, description="masses on a turning shaft balanced")


class Taken(TypedDict):
    rotor: Given | None


def given(read: Read) -> Taken:
    return {"rotor": read.block(Block).rotor}


# --- mistakes


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).rotor
    if written is None:
        return
    # what is wrong in itself is missing here: nothing is said of what belongs with it
    broken = {path[1] for path in read.broken if path[:1] == PATH and len(path) > 1}
    if not broken & {"masses", "bodies"}:
        yield from _masses(written)
        yield from _bodies(written)
    if "planes" not in broken:
        yield from _planes(written)
    yield from _together(written, broken)


def _masses(written: Given) -> Iterator[Problem]:
    if not written.masses and not written.bodies:
        text = N_("the rotor has neither masses nor bodies: there is nothing to balance")
        yield mistake(
            text, PATH, Message(N_("masses: [{mass: 2 kg, radius: 30 mm, angle: 0 deg, at: 50 mm}]"))
        )
    stated = [*(one.name for one in written.masses), *(one.name for one in written.bodies)]
    names = [name or str(k) for k, name in enumerate(stated, 1)]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield mistake(N_("two masses are named %(name)s"), (*PATH, "masses"), name=name)
    for k, one in enumerate(written.masses):
        both = one.mass is not None and one.radius is not None
        neither = one.mass is None and one.radius is None
        if not (both if one.unbalance is None else neither):
            text = N_("a mass needs its mass and its radius, or its unbalance alone")
            yield mistake(text, (*PATH, "masses", k), Message(N_("mass: 2 kg, radius: 30 mm")))


def _planes(written: Given) -> Iterator[Problem]:
    for k, plane in enumerate(written.planes):
        if (plane.radius is None) == (plane.mass is None):
            text = N_("a correction plane states the radius of its weight or its mass, the other is found")
            yield mistake(text, (*PATH, "planes", k), Message(N_("radius: 120 mm, or mass: 0.4 kg")))
    if len(written.planes) == 2 and abs(written.planes[0].at - written.planes[1].at) < NEAR:
        text = N_("both correction planes stand at one place: forces in one plane balance no couple")
        yield mistake(text, (*PATH, "planes", 1, "at"), Message(N_("two different places along the shaft")))


def _bodies(written: Given) -> Iterator[Problem]:
    for k, body in enumerate(written.bodies):
        if body.tilt and body.products:
            text = N_("the couple of a body is stated twice: by its products of inertia and by its tilt")
            yield mistake(text, (*PATH, "bodies", k), Message(N_("one of them")))
        if body.tilt and abs(body.tilt.angle) >= math.pi / 2:
            path: Path = (*PATH, "bodies", k, "tilt", "angle")
            yield mistake(N_("a body cannot lean by 90° or more"), path)
        if body.tilt and body.tilt.axial > 2 * body.tilt.across * (1 + 1e-9):
            text = N_("no body has a moment of inertia about its axis above twice that about a diameter")
            yield mistake(text, (*PATH, "bodies", k, "tilt"))


def _together(written: Given, broken: set[str | int]) -> Iterator[Problem]:
    if written.bearings and abs(written.bearings[0] - written.bearings[1]) < NEAR:
        text = N_("both bearings stand at one place: they cannot hold a couple")
        yield mistake(text, (*PATH, "bearings"), Message(N_("two different places along the shaft")))
    if written.grade and not written.speed and "speed" not in broken:
        text = N_("a balance quality grade limits e·ω: the speed is needed")
        yield mistake(text, (*PATH, "grade"), Message(N_("speed: 1500 rpm")))
    unknown = not written.bodies or any(one.mass is None for one in written.masses)
    if written.grade and written.mass is None and unknown and not broken & {"mass", "masses", "bodies"}:
        text = N_("a balance quality grade needs the mass of the whole rotor")
        yield mistake(text, (*PATH, "grade"), Message(N_("mass: 40 kg")))
    if (written.diameter is None) != (written.width is None) and not broken & {"diameter", "width"}:
        text = N_("which balance suffices is seen from the width and the diameter together")
        yield mistake(text, PATH, Message(N_("diameter: 300 mm, width: 60 mm")))
