"""Torsion springs between two links: how far one has turned against the other, and the moments on both."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from tmm_report.chapters.lever.kinetostatics.given import Loads
from tmm_report.chapters.lever.kinetostatics.ties import Twist
from tmm_report.mechanics.lever.mechanism import FRAME
from tmm_report.mechanics.lever.motion import Motion
from tmm_report.problems import N_, Message, Problem, mistake

if TYPE_CHECKING:
    from tmm_report.chapters.lever.kinematics.solve.positions import Kinematics

Array = Any
WHOLE = 2 * np.pi * (1 - 1e-6)  # a swing of a whole turn or more is no swing


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


def energy(twist: Twist, kinematics: Kinematics, motion: Motion) -> Array:
    """Potential of a spring, c (α₀ − φ)²/2, J, (..., P)."""
    law = twist.law
    return law.stiffness * (law.free - turned(twist, kinematics, motion)) ** 2 / 2


def springs_of(given: Loads) -> list[Twist]:
    """The first end of every torsion spring, in their order."""
    found: dict[str, Twist] = {}
    for one in given.moments:
        if isinstance(one, Twist):
            found.setdefault(one.of, one)
    return list(found.values())


def refused(given: Loads, kinematics: Kinematics) -> Iterator[Problem]:
    """Torsion springs between links that go round one another, or whose position 0 is not there."""
    for one in springs_of(given):
        path = ("loads", "torsion_springs", int(one.of[1:]) - 1)
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
