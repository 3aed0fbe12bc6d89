"""The block `governor` of a variant: the centrifugal governor, its machine, the servomotor, the brake."""

from collections.abc import Iterator, Set
from dataclasses import fields
from typing import TypedDict

from pydantic import Field

from tmm_report.chapters.machine.governor.given import Brake, Given
from tmm_report.problems import N_, Message, Problem, mistake
from tmm_report.variant import model
from tmm_report.variant.model import Read
from tmm_report.variant.stated import Stated

PATH = ("governor",)
_BESIDE = frozenset(one.name for one in fields(Given)) - {"arms", "bell_crank", "brake"}
"""Keys that do not say what kind of governor it is; an unknown key may be meant to say it."""


class Block(model.Block):
    """The speed governor."""

    ALONE = True

    governor: Stated[Given] | None = Field(default=None, description="the speed governor")


class Taken(TypedDict):
    governor: Given | None


def given(read: Read) -> Taken:
    return {"governor": read.block(Block).governor}


# --- mistakes


def mistakes(read: Read) -> Iterator[Problem]:
    written = read.block(Block).governor
    if written is None:
        return
    # what is wrong in itself is missing here: nothing is said of what belongs with it
    broken = {path[1] for path in read.broken if path[:1] == PATH and len(path) > 1}
    for problem in _together(written, broken):
        if not broken & set(problem.path[1:2]):
            yield problem


def _together(written: Given, broken: Set[object]) -> Iterator[Problem]:
    centrifugal = bool(written.arms or written.bell_crank or broken & {"arms", "bell_crank"})
    if written.arms and written.bell_crank:
        right = Message(N_("leave one of them: arms or bell_crank"))
        yield mistake(
            N_("the balls hang on arms or on angle levers, not on both"), (*PATH, "bell_crank"), right
        )
    elif centrifugal:
        yield from _range(written)
        yield from _masses(written)
        yield from _places(written)
    elif written.brake is None and not broken - _BESIDE:
        right = Message(N_("state arms, bell_crank or brake"))
        yield mistake(N_("nothing says what kind of governor it is"), PATH, right)
    yield from _needs(written, centrifugal, "machine" in broken)


def _range(written: Given) -> Iterator[Problem]:
    if written.radius is None:
        right = Message(N_("for example, radius: {lowest: 150 mm, highest: 200 mm}"))
        yield mistake(N_("the working range of the governor is not stated"), (*PATH, "radius"), right)
        return
    if (written.radius.highest is None) == (written.lift is None):
        right = Message(N_("state the highest radius or the lift of the sleeve"))
        yield mistake(N_("one of the two ends the working range"), (*PATH, "radius", "highest"), right)
    elif written.radius.highest is not None and written.radius.highest <= written.radius.lowest:
        right = Message(N_("the balls go outwards as the sleeve rises: highest above lowest"))
        text = N_("the highest radius is not greater than the lowest")
        yield mistake(text, (*PATH, "radius", "highest"), right)


def _masses(written: Given) -> Iterator[Problem]:
    chosen = written.choose
    if written.balls.mass is None and (chosen is None or chosen.balls is None):
        right = Message(N_("state their mass, or choose: {balls: 300 rpm}"))
        yield mistake(N_("the balls have no mass"), (*PATH, "balls", "mass"), right)
    stated = {"spring": written.spring, "balls": written.balls.mass, "sleeve": written.sleeve.mass}
    for key, value in stated.items():
        if chosen is not None and getattr(chosen, key) is not None and value is not None:
            right = Message(N_("state it or have it chosen, not both"))
            yield mistake(N_("what is chosen is stated, too"), (*PATH, "choose", key), right)


def _places(written: Given) -> Iterator[Problem]:
    """Where the balls are on arms, and the fulcrum of an angle lever."""
    balls, crank = written.balls, written.bell_crank
    if crank is not None and crank.fulcrum is None and not crank.level:
        right = Message(N_("state it, or level: true, by which the obliquity of the arms is neglected"))
        yield mistake(N_("the key %(key)s is missing"), (*PATH, "bell_crank"), right, key="fulcrum")
    if balls.distance is not None and balls.extension is not None:
        right = Message(N_("a distance along the upper arm or an extension of the lower one"))
        yield mistake(N_("a ball cannot be on both arms"), (*PATH, "balls", "extension"), right)
    for key in ("distance", "extension"):
        if written.bell_crank and getattr(balls, key) is not None:
            right = Message(N_("leave it out: the ball is at the end of ball_arm"))
            yield mistake(N_("an angle lever has no arms"), (*PATH, "balls", key), right)


def _needs(written: Given, centrifugal: bool, broken_machine: bool) -> Iterator[Problem]:
    if written.machine and not centrifugal:
        right = Message(N_("state its arms or its bell_crank"))
        yield mistake(N_("the machine has no centrifugal governor"), (*PATH, "machine"), right)
    if written.machine and written.machine.load.before == written.machine.load.after:
        right = Message(N_("a load after the step that differs from that before it"))
        yield mistake(N_("the load does not step"), (*PATH, "machine", "load", "after"), right)
    if written.servo and not (written.machine or broken_machine):
        right = Message(N_("state the machine, too"))
        yield mistake(N_("a servomotor governs nothing without a machine"), (*PATH, "servo"), right)
    if written.brake:
        yield from _brake(written.brake)


def _brake(written: Brake) -> Iterator[Problem]:
    """What is chosen is not stated, and the mass is one of them."""
    choose, path = written.choose, (*PATH, "brake")
    if written.mass is None and (choose is None or choose.mass is None):
        right = Message(N_("state their mass, or choose: {mass: 300 rpm}"))
        yield mistake(N_("the shoes have no mass"), (*path, "mass"), right)
    stated = {"mass": written.mass, "spring": written.spring.force or None}
    for key, value in stated.items():
        if choose is not None and getattr(choose, key) is not None and value is not None:
            right = Message(N_("state it or have it chosen, not both"))
            yield mistake(N_("what is chosen is stated, too"), (*path, "choose", key), right)
