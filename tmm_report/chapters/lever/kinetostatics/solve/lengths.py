"""Springs and dampers at the positions of a mechanism: how long they are, how fast they grow, where they pull; how far
the links of torsion springs have turned against one another."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.ties import End, Spring, Tie, apart
from tmm_report.chapters.lever.kinetostatics.ties import TorsionSpring as TorsionSpring
from tmm_report.chapters.lever.kinetostatics.ties import Twist as Twist
from tmm_report.chapters.lever.kinetostatics.ties import twists as twists
from tmm_report.mechanics.calculus.laws import ByLength, Law
from tmm_report.mechanics.calculus.vectors import NOWHERE, dot
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, Problem, ProblemError, doubt, mistake

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any
WHOLE = 2 * np.pi * (1 - 1e-6)  # a swing of a whole turn or more is no swing
MET = 1e-9  # of the mechanism's size: nearer points are one, and no line goes through them


class Line(NamedTuple):
    """From the first point of a tie to the second, (..., P): length, m, its derivative by the time, m/s, and direction,
    unit complex; nan where the points meet: there the line has none."""

    length: Array
    rate: Array
    way: Array


def line(one: str, other: str, motion: Motion) -> Line:
    """From a point to another."""
    speed = motion.velocity(other) - motion.velocity(one)
    return between(
        motion.place(other) - motion.place(one), speed, np.nanmax(np.abs(motion.places), initial=0.0)
    )


def between(apart_: Array, speed: Array, size: float) -> Line:
    """l = |r_B − r_A|, l′ = (v_B − v_A)·e with e = (r_B − r_A)/l; `size`: of the mechanism, m."""
    length = np.abs(apart_)
    met = length <= MET * size
    with np.errstate(invalid="ignore"):  # positions that do not close are nan
        way = np.where(met, NOWHERE, apart_ / np.where(met, 1.0, length))
    return Line(length, dot(way, speed), way)


def law_of(tie: Tie, kinematics: Kinematics) -> Law:
    """Of a spring with a preload at a position the free length is what the motion makes it."""
    if not isinstance(tie, Spring) or tie.free is not None:
        return tie.law
    length = line(*tie.between, kinematics.table).length[..., tie.at_position or 0]
    return ByLength(tie.stiffness, float(tie.free_of(length)))


def argument(of: Line, law: Law) -> Array:
    """What the law of a tie is over."""
    return of.length if isinstance(law, ByLength) else of.rate


def pulled(end: End, kinematics: Kinematics, motion: Motion) -> tuple[Array, Array]:
    """The force on an end, (..., P), and how much of it draws it to the other point, N."""
    return along(line(end.at, end.way.point, motion), law_of(end.tie, kinematics))


def along(of: Line, law: Law) -> tuple[Array, Array]:
    """The force on the first point of a line, and how much of it draws it to the second, N."""
    size = law.value(argument(of, law))
    size = np.where(np.isnan(of.way), np.nan, size)
    return size * of.way, size


def energy(end: End, kinematics: Kinematics, motion: Motion) -> Array:
    """Potential of a spring, c (l − l₀)²/2, J, (..., P); of a damper there is none."""
    law, of = law_of(end.tie, kinematics), line(*end.tie.between, motion)
    if not isinstance(law, ByLength):
        return np.zeros(motion.shape)
    return np.broadcast_to(law.stiffness * (of.length - law.free) ** 2 / 2, motion.shape)


def ties_of(given: Loads) -> list[End]:
    """The first end of every spring and damper, in their order."""
    return [given.forces[own[0]] for own in apart(given.forces)[1]]  # type: ignore[misc]


def is_tie(load: object) -> bool:
    """Whether a load is the force of a spring or damper."""
    return isinstance(load, End)


def path_of(given: Loads, end: End) -> tuple[str | int, ...]:
    """Where a tie stands in the file."""
    return "loads", "springs" if isinstance(end.tie, Spring) else "dampers", int(end.of[1:]) - 1


def never(given: Loads, kinematics: Kinematics) -> Iterator[Problem]:
    """Ties whose points are in one place at every position."""
    for end in ties_of(given):
        if np.isnan(line(*end.tie.between, kinematics.diagram).way).all():
            text = N_("points %(one)s and %(other)s are in one place: no line goes through them")
            one, other = end.tie.between
            yield mistake(text, (*path_of(given, end), "between"), one=one, other=other)
        elif np.isnan(getattr(law_of(end.tie, kinematics), "free", 0.0)):
            text = N_("the mechanism has no position %(position)s, at which the spring has its preload")
            right = Message(N_("at_length: 260 mm, or another position"))
            yield mistake(text, (*path_of(given, end), "preload"), right, position=end.tie.at_position or 0)  # type: ignore[attr-defined]


def refuse(given: Loads, kinematics: Kinematics) -> None:
    """Raises ProblemError for ties without a line, and torsion springs that would be wound up."""
    turning = [(one, ("loads", "torsion_springs", int(one.of[1:]) - 1)) for one in torsions_of(given)]
    if found := [*never(given, kinematics), *wound_up(turning, kinematics)]:
        raise ProblemError(found)


def odd(given: Loads, kinematics: Kinematics) -> Iterator[Problem]:
    """Free lengths that no spring has; positions at which the points of a tie meet, so that nothing is found there."""
    for end in ties_of(given):
        law = law_of(end.tie, kinematics)
        if isinstance(law, ByLength) and law.free < 0:
            text = N_("the free length of the spring comes out below zero, %(length)s mm")
            right = Message(N_("a smaller preload, or a greater stiffness"))
            yield doubt(text, (*path_of(given, end), "preload"), right, length=f"{law.free * 1e3:.4g}")
        met = np.flatnonzero(np.isnan(line(*end.tie.between, kinematics.table).way) & kinematics.table.closes)
        if met.size:
            text = N_(
                "points %(one)s and %(other)s meet at position %(position)s: the force between them has no direction "
                "there, and no forces are given"
            )
            one, other = end.tie.between
            here = (*path_of(given, end), "between")
            yield doubt(text, here, one=one, other=other, position=int(met[0]))


# ---------------------------------------------------------------- torsion springs


def turned(twist: Twist, kinematics: Kinematics, motion: Motion) -> Array:
    """By how much a link has turned against the other since position 0, rad, (..., P): without a jump from π to −π, as
    its swing is less than a turn."""
    low, high = swing(twist, kinematics)
    middle = (low + high) / 2
    since = against(twist, motion) / start(twist, kinematics)
    return middle + np.angle(since * np.exp(-1j * middle))


def swing(twist: Twist, kinematics: Kinematics) -> tuple[float, float]:
    """Between which angles from position 0 a link turns against the other over the cycle, rad."""
    way = against(twist, kinematics.cycle.search[1]) / start(twist, kinematics)
    known = np.ravel(way)[np.isfinite(np.ravel(way))]
    angles = np.unwrap(np.angle(known)) if known.size else np.zeros(1)
    return float(angles.min()), float(angles.max())


def start(twist: Twist, kinematics: Kinematics) -> complex:
    """The direction of the link against the other at position 0; nan where the mechanism has none."""
    return complex(np.ravel(against(twist, kinematics.table))[0])


def against(twist: Twist, motion: Motion) -> Array:
    """The direction of a link seen from the other, unit complex."""
    own, other = (1.0 + 0j if link == FRAME else motion.turn(link) for link in (twist.on, twist.other))
    return own * np.conj(other) * np.ones(motion.shape)


def twist_energy(twist: Twist, kinematics: Kinematics, motion: Motion) -> Array:
    """Potential of a spring, c (α₀ − φ)²/2, J, (..., P)."""
    law = twist.law
    return law.stiffness * (law.free - turned(twist, kinematics, motion)) ** 2 / 2


def is_torsion(load: object) -> bool:
    """Whether a load is the moment of a torsion spring."""
    return isinstance(load, Twist)


def torsions_of(given: Loads) -> list[Twist]:
    """The first end of every torsion spring, in their order."""
    found: dict[str, Twist] = {}
    for one in given.moments:
        if isinstance(one, Twist):
            found.setdefault(one.of, one)
    return list(found.values())


def wound_up(
    springs: Iterable[tuple[Twist, tuple[str | int, ...]]], kinematics: Kinematics
) -> Iterator[Problem]:
    """Torsion springs, with where they are stated, between links that go round one another, or whose position 0 is
    not there."""
    for one, path in springs:
        if not np.isfinite(start(one, kinematics)):
            text = N_("the mechanism has no position 0, from which the angle of a torsion spring is counted")
            yield mistake(text, path)
            continue
        low, high = swing(one, kinematics)
        if high - low >= WHOLE:
            text = N_(
                "links %(one)s and %(other)s go round one another: a torsion spring between them would be wound up "
                "more and more with each turn"
            )
            right = Message(N_("two links that swing against one another"))
            yield mistake(text, (*path, "links"), right, one=one.on, other=one.other)
